"""What was generated and compiled before, kept by content.

    sources/KEY/    NAME.h NAME.c NAME.pyx     KEY: the model, the options, and the text of the generator
    binaries/KEY/   NAME.<extension suffix>    KEY: the sources' text and the ABI's, compiler, flags, processor,
                                                    Python, Cython, NumPy

An entry is filled under another name and renamed, under a lock of its own: it is there in full or not at all,
and of two processes that want the same one, the second waits and finds it.
"""

import hashlib
import os
import secrets
import shutil
from collections.abc import Callable
from pathlib import Path

from filelock import FileLock
from platformdirs import user_cache_path

LOCATION = "EIGENMOTION_CACHE"


def location() -> Path:
    """Folder of the cache: $EIGENMOTION_CACHE, or where the platform keeps caches."""
    chosen = os.environ.get(LOCATION)
    return Path(chosen).expanduser().absolute() if chosen else user_cache_path("eigenmotion", appauthor=False)


def key(*parts: str | bytes) -> str:
    """Hash of a sequence of texts; ("ab", "c") and ("a", "bc") differ."""
    digest = hashlib.sha256()
    for part in parts:
        data = part.encode() if isinstance(part, str) else part
        digest.update(f"{len(data)}:".encode())
        digest.update(data)
    return digest.hexdigest()[:32]


def entry(kind: str, name: str, fill: Callable[[Path], None]) -> Path:
    """Return the folder `kind/name`, which `fill(folder)` fills where it is not there yet.

    Whatever `fill` raises is raised, and leaves nothing behind.
    """
    folder = location() / kind / name
    if not folder.is_dir():
        with _lock(f"{kind}-{name}"):
            if not folder.is_dir():
                _fill(folder, fill)
    return folder


def _lock(name: str) -> FileLock:
    folder = location() / "locks"
    folder.mkdir(parents=True, exist_ok=True)
    return FileLock(folder / name)


def _fill(folder: Path, fill: Callable[[Path], None]) -> None:
    folder.parent.mkdir(parents=True, exist_ok=True)
    temporary = folder.with_name(f".{folder.name}.{secrets.token_hex(4)}")
    temporary.mkdir()
    try:
        fill(temporary)
        temporary.rename(folder)
    finally:
        shutil.rmtree(temporary, ignore_errors=True)
