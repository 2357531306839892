"""Lagrange's equations of a model by plain SymPy, for peers and for the reference.

    M a + A^T lambda = f,    A a = g                                                  (7), (8) differentiated

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
    M = np.array(function(*model.initial_x, *model.initial_v, 0.0, *values), dtype=float)
    units = 1 / np.sqrt(np.where(np.diag(M) > 0, np.diag(M), 1.0))
    return not np.isfinite(M).all() or bool(np.linalg.matrix_rank(M * np.outer(units, units), 1e-11) == len(M))


def _with_rows(equations: Lagrange) -> Lagrange:
    """Add A^T A a = A^T g to the equations: M + A^T A is regular if M is regular along the constraints."""
    M, A = sympy.Matrix(equations.M), sympy.Matrix(len(equations.g), len(equations.x), sum(equations.A, ()))
    f = sympy.Matrix(equations.f) + A.T * sympy.Matrix(len(equations.g), 1, equations.g)
    return replace(equations, M=tuple(map(tuple, (M + A.T * A).tolist())), f=tuple(f))


def double(equations: Lagrange) -> Callable[[float, Vector], Vector]:
    """Return f(t, y) for y = (x, v): each call evaluates one lambdified function and solves one (n + m) system."""
    n, m = len(equations.x), len(equations.g)
    function = sympy.lambdify(equations.arguments, equations.entries, modules="math", cse=True)
    constants = [value for _, value in equations.constants]

    def rhs(time: float, y: Vector) -> Vector:
        values = np.array(function(*y.tolist(), time, *constants), dtype=np.float64)
        K, right = np.zeros((n + m, n + m)), values[(n + m) * n :]
        K[:, :n] = values[: (n + m) * n].reshape(n + m, n)
        K[:n, n:] = K[n:, :n].T
        return np.concatenate([y[n:], np.linalg.solve(K, right)[:n]])

    return rhs


def explicit(
    equations: Lagrange, functions: Mapping[str, Any], x: Sequence[Any], v: Sequence[Any], time: Any
) -> list[Any]:
    """Return the accelerations in another algebra: its variables x, v, time, and its functions by SymPy's names.

    Raises
    ------
    NameError, TypeError, ...
        The algebra lacks a function of the model.
    """
    module = {"pi": np.pi, "E": np.e, **functions}
    function = sympy.lambdify(equations.arguments, equations.entries, modules=[module], cse=True)
    return accelerations(*equations.split(function(*x, *v, time, *(value for _, value in equations.constants))))
