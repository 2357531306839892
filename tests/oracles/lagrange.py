"""Lagrange's equations (7) by plain differentiation in time, for any model: no mass matrix is ever formed by hand.

The residual d/dt (dL/dxdot) - dL/dx - Q + A^T lambda and the constraints' derivatives are linear in the accelerations
and multipliers; their coefficients are read off by differentiation, and the system is solved with numbers.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from eigenmotion import Model, t

from .arithmetic import array, compiled, numbers, solve


class Lagrange:
    """Accelerations and multipliers of a model, in the precision asked for (see `arithmetic`)."""

    def __init__(self, model: Model, precision: str = "double") -> None:
        self.model, self.precision = model, precision
        self.n, self.m = len(model.coordinates), len(_rows(model))
        self._plain = _plain_symbols(model)
        residual, rows, A = self._equations()
        self._parameters = {str(symbol): value for symbol, value in model.parameters}
        self._inputs = {u.func.__name__: value for u, value in model.inputs}
        self._own = [numbers(own.values(), precision) for own in (self._inputs, self._parameters)]
        arguments = [*self._plain.values(), *(symbol for symbol, _ in model.parameters)]
        rates_only = [symbol for name, symbol in self._plain.items() if name not in self._second()]
        accelerations = [self._plain[a] for a in self._second()]
        at_rest = dict.fromkeys(accelerations, sympy.Integer(0))
        M = [entry.diff(a) for entry in residual for a in accelerations]
        forces = [-entry.xreplace(at_rest) for entry in residual]
        drift = [-entry.xreplace(at_rest) for entry in rows]
        kept = [*rates_only, *arguments[len(self._plain) :]]
        self._function = compiled(kept, [*M, *forces, *drift, *A], precision)

    def __call__(
        self,
        x: Iterable[Any],
        v: Iterable[Any],
        time: Any = 0.0,
        parameters: Mapping[str, float] | None = None,
        inputs: Mapping[str, float] | None = None,
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return xddot (n,) and lambda (m,) of (7) and the derivative of (8)."""
        n, m = self.n, self.m
        values = numbers(self._function(*self._arguments(x, v, time, parameters, inputs)), self.precision)
        forces, A = n * n, n * n + n + m
        rows = [values[A + k * n : A + (k + 1) * n] for k in range(m)]
        zeros = numbers([0] * m, self.precision)
        matrix = [values[k * n : (k + 1) * n] + [row[k] for row in rows] for k in range(n)] + [r + zeros for r in rows]
        solution = solve(matrix, values[forces:A])
        return array(solution[:n], self.precision), array(solution[n:], self.precision)

    def _arguments(self, x: Any, v: Any, time: Any, parameters: Any, inputs: Any) -> list[Any]:
        if not (parameters or inputs):
            return [*numbers([*x, *v], self.precision), *self._own[0], *numbers([time], self.precision), *self._own[1]]
        p, u = self._parameters | dict(parameters or {}), self._inputs | dict(inputs or {})
        return numbers([*x, *v, *u.values(), time, *(p[name] for name in self._parameters)], self.precision)

    def _second(self) -> list[sympy.Expr]:
        return [x.diff(t, 2) for x in self.model.coordinates]

    def _equations(self) -> tuple[list[sympy.Expr], list[sympy.Expr], list[sympy.Expr]]:
        """Residual of (7) without A^T lambda, rows differentiated until they hold accelerations, and A row by row."""
        model = self.model
        L = _in_rates(model, model.kinetic_energy) - model.potential_energy
        residual = [
            L.diff(x.diff(t)).diff(t) - L.diff(x) - _in_rates(model, Q)
            for x, Q in zip(model.coordinates, model.forces, strict=True)
        ]
        rows = [row.diff(t) for row in _rows(model)]
        A = [row.diff(a) for row in rows for a in self._second()]
        return self._replaced(residual), self._replaced(rows), self._replaced(A)

    def _replaced(self, expressions: list[sympy.Expr]) -> list[sympy.Expr]:
        """Plain symbols for functions of time and their derivatives, the highest first."""
        return [_away_from_jumps(entry.doit()).xreplace(self._plain) for entry in expressions]


def _away_from_jumps(expression: sympy.Expr) -> sympy.Expr:
    """Zero for the derivatives of steps, which SymPy carries along."""
    jumps = [
        *expression.atoms(sympy.DiracDelta),
        *(d for d in expression.atoms(sympy.Derivative) if d.expr.has(sympy.sign)),
    ]
    return expression.xreplace(dict.fromkeys(jumps, sympy.Integer(0)))


def _plain_symbols(model: Model) -> dict[sympy.Expr, sympy.Symbol]:
    """What a state consists of -> plain symbols, in the order of the arguments; the accelerations come last."""
    names = [x.func.__name__ for x in model.coordinates]
    x = {q: sympy.Symbol(f"x_{name}") for q, name in zip(model.coordinates, names, strict=True)}
    v = {q.diff(t): sympy.Symbol(f"v_{name}") for q, name in zip(model.coordinates, names, strict=True)}
    a = {q.diff(t, 2): sympy.Symbol(f"a_{name}") for q, name in zip(model.coordinates, names, strict=True)}
    u = {q: sympy.Symbol(f"u_{q.func.__name__}") for q, _ in model.inputs}
    return x | v | u | {t: sympy.Symbol("time")} | a


def _in_rates(model: Model, expression: sympy.Expr) -> sympy.Expr:
    """The expression with the quasi-velocities written out (3)."""
    return expression.subs(list(model.quasi_velocities)).doit() if expression.has(AppliedUndef) else expression


def _rows(model: Model) -> list[sympy.Expr]:
    """Constraint rows on the velocity level (8), holonomic ones first."""
    holonomic = [phi.diff(t) for phi in model.holonomic_constraints]
    return holonomic + [_in_rates(model, row) for row in model.nonholonomic_constraints]
