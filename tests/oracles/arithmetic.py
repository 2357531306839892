"""Vectors in double, extended (np.longdouble) or arbitrary precision (mpmath numbers in object arrays)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np
import sympy

FUNCTIONS = {"double": np.float64, "extended": np.longdouble, "arbitrary": mpmath.mpf}


def number_type(precision: str) -> Callable[[Any], Any]:
    """Return the type of a number: "double", "extended", or "arbitrary" with the digits of mpmath.mp."""
    return FUNCTIONS[precision]


def array(values: Any, precision: str) -> np.ndarray:
    """Return a vector of numbers of this precision."""
    return np.array(numbers(values, precision), dtype=object if precision == "arbitrary" else number_type(precision))


def numbers(values: Any, precision: str) -> list[Any]:
    """Return values as numbers of this precision."""
    kind = number_type(precision)
    return [value if type(value) is kind else kind(value) for value in values]


def compiled(arguments: list[sympy.Symbol], expressions: list[sympy.Expr], precision: str) -> Callable[..., list[Any]]:
    """Return a function of the arguments; its fractions and its pi are rounded in the precision asked for."""
    module = "mpmath" if precision == "arbitrary" else "numpy"
    constants = sorted(set().union(*(_inexact(entry) for entry in expressions)), key=sympy.default_sort_key)
    names = sympy.symbols(f"constant_:{len(constants)}")
    replaced = [entry.xreplace(dict(zip(constants, names, strict=True))) for entry in expressions]
    function = sympy.lambdify([*arguments, *names], replaced, modules=module, cse=True)
    values = [_rounded(constant, precision) for constant in constants]
    return lambda *given: function(*given, *values)


def solve(matrix: Any, right: Any) -> list[Any]:
    """Solve by Gauss elimination with row pivots, in whatever arithmetic the entries have.

    Number by number: of a few rows that is several times as quick as array by array.
    """
    a, b = [list(row) for row in matrix], list(right)
    n = len(b)
    for k in range(n):
        pivot = max(range(k, n), key=lambda row: abs(a[row][k]))
        a[k], a[pivot], b[k], b[pivot] = a[pivot], a[k], b[pivot], b[k]
        top = a[k]
        for i in range(k + 1, n):
            row, factor = a[i], a[i][k] / top[k]
            for j in range(k + 1, n):
                row[j] -= factor * top[j]
            b[i] -= factor * b[k]
    for k in reversed(range(n)):
        for j in range(k + 1, n):
            b[k] -= a[k][j] * b[j]
        b[k] /= a[k][k]
    return b


def _inexact(expression: sympy.Expr) -> set[sympy.Expr]:
    """Numbers that no double holds, but for exponents, which SymPy prints in their own way."""
    exponents = {power.exp for power in expression.atoms(sympy.Pow)}
    fractions = {q for q in expression.atoms(sympy.Rational) if q.q & (q.q - 1)}
    return (fractions | expression.atoms(sympy.NumberSymbol)) - exponents


def _rounded(constant: sympy.Expr, precision: str) -> Any:
    if constant.is_Rational:
        kind = number_type(precision)
        return kind(int(constant.p)) / kind(int(constant.q))
    digits = mpmath.mp.dps if precision == "arbitrary" else 25
    return number_type(precision)(str(constant.evalf(digits)))
