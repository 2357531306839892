"""Page of the stability matrix."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ...presentation.figures import Picture
from ...presentation.page import render
from ...presentation.tables import Row, Table
from ...presentation.text import number
from ..cases.case import Case
from ..evaluation.expected_rows import DIRECTIONS
from ..evaluation.matrix import Matrix
from ..evaluation.outcome import RULES, Cell
from .text import reasons, summary


@dataclass(frozen=True, slots=True)
class CaseSection:
    """The section of one case, or of all cases; tables are (title, table)."""

    name: str
    title: str
    pictures: tuple[Picture, ...]
    tables: tuple[tuple[str, Table], ...]


def page(
    matrix: Matrix,
    drawn: Mapping[str, tuple[Picture, ...]],
    machine: Mapping[str, str],
    heading: str = "stiff and extreme cases",
    lines: Sequence[str] | None = None,
) -> str:
    """Render the page; `drawn` are the pictures of `pictures`; cases without any have tables only."""
    sections = [
        CaseSection("", drawn[""][0].title, drawn[""], ()),
        *(_section(matrix, c, drawn.get(c.name, ())) for c in matrix.cases),
    ]
    rules = [(str(outcome), rule) for outcome, rule in RULES.items()]
    return render(
        __package__, summary=summary(matrix) if lines is None else lines, rules=rules, sections=sections,
        machine=machine, directions=DIRECTIONS, heading=heading,
    )  # fmt: skip


def _section(matrix: Matrix, case: Case, drawn: tuple[Picture, ...]) -> CaseSection:
    tables = (_references(matrix, case), _reasons(matrix, case), _cells(matrix, case))
    return CaseSection(case.name, case.title, drawn, tables)


def _references(matrix: Matrix, case: Case) -> tuple[str, Table]:
    rows = [(p.point, number(p.kappa), number(p.reference_error), p.how) for p in matrix.of(case)]
    return "References", Table((case.axis or "start", "kappa", "error of the reference", "reference"), tuple(rows))


def _reasons(matrix: Matrix, case: Case) -> tuple[str, Table]:
    rows = [(name, str(n)) for name, n in reasons(matrix, case)]
    return "Reasons given", Table(("reason", "runs"), tuple(rows))


def _cells(matrix: Matrix, case: Case) -> tuple[str, Table]:
    per = "a period" if matrix.has_periods(case) else "a span"  # unit of slopes
    head = (
        "formulation", case.axis or "start", "method", "tolerance", "outcome", "error", "bound", "energy drift",
        per, "|A v + b|", "|phi|", per, "factor residual", "steps", "seconds", "message",
    )  # fmt: skip
    cells = [cell for point in matrix.of(case) for cell in point.cells]
    return f"{len(cells)} runs", Table(head, tuple(map(_cell, cells)))


def _cell(c: Cell) -> Row:
    i = c.shown
    return (
        c.variant, c.point, c.method, f"{c.tolerance:g}", str(c.outcome), number(c.error), number(c.bound),
        *map(number, (i.energy, i.energy_slope, i.constraint, i.position, i.position_slope, i.factor)),
        "-" if c.nsteps is None else str(c.nsteps), f"{c.seconds:.2f}", c.message[:160],
    )  # fmt: skip
