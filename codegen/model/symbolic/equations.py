"""Equations of motion as SymPy matrices in the user's symbols, for display; generated code does not use them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import sympy

from ..normalise import MULTIPLIER, t
from ..statement.mechanism import Mechanism
from ..tree.functions import BodyFunction
from .expression_text import as_python, latex
from .lagrange import lagrange, stated

_MOST_EXPANDED = 700
_MOST_SIMPLIFIED = 110
"""Operation counts up to which SymPy expands in a few hundredths of a second, and simplifies within a second."""


@dataclass(frozen=True, slots=True)
class Equations:
    """M xddot + A^T lambda = bias (11), A xdot + b = 0 (8), and its time derivative A xddot + gamma = 0.

    x, v, a, multipliers : (n,), (n,), (n,), (m,) unknowns: x(t), its derivatives, lambda
    M : (n, n) [J s^2 / (u_i u_j)]
    bias : (n, 1) [J / u_i]
    A : (m, n); b, gamma : (m, 1)
    states : pairs z, zdot of first-order states
    """

    x: tuple[sympy.Expr, ...]
    multipliers: tuple[sympy.Expr, ...]
    M: sympy.ImmutableDenseMatrix
    bias: sympy.ImmutableDenseMatrix
    A: sympy.ImmutableDenseMatrix
    b: sympy.ImmutableDenseMatrix
    gamma: sympy.ImmutableDenseMatrix
    states: tuple[tuple[sympy.Expr, sympy.Expr], ...] = ()

    @property
    def v(self) -> tuple[sympy.Expr, ...]:
        """Velocities."""
        return tuple(x.diff(t) for x in self.x)

    @property
    def a(self) -> tuple[sympy.Expr, ...]:
        """Accelerations."""
        return tuple(x.diff(t, 2) for x in self.x)

    @property
    def parts(self) -> dict[str, sympy.ImmutableDenseMatrix]:
        """The matrices by name; those of constraints only where there are constraints."""
        parts = {"M": self.M, "bias": self.bias}
        return parts | ({"A": self.A, "b": self.b, "gamma": self.gamma} if self.A.rows else {})

    def latex(self) -> str:
        """Return the form of the equations and their matrices in LaTeX, as an `align*` environment."""
        names = {"M": "M", "bias": "h", "A": "A", "b": "b", "gamma": r"\gamma"}
        rows = [rf"{names[name]} &= {latex(part)}" for name, part in self.parts.items()]
        rows += [rf"{left} &= {right}" for left, right in self.state_form]
        return (
            "\\begin{align*}\n"
            + " \\\\\n".join([rf"{left} &= {right}" for left, right in self.form] + rows)
            + ("\n\\end{align*}")
        )

    @property
    def form(self) -> tuple[tuple[str, str], ...]:
        """Left and right sides of the equations, in LaTeX."""
        if not self.A.rows:
            return ((r"M \ddot{x}", "h"),)
        return ((r"M \ddot{x} + A^T \lambda", "h"), (r"A \dot{x} + b", "0"), (r"A \ddot{x} + \gamma", "0"))

    @property
    def state_form(self) -> tuple[tuple[str, str], ...]:
        """Left and right sides of the rates of states, in LaTeX."""
        return tuple((latex(z.diff(t)), latex(rate)) for z, rate in self.states)

    def source(self) -> str:
        """Return Python source that defines these matrices."""
        return as_python(self.parts)

    def _repr_latex_(self) -> str:
        return f"$${self.latex().replace('align*', 'aligned')}$$"


def equations_of(model: Mechanism) -> Equations:
    """Return Lagrange's equations of a model, simplified where that is fast."""
    terms, n, m = lagrange(model), model.n, model.m
    back = dict(zip((*terms.x, *terms.v, *terms.u, terms.time), stated(model), strict=True))

    def matrix(rows: int, columns: int, entries: Iterable[sympy.Expr]) -> sympy.ImmutableDenseMatrix:
        return sympy.ImmutableDenseMatrix(rows, columns, [simplified(entry).xreplace(back) for entry in entries])

    return Equations(
        model.coordinates, tuple(MULTIPLIER(sympy.Integer(row)) for row in range(m)),
        matrix(n, n, sum(terms.M, ())), matrix(n, 1, terms.f), matrix(m, n, sum(terms.A, ())), matrix(m, 1, terms.b),
        matrix(m, 1, (-g for g in terms.g)), tuple((z, simplified(rate)) for z, rate in model.states),
    )  # fmt: skip


def simplified(expression: sympy.Expr) -> sympy.Expr:
    """Return the shortest of an expression and those of its expanded, simplified and factored forms found fast."""
    if expression.has(BodyFunction):  # opaque: trigsimp would factor polynomials in dozens of them, for minutes
        return expression
    forms = [expression]
    if sympy.count_ops(expression) <= _MOST_EXPANDED:
        forms.append(sympy.expand(expression))
    if sympy.count_ops(forms[-1]) <= _MOST_SIMPLIFIED:
        forms.append(sympy.trigsimp(forms[-1]))
    return min((*forms, *map(sympy.factor_terms, forms[1:])), key=_length)


def _length(expression: sympy.Expr) -> tuple[int, str]:
    return sympy.count_ops(expression), str(expression)
