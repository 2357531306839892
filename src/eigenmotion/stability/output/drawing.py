"""Pictures of the matrix; each outcome has a pattern as well as a colour."""

from collections.abc import Iterable, Sequence
from textwrap import fill
from typing import Any

from ...presentation.figures import BLACK, FORMULATIONS, ORANGE, Picture, blank, picture, uncluttered
from ..cases.case import Case
from ..evaluation.examine import PointResult
from ..evaluation.matrix import Matrix
from ..evaluation.outcome import JUDGED_RIGHT, OF_OWN_MODELS, Cell, Outcome
from .groups import Row, alike, named
from .text import LETTERS, mark

WIDTH, TYPE = 7.2, 9
"""Width [inch] and type [pt]: at 700 pixels, which are 7.3 inches of a page, type has its size."""
_LABEL, _LINE = 34, 104  # letters of a label, and of a line across a picture
_FACE = {
    Outcome.RIGHT: "#9BD3C0", Outcome.AGREES: "#CFE8F5", Outcome.NO_DIGITS: "#E6DFF2", Outcome.REFUSED: "#E4E4E4",
    Outcome.DEGRADED: "#F0C35E", Outcome.DIFFERS: "#CC79A7", Outcome.WRONG: "#D55E00",
}  # fmt: skip
_INK = {
    Outcome.RIGHT: "#0B3B2E", Outcome.AGREES: "#10405A", Outcome.NO_DIGITS: "#3D2F5C", Outcome.REFUSED: "#444444",
    Outcome.DEGRADED: "#3A2A00", Outcome.DIFFERS: "#2E0018", Outcome.WRONG: "#FFFFFF",
}  # fmt: skip
_HATCH = {
    Outcome.RIGHT: "", Outcome.AGREES: "", Outcome.NO_DIGITS: "--", Outcome.REFUSED: "////", Outcome.DEGRADED: "....",
    Outcome.DIFFERS: "++", Outcome.WRONG: "xx",
}  # fmt: skip
_ORDER = list(Outcome)
_DRIFT_LOOKS = {
    **dict(zip(FORMULATIONS, zip(FORMULATIONS.values(), ("-", "--", "-.", ":"), strict=True), strict=True)),
    "eigenfactor, not stabilised": (BLACK, "-"),
    "lagrange, not stabilised": (ORANGE, "--"),
}


def pictures(matrix: Matrix) -> dict[str, tuple[Picture, ...]]:
    """Return case name -> pictures, with the drift if there are many periods; "" -> the overview of all cases."""
    return {"": (overview(matrix),)} | {case.name: _pictures(matrix, case) for case in matrix.cases}


def _pictures(matrix: Matrix, case: Case) -> tuple[Picture, ...]:
    return (detail(matrix, case), *([drift(matrix, case)] if matrix.has_periods(case) else []))


def overview(matrix: Matrix) -> Picture:
    """Draw each case in which not every run is right, and each variant: the worst outcome, and how many runs are not.

    The other cases are listed below.
    """
    cases = [case for case in matrix.cases if not _all_right(matrix, case)]
    columns = list(dict.fromkeys(c.variant for case in cases for point in matrix.of(case) for c in point.cells))
    figure, axes = canvas(2.6 + 0.3 * len(cases))
    for row, case in enumerate(cases):
        for column, variant in enumerate(columns):
            cells = [c for point in matrix.of(case) for c in point.cells if c.variant == variant]
            if cells:
                missing = sum(c.outcome is not Outcome.RIGHT for c in cells)
                tile(axes, column, row, worst(cells), f"{missing}" if missing else "")
    frame(axes, columns, [wrapped(case.title) for case in cases], slanted=True)
    axes.set_title("worst outcome; number of runs that are not right" if cases else "", fontsize=TYPE)
    below(figure, [(case.title, matrix.of(case)) for case in matrix.cases if case not in cases])
    legend(figure, matrix.cells)
    text = "Rows: cases in which not every run is right. Columns: formulations and options."
    return picture(figure, "stability", "All cases", text)


def _all_right(matrix: Matrix, case: Case) -> bool:
    return all(c.outcome in JUDGED_RIGHT for point in matrix.of(case) for c in point.cells)


def below(figure: Any, cases: Sequence[tuple[str, Sequence[PointResult]]]) -> None:
    """List the cases that have no row, by title and points, and their numbers of runs, below a picture."""
    if cases:
        names = [f"{title} ({sum(len(point.cells) for point in points)})" for title, points in cases]
        text = fill(f"Every run is right or agrees (number of runs): {', '.join(names)}.", _LINE)
        figure.supxlabel(text, x=0.01, ha="left", fontsize=TYPE)


def detail(matrix: Matrix, case: Case) -> Picture:
    """Draw each run of a case: columns are values, rows are methods and the variants that fare alike."""
    points = matrix.of(case)
    rows = _rows(points)
    figure, axes = canvas(2.0 + 0.27 * len(rows))
    for column, point in enumerate(points):
        for row, (method, group) in enumerate(rows):
            cells = [cell for cell in point.cells if cell.method == method and cell.variant in group]
            if cells:
                shown = max(cells, key=lambda cell: cell.error or 0.0)
                tile(axes, column, row, shown.outcome, mark(shown))
    every = list(dict.fromkeys(cell.variant for point in points for cell in point.cells))
    names = [named(group, every) for _, group in rows]
    labels = [f"{method}: {name}" if name else method for (method, _), name in zip(rows, names, strict=True)]
    frame(axes, [point.point for point in points], list(map(wrapped, labels)))
    for k in range(1, len(rows)):
        if rows[k][0] != rows[k - 1][0]:
            axes.axhline(k - 0.5, color="0.2", linewidth=1.0)
    axes.set_xlabel(case.axis, fontsize=TYPE)
    axes.set_title(case.title, fontsize=TYPE + 1)
    legend(figure, [cell for point in points for cell in point.cells])
    text = f"{case.about} Formulations and options with the same outcomes share a row. {_key(points)}"
    return picture(figure, f"stability_{case.name}", case.title, text)


