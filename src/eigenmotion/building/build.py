"""Sources -> extension module -> System, by way of the cache."""

import logging
import shutil
import sys
from concurrent.futures import ThreadPoolExecutor
from functools import cache, partial
from importlib.machinery import ExtensionFileLoader, ModuleSpec
from importlib.metadata import version
from importlib.util import module_from_spec
from os import PathLike
from pathlib import Path
from tempfile import TemporaryDirectory
from threading import Lock
from types import ModuleType

from ..codegen.c.emit import SourceFile, Sources, body_hash
from ..codegen.model import Model
from ..files import write
from ..system.system import System
from .cache import LOCATION, entry, guarded, key
from .errors import BuildError, FolderError
from .proof import prove
from .request import Order, order
from .toolchain import EXTENSION_SUFFIX, INCLUDE, Toolchain, run, toolchain

_log = logging.getLogger("eigenmotion")
_loading = Lock()
GLUE = "glue"


def build(
    model: Model | str | PathLike[str],
    *,
    formulation: str = "eigenfactor",
    close_eigenvalues: str = "bounded",
    schur: str = "auto",
    output: str | PathLike[str] | None = None,
    compiler: str | None = None,
    flags: str | None = None,
    **keywords: object,
) -> System:
    """Generate, compile and import; what was built before is taken from the cache.

    Parameters
    ----------
    model
        A Model, or the path of a file that defines one.
    formulation
        "eigenfactor", "cholesky", "lagrange" or "inverse".
    close_eigenvalues
        "bounded" or "extrapolate": what becomes of (32) where eigenvalues meet.
    schur
        "auto", "factor" or "eigenfactor": how Delta of (43) is factored.
    output
        A folder that gets the sources and the compiled module as well.
    compiler, flags
        C compiler and flags after ours; else $CC and $EIGENMOTION_CFLAGS.
    **keywords
        Arguments of the file's function `model`: `build("chain.py", n=8)`. Those named as one above: see `load_model`.

    Raises
    ------
    ModelError
        The model has a mistake, or takes no such keyword.
    BuildError
        The compiler refused the code; carries its words. CompilerNotFoundError where there is none, FolderError where
        the cache or `output` cannot be written to.
    """
    wanted = order(model, keywords, formulation=formulation, close_eigenvalues=close_eigenvalues, schur=schur)
    folder = None if output is None else _folder(output)
    return system_of(wanted, compiler, flags, folder)


def system_of(wanted: Order, compiler: str | None = None, flags: str | None = None, output: Path | None = None
              ) -> System:  # fmt: skip
    """Return the System of an order, which pickles as that order."""
    system = load(make(wanted, toolchain(compiler, flags), output))
    system.compiled.recipe = partial(system_of, wanted, compiler, flags)
    return system


def make(wanted: Order, tools: Toolchain, output: Path | None = None) -> Path:
    """Generate and compile, or find both in the cache; return the extension module in the cache.

    Where `output` is given, that folder gets the sources and the module, once both are there.
    """
    sources = cached_sources(wanted)
    binary = compiled(sources, tools, wanted.model)
    if output is not None:
        with guarded():
            module = binary.read_bytes()
        _write(output, [(file.name, file.text.encode()) for file in sources.files] + [(binary.name, module)])
    return binary


def _folder(output: object) -> Path:
    try:
        return Path(output)  # type: ignore[arg-type]
    except TypeError as error:
        raise FolderError(f"output is {output!r}: give the path of a folder") from error


def _write(folder: Path, files: list[tuple[str, bytes]]) -> None:
    try:
        for name, content in files:
            write(folder / name, content)
    except (OSError, ValueError) as error:
        raise FolderError(f"cannot write to the output folder {folder}: {error}") from error


def cached_sources(wanted: Order) -> Sources:
    """Return the sources of an order, derived unless the same generator did so before."""
    folder = entry("sources", wanted.question, lambda folder: _generate(wanted, folder))
    with guarded():
        files = tuple(SourceFile(name, (folder / name).read_text(encoding="utf-8")) for name in wanted.file_names)
    return Sources(wanted.model.name, files)


def compiled(sources: Sources, tools: Toolchain, model: Model | None = None) -> Path:
    """Return the path of the extension module made of `sources`, and proved to be the model, where that is given."""
    bodies = [body_hash(file.text) for file in sources.files]
    proved = () if model is None else (model.canonical(), _proof())
    name = key(sources.name, *bodies, _abi(), tools.identity, _python(), *proved)
    folder = entry("binaries", name, lambda folder: compile_in(sources, tools, folder, model))
    return folder / f"{sources.name}{EXTENSION_SUFFIX}"


def load(binary: Path) -> System:
    """Import the extension module at `binary`, once a process, and return its `system`."""
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


def _loaded_apart(binary: Path, stem: str) -> System:
    """Return the System of a module that is loaded from here this once; what is imported later is a copy of it."""
    with _loading:
        system: System = _executed(f"_eigenmotion_apart.{stem}", binary).system
    return system


def _generate(wanted: Order, folder: Path) -> None:
    _log.info("deriving %s", wanted.model.name)
    for file in wanted.sources().files:
        (folder / file.name).write_text(file.text, encoding="utf-8")


def compile_in(sources: Sources, tools: Toolchain, folder: Path, model: Model | None = None) -> None:
    """Compile in a folder of its own, for compilers leave files about, prove the module and keep it only.

    It lies in the one that gets the module: what a build that is killed leaves behind goes with that.
    """
    _log.info("compiling %s", sources.name)
    with TemporaryDirectory(prefix="work-", dir=folder) as place:
        work = Path(place)
        for file in sources.files:
            (work / file.name).write_text(file.text, encoding="utf-8")
        _compile_in(work, sources.name, tools)
        module = f"{sources.name}{EXTENSION_SUFFIX}"
        if model is not None:
            prove(model, _loaded_apart(work / module, sources.name))
        shutil.copyfile(work / module, folder / module)


def _compile_in(work: Path, name: str, tools: Toolchain) -> None:
    """NAME.c, and NAME.pyx -> glue/NAME.c, into one module.

    In a folder of its own, what Cython writes finds Python's headers also where NAME is `Python` or `code`.
    """
    glue = f"{GLUE}/{name}"
    (work / GLUE).mkdir()
    with ThreadPoolExecutor(max_workers=1) as pool:
        model = pool.submit(tools.compile_model, work, name)
        run((sys.executable, "-P", "-m", "cython", "-3", "--module-name", name, f"{name}.pyx", "-o", f"{glue}.c"), work)
        tools.compile_glue(work, glue)
        model.result()
    tools.link(work, (name, glue), name)


@cache
def _abi() -> str:
    """Hash of the headers that are compiled in."""
    return key(*(path.read_bytes() for path in sorted(INCLUDE.glob("*.h"))))


def _python() -> str:
    """Interpreter and libraries whose binary interfaces the module uses."""
    return key(sys.version, EXTENSION_SUFFIX, version("cython"), version("numpy"))


@cache
def _proof() -> str:
    """Hash of what a module is held against before it is kept."""
    return key(*(path.read_bytes() for path in sorted((Path(__file__).parent / "proof").glob("*.py"))))
