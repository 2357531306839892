"""Constraint rows of a system on its velocities, beside those of its holonomic constraints."""

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
    """Return the rows that hold what no holonomic constraint holds already.

    `System.velocity_constraints` may be set: then it has the derivatives of the holonomic constraints, in some form,
    and others. Those are left out that follow, at a random place, from the derivatives and the rows before.
    """
    derivatives = [phi.diff(t) for phi in system.holonomic_constraints]
    given = list(system.velocity_constraints)
    if given == [*derivatives, *system.nonholonomic_constraints]:
        return tuple(system.nonholonomic_constraints)
    space = _Space(speeds)
    for row in derivatives:
        space.takes(row)
    return tuple(row for row in given if space.takes(row))


class _Space:
    """What rows span, in numbers at a random place."""

    def __init__(self, speeds: Speeds) -> None:
        self.speeds = speeds
        self.basis: list[sympy.Matrix] = []
        self.random = random.Random("a place without symmetry")
        self.place: dict[sympy.Expr, sympy.Float] = {}

    def takes(self, row: sympy.Expr) -> bool:
        """Whether a row is independent of those before; then it is one of them."""
        numbers = sympy.Matrix(self._coefficients(row))
        rest = numbers
        for _ in range(2):
            rest = sum((-rest.dot(known) * known for known in self.basis), rest)
        if rest.norm() <= _ROUNDING * numbers.norm():
            return False
        self.basis.append(rest / rest.norm())
        return True

    def _coefficients(self, row: sympy.Expr) -> list[sympy.Expr]:
        """(n + 1) of the rates, and what is left at rest."""
        row = row.xreplace(dict(self.speeds.in_rates))
        parts = [row.diff(rate) for rate in self.speeds.rates]
        at_rest = dict.fromkeys(self.speeds.rates, sympy.S.Zero)
        numbers = [part.xreplace(at_rest) for part in (*parts, row)]
        return [number.xreplace(self._at(numbers)).evalf(_DIGITS) for number in numbers]

    def _at(self, numbers: Iterable[sympy.Expr]) -> dict[sympy.Expr, sympy.Float]:
        held = sympy.Tuple(*numbers)
        for symbol in sorted(held.atoms(AppliedUndef) | held.free_symbols, key=sympy.default_sort_key):
            self.place.setdefault(symbol, sympy.Float(self.random.uniform(0.3, 1.2), _DIGITS))
        if held.atoms(sympy.Derivative):
            raise ModelError(f"A velocity constraint holds {held.atoms(sympy.Derivative).pop()}, which is no velocity.")
        return self.place
