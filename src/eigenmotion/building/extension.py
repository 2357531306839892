"""Extension modules: sources are compiled into one, and it is imported."""

import logging
import shutil
import sys
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from importlib.machinery import ExtensionFileLoader, ModuleSpec
from importlib.util import module_from_spec
from pathlib import Path
from tempfile import TemporaryDirectory
from threading import Lock
from types import ModuleType
from typing import TYPE_CHECKING

from ..codegen.c.emit import Sources
from ..codegen.model import Model
from .cache import LOCATION, entry, key
from .errors import BuildError
from .parts import methods_of, whole
from .toolchain import EXTENSION_SUFFIX, IN_PLACE_OF, OF_A_SHAPE, Toolchain

if TYPE_CHECKING:
    from ..system.system import System

_log = logging.getLogger("eigenmotion")
_loading = Lock()


def compile_in(sources: Sources, tools: Toolchain, folder: Path, model: Model | None = None,
               units: Sequence[str] = (), kept: Sequence[Path] = ()) -> None:  # fmt: skip
    """Compile units (all), prove the module of them and of objects that are `kept`, and keep it beside new objects.

    Compilers work in a folder of its own, for they leave files about. It lies in the one that gets the module: what a
    build that is killed leaves behind goes with that. What has been proved of objects that are kept is not proved anew.
    """
    module = f"{sources.name}{EXTENSION_SUFFIX}"
    units = tuple(units) or whole()
    with _work(sources, folder) as work:
        with ThreadPoolExecutor(max_workers=1) as pool:
            built = pool.submit(compile_and_link, work, sources.name, tools, units, kept)
            from .proof import prove, prove_methods  # noqa: PLC0415, half a second, and more, while compilers work
        made = built.result()
        if model is not None:
            system = _loaded_apart(work / module, sources.name)
            prove_methods(model, system, methods_of(units)) if kept else prove(model, system, methods_of(units))
        for name in (module, *made):
            shutil.copyfile(work / name, folder / name)


@contextmanager
def _work(sources: Sources, folder: Path) -> Iterator[Path]:
    """A folder with the sources."""
    with TemporaryDirectory(prefix="work-", dir=folder) as place:
        for file in sources.files:
            (Path(place) / file.name).write_text(file.text, encoding="utf-8")
        yield Path(place)


def compile_and_link(work: Path, name: str, tools: Toolchain, units: Sequence[str] = (), kept: Sequence[Path] = ()
                     ) -> tuple[str, ...]:  # fmt: skip
    """Units of NAME.c side by side, with what makes a module of them unless that is `kept`; then the module.

    Returns the names of objects that are new, and this model's alone.
    """
    units = tuple(units) or whole()
    replaced = {f"{name}_{IN_PLACE_OF[unit]}.o" for unit in units if unit in IN_PLACE_OF}
    shaped = [unit for unit in dict.fromkeys(("stepper", *units)) if unit in OF_A_SHAPE]
    there = {path.name for path in kept}
    with ThreadPoolExecutor(max_workers=len(units) + 2) as pool:
        shared = [pool.submit(_shared_unit, work, name, unit, tools) for unit in shaped]
        own = [unit for unit in units if unit not in OF_A_SHAPE and f"{name}_{unit}.o" not in there]
        made = [pool.submit(tools.compile_unit, work, name, unit) for unit in own]
        if not kept:
            made.append(pool.submit(tools.compile_module, work, name))
        new, others = tuple(one.result() for one in made), [one.result() for one in shared]
    tools.link(work, (*new, *others, *(str(path) for path in kept if path.name not in replaced)), name)
    return new


def _shared_unit(work: Path, name: str, unit: str, tools: Toolchain) -> str:
    """Return the path of the object of a unit that a model of the same shape may have left in the cache."""
    text = tools.preprocess_unit(work, name, unit)

    def fill(folder: Path) -> None:
        shutil.move(work / tools.compile_unit(work, name, unit), folder / f"{unit}.o")

    return str(entry("steppers", key(text, tools.identity), fill) / f"{unit}.o")


def load(binary: Path) -> "System":
    """Import the extension module at `binary`, once a process, and return its `system`."""
    from ..system.system import System  # noqa: PLC0415, as above

    stem = binary.name.removesuffix(EXTENSION_SUFFIX)
    name = f"_eigenmotion_{binary.parent.name}.{stem}"
    with _loading:
        try:
            system: object = (sys.modules.get(name) or _import(name, binary)).system
        except ImportError as error:
            raise BuildError(f"{binary} cannot be loaded: {error}. Code must be allowed to run from there; "
                             f"${LOCATION} names another folder") from error  # fmt: skip
    if not isinstance(system, System):
        raise BuildError(f"{binary}: `system` is a {type(system).__name__}, not a System")
    return system


def _import(name: str, binary: Path) -> ModuleType:
    sys.modules[name] = module = _executed(name, binary)
    return module


def _executed(name: str, binary: Path) -> ModuleType:
    loader = ExtensionFileLoader(name, str(binary))
    module = module_from_spec(ModuleSpec(name, loader, origin=str(binary)))
    loader.exec_module(module)
    return module


def _loaded_apart(binary: Path, stem: str) -> "System":
    """Return the System of a module that is loaded from here this once; what is imported later is a copy of it."""
    with _loading:
        system: System = _executed(f"_eigenmotion_apart.{stem}", binary).system
    return system
