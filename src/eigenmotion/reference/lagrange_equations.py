"""Lagrange's equations of a model by plain SymPy, for peers and for the reference.

    M a + A^T lambda = f,    A a = g                                                  (7), (8) differentiated

Right-hand sides are those of y = (x, v, z), with the first-order states z last.
The code generator does not use these expressions.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import sympy

from ..arguments.named_values import Vector
from ..codegen.model import Model
from ..codegen.model.symbolic.lagrange import Lagrange, lagrange
from .elimination import accelerations


def classical(model: Model) -> Lagrange:
    """Return Lagrange's equations of a model, with a regular M."""
    equations = lagrange(model)
    return equations if _has_inertia(equations, model) else _with_rows(equations)


def _has_inertia(equations: Lagrange, model: Model) -> bool:
    """Return whether M is regular at the start."""
    function = sympy.lambdify(equations.arguments, equations.M, modules="math")
    values = [value for _, value in equations.constants]
    states = [0.0] * len(equations.z)  # M does not contain them
    M = np.array(function(*model.initial_x, *model.initial_v, *states, 0.0, *values), dtype=float)
    units = 1 / np.sqrt(np.where(np.diag(M) > 0, np.diag(M), 1.0))
    return not np.isfinite(M).all() or bool(np.linalg.matrix_rank(M * np.outer(units, units), 1e-11) == len(M))


def _with_rows(equations: Lagrange) -> Lagrange:
    """Add A^T A a = A^T g to the equations: M + A^T A is regular if M is regular along the constraints."""
    M, A = sympy.Matrix(equations.M), sympy.Matrix(len(equations.g), len(equations.x), sum(equations.A, ()))
    f = sympy.Matrix(equations.f) + A.T * sympy.Matrix(len(equations.g), 1, equations.g)
    return replace(equations, M=tuple(map(tuple, (M + A.T * A).tolist())), f=tuple(f))


def double(equations: Lagrange) -> Callable[[float, Vector], Vector]:
    """Return f(t, y): each call evaluates one lambdified function, or two with states, and solves one system."""
    n, m, states = len(equations.x), len(equations.g), len(equations.z)
    function = sympy.lambdify(equations.arguments, equations.entries, modules="math", cse=True)
    rates = sympy.lambdify([*equations.arguments, *equations.multipliers], equations.rates, modules="math", cse=True)
    constants = [value for _, value in equations.constants]

    def rhs(time: float, y: Vector) -> Vector:
        given = (*y.tolist(), time, *constants)
        values = np.array(function(*given), dtype=np.float64)
        K, right = np.zeros((n + m, n + m)), values[(n + m) * n :]
        K[:, :n] = values[: (n + m) * n].reshape(n + m, n)
        K[:n, n:] = K[n:, :n].T
        solved = np.linalg.solve(K, right)
        return np.concatenate([y[n : 2 * n], solved[:n], rates(*given, *solved[n:].tolist()) if states else ()])

    return rhs


def explicit(equations: Lagrange, functions: Mapping[str, Any], y: Sequence[Any], time: Any) -> list[Any]:
    """Return the rates of y in another algebra: its variables y, time, and its functions by SymPy's names.

    Raises
    ------
    NameError, TypeError, ...
        The algebra lacks a function of the model.
    """
    module = {"pi": np.pi, "E": np.e, **functions}
    function = sympy.lambdify(equations.arguments, equations.entries, modules=[module], cse=True)
    rates = sympy.lambdify([*equations.arguments, *equations.multipliers], equations.rates, modules=[module], cse=True)
    given, n = (*y, time, *(value for _, value in equations.constants)), len(equations.x)
    a, multipliers = accelerations(*equations.split(function(*given)))
    return [*y[n : 2 * n], *a, *(rates(*given, *multipliers) if equations.rates else ())]
