"""Rotations by modified Rodrigues parameters s, which a run replaces by their shadow set -s / |s|^2: the same rotation.

Two runs may do so at different times. Their rows are compared in the set of the one that is expected.
"""

from collections.abc import Sequence

import numpy as np

from ..arguments.named_values import Vector


def in_sets_of(expected: Vector, rows: Vector, n: int, rotations: Sequence[Sequence[int]]) -> Vector:
    """Return rows (k, 2n + p) of (x, v, z) with each rotation in whichever of its two sets is nearer to `expected`.

    rotations : the three coordinates of each
    """
    if not rotations:
        return rows
    turned = rows.copy()
    for triple in rotations:
        s, rate = (turned[:, [first + k for k in triple]] for first in (0, n))
        other, other_rate = _shadow(s, rate)
        goal = expected[:, list(triple)]
        is_nearer = np.linalg.norm(other - goal, axis=1) < np.linalg.norm(s - goal, axis=1)
        for first, own, shadow in ((0, s, other), (n, rate, other_rate)):
            turned[:, [first + k for k in triple]] = np.where(is_nearer[:, None], shadow, own)
    return turned


def _shadow(s: Vector, rate: Vector) -> tuple[Vector, Vector]:
    """Return the shadow sets (k, 3) and their rates; NaN for s = 0, which has none."""
    with np.errstate(all="ignore"):
        square, along = (np.sum(s * factor, axis=1, keepdims=True) for factor in (s, rate))
        return -s / square, (2 * s * along / square - rate) / square
