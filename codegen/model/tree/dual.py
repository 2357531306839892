"""Dual numbers, nested for higher derivatives: values of functions of bodies and of their derivatives as floats."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sympy

from .forward_kinematics import Arithmetic, ForwardKinematics
from .quantity import Quantity


@dataclass(frozen=True, slots=True, eq=False)
class Dual:
    """value + slope d, d^2 = 0. Both are floats, or dual numbers in another d."""

    value: Any
    slope: Any

    def __add__(self, other: Any) -> Dual:
        if isinstance(other, Dual):
            return Dual(self.value + other.value, self.slope + other.slope)
        return Dual(self.value + other, self.slope)

    def __mul__(self, other: Any) -> Dual:
        if isinstance(other, Dual):
            return Dual(self.value * other.value, self.value * other.slope + self.slope * other.value)
        return Dual(self.value * other, self.slope * other)

    def __radd__(self, other: Any) -> Dual:
        return Dual(self.value + other, self.slope)

    def __rmul__(self, other: Any) -> Dual:
        return Dual(self.value * other, self.slope * other)

    def __sub__(self, other: Any) -> Dual:
        return Dual.__add__(self, -other)

    def __rsub__(self, other: Any) -> Dual:
        return Dual.__add__(-self, other)

    def __neg__(self) -> Dual:
        return Dual(-self.value, -self.slope)

    def __pow__(self, exponent: float) -> Dual:
        return Dual(self.value**exponent, exponent * self.value ** (exponent - 1) * self.slope)

    def __truediv__(self, other: Any) -> Dual:
        quotient: Dual = self * Dual._inverse(other)
        return quotient

    def __rtruediv__(self, other: Any) -> Dual:
        quotient: Dual = Dual._inverse(self) * other
        return quotient

    @staticmethod
    def _inverse(number: Any) -> Any:
        return number**-1.0


def _sin(x: Any) -> Any:
    return Dual(_sin(x.value), _cos(x.value) * x.slope) if isinstance(x, Dual) else math.sin(x)


def _cos(x: Any) -> Any:
    return Dual(_cos(x.value), _sin(x.value) * x.slope * -1.0) if isinstance(x, Dual) else math.cos(x)


def value(quantity: Quantity, orders: Sequence[int], point: Sequence[float]) -> float:
    """Return a quantity, or its derivative of these orders, one for each of its variables, at a point."""
    numbers: list[Any] = [float(one) for one in point]
    for place, order in enumerate(orders):
        for _ in range(order):
            numbers = [Dual(one, _constant(one, float(k == place))) for k, one in enumerate(numbers)]
    known = dict(zip(quantity.variables, numbers, strict=True))

    def of(expression: sympy.Expr) -> Any:
        symbols = sorted(expression.free_symbols, key=str)
        return sympy.lambdify(symbols, expression, "math")(*(known[one] for one in symbols))

    arithmetic = Arithmetic(of, of, _sin, _cos, lambda x: 1.0 / x)
    result = ForwardKinematics(arithmetic, known).quantity(quantity)
    for _ in range(sum(orders)):
        result = result.slope if isinstance(result, Dual) else 0.0
    while isinstance(result, Dual):
        result = result.value
    return float(result or 0.0)


def _constant(like: Any, number: float) -> Any:
    """Return a number nested as another one."""
    return Dual(_constant(like.value, number), _constant(like.slope, 0.0)) if isinstance(like, Dual) else number
