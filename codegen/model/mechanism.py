"""What a mechanism is: its fields, normalised, and what follows from them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy

from .drawing import Shape
from .normalise import ModelError, expression, shown, t, truth


@dataclass(frozen=True, slots=True)
class Event:
    """A zero crossing: direction 1 upwards, -1 downwards, 0 both; a terminal one ends the run.

    Examples
    --------
    >>> from sympy.physics.mechanics import dynamicsymbols
    >>> from eigenmotion import Event
    >>> theta = dynamicsymbols("theta")
    >>> events = {"limit": Event(theta - 1, direction=1, terminal=True), "bottom": theta}
    """

    expression: Any
    direction: int = 0
    terminal: bool = False

    def __post_init__(self) -> None:
        object.__setattr__(self, "expression", expression(self.expression, "The expression of an event"))
        given = self.direction
        if not isinstance(given, int) or isinstance(given, bool) or given not in (-1, 0, 1):
            raise ModelError(f"The direction of an event is 1 (upwards), -1 (downwards) or 0, not {shown(given)}.")
        object.__setattr__(self, "terminal", truth(self.terminal, "terminal of an event"))


@dataclass(frozen=True, slots=True)
class Mechanism:
    """The fields of a `Model`, as its docstring has them, before anything is checked."""

    name: str
    coordinates: tuple[sympy.Expr, ...]
    kinetic_energy: sympy.Expr
    potential_energy: sympy.Expr
    forces: tuple[sympy.Expr, ...]
    holonomic_constraints: tuple[sympy.Expr, ...]
    nonholonomic_constraints: tuple[sympy.Expr, ...]
    quasi_velocities: tuple[tuple[sympy.Expr, sympy.Expr], ...]
    parameters: tuple[tuple[sympy.Symbol, float], ...]
    inputs: tuple[tuple[sympy.Expr, float], ...]
    outputs: tuple[tuple[str, sympy.Expr], ...]
    events: tuple[tuple[str, Event], ...]
    initial: tuple[tuple[sympy.Expr, float], ...]
    scales: tuple[float, ...]
    drawing: tuple[Shape, ...]

    @property
    def n(self) -> int:
        """Number of coordinates."""
        return len(self.coordinates)

    @property
    def h(self) -> int:
        """Number of holonomic constraint rows."""
        return len(self.holonomic_constraints)

    @property
    def m(self) -> int:
        """Number of constraint rows."""
        return self.h + len(self.nonholonomic_constraints)

    @property
    def rates(self) -> tuple[sympy.Expr, ...]:
        """Velocities xdot : (n) the derivatives of the coordinates."""
        return tuple(x.diff(t) for x in self.coordinates)

    @property
    def initial_x(self) -> tuple[float, ...]:
        """(n) [u_i] coordinates at the start."""
        known = dict(self.initial)
        return tuple(known.get(x, 0.0) for x in self.coordinates)

    @property
    def initial_y(self) -> tuple[float, ...]:
        """(n) quasi-velocities at the start, or () where `initial` names none."""
        known = dict(self.initial)
        given = any(y in known for y, _ in self.quasi_velocities)
        return tuple(known.get(y, 0.0) for y, _ in self.quasi_velocities) if given else ()

    def in_rates(self, given: sympy.Expr) -> sympy.Expr:
        """Return an expression with the quasi-velocities (3) written in the rates."""
        if not self.quasi_velocities:
            return given
        replacements = {y.diff(t): P_xdot.diff(t) for y, P_xdot in self.quasi_velocities}
        return given.xreplace(replacements).xreplace(dict(self.quasi_velocities))
