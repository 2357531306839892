"""A body of a tree: its joint to the parent, where that is, and its inertia."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache

import sympy

Triple = tuple[sympy.Expr, sympy.Expr, sympy.Expr]

FREEDOMS = {"fixed": 0, "revolute": 1, "prismatic": 1, "spherical": 3, "free": 6}
"""Number of coordinates of each kind of joint. Spherical: modified Rodrigues parameters; free: the place, then these"""

ROTATED = ("spherical", "free")
"""Joints whose last three coordinates are modified Rodrigues parameters"""


@dataclass(frozen=True, slots=True, eq=False)
class Link:
    """A body whose joint is one of FREEDOMS. Bodies are equal only to themselves.

    name
    parent : the body that carries it; None for the ground
    joint : a kind of FREEDOMS
    coordinates : functions of time; bodies with a coordinate in common move together
    at : (3,) place of the joint in the parent's frame [m]
    rotation : (9,) R, row by row: the axes of the joint's frame are the columns of R, in the parent's axes
    axis : (3,) direction of a revolute or prismatic joint, in the joint's frame; of length 1
    mass [kg]; center : (3,) mass centre in the body's frame [m]
    inertia : (6,) xx, xy, xz, yy, yz, zz about the mass centre, in the body's axes [kg m^2]
    moment : (3,) first moment besides mass times center, in the body's axes [kg m]
    ratio, offset : a revolute or prismatic joint with the coordinate q is at ratio q + offset
    is_part : whether this is a part of a joint made of several, and no body of the user

    The body's frame is the joint's frame, moved by the joint.
    """

    name: str
    parent: Link | None
    joint: str
    coordinates: tuple[sympy.Expr, ...]
    at: Triple
    rotation: tuple[sympy.Expr, ...]
    axis: Triple
    mass: sympy.Expr
    center: Triple
    inertia: tuple[sympy.Expr, ...]
    moment: Triple = (sympy.S.Zero, sympy.S.Zero, sympy.S.Zero)
    ratio: sympy.Expr = sympy.S.One
    offset: sympy.Expr = sympy.S.Zero
    is_part: bool = False

    @property
    def ancestors(self) -> Iterator[Link]:
        """The body itself, its parent, and so on to the ground."""
        link: Link | None = self
        while link is not None:
            yield link
            link = link.parent

    @property
    def geometry(self) -> tuple[sympy.Expr, ...]:
        """The expressions that say where it is on its parent."""
        return (*self.at, *self.rotation, *self.axis, self.ratio, self.offset)

    @property
    def masses(self) -> tuple[sympy.Expr, ...]:
        """The expressions that say what inertia it has."""
        return (self.mass, *self.center, *self.inertia, *self.moment)

    @property
    def text(self) -> str:
        """All that it is on its parent, for a digest."""
        return _text(self)


@cache
def _text(body: Link) -> str:
    numbers = (*body.geometry, *body.masses)
    return f"{body.name} {body.joint} {body.coordinates} {list(map(sympy.srepr, numbers))}"


def coordinates_of(bodies: Iterable[Link]) -> tuple[sympy.Expr, ...]:
    """Return the coordinates of bodies, each once, in the order of the bodies."""
    return tuple(dict.fromkeys(q for body in bodies for q in body.coordinates))


@cache
def rate_of(coordinate: sympy.Expr) -> sympy.Expr:
    """Return the derivative of a coordinate with respect to time."""
    return coordinate.diff()
