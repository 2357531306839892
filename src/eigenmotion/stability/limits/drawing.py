"""Pictures of the limits of a model."""

from collections.abc import Sequence

from ...presentation.figures import Picture, picture
from ..cases.case import Case
from ..evaluation.matrix import Matrix
from ..evaluation.outcome import Outcome
from ..output.drawing import canvas, detail, frame, legend, tile, worst
from .findings import Combination
from .survey import Limits

_MOST = 12
"""Pictures of single cases: those with the worst outcomes"""
_WIDTH = 24
"""Cases in a column each of the overview; of more, those with the worst outcomes"""
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
    """Draw each formulation and method (rows) in each case (columns): the worst outcome, right runs / all runs."""
    matrix = found.matrix
    chosen = _by_outcome(matrix, matrix.cases, Outcome.RIGHT)[:_WIDTH]
    cases = [case for case in matrix.cases if case in chosen]
    rows: list[Combination] = list(dict.fromkeys((c.variant, c.method) for c in matrix.cells))
    rows.sort(key=lambda pair: found.own.formulations.index(pair[0]))
    figure, axes = canvas(2.6 + 0.78 * max(len(cases), 5), 2.0 + 0.26 * len(rows))
    for column, case in enumerate(cases):
        for row, pair in enumerate(rows):
            cells = [c for point in matrix.of(case) for c in point.cells if (c.variant, c.method) == pair]
            if cells:
                right = sum(c.outcome in (Outcome.RIGHT, Outcome.AGREES) for c in cells)
                tile(axes, column, row, worst(cells), f"{right}/{len(cells)}")
    frame(axes, [_short(case) for case in cases], [f"{variant}, {method}" for variant, method in rows])
    for k in range(1, len(rows)):
        if rows[k][0] != rows[k - 1][0]:
            axes.axhline(k - 0.5, color="0.2", linewidth=1.2)
    axes.set_title(f"{found.own.model.name}: worst outcome; right or agreeing runs / all runs", fontsize=10)
    legend(figure, matrix.cells)
    left = len(matrix.cases) - len(cases)
    text = "Rows: formulations and methods. Columns: cases, and parameters times 1e-6 to 1e6."
    return picture(figure, "stability", found.own.model.name, text + (f" Without {left} cases." if left else ""))


def _short(case: Case) -> str:
    """Return a title for a narrow column."""
    words = {"tolerances": "tole-\nrances", "spans": "spans", "singular_mass_matrix": "near\nsingular\nM",
             "singular_constraints": "near\ndependent\nrows"}  # fmt: skip
    return words.get(case.name, case.title.removeprefix("Parameter "))
