"""Piecewise motions with contacts: from one event to the next in closed form, or by Integrated."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import asin, ceil, cos, floor, pi, sin
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from ...arguments.named_values import Vector
from .truth import Integrated


@dataclass(frozen=True)
class ReducedMotion:
    """Rows of a mechanism from a motion in fewer coordinates.

    begin : start (2n,) -> start of the inner motion
    shown : rows of the inner motion -> rows (k, 2n)
    """

    inner: Integrated
    begin: Callable[[Vector], Vector]
    shown: Callable[[Vector], Vector]
    how: str = "the equation of what stays free, in extended precision"
    own: float = 1e-13
    independent: bool = True

    def rows(self, start: Vector, times: Vector, level: int) -> Vector:
        return self.shown(self.inner.rows(self.begin(start), times, level))


@dataclass(frozen=True)
class TabulatedMotion:
    """Rows from a table (k, 1 + 2n), with the time as first column."""

    table: Vector
    how: str
    own: float = 1e-10
    independent: bool = True

    def rows(self, start: Vector, times: Vector, level: int) -> Vector:  # noqa: ARG002, the same at all levels
        return np.vstack([start, self.table[np.searchsorted(self.table[:, 0], times[1:]), 1:]])


@dataclass(frozen=True)
class DrivenFrictionMass:
    """A mass m under A sin(w t) with friction of up to `limit`, and a stop at x = 1 with restitution e (None: no stop).

    A mass that rebounds with at most the speed `rest` stays at the stop.
    """

    m: float
    A: float
    w: float
    limit: float
    e: float | None = None
    rest: float = 0.0

    def __call__(self, start: Vector, elapsed: Vector) -> Vector:
        """Return rows (k, 2)."""
        values = np.empty((len(elapsed), 2))
        for begin, end, x, v, way in self._pieces(float(start[0]), float(start[1]), float(elapsed[-1])):
            here = (elapsed >= begin) & (elapsed <= end)
            values[here] = np.stack(self._at(elapsed[here], begin, x, v, way), axis=1)
        return values

    def _at(self, t: Vector, begin: float, x: float, v: float, way: float) -> tuple[Vector, Vector]:
        """Return x and its rate, sliding to one side; 0: at rest."""
        if not way:
            return np.full_like(t, x), np.zeros_like(t)
        s, A, w = t - begin, self.A / self.w, self.w
        there = (
            v * s
            + (A * (cos(w * begin) * s - (np.sin(w * t) - sin(w * begin)) / w) - way * self.limit * s**2 / 2) / self.m
        )
        return x + there, v + (A * (cos(w * begin) - np.cos(w * t)) - way * self.limit * s) / self.m

    def _pieces(self, x: float, v: float, end: float) -> Iterator[tuple[float, float, float, float, float]]:
        """Yield begin, end, x and its rate at the beginning, and the direction of slip, of each piece."""
        t = 0.0
        while t < end:
            way = float(np.sign(v)) or self._slip_direction(t, x)
            until = self._next_stop(t, x, v, way, end) if way else self._next_slip(t, x)
            yield t, until, x, v, way
            (x,), (v,) = self._at(np.array([until]), t, x, v, way)
            if way and until < end:
                x, v = self._after_piece(x, v)
            t = until

    def _after_piece(self, x: float, v: float) -> tuple[float, float]:
        """Return x and its rate after a piece: at rest, or rebounding from the stop."""
        if self.e is None or v < 1e-9:
            return x, 0.0
        return 1.0, -self.e * v if self.e * v > self.rest else 0.0

    def _slip_direction(self, t: float, x: float) -> float:
        """Return the direction in which the mass begins to slide; 0: it does not."""
        force, grows = self.A * sin(self.w * t), cos(self.w * t) * sin(self.w * t) > 0
        over = abs(force) > self.limit * (1 + 1e-12) or (abs(force) > self.limit * (1 - 1e-12) and grows)
        way = float(np.sign(force)) * over
        return 0.0 if way > 0 and self._pressed(x) else way

    def _pressed(self, x: float) -> bool:
        return self.e is not None and abs(x - 1.0) < 1e-12

    def _next_slip(self, t: float, x: float) -> float:
        """Return the time at which the force next exceeds the limit towards a free side."""
        first = asin(self.limit / self.A) if self.limit < self.A else np.inf
        starts = (pi + first,) if self._pressed(x) else (first, pi + first)
        phase = self.w * t
        nexts = [s + 2 * pi * ceil((phase - s) / (2 * pi) + 1e-12) for s in starts if np.isfinite(s)]
        return min(nexts, default=np.inf) / self.w

    def _next_stop(self, t: float, x: float, v: float, way: float, end: float) -> float:
        """Return the time at which the sliding mass comes to rest or reaches the stop, at most `end`."""
        times = np.linspace(t, end, 2 + floor(400 * self.w * (end - t)))
        places, rates = self._at(times, t, x, v, way)
        stands = np.flatnonzero(way * rates[1:] < 0)
        meets = np.flatnonzero(places[1:] > 1.0) if self.e is not None and way > 0 else np.zeros(0, int)
        values = [
            self._root(times, k, t, x, v, way, part) for part, all_of in ((1, stands), (0, meets)) for k in all_of[:1]
        ]
        return min(values, default=end)

    def _root(self, times: Vector, k: int, t: float, x: float, v: float, way: float, part: int) -> float:
        value = lambda s: float(self._at(np.array([s]), t, x, v, way)[part][0]) - (1.0 - part)  # noqa: E731
        low = times[k] if k else t + 1e-9 * (times[1] - t)
        return float(brentq(value, low, times[k + 1], xtol=1e-15, rtol=1e-15))


@dataclass(frozen=True)
class RockingBlock:
    """Housner's block: p'' = -3 g (b cos p - h |sin p|) sign p / (4 (b^2 + h^2)); each impact reduces p'."""

    b: float
    h: float
    g: float

    @property
    def remaining(self) -> float:
        """1 - 3/2 sin^2 alpha: the part of p' after an impact, by angular momentum about the new corner."""
        return 1 - 1.5 * self.b**2 / (self.b**2 + self.h**2)

    def until_the_first(self, p: float) -> float:
        """Return the time [s] of the first impact after a release at an angle p > 0."""
        return float(self._about(1.0, 0.0, np.inf, p, 0.0).t[-1])

    def __call__(self, start: Vector, elapsed: Vector) -> Vector:
        """Return rows (k, 6) of x, y, p and their rates."""
        return np.array([self._shown(*row) for row in self._turned(start[2], start[5], elapsed)])

    def _turned(self, p: float, rate: float, elapsed: Vector) -> Vector:
        values, t, side = np.empty((len(elapsed), 2)), 0.0, float(np.sign(p))
        while t < elapsed[-1]:
            done = self._about(side, t, elapsed[-1], p, rate)
            here = (elapsed >= t) & (elapsed <= done.t[-1])
            values[here] = done.sol(elapsed[here]).T
            t, p, rate, side = float(done.t[-1]), 0.0, self.remaining * float(done.y[1, -1]), -side
        return values

    def _about(self, side: float, t: float, end: float, p: float, rate: float) -> Any:
        """Return the rotation about the corner of one side until the other corner lands."""
        pull = 0.75 * self.g / (self.b**2 + self.h**2)

        def rates(_: float, z: Vector) -> list[float]:
            return [z[1], -pull * side * self._lever(side * z[0])]

        def falls(_: float, z: Vector) -> float:
            return float(side * z[0])

        falls.terminal, falls.direction = True, -1  # type: ignore[attr-defined]
        accuracy: dict[str, Any] = {"rtol": 1e-13, "atol": 1e-15, "dense_output": True}
        return solve_ivp(rates, (t, end), [p, rate], "DOP853", events=falls, **accuracy)

    def _lever(self, angle: float) -> float:
        return self.b * cos(angle) - self.h * sin(angle)

    def _shown(self, p: float, rate: float) -> list[float]:
        side = 1.0 if p >= 0 else -1.0
        a = side * p
        x, y = side * (-self.b + self.b * cos(a) - self.h * sin(a)), self.b * sin(a) + self.h * cos(a)
        return [x, y, p, -rate * (self.b * sin(a) + self.h * cos(a)), side * rate * self._lever(a), rate]
