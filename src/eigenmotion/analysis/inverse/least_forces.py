"""The least forces of actuators for which reactions are within bounds.

    minimise tau^T W tau   subject to   B tau - P^T lambda = r,  G lambda >= 0

Of multipliers that leave tau the least, those with the least sum of squares are taken. A problem of least distance
[Lawson and Hanson, Solving Least Squares Problems (1974), chapter 23] finds which bounds are reached; these are then
equations, so that the result has no error of an iteration.
"""

import numpy as np
import scipy
from numpy.typing import NDArray

from ...arguments.named_values import Vector

_DEPENDENT = 1e-9
"""A singular value of a matrix with columns of length one, or less, that counts as zero."""
_UNDRIVEN = 1e-8
"""Part of r that counts as zero: EM_DRIVEN of C."""
_INFEASIBLE = 1e-7
"""Distance of the dual problem that counts as zero: the least forces would be larger than its inverse."""
_OF_MULTIPLIERS = 1e-5
"""Weight of multipliers beside that of forces, where both are minimised at once."""


def least_forces(B: Vector, P: Vector, r: Vector, G: Vector, weights: Vector) -> tuple[Vector, Vector] | None:
    """Return tau (count,) and lambda (m,); None if there are none.

    Parameters
    ----------
    B, P, r
        (n, count), (m, n), (n,).
    G
        (bounds, m), without rows of zeros.
    weights
        (count,) of the squares of tau, positive.
    """
    count, G = B.shape[1], np.hstack([np.zeros((len(G), B.shape[1])), G])
    lengths, size = np.linalg.norm(P, axis=1), np.linalg.norm(B / np.sqrt(weights), axis=0).max(initial=0.0) or 1.0
    lengths[lengths == 0.0] = 1.0
    scale = np.concatenate([1.0 / np.sqrt(weights) / size, 1.0 / lengths])
    K, G = np.hstack([B, -P.T]) * scale, G * scale
    G = G / np.linalg.norm(G, axis=1)[:, None]
    reached = _reached(K, r, G, count)
    if reached is None:
        return None
    y = _least(np.vstack([K, G[reached]]), np.concatenate([r, np.zeros(len(reached))]), count) * scale
    return y[:count], y[count:]


def _reached(K: Vector, r: Vector, G: Vector, count: int) -> NDArray[np.intp] | None:
    """Return the bounds (indices) that the least y with K y = r, G y >= 0 reaches; None if there is no y."""
    D = np.ones(K.shape[1])
    D[count:] = _OF_MULTIPLIERS
    y, Z = _solutions(K, r)
    if np.linalg.norm(K @ y - r) > _UNDRIVEN * np.linalg.norm(r):
        return None
    Q, R = np.linalg.qr(D[:, None] * Z)
    along = np.linalg.solve(R.T, (G @ Z).T).T if Z.shape[1] else np.zeros((len(G), 0))
    least = along @ (Q.T @ (D * y)) - G @ y  # along w >= least, with w of the least length
    lengths, moving = np.linalg.norm(along, axis=1), np.linalg.norm(G @ Z, axis=1) > _DEPENDENT
    rounded = _DEPENDENT * (np.abs(G) @ np.abs(y))
    if (least > rounded)[~moving].any():
        return None
    unit, far = along[moving] / lengths[moving, None], (least - rounded)[moving] / lengths[moving]
    if not (far > 0.0).any():
        return np.flatnonzero(moving)[:0]
    u, distance = scipy.optimize.nnls(
        np.vstack([unit.T, far[None] / far.max()]), np.append(np.zeros(unit.shape[1]), 1.0)
    )
    return np.flatnonzero(moving)[u > 0.0] if distance > _INFEASIBLE else None


def _least(K: Vector, right: Vector, count: int) -> Vector:
    """Return y with K y = right, of which the first `count` have the least norm, and then the others."""
    y, Z = _solutions(K, right)
    for part in (slice(None, count), slice(count, None)):
        if Z.shape[1]:
            move, rest = _solutions(Z[part], -y[part])
            y, Z = y + Z @ move, Z @ rest
    return y


def _solutions(K: Vector, right: Vector) -> tuple[Vector, Vector]:
    """Return the least squares solution y of K y = right, and an orthonormal basis of K z = 0.

    Columns of K have lengths near one, or are parts of orthonormal columns: singular values are compared with one.
    """
    U, sizes, V = np.linalg.svd(K)
    rank = int((sizes > _DEPENDENT).sum())
    return V[:rank].T @ ((U[:, :rank].T @ right) / sizes[:rank]), V[rank:].T
