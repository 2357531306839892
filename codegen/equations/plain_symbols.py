"""Plain symbols in place of the user's functions of time."""

from __future__ import annotations

from collections.abc import Mapping

import sympy

from ..model.model import multiplier, t
from ..model.normalise import name_of
from ..model.statement.constraint_rows import normal_force
from ..model.statement.mechanism import Mechanism


class Names:
    """Plain symbols for coordinates, rates, accelerations, inputs, multipliers and time, with unique names."""

    def __init__(self, model: Mechanism) -> None:
        self.model = model
        self.parameters = tuple(symbol for symbol, _ in model.parameters)
        self._taken = {symbol.name for symbol in self.parameters} | {"t"}
        self.time = sympy.Symbol("t")
        states = [name_of(z) for z, _ in model.states]
        moving = model.coordinates[: model.n - len(states)]
        x = tuple(self._new(name_of(x)) for x in moving)
        self.inputs = tuple(self._new(name_of(u)) for u, _ in model.inputs)
        z = tuple(map(self._new, states))
        self.x = (*x, *(self._new(f"{name}_integral") for name in states))
        self.v = (*(self._new(f"{one.name}_dot") for one in x), *z)
        self.accelerations = (
            *(self._new(f"{one.name}_ddot") for one in x),
            *(self._new(f"{one.name}_dot") for one in z),
        )
        self.multipliers = tuple(self._new(f"lambda_{row}") for row in range(model.m))
        self.norms = {normal_force(s.presses): self._new(f"rho_{s.name}") for s in model.switches if s.presses}
        self._replacements = self._plain()

    def _new(self, name: str) -> sympy.Symbol:
        while name in self._taken:
            name += "_"
        self._taken.add(name)
        return sympy.Symbol(name)

    def by_name(self) -> Mapping[str, sympy.Symbol]:
        """Return all plain symbols by name."""
        every = (*self.parameters, *self.x, *self.v, *self.inputs, *self.accelerations, *self.multipliers, self.time)
        return {symbol.name: symbol for symbol in (*every, *self.norms.values())}

    def signs(self) -> Mapping[str, int]:
        """Return 1 or -1 for parameters declared positive or negative; coordinates may have either sign."""
        return {p.name: 1 if p.is_positive else -1 for p in self.parameters if p.is_positive or p.is_negative}

    def _plain(self) -> tuple[dict[sympy.Basic, sympy.Expr], ...]:
        """Return the replacements, highest derivatives first."""
        model = self.model
        second = dict(zip((x.diff(t, 2) for x in model.coordinates), self.accelerations, strict=True))
        first = dict(zip(model.rates, self.v, strict=True))
        functions = (*model.coordinates, *(u for u, _ in model.inputs), t)
        zeroth = dict(zip(functions, (*self.x, *self.inputs, self.time), strict=True))
        rows = {multiplier(row): symbol for row, symbol in enumerate(self.multipliers)}
        return second, first, zeroth | rows

    def plain(self, expression: sympy.Expr) -> sympy.Expr:
        """Return an expression in plain symbols; quasi-velocities are replaced by P xdot (3)."""
        expression = self.model.in_rates(expression)
        for replacements in self._replacements:
            expression = expression.xreplace(replacements)
        return expression
