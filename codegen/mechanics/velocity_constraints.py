"""Velocity constraints of a system that do not follow from its holonomic constraints."""

from __future__ import annotations

import random
from collections.abc import Iterable

import sympy
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import System

from ..model import ModelError, t
from .speeds import Speeds

_DIGITS = 40
_ROUNDING = sympy.Float("1e-25", _DIGITS)


def velocity_rows(system: System, speeds: Speeds) -> tuple[sympy.Expr, ...]:
    """Return the velocity constraints that are independent of the holonomic constraints and of each other.

    If the user set `System.velocity_constraints`, it contains the derivatives of the holonomic constraints, in some
    form, and others. A row is dropped if, at a random state, it depends on those derivatives and the rows before it.
    """
    derivatives = [phi.diff(t) for phi in system.holonomic_constraints]
    rows = list(system.velocity_constraints)
    if rows == [*derivatives, *system.nonholonomic_constraints]:
        return tuple(system.nonholonomic_constraints)
    space = _Space(speeds)
    for row in derivatives:
        space.add(row)
    return tuple(row for row in rows if space.add(row))


class _Space:
    """The row space of constraints at a random state, as an orthonormal basis."""

    def __init__(self, speeds: Speeds) -> None:
        self.speeds = speeds
        self.basis: list[sympy.Matrix] = []
        self.random = random.Random("a place without symmetry")
        self.place: dict[sympy.Expr, sympy.Float] = {}

    def add(self, row: sympy.Expr) -> bool:
        """Add a row if it is independent of those added before; return whether it is."""
        numbers = sympy.Matrix(self._coefficients(row))
        rest = numbers
        for _ in range(2):
            rest = sum((-rest.dot(known) * known for known in self.basis), rest)
        if rest.norm() <= _ROUNDING * numbers.norm():
            return False
        self.basis.append(rest / rest.norm())
        return True

    def _coefficients(self, row: sympy.Expr) -> list[sympy.Expr]:
        """Return (n + 1) coefficients: those of the rates, and the value at rest."""
        row = row.xreplace(dict(self.speeds.in_rates))
        parts = [row.diff(rate) for rate in self.speeds.rates]
        at_rest = dict.fromkeys(self.speeds.rates, sympy.S.Zero)
        numbers = [part.xreplace(at_rest) for part in (*parts, row)]
        return [number.xreplace(self._at(numbers)).evalf(_DIGITS) for number in numbers]

    def _at(self, numbers: Iterable[sympy.Expr]) -> dict[sympy.Expr, sympy.Float]:
        whole = sympy.Tuple(*numbers)
        for symbol in sorted(whole.atoms(AppliedUndef) | whole.free_symbols, key=sympy.default_sort_key):
            self.place.setdefault(symbol, sympy.Float(self.random.uniform(0.3, 1.2), _DIGITS))
        if rates := whole.atoms(sympy.Derivative):
            raise ModelError(f"A velocity constraint holds {rates.pop()}, which is no velocity.")
        return self.place
