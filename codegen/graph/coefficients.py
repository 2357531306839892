"""Arithmetic of coefficients and exponents: exact for integers and fractions, floating point otherwise."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import gcd, lcm

Number = int | Fraction | float


def exact(numerator: int, denominator: int = 1) -> Number:
    """Return a quotient of integers, as an int where it is whole, since int is faster than Fraction."""
    return numerator // denominator if numerator % denominator == 0 else Fraction(numerator, denominator)


def ratio(first: Number, second: Number) -> Number:
    """Return first / second, exactly unless one of them is a floating-point number."""
    if second == 1:
        return first
    if second == -1:
        return -first
    if isinstance(first, int) and isinstance(second, int):
        return exact(first, second)
    if isinstance(first, float) or isinstance(second, float):
        return float(first) / float(second)
    return exact(first.numerator * second.denominator, first.denominator * second.numerator)


def magnitude(number: Number) -> Number:
    """Return |number|."""
    return -number if number < 0 else number


def is_whole(number: Number) -> bool:
    """Whether a number is an integer."""
    return isinstance(number, int) or number == int(number)


def whole_power(base: Number, exponent: int) -> Number:
    """Return base^exponent, exactly unless base is a floating-point number."""
    if isinstance(base, float):
        return base**exponent
    if exponent == 1:
        return exact(base.numerator, base.denominator)
    power = Fraction(base) ** exponent
    return exact(power.numerator, power.denominator)


def content(numbers: Sequence[Number]) -> Number:
    """Return the divisor that makes the numbers coprime integers, or all of them +-1, with a positive first one."""
    first = numbers[0]
    sign = -1 if first < 0 else 1
    if all(abs(number) == abs(first) for number in numbers):
        return first
    rational = [number for number in numbers if not isinstance(number, float)]
    if len(rational) < len(numbers):
        return sign
    return exact(sign * gcd(*(f.numerator for f in rational)), lcm(*(f.denominator for f in rational)))
