"""Libraries of models: sources are compiled into one, and it is loaded; one that has all is a module of Python, too."""

import ctypes
import logging
import shutil
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
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
_loaded: dict[Path, "System"] = {}
_CAPSULE = b"eigenmotion.em_model"  # which outlives its capsules, as they ask
_capsule = ctypes.pythonapi.PyCapsule_New
_capsule.restype, _capsule.argtypes = ctypes.py_object, (ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p)


def compile_in(sources: Sources, tools: Toolchain, folder: Path, model: Model | None = None,
               units: Sequence[str] = (), kept: Sequence[Path] = ()) -> None:  # fmt: skip
    """Compile units (all), prove the library of them and of objects that are `kept`, and keep it beside new objects.

    Compilers work in a folder of its own, for they leave files about. It lies in the one that gets the library: what a
    build that is killed leaves behind goes with that. What has been proved of objects that are kept is not proved anew.
    """
    library, proved = f"{sources.name}{EXTENSION_SUFFIX}", methods_of(tuple(units) or whole())
    with _work(sources.files, folder) as work:
        with ThreadPoolExecutor(max_workers=1) as pool:
            built = pool.submit(compile_and_link, work, sources.name, tools, units, kept)
            with uncollected():
                from .verification import prove, prove_methods  # noqa: PLC0415, half a second, and more, while compilers work
        made = built.result()
        if model is not None:
            system = system_in(work / library)
            prove_methods(model, system, proved) if kept else prove(model, system, proved)
        for name in (library, *made):
            shutil.copyfile(work / name, folder / name)


@contextmanager
def _work(files: Iterable[SourceFile], folder: Path) -> Iterator[Path]:
    """A folder with files."""
    with TemporaryDirectory(prefix="work-", dir=folder) as place:
        for file in files:
            (Path(place) / file.name).write_text(file.text, encoding="utf-8")
        yield Path(place)


def compile_and_link(work: Path, name: str, tools: Toolchain, units: Sequence[str] = (), kept: Sequence[Path] = ()
                     ) -> tuple[str, ...]:  # fmt: skip
    """Units of NAME.c side by side, then the library of them. Without `units`: all, and it is a module of Python.

    Returns the names of objects that are new, and this model's alone.
    """
    is_module, units = not units, tuple(units) or whole()
    replaced = {f"{name}_{IN_PLACE_OF[unit]}.o" for unit in units if unit in IN_PLACE_OF}
    there = {path.name for path in kept}
    with ThreadPoolExecutor(max_workers=cores()) as pool:
        shared = pool.submit(stepper, tools)
        own = [unit for unit in units if f"{name}_{unit}.o" not in there]
        made = [pool.submit(tools.compile_unit, work, name, unit) for unit in own]
        if is_module:
            made.append(pool.submit(tools.compile_module, work, name))
        new = tuple(one.result() for one in made)
    tools.link(work, (*new, shared.result(), *(str(path) for path in kept if path.name not in replaced)), name)
    return new


def stepper(tools: Toolchain) -> str:
    """Return the path of the object that all models have in common: compiled once by each compiler, with its flags."""

    def fill(folder: Path) -> None:
        with _work((), folder) as work:
            shutil.move(work / tools.compile_stepper(work), folder / f"{STEPPER}.o")

    return str(entry("steppers", key(headers(), tools.identity), fill) / f"{STEPPER}.o")


@contextmanager
def stepper_meanwhile(tools: Toolchain) -> Iterator[None]:
    """Have the stepper compiled, where it is not yet, while a model is derived.

    Whoever needs it finds it in the cache, or waits for it; what goes wrong here goes wrong there again, and says so.
    """
    with ThreadPoolExecutor(max_workers=1) as pool:
        pool.submit(stepper, tools)
        yield


def load(binary: Path) -> "System":
    """Load the library at `binary`, once a process, and return the System of its model."""
    with _loading:
        if binary not in _loaded:
            _loaded[binary] = system_in(binary)
        return _loaded[binary]


def system_in(binary: Path) -> "System":
    """Return a System of what is in a library now; it stays loaded, wherever its file goes."""
    from ..system.system import System  # noqa: PLC0415, as above

    stem = binary.name.removesuffix(EXTENSION_SUFFIX)
    try:
        model = ctypes.c_char.in_dll(ctypes.CDLL(str(binary)), f"{stem}_model")
    except (OSError, ValueError) as error:
        raise BuildError(f"{binary} cannot be loaded: {error}. Code must be allowed to run from there; "
                         f"${LOCATION} names another folder") from error  # fmt: skip
    return System(_capsule(ctypes.addressof(model), _CAPSULE, None))
