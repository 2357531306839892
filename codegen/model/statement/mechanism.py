"""The record of a mechanism's normalised fields, and properties derived from them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from functools import lru_cache

import sympy

from ..normalise import rate_of, t
from .constraint_rows import NamedRows, names_of_rows
from .contacts import Contact, Friction, Switch, normals_of, switch_of
from .drawing import Shape
from .event import Event


@dataclass(frozen=True, slots=True)
class Mechanism:
    """The fields of a `Model` (see its docstring), without checks."""

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
    notes: tuple[str, ...]
    units: tuple[tuple[str, str], ...]

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
        """The switches of its contacts: the parameters and rows into which contacts were translated."""
        rows = self.holonomic_constraints, self.nonholonomic_constraints
        normals = normals_of({field.name: getattr(self, field.name) for field in fields(Mechanism)})
        return tuple(switch_of(name, entry, *rows, normals) for name, entry in self.contacts)

    @property
    def row_names(self) -> tuple[str, ...]:
        """(m) names of the constraint rows, such as "guide[1]"; "" for rows without a name, () if no row has one."""
        return names_of_rows(self.constraint_names, self.h, self.m)

    @property
    def rates(self) -> tuple[sympy.Expr, ...]:
        """(n) velocities xdot, the time derivatives of the coordinates."""
        return tuple(map(rate_of, self.coordinates))

    @property
    def initial_x(self) -> tuple[float, ...]:
        """(n) [u_i] initial coordinates."""
        known = dict(self.initial)
        return tuple(known.get(x, 0.0) for x in self.coordinates)

    @property
    def initial_y(self) -> tuple[float, ...]:
        """(n) initial quasi-velocities, or () where `initial` has none."""
        known = dict(self.initial)
        has_some = any(y in known for y, _ in self.quasi_velocities)
        return tuple(known.get(y, 0.0) for y, _ in self.quasi_velocities) if has_some else ()

    def in_rates(self, expression: sympy.Expr) -> sympy.Expr:
        """Replace the quasi-velocities in an expression by P xdot (3)."""
        return in_rates(expression, self.quasi_velocities)


def in_rates(expression: sympy.Expr, quasi_velocities: tuple[tuple[sympy.Expr, sympy.Expr], ...]) -> sympy.Expr:
    """Replace quasi-velocities, given as pairs y_i and P xdot (3), in an expression."""
    if not quasi_velocities:
        return expression
    return expression.xreplace(_accelerations(quasi_velocities)).xreplace(dict(quasi_velocities))


@lru_cache(maxsize=8)
def _accelerations(quasi_velocities: tuple[tuple[sympy.Expr, sympy.Expr], ...]) -> Mapping[sympy.Expr, sympy.Expr]:
    """Return the rates of quasi-velocities, from their rates as SymPy writes them."""
    return {y.diff(t): P_xdot.diff(t) for y, P_xdot in quasi_velocities}
