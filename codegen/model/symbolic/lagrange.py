"""Lagrange's equations of a model by differentiation in SymPy; generated code does not use them.

First-order states are symbols of their own here, not velocities of further coordinates as in generated code.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import sympy

from ..normalise import MULTIPLIER, name_of, t
from ..statement.mechanism import Mechanism

Rows = tuple[tuple[sympy.Expr, ...], ...]


@dataclass(frozen=True, slots=True)
class Lagrange:
    """M a + A^T lambda = f (11), A v + b = 0 (8), its time derivative A a = g, and zdot, in plain symbols.

    Attributes
    ----------
    x, v : (n,) coordinates and rates
    z : (p,) first-order states
    u : inputs
    multipliers : (m,) lambda
    time
    constants : parameters and inputs with their values
    M : (n, n) [J s^2 / (u_i u_j)]; f : (n,) [J / u_i]; A : (m, n); b, g : (m,)
    rates : (p,) zdot, which may contain multipliers
    """

    x: tuple[sympy.Symbol, ...]
    v: tuple[sympy.Symbol, ...]
    z: tuple[sympy.Symbol, ...]
    u: tuple[sympy.Symbol, ...]
    time: sympy.Symbol
    multipliers: tuple[sympy.Symbol, ...]
    constants: tuple[tuple[sympy.Symbol, float], ...]
    M: Rows
    f: tuple[sympy.Expr, ...]
    A: Rows
    b: tuple[sympy.Expr, ...]
    g: tuple[sympy.Expr, ...]
    rates: tuple[sympy.Expr, ...]

    @property
    def arguments(self) -> list[sympy.Symbol]:
        """Return x, v, z, time, in that order, then the constants."""
        return [*self.x, *self.v, *self.z, self.time, *(symbol for symbol, _ in self.constants)]

    @property
    def entries(self) -> list[sympy.Expr]:
        """M, A row by row, then f and g: without the rates of states."""
        return [entry for row in (*self.M, *self.A) for entry in row] + [*self.f, *self.g]

    def with_values(self, values: Mapping[str, float]) -> Lagrange:
        """Return the same equations with other values of parameters and inputs."""
        return replace(self, constants=tuple((key, values.get(str(key), value)) for key, value in self.constants))

    def split(self, values: Sequence[Any]) -> tuple[list[Sequence[Any]], list[Sequence[Any]], Any, Any]:
        """Return M, A, f, g of a list in the order of `entries`."""
        n, m = len(self.x), len(self.g)
        rows = [values[k * n : (k + 1) * n] for k in range(n + m)]
        rest = values[(n + m) * n :]
        return rows[:n], rows[n:], rest[:n], rest[n:]


def lagrange(model: Mechanism) -> Lagrange:
    """Derive Lagrange's equations from T, V and the constraints of a model.

    M_ij = d2T / dv_i dv_j; f = Q - dV/dx + dT/dx - (d2T / dv dx) v - d2T / dv dt; A and b are coefficients of the
    constraints as velocities, and g follows from their time derivatives. States do not act on constraints or T.
    """
    x, v, u, time = symbols(model)
    z, multipliers = (sympy.symbols(f"em_{letter}:{k}") for letter, k in (("z", len(model.states)), ("l", model.m)))
    plain = dict(zip(stated(model), (*x, *v, *u, time), strict=True))
    plain |= dict(zip((state for state, _ in model.states), z, strict=True))
    plain |= {MULTIPLIER(k): symbol for k, symbol in enumerate(multipliers)}

    def rate(expression: sympy.Expr) -> sympy.Expr:  # time derivative at constant velocities
        moving = (expression.diff(q) * w for q, w in zip(x, v, strict=True))
        return sympy.Add(*moving) + expression.diff(time)

    T, V, *others = (model.in_rates(sympy.sympify(one)).xreplace(plain) for one in (
        model.kinetic_energy, model.potential_energy, *model.forces, *model.holonomic_constraints,
        *model.nonholonomic_constraints, *(zdot for _, zdot in model.states)))  # fmt: skip
    rows_end = model.n + model.m
    forces, constraints, rates = others[: model.n], others[model.n : rows_end], others[rows_end:]
    momenta = [T.diff(w) for w in v]
    rows = [rate(phi) for phi in constraints[: model.h]] + constraints[model.h :]
    values = (*model.parameters, *zip(u, (value for _, value in model.inputs), strict=True))
    return Lagrange(
        x, v, z, u, time, multipliers, tuple((symbol, float(value)) for symbol, value in values),
        M=tuple(tuple(p.diff(w) for w in v) for p in momenta),
        f=tuple(Q - V.diff(q) + T.diff(q) - rate(p) for q, p, Q in zip(x, momenta, forces, strict=True)),
        A=tuple(tuple(row.diff(w) for w in v) for row in rows),
        b=tuple(row.xreplace(dict.fromkeys(v, sympy.S.Zero)) for row in rows),
        g=tuple(-rate(row) for row in rows),
        rates=tuple(rates),
    )  # fmt: skip


def stated(model: Mechanism) -> tuple[sympy.Expr, ...]:
    """Return coordinates, rates, inputs and time in the user's symbols."""
    return (*model.coordinates, *model.rates, *(signal for signal, _ in model.inputs), t)


def symbols(model: Mechanism) -> tuple[Any, Any, Any, sympy.Symbol]:
    """Return plain symbols for coordinates, rates, inputs and time."""
    x, v = (sympy.symbols(f"em_{letter}:{model.n}") for letter in "xv")
    return x, v, tuple(sympy.Symbol(name_of(signal)) for signal, _ in model.inputs), sympy.Symbol("em_time")
