"""Shapes for the drawing of a mechanism: `Model(drawing=[...])`.

A position is a sequence of two expressions (x, y) with y upwards, or three (x, y, z) with z upwards; they may contain
coordinates, parameters and time. All positions of a drawing have the same dimension.

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
    angle : of a mark on the disk, from the x axis of the plane. None: no mark
    axis : the direction of its axle in space. The angle is measured about it, from the line of nodes (z axis) x (axle),
        or from the x axis if the axle is vertical. None: a ball
    """

    center: Position
    radius: Any
    angle: Any = None
    axis: Position | None = None


@dataclass(frozen=True, slots=True)
class Body:
    """A solid body: in the plane the polygon with these corners in order, in space their convex hull."""

    points: Iterable[Position]


@dataclass(frozen=True, slots=True)
class Solid:
    """A rigid body in space: the convex hull of corners that move with a frame.

    position : of the frame's origin
    rotation : (3, 3), the axes of the frame as columns
    corners : (k, 3) numbers, in the frame [m]; many cost no time, since only the frame is computed
    """

    position: Position
    rotation: Any
    corners: Iterable[Sequence[float]]


@dataclass(frozen=True, slots=True, init=False)
class Ground:
    """A fixed part: a support (one point), a wall or floor (two), a floor in space (a polygon of more points)."""

    points: tuple[Position, ...]

    def __init__(self, *points: Position) -> None:
        object.__setattr__(self, "points", points)


@dataclass(frozen=True, slots=True)
class Trace:
    """The path of a point p."""

    p: Position
