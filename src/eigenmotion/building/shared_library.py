"""Shared libraries of models: compilation, linking and loading. A complete library is also a Python module."""

import ctypes
import logging
import shutil
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from threading import Lock
from typing import TYPE_CHECKING

from ..codegen.model import Model
from ..codegen.render.emit import SourceFile, Sources
from ..cores import cores
from ..garbage import uncollected
from .cache import LOCATION, entry, key
from .errors import BuildError
from .lazy_units import methods_of, whole
from .toolchain import EXTENSION_SUFFIX, IN_PLACE_OF, STEPPER, Toolchain, headers

if TYPE_CHECKING:
    from ..system.system import System

_log = logging.getLogger("eigenmotion")
_loading = Lock()
Units = tuple[tuple[str, str], ...]
_loaded: dict[tuple[Path, Units], "System"] = {}
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
        with ThreadPoolExecutor(max_workers=1) as pool:
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
    with ThreadPoolExecutor(max_workers=cores()) as pool:
        shared = pool.submit(stepper, tools)
        missing = [unit for unit in units if f"{name}_{unit}.o" not in compiled_before]
        jobs = [pool.submit(tools.compile_unit, work, name, unit) for unit in missing]
        if is_module:
            jobs.append(pool.submit(tools.compile_module, work, name))
        for k, _ in enumerate(as_completed(jobs), 1):
            if k < len(jobs):
                _log.info("compiling %s: %d of %d units are done", name, k, len(jobs))
        new = tuple(job.result() for job in jobs)
    tools.link(work, (*new, shared.result(), *(str(path) for path in existing if path.name not in replaced)), name)
    return new


def stepper(tools: Toolchain) -> str:
    """Return the path of the stepper object, which all models share; compiled once for each compiler and its flags."""

    def fill(folder: Path) -> None:
        with _work((), folder) as work:
            shutil.move(work / tools.compile_stepper(work), folder / f"{STEPPER}.o")

    return str(entry("steppers", key(headers(), tools.identity), fill) / f"{STEPPER}.o")


@contextmanager
def stepper_meanwhile(tools: Toolchain) -> Iterator[None]:
    """Compile the stepper, unless it is in the cache, while a model is derived.

    The link step takes it from the cache or waits for it. An error here occurs there again, and is reported there.
    """
    with ThreadPoolExecutor(max_workers=1) as pool:
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
