"""Pictures of the matrix; each outcome has a pattern as well as a colour."""

from collections.abc import Iterable, Sequence
from typing import Any

from ...presentation.figures import BLACK, FORMULATIONS, ORANGE, Picture, blank, picture, uncluttered
from ..cases.case import Case
from ..evaluation.examine import PointResult
from ..evaluation.matrix import Matrix
from ..evaluation.outcome import OF_OWN_MODELS, Cell, Outcome
from .text import LETTERS, mark

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
    """Draw each case and variant: the worst outcome, and the number of right runs."""
    cases = matrix.cases
    columns = list(dict.fromkeys(cell.variant for cell in matrix.cells))
    figure, axes = canvas(3.4 + 1.15 * len(columns), 1.9 + 0.36 * len(cases))
    for row, case in enumerate(cases):
        for column, variant in enumerate(columns):
            cells = [c for point in matrix.of(case) for c in point.cells if c.variant == variant]
            if cells:
                right = sum(c.outcome is Outcome.RIGHT for c in cells)
                tile(axes, column, row, worst(cells), f"{right}/{len(cells)}")
    frame(axes, [c.replace(", ", ",\n").replace("schur ", "schur\n") for c in columns], [c.title for c in cases])
    axes.set_title("worst outcome of all methods and values; numbers: right runs / all runs", fontsize=10)
    legend(figure, matrix.cells)
    return picture(figure, "stability", "All cases", "Rows: cases. Columns: formulations and options.")


def detail(matrix: Matrix, case: Case) -> Picture:
    """Draw each run of a case: columns are values, rows are methods and variants."""
    points = matrix.of(case)
    rows = list(dict.fromkeys((c.method, c.variant) for point in points for c in point.cells))
    figure, axes = canvas(4.6 + 0.62 * max(len(points), 6), 2.0 + 0.24 * len(rows))
    for column, point in enumerate(points):
        for cell in point.cells:
            tile(axes, column, rows.index((cell.method, cell.variant)), cell.outcome, mark(cell))
    frame(axes, [point.point for point in points], [f"{variant}, {method}" for method, variant in rows])
    for k in range(1, len(rows)):
        if rows[k][0] != rows[k - 1][0]:
            axes.axhline(k - 0.5, color="0.2", linewidth=1.2)
    axes.set_xlabel(case.axis)
    axes.set_title(case.title, fontsize=11)
    legend(figure, [cell for point in points for cell in point.cells])
    return picture(figure, f"stability_{case.name}", case.title, f"{case.about} {_key(points)}")


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
    return "Numbers: power of ten of the error." + (f" Refused, {letters}." if letters else "")


def canvas(width: float, height: float) -> tuple[Any, Any]:
    """Return a figure and its axes."""
    figure = blank(width, height)
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
    shown = axes.text(column, row, text, ha="center", va="center", fontsize=8, color=_INK[outcome], bbox=behind)
    shown.set_in_layout(False)


def frame(axes: Any, columns: Sequence[str], rows: Sequence[str]) -> None:
    """Name columns and rows."""
    axes.set_xlim(-0.5, len(columns) - 0.5)
    axes.set_ylim(len(rows) - 0.5, -0.5)
    axes.set_xticks(range(len(columns)), columns, fontsize=8)
    axes.set_yticks(range(len(rows)), rows, fontsize=8)
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
    figure.legend(handles=handles, loc="outside lower center", ncols=len(handles), frameon=False, fontsize=9)


def worst(cells: Sequence[Cell]) -> Outcome:
    """Return the worst outcome of some cells."""
    return max((cell.outcome for cell in cells), key=_ORDER.index)
