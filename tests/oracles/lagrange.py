"""Lagrange's equations (7) by differentiation in time, for any model: no mass matrix is ever formed by hand.

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
        self.n, self.m = len(model.coordinates), len(model.holonomic_constraints) + len(model.nonholonomic_constraints)
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
        x, v, a = ([self._plain[q.diff(t, k)] for q in model.coordinates] for k in range(3))
        L = self._replaced(model.kinetic_energy) - self._replaced(model.potential_energy)
        residual = [
            self._rate(L.diff(w)) - L.diff(q) - self._replaced(Q) for q, w, Q in zip(x, v, model.forces, strict=True)
        ]
        rows = [self._rate(self._replaced(phi)) for phi in model.holonomic_constraints]
        rows = [self._rate(row) for row in (*rows, *map(self._replaced, model.nonholonomic_constraints))]
        A = [row.diff(w) for row in rows for w in a]
        residual, rows, A = ([_away_from_jumps(entry) for entry in entries] for entries in (residual, rows, A))
        return residual, rows, A

    def _rate(self, expression: sympy.Expr) -> sympy.Expr:
        """d/dt of what holds plain symbols, by the chain rule: of functions of time SymPy takes twice as long."""
        coordinates = self.model.coordinates
        pairs = [(self._plain[q.diff(t, k)], self._plain[q.diff(t, k + 1)]) for q in coordinates for k in (0, 1)]
        return sum((expression.diff(one) * its_rate for one, its_rate in pairs), expression.diff(self._plain[t]))

    def _replaced(self, expression: sympy.Expr) -> sympy.Expr:
        """Plain symbols for functions of time and their derivatives, the highest first."""
        return _in_rates(self.model, sympy.sympify(expression)).doit().xreplace(self._plain)


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
    x = {q: sympy.Symbol(f"x_{name}", real=True) for q, name in zip(model.coordinates, names, strict=True)}
    v = {q.diff(t): sympy.Symbol(f"v_{name}", real=True) for q, name in zip(model.coordinates, names, strict=True)}
    a = {q.diff(t, 2): sympy.Symbol(f"a_{name}", real=True) for q, name in zip(model.coordinates, names, strict=True)}
    u = {q: sympy.Symbol(f"u_{q.func.__name__}", real=True) for q, _ in model.inputs}
    return x | v | u | {t: sympy.Symbol("time", real=True)} | a


def _in_rates(model: Model, expression: sympy.Expr) -> sympy.Expr:
    """The expression with the quasi-velocities written out (3)."""
    return expression.subs(list(model.quasi_velocities)).doit() if expression.has(AppliedUndef) else expression
