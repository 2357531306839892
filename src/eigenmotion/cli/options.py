"""Common arguments and options of the commands."""

import tempfile
from collections.abc import Callable, Collection, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from math import isfinite
from pathlib import Path
from typing import Any, TypeVar

import click

from eigenmotion.arguments.named_values import spelled
from eigenmotion.building.request import Request, request
from eigenmotion.codegen.choices import CLOSE_EIGENVALUES, FORMULATIONS, OF_TREES, SCHUR
from eigenmotion.codegen.model import Model
from eigenmotion.progress import Progress, bar

Command = TypeVar("Command", bound=Callable[..., Any])


class Finite(click.ParamType):  # type: ignore[type-arg]  # generic in newer versions of click only
    """A finite number: click's own type would accept infinity and NaN."""

    name = "number"

    def __init__(self, *, above_zero: bool = False) -> None:
        self._above_zero = above_zero

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        """Return the number, or fail with a usage error."""
        number = float(click.FLOAT.convert(value, param, ctx))
        if not isfinite(number):
            self.fail(f"{value!r} is not a finite number.", param, ctx)
        if self._above_zero and number <= 0:
            self.fail(f"{value!r} is not above 0.", param, ctx)
        return number


ABOVE_ZERO = Finite(above_zero=True)


Completion = Callable[[Path, Mapping[str, object]], Mapping[str, object]]
"""Function of a file and the arguments of -D that returns the arguments in full"""


@dataclass(frozen=True, slots=True)
class Shape:
    """The options of the generated code."""

    define: tuple[str, ...]
    formulation: str | None
    close_eigenvalues: str
    schur: str

    def request(self, model: Path, more: Completion | None = None) -> Request:
        """Return the request for the code of the model in a file; `more` may add to the arguments of -D."""
        given = assignments(self.define, "-D")
        return request(
            model,
            more(model, given) if more else given,
            formulation=self.formulation,
            close_eigenvalues=self.close_eigenvalues,
            schur=self.schur,
        )


def define(command: Command) -> Command:
    """Add -D."""
    option = click.option("-D", "define", multiple=True, metavar="NAME=VALUE",
                          help="Set an argument of the model's function, e.g. -D n=10.")  # fmt: skip
    return option(command)


def setting(command: Command) -> Command:
    """Add --set."""
    option = click.option("--set", "settings", multiple=True, metavar="NAME=VALUE",
                          help="Set a parameter, a constant input or an initial value: theta=0.5, "
                          "theta'=1 for a rate; or a quasi-velocity.")  # fmt: skip
    return option(command)


def ending(kind: Any) -> Callable[[Command], Command]:
    """Add --t-end, a number of some kind."""
    return click.option("--t-end", type=kind, default=10.0, show_default=True, metavar="T",
                        help="End time in seconds; runs start at 0.")  # fmt: skip


def shaping(command: Command) -> Command:
    """Add the options of `Shape`."""
    for option in (
        click.option("--schur", type=click.Choice(SCHUR), default="auto", show_default=True,
                     help="Factorisation of Delta, the matrix of the constraints."),
        click.option("--close-eigenvalues", type=click.Choice(CLOSE_EIGENVALUES), default="bounded",
                     show_default=True, help="Treatment of close eigenvalues of M: ours, or the paper's."),
        click.option("--formulation", type=click.Choice((*FORMULATIONS, *OF_TREES)), default=None,
                     help="The equations of motion to generate. By default articulated_body for masses in trees of "
                     "bodies, and eigenfactor for all others."),
        define,
    ):  # fmt: skip
        command = option(command)
    return command


def models(command: Command) -> Command:
    """Add the argument MODEL..."""
    path = click.Path(path_type=Path)
    return click.argument("models", metavar="MODEL...", nargs=-1, required=True, type=path)(command)


def model(command: Command) -> Command:
    """Add the argument MODEL."""
    return click.argument("model", metavar="MODEL", type=click.Path(path_type=Path))(command)


def folder(default: str, holds: str) -> Callable[[Command], Command]:
    """Add -o."""
    return click.option("-o", "--output", type=click.Path(path_type=Path, file_okay=False), default=Path(default),
                        show_default=True, help=f"Folder of the {holds}.")  # fmt: skip


output = folder("generated", "generated files")


def listed(text: str | None) -> tuple[str, ...] | None:
    """Return the names of a text, which commas separate; None without one."""
    return None if text is None else tuple(name.strip() for name in text.split(","))


