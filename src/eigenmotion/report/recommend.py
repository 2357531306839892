"""Recommendation of a method and tolerance from measurements, and properties of measured curves."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from .measure import Measurement
from .solvers import IMPLICIT, OURS

LEVELS = (1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-12)


@dataclass(frozen=True, slots=True)
class Curve:
    """The complete measurements of one solver, from loose to tight."""

    family: str
    formulation: str
    method: str
    label: str
    points: tuple[Measurement, ...]

    @property
    def is_implicit(self) -> bool:
        """Whether it is one of our implicit methods."""
        return self.family == OURS and self.method in IMPLICIT

    @property
    def group(self) -> str:
        """The group for comparisons: the formulation for our explicit methods, the label for all others."""
        return self.formulation if self.family == OURS and not self.is_implicit else self.label

    @property
    def errors(self) -> list[float]:
        """(k,) largest errors over all rows."""
        return [point.error_max or 0.0 for point in self.points]

    @property
    def seconds(self) -> list[float]:
        """(k,) medians [s]."""
        return [point.seconds or np.nan for point in self.points]

    def reaching(self, error: float) -> list[Measurement]:
        """Return the points that reach `error`, and whose next tighter point reaches it too, so that it is not luck."""
        good = [e <= error for e in self.errors]
        steady = [a and b for a, b in pairwise([*good, True])]
        return [point for point, is_steady in zip(self.points, steady, strict=True) if is_steady]

    def seconds_at(self, error: float) -> float | None:
        """Return the least time [s] to reach `error`; None if the curve does not reach it.

        Before the loosest point that reaches it, times are interpolated in logarithms. If the loosest measured
        tolerance reaches `error` already, looser tolerances might be faster.
        """
        reached = self.reaching(error)
        if not reached:
            return None
        return min(
            self._crossing(error, self.points.index(reached[0])), *(point.seconds or np.inf for point in reached)
        )

    def _crossing(self, error: float, k: int) -> float:
        """Return the time at which the line from point k - 1 to k crosses `error`, or that of point k."""
        errors, seconds = np.maximum(self.errors, 1e-300), self.seconds
        if k == 0 or not errors[k - 1] > error:
            return seconds[k]
        (e0, e1), (s0, s1) = np.log(errors[k - 1 : k + 1]), np.log(seconds[k - 1 : k + 1])
        return float(np.exp(s0 + (s1 - s0) * (e0 - np.log(error)) / (e0 - e1)))

    def order(self, floor: float) -> float | None:
        """Return p of error ~ steps^-p, fitted where the error is below 1e-2 and above `floor`.

        None if there are too few points, or if the steps of the first and last point differ by less than a factor of 2.
        """
        used = [p for p in self.points if p.nsteps and p.error_max and floor < p.error_max < 1e-2]
        if len(used) < 4 or (used[-1].nsteps or 0) < 2 * (used[0].nsteps or 0):
            return None
        steps, errors = np.log(np.array([[p.nsteps, p.error_max] for p in used], dtype=np.float64)).T
        return -float(np.polyfit(steps, errors, 1)[0])

    def cost(self) -> tuple[float, float] | None:
        """Return a [s], the cost of a call, and b [s], of an evaluation: seconds = a + b nfev, fitted relatively."""
        used = [p for p in self.points if p.nfev and p.seconds]
        if len(used) < 3:
            return None
        nfev, seconds = np.array([[p.nfev, p.seconds] for p in used], dtype=np.float64).T
        slope, constant = np.polyfit(nfev, seconds, 1, w=1 / seconds)
        return float(constant), float(slope)


@dataclass(frozen=True, slots=True)
class Recommendation:
    """The recommendation for a largest error of `requested`.

    chosen : the fastest measurement that reaches it, or None
    as_fast : others whose range of times overlaps with that of the chosen one
    closest : if none reaches it, the one with the smallest error
    """

    requested: float
    chosen: Measurement | None
    as_fast: tuple[Measurement, ...]
    closest: Measurement | None


def curves(measurements: Sequence[Measurement]) -> tuple[Curve, ...]:
    """Group measurements by solver, in their order."""
    names = dict.fromkeys((*m.curve, m.label) for m in measurements)
    return tuple(
        Curve(*name, tuple(m for m in measurements if (*m.curve, m.label) == name and m.seconds is not None))
        for name in names
    )


def recommend(candidates: Sequence[Curve], requested: float) -> Recommendation:
    """Return the recommendation among our curves."""
    ours = [curve for curve in candidates if curve.family == OURS]
    able = sorted((p for curve in ours for p in curve.reaching(requested)), key=lambda p: p.seconds or np.inf)
    if not able:
        every = [p for curve in ours for p in curve.points]
        return Recommendation(requested, None, (), min(every, key=lambda p: p.error_max or np.inf, default=None))
    best, *others = able
    overlapping = [p for p in others if p.curve != best.curve and (p.seconds_low or 0) <= (best.seconds_high or 0)]
    first_of_each = {p.curve: p for p in reversed(overlapping)}
    return Recommendation(requested, best, tuple(p for p in overlapping if first_of_each[p.curve] is p), None)
