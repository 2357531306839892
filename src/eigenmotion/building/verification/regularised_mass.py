"""Regularised mass matrix M + A^T W A, which is factored if M is singular, with the weights of the compiled model."""

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
    system: System, compiled: CompiledValues, symbolic: SymbolicValues
) -> tuple[SymbolicValues, Iterator[Identity]]:
    """Return the symbolic values with M + A^T W A and its rate in place of M, and identities of the matrix.

    Any weights W are valid, so W and its rate are fitted to the compiled values. If M itself is factored, nothing
    changes.
    """
    difference = compiled.factored - compiled.M
    if not np.nan_to_num(difference).any():
        return symbolic, iter(())
    units = 1.0 / geometric(compiled.factored)
    W = rounded(_weights(symbolic.A.value, difference, units)[:, :, None])
    turned, rate = symbolic.A.turned, symbolic.A_rate.turned
    M = (symbolic.M + turned @ (W * symbolic.A)).off(_spread(EPS / units, units))
    M_rate = symbolic.M_rate + rate @ (W * symbolic.A) + turned @ (W * symbolic.A_rate)
    W_rate = rounded(_weights(symbolic.A.value, compiled.factored_rate - M_rate.value, units)[:, :, None])
    M_rate = (M_rate + turned @ (W_rate * symbolic.A)).off(_spread(compiled.rate_off + M_rate.bound, units))
    names = [
        f"M + A^T W A of {one}, {two}" for one in system.compiled.coordinates for two in system.compiled.coordinates
    ]
    same = Identity(names, [flat(rounded(compiled.factored)), -flat(M)], scale=(1.0 / units).reshape(len(units), -1))
    return replace(symbolic, M=M, M_rate=M_rate), iter((same,))


def _spread(off: Vector, units: Vector) -> Vector:
    """Return the error (k, n, n) of A^T W A that follows from errors of the matrix to which W is fitted."""
    return np.asarray(np.sqrt(((off * units) ** 2).sum(axis=(1, 2), keepdims=True)) / units)


def _weights(A: Vector, difference: Vector, units: Vector) -> Vector:
    """Return the least-squares solution W (k, m) of A^T W A = difference, in `units` (k, n, n); NaN if not finite."""
    columns = np.moveaxis((A[:, :, :, None] * A[:, :, None, :]) * units[:, None], 1, 3).reshape(len(A), -1, A.shape[1])
    right = (difference * units).reshape(len(A), -1)
    size = np.sqrt((columns**2).sum(axis=1, keepdims=True))  # units of rows are arbitrary and must not affect the rank
    columns = columns / np.where(size > 0.0, size, 1.0)
    known = np.isfinite(columns).all(axis=(1, 2)) & np.isfinite(right).all(axis=1)
    W = np.full(A.shape[:2], np.nan)
    for k in np.flatnonzero(known):
        W[k] = np.linalg.lstsq(columns[k], right[k])[0]
    return W / np.where(size > 0.0, size, 1.0)[:, 0]
