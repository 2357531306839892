"""The equations of motion of a model as SymPy matrices, in the user's symbols. Nothing generated comes of them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import sympy

from .mechanism import Mechanism
from .normalise import MULTIPLIER, t
from .writing import as_python, latex

_SOON_EXPANDED = 700
_SOON_SIMPLIFIED = 110
"""Operations of an expression that SymPy expands in a few hundredths of a second, and simplifies within one."""


@dataclass(frozen=True, slots=True)
class Equations:
    """M xddot + A^T lambda = bias (11), A xdot + b = 0 (8), and that differentiated, A xddot + gamma = 0.

    x, v, a, multipliers : (n,), (n,), (n,), (m,) what the equations are in: x(t) and its derivatives, lambda
    M : (n, n) [J s^2 / (u_i u_j)]
    bias : (n, 1) [J / u_i]
    A : (m, n); b, gamma : (m, 1)
    """

    x: tuple[sympy.Expr, ...]
    multipliers: tuple[sympy.Expr, ...]
    M: sympy.ImmutableDenseMatrix
    bias: sympy.ImmutableDenseMatrix
    A: sympy.ImmutableDenseMatrix
    b: sympy.ImmutableDenseMatrix
    gamma: sympy.ImmutableDenseMatrix

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
        """The matrices by name, without those of constraints where there are none."""
        parts = {"M": self.M, "bias": self.bias}
        return parts | ({"A": self.A, "b": self.b, "gamma": self.gamma} if self.A.rows else {})

    def latex(self) -> str:
        """Return LaTeX: the form of the equations, and below what stands in it, ready for an `align*`."""
        names = {"M": "M", "bias": "h", "A": "A", "b": "b", "gamma": r"\gamma"}
        rows = [rf"{names[name]} &= {latex(part)}" for name, part in self.parts.items()]
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

    def source(self) -> str:
        """Return Python that makes these matrices."""
        return as_python(self.parts)

    def _repr_latex_(self) -> str:
        return f"$${self.latex().replace('align*', 'aligned')}$$"


def equations_of(model: Mechanism) -> Equations:
    """Return Lagrange's equations of a model, simplified where that is quick.

    M_ij = d2T / dv_i dv_j; bias = Q - dV/dx + dT/dx - (d2T / dv dx) v - d2T / dv dt; rows and their rates as stated.
    """
    plain = _Plain(model)
    T, V = plain(model.kinetic_energy), plain(model.potential_energy)
    momenta = [T.diff(v) for v in plain.v]
    forces = [plain(Q) - V.diff(x) + T.diff(x) for x, Q in zip(plain.x, model.forces, strict=True)]
    bias = [force - plain.rate(momentum) for force, momentum in zip(forces, momenta, strict=True)]
    rows = [plain.rate(plain(phi)) for phi in model.holonomic_constraints]
    rows += [plain(row) for row in model.nonholonomic_constraints]
    at_rest = dict.fromkeys(plain.v, sympy.S.Zero)
    n, m = model.n, model.m
    return Equations(
        model.coordinates, tuple(MULTIPLIER(sympy.Integer(row)) for row in range(m)),
        plain.matrix(n, n, (momentum.diff(v) for momentum in momenta for v in plain.v)), plain.matrix(n, 1, bias),
        plain.matrix(m, n, (row.diff(v) for row in rows for v in plain.v)),
        plain.matrix(m, 1, (row.xreplace(at_rest) for row in rows)),
        plain.matrix(m, 1, map(plain.rate, rows)),
    )  # fmt: skip


class _Plain:
    """Symbols for coordinates and rates, so that derivatives in t are those of time alone; and the way back."""

    def __init__(self, model: Mechanism) -> None:
        self.model = model
        self.x = sympy.symbols(f"x:{model.n}", cls=sympy.Dummy)
        self.v = sympy.symbols(f"v:{model.n}", cls=sympy.Dummy)
        moving = (*model.rates, *model.coordinates)
        self._symbols = dict(zip(moving, (*self.v, *self.x), strict=True))
        self._back = {symbol: given for given, symbol in self._symbols.items()}

    def __call__(self, expression: sympy.Expr) -> sympy.Expr:
        return self.model.in_rates(expression).xreplace(self._symbols)

    def rate(self, expression: sympy.Expr) -> sympy.Expr:
        """Return the rate of an expression along the motion, where the velocities stay."""
        moving = (expression.diff(x) * v for x, v in zip(self.x, self.v, strict=True))
        return sympy.Add(*moving) + expression.diff(t)

    def matrix(self, rows: int, columns: int, entries: Iterable[sympy.Expr]) -> sympy.ImmutableDenseMatrix:
        """Return entries, simplified, in the user's symbols."""
        back = (simplified(entry).xreplace(self._back) for entry in entries)
        return sympy.ImmutableDenseMatrix(rows, columns, list(back))


def simplified(expression: sympy.Expr) -> sympy.Expr:
    """Return the shortest of an expression and forms of it that are quickly found."""
    forms = [expression]
    if sympy.count_ops(expression) <= _SOON_EXPANDED:
        forms.append(sympy.expand(expression))
    if sympy.count_ops(forms[-1]) <= _SOON_SIMPLIFIED:
        forms.append(sympy.trigsimp(forms[-1]))
    return min((*forms, *map(sympy.factor_terms, forms[1:])), key=_length)


def _length(expression: sympy.Expr) -> tuple[int, str]:
    return sympy.count_ops(expression), str(expression)
