"""Test that forces are linear in parameters: at random values of these, and at random states.

Forces are analytic functions of parameters, apart from kinks. One that is not linear differs from its linear part at
almost all values, so that random ones show it.
"""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from ...runtime import EvaluationError, Prepared
from ..inverse.motion_arguments import Motion
from .slopes import required, slopes

_LINEAR = 1e-9
"""A change of slopes, relative to these, that counts as none."""
_ROUNDED = 1e-12
"""Rounding errors of forces, relative to these."""
_ROWS = 5
"""States of the motion that are tried, and as many random ones."""
_TRIALS = 3
_NEARER = (1.0, 0.25, 1 / 16, 1 / 64, 1 / 512)
"""Changes of parameters, relative to them: the largest with which the model can be evaluated is tried."""


def check_linear(motion: Motion, columns: list[int]) -> None:
    """Raise ModelError if forces are not linear in the parameters with these indices; names those at fault."""
    some = _states(motion)
    p = np.array(motion.prepared.parameters)[columns]
    spread = np.where(p != 0.0, np.abs(p), np.median(np.abs(p[p != 0.0])) if p.any() else 1.0)
    Y, r = slopes(some, columns), required(some)
    known = np.isfinite(Y).all(axis=(1, 2)) & np.isfinite(r).all(axis=1)
    some, Y, r = some.rows(known), Y[known], r[known]
    largest = np.abs(Y).max(axis=0, initial=0.0) * spread
    size = np.abs(r).max(axis=0, initial=0.0)[:, None] + largest.sum(axis=1, keepdims=True)
    for change in _changes(motion, columns, spread):
        other = some.in_mode(_with(motion, columns, p + change))
        differ = np.abs(slopes(other, columns) - Y) * spread
        bad = (differ > _LINEAR * largest + _ROUNDED * size).any(axis=(0, 1))
        if bad.any():
            raise ModelError(_words(some, columns, p, change, bad))
        left = np.abs(required(other) - r - Y @ change)
        if (left > _LINEAR * (largest.sum(axis=1)) + _ROUNDED * size[:, 0]).any():
            names = ", ".join(repr(motion.model.parameters[k]) for k in columns)
            raise ModelError(f"{motion.model.name}: forces are not linear in {names}.")


def _states(motion: Motion) -> Motion:
    """Return a few rows of a motion, and as many at random about them."""
    count = len(motion.t)
    few = motion.rows(np.unique(np.linspace(0, count - 1, min(count, _ROWS)).astype(int)))
    random, shape = np.random.default_rng(11), few.x.shape
    moved = (
        few.x + random.uniform(-0.5, 0.5, shape),
        few.v + random.normal(size=shape),
        few.a + random.normal(size=shape),
    )
    x, v, a = (np.vstack(pair) for pair in zip((few.x, few.v, few.a), moved, strict=True))
    return replace(few, t=np.tile(few.t, 2), x=x, v=v, a=a, u=np.vstack([few.u, few.u]))


def _changes(motion: Motion, columns: list[int], spread: Vector) -> Iterator[Vector]:
    """Yield random changes (k,) of parameters with which the model can be evaluated."""
    random, p = np.random.default_rng(5), np.array(motion.prepared.parameters)[columns]
    for _ in range(_TRIALS):
        direction = random.uniform(0.3, 0.9, len(columns)) * random.choice([-1.0, 1.0], len(columns))
        for nearer in _NEARER:
            try:
                _with(motion, columns, p + nearer * spread * direction)
            except EvaluationError:
                continue
            yield nearer * spread * direction
            break
        else:
            names = ", ".join(repr(motion.model.parameters[k]) for k in columns)
            raise ModelError(f"{motion.model.name}: with other values of {names} it cannot be evaluated, so that "
                             "nothing shows whether forces are linear in them. Give other `values`.")  # fmt: skip


def _with(motion: Motion, columns: list[int], p: Vector) -> Prepared:
    parameters = np.array(motion.prepared.parameters)
    parameters[columns] = p
    return motion.model.prepare(parameters)


def _words(some: Motion, columns: list[int], p: Vector, change: Vector, bad: Vector) -> str:
    """Return the message of slopes that change: which of them, and with which parameter."""
    c, Y = some.model, slopes(some, columns)
    k = int(np.flatnonzero(bad)[0])
    own, moved = c.parameters[columns[k]], []
    for j, column in enumerate(columns):
        other = slopes(some.in_mode(_with(some, columns, p + change * (np.arange(len(p)) == j))), columns)
        if (np.abs(other - Y)[..., k] > _LINEAR * np.abs(Y[..., k]).max()).any():
            moved.append(c.parameters[column])
    if own in moved or not moved:
        return f"{c.name}: forces are not linear in parameter {own!r}. Leave it out, or state the model by others."
    return (f"{c.name}: forces contain the product of parameters {own!r} and {moved[0]!r}. Leave one out, or state the "
            "model by their product.")  # fmt: skip
