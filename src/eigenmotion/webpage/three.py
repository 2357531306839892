"""three.js for drawings in space: downloaded once through npm, checked against its hash, and cached."""

import base64
import hashlib
import shutil
import tarfile
import tempfile
from dataclasses import dataclass
from pathlib import Path

from ..building.cache import entry, guarded, key
from ..building.errors import BuildError
from ..building.processes import run

VERSION = "0.180.0"
_SHA512 = "o+qycAMZrh+TsE01GqWUxUIKR1AL0S8pq7zDkYOQw8GqfX8b8VoCKYUoHbhiX5j+7hr8XsuHDVU6+gkQJQKg9w=="
_FILES = {
    "core": "package/build/three.core.min.js",
    "module": "package/build/three.module.min.js",
    "licence": "package/LICENSE",
}


@dataclass(frozen=True, slots=True)
class Three:
    """The text of three.js: its module, the core that the module imports as ./three.core.min.js, and its licence."""

    core: str
    module: str
    licence: str


def three() -> Three:
    """Return three.js.

    Raises
    ------
    BuildError
        It is not in the cache, and npm is missing, has no network, or returned another file.
    """
    folder = entry("three", key(VERSION, _SHA512), _fetch)
    with guarded():
        return Three(**{part: (folder / f"{part}.txt").read_text(encoding="utf-8") for part in _FILES})


def _fetch(folder: Path) -> None:
    npm = shutil.which("npm")
    if npm is None:
        raise BuildError("npm, which brings three.js, is not on the PATH")
    with tempfile.TemporaryDirectory() as place:
        run((npm, "pack", f"three@{VERSION}", "--ignore-scripts", "--silent"), Path(place))
        packed = next(iter(Path(place).glob("*.tgz"))).read_bytes()
        if base64.b64encode(hashlib.sha512(packed).digest()).decode() != _SHA512:
            raise BuildError(f"what npm brought is not three.js {VERSION}: its hash is another one")
        _unpack(next(iter(Path(place).glob("*.tgz"))), folder)


def _unpack(archive: Path, folder: Path) -> None:
    with tarfile.open(archive) as content:
        for part, name in _FILES.items():
            file = content.extractfile(name)
            assert file is not None, name
            (folder / f"{part}.txt").write_bytes(file.read())
