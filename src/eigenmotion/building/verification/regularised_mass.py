"""The matrix that is factored where M is singular: M + A^T W A, with weights that the compiled model chose."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from ...arguments.named_values import Vector
from ...system.system import System
from .compiled_values import CompiledValues
from .identities import Identity, flat
from .rounding_bounds import EPS, geometric, rounded
from .symbolic_values import SymbolicValues


def factored(
    system: System, found: CompiledValues, stated: SymbolicValues
) -> tuple[SymbolicValues, Iterator[Identity]]:
    """Return the statement with M + A^T W A and its rate in place of M's, and that the model factors that.

    Any weights will do, of which those that fit are taken, and so are rates of theirs; where M itself is factored, all
    is as it was.
    """
    difference = found.factored - found.M
    if not np.nan_to_num(difference).any():
        return stated, iter(())
    units = 1.0 / geometric(found.factored)
    W = rounded(_weights(stated.A.value, difference, units)[:, :, None])
    turned, rate = stated.A.turned, stated.A_rate.turned
    M = (stated.M + turned @ (W * stated.A)).off(_spread(EPS / units, units))
    M_rate = stated.M_rate + rate @ (W * stated.A) + turned @ (W * stated.A_rate)
    W_rate = rounded(_weights(stated.A.value, found.factored_rate - M_rate.value, units)[:, :, None])
    M_rate = (M_rate + turned @ (W_rate * stated.A)).off(_spread(found.rate_off + M_rate.bound, units))
    names = [f"M + A^T W A of {one}, {two}" for one in system.coordinates for two in system.coordinates]
    same = Identity(names, [flat(rounded(found.factored)), -flat(M)], scale=(1.0 / units).reshape(len(units), -1))
    return replace(stated, M=M, M_rate=M_rate), iter((same,))


def _spread(off: Vector, units: Vector) -> Vector:
    """(k, n, n): how far what the weights make is off where that which they are fitted to is."""
    return np.asarray(np.sqrt(((off * units) ** 2).sum(axis=(1, 2), keepdims=True)) / units)


def _weights(A: Vector, difference: Vector, units: Vector) -> Vector:
    """(k, m): the least squares of A^T W A = difference in `units` (k, n, n); NaN where there are no numbers."""
    columns = np.moveaxis((A[:, :, :, None] * A[:, :, None, :]) * units[:, None], 1, 3).reshape(len(A), -1, A.shape[1])
    right = (difference * units).reshape(len(A), -1)
    size = np.sqrt((columns**2).sum(axis=1, keepdims=True))  # which is how rows are stated, and no matter of rank
    columns = columns / np.where(size > 0.0, size, 1.0)
    known = np.isfinite(columns).all(axis=(1, 2)) & np.isfinite(right).all(axis=1)
    found = np.full(A.shape[:2], np.nan)
    for k in np.flatnonzero(known):
        found[k] = np.linalg.lstsq(columns[k], right[k])[0]
    return found / np.where(size > 0.0, size, 1.0)[:, 0]
