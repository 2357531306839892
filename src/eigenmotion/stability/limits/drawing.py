"""Pictures of the limits of a model."""

from collections.abc import Sequence

from ...presentation.figures import Picture, picture
from ..cases.case import Case
from ..evaluation.matrix import Matrix
from ..evaluation.outcome import JUDGED_RIGHT, Cell, Outcome
from ..output.drawing import TYPE, below, canvas, detail, frame, legend, tile, worst, wrapped
from ..output.groups import alike, named
from .survey import Limits

_MOST = 12
"""Pictures of single cases: those with the worst outcomes"""
_MOST_ROWS = 24
"""Rows of the overview"""
_ORDER = list(Outcome)


def pictures_of(found: Limits) -> dict[str, tuple[Picture, ...]]:
    """Return case name -> pictures, of cases in which not every run is right; "" -> the overview."""
    shown = _by_outcome(found.matrix, found.matrix.cases, Outcome.NO_DIGITS)[:_MOST]
    drawn: dict[str, tuple[Picture, ...]] = {case.name: (detail(found.matrix, case),) for case in shown}
    return {"": (overview(found),)} | drawn


def _by_outcome(matrix: Matrix, cases: Sequence[Case], least: Outcome) -> list[Case]:
    """Return cases with at least this outcome, the worst first, otherwise in their order."""
    outcomes = {case.name: _worst(matrix, case) for case in cases}
    chosen = [case for case in cases if outcomes[case.name] >= _ORDER.index(least)]
    return sorted(chosen, key=lambda case: -outcomes[case.name])


def _worst(matrix: Matrix, case: Case) -> int:
    return max((_ORDER.index(c.outcome) for point in matrix.of(case) for c in point.cells), default=0)


def overview(found: Limits) -> Picture:
    """Draw each case in which not every run is right or agrees (rows), by method (columns): the worst outcome.

    Formulations that fare alike share a row. The other cases are listed below.
    """
    matrix = found.matrix
    shown = _by_outcome(matrix, matrix.cases, Outcome.NO_DIGITS)
    methods = list(dict.fromkeys(cell.method for cell in matrix.cells))
    rows = [row for case in matrix.cases if case in shown for row in _rows(matrix, case)]
    left = len(rows) - _MOST_ROWS
    figure, axes = canvas(2.2 + 0.34 * max(min(len(rows), _MOST_ROWS), 1))
    for k, (_, cells) in enumerate(rows[:_MOST_ROWS]):
        for column, method in enumerate(methods):
            own = [cell for cell in cells if cell.method == method]
            if own:
                tile(axes, column, k, worst(own), f"{sum(c.outcome in JUDGED_RIGHT for c in own)}/{len(own)}")
    frame(axes, methods if rows else [], [wrapped(name) for name, _ in rows[:_MOST_ROWS]])
    words = "worst outcome; runs that are right or agree / all runs" if rows else "every run is right or agrees"
    axes.set_title(f"{found.own.model.name}: {words}", fontsize=TYPE)
    below(figure, [(_short(case), matrix.of(case)) for case in matrix.cases if case not in shown])
    legend(figure, matrix.cells)
    text = "Rows: cases, and parameters times 1e-6 to 1e6, in which not every run is right or agrees. Columns: methods."
    return picture(figure, "stability", found.own.model.name, text + (f" Without {left} rows." if left > 0 else ""))


def _rows(matrix: Matrix, case: Case) -> list[tuple[str, list[Cell]]]:
    """Return the rows of a case: label, cells."""
    cells = [cell for point in matrix.of(case) for cell in point.cells]
    every = list(dict.fromkeys(cell.variant for cell in cells))
    rows = []
    for group in alike(cells, lambda cell: cell.outcome):
        name = named(group, every)
        label = f"{_short(case)}: {name}" if name else _short(case)
        rows.append((label, [cell for cell in cells if cell.variant in group]))
    return rows


def _short(case: Case) -> str:
    """Return a title for a row."""
    return {"singular_mass_matrix": "near singular M", "singular_constraints": "near dependent rows"}.get(
        case.name, case.title.removeprefix("Parameter ")
    )
