"""Hyper-dual numbers: first and mixed second derivatives, exact to rounding, with bounds of the rounding error.

a + b d + c e + f d e with d^2 = e^2 = 0: a function of x + v d + w e has its derivative along v as coefficient of d,
along w of e, and the mixed second derivative of d e (Fike and Alonso 2011). There is no step size and no cancellation.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from .rounding_bounds import EPS, FACTOR, Part, Rounded, rounded

_Some = Rounded | None
"""A coefficient; None if it is zero everywhere."""


def plus(first: _Some, second: _Some) -> _Some:
    """Return the sum of two coefficients."""
    if first is None:
        return second
    return first if second is None else first + second


def times(first: _Some, second: _Some) -> _Some:
    """Return the product of two coefficients."""
    return None if first is None or second is None else first * second


@dataclass(frozen=True, slots=True, eq=False)
class HyperDual:
    """a + b d + c e + f d e; coefficients broadcast against each other, None is zero."""

    a: Rounded
    b: _Some = None
    c: _Some = None
    f: _Some = None

    @property
    def varies(self) -> bool:
        """Whether the number has a nonzero derivative."""
        return self.b is not None or self.c is not None

    def __add__(self, other: HyperDual) -> HyperDual:
        return HyperDual(self.a + other.a, plus(self.b, other.b), plus(self.c, other.c), plus(self.f, other.f))

    def __mul__(self, other: HyperDual) -> HyperDual:
        return HyperDual(
            self.a * other.a,
            plus(times(self.a, other.b), times(self.b, other.a)),
            plus(times(self.a, other.c), times(self.c, other.a)),
            plus(
                plus(times(self.a, other.f), times(self.f, other.a)),
                plus(times(self.b, other.c), times(self.c, other.b)),
            ),
        )

    def through(self, value: Rounded, slope: _Some = None, bend: _Some = None) -> HyperDual:
        """Return g(self) from g, g' and g'' at a; None for a derivative that is zero."""
        return HyperDual(
            value,
            times(slope, self.b),
            times(slope, self.c),
            plus(times(slope, self.f), times(bend, times(self.b, self.c))),
        )

    def power(self, p: Rounded) -> HyperDual:
        """Return self^p for a constant exponent."""
        if np.ndim(p.value) == 0 and p.value == 2.0:
            return self * self
        a, orders = self.a, 3 if self.varies else 1
        whole = (p.value >= 0.0) & (p.value == np.floor(p.value))
        reach = np.abs(a.value) + np.where(whole, a.bound, 0.0)  # the slope here bounds that of the power
        factors = np.cumprod(np.array(np.broadcast_arrays(1.0, *(p.value - k for k in range(orders)))), axis=0)
        unsure = a.near() & (a.bound > 0.0) & ~whole
        most = np.where(p.value > 0.0, (np.abs(a.value) + a.bound) ** p.value, np.inf)
        logarithm = np.where(a.value == 0.0, 0.0, np.log(np.abs(a.value)))

        def derivative(order: int) -> Rounded:
            value = _scaled_power(factors[order], a.value, p.value - order)
            slope = np.abs(_scaled_power(factors[order + 1], reach, p.value - order - 1.0))
            bound = _moved(slope, a.bound) + np.abs(value) * (EPS + np.abs(logarithm) * p.bound)
            return Rounded(value, np.where(unsure, most if order == 0 else np.inf, bound))

        return self.through(*map(derivative, range(orders)))

    def where(self, chosen: Part, doubt: Part, other: HyperDual) -> HyperDual:
        """Return self where `chosen`, and other elsewhere; where there is a doubt, the bound covers both."""

        def part(mine: _Some, theirs: _Some) -> _Some:
            return None if mine is None and theirs is None else _either(chosen, doubt, mine or _ZERO, theirs or _ZERO)

        parts = (part(getattr(self, k), getattr(other, k)) for k in "bcf")
        return HyperDual(_either(chosen, doubt, self.a, other.a), *parts)


_ZERO = Rounded(0.0, 0.0)