@contextmanager
def bar_until_interrupted(name: str) -> Iterator[Progress]:
    """Show the progress of a task that writes its files at its end; Ctrl-C says how far it came."""
    reached = "before it began"

    def noted(done: float, what: str) -> None:
        nonlocal reached
        reached = f"at {100 * done:.0f} %, {what}"
        progress(done, what)

    with bar(name) as progress:
        try:
            yield noted
        except KeyboardInterrupt:
            raise KeyboardInterrupt(f"{reached}: nothing of {name} is written") from None


def assignments(texts: tuple[str, ...], option: str) -> dict[str, str]:
    """Return name -> value from NAME=VALUE texts; the last of several values of a name applies."""
    for text in texts:
        name, equals, value = text.partition("=")
        if not (name.strip() and equals and value.strip()):
            raise click.UsageError(f"{option} {text}: expected NAME=VALUE")
    return {name.strip(): value.strip() for name, _, value in (text.partition("=") for text in texts)}


def distinct_assignments(texts: tuple[str, ...], option: str) -> dict[str, str]:
    """Return name -> value from NAME=VALUE texts; each name may occur once.

    Raises
    ------
    UsageError
        A name is given twice.
    """
    names = [text.partition("=")[0].strip() for text in texts]
    if twice := [name for name in names if names.count(name) > 1]:
        raise click.UsageError(f"{option} {twice[0]} is given twice: give its values in one")
    return assignments(texts, option)


def values(model: Model, settings: tuple[str, ...], option: str = "--set") -> dict[str, dict[str, float]]:
    """Return the arguments parameters, inputs, x0 and v0 of `simulate` from --set NAME=VALUE texts.

    Raises
    ------
    UsageError
        The model does not have the name, or the value is not a number.
    """
    numbers_by_name = {name: _number(name, text, option) for name, text in assignments(settings, option).items()}
    positions = [spelled(key) for key in model.coordinates]
    rates = [f"{name}'" for name in positions]
    kinds = {
        "parameters": [spelled(key) for key, _ in model.parameters if spelled(key) not in model.prescribed],
        "inputs": [*(spelled(key) for key, _ in model.inputs), *model.prescribed],
        "x0": [*positions, *(spelled(z) for z, _ in model.states)],
        "v0": [*rates, *(spelled(y) for y, _ in model.quasi_velocities)],
    }
    known = [name for names in kinds.values() for name in names]
    if unknown := sorted(numbers_by_name.keys() - set(known)):
        raise click.UsageError(f"{option} {unknown[0]}: not known to {model.name}, which has {', '.join(known)}")
    if twice := [name for name in numbers_by_name if known.count(name) > 1]:
        raise click.UsageError(f"{option} {twice[0]}: of {model.name} two things have that name. Rename one of them")
    chosen = {
        kind: {
            name.removesuffix("'") if name in rates else name: numbers_by_name[name]
            for name in names
            if name in numbers_by_name
        }
        for kind, names in kinds.items()
    }
    return {kind: numbers for kind, numbers in chosen.items() if numbers}


def _number(name: str, text: str, option: str) -> float:
    try:
        return float(text)
    except ValueError as error:
        raise click.UsageError(f"{option} {name}={text}: {text} is not a number") from error


def check_writable(folder: Path, option: str) -> None:
    """Check before the work that files can be written into a folder, which exists or can be created.

    Raises
    ------
    UsageError
        Files cannot be written; the message names the option and the reason.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            pass
    except OSError as error:
        raise click.UsageError(f"{option} {folder}: nothing can be written there ({error.strerror})") from error


def check_file(file: Path, option: str) -> None:
    """Check before the work that a file can be written into an existing folder.

    Raises
    ------
    UsageError
        The file cannot be written; the message names the option and the reason.
    """
    if not file.absolute().parent.is_dir():
        raise click.UsageError(f"{option} {file}: there is no folder {file.parent}")
    check_writable(file.absolute().parent, option)


def check_targets(*targets: tuple[str, Path | None, Collection[str]]) -> None:
    """Check the files that options name, and their endings.

    Raises
    ------
    UsageError
        As `check_file`; or an ending is unknown.
    """
    for option, file, endings in targets:
        if file is None:
            continue
        if file.suffix not in endings:
            raise click.UsageError(f"{option} {file}: known endings are {', '.join(endings)}")
        check_file(file, option)


def distinct(requests: list[Request]) -> list[Request]:
    """Return the requests; raise UsageError for two models of the same name, whose files would have the same names."""
    names = [request.model.name for request in requests]
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise click.UsageError(f"more than one model is named {', '.join(twice)}; generate them to different folders")
    return requests
