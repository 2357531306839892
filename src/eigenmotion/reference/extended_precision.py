"""Right-hand side of Lagrange's equations in extended precision.

The numbers are np.longdouble: 64 bits of mantissa on x86, 113 on platforms with quadruple precision, and double
precision on platforms with neither.
"""

from collections.abc import Callable, Sequence
from itertools import chain
from typing import Any

import numpy as np
import sympy
from numpy.typing import NDArray

from ..codegen.model.symbolic.lagrange import Lagrange
from .elimination import accelerations
from .straight_line import straight_line_function

Extended = NDArray[np.longdouble]
Rhs = Callable[[Any, Extended], Extended]
EPSILON = float(np.finfo(np.longdouble).eps)


def extended(equations: Lagrange) -> Rhs:
    """Return f(t, y), y = (x, v, z), with every constant rounded in extended precision."""
    numbers = sorted(_inexact([*equations.entries, *equations.rates]), key=sympy.default_sort_key)
    names = sympy.symbols(f"em_c:{len(numbers)}")
    named = dict(zip(numbers, names, strict=True))
    entries, rates = ([e.xreplace(named) for e in part] for part in (equations.entries, equations.rates))
    function = sympy.lambdify([*equations.arguments, *names], entries, modules="numpy", cse=True)
    zdot = sympy.lambdify([*equations.arguments, *names, *equations.multipliers], rates, modules="numpy", cse=True)
    constants = [np.longdouble(value) for _, value in equations.constants] + [_rounded(number) for number in numbers]
    zeros = [entry.is_zero is True for entry in entries]
    solved = straight_line_function(lambda values: list(chain(*accelerations(*equations.split(values)))), zeros)
    n = len(equations.x)

    def rhs(time: Any, y: Extended) -> Extended:
        given = (*y, time, *constants)
        results = solved(function(*given))
        of_states = zdot(*given, *results[n:]) if rates else ()
        return np.array([*y[n : 2 * n], *results[:n], *of_states], dtype=np.longdouble)

    return rhs


def _inexact(entries: Sequence[sympy.Expr]) -> set[sympy.Expr]:
    """Return the fractions, and numbers like pi, that are not exact in double precision."""
    fractions = {q for entry in entries for q in entry.atoms(sympy.Rational) if q.q & (q.q - 1)}
    return fractions | {c for entry in entries for c in entry.atoms(sympy.NumberSymbol)}


def _rounded(number: sympy.Expr) -> np.longdouble:
    return np.longdouble(str(number.evalf(40)))