def _either(chosen: Part, doubt: Part, mine: Rounded, theirs: Rounded) -> Rounded:
    bound = np.where(chosen, mine.bound, theirs.bound)
    unsure = np.abs(mine.value - theirs.value) + mine.bound + theirs.bound
    return Rounded(np.where(chosen, mine.value, theirs.value), np.where(doubt, unsure, bound))


def from_parts(a: Part, b: Part = None, c: Part = None, f: Part = None) -> HyperDual:
    """Return a number from its coefficients, each of which is rounded once."""
    return HyperDual(rounded(a), *(None if part is None else rounded(part) for part in (b, c, f)))


def power(base: HyperDual, exponent: HyperDual) -> HyperDual:
    """Return base^exponent."""
    if not exponent.varies:
        return base.power(exponent.a)
    return FUNCTIONS["exp"](exponent * FUNCTIONS["log"](base))


def doubt(one: HyperDual, other: HyperDual) -> Part:
    """Return whether rounding decides which is larger, or they are equal but their difference varies."""
    difference = one.a - other.a
    return difference.near() & ((difference.bound > 0.0) | one.varies | other.varies)


def _scaled_power(factor: Part, a: Part, p: Part) -> Part:
    return np.where(factor == 0.0, 0.0, factor * a**p)


def _moved(slope: Part, bound: Part) -> Part:
    """Return the error of a value due to the error of its argument; 0 if the argument is exact."""
    return np.where(bound == 0.0, 0.0, np.abs(slope) * bound)


def _arctan2(y: HyperDual, x: HyperDual) -> HyperDual:
    """Return atan2: the angle, plus atan of a rotated argument near zero, where there is no branch cut."""
    up, right = HyperDual(y.a), HyperDual(x.a)
    along = y * up + x * right
    across = y * right + x * HyperDual(-y.a)
    angle = np.arctan2(y.a.value, x.a.value)
    cut = np.where(doubt(y, HyperDual(_ZERO)) & ~(x.a.value > 0.0), 2.0 * np.pi, 0.0)
    turned = FUNCTIONS["atan"](across * along.power(Rounded(-1.0, 0.0)))
    return turned + HyperDual(Rounded(angle, EPS * np.abs(angle) + cut))


def _steps(value: Callable[[Part], Part], jump: float, whole: bool = False) -> Callable[[HyperDual], HyperDual]:
    """Return the extension of a step function, with a jump at zero or at whole numbers."""

    def function(x: HyperDual) -> HyperDual:
        at = Rounded(np.round(x.a.value) if whole else 0.0, 0.0)
        return HyperDual(Rounded(value(x.a.value), np.where(doubt(x, HyperDual(at)), jump, 0.0)))

    return function


def _smooth(
    *derivatives: Callable[[Part], Part], edge: Callable[[Part], Part] | None = None, terms: float = 0.0
) -> Any:
    """Return the extension of a function from its value and three derivatives.

    edge : zero at the boundary of the domain
    terms : size of terms that may cancel in the derivatives
    """

    def function(x: HyperDual) -> HyperDual:
        a, off = x.a.value, x.a.bound
        values = [derivative(a) for derivative in derivatives[: 4 if x.varies else 2]]
        if edge is not None:
            off = np.where((np.abs(edge(a)) > FACTOR * off) | (off == 0.0), off, np.inf)
        bounds = [_moved(slope, off) + EPS * np.maximum(np.abs(value), terms if order else 0.0)
                  for order, (value, slope) in enumerate(pairwise(values))]  # fmt: skip
        return x.through(*map(Rounded, values, bounds))

    return function


def _absolute(x: HyperDual) -> HyperDual:
    sign = FUNCTIONS["sign"](x).a
    return x.through(Rounded(np.abs(x.a.value), x.a.bound), sign)


_BELL = 2.0 / math.sqrt(math.pi)
_erf = np.vectorize(math.erf, otypes=[float])


def _tan3(a: Part) -> Part:
    return (2 + 4 * np.sin(a) ** 2) / np.cos(a) ** 4


