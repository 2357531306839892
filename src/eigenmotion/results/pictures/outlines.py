"""Outlines of a drawing at one row: lines and faces, in the plane or in space."""

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np
import scipy

from ...arguments.named_values import Vector
from .moving_shapes import Drawing, Shape

COILS = 8
_ROUND = np.linspace(0.0, 2 * np.pi, 49)
_UP = np.array([0.0, 0.0, 1.0])


@dataclass(slots=True)
class Outlines:
    """Polygons (k, d), by the way they are drawn: bars, fine lines, faces, wheels and paths."""

    bars: list[Vector] = field(default_factory=list)
    lines: list[Vector] = field(default_factory=list)
    faces: list[Vector] = field(default_factory=list)
    wheels: list[Vector] = field(default_factory=list)
    paths: list[Vector] = field(default_factory=list)


def outlines(drawing: Drawing, row: int) -> Outlines:
    """Return the outlines of a drawing at one row, at which traces end."""
    outlined = Outlines()
    for shape in drawing.shapes:
        _ADD[shape.kind](outlined, shape, row, drawing.size)
        if shape.kind == "trace":
            outlined.paths.append(shape.points[: row + 1, 0])
    return outlined


def _line(outlined: Outlines, shape: Shape, row: int, _size: float) -> None:
    outlined.bars.append(shape.points[row])


def _spring(outlined: Outlines, shape: Shape, row: int, size: float) -> None:
    """Add a spring: straight ends, and coils of constant width in between."""
    p, q = shape.points[row]
    along = np.linspace(0.0, 1.0, 16 * COILS + 1)
    inner = (along > 0.08) & (along < 0.92)
    phase = 2 * np.pi * COILS * (along - 0.08) / 0.84
    across, aside = frame(q - p)
    swing = 0.018 * size * inner
    coil = swing[:, None] * np.sin(phase)[:, None] * across
    if len(p) > len("xy"):
        coil = coil + (swing * np.cos(phase))[:, None] * aside
    outlined.lines.append(p + along[:, None] * (q - p) + coil)


def _disk(outlined: Outlines, shape: Shape, row: int, _size: float) -> None:
    center, radius = shape.points[row, 0], shape.radius[row]
    if len(center) == len("xy"):
        outlined.wheels.append(center + radius * np.column_stack([np.cos(_ROUND), np.sin(_ROUND)]))
        first, second = np.eye(2)
    elif shape.axis is None:
        outlined.wheels.extend(center + radius * circle for circle in _ball())
        return
    else:
        first, second = nodes(shape.axis[row])
        outlined.wheels.append(center + radius * (np.outer(np.cos(_ROUND), first) + np.outer(np.sin(_ROUND), second)))
    if shape.angle is not None:
        angle = shape.angle[row]
        outlined.lines.append(np.array([center, center + radius * (np.cos(angle) * first + np.sin(angle) * second)]))


def _body(outlined: Outlines, shape: Shape, row: int, _size: float) -> None:
    corners = shape.points[row]
    outlined.faces.extend([corners] if corners.shape[1] == len("xy") else hull(corners))


def _ground(outlined: Outlines, shape: Shape, row: int, size: float) -> None:
    points = shape.points[row]
    if len(points) > len("pq"):
        outlined.faces.append(points)
    elif points.shape[1] == len("xy"):
        _hatched(outlined, points, 0.04 * size)
    elif len(points) > 1:
        outlined.bars.append(points)
    else:
        side = 0.03 * size
        outlined.faces.append(points[0] + side * np.array([[1, 1, 0], [-1, 1, 0], [-1, -1, 0], [1, -1, 0]]))


def _hatched(outlined: Outlines, points: Vector, length: float) -> None:
    """Add a wall from p to q with hatches on its right, or a support (one point) on a short wall."""
    if len(points) == 1:
        (p,), foot = points, np.array([length / 2, -length])
        left, right = p + foot * [-1, 1], p + foot
        outlined.lines.append(np.array([p, left, right, p]))
        beyond = np.array([length / 3, 0.0])
        points = np.array([left - beyond, right + beyond])
    p, q = points
    span = np.linalg.norm(q - p)
    if not span > 0.0:
        return
    along = (q - p) / span
    slant = length / 3 * (np.array([along[1], -along[0]]) - along)
    outlined.lines.append(points)
    count = max(3, round(span / length * 3))
    outlined.lines.extend(np.array([foot, foot + slant]) for foot in p + np.linspace(0, 1, count)[:, None] * (q - p))


def _trace(outlined: Outlines, shape: Shape, row: int, size: float) -> None:
    """Add nothing: `outlines` adds the path."""


_ADD = {"line": _line, "spring": _spring, "disk": _disk, "body": _body, "solid": _body, "ground": _ground,
        "trace": _trace}  # fmt: skip


def frame(direction: Vector) -> tuple[Vector, Vector]:
    """Return two unit vectors perpendicular to a direction; in the plane, one and a zero vector."""
    length = np.linalg.norm(direction)
    unit = direction / length if length > 0.0 else np.eye(len(direction))[0]
    if len(direction) == len("xy"):
        return np.array([-unit[1], unit[0]]), np.zeros(2)
    across = np.cross(unit, np.eye(3)[np.argmin(np.abs(unit))])
    across /= np.linalg.norm(across)
    return across, np.cross(unit, across)


def nodes(axis: Vector) -> tuple[Vector, Vector]:
    """Return unit vectors across an axle: the line of nodes z x axle (x if the axle is vertical), and axle x that."""
    axle = axis / np.linalg.norm(axis)
    first = np.cross(_UP, axle)
    length = np.linalg.norm(first)
    first = first / length if length > 1e-9 else np.array([1.0, 0.0, 0.0])
    return first, np.cross(axle, first)


def hull(corners: Vector) -> list[Vector]:
    """Return the triangles of the convex hull of corners (k, 3); none if they lie in one plane."""
    try:
        return [corners[triangle] for triangle in scipy.spatial.ConvexHull(corners).simplices]
    except (scipy.spatial.QhullError, ValueError):
        return []


def _ball() -> Iterator[Vector]:
    """Yield three great circles."""
    ring = np.column_stack([np.cos(_ROUND), np.sin(_ROUND), np.zeros_like(_ROUND)])
    yield from (np.roll(ring, shift, axis=1) for shift in range(3))
