"""Motions that constraints allow, along which reactions do no work."""

from collections.abc import Iterator

import numpy as np

from ...arguments.named_values import Vector
from ..inverse.motion_arguments import Motion
from .slopes import slopes

_DEPENDENT = 1e-9
"""Of the length of a constraint row, in the units of the masses: a row with less of its own adds nothing."""


def free_motions(motion: Motion) -> Iterator[Vector]:
    """Yield N (n, freedoms) of each row: an orthonormal basis, in the units of the masses, of the null space of A."""
    c, n = motion.model, motion.model.n_coordinates
    for k in range(len(motion.t)):
        t, x = float(motion.t[k]), motion.x[k]
        A = c.pfaffian(t, x, motion.prepared)[0][:, :n]
        unit = np.sqrt(np.diag(c.factored_matrix(t, x, motion.prepared))[:n]) if c.m else np.ones(n)
        yield _null_space(A / unit) / unit[:, None] if c.m else np.eye(n)


def _null_space(A: Vector) -> Vector:
    length = np.linalg.norm(A, axis=1)
    _, sizes, V = np.linalg.svd(A[length > 0.0] / length[length > 0.0, None])
    return V[int((sizes > _DEPENDENT).sum()) :].T


def obstacle_of(motion: Motion, columns: list[int]) -> str:
    """Return why forces along free motions are not linear in parameters, or ""."""
    c = motion.model
    if not c.m:
        return ""
    if c.pushes:
        return (f"{c.name}: friction is proportional to reactions, which forces without reactions do not have. State "
                "its limit as a number or a parameter.")  # fmt: skip
    moved = _reactions_move(motion, columns)
    if moved:
        names = ", ".join(repr(c.parameters[k]) for k in moved)
        return (f"{c.name}: constraints depend on {names}, and with them the motions that they allow. Leave them out: "
                "forces along these motions are not linear in them.")  # fmt: skip
    return ""


def _reactions_move(motion: Motion, columns: list[int]) -> list[int]:
    """Return the parameters on which the rows of A depend."""
    some = motion.rows(slice(0, 3))
    factors = np.random.default_rng(7).uniform(0.5, 1.5, motion.model.m)
    change = np.abs(slopes(some, columns, factors) - slopes(some, columns)).max(axis=(0, 1))
    size = np.abs(slopes(some, columns, factors)).max(axis=(0, 1))
    return [column for column, one, most in zip(columns, change, size, strict=True) if one > 1e-12 * most]