FUNCTIONS: Mapping[str, Callable[..., HyperDual]] = {
    "sin": _smooth(np.sin, np.cos, lambda a: -np.sin(a), lambda a: -np.cos(a)),
    "cos": _smooth(np.cos, lambda a: -np.sin(a), lambda a: -np.cos(a), np.sin),
    "tan": _smooth(np.tan, lambda a: 1 / np.cos(a) ** 2, lambda a: 2 * np.tan(a) / np.cos(a) ** 2, _tan3, edge=np.cos),
    "asin": _smooth(np.arcsin, lambda a: (1 - a**2) ** -0.5, lambda a: a * (1 - a**2) ** -1.5,
                    lambda a: (1 + 2 * a**2) * (1 - a**2) ** -2.5, edge=lambda a: 1 - np.abs(a)),
    "acos": _smooth(np.arccos, lambda a: -((1 - a**2) ** -0.5), lambda a: -a * (1 - a**2) ** -1.5,
                    lambda a: -(1 + 2 * a**2) * (1 - a**2) ** -2.5, edge=lambda a: 1 - np.abs(a)),
    "atan": _smooth(np.arctan, lambda a: 1 / (1 + a**2), lambda a: -2 * a / (1 + a**2) ** 2,
                    lambda a: (6 * a**2 - 2) / (1 + a**2) ** 3),
    "atan2": _arctan2,
    "sinh": _smooth(np.sinh, np.cosh, np.sinh, np.cosh),
    "cosh": _smooth(np.cosh, np.sinh, np.cosh, np.sinh),
    "tanh": _smooth(np.tanh, lambda a: np.cosh(a) ** -2.0, lambda a: -2 * np.tanh(a) * np.cosh(a) ** -2.0,
                    lambda a: (4 * np.tanh(a) ** 2 - 2 * np.cosh(a) ** -2.0) * np.cosh(a) ** -2.0, terms=1.0),
    "asinh": _smooth(np.arcsinh, lambda a: (a**2 + 1) ** -0.5, lambda a: -a * (a**2 + 1) ** -1.5,
                     lambda a: (2 * a**2 - 1) * (a**2 + 1) ** -2.5),
    "acosh": _smooth(np.arccosh, lambda a: (a**2 - 1) ** -0.5, lambda a: -a * (a**2 - 1) ** -1.5,
                     lambda a: (2 * a**2 + 1) * (a**2 - 1) ** -2.5, edge=lambda a: a - 1),
    "atanh": _smooth(np.arctanh, lambda a: 1 / (1 - a**2), lambda a: 2 * a / (1 - a**2) ** 2,
                     lambda a: (2 + 6 * a**2) / (1 - a**2) ** 3, edge=lambda a: 1 - np.abs(a)),
    "exp": _smooth(np.exp, np.exp, np.exp, np.exp),
    "log": _smooth(np.log, lambda a: 1 / a, lambda a: -1 / a**2, lambda a: 2 / a**3, edge=lambda a: a),
    "erf": _smooth(_erf, lambda a: _BELL * np.exp(-(a**2)), lambda a: -2 * a * _BELL * np.exp(-(a**2)),
                   lambda a: (4 * a**2 - 2) * _BELL * np.exp(-(a**2))),
    "Abs": _absolute,
    "Min": lambda x, y: x.where(x.a.value < y.a.value, doubt(x, y), y),
    "Max": lambda x, y: x.where(x.a.value > y.a.value, doubt(x, y), y),
    "sign": _steps(np.sign, 2.0),
    "floor": _steps(np.floor, 1.0, whole=True),
    "ceiling": _steps(np.ceil, 1.0, whole=True),
    "Heaviside": _steps(lambda a: np.heaviside(a, 0.5), 1.0),
}  # fmt: skip
"""Name of the SymPy class -> function; Min and Max of two arguments."""

RELATIONS: Mapping[str, Callable[[Part, Part], Part]] = {
    "StrictLessThan": operator.lt, "LessThan": operator.le, "StrictGreaterThan": operator.gt,
    "GreaterThan": operator.ge, "Equality": operator.eq, "Unequality": operator.ne,
}  # fmt: skip
