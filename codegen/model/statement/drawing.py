"""Normalised drawings: the kind of each shape and its numbers, as expressions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sympy

from ..normalise import ModelError, expression, number, sequence_of, shown
from . import draw

KINDS = {
    draw.Line: "line",
    draw.Spring: "spring",
    draw.Disk: "disk",
    draw.Body: "body",
    draw.Solid: "solid",
    draw.Ground: "ground",
    draw.Trace: "trace",
}
_DIMENSIONS = (2, 3)


@dataclass(frozen=True, slots=True)
class Shape:
    """One shape: the points, `dimension` numbers each; for a disk its center, radius, axle (in space) and angle.

    The axle and the angle are omitted where a disk has none. For a solid: the position of its frame and its rotation,
    row by row; apart from these, its corners in the frame.
    """

    kind: str
    dimension: int
    numbers: tuple[sympy.Expr, ...]
    corners: tuple[tuple[float, float, float], ...] = ()


def drawing_of(drawing: Any) -> tuple[Shape, ...]:
    """Return a normalised drawing.

    Raises
    ------
    ModelError
        An entry is not a shape, a position does not have two or three expressions, or the dimensions differ.
    """
    shapes = tuple(_shape(entry, f"drawing[{k}]") for k, entry in enumerate(sequence_of(drawing, "drawing")))
    for k, shape in enumerate(shapes):
        if shape.dimension != shapes[0].dimension:
            raise ModelError(
                f"drawing[{k}] ({shape.kind}) has {shape.dimension} numbers a position, drawing[0] has "
                f"{shapes[0].dimension}. One drawing is in the plane (x, y) or in space (x, y, z)."
            )
    return shapes


def _shape(shape: Any, what: str) -> Shape:
    if isinstance(shape, Shape):  # copied from another Model
        return shape
    kind = KINDS.get(type(shape))
    if kind is None:
        names = ", ".join(f"eigenmotion.draw.{known.__name__}" for known in KINDS)
        raise ModelError(f"{what} is {shown(shape)}, which is no shape. Use {names}.")
    what = f"{what} ({kind})"
    if isinstance(shape, draw.Disk):
        return _disk(shape, what)
    if isinstance(shape, draw.Solid):
        return _solid(shape, what)
    points = [_position(point, f"{what}: {name}") for name, point in _points(shape, what)]
    for point in points:
        _check_dimension(point, len(points[0]), what)
    return Shape(kind, len(points[0]), tuple(number for point in points for number in point))


def _points(shape: Any, what: str) -> list[tuple[str, Any]]:
    """Return the positions of a shape, with their names."""
    if not isinstance(shape, draw.Body | draw.Ground):
        return [(name, getattr(shape, name)) for name in shape.__slots__]
    least = 3 if isinstance(shape, draw.Body) else 1
    points = sequence_of(shape.points, f"{what}: points")
    if len(points) < least:
        raise ModelError(f"{what} has {len(points)} points and needs at least {least}. Add some.")
    return [(f"points[{k}]", point) for k, point in enumerate(points)]


def _disk(disk: draw.Disk, what: str) -> Shape:
    center = _position(disk.center, f"{what}: center")
    numbers = [*center, expression(disk.radius, f"{what}: radius")]
    if disk.axis is not None:
        axis = _position(disk.axis, f"{what}: axis")
        if len(center) == 2:
            raise ModelError(f"{what} has an axis, which disks in the plane do not. Leave it out.")
        _check_dimension(axis, 3, what)
        numbers.extend(axis)
    if disk.angle is not None:
        if len(center) == 3 and disk.axis is None:
            raise ModelError(
                f"{what} has an angle in space, but no axis to turn about. Give the direction of its axle."
            )
        numbers.append(expression(disk.angle, f"{what}: angle"))
    return Shape("disk", len(center), tuple(numbers))


def _solid(solid: draw.Solid, what: str) -> Shape:
    position = _position(solid.position, f"{what}: position")
    _check_dimension(position, 3, what)
    rotation = sympy.Matrix(solid.rotation)
    if rotation.shape != (3, 3):
        raise ModelError(f"{what}: its rotation is {rotation.shape[0]} by {rotation.shape[1]}. Give a matrix 3 by 3.")
    axes = (expression(entry, f"{what}: rotation[{k // 3}, {k % 3}]") for k, entry in enumerate(rotation))
    return Shape("solid", 3, (*position, *axes), _corners(solid.corners, what))


def _corners(given: Any, what: str) -> tuple[tuple[float, float, float], ...]:
    """Return corners of a solid, at least three."""
    corners = []
    for k, corner in enumerate(sequence_of(given, f"{what}: corners")):
        entries = sequence_of(corner, f"{what}: corners[{k}]")
        _check_dimension(entries, 3, what)
        x, y, z = (number(entry, f"{what}: corners[{k}]") for entry in entries)
        corners.append((x, y, z))
    if len(corners) < 3:
        raise ModelError(f"{what} has {len(corners)} corners and needs at least 3. Add some.")
    return tuple(corners)


def _position(position: Any, what: str) -> tuple[sympy.Expr, ...]:
    """Return a position as a tuple of two or three expressions."""
    numbers = sequence_of(position, what)
    if len(numbers) not in _DIMENSIONS:
        raise ModelError(f"{what} has {len(numbers)} numbers. A position is (x, y) in the plane, (x, y, z) in space.")
    return tuple(expression(number, f"{what}[{axis}]") for axis, number in zip("xyz", numbers, strict=False))


def _check_dimension(point: Sequence[Any], dimension: int, what: str) -> None:
    if len(point) != dimension:
        raise ModelError(f"{what} has positions of {dimension} and of {len(point)} numbers. Give all alike.")
