"""The fields of a mechanism, normalised, and properties that follow from them."""

from __future__ import annotations

from dataclasses import dataclass, fields

import sympy

from ..normalise import t
from .constraint_rows import NamedRows, names_of_rows
from .contacts import Contact, Friction, Switch, normals_of, switch_of
from .drawing import Shape
from .event import Event


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
    contacts: tuple[tuple[str, Contact | Friction], ...]
    constraint_names: tuple[NamedRows, ...]
    states: tuple[tuple[sympy.Expr, sympy.Expr], ...]

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
    def switches(self) -> tuple[Switch, ...]:
        """What of the other fields contacts were made into."""
        rows = self.holonomic_constraints, self.nonholonomic_constraints
        normals = normals_of({field.name: getattr(self, field.name) for field in fields(Mechanism)})
        return tuple(switch_of(name, entry, *rows, normals) for name, entry in self.contacts)

    @property
    def row_names(self) -> tuple[str, ...]:
        """(m) names of the constraint rows, as "guide[1]"; "" of rows without, () where none has one."""
        return names_of_rows(self.constraint_names, self.h, self.m)

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
        return in_rates(given, self.quasi_velocities)


def in_rates(given: sympy.Expr, quasi_velocities: tuple[tuple[sympy.Expr, sympy.Expr], ...]) -> sympy.Expr:
    """Return an expression with quasi-velocities, pairs y_i and P xdot (3), written in the rates."""
    if not quasi_velocities:
        return given
    replacements = {y.diff(t): P_xdot.diff(t) for y, P_xdot in quasi_velocities}
    return given.xreplace(replacements).xreplace(dict(quasi_velocities))
