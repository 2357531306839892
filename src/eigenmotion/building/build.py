"""Build of a System: generation, compilation and proof, with results from the cache where possible."""

import logging
import sys
from functools import cache, partial
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

from ..codegen.model import Model
from ..codegen.render.emit import SourceFile, Sources, body_hash
from ..files import write
from ..progress import clock
from .cache import entry, guarded, key
from .errors import BuildError, FolderError
from .lazy_units import ALL_AT_FIRST, PARTS, WORDS, at_first
from .request import Request, request
from .shared_library import compile_in, load, stepper_meanwhile
from .toolchain import EXTENSION_SUFFIX, Toolchain, headers, toolchain
from .undefined_terms import undefined_terms

if TYPE_CHECKING:
    from ..runtime import CompiledModel
    from ..system.system import System

_log = logging.getLogger("eigenmotion")


def build(
    model: Model | str | PathLike[str],
    *,
    formulation: str | None = None,
    close_eigenvalues: str = "bounded",
    schur: str = "auto",
    output: str | PathLike[str] | None = None,
    compiler: str | None = None,
    flags: str | None = None,
    **keywords: object,
) -> "System":
    """Generate, compile and load a model. A model that was built before is loaded from the cache.

    The functions for runs with method "auto" are compiled and proved now. Derivatives, ensembles in lanes and other
    methods are compiled at their first use, and cached too (docs/flags.md). The module in `output` is complete.

    Parameters
    ----------
    model
        A Model, or the path of a file that defines one.
    formulation
        "eigenfactor", "cholesky", "lagrange" or "inverse"; "articulated_body" for models of a `Tree`. None:
        "articulated_body" if the masses are those of a `Tree`, else "eigenfactor".
    close_eigenvalues
        "bounded" or "extrapolate": the treatment of (32) near coincident eigenvalues.
    schur
        "auto", "factor" or "eigenfactor": the factorisation of Delta of (43).
    output
        A folder to which the sources and the compiled module are written as well.
    compiler, flags
        C compiler, and flags that follow ours; None: $CC and $EIGENMOTION_CFLAGS.
    **keywords
        Arguments of the file's function `model`: `build("chain.py", n=8)`. For an argument with the name of a
        parameter above, use `load_model`.

    Raises
    ------
    ModelError
        The model has a mistake, or has no such keyword.
    BuildError
        The compiler failed; contains its output. CompilerNotFoundError if there is no compiler, FolderError if the
        cache or `output` cannot be written.

    Examples
    --------
    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> em.build(model)
    <System pendulum: n=1, m=0, 2 states, eigenfactor>
    >>> em.build(model, formulation="lagrange").formulation
    'lagrange'
    """
    requested = request(model, keywords, formulation=formulation, close_eigenvalues=close_eigenvalues, schur=schur)
    folder = None if output is None else _folder(output)
    return system_of(requested, compiler, flags, folder)


def system_of(requested: Request, compiler: str | None = None, flags: str | None = None, output: Path | None = None
              ) -> "System":  # fmt: skip
    """Return the System of a request; it is pickled as the request."""
    tools = toolchain(compiler, flags)
    with clock():
        system = load(make(requested, tools, output), requested.model.units)
    system.compiled.recipe = partial(system_of, requested, compiler, flags)
    system.compiled.undefined_terms = partial(undefined_terms, requested.model)
    system.compiled.load_part = partial(load_part, requested, tools)
    return system


def load_part(requested: Request, tools: Toolchain, part: str) -> "CompiledModel":
    """Return a model with the functions of a part, which is compiled now unless it is in the cache.

    Raises
    ------
    BuildError
        As `build`; names the part.
    """
    try:
        with clock():
            return load(part_of(requested, tools, part)).compiled
    except BuildError as error:
        raise type(error)(
            f"{error}\n\nIt is {WORDS[part]} of {requested.model.name} that cannot be compiled: parts of a model are "
            "as something first asks for them. `eigenmotion build` makes a module that has all, where there is a "
            "compiler"
        ) from error


