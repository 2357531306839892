"""The matrix M + A^T W A that is factored if M is singular, with the weights of the compiled model."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from ...arguments.named_values import Vector
from ...system.system import System
from .arithmetic.rounding_bounds import EPS, geometric, rounded
from .compiled_values import CompiledValues
from .identities import Identity, flat
from .symbolic_values import SymbolicValues


def factored(
    system: System, found: CompiledValues, stated: SymbolicValues
) -> tuple[SymbolicValues, Iterator[Identity]]:
    """Return the symbolic values with M + A^T W A and its rate in place of those of M, and the matrix's identities.

    Any weights W are valid, so W and its rate are fitted to the compiled values. If M itself is factored, nothing
    changes.
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
    names = [
        f"M + A^T W A of {one}, {two}" for one in system.compiled.coordinates for two in system.compiled.coordinates
    ]
    same = Identity(names, [flat(rounded(found.factored)), -flat(M)], scale=(1.0 / units).reshape(len(units), -1))
    return replace(stated, M=M, M_rate=M_rate), iter((same,))


def _spread(off: Vector, units: Vector) -> Vector:
    """(k, n, n): the error of A^T W A that follows from errors of the matrix to which W is fitted."""
    return np.asarray(np.sqrt(((off * units) ** 2).sum(axis=(1, 2), keepdims=True)) / units)


def _weights(A: Vector, difference: Vector, units: Vector) -> Vector:
    """(k, m): the least-squares solution W of A^T W A = difference, in `units` (k, n, n); NaN if not finite."""
    columns = np.moveaxis((A[:, :, :, None] * A[:, :, None, :]) * units[:, None], 1, 3).reshape(len(A), -1, A.shape[1])
    right = (difference * units).reshape(len(A), -1)
    size = np.sqrt((columns**2).sum(axis=1, keepdims=True))  # units of rows are arbitrary and do not affect the rank
    columns = columns / np.where(size > 0.0, size, 1.0)
    known = np.isfinite(columns).all(axis=(1, 2)) & np.isfinite(right).all(axis=1)
    found = np.full(A.shape[:2], np.nan)
    for k in np.flatnonzero(known):
        found[k] = np.linalg.lstsq(columns[k], right[k])[0]
    return found / np.where(size > 0.0, size, 1.0)[:, 0]
