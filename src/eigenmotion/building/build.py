"""Sources -> extension module -> System, by way of the cache."""

import logging
import sys
from functools import cache, partial
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

from ..codegen.model import Model
from ..codegen.render.emit import SourceFile, Sources, body_hash
from ..files import write
from .cache import entry, guarded, key
from .errors import BuildError, FolderError
from .lazy_units import ALL_AT_FIRST, PARTS, WORDS, at_first
from .request import Request, request
from .shared_library import compile_in, load, stepper_meanwhile
from .toolchain import EXTENSION_SUFFIX, Toolchain, headers, toolchain

if TYPE_CHECKING:
    from ..runtime import CompiledModel
    from ..system.system import System

_log = logging.getLogger("eigenmotion")


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
) -> "System":
    """Generate, compile and import; what was built before is taken from the cache.

    What runs by `auto` need is compiled and proved now; derivatives, ensembles in lanes and other methods are as they
    are first asked for, and kept likewise (docs/flags.md). What `output` gets has all.

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

    Examples
    --------
    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> em.build(model)
    <System pendulum: n=1, m=0, 2 states, eigenfactor>
    >>> em.build(model, formulation="lagrange").formulation
    'lagrange'
    """
    wanted = request(model, keywords, formulation=formulation, close_eigenvalues=close_eigenvalues, schur=schur)
    folder = None if output is None else _folder(output)
    return system_of(wanted, compiler, flags, folder)


def system_of(wanted: Request, compiler: str | None = None, flags: str | None = None, output: Path | None = None
              ) -> "System":  # fmt: skip
    """Return the System of a request, which pickles as that request."""
    tools = toolchain(compiler, flags)
    system = load(make(wanted, tools, output))
    system.compiled.recipe = partial(system_of, wanted, compiler, flags)
    system.compiled.later = partial(later, wanted, tools)
    return system


def later(wanted: Request, tools: Toolchain, part: str) -> "CompiledModel":
    """Return a model that has what others lack until somebody asks; compiled now unless it was before.

    Raises
    ------
    BuildError
        As `build`; says what was asked for.
    """
    try:
        return load(part_of(wanted, tools, part)).compiled
    except BuildError as error:
        raise type(error)(
            f"{error}\n\nIt is {WORDS[part]} of {wanted.model.name} that cannot be compiled: parts of a model are as "
            "something first asks for them. `eigenmotion build` makes a module that has all, where there is a compiler"
        ) from error


def make(wanted: Request, tools: Toolchain, output: Path | None = None) -> Path:
    """Generate and compile, or find both in the cache; return the library in the cache.

    It has what every run may need. Where `output` is given, that folder gets the sources and a module that has all,
    once both are there.
    """
    with stepper_meanwhile(tools):
        if output is not None:
            sources = cached_sources(wanted)
            binary = all_of(sources, tools, wanted.model)
            with guarded():
                module = binary.read_bytes()
            _write(output, [(file.name, file.text.encode()) for file in sources.files] + [(binary.name, module)])
        return compiled(first_sources(wanted), tools, wanted.model)


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


def cached_sources(wanted: Request) -> Sources:
    """Return the sources of a request, derived unless the same generator did so before."""
    return _cached_sources(wanted, wanted.sources_hash, whole=True)


def first_sources(wanted: Request) -> Sources:
    """Return what of the sources first runs need: all but derivatives, unless those are part of that."""
    if ALL_AT_FIRST:
        return cached_sources(wanted)
    return _cached_sources(wanted, key(wanted.sources_hash, "first"), whole=False)


def _cached_sources(wanted: Request, name: str, whole: bool) -> Sources:
    folder = entry("sources", name, lambda folder: _generate(wanted, folder, whole))
    with guarded():
        files = tuple(SourceFile(name, (folder / name).read_text(encoding="utf-8")) for name in wanted.file_names)
    return Sources(wanted.model.name, files)


def compiled(sources: Sources, tools: Toolchain, model: Model | None = None) -> Path:
    """Return the path of the library made of `sources`, and proved to be the model, where that is given.

    It has what every run may need, and NULL for the rest (parts.py).
    """

    def fill(folder: Path) -> None:
        _log.info("compiling %s", sources.name)
        compile_in(sources, tools, folder, model, at_first(_text(sources)))

    folder = entry("binaries", _key(sources, tools, model), fill)
    return folder / f"{sources.name}{EXTENSION_SUFFIX}"


def part_of(wanted: Request, tools: Toolchain, part: str) -> Path:
    """Return the path of the library that has a part in new objects, and the rest in those of `compiled`."""
    units, model, first = PARTS[part], wanted.model, first_sources(wanted)
    kept = _objects(compiled(first, tools, model))
    sources = cached_sources(wanted) if part == "derivatives" else first

    def fill(folder: Path) -> None:
        _log.info("compiling %s of %s", WORDS[part], sources.name)
        compile_in(sources, tools, folder, model, units, tuple(kept.values()))

    folder = entry("binaries", key(_key(sources, tools, model), part), fill)
    return folder / f"{sources.name}{EXTENSION_SUFFIX}"


def all_of(sources: Sources, tools: Toolchain, model: Model | None = None) -> Path:
    """Return the path of Python's module that has all, and proved so: for folders that users keep."""

    def fill(folder: Path) -> None:
        _log.info("compiling all of %s", sources.name)
        compile_in(sources, tools, folder, model)

    folder = entry("binaries", key(_key(sources, tools, model), "all", _python()), fill)
    return folder / f"{sources.name}{EXTENSION_SUFFIX}"


def _objects(library: Path) -> dict[str, Path]:
    """Return the objects that an entry has beside its library, by name."""
    return {path.name: path for path in sorted(library.parent.glob("*.o"))}


def _text(sources: Sources) -> str:
    return next(file.text for file in sources.files if file.name.endswith(".c"))


def _key(sources: Sources, tools: Toolchain, model: Model | None) -> str:
    bodies = [body_hash(file.text) for file in sources.files]
    proved = () if model is None else (model.canonical(), _proof())
    return key(sources.name, *bodies, headers(), tools.identity, *proved)


def _generate(wanted: Request, folder: Path, whole: bool) -> None:
    _log.info("deriving %s", wanted.model.name)
    for file in wanted.sources(whole).files:
        (folder / file.name).write_text(file.text, encoding="utf-8")


def _python() -> str:
    """The interpreter, whose binary interface a module uses."""
    return key(sys.version, EXTENSION_SUFFIX)


@cache
def _proof() -> str:
    """Hash of what a module is held against before it is kept."""
    return key(*(path.read_bytes() for path in sorted((Path(__file__).parent / "verification").rglob("*.py"))))
