"""Integration in extended precision: adaptive steps, steps on a graded mesh, and extrapolated midpoint steps.

Gragg, Bulirsch, Stoer; Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, II.9: T_j1 by
n_j = 2, 4, 6, ... modified midpoint steps, T_jk = T_j,k-1 + (T_j,k-1 - T_j-1,k-1) / ((n_j / n_j-k+1)^2 - 1).
"""

from itertools import pairwise
from math import ceil
from typing import Any, Protocol

import numpy as np

from ..arguments.named_values import Vector
from .extended_precision import Extended, Rhs

MOST_STEPS = 20_000


class NotReachedError(ArithmeticError):
    """The integration did not reach its end; the message says why."""


class Scheme(Protocol):
    """A one-step method with an error estimate, which is proportional to h^power."""

    @property
    def power(self) -> int: ...

    def step(self, rhs: Rhs, time: Any, y: Extended, h: Any) -> tuple[Extended, float]:
        """Return y at time + h and the scaled error, infinite or NaN if the step fails."""


def integrate_adaptive(scheme: Scheme, rhs: Rhs, y: Vector | Extended, times: Vector, tolerance: float) -> Extended:
    """Return y (k, 2n) at increasing times (k,), the first of which is the start; each step has error <= tolerance.

    Raises
    ------
    NotReachedError
        Too many steps, or a step below the spacing of doubles.
    """
    rows = [np.array(y, dtype=np.longdouble)]
    steps = _AdaptiveSteps(scheme, rhs, tolerance, step=float(times[-1] - times[0]) / 64)
    for start, end in zip(times[:-1].tolist(), times[1:].tolist(), strict=True):
        rows.append(steps.advance(np.longdouble(start), np.longdouble(end), rows[-1]))
    return np.array(rows)


class _AdaptiveSteps:
    """Adaptive steps of fixed order."""

    def __init__(self, scheme: Scheme, rhs: Rhs, tolerance: float, step: float) -> None:
        self.scheme, self.rhs, self.tolerance, self.step, self.left = scheme, rhs, tolerance, step, MOST_STEPS

    def advance(self, time: Any, end: Any, y: Extended) -> Extended:
        while time < end:
            parts = max(1, ceil(float(end - time) / self.step))
            h = (end - time) / parts
            candidate, error = self.scheme.step(self.rhs, time, y, h)
            self._resize(float(h), float(time), error)
            if error <= self.tolerance:
                time, y = (end if parts == 1 else time + h), candidate
        return y

    def _resize(self, h: float, time: float, error: float) -> None:
        self.left -= 1
        factor = 0.8 * (self.tolerance / max(error, 1e-300)) ** (1 / self.scheme.power) if np.isfinite(error) else 0.2
        proposed = h * min(3.0, max(0.2, factor))
        # a step that was shortened to end at a row must not reduce the step size
        self.step = max(proposed, self.step) if error <= self.tolerance and h < self.step else proposed
        if self.step < 1e-15 * max(1.0, abs(time)) or self.left < 0:
            raise NotReachedError(f"the reference stopped at t = {time:.6g} with steps of {self.step:.1e} s")


def integrate_graded(scheme: Scheme, rhs: Rhs, y: Vector | Extended, times: Vector, per_decade: int) -> Extended:
    """Return y (k, 2n) at increasing times (k,) from the start 0, with predetermined steps.

    The steps grow geometrically from 1e-12 of the span, `per_decade` of them for a factor of ten, and end at each of
    the times. None is longer than the span / (8 per_decade).

    Raises
    ------
    NotReachedError
        A step failed.
    """
    here, proposed = np.array(y, dtype=np.longdouble), set(times.tolist())
    rows = [here]
    for start, end in pairwise(_mesh(times, per_decade)):
        here, error = scheme.step(rhs, np.longdouble(start), here, np.longdouble(end) - np.longdouble(start))
        if not np.isfinite(error):
            raise NotReachedError(f"the reference stopped at t = {start:.6g}, from where there is no step to {end:.6g}")
        if end in proposed:
            rows.append(here)
    return np.array(rows)


def _mesh(times: Vector, per_decade: int) -> list[float]:
    span = float(times[-1])
    geometric = span * np.logspace(-12, 0, 12 * per_decade + 1)
    even = np.linspace(0.0, span, 8 * per_decade + 1)
    return sorted({0.0, *geometric[:-1].tolist(), *even[:-1].tolist(), *times.tolist()})


class Midpoint:
    """Extrapolated midpoint steps with `columns` columns, of order 2 columns."""

    def __init__(self, columns: int) -> None:
        self.substeps = tuple(2 * (k + 1) for k in range(columns))
        self.power = 2 * columns - 1

    def step(self, rhs: Rhs, time: Any, y: Extended, h: Any) -> tuple[Extended, float]:
        """Return y at time + h and the scaled difference of the last two columns."""
        slope = rhs(time, y)
        row: list[Extended] = []
        for j, count in enumerate(self.substeps):
            above, row = row, [_midpoint(rhs, time, y, slope, h, count)]
            for k, coarse in enumerate(above):
                ratio = np.longdouble(count) / self.substeps[j - k - 1]
                row.append(row[k] + (row[k] - coarse) / (ratio * ratio - 1))
        error = np.abs(row[-1] - row[-2]) / (1 + np.abs(y))
        return row[-1], float(error.max())


def _midpoint(rhs: Rhs, time: Any, y: Extended, slope: Extended, h: Any, count: int) -> Extended:
    small = h / count
    before: Extended = y
    here: Extended = y + small * slope
    for k in range(1, count):
        after: Extended = before + 2 * small * rhs(time + k * small, here)
        before, here = here, after
    return here
