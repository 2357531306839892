"""Hyper-dual numbers: first and mixed second derivatives by arithmetic, exact to rounding.

a + b d + c e + f d e with d^2 = e^2 = 0: a function of x + v d + w e has its derivative along v at d, along w at e,
along both at d e (Fike and Alonso 2011). No step to choose, nothing that cancels.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

Part: TypeAlias = Any
"""An array, or None for a part that is zero throughout."""


def _plus(first: Part, second: Part) -> Part:
    if first is None:
        return second
    return first if second is None else first + second


def _times(first: Part, second: Part) -> Part:
    return None if first is None or second is None else first * second


@dataclass(frozen=True, slots=True, eq=False)
class HyperDual:
    """a + b d + c e + f d e; arrays that broadcast against each other, None for zero."""

    a: Part
    b: Part = None
    c: Part = None
    f: Part = None

    def __add__(self, other: HyperDual) -> HyperDual:
        return HyperDual(self.a + other.a, _plus(self.b, other.b), _plus(self.c, other.c), _plus(self.f, other.f))

    def __mul__(self, other: HyperDual) -> HyperDual:
        return HyperDual(
            self.a * other.a,
            _plus(_times(self.a, other.b), _times(self.b, other.a)),
            _plus(_times(self.a, other.c), _times(self.c, other.a)),
            _plus(
                _plus(_times(self.a, other.f), _times(self.f, other.a)),
                _plus(_times(self.b, other.c), _times(self.c, other.b)),
            ),
        )

    def scaled(self, factor: Part) -> HyperDual:
        """Return factor x self, for a factor that varies with nothing."""
        return HyperDual(self.a * factor, *(_times(part, factor) for part in (self.b, self.c, self.f)))

    def through(self, value: Part, slope: Part, bend: Part) -> HyperDual:
        """Return g(self), given g, g' and g'' at a; None where a derivative is zero."""
        return HyperDual(
            value,
            _times(slope, self.b),
            _times(slope, self.c),
            _plus(_times(slope, self.f), _times(bend, _times(self.b, self.c))),
        )

    def power(self, exponent: Part) -> HyperDual:
        """Return self^exponent for an exponent that varies with nothing."""
        p, a = exponent, self.a
        if self.b is None and self.c is None:
            return HyperDual(a**p)
        first = np.where(np.equal(p, 0), 0.0, p * a ** (p - 1.0))
        second = np.where(np.equal(p * (p - 1.0), 0), 0.0, p * (p - 1.0) * a ** (p - 2.0))
        return self.through(a**p, first, second)

    def where(self, chosen: Part, other: HyperDual) -> HyperDual:
        """Return self where `chosen`, and the other elsewhere."""

        def part(mine: Part, theirs: Part) -> Part:
            if mine is None and theirs is None:
                return None
            return np.where(chosen, 0.0 if mine is None else mine, 0.0 if theirs is None else theirs)

        return HyperDual(*(part(getattr(self, k), getattr(other, k)) for k in "abcf"))


def power(base: HyperDual, exponent: HyperDual) -> HyperDual:
    """Return base^exponent."""
    if exponent.b is None and exponent.c is None:
        return base.power(exponent.a)
    return FUNCTIONS["exp"](exponent * FUNCTIONS["log"](base))


def _arctan2(y: HyperDual, x: HyperDual) -> HyperDual:
    """atan2, turned so that the angle left is zero: it has no branches there."""
    along = y.scaled(y.a) + x.scaled(x.a)
    across = y.scaled(x.a) + x.scaled(-y.a)
    return FUNCTIONS["atan"](across * along.power(-1.0)) + HyperDual(np.arctan2(y.a, x.a))


def _steps(value: Callable[[Part], Part]) -> Callable[[HyperDual], HyperDual]:
    return lambda x: HyperDual(value(x.a))


def _smooth(value: Callable[[Part], Part], slope: Callable[[Part], Part], bend: Callable[[Part], Part]) -> Any:
    def function(x: HyperDual) -> HyperDual:
        if x.b is None and x.c is None:
            return HyperDual(value(x.a))
        return x.through(value(x.a), slope(x.a), bend(x.a))

    return function


_BELL = 2.0 / math.sqrt(math.pi)
_erf = np.vectorize(math.erf, otypes=[float])

FUNCTIONS: Mapping[str, Callable[..., HyperDual]] = {
    "sin": _smooth(np.sin, np.cos, lambda a: -np.sin(a)),
    "cos": _smooth(np.cos, lambda a: -np.sin(a), lambda a: -np.cos(a)),
    "tan": _smooth(np.tan, lambda a: 1 / np.cos(a) ** 2, lambda a: 2 * np.tan(a) / np.cos(a) ** 2),
    "asin": _smooth(np.arcsin, lambda a: (1 - a**2) ** -0.5, lambda a: a * (1 - a**2) ** -1.5),
    "acos": _smooth(np.arccos, lambda a: -((1 - a**2) ** -0.5), lambda a: -a * (1 - a**2) ** -1.5),
    "atan": _smooth(np.arctan, lambda a: 1 / (1 + a**2), lambda a: -2 * a / (1 + a**2) ** 2),
    "atan2": _arctan2,
    "sinh": _smooth(np.sinh, np.cosh, np.sinh),
    "cosh": _smooth(np.cosh, np.sinh, np.cosh),
    "tanh": _smooth(np.tanh, lambda a: np.cosh(a) ** -2.0, lambda a: -2 * np.tanh(a) * np.cosh(a) ** -2.0),
    "asinh": _smooth(np.arcsinh, lambda a: (a**2 + 1) ** -0.5, lambda a: -a * (a**2 + 1) ** -1.5),
    "acosh": _smooth(np.arccosh, lambda a: (a**2 - 1) ** -0.5, lambda a: -a * (a**2 - 1) ** -1.5),
    "atanh": _smooth(np.arctanh, lambda a: 1 / (1 - a**2), lambda a: 2 * a / (1 - a**2) ** 2),
    "exp": _smooth(np.exp, np.exp, np.exp),
    "log": _smooth(np.log, lambda a: 1 / a, lambda a: -1 / a**2),
    "erf": _smooth(_erf, lambda a: _BELL * np.exp(-(a**2)), lambda a: -2 * a * _BELL * np.exp(-(a**2))),
    "Abs": lambda x: x.through(np.abs(x.a), np.sign(x.a), None),
    "Min": lambda x, y: x.where(x.a < y.a, y),
    "Max": lambda x, y: x.where(x.a > y.a, y),
    "sign": _steps(np.sign),
    "floor": _steps(np.floor),
    "ceiling": _steps(np.ceil),
    "Heaviside": _steps(lambda a: np.heaviside(a, 0.5)),
}
"""By the names of SymPy's classes; Min and Max of two."""

RELATIONS: Mapping[str, Callable[[Part, Part], Part]] = {
    "StrictLessThan": operator.lt, "LessThan": operator.le, "StrictGreaterThan": operator.gt,
    "GreaterThan": operator.ge, "Equality": operator.eq, "Unequality": operator.ne,
}  # fmt: skip
