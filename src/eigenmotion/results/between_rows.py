"""Positions and velocities between the rows of a motion, accurate enough for pictures."""

import numpy as np
import scipy

from ..arguments.named_values import Vector


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
