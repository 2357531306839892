"""Drawing of a mechanism: shapes at positions in SymPy, for `Model(drawing=[...])`.

A position is a sequence of two expressions (x, y), y upwards, or of three (x, y, z), z upwards, in coordinates,
parameters and time. One drawing is in the plane or in space.

Examples
--------
>>> from sympy import cos, sin, symbols
>>> from sympy.physics.mechanics import dynamicsymbols
>>> from eigenmotion import draw
>>> theta, l = dynamicsymbols("theta"), symbols("l", positive=True)
>>> mass = l * sin(theta), -l * cos(theta)
>>> drawing = [draw.Ground((0, 0)), draw.Line((0, 0), mass), draw.Disk(mass, l / 10), draw.Trace(mass)]
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

Position = Sequence[Any]


@dataclass(frozen=True, slots=True)
class Line:
    """A bar from p to q."""

    p: Position
    q: Position


@dataclass(frozen=True, slots=True)
class Spring:
    """A spring from p to q."""

    p: Position
    q: Position


@dataclass(frozen=True, slots=True)
class Disk:
    """A wheel, a ball or a point mass.

    radius : [m]
    angle : of the mark on it, from the x axis of the plane; none: there is no mark
    axis : in space, along its axle; the angle is about it, from the line of nodes (z axis) x (axle), or from x where
        the axle is vertical. None: a ball
    """

    center: Position
    radius: Any
    angle: Any = None
    axis: Position | None = None


@dataclass(frozen=True, slots=True)
class Body:
    """A solid with these corners: in the plane the polygon in the order given, in space the convex hull."""

    points: Iterable[Position]


@dataclass(frozen=True, slots=True, init=False)
class Ground:
    """What does not move: a support (one point), a wall or floor (two), a floor in space (the polygon of more)."""

    points: tuple[Position, ...]

    def __init__(self, *points: Position) -> None:
        object.__setattr__(self, "points", points)


@dataclass(frozen=True, slots=True)
class Trace:
    """The path of p."""

    p: Position
