"""Sources -> extension module -> System, by way of the cache."""

import logging
import sys
from functools import cache, partial
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

from ..codegen.c.emit import SourceFile, Sources, body_hash
from ..codegen.model import Model
from ..files import write
from .cache import entry, guarded, key
from .differentiated import rate_jacobian
from .errors import FolderError
from .extension import compile_in, load
from .request import Request, request
from .toolchain import EXTENSION_SUFFIX, INCLUDE, Toolchain, toolchain

if TYPE_CHECKING:
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
    system = load(make(wanted, toolchain(compiler, flags), output))
    system.compiled.recipe = partial(system_of, wanted, compiler, flags)
    system.compiled.differentiated = cache(partial(_differentiated, wanted, compiler, flags))
    return system


def _differentiated(wanted: Request, compiler: str | None, flags: str | None) -> int:
    return rate_jacobian(cached_sources(wanted), toolchain(compiler, flags))


def make(wanted: Request, tools: Toolchain, output: Path | None = None) -> Path:
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


def cached_sources(wanted: Request) -> Sources:
    """Return the sources of a request, derived unless the same generator did so before."""
    folder = entry("sources", wanted.sources_hash, lambda folder: _generate(wanted, folder))
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


def _generate(wanted: Request, folder: Path) -> None:
    _log.info("deriving %s", wanted.model.name)
    for file in wanted.sources().files:
        (folder / file.name).write_text(file.text, encoding="utf-8")


@cache
def _abi() -> str:
    """Hash of the headers that are compiled in, and of what makes a module of a model."""
    return key(*(path.read_bytes() for path in sorted(INCLUDE.glob("*.[ch]"))))


def _python() -> str:
    """The interpreter, whose binary interface the module uses."""
    return key(sys.version, EXTENSION_SUFFIX)


@cache
def _proof() -> str:
    """Hash of what a module is held against before it is kept."""
    return key(*(path.read_bytes() for path in sorted((Path(__file__).parent / "proof").glob("*.py"))))
