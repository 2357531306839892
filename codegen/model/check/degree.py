"""Polynomial degree of an expression in given symbols, determined without expansion where possible."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import sympy
from sympy.functions.elementary.piecewise import ExprCondPair

from ..tree.functions import BodyFunction

if TYPE_CHECKING:
    from collections.abc import Iterable


def has_degree(expression: sympy.Expr, symbols: Iterable[sympy.Expr], degree: int) -> bool:
    """Whether an expression is a polynomial of at most this degree in the symbols.

    The sum of the degrees of its factors is an upper bound of a product's degree. The expression is expanded only where
    that bound exceeds `degree`, since terms may cancel.
    """
    variables = frozenset(symbols)
    if _bound(expression, variables, {}) <= degree:
        return True
    plain = {symbol: sympy.Dummy() for symbol in variables}
    try:
        polynomial = sympy.Poly(sympy.expand(expression.xreplace(plain)), *plain.values())
    except sympy.PolynomialError:
        return False
    return bool(polynomial.total_degree() <= degree)


def _bound(expression: sympy.Expr, symbols: frozenset[sympy.Expr], known: dict[sympy.Expr, float]) -> float:
    """Return an upper bound of the degree; infinity where the expression may not be a polynomial."""
    if expression in known:
        return known[expression]
    parts = [] if expression in symbols else [_bound(part, symbols, known) for part in expression.args]
    known[expression] = degree = _combined(expression, parts, expression in symbols)
    return degree


def _combined(expression: sympy.Expr, parts: list[float], is_symbol: bool) -> float:
    if is_symbol:
        return 1
    if isinstance(expression, sympy.Derivative) or not any(parts):
        return 0
    if expression.is_Add:
        return max(parts)
    if expression.is_Mul:
        return sum(parts)
    if expression.is_Pow and expression.exp.is_Integer and expression.exp.is_positive:
        return parts[0] * int(expression.exp)
    if isinstance(expression, BodyFunction):
        return expression.degree_in_rates() if max(parts) == 1 else math.inf
    if isinstance(expression, sympy.Piecewise):
        return max(parts)
    if isinstance(expression, ExprCondPair):
        value, condition = parts
        return value if condition == 0 else math.inf
    return math.inf
