"""From measurements to advice: what reaches an accuracy soonest, and what a curve says."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from .measure import Measurement
from .solvers import IMPLICIT, OURS

LEVELS = (1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-12)


@dataclass(frozen=True, slots=True)
class Curve:
    """One solver's measurements that got to their end, from loose to tight."""

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
        """What it is compared as: our compiled methods by formulation, everything else by its label."""
        return self.formulation if self.family == OURS and not self.is_implicit else self.label

    @property
    def errors(self) -> list[float]:
        """(k,) largest on the way."""
        return [point.error_max or 0.0 for point in self.points]

    @property
    def seconds(self) -> list[float]:
        """(k,) medians [s]."""
        return [point.seconds or np.nan for point in self.points]

    def reaching(self, error: float) -> list[Measurement]:
        """Return the points that reach `error` and are not lucky: the next tighter one, if any, reaches it too."""
        good = [e <= error for e in self.errors]
        steady = [a and b for a, b in pairwise([*good, True])]
        return [point for point, is_steady in zip(self.points, steady, strict=True) if is_steady]

    def seconds_at(self, error: float) -> float | None:
        """Return the time to reach `error` [s], of the quickest that do; None where the curve does not reach it.

        Up to the loosest that does, the times are interpolated in logarithms. Where the loosest tolerance measured is
        better than `error` already, looser ones may be quicker.
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

        None where there are too few points, or hardly more steps at the last than at the first: the order varies.
        """
        used = [p for p in self.points if p.nsteps and p.error_max and floor < p.error_max < 1e-2]
        if len(used) < 4 or (used[-1].nsteps or 0) < 2 * (used[0].nsteps or 0):
            return None
        steps, errors = np.log(np.array([[p.nsteps, p.error_max] for p in used], dtype=np.float64)).T
        return -float(np.polyfit(steps, errors, 1)[0])

    def cost(self) -> tuple[float, float] | None:
        """Return a [s] and b [s] of seconds = a + b nfev, fitted to relative deviations: a call, and an evaluation."""
        used = [p for p in self.points if p.nfev and p.seconds]
        if len(used) < 3:
            return None
        nfev, seconds = np.array([[p.nfev, p.seconds] for p in used], dtype=np.float64).T
        slope, constant = np.polyfit(nfev, seconds, 1, w=1 / seconds)
        return float(constant), float(slope)


@dataclass(frozen=True, slots=True)
class Recommendation:
    """What to use for an error of `asked`, largest on the way.

    chosen : the measurement that reaches it soonest, or None where none does
    as_fast : others whose spread of times overlaps with that of the chosen one
    closest : where none reaches it, the smallest error there is
    """

    asked: float
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


def recommend(found: Sequence[Curve], asked: float) -> Recommendation:
    """Choose among our curves."""
    ours = [curve for curve in found if curve.family == OURS]
    able = sorted((p for curve in ours for p in curve.reaching(asked)), key=lambda p: p.seconds or np.inf)
    if not able:
        every = [p for curve in ours for p in curve.points]
        return Recommendation(asked, None, (), min(every, key=lambda p: p.error_max or np.inf, default=None))
    best, *others = able
    overlapping = [p for p in others if p.curve != best.curve and (p.seconds_low or 0) <= (best.seconds_high or 0)]
    first_of_each = {p.curve: p for p in reversed(overlapping)}
    return Recommendation(asked, best, tuple(p for p in overlapping if first_of_each[p.curve] is p), None)
