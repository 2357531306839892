"""Numbers with bounds of their rounding error: running error analysis (Higham 2002, section 3.3).

The bound is, to first order, the error of an evaluation if every term has a relative error of eps. It does not depend
on the order in which terms are added: another evaluation of the same terms differs by a small multiple of it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
import sympy

Part: TypeAlias = Any
"""An array or a number."""

EPS = float(np.finfo(float).eps)
FACTOR = 1e3
"""Values that differ by more than this many bounds are different; equivalent expressions differ by a few bounds."""


@dataclass(frozen=True, slots=True, eq=False)
class Rounded:
    """Values and their error bounds; arrays that broadcast against each other."""

    value: Part
    bound: Part

    __array_ufunc__ = None

    def __add__(self, other: Rounded) -> Rounded:
        return Rounded(self.value + other.value, self.bound + other.bound)

    def __sub__(self, other: Rounded) -> Rounded:
        return Rounded(self.value - other.value, self.bound + other.bound)

    def __neg__(self) -> Rounded:
        return Rounded(-self.value, self.bound)

    def __mul__(self, other: Rounded) -> Rounded:
        bound = np.abs(self.value) * other.bound + self.bound * (np.abs(other.value) + other.bound)
        return Rounded(self.value * other.value, bound)

    def __rmul__(self, factor: Part) -> Rounded:
        """Return factor * self for an exact factor, such as a power of two."""
        return Rounded(factor * self.value, np.abs(factor) * self.bound)

    def __truediv__(self, divisor: Rounded) -> Rounded:
        inverse = 1.0 / divisor.value
        return self * Rounded(inverse, np.where(divisor.near(), np.inf, inverse**2 * divisor.bound))

    def __matmul__(self, other: Rounded) -> Rounded:
        bound = np.abs(self.value) @ other.bound + self.bound @ (np.abs(other.value) + other.bound)
        return Rounded(self.value @ other.value, bound)

    def __getitem__(self, key: Any) -> Rounded:
        return Rounded(self.value[key], self.bound[key])

    @property
    def turned(self) -> Rounded:
        """The transposed matrices of (k, i, j)."""
        return Rounded(self.value.swapaxes(1, 2), self.bound.swapaxes(1, 2))

    def near(self, other: Part = 0.0) -> Part:
        """Return whether the values may equal another number within their bounds."""
        return ~(np.abs(self.value - other) > FACTOR * self.bound)

    def off(self, more: Part) -> Rounded:
        """Return the same values with larger bounds."""
        return Rounded(self.value, self.bound + more)

    def filled(self, shape: tuple[int, ...]) -> Rounded:
        """Return the numbers broadcast to this shape."""
        return Rounded(*(np.array(np.broadcast_to(part, shape), dtype=float) for part in (self.value, self.bound)))


def rounded(value: Part) -> Rounded:
    """Return values with the relative error bound eps."""
    return Rounded(value, EPS * np.abs(value))


def constant(number: sympy.Basic) -> Rounded:
    """Return the value of a constant: whole numbers are exact, others are rounded once."""
    value = np.float64(number)
    return Rounded(value, 0.0) if number.is_Integer and int(value) == number else rounded(value)


def joined(parts: Sequence[Rounded], axis: int) -> Rounded:
    """Return the concatenation of arrays."""
    values, bounds = [part.value for part in parts], [part.bound for part in parts]
    return Rounded(np.concatenate(values, axis), np.concatenate(bounds, axis))


def applied(W: Rounded, v: Rounded) -> Rounded:
    """Return the products W v of matrices (k, i, j) and vectors (k, j)."""
    return (W @ v[:, :, None])[:, :, 0]


def inverse(M: Rounded) -> Rounded:
    """Return the pseudo-inverses of symmetric M (k, n, n), with infinite bounds if M may be singular."""
    unit = np.sqrt(np.abs(np.einsum("kii->ki", M.value)))
    unit = np.where(unit > 0.0, unit, 1.0)
    size = unit[:, :, None] * unit[:, None, :]
    fine = np.asarray(np.isfinite(M.value + M.bound).all(axis=(1, 2)))[:, None, None]
    W = np.linalg.pinv(np.where(fine, M.value / size, 0.0), hermitian=True)
    moved = np.abs(W) @ np.where(fine, M.bound / size, 0.0)
    whole = np.abs(np.einsum("kij,kji->k", W, np.where(fine, M.value / size, 0.0)) - W.shape[1]) < 0.5
    known = fine & (FACTOR * moved.sum(axis=2, keepdims=True).max(axis=1, keepdims=True, initial=0.0) < 1.0)
    known &= whole[:, None, None]
    return Rounded(np.where(fine, W / size, np.nan), np.where(known, moved @ np.abs(W) / size, np.inf))


def root(M: Rounded) -> Rounded:
    """Return triangular L (k, n, n), M = L L^T, with infinite bounds if M may not be positive definite."""
    W = inverse(M)
    sound = np.isfinite(W.bound).all(axis=(1, 2), keepdims=True) & (np.linalg.eigvalsh(
        np.where(np.isfinite(M.value), M.value, 0.0))[:, :1, None] > 0.0)  # fmt: skip
    L = np.linalg.cholesky(np.where(sound, M.value, np.eye(M.value.shape[1])))
    back = np.linalg.inv(L)
    inner = np.tril(np.abs(back) @ np.where(sound, M.bound, 0.0) @ np.abs(back).swapaxes(1, 2))
    return Rounded(L, np.where(sound, np.abs(L) @ inner, np.inf))


def geometric(M: Part) -> Part:
    """Return sqrt(M_ii M_jj), (k, n, n): a size of the entries that is independent of units."""
    diagonal = np.sqrt(np.abs(np.einsum("kii->ki", M)))
    return np.asarray(diagonal[:, :, None] * diagonal[:, None, :])
