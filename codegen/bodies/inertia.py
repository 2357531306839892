"""Inertias about the origin of a body's frame: of rigid bodies, and of articulated ones (Featherstone 2008)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from .rotation import General, Rotation, Symmetric, full, matrix_vector
from .scalar import HALF, Scalar, Vector, cross, dot, minus, plus, scaled, total

Spatial = tuple[Vector, Vector]
"""Angular part, then linear part: angular velocity and velocity of the origin, or torque about the origin and force"""


def spatial_dot(a: Spatial, b: Spatial) -> Scalar:
    """Return the power of a force and a motion, or any other scalar product of the two parts."""
    return dot([*a[0], *a[1]], [*b[0], *b[1]])


def spatial_sum(*terms: Spatial) -> Spatial:
    """Return the sum, part by part."""
    return plus(*(term[0] for term in terms)), plus(*(term[1] for term in terms))


def times(a: Spatial, factor: Scalar) -> Spatial:
    """Return factor a."""
    return scaled(a[0], factor), scaled(a[1], factor)


def crossed(motion: Spatial, other: Spatial) -> Spatial:
    """Return motion x other, the rate of a motion that is fixed in a frame that moves so."""
    (w, v), (a, b) = motion, other
    return cross(w, a), plus(cross(v, a), cross(w, b))


def crossed_force(motion: Spatial, force: Spatial) -> Spatial:
    """Return motion x* force, the rate of a force that is fixed in a frame that moves so."""
    (w, v), (n, f) = motion, force
    return plus(cross(w, n), cross(v, f)), cross(w, f)


@dataclass(frozen=True, slots=True)
class RigidInertia:
    """mass [kg]; moment : m c, first moment [kg m]; J : inertia about the origin [kg m^2]."""

    mass: Scalar
    moment: Vector
    J: Symmetric

    def __add__(self, other: RigidInertia) -> RigidInertia:
        return RigidInertia(self.mass + other.mass, plus(self.moment, other.moment), plus(self.J, other.J))

    def __mul__(self, motion: Spatial) -> Spatial:
        """Return the momentum J w + m c x v, m v - m c x w."""
        w, v = motion
        return plus(matrix_vector(self.J, w), cross(self.moment, v)), plus(scaled(v, self.mass), cross(w, self.moment))

    def turned(self, rotation: Rotation) -> RigidInertia:
        """Return it in the axes of the parent."""
        return RigidInertia(self.mass, rotation.up(self.moment), rotation.up_symmetric(self.J))

    def shifted(self, p: Vector) -> RigidInertia:
        """Return it about another origin, from which this one is at p: J + 2 a.p - a p^T - p a^T, a = m c + m p / 2."""
        a = plus(self.moment, scaled(p, self.mass * HALF))
        (ax, ay, az), (px, py, pz) = a, p
        x, y, z = ax * px, ay * py, az * pz
        added = [
            (y + z) * 2,
            -(ax * py + ay * px),
            -(ax * pz + az * px),
            (x + z) * 2,
            -(ay * pz + az * py),
            (x + y) * 2,
        ]
        return RigidInertia(self.mass, plus(self.moment, scaled(p, self.mass)), plus(self.J, added))

    def articulated(self) -> ArticulatedInertia:
        """Return it as the inertia of an articulated body."""
        zero, (x, y, z) = self.mass * 0, self.moment
        H = [zero, -z, y, z, zero, -x, -y, x, zero]
        return ArticulatedInertia(self.J, H, [self.mass, zero, zero, self.mass, zero, self.mass])


@dataclass(frozen=True, slots=True)
class ArticulatedInertia:
    """The map [J H; H^T M] from an acceleration to the force that it takes; J and M symmetric."""

    J: Symmetric
    H: General
    M: Symmetric

    def __add__(self, other: ArticulatedInertia) -> ArticulatedInertia:
        return ArticulatedInertia(plus(self.J, other.J), plus(self.H, other.H), plus(self.M, other.M))

    def __mul__(self, motion: Spatial) -> Spatial:
        """Return the force J a + H b, H^T a + M b."""
        a, b = motion
        H = self.H
        return (
            [dot([*full(self.J)[k], *H[3 * k : 3 * k + 3]], [*a, *b]) for k in range(3)],
            [dot([*H[k::3], *full(self.M)[k]], [*a, *b]) for k in range(3)],
        )

    def turned(self, rotation: Rotation) -> ArticulatedInertia:
        """Return it in the axes of the parent."""
        return ArticulatedInertia(
            rotation.up_symmetric(self.J), rotation.up_general(self.H), rotation.up_symmetric(self.M)
        )

    def shifted(self, p: Vector) -> ArticulatedInertia:
        """Return it about another origin, from which this one is at p: H' = H + P M, J' = J + P H'^T - H P."""
        M = full(self.M)
        H = [self.H[3 * k : 3 * k + 3] for k in range(3)]
        moved = _rows(plus(_flat(H), _flat(_crossed_columns(p, M))))
        left = _crossed_columns(p, [list(column) for column in zip(*moved, strict=True)])
        right = [cross(row, p) for row in H]
        places = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))
        J = [total(p[0].graph, (self.J[k], left[i][j], -right[i][j])) for k, (i, j) in enumerate(places)]
        return ArticulatedInertia(J, _flat(moved), self.M)

    def rate(self, motion: Spatial) -> ArticulatedInertia:
        """Return its derivative in the parent's frame, in the axes of a child that moves so: v x* I - I v x.

        J' = A + A^T, A = w x J + v x H^T; H' = w x H - H w x + v x M; M' = B + B^T, B = w x M.
        """
        (w, v), M = motion, full(self.M)
        H, H_T = _rows(self.H), [self.H[k::3] for k in range(3)]
        A = [plus(*rows) for rows in zip(_crossed_columns(w, full(self.J)), _crossed_columns(v, H_T), strict=True)]
        B = _crossed_columns(w, M)
        terms = zip(_crossed_columns(w, H), H, _crossed_columns(v, M), strict=True)
        moved = [minus(plus(one, other), cross(row, w)) for one, row, other in terms]
        return ArticulatedInertia(_doubled(A), _flat(moved), _doubled(B))

    def without(self, forces: Sequence[Spatial], gains: Sequence[Spatial]) -> ArticulatedInertia:
        """Return it less sum of force gain^T, what a joint that gives way does not pass on."""
        J, H, M = list(self.J), list(self.H), list(self.M)
        for (n, f), (a, b) in zip(forces, gains, strict=True):
            places = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))
            J = [J[k] - n[i] * a[j] for k, (i, j) in enumerate(places)]
            M = [M[k] - f[i] * b[j] for k, (i, j) in enumerate(places)]
            H = [H[3 * i + j] - n[i] * b[j] for i in range(3) for j in range(3)]
        return ArticulatedInertia(J, H, M)


def _rows(flat: Sequence[Scalar]) -> list[Vector]:
    return [flat[0:3], flat[3:6], flat[6:9]]


def _flat(rows: Sequence[Vector]) -> list[Scalar]:
    return [entry for row in rows for entry in row]


def _crossed_columns(p: Vector, matrix: Sequence[Vector]) -> list[Vector]:
    """Return [p x] matrix."""
    columns = [cross(p, column) for column in zip(*matrix, strict=True)]
    return [list(row) for row in zip(*columns, strict=True)]


def _doubled(A: Sequence[Vector]) -> Symmetric:
    """Return A + A^T."""
    return [A[i][j] + A[j][i] for i, j in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))]
