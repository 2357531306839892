"""Request for generated code: a model, the options of generation, and the command for the headers."""

from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass
from functools import cache
from importlib.metadata import version
from importlib.resources import files
from importlib.resources.abc import Traversable
from os import PathLike
from pathlib import Path

from ..codegen.choices import STANDARD, Choices
from ..codegen.compiler import explain, generate, input_hash, suited
from ..codegen.model import Model, ModelError
from ..codegen.render.emit import Sources
from ..garbage import uncollected
from .cache import key
from .model_file import load_model

SUFFIXES = (".h", ".c", ".pyx")
OPTIONS = ("formulation", "close_eigenvalues", "schur", "output", "compiler", "flags")
"""Options of `build`."""


@dataclass(frozen=True, slots=True)
class Request:
    """A model and the options of its generated code; `origin` is the command in the headers of the files."""

    model: Model
    choices: Choices = STANDARD
    origin: str = ""

    @property
    def input_hash(self) -> str:
        """Hash of the model and the options: all inputs of the generator."""
        return input_hash(self.model, self.choices)

    @property
    def sources_hash(self) -> str:
        """Hash of all that the generated text depends on: inputs, command and generator."""
        return key(self.input_hash, self.origin, generator_hash())

    def sources(self, whole: bool = True) -> Sources:
        """Derive and render; `whole` as in `generate`."""
        with uncollected():
            return generate(self.model, self.choices, origin=self.origin, whole=whole)

    def explanation(self) -> str:
        """Return a text about what the generated code computes and leaves out."""
        return explain(self.model, self.choices)

    @property
    def file_names(self) -> tuple[str, ...]:
        """Names of the generated files."""
        return tuple(self.model.name + suffix for suffix in SUFFIXES)


def request(
    source: Model | str | PathLike[str],
    definitions: Mapping[str, object] | None = None,
    *,
    formulation: str | None = None,
    close_eigenvalues: str = "bounded",
    schur: str = "auto",
) -> Request:
    """Return the request for a model, or for the model that the file `source` defines.

    Parameters
    ----------
    definitions
        Arguments of the file's function `model`.
    formulation
        None: "articulated_body" for masses in trees of bodies, "eigenfactor" for all others.

    Raises
    ------
    ModelError
        The file or the model has a mistake, or has no such arguments.
    """
    choices = Choices(formulation or STANDARD.formulation, close_eigenvalues, schur)
    keywords = definitions or {}
    if isinstance(source, Model):
        if keywords:
            from ..arguments.named_values import unknown  # noqa: PLC0415, loads NumPy, for which compilers would wait

            raise ModelError(f"model {source.name}: {unknown('option', keywords, OPTIONS)} A Model takes no keywords.")
        return Request(source, choices if formulation else suited(source, choices))
    model = load_model(source, **keywords)
    choices = choices if formulation else suited(model, choices)
    return Request(model, choices, _command(Path(source).name, keywords, choices))


def _command(file: str, definitions: Mapping[str, object], choices: Choices) -> str:
    """Return the command that generates these files, without defaults and without folders."""
    words = ["eigenmotion", "generate", file]
    words += [f"-D {name}={value}" for name, value in sorted(definitions.items())]
    standard = asdict(STANDARD)
    chosen = {name: value for name, value in asdict(choices).items() if value != standard[name]}
    words += [f"--{name.replace('_', '-')} {value}" for name, value in chosen.items()]
    return " ".join(words)


@cache
def generator_hash() -> str:
    """Return a hash of the generator: its Python files, its templates, and the versions of SymPy and Jinja."""
    texts = [text for package in ("eigenmotion.codegen", "eigenmotion.templates") for text in _texts(files(package))]
    return key(version("sympy"), version("jinja2"), *texts)


def _texts(folder: Traversable) -> Iterator[bytes]:
    """Yield the content of each Python file and template of a package and its subpackages."""
    for file in sorted(folder.iterdir(), key=lambda file: file.name):
        if file.name.endswith((".py", ".jinja")):
            yield file.read_bytes()
        elif file.is_dir():
            yield from _texts(file)
