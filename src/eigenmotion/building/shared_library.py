"""Shared libraries of models: compilation, linking and loading. A complete library is also a Python module."""

import ctypes
import logging
import shutil
import time
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import as_completed
from contextlib import contextmanager, suppress
from itertools import chain
from math import inf
from pathlib import Path
from tempfile import TemporaryDirectory
from threading import Lock
from typing import TYPE_CHECKING

from ..codegen.model import Model
from ..codegen.render.emit import SourceFile, Sources
from ..cores import cores
from ..garbage import uncollected
from .cache import LOCATION, entry, key, location
from .errors import BuildError
from .lazy_units import methods_of, whole
from .processes import ToolPool
from .toolchain import EXTENSION_SUFFIX, IN_PLACE_OF, STEPPER, Toolchain, headers

if TYPE_CHECKING:
    from ..system.system import System

_log = logging.getLogger("eigenmotion")
_loading = Lock()
Units = tuple[tuple[str, str], ...]
_loaded: dict[tuple[Path, Units], "System"] = {}
_SECONDS = "seconds"
"""File with the duration of the stepper's compilation, beside its object."""
_SHARE_OF_STEPPER, _BYTES_OF_HEADERS = 0.08, 60_000
"""The compiler's time for a model's units is about this part of that for the stepper, for the headers, and as much
again for so many bytes of the model's own text: within a third for the models of `benchmarks/pipeline.py`."""
_CAPSULE = b"eigenmotion.em_model"  # a constant, as capsules must outlive their name
_capsule = ctypes.pythonapi.PyCapsule_New
_capsule.restype, _capsule.argtypes = ctypes.py_object, (ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p)


def compile_in(sources: Sources, tools: Toolchain, folder: Path, model: Model | None = None,
               units: Sequence[str] = (), existing: Sequence[Path] = ()) -> None:  # fmt: skip
    """Compile units (default: all) and link them with `existing` objects; prove the library; copy it to `folder`.

    The compiler runs in a temporary folder inside `folder`, since it leaves other files; if the build is killed, it is
    deleted together with `folder`. With existing objects, only the methods of the new units are proved.
    """
    library, proved = f"{sources.name}{EXTENSION_SUFFIX}", methods_of(tuple(units) or whole())
    with _work(sources.files, folder) as work:
        with ToolPool(1) as pool:
            built = pool.submit(compile_and_link, work, sources.name, tools, units, existing)
            with uncollected():
                from .verification import prove, prove_methods  # noqa: PLC0415, slow import while the compiler runs
        new = built.result()
        if model is not None:
            _log.info("proving %s", sources.name)
            system = system_in(work / library)
            prove_methods(model, system, proved) if existing else prove(model, system, proved)
        for name in (library, *new):
            shutil.copyfile(work / name, folder / name)


@contextmanager
def _work(files: Iterable[SourceFile], folder: Path) -> Iterator[Path]:
    """Make a temporary folder with files."""
    with TemporaryDirectory(prefix="work-", dir=folder) as place:
        for file in files:
            (Path(place) / file.name).write_text(file.text, encoding="utf-8")
        yield Path(place)


def compile_and_link(work: Path, name: str, tools: Toolchain, units: Sequence[str] = (), existing: Sequence[Path] = ()
                     ) -> tuple[str, ...]:  # fmt: skip
    """Compile units of NAME.c in parallel, then link them. Without `units`: all units, as a Python module.

    Returns the names of the new objects of this model.
    """
    is_module, units = not units, tuple(units) or whole()
    replaced = {f"{name}_{IN_PLACE_OF[unit]}.o" for unit in units if unit in IN_PLACE_OF}
    compiled_before = {path.name for path in existing}
    with ToolPool(cores()) as pool:
        shared = pool.submit(stepper, tools)
        missing = [unit for unit in units if f"{name}_{unit}.o" not in compiled_before]
        end = time.monotonic() + _expected(tools, work / f"{name}.c", len(missing) / len(units))
        jobs = [pool.submit(tools.compile_unit, work, name, unit) for unit in missing]
        if is_module:
            jobs.append(pool.submit(tools.compile_module, work, name))
        for k, _ in enumerate(chain([None], as_completed(jobs))):
            if k < len(jobs):
                left = {"expected": end - time.monotonic()}
                _log.info("compiling %s: %d of %d units are done", name, k, len(jobs), extra=left)
        new = tuple(job.result() for job in jobs)
        if not shared.done():
            _log.info("compiling the stepper, once for each compiler")
    tools.link(work, (*new, shared.result(), *(str(path) for path in existing if path.name not in replaced)), name)
    return new


def _expected(tools: Toolchain, text: Path, part: float) -> float:
    """Return about the seconds that compiling a part of a model's units takes; -inf: unknown.

    The compilation of the stepper, whose duration the cache keeps, has measured the compiler on this machine.
    """
    measured = location() / "steppers" / _stepper_key(tools) / _SECONDS
    with suppress(OSError, ValueError):
        size = text.stat().st_size / _BYTES_OF_HEADERS
        return part * _SHARE_OF_STEPPER * float(measured.read_text(encoding="ascii")) * (1 + size) / cores()
    return -inf


def _stepper_key(tools: Toolchain) -> str:
    return key(headers(), tools.identity)


def stepper(tools: Toolchain) -> str:
    """Return the path of the stepper object, which all models share; compiled once for each compiler and its flags."""

    def fill(folder: Path) -> None:
        start = time.monotonic()
        with _work((), folder) as work:
            shutil.move(work / tools.compile_stepper(work), folder / f"{STEPPER}.o")
        (folder / _SECONDS).write_text(f"{time.monotonic() - start:.3f}\n", encoding="ascii")

    return str(entry("steppers", _stepper_key(tools), fill) / f"{STEPPER}.o")


@contextmanager
def stepper_meanwhile(tools: Toolchain) -> Iterator[None]:
    """Compile the stepper, unless it is in the cache, while a model is derived.

    The link step takes it from the cache or waits for it. An error here occurs there again, and is reported there.
    """
    with ToolPool(1) as pool:
        pool.submit(stepper, tools)
        yield


def load(binary: Path, units: Units = ()) -> "System":
    """Load the library at `binary`, once per process, and return the System of its model.

    Models that differ in the words for their units alone have one library, but Systems of their own.
    """
    with _loading:
        if (binary, units) not in _loaded:
            _loaded[binary, units] = system_in(binary)
            _loaded[binary, units].compiled.units = dict(units) or None
        return _loaded[binary, units]


def system_in(binary: Path) -> "System":
    """Return a System of a library, which stays loaded even if its file is moved or deleted."""
    from ..system.system import System  # noqa: PLC0415, loads NumPy, for which compilers would wait

    stem = binary.name.removesuffix(EXTENSION_SUFFIX)
    try:
        model = ctypes.c_char.in_dll(ctypes.CDLL(str(binary)), f"{stem}_model")
    except (OSError, ValueError) as error:
        raise BuildError(f"{binary} cannot be loaded: {error}. Code must be allowed to run from there; "
                         f"${LOCATION} names another folder") from error  # fmt: skip
    return System(_capsule(ctypes.addressof(model), _CAPSULE, None))
