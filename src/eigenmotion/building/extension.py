"""Extension modules: sources are compiled into one, and it is imported."""

import logging
import shutil
import sys
from concurrent.futures import ThreadPoolExecutor
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
from .toolchain import EXTENSION_SUFFIX, SHARED_UNIT, UNITS, Toolchain

if TYPE_CHECKING:
    from ..system.system import System

_log = logging.getLogger("eigenmotion")
_loading = Lock()
OBJECT = "stepper.o"


def compile_in(sources: Sources, tools: Toolchain, folder: Path, model: Model | None = None) -> None:
    """Compile in a folder of its own, for compilers leave files about, prove the module and keep it only.

    It lies in the one that gets the module: what a build that is killed leaves behind goes with that.
    """
    _log.info("compiling %s", sources.name)
    with TemporaryDirectory(prefix="work-", dir=folder) as place:
        work = Path(place)
        for file in sources.files:
            (work / file.name).write_text(file.text, encoding="utf-8")
        with ThreadPoolExecutor(max_workers=1) as pool:
            built = pool.submit(compile_and_link, work, sources.name, tools)
            from .proof import prove  # noqa: PLC0415, half a second with all that runs a model, while compilers work
        built.result()
        module = f"{sources.name}{EXTENSION_SUFFIX}"
        if model is not None:
            prove(model, _loaded_apart(work / module, sources.name))
        shutil.copyfile(work / module, folder / module)


def compile_and_link(work: Path, name: str, tools: Toolchain) -> None:
    """The units of NAME.c, and what makes a module of them, side by side; then the module."""
    with ThreadPoolExecutor(max_workers=len(UNITS) + 1) as pool:
        objects = [pool.submit(_shared_unit, work, name, tools)]
        objects.extend(pool.submit(tools.compile_unit, work, name, unit) for unit in UNITS if unit != SHARED_UNIT)
        objects.append(pool.submit(tools.compile_module, work, name))
        tools.link(work, tuple(one.result() for one in objects), name)


def _shared_unit(work: Path, name: str, tools: Toolchain) -> str:
    """Return the path of the stepper's object, which a model of the same shape may have left in the cache."""
    text = tools.preprocess_unit(work, name, SHARED_UNIT)

    def fill(folder: Path) -> None:
        shutil.move(work / tools.compile_unit(work, name, SHARED_UNIT), folder / OBJECT)

    return str(entry("steppers", key(text, tools.identity), fill) / OBJECT)


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