def _rows(points: Sequence[PointResult]) -> list[Row]:
    cells = [cell for point in points for cell in point.cells]
    methods = dict.fromkeys(cell.method for cell in cells)
    return [
        (method, group)
        for method in methods
        for group in alike((c for c in cells if c.method == method), lambda c: (c.outcome, c.reason))
    ]


def drift(matrix: Matrix, case: Case) -> Picture:
    """Draw the drift of a case with many periods against their number, one panel for each method."""
    figure = blank(3.6 * len(case.tolerances), 4.6)
    panels = figure.subplots(1, len(case.tolerances), sharey=True, squeeze=False)[0]
    for axes, (method, tolerance) in zip(panels, case.tolerances.items(), strict=True):
        for variant, look in _DRIFT_LOOKS.items():
            cells = [c for point in matrix.of(case) for c in point.cells if (c.method, c.variant) == (method, variant)]
            _draw_drift(axes, cells, variant, *look)
        axes.set(xlabel="periods", title=f"{method}, tolerance {tolerance:g}")
        uncluttered(axes, linewidth=0.7)
    panels[0].set_ylabel("circles: relative drift of the energy\ntriangles: error of x and v")
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=3, frameon=False)
    text = f"{case.about} Circles: largest relative drift of the energy; triangles: largest error."
    return picture(figure, f"stability_{case.name}_drift", f"{case.title}: drift", text)


def _draw_drift(axes: Any, cells: Sequence[Cell], label: str, colour: str, style: str) -> None:
    """Draw one variant: energy drift with filled markers, error with hollow markers and thinner lines."""
    points = [(float(c.point), c.shown.energy, c.error) for c in cells if c.shown.energy and c.error]
    if points:
        periods, energies, errors = zip(*points, strict=True)
        axes.loglog(periods, energies, style, color=colour, marker="o", markersize=4, label=label)
        hollow = {"marker": "^", "markersize": 5, "markerfacecolor": "white", "linewidth": 0.8}
        axes.loglog(periods, errors, style, color=colour, **hollow)


def _key(points: Sequence[PointResult]) -> str:
    """Return an explanation of the marks in a picture."""
    used = {cell.reason for point in points for cell in point.cells if cell.error is None}
    letters = ", ".join(f"{letter}: {reason}" for reason, letter in LETTERS.items() if reason in used)
    return "Numbers: power of ten of the largest error." + (f" Refused, {letters}." if letters else "")


def canvas(height: float) -> tuple[Any, Any]:
    """Return a figure of the common width, and its axes."""
    figure = blank(WIDTH, height)
    figure.get_layout_engine().set(w_pad=0.1, h_pad=0.1)
    return figure, figure.add_subplot()


def tile(axes: Any, column: float, row: float, outcome: Outcome, text: str) -> None:
    """Draw one outcome with a text."""
    from matplotlib.patches import Rectangle  # noqa: PLC0415, an optional package

    corner = column - 0.47, row - 0.44
    axes.add_patch(Rectangle(corner, 0.94, 0.88, facecolor=_FACE[outcome], linewidth=0.0))
    if hatch := _HATCH[outcome]:
        axes.add_patch(Rectangle(corner, 0.94, 0.88, fill=False, hatch=hatch, edgecolor="#FFFFFF", linewidth=0.0))
    behind = {"facecolor": _FACE[outcome], "linewidth": 0.0, "pad": 1.0} if hatch and text else None
    shown = axes.text(column, row, text, ha="center", va="center", fontsize=TYPE, color=_INK[outcome], bbox=behind)
    shown.set_in_layout(False)


def wrapped(label: str) -> str:
    """Return a label of a row in lines that leave room for the columns."""
    return fill(label, _LABEL)


def frame(axes: Any, columns: Sequence[str], rows: Sequence[str], slanted: bool = False) -> None:
    """Name columns and rows."""
    axes.set_xlim(-0.5, max(len(columns), 1) - 0.5)
    axes.set_ylim(max(len(rows), 1) - 0.5, -0.5)
    turn = {"rotation": 40, "ha": "right", "rotation_mode": "anchor"} if slanted else {}
    axes.set_xticks(range(len(columns)), columns, fontsize=TYPE, **turn)
    axes.set_yticks(range(len(rows)), rows, fontsize=TYPE, linespacing=0.95)
    axes.tick_params(length=0)
    axes.spines[:].set_visible(False)


def legend(figure: Any, cells: Iterable[Cell]) -> None:
    """Name the outcomes; those of users' models only if they occur."""
    from matplotlib.patches import Patch  # noqa: PLC0415, an optional package

    present = {cell.outcome for cell in cells}
    handles = [
        Patch(facecolor=_FACE[o], hatch=_HATCH[o], edgecolor="#FFFFFF", linewidth=0.0, label=str(o))
        for o in Outcome
        if o in present or o not in OF_OWN_MODELS
    ]
    figure.legend(
        handles=handles, loc="outside upper center", ncols=len(handles), frameon=False, fontsize=TYPE, columnspacing=1.2
    )


def worst(cells: Sequence[Cell]) -> Outcome:
    """Return the worst outcome of some cells."""
    return max((cell.outcome for cell in cells), key=_ORDER.index)
