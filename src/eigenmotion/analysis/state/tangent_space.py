"""Tangent space of the constraints: the null space of the derivatives of phi and A v + b."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy

from ...arguments.named_values import Vector
from .operating_point import OperatingPoint

_DEPENDENT = 3e-6
"""Least part of a unit row that is independent of other rows: the square root of EM_DEPENDENT (em_rank.h)."""

_VANISHED = 1e-13
"""A row shorter than this part of the longest is zero, as in runs: the square root of EM_VANISHED (em_linear.h)."""

_PREFERRED = 100.0
"""Factor by which the columns that are to be dependent are scaled."""


@dataclass(frozen=True, slots=True)
class Tangent:
    """Deviations (dx, dv) = Z z of a state, where z are the deviations of independent coordinates and velocities.

    Z : (2 n, k); free : (k,) indices of z among the 2 n numbers, so that Z[free] is the unit matrix
    """

    Z: Vector
    free: tuple[int, ...]


def tangent(at: OperatingPoint, dependent: Sequence[int] = ()) -> Tangent:
    """Return the tangent space of the constraints, without integrals of states, on which nothing depends.

    The dependent coordinates are those that the constraints determine best, scaled by their inertia. `dependent` names
    velocities that are to be dependent.
    """
    n, h = at.model.n, at.model.h
    rows, unit = at.constraints, 1.0 / at.inertia
    x_free, Nx, _ = null_space(rows[:h, :n], unit)
    v_free, Nv, lifted = null_space(rows[h:, n : 2 * n], unit, -rows[h:, :n] @ Nx, dependent)
    Z = np.block([[Nx, np.zeros((n, len(v_free)))], [lifted, Nv]])
    free = (*x_free, *(n + k for k in v_free))
    kept = [k for k, number in enumerate(free) if not at.coordinates <= number < n]
    return Tangent(Z[:, kept], tuple(free[k] for k in kept))


def null_space(
    A: Vector, unit: Vector, right: Vector | None = None, first: Sequence[int] = ()
) -> tuple[list[int], Vector, Vector]:
    """Return the free columns of A (m, n), N (n, free) with A N = 0 and N[free] = 1, and X with A X = right.

    The rows `free` of X are zero. The result does not depend on units of rows and columns. `first`: columns that should
    not be free.
    """
    n = A.shape[1]
    unit = unit.copy()
    unit[list(first)] *= _PREFERRED
    right = np.zeros((len(A), 0)) if right is None else right
    scaled = A * unit
    length = np.sqrt((scaled**2).sum(axis=1))
    length = np.where(length > _VANISHED * length.max(initial=0.0), length, np.inf)[:, None]
    if not len(A):
        return list(range(n)), np.eye(n), np.zeros((n, right.shape[1]))
    Q, R, order = scipy.linalg.qr(scaled / length, mode="economic", pivoting=True)
    rank = int((np.abs(np.diag(R)) > _DEPENDENT).sum())
    fixed, free = order[:rank], np.sort(order[rank:])
    place = {k: at for at, k in enumerate(order)}
    both = np.hstack([-R[:rank, [place[k] for k in free]] / unit[free], (Q.T @ (right / length))[:rank]])
    dependent = scipy.linalg.solve_triangular(R[:rank, :rank], both) * unit[fixed][:, None]
    N, X = np.zeros((n, len(free))), np.zeros((n, right.shape[1]))
    N[free, range(len(free))] = 1.0
    N[fixed], X[fixed] = np.split(dependent, [len(free)], axis=1)
    return free.tolist(), N, X


def shift(at: OperatingPoint, column: int) -> Vector:
    """Return (2 n,) changes of dependent coordinates and velocities with one argument of the constraints.

    column : its place among the arguments: x, v, inputs, parameters. Those of `tangent(at).free` do not change.
    """
    n, h = at.model.n, at.model.h
    rows, unit = at.constraints, 1.0 / at.inertia
    x = null_space(rows[:h, :n], unit, -rows[:h, [column]])[2]
    v = null_space(rows[h:, n : 2 * n], unit, -rows[h:, :n] @ x - rows[h:, [column]])[2]
    return np.concatenate([x, v])[:, 0]
