"""A right-hand side that differentiates itself, compiled where somebody first asks for it (em_rate_jacobian.h)."""

import ctypes
import logging
import shutil
from pathlib import Path
from tempfile import TemporaryDirectory

from ..codegen.c.emit import Sources, body_hash
from .cache import LOCATION, entry, key
from .errors import BuildError
from .toolchain import EXTENSION_SUFFIX, INCLUDE, Toolchain

_log = logging.getLogger("eigenmotion")
_loaded: list[ctypes.CDLL] = []
"""Libraries stay, for whoever has an address calls it."""


def rate_jacobian(sources: Sources, tools: Toolchain) -> int:
    """Return the address of the compiled function that em_rate_jacobian.h describes.

    Raises
    ------
    BuildError
        The compiler refused the code, or what it made cannot be loaded.
    """
    headers = (path.read_bytes() for path in sorted(INCLUDE.glob("*.h")))
    name = key(sources.name, *(body_hash(file.text) for file in sources.files), *headers, tools.identity)
    folder = entry("jacobians", name, lambda folder: _compile(sources, tools, folder))
    path = folder / f"{sources.name}{EXTENSION_SUFFIX}"
    try:
        library = ctypes.CDLL(str(path))
    except OSError as error:
        raise BuildError(f"{path} cannot be loaded: {error}. Code must be allowed to run from there; ${LOCATION} names "
                         "another folder") from error  # fmt: skip
    _loaded.append(library)
    return ctypes.cast(library.em_rate_jacobian, ctypes.c_void_p).value or 0


def _compile(sources: Sources, tools: Toolchain, folder: Path) -> None:
    _log.info("compiling derivatives of %s", sources.name)
    with TemporaryDirectory(prefix="work-", dir=folder) as place:
        work = Path(place)
        for file in sources.files:
            (work / file.name).write_text(file.text, encoding="utf-8")
        tools.link(work, (tools.compile_duals(work, sources.name),), sources.name)
        shutil.move(work / f"{sources.name}{EXTENSION_SUFFIX}", folder)
