"""Frames of a tree of bodies: steps from a parent's frame to a child's, in which joints turn about or move along z.

A frame of a user is turned so that the axis of its joint is z, and about that axis so that what remains between the
parent's frame and the joint's are two rotations in planes, about z and x (Denavit and Hartenberg, for trees).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from ..graph.coefficients import Number
from ..graph.graph import Graph
from ..graph.store import Kind
from .inertia import ArticulatedInertia, RigidInertia, Spatial
from .rotation import MatrixRotation, PlaneRotation, Rotation
from .scalar import Scalar, Vector, cross, plus

ROUNDING = 8 * 2.0**-53
"""Entries of rotations within this of 0 or 1 are 0 or 1: cos(pi / 2) is 6e-17 in floating point."""
Matrix = Sequence[Vector]


class Step(Protocol):
    """A part of the way from a parent's frame to a child's."""

    def point_up(self, x: Vector) -> Vector:
        """Return a point's place in the parent's frame."""

    def vector_up(self, a: Vector) -> Vector:
        """Return a vector in the parent's axes."""

    def motion_down(self, motion: Spatial) -> Spatial:
        """Return a velocity or an acceleration in the child's frame."""

    def force_up(self, force: Spatial) -> Spatial:
        """Return a torque and force in the parent's frame."""

    def rigid_up(self, inertia: RigidInertia) -> RigidInertia:
        """Return an inertia in the parent's frame."""

    def articulated_up(self, inertia: ArticulatedInertia) -> ArticulatedInertia:
        """Return an inertia in the parent's frame."""


@dataclass(frozen=True, slots=True)
class Shift:
    """The child's origin is at p."""

    p: Vector

    def point_up(self, x: Vector) -> Vector:
        """Return x + p."""
        return plus(x, self.p)

    def vector_up(self, a: Vector) -> Vector:
        """Return a."""
        return a

    def motion_down(self, motion: Spatial) -> Spatial:
        """Return w, v + w x p."""
        w, v = motion
        return w, plus(v, cross(w, self.p))

    def force_up(self, force: Spatial) -> Spatial:
        """Return n + p x f, f."""
        n, f = force
        return plus(n, cross(self.p, f)), f

    def rigid_up(self, inertia: RigidInertia) -> RigidInertia:
        """Return it about the parent's origin."""
        return inertia.shifted(self.p)

    def articulated_up(self, inertia: ArticulatedInertia) -> ArticulatedInertia:
        """Return it about the parent's origin."""
        return inertia.shifted(self.p)


@dataclass(frozen=True, slots=True)
class Turn:
    """The child's axes are rotated."""

    rotation: Rotation

    def point_up(self, x: Vector) -> Vector:
        """Return R x."""
        return self.rotation.up(x)

    def vector_up(self, a: Vector) -> Vector:
        """Return R a."""
        return self.rotation.up(a)

    def motion_down(self, motion: Spatial) -> Spatial:
        """Return R^T w, R^T v."""
        return self.rotation.down(motion[0]), self.rotation.down(motion[1])

    def force_up(self, force: Spatial) -> Spatial:
        """Return R n, R f."""
        return self.rotation.up(force[0]), self.rotation.up(force[1])

    def rigid_up(self, inertia: RigidInertia) -> RigidInertia:
        """Return it in the parent's axes."""
        return inertia.turned(self.rotation)

    def articulated_up(self, inertia: ArticulatedInertia) -> ArticulatedInertia:
        """Return it in the parent's axes."""
        return inertia.turned(self.rotation)


def matrix(graph: Graph, rows: Sequence[Sequence[Number]]) -> Matrix:
    """Return a matrix of numbers."""
    return [[Scalar(graph, graph.number(entry)) for entry in row] for row in rows]


def product(A: Matrix, B: Matrix) -> Matrix:
    """Return A B, with entries within rounding of 0, 1 and -1 rounded to these."""
    return [[_rounded(_entry(row, column)) for column in zip(*B, strict=True)] for row in A]


def transposed(A: Matrix) -> Matrix:
    """Return A^T."""
    return [list(column) for column in zip(*A, strict=True)]


