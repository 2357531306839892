"""The HTML page: one file, which opens without a network."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from importlib.resources import files

from jinja2 import Environment, StrictUndefined
from markupsafe import Markup

from ..pages.machine import machine
from ..report.curves import Picture
from ..report.words import number
from .case import Case
from .matrix import Matrix
from .outcome import RULES, Cell
from .reference import DIRECTIONS
from .words import reasons, summary

Row = tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Table:
    """Texts, row by row, behind a title."""

    title: str
    head: Row
    rows: tuple[Row, ...]


@dataclass(frozen=True, slots=True)
class Section:
    """One case on the page."""

    name: str
    title: str
    pictures: tuple[tuple[str, Markup], ...]
    tables: tuple[Table, ...]


def page(matrix: Matrix, drawn: Sequence[Picture]) -> str:
    """Render the page."""
    text = files(__package__).joinpath("page.html.jinja").read_text(encoding="utf-8")
    environment = Environment(autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True)
    sections = [Section("", drawn[0].title, _shown(drawn[:1]), ())] + [_section(matrix, c, drawn) for c in matrix.cases]
    return environment.from_string(text).render(
        summary=summary(matrix), rules=[(str(o), rule) for o, rule in RULES.items()], sections=sections,
        machine=tuple(machine().items()), directions=DIRECTIONS,
    )  # fmt: skip


def _section(matrix: Matrix, case: Case, drawn: Sequence[Picture]) -> Section:
    own = [p for p in drawn if p.stem in (f"stability_{case.name}", f"stability_{case.name}_drift")]
    tables = (_references(matrix, case), _reasons(matrix, case), _cells(matrix, case))
    return Section(case.name, case.title, _shown(own), tables)


def _shown(drawn: Iterable[Picture]) -> tuple[tuple[str, Markup], ...]:
    return tuple((p.text, Markup(p.svg)) for p in drawn)


def _references(matrix: Matrix, case: Case) -> Table:
    rows = [(p.point, number(p.kappa), number(p.reference_error), p.how) for p in matrix.of(case)]
    return Table("References", (case.axis or "start", "kappa", "error of the reference", "reference"), tuple(rows))


def _reasons(matrix: Matrix, case: Case) -> Table:
    return Table("Reasons given", ("reason", "runs"), tuple((name, str(n)) for name, n in reasons(matrix, case)))


def _cells(matrix: Matrix, case: Case) -> Table:
    head = (
        "formulation", case.axis or "start", "method", "tolerance", "outcome", "error", "bound", "energy drift",
        f"a {_per(matrix, case)}", "|A v + b|", "|phi|", f"a {_per(matrix, case)}", "factor residual", "steps",
        "seconds", "message",
    )  # fmt: skip
    cells = [cell for point in matrix.of(case) for cell in point.cells]
    return Table(f"{len(cells)} runs", head, tuple(map(_cell, cells)))


def _per(matrix: Matrix, case: Case) -> str:
    """What slopes are told by: a period where there are many, else the whole span."""
    return "period" if any(point.periods for point in matrix.of(case)) else "span"


def _cell(c: Cell) -> Row:
    i = c.shown
    return (
        c.variant, c.point, c.method, f"{c.tolerance:g}", str(c.outcome), number(c.error), number(c.bound),
        *map(number, (i.energy, i.energy_slope, i.constraint, i.position, i.position_slope, i.factor)),
        "-" if c.nsteps is None else str(c.nsteps), f"{c.seconds:.2f}", c.message[:160],
    )  # fmt: skip
