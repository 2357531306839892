"""Charts of a page: SVG whose numbers are computed here and printed by chart.svg.jinja, wide and narrow."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from ....presentation.figures import spread_labels
from ....presentation.text import number, seconds
from ...measure import Measurement
from ..chart import Chart, Line
from ..looks import INKS, dashes
from ..text import spread
from ..ticks import height_in_words, heights_to_label, powers_of_ten

_LETTER = 0.56  # mean width of a letter, in heights of the type
_ROW = 1.25  # distance of labels, in heights of the type


@dataclass(frozen=True, slots=True)
class Layout:
    """Sizes of a chart in pixels of the page; margins are around the axes, the right one for labels without letters."""

    name: str
    width: int
    height: int
    type: int
    left: int
    top: int = 46
    bottom: int = 44


WIDE, NARROW = Layout("wide", 720, 450, 13, 62), Layout("narrow", 360, 420, 12, 54)


@dataclass(frozen=True, slots=True)
class DrawnPoint:
    """A point at (x, y); `bar` from the upper to the lower quartile; `run`, the number of its run; its mark."""

    x: float
    y: float
    bar: tuple[float, float] | None
    run: int
    is_recommended: bool


@dataclass(frozen=True, slots=True)
class DrawnLine:
    """A curve: index of its colour, dashes, points; label, its place, and the leader that leads there."""

    colour: int
    dashes: str
    points: tuple[DrawnPoint, ...]
    label: str
    label_x: float
    label_y: float
    leader: str

    @property
    def path(self) -> str:
        """The points of the polyline."""
        return " ".join(f"{p.x},{p.y}" for p in self.points)


@dataclass(frozen=True, slots=True)
class Drawn:
    """A chart as it is printed: sizes, ticks (place, text), curves; band, the errors below the reference's own."""

    layout: Layout
    title: str
    everything: bool
    height: int
    right: float
    floor: float
    requested: float | None
    caption_x: float
    band: float
    caption: str
    y_title: str
    x_ticks: tuple[tuple[float, str], ...]
    y_ticks: tuple[tuple[float, str], ...]
    lines: tuple[DrawnLine, ...]


@dataclass(frozen=True, slots=True)
class _Scale:
    """Logarithmic axes of a chart: errors from left to right, heights from the floor up."""

    limits: tuple[float, float, float, float]
    box: tuple[float, float, float, float]  # left, right, top, floor

    def x(self, error: float) -> float:
        first, last, *_ = self.limits
        left, right, *_ = self.box
        part = math.log(first / error) / math.log(first / last)
        return round(left + min(max(part, 0.0), 1.0) * (right - left), 1)

    def y(self, height: float) -> float:
        *_, low, high = self.limits
        *_, top, floor = self.box
        part = math.log(height / low) / math.log(high / low)
        return round(floor - min(max(part, 0.0), 1.0) * (floor - top), 1)


def drawn(chart: Chart, runs: dict[int, int], layout: Layout, everything: bool) -> Drawn:
    """Return a chart as it is printed; `runs` are the numbers of measurements on the page, by identity."""
    lines = chart.lines(everything)
    row, letters = _ROW * layout.type, max((len(line.label) for line in lines), default=0)
    height = max(layout.height, math.ceil(layout.top + layout.bottom + row * (len(lines) + 1)))
    right = round(layout.width - _LETTER * layout.type * letters - 24, 1)
    scale = _Scale(chart.limits(lines), (layout.left, right, layout.top, height - layout.bottom))
    first, last, low, high = scale.limits
    caption = f"requested: {chart.requested:g}"
    requested = scale.x(chart.requested) if last <= chart.requested <= first else None
    half = _LETTER * layout.type * len(caption) / 2
    caption_x = round(min(max(requested or 0.0, layout.left + half), right - half), 1)
    most = (right - layout.left) / (4.2 * layout.type)
    return Drawn(
        layout, chart.title, everything, height, right, height - layout.bottom, requested, caption_x,
        scale.x(max(chart.own, last)), caption, chart.height,
        tuple((scale.x(e), f"{e:.0e}") for e in powers_of_ten(last, first, most)),
        tuple((scale.y(h), height_in_words(h, chart.is_time)) for h in heights_to_label(low, high)),
        _lines(chart, lines, scale, layout, runs),
    )  # fmt: skip


def _lines(
    chart: Chart, lines: Sequence[Line], scale: _Scale, layout: Layout, runs: dict[int, int]
) -> tuple[DrawnLine, ...]:
    """Return curves with labels at their ends, moved apart as far as necessary."""
    if not lines:
        return ()
    _, right, top, floor = scale.box
    ends = [(scale.x(error), scale.y(height)) for error, height in (line.end for line in lines)]
    gap = _ROW * layout.type / (floor - top)
    places = top + (floor - top) * spread_labels([(y - top) / (floor - top) for _, y in ends], gap)
    kinds = list(INKS)
    return tuple(
        DrawnLine(
            kinds.index(line.kind) if line.kind in INKS else len(kinds) - 1,
            " ".join(str(1.6 * part) for part in dashes(line.method)),
            tuple(_point(chart, point, scale, runs) for point in line.points),
            line.label, right + 20, round(float(place), 1), f"{x},{y} {right + 4},{place:.1f} {right + 16},{place:.1f}",
        )
        for line, (x, y), place in zip(lines, ends, places, strict=True)
    )  # fmt: skip


def _point(chart: Chart, point: tuple[float, float, Measurement], scale: _Scale, runs: dict[int, int]) -> DrawnPoint:
    error, height, m = point
    bar = None
    if chart.is_time and m.seconds_low and m.seconds_high:
        bar = (scale.y(m.seconds_high), scale.y(m.seconds_low))
    return DrawnPoint(scale.x(error), scale.y(height), bar, runs[id(m)], m == chart.recommended)


def run_in_words(m: Measurement) -> dict[str, str]:
    """Return the numbers of one run, as a page shows them: name -> text.

    Examples
    --------
    >>> run_in_words(Measurement("SciPy", "lambdified", "Radau", "SciPy Radau", 1e-6))["tolerance"]
    '1e-06'
    """
    rejected = "" if m.nrejected is None else f", {m.nrejected:,} rejected"
    return {
        "label": m.label, "method": m.method, "formulation": m.formulation, "tolerance": number(m.tolerance),
        "largest error": number(m.error_max), "error at the end": number(m.error_end),
        "run time": seconds(m.seconds), "quartiles": spread(m),
        "steps": "-" if m.nsteps is None else f"{m.nsteps:,}{rejected}",
        "right-hand sides": "-" if m.nfev is None else f"{m.nfev:,}",
    }  # fmt: skip
