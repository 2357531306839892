"""Charts of a report: curves over the error, as numbers that pictures and pages draw alike."""

from collections.abc import Sequence
from dataclasses import dataclass

from ..examine import Findings
from ..measure import Measurement
from ..recommend import Curve
from ..solvers import OURS
from .choice import foremost, kind

_LEAST, _LARGEST = 1e-17, 10.0  # errors beyond are drawn at the margin


@dataclass(frozen=True, slots=True)
class Line:
    """A curve: kind, which decides its colour; label at its end; (error, height, measurement) from loose to tight."""

    kind: str
    method: str
    label: str
    points: tuple[tuple[float, float, Measurement], ...]

    @property
    def end(self) -> tuple[float, float]:
        """Error and height of the most accurate point, at which the label is."""
        return min(point[:2] for point in self.points)


@dataclass(frozen=True, slots=True)
class Chart:
    """Curves over the error.

    few : the curves drawn by default; every : all of them
    is_time : whether the heights are run times [s]; else they are counts
    requested : the requested error; own : the largest error of the reference
    recommended : the recommended measurement, or None
    """

    stem: str
    title: str
    text: str
    height: str
    is_time: bool
    few: tuple[Line, ...]
    every: tuple[Line, ...]
    requested: float
    own: float
    recommended: Measurement | None

    def lines(self, everything: bool) -> tuple[Line, ...]:
        """Return all curves, or the few."""
        return self.every if everything else self.few

    def limits(self, lines: Sequence[Line]) -> tuple[float, float, float, float]:
        """Return error at the left (largest) and at the right, lowest and greatest height, with a margin.

        The requested error is among them unless it is far from all measured ones.
        """
        errors = [error for line in lines for error, *_ in line.points] or [self.requested]
        heights = [height for line in lines for _, height, _ in line.points] or [1.0, 10.0]
        left, right = max(errors), min(errors)
        if right / 1e3 < self.requested < left * 1e3:
            left, right = max(left, 10 * self.requested), min(right, self.requested / 10)
        low, high = min(heights), max(heights)
        margin = max(1.25, (high / low) ** 0.03, (10 * low / high) ** 0.5)
        return 1.5 * left, right / 1.5, low / margin, high * margin


def charts(findings: Findings) -> tuple[Chart, ...]:
    """Return the charts of a model: run time against error, and steps against error."""
    return _times(findings), _steps(findings)


def _times(findings: Findings) -> Chart:
    few = foremost(findings.curves, findings.recommendation)
    every = [c for c in findings.curves if c.points]
    return _chart(
        findings, "time", "run time against error",
        "Lower is faster, further right is more accurate; each point is a tolerance. Vertical bars: quartiles of the "
        "repeats. Ring: the recommended run.",
        "run time of one call", [_line(c, c.label) for c in few], [_line(c, c.label) for c in every],
    )  # fmt: skip


def _steps(findings: Findings) -> Chart:
    ours = [c for c in findings.curves if c.family == OURS and any(p.nsteps for p in c.points)]
    best = findings.recommendation.chosen or findings.recommendation.closest
    explicit = [c.formulation for c in ours if not c.is_implicit]
    drawn = best.formulation if best and best.formulation in explicit else next(iter(explicit), "")
    few = [c for c in ours if c.formulation == drawn or c.is_implicit]
    return _chart(
        findings, "order", "steps against error",
        f"Each method with formulation {drawn or '-'}, the implicit ones once. p: the order seen, of an error "
        "that falls as steps⁻ᵖ, where there are enough points above rounding to fit it.",
        "accepted steps", [_line(c, _with_order(c, c.method, findings), True) for c in few],
        [_line(c, _with_order(c, c.label, findings), True) for c in ours],
    )  # fmt: skip


def _with_order(curve: Curve, name: str, findings: Findings) -> str:
    order = curve.order(findings.floor)
    return name if order is None else f"{name}, p = {order:.1f}"


def _line(curve: Curve, label: str, of_steps: bool = False) -> Line:
    """Return a curve with its heights; errors are kept within what a logarithm can show."""
    heights = [(p.nsteps if of_steps else p.seconds) or 0.0 for p in curve.points]
    errors = [min(max(error, _LEAST), _LARGEST) for error in curve.errors]
    points = [point for point in zip(errors, heights, curve.points, strict=True) if point[1] > 0]
    return Line(kind(curve), curve.method, label, tuple((e, float(h), p) for e, h, p in points))


def _chart(
    findings: Findings, name: str, title: str, text: str, height: str, few: Sequence[Line], every: Sequence[Line]
) -> Chart:
    return Chart(
        f"{findings.name}_{name}", title, text, height, name == "time",
        tuple(line for line in few if line.points), tuple(line for line in every if line.points),
        findings.options.error, max(float(findings.reference.errors.max()), _LEAST), findings.recommendation.chosen,
    )  # fmt: skip
