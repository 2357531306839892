"""Values and derivatives of expression trees in mpmath's complex numbers, on principal branches as in SymPy.

A tree is a tuple (operation, operand, ...): a symbol ("symbol", name), a number ("number", value), a power with a fixed
exponent ("power", base, exponent), else a function of trees. Derivatives by dual numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

import mpmath

Tree = tuple[Any, ...]
HAIR = mpmath.mpf(10) ** -30
"""Nearer than this an order is rounding's: of 50 digits, sqrt(2)^2 - 2 leaves 1e-50."""


class Undefined(ArithmeticError):
    """The tree has no value, or no derivative, at this point."""


class Dual:
    """value, slope : complex; real : whether all was real on the way there, so that real arithmetic can follow."""

    def __init__(self, value: Any, slope: Any = 0, real: bool = True) -> None:
        self.value, self.slope = mpmath.mpc(value), mpmath.mpc(slope)
        self.real = real and self.value.imag == 0 and self.slope.imag == 0
        if not (mpmath.isfinite(self.value) and mpmath.isfinite(self.slope)):
            raise Undefined

    def on_the_line(self) -> Any:
        """Return the value where an order matters."""
        if not self.real:
            raise Undefined
        return self.value.real


def number(value: Any) -> Any:
    """Return a fraction or a double in mpmath's precision."""
    return mpmath.mpf(value.numerator) / value.denominator if isinstance(value, Fraction) else mpmath.mpf(value)


def dual(tree: Tree, point: Mapping[str, float], direction: str = "") -> Dual:
    """Return value and derivative along one symbol.

    Raises
    ------
    Undefined
        A division by zero, an order of complex numbers, a kink.
    """
    name, *operands = tree
    if name == "number":
        return Dual(number(operands[0]))
    if name == "symbol":
        return Dual(point[operands[0]], operands[0] == direction)
    try:
        if name == "power":
            return _power(dual(operands[0], point, direction), operands[1])
        if name == "piecewise":
            return _piecewise(operands, point, direction)
        return OPERATIONS[name](*(dual(operand, point, direction) for operand in operands))
    except (ZeroDivisionError, ValueError, OverflowError) as error:
        raise Undefined from error


def _power(base: Dual, exponent: Any) -> Dual:
    e = number(exponent)
    if base.value == 0 and e.real < 1:
        raise Undefined
    value = base.value ** (int(e) if e == int(e) else e)
    slope = e * value / base.value * base.slope if base.value != 0 else (base.slope if e == 1 else 0)
    return Dual(value, slope, base.real)


def _meet(a: Any, b: Any) -> bool:
    return bool(abs(a - b) <= HAIR * max(1, abs(a), abs(b)))


def _piecewise(operands: list[Any], point: Mapping[str, float], direction: str) -> Dual:
    """("piecewise", relation, left, right, then, otherwise); otherwise may be missing (None)."""
    relation, left, right, then, otherwise = operands
    a, b = (dual(side, point, direction).on_the_line() for side in (left, right))
    if a != b and _meet(a, b):
        raise Undefined
    chosen = then if {"<": a < b, "<=": a <= b, ">": a > b, ">=": a >= b}[relation] else otherwise
    if chosen is None:
        raise Undefined
    return dual(chosen, point, direction)


def _sum(*terms: Dual) -> Dual:
    return Dual(sum(t.value for t in terms), sum(t.slope for t in terms), all(t.real for t in terms))


def _product(*factors: Dual) -> Dual:
    result = factors[0]
    for f in factors[1:]:
        slope = result.value * f.slope + result.slope * f.value
        result = Dual(result.value * f.value, slope, result.real and f.real)
    return result


def _analytic(f: Callable[[Any], Any], slope: Callable[[Any, Any], Any]) -> Callable[[Dual], Dual]:
    """A function on the real line; what it is elsewhere is not asked."""

    def applied(a: Dual) -> Dual:
        at = a.on_the_line()
        value = f(at)
        return Dual(value, slope(at, value) * a.slope if a.slope != 0 else 0)

    return applied


def _stepped(f: Callable[[Any], Any], at_jump: Callable[[Any], bool]) -> Callable[[Dual], Dual]:
    def applied(a: Dual) -> Dual:
        if at_jump(a.on_the_line()):
            raise Undefined
        return Dual(f(a.value.real))

    return applied


def _chosen(wanted: Callable[[Any, Any], bool]) -> Callable[[Dual, Dual], Dual]:
    def applied(a: Dual, b: Dual) -> Dual:
        if _meet(a.on_the_line(), b.on_the_line()) and a.slope != b.slope:
            raise Undefined
        return a if wanted(a.value.real, b.value.real) else b

    return applied


def _abs(a: Dual) -> Dual:
    if _meet(a.on_the_line(), 0):
        raise Undefined
    return a if a.value.real > 0 else Dual(-a.value, -a.slope)


def _log(a: Dual) -> Dual:
    """On both half-lines: SymPy knows log of a negative number, C does not."""
    return Dual(mpmath.log(a.value), a.slope / a.value, a.real)


def _atan2(a: Dual, b: Dual) -> Dual:
    y, x = a.on_the_line(), b.on_the_line()
    return Dual(mpmath.atan2(y, x), (x * a.slope - y * b.slope) / (x * x + y * y))


def _general_power(a: Dual, b: Dual) -> Dual:
    if a.value == 0:
        raise Undefined
    value = mpmath.exp(b.value * mpmath.log(a.value)) if a.value.imag or a.value.real < 0 else a.value**b.value
    slope = value * b.value / a.value * a.slope
    if b.slope != 0:
        slope += value * mpmath.log(a.value) * b.slope
    return Dual(value, slope, a.real and b.real)


OPERATIONS: Mapping[str, Callable[..., Dual]] = {
    "add": _sum, "mul": _product, "atan2": _atan2, "abs": _abs, "log": _log, "pow": _general_power,
    "min": _chosen(lambda a, b: a <= b), "max": _chosen(lambda a, b: a >= b),
    "sin": _analytic(mpmath.sin, lambda a, f: mpmath.cos(a)), "cos": _analytic(mpmath.cos, lambda a, f: -mpmath.sin(a)),
    "tan": _analytic(mpmath.tan, lambda a, f: 1 + f * f), "atan": _analytic(mpmath.atan, lambda a, f: 1 / (1 + a * a)),
    "tanh": _analytic(mpmath.tanh, lambda a, f: 1 - f * f), "exp": _analytic(mpmath.exp, lambda a, f: f),
    "asinh": _analytic(mpmath.asinh, lambda a, f: 1 / mpmath.sqrt(1 + a * a)),
    "sign": _stepped(mpmath.sign, lambda a: _meet(a, 0)),
    "floor": _stepped(mpmath.floor, lambda a: _meet(a, mpmath.nint(a))),
    "step": _stepped(lambda a: a > 0, lambda a: _meet(a, 0)),
}  # fmt: skip
