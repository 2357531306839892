"""States of two runs in the same charts: in modified Rodrigues parameters of the same set (em_shadow_parameters.h)."""

import numpy as np

from ..arguments.named_values import Vector
from ..runtime import CompiledModel


def in_charts_of(model: CompiledModel, reference: Vector, x: Vector, v: Vector) -> tuple[Vector, Vector]:
    """Return x, v (n, k), where each rotation is in the set that is nearer to that of `reference` (n, k)."""
    x, v = np.array(x), np.array(v)
    for rotation in map(list, model.rotations):
        s, rate = x[rotation], v[rotation]
        square = (s**2).sum(axis=0)
        square[square == 0.0] = np.inf  # the shadow is at infinity
        shadow, turned = -s / square, (2 * (s * rate).sum(axis=0) / square * s - rate) / square
        here, there = (((reference[rotation] - one) ** 2).sum(axis=0) for one in (s, shadow))
        other = there < here
        x[np.ix_(rotation, other)], v[np.ix_(rotation, other)] = shadow[:, other], turned[:, other]
    return x, v
