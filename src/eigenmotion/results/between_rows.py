"""Motions between their rows: positions and velocities for pictures, and passages through given values."""

from collections.abc import Callable

import numpy as np
import scipy

from ..arguments.named_values import Vector
from ..codegen.model.normalise import ModelError

_WITHIN = 8  # points of each step at which the direction is looked at
_HALVINGS = 60  # of a step: to rounding
_ROUNDED = 64 * np.finfo(float).eps
"""Rounding error of an end of a motion, relative to the larger one."""


def between(t: Vector, x: Vector, v: Vector, at: Vector) -> tuple[Vector, Vector]:
    """Return x, v (j, n) at times at (j,) between the rows t (k,), x, v (k, n): cubic Hermite interpolation."""
    sign = 1.0 if t[-1] >= t[0] else -1.0
    jumps = np.flatnonzero(np.diff(t) == 0) + 1  # an event action has a row before and a row after it
    segments = [rows for rows in np.split(np.arange(len(t)), jumps) if len(rows) > 1]
    positions, velocities = (np.repeat(columns[:1], len(at), axis=0) for columns in (x, v))
    last = np.full(len(at), -1)
    for number, rows in enumerate(segments):
        last[sign * at >= sign * t[rows[0]]] = number
    for number, rows in enumerate(segments):
        cubics = scipy.interpolate.CubicHermiteSpline(sign * t[rows], x[rows], sign * v[rows])
        here = sign * at[last == number]
        positions[last == number], velocities[last == number] = cubics(here), sign * cubics(here, 1)
    return positions, velocities


def passages(name: str, q: Callable[[Vector], Vector], ends: Vector, values: Vector) -> Vector:
    """Return the times (j,) at which q(t) passes values (j,), which are in the order of the run.

    Parameters
    ----------
    q
        The coordinate at times (k,).
    ends
        (k,) the ends of the steps, in the order of the run.

    Raises
    ------
    ModelError
        q turns back during the run, or does not reach a value.
    """
    part = np.arange(_WITHIN) / _WITHIN
    t = np.append((ends[:-1, None] + np.diff(ends)[:, None] * part).ravel(), ends[-1])
    x = q(t)
    sign = 1.0 if x[-1] >= x[0] else -1.0
    if (turned := np.diff(sign * x) < 0.0).any():
        raise ModelError(
            f"{name} turns back at t = {t[int(np.argmax(turned))]:.6g}, and passes some values twice: end the run "
            "before, or take rows over the time"
        )
    low, high = sorted((float(x[0]), float(x[-1])))
    rounded = _ROUNDED * max(-low, high)  # rows are on the constraints, and values between them beside these
    if outside := [value for value in values.tolist() if not low - rounded <= value <= high + rounded]:
        raise ModelError(f"{name} does not reach {outside[0]:.6g}: it goes from {x[0]:.6g} to {x[-1]:.6g}")
    after = np.clip(np.searchsorted(sign * x, sign * values), 1, len(t) - 1)
    before, behind = t[after - 1], t[after]
    for _ in range(_HALVINGS):
        middle = (before + behind) / 2
        is_past = sign * q(middle) >= sign * values
        before, behind = np.where(is_past, before, middle), np.where(is_past, middle, behind)
    return np.asarray(behind)
