"""Interpolants of SciPy in SymPy's expressions: values and derivatives come of SciPy alone."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from math import perm
from typing import Any

import numpy as np
import scipy.interpolate as si
import sympy

ENDS = 1e-9
"""So close to the end of a range, in parts of it, nothing is asked: rounding decides on which side an argument is."""


def spline_of(given: Any) -> Any:
    """Return an interpolant of SciPy that gives derivatives, and goes on beyond its range, of what a table takes."""
    if isinstance(given, tuple) and len(given) == 2:
        return si.make_interp_spline(*given, k=1)
    if isinstance(given, tuple):
        x, y, values = given
        return si.NdBSpline((_doubled(x), _doubled(y)), np.asarray(values), 1)
    if isinstance(given, si.RectBivariateSpline):
        (tx, ty, c), (kx, ky) = given.tck, given.degrees
        return si.NdBSpline((tx, ty), np.reshape(c, (len(tx) - kx - 1, len(ty) - ky - 1)), (kx, ky))
    return given


def _doubled(points: Any) -> np.ndarray:
    return np.array([points[0], *points, points[-1]], dtype=float)


@dataclass(frozen=True, eq=False)
class Curve:
    """A function of one argument or two, and how it goes on beyond its range."""

    given: Any
    outside: str
    name: str
    spline: Any = field(init=False)
    made: dict[tuple[int, ...], type[sympy.Function]] = field(init=False, default_factory=dict)

    def __post_init__(self) -> None:
        object.__setattr__(self, "spline", spline_of(self.given))

    @property
    def ranges(self) -> list[tuple[float, float]]:
        """The first and the last knot of each argument."""
        return [(knots[0], knots[-1]) for knots in self.knots]

    @property
    def knots(self) -> list[np.ndarray]:
        """The knots of each argument."""
        if isinstance(self.spline, si.NdBSpline):
            return [np.array(t[k : len(t) - k]) for t, k in zip(self.spline.t, self.spline.k, strict=True)]
        if isinstance(self.spline, si.BSpline):
            return [self.spline.t[self.spline.k : len(self.spline.t) - self.spline.k]]
        return [self.spline.x]

    def value(self, orders: tuple[int, ...], point: tuple[float, ...]) -> float:
        """Return the derivative of these orders at a point; NaN where it is refused."""
        at = [self._within(x, low, high) for x, (low, high) in zip(point, self.ranges, strict=True)]
        if np.isnan(at).any():
            return np.nan
        off = _ROUNDING.draw() * self.terms(orders, point) if _ROUNDING.size else 0.0
        return self._at(orders, point, at) + off

    def _at(self, orders: tuple[int, ...], point: tuple[float, ...], at: list[float]) -> float:
        if self.outside == "hold" and any(d and x != y for d, x, y in zip(orders, point, at, strict=True)):
            return 0.0
        if len(at) == 1:
            return float(self.spline(at[0], orders[0], extrapolate=True))
        if any(d > k for d, k in zip(orders, self.spline.k, strict=True)):
            return 0.0
        return float(self.spline(at, nu=orders, extrapolate=True))

    def _within(self, x: float, low: float, high: float) -> float:
        if low <= x <= high or self.outside == "extend":
            return x
        if self.outside == "hold":
            return min(max(x, low), high)
        return x - np.floor((x - low) / (high - low)) * (high - low) if self.outside == "periodic" else np.nan

    def place(self, point: tuple[float, ...]) -> tuple[int, ...] | None:
        """Return the numbers of the pieces; None where an argument is at the end of a range, to rounding."""
        for x, (low, high) in zip(point, self.ranges, strict=True):
            part = (x - low) / (high - low)
            if abs(part - round(part)) < ENDS and (self.outside == "periodic" or round(part) in (0, 1)):
                return None
        return tuple(int(np.searchsorted(knots, self._within(x, knots[0], knots[-1])))
                     for x, knots in zip(point, self.knots, strict=True))  # fmt: skip

    def terms(self, orders: tuple[int, ...], point: tuple[float, ...]) -> float:
        """Return the sum of the sizes of the terms of a derivative: what rounding is measured in; of two, a bound."""
        at = [self._within(x, low, high) for x, (low, high) in zip(point, self.ranges, strict=True)]
        if len(at) == 1:
            return self._powers(at[0], orders[0])
        sizes = [_growth(x, knots, k, d) for x, knots, k, d in
                 zip(at, self.knots, self.spline.k, orders, strict=True)]  # fmt: skip
        return float(np.abs(self.spline.c).max() * np.prod(sizes))

    def _powers(self, x: float, order: int) -> float:
        pieces = si.PPoly.from_spline(self.spline) if isinstance(self.spline, si.BSpline) else self.spline
        places = np.flatnonzero(np.diff(pieces.x))  # some knots are there several times
        k = places[max(int(np.searchsorted(pieces.x[places], x, side="right")) - 1, 0)]
        step, coefficients = abs(x - pieces.x[k]), np.abs(pieces.c[::-1, k])
        return sum(perm(m, order) * c * step ** (m - order) for m, c in enumerate(coefficients) if m >= order)

    def function(self, orders: tuple[int, ...]) -> type[sympy.Function]:
        """Return the derivative of these orders as a function of SymPy, which NumPy evaluates."""
        parts = {
            "nargs": len(orders),
            "curve": self,
            "fdiff": lambda call, k=1: self.function(_raised(orders, k - 1))(*call.args),
            "_eval_is_extended_real": lambda call: True,
            "_imp_": staticmethod(lambda *point: self.value(orders, tuple(map(float, point)))),
        }
        if orders not in self.made:
            self.made[orders] = type(f"{self.name}_{''.join(map(str, orders))}", (sympy.Function,), parts)
        return self.made[orders]

    def __call__(self, *arguments: Any) -> sympy.Expr:
        """Return the curve at these arguments, as an expression."""
        return self.function((0,) * len(arguments))(*arguments)


def _growth(x: float, knots: np.ndarray, k: int, order: int) -> float:
    """Return a bound of a basis spline's derivative, of degree k: between knots, and beyond."""
    gap, width = np.diff(knots).min(), np.diff(knots).max()
    beyond = max(knots[0] - x, x - knots[-1], 0.0)
    return float((2 * max(k, 1) / gap) ** order * (1 + 2 * beyond / gap) ** k * (1 + width / gap))


class _Rounding:
    """How large the errors are that curves are asked to make, in parts of their terms, and their signs."""

    def __init__(self) -> None:
        self.size, self.random = 0.0, np.random.default_rng(0)

    def draw(self) -> float:
        return self.size * self.random.choice((-1.0, 1.0))


_ROUNDING = _Rounding()


@contextmanager
def rounded(size: float, seed: int) -> Iterator[None]:
    """Within it, curves are off by a part of their terms."""
    _ROUNDING.size, _ROUNDING.random = size, np.random.default_rng(seed)
    try:
        yield
    finally:
        _ROUNDING.size = 0.0


def _raised(orders: tuple[int, ...], k: int) -> tuple[int, ...]:
    return tuple(order + (place == k) for place, order in enumerate(orders))


def calls_in(expressions: Iterable[sympy.Expr]) -> list[tuple[Curve, tuple[sympy.Expr, ...]]]:
    """Return the curves that expressions call, with their arguments."""
    found = {call for one in expressions for call in sympy.sympify(one).atoms(sympy.Function) if hasattr(call, "curve")}
    return [(call.curve, call.args) for call in sorted(found, key=str)]