def applied(A: Matrix, a: Vector) -> Vector:
    """Return A a."""
    return [_entry(row, a) for row in A]


def turns(R: Matrix) -> tuple[list[Turn], Matrix]:
    """Return rotations about z and x whose product, with a last rotation about z, is R; and that last one, as a matrix.

    A matrix that contains parameters is one rotation; nothing is left of it.
    """
    graph, numbers = R[0][0].graph, [[number_of(entry) for entry in row] for row in R]
    if any(entry is None for row in numbers for entry in row):
        return [Turn(MatrixRotation(R))], matrix(graph, _UNIT)
    r = [[float(entry) for entry in row if entry is not None] for row in numbers]
    tilt = math.hypot(r[0][2], r[1][2])
    if tilt <= ROUNDING:
        up = 1 if r[2][2] > 0 else -1
        last: list[list[float]] = [[r[0][0], r[0][1], 0], [up * r[1][0], up * r[1][1], 0], [0, 0, 1]]
        return ([] if up > 0 else [_plane(graph, 0, -1, 0)]), _cleaned(graph, last)
    cosine, sine = -r[1][2] / tilt, r[0][2] / tilt
    # of what these two leave, so that their product with the last is R to rounding, however small the tilt
    c, s = (cosine * r[0][k] + sine * r[1][k] for k in range(2))
    last = [[c, s, 0], [-s, c, 0], [0, 0, 1]]
    return [_plane(graph, 2, cosine, sine), _plane(graph, 0, r[2][2], tilt)], _cleaned(graph, last)


def aligned(graph: Graph, axis: Vector) -> Matrix:
    """Return a rotation whose third column is this axis, of length 1."""
    numbers = [number_of(entry) for entry in axis]
    a = [float(entry) for entry in numbers if entry is not None]
    for k, columns in enumerate(_PERMUTATIONS):
        if abs(a[k]) >= 1 - ROUNDING:
            sign = 1 if a[k] > 0 else -1
            return matrix(graph, [[row[0], sign * row[1], sign * row[2]] for row in columns])
    least = min(range(3), key=lambda k: abs(a[k]))
    e = [float(k == least) for k in range(3)]
    x = [e[1] * a[2] - e[2] * a[1], e[2] * a[0] - e[0] * a[2], e[0] * a[1] - e[1] * a[0]]
    length = math.hypot(*x)
    x = [entry / length for entry in x]
    y = [a[1] * x[2] - a[2] * x[1], a[2] * x[0] - a[0] * x[2], a[0] * x[1] - a[1] * x[0]]
    return matrix(graph, [list(row) for row in zip(x, y, a, strict=True)])


def number_of(scalar: Scalar) -> Number | None:
    """Return the value of a number; None for an expression."""
    kind, operands = scalar.graph.records[scalar.node]
    if kind is Kind.NUMBER:
        value: Number = operands[0]
        return value
    return None


_UNIT = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
_PERMUTATIONS = (((0, 0, 1), (1, 0, 0), (0, 1, 0)), ((0, 1, 0), (0, 0, 1), (1, 0, 0)), _UNIT)
"""Rotations whose third column is x, y, z"""


def _plane(graph: Graph, axis: int, cosine: float, sine: float) -> Turn:
    (c, s), _, _ = _cleaned(graph, [[cosine, sine], [0, 0], [0, 0]])
    return Turn(PlaneRotation(axis, c, s))


def _cleaned(graph: Graph, rows: Sequence[Sequence[float]]) -> Matrix:
    return [[_rounded(entry) for entry in row] for row in matrix(graph, rows)]


def _rounded(entry: Scalar) -> Scalar:
    value = number_of(entry)
    if isinstance(value, float) and abs(value - round(value)) <= ROUNDING and abs(value) < 2:
        return Scalar(entry.graph, entry.graph.number(round(value)))
    return entry


def _entry(row: Vector, column: Vector) -> Scalar:
    graph = row[0].graph
    return Scalar(graph, graph.sum([((a * b).node, 1) for a, b in zip(row, column, strict=True)]))
