"""Lagrange's equations of a model by plain SymPy: what peers integrate, and what the reference is computed from.

    M a + A^T lambda = f,    A a = g                                                  (7), (8) differentiated

Nothing here is shared with the code generator: M_ij = d2T / dv_i dv_j, and f, g by differentiation along the motion.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import sympy

from ..arguments.names import Vector
from ..codegen.model import Model, t
from ..codegen.model.normalise import name_of
from .elimination import accelerations


@dataclass(frozen=True, slots=True)
class Classical:
    """The terms as SymPy expressions in plain symbols. n coordinates, m constraint rows.

    Attributes
    ----------
    x, v : (n,) coordinates and rates; time
    constants : parameters and inputs with their values
    M : (n, n); f : (n,) [J / u_i]; A : (m, n); g : (m,)
    """

    x: tuple[sympy.Symbol, ...]
    v: tuple[sympy.Symbol, ...]
    time: sympy.Symbol
    constants: tuple[tuple[sympy.Symbol, float], ...]
    M: tuple[tuple[sympy.Expr, ...], ...]
    f: tuple[sympy.Expr, ...]
    A: tuple[tuple[sympy.Expr, ...], ...]
    g: tuple[sympy.Expr, ...]

    @property
    def arguments(self) -> list[sympy.Symbol]:
        """Return x, v, time, in that order, then the constants."""
        return [*self.x, *self.v, self.time, *(symbol for symbol, _ in self.constants)]

    @property
    def entries(self) -> list[sympy.Expr]:
        """M, A row by row, then f and g."""
        return [entry for row in (*self.M, *self.A) for entry in row] + [*self.f, *self.g]

    def with_values(self, values: Mapping[str, float]) -> "Classical":
        """Return the same equations with other values of parameters and inputs."""
        return replace(self, constants=tuple((key, values.get(str(key), value)) for key, value in self.constants))

    def split(self, values: Sequence[Any]) -> tuple[list[Sequence[Any]], list[Sequence[Any]], Any, Any]:
        """Return M, A, f, g of a list in the order of `entries`."""
        n, m = len(self.x), len(self.g)
        rows = [values[k * n : (k + 1) * n] for k in range(n + m)]
        rest = values[(n + m) * n :]
        return rows[:n], rows[n:], rest[:n], rest[n:]


def classical(model: Model) -> Classical:
    """Differentiate T, V and the constraints of a model."""
    x, v, constants, plain = _symbols(model)
    time = sympy.Symbol("em_time")
    T, V = plain(model.kinetic_energy), plain(model.potential_energy)
    L, momenta = T - V, [T.diff(w) for w in v]
    holonomic = [plain(phi) for phi in model.holonomic_constraints]
    rows = [_along(phi, x, v, time) for phi in holonomic] + [plain(row) for row in model.nonholonomic_constraints]
    found = Classical(
        x, v, time, constants,
        M=tuple(tuple(p.diff(w) for w in v) for p in momenta),
        f=tuple(plain(Q) + L.diff(q) - _along(p, x, v, time) for q, p, Q in zip(x, momenta, model.forces, strict=True)),
        A=tuple(tuple(row.diff(w) for w in v) for row in rows),
        g=tuple(-_along(row, x, v, time) for row in rows),
    )  # fmt: skip
    return found if _has_inertia(found, model) else _with_rows(found)


def _has_inertia(equations: Classical, model: Model) -> bool:
    """Whether M is regular at the start."""
    function = sympy.lambdify(equations.arguments, equations.M, modules="math")
    values = [value for _, value in equations.constants]
    M = np.array(function(*model.initial_x, *model.initial_v, 0.0, *values), dtype=float)
    units = 1 / np.sqrt(np.where(np.diag(M) > 0, np.diag(M), 1.0))
    return not np.isfinite(M).all() or bool(np.linalg.matrix_rank(M * np.outer(units, units), 1e-11) == len(M))


def _with_rows(equations: Classical) -> Classical:
    """Add A^T A a = A^T g to the equations: where M is singular but not along the constraints, M + A^T A is regular."""
    M, A = sympy.Matrix(equations.M), sympy.Matrix(len(equations.g), len(equations.x), sum(equations.A, ()))
    f = sympy.Matrix(equations.f) + A.T * sympy.Matrix(len(equations.g), 1, equations.g)
    return replace(equations, M=tuple(map(tuple, (M + A.T * A).tolist())), f=tuple(f))


def _symbols(model: Model) -> tuple[Any, Any, Any, Callable[[sympy.Expr], sympy.Expr]]:
    """Return plain symbols, the constants' values, and the function that puts the symbols in."""
    x, v = (sympy.symbols(f"em_{letter}:{len(model.coordinates)}") for letter in "xv")
    u = [sympy.Symbol(name_of(signal)) for signal, _ in model.inputs]
    rates = dict(zip(model.rates, v, strict=True))
    others = dict(zip([*model.coordinates, *(name for name, _ in model.inputs), t], [*x, *u, sympy.Symbol("em_time")],
                      strict=True))  # fmt: skip
    values = [*model.parameters, *zip(u, (value for _, value in model.inputs), strict=True)]
    constants = tuple((symbol, float(value)) for symbol, value in values)
    return x, v, constants, lambda e: model.in_rates(sympy.sympify(e)).xreplace(rates).xreplace(others)


def _along(expression: sympy.Expr, x: Sequence[Any], v: Sequence[Any], time: sympy.Symbol) -> sympy.Expr:
    """Total derivative in time with constant velocities."""
    return sum((expression.diff(q) * w for q, w in zip(x, v, strict=True)), expression.diff(time))


def double(equations: Classical) -> Callable[[float, Vector], Vector]:
    """Return f(t, y) for y = (x, v): one lambdified function, one solve of the (n + m) system a call."""
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
    equations: Classical, functions: Mapping[str, Any], x: Sequence[Any], v: Sequence[Any], time: Any
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
