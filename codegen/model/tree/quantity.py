"""Quantities of bodies: places, velocities, rotations, energies, and the variables on which they depend."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from functools import cache

import sympy

from .body import Link, coordinates_of, rate_of

Variables = tuple[sympy.Expr, ...]

KINDS = {
    "position": 0, "velocity": 1, "rotation": 0, "angular_velocity": 1, "kinetic_energy": 2, "potential_energy": 0
}  # fmt: skip
"""What a function may be, and its degree in the rates of coordinates."""


@dataclass(frozen=True, slots=True)
class Quantity:
    """A quantity of bodies.

    kind : a key of KINDS
    bodies : those on which it depends, parents before children
    vector : (3,) the point of the last body, in its frame [m], or gravity [m / s^2]; () for neither
    place : which entry of a vector or matrix
    """

    kind: str
    bodies: tuple[Link, ...]
    vector: tuple[sympy.Expr, ...] = ()
    place: tuple[int, ...] = ()

    @property
    def label(self) -> str:
        """A name for people, such as "hand.velocity[2]"."""
        where = f"[{', '.join(map(str, self.place))}]" if self.place else ""
        return f"{self.bodies[-1].name}.{self.kind}{where}"

    @property
    def digest(self) -> str:
        """SHA-256 of all that it depends on."""
        numbers = {body: number for number, body in enumerate(self.bodies)}
        lines = [f"{numbers.get(body.parent)} {body.text}" if body.parent else body.text for body in self.bodies]
        text = "\n".join([self.kind, *lines, *map(sympy.srepr, self.vector), str(self.place)])
        return hashlib.sha256(text.encode()).hexdigest()

    @property
    def variables(self) -> Variables:
        """Coordinates, rates where it depends on them, and parameters."""
        return _variables(self.bodies, self.vector, KINDS[self.kind] > 0)


@cache
def _variables(bodies: tuple[Link, ...], vector: tuple[sympy.Expr, ...], rates: bool) -> Variables:
    coordinates = coordinates_of(bodies)
    numbers = [*vector]
    for body in bodies:
        numbers += [*body.geometry, *body.masses]
    parameters = sorted(set().union(*(one.free_symbols for one in numbers)), key=lambda symbol: symbol.name)
    return (*coordinates, *(rate_of(q) for q in coordinates if rates), *parameters)
