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
    kind = number_type(precision)
    return np.array([kind(value) for value in values], dtype=object if precision == "arbitrary" else kind)


def compiled(arguments: list[sympy.Symbol], expressions: list[sympy.Expr], precision: str) -> Callable[..., list[Any]]:
    """Return a function of the arguments; its fractions and its pi are rounded in the precision asked for."""
    module = "mpmath" if precision == "arbitrary" else "numpy"
    constants = sorted(set().union(*(_inexact(entry) for entry in expressions)), key=sympy.default_sort_key)
    names = sympy.symbols(f"constant_:{len(constants)}")
    replaced = [entry.xreplace(dict(zip(constants, names, strict=True))) for entry in expressions]
    function = sympy.lambdify([*arguments, *names], replaced, modules=module, cse=True)
    values = [_rounded(constant, precision) for constant in constants]
    return lambda *given: function(*given, *values)


def solve(matrix: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Solve by Gauss elimination with row pivots, in whatever arithmetic the entries have."""
    a, b = matrix.copy(), right.copy()
    n = len(b)
    for k in range(n):
        pivot = k + int(np.argmax([abs(entry) for entry in a[k:, k]]))
        a[[k, pivot]], b[[k, pivot]] = a[[pivot, k]], b[[pivot, k]]
        factors = a[k + 1 :, k] / a[k, k]
        a[k + 1 :] -= factors[:, None] * a[k]
        b[k + 1 :] -= factors * b[k]
    for k in reversed(range(n)):
        b[k] = (b[k] - a[k, k + 1 :] @ b[k + 1 :]) / a[k, k]
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
