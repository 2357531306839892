"""Forces of a motion's rows, and their derivatives by parameters and inputs."""

import numpy as np

from ...arguments.named_values import Vector
from ...runtime.variations import equation_partials
from ..inverse.motion_arguments import Motion


def required(motion: Motion) -> Vector:
    """Return M a - f (rows, n)."""
    rows: Vector = motion.model.required_rows(*motion.arguments)[0]
    return rows[:, : motion.model.n_coordinates]


def slopes(motion: Motion, columns: list[int], multipliers: Vector | None = None) -> Vector:
    """Return the derivatives (rows, n, k) of M a - f by parameters; with multipliers (m,), of M a - f + P^T lambda."""
    first = 2 * motion.model.n + motion.model.n_inputs
    return _partials(motion, [first + k for k in columns], multipliers)


def input_slopes(motion: Motion, inputs: list[int]) -> Vector:
    """Return the derivatives (rows, n, k) of M a - f by inputs."""
    return _partials(motion, [2 * motion.model.n + k for k in inputs], None)


def _partials(motion: Motion, places: list[int], multipliers: Vector | None) -> Vector:
    c = motion.model
    factors = np.zeros(c.m) if multipliers is None else multipliers
    t, x, v, a, u, prepared = motion.arguments
    made = np.empty((len(t), c.n_coordinates, len(places)))
    for k in range(len(t)):
        made[k] = equation_partials(c, float(t[k]), x[k], v[k], a[k], factors, prepared, u[k])[
            : c.n_coordinates, places
        ]
    return made