def make(requested: Request, tools: Toolchain, output: Path | None = None) -> Path:
    """Generate and compile, unless both are in the cache; return the path of the library in the cache.

    The library has the functions that any run may need. If `output` is given, the sources and a complete module are
    written to that folder after both exist.
    """
    with stepper_meanwhile(tools):
        if output is not None:
            sources = cached_sources(requested)
            binary = all_of(sources, tools, requested.model)
            with guarded():
                module = binary.read_bytes()
            _write(output, [(file.name, file.text.encode()) for file in sources.files] + [(binary.name, module)])
        return compiled(first_sources(requested), tools, requested.model)


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


def cached_sources(requested: Request) -> Sources:
    """Return the sources of a request, from the cache if the same generator wrote them before."""
    return _cached_sources(requested, requested.sources_hash, whole=True)


def first_sources(requested: Request) -> Sources:
    """Return the sources that first runs need: without derivatives, unless these runs need them."""
    if ALL_AT_FIRST:
        return cached_sources(requested)
    return _cached_sources(requested, key(requested.sources_hash, "first"), whole=False)


def _cached_sources(requested: Request, name: str, whole: bool) -> Sources:
    folder = entry("sources", name, lambda folder: _generate(requested, folder, whole))
    with guarded():
        files = tuple(SourceFile(name, (folder / name).read_text(encoding="utf-8")) for name in requested.file_names)
    return Sources(requested.model.name, files)


def compiled(sources: Sources, tools: Toolchain, model: Model | None = None) -> Path:
    """Return the path of the library compiled from `sources`, proved against `model` if that is given.

    The library has the functions that any run may need, and NULL for the others (lazy_units.py).
    """

    def fill(folder: Path) -> None:
        _log.info("compiling %s", sources.name)
        compile_in(sources, tools, folder, model, at_first(_text(sources)))

    folder = entry("binaries", _key(sources, tools, model), fill)
    return folder / f"{sources.name}{EXTENSION_SUFFIX}"


def part_of(requested: Request, tools: Toolchain, part: str) -> Path:
    """Return the path of the library of a part: new objects for the part, and the objects of `compiled`."""
    units, model, first = PARTS[part], requested.model, first_sources(requested)
    existing = _objects(compiled(first, tools, model))
    sources = cached_sources(requested) if part == "derivatives" else first

    def fill(folder: Path) -> None:
        _log.info("compiling %s of %s", WORDS[part], sources.name)
        compile_in(sources, tools, folder, model, units, tuple(existing.values()))

    folder = entry("binaries", key(_key(sources, tools, model), part), fill)
    return folder / f"{sources.name}{EXTENSION_SUFFIX}"


def all_of(sources: Sources, tools: Toolchain, model: Model | None = None) -> Path:
    """Return the path of a complete, proved Python module, for the folders of users."""

    def fill(folder: Path) -> None:
        _log.info("compiling all of %s", sources.name)
        compile_in(sources, tools, folder, model)

    folder = entry("binaries", key(_key(sources, tools, model), "all", _python()), fill)
    return folder / f"{sources.name}{EXTENSION_SUFFIX}"


def _objects(library: Path) -> dict[str, Path]:
    """Return name -> path of the objects beside a library in the cache."""
    return {path.name: path for path in sorted(library.parent.glob("*.o"))}


def _text(sources: Sources) -> str:
    return next(file.text for file in sources.files if file.name.endswith(".c"))


def _key(sources: Sources, tools: Toolchain, model: Model | None) -> str:
    bodies = [body_hash(file.text) for file in sources.files]
    proved = () if model is None else (model.canonical(), _proof())
    return key(sources.name, *bodies, headers(), tools.identity, *proved)


def _generate(requested: Request, folder: Path, whole: bool) -> None:
    for file in requested.sources(whole).files:
        (folder / file.name).write_text(file.text, encoding="utf-8")


def _python() -> str:
    """Return a hash of the interpreter, whose binary interface a module uses."""
    return key(sys.version, EXTENSION_SUFFIX)


@cache
def _proof() -> str:
    """Return a hash of the code that proves a library before it is cached."""
    return key(*(path.read_bytes() for path in sorted((Path(__file__).parent / "verification").rglob("*.py"))))
