"""Rotations of vectors, symmetric matrices and general matrices: in a plane, or by a matrix."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from .scalar import Scalar, Vector, dot

Symmetric = Sequence[Scalar]
"""(6,) the entries xx, xy, xz, yy, yz, zz of a symmetric matrix"""
General = Sequence[Scalar]
"""(9,) the entries of a matrix, row by row"""

_PLACES = (0, 1, 2, 1, 3, 4, 2, 4, 5)


class Rotation(Protocol):
    """R, which takes the components of a vector in the child's axes to those in the parent's."""

    def up(self, a: Vector) -> Vector:
        """Return R a."""

    def down(self, a: Vector) -> Vector:
        """Return R^T a."""

    def up_symmetric(self, M: Symmetric) -> Symmetric:
        """Return R M R^T of a symmetric matrix."""

    def up_general(self, H: General) -> General:
        """Return R H R^T."""
        columns = [self.up(H[k::3]) for k in range(3)]
        rows = [self.up([column[k] for column in columns]) for k in range(3)]
        return [entry for row in rows for entry in row]


@dataclass(frozen=True, slots=True)
class PlaneRotation(Rotation):
    """Rotation about an axis of the frame: 0, 1, 2 for x, y, z; cosine and sine of the angle.

    It takes 4 multiplications for a vector, and 7 for a symmetric matrix, where a matrix takes 9 and 30.
    """

    axis: int
    cosine: Scalar
    sine: Scalar

    @property
    def places(self) -> tuple[int, int]:
        """The two axes of the plane."""
        return (self.axis + 1) % 3, (self.axis + 2) % 3

    def up(self, a: Vector) -> Vector:
        """Return R a."""
        return self._turned(a, self.sine)

    def down(self, a: Vector) -> Vector:
        """Return R^T a."""
        return self._turned(a, -self.sine)

    def _turned(self, a: Vector, sine: Scalar) -> Vector:
        (i, j), b = self.places, list(a)
        b[i], b[j] = self.cosine * a[i] - sine * a[j], sine * a[i] + self.cosine * a[j]
        return b

    def up_symmetric(self, M: Symmetric) -> Symmetric:
        """Return R M R^T: with k = s (M_jj - M_ii) - 2 c M_ij, M_ii + s k, M_jj - s k and -M_ij - c k."""
        (i, j), c, s = self.places, self.cosine, self.sine
        ii, jj, ij, ki, kj = (_PLACES[3 * a + b] for a, b in ((i, i), (j, j), (i, j), (self.axis, i), (self.axis, j)))
        k = s * (M[jj] - M[ii]) - c * M[ij] * 2
        N = list(M)
        N[ii], N[jj], N[ij] = M[ii] + s * k, M[jj] - s * k, -M[ij] - c * k
        N[ki], N[kj] = c * M[ki] - s * M[kj], s * M[ki] + c * M[kj]
        return N


@dataclass(frozen=True, slots=True)
class MatrixRotation(Rotation):
    """Rotation by an orthogonal matrix, given by its rows."""

    R: Sequence[Vector]

    def up(self, a: Vector) -> Vector:
        """Return R a."""
        return [dot(row, a) for row in self.R]

    def down(self, a: Vector) -> Vector:
        """Return R^T a."""
        return [dot(column, a) for column in zip(*self.R, strict=True)]

    def up_symmetric(self, M: Symmetric) -> Symmetric:
        """Return R M R^T of a symmetric matrix."""
        full = self.up_general([M[place] for place in _PLACES])
        return [full[k] for k in (0, 1, 2, 4, 5, 8)]


def matrix_vector(M: Symmetric, a: Vector) -> Vector:
    """Return M a of a symmetric matrix."""
    return [dot([M[_PLACES[3 * row + column]] for column in range(3)], a) for row in range(3)]


def full(M: Symmetric) -> list[list[Scalar]]:
    """Return the rows of a symmetric matrix."""
    return [[M[_PLACES[3 * row + column]] for column in range(3)] for row in range(3)]
