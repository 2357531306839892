"""Elimination with the best pivot first, of matrices in floating point or of any other numbers."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Numbers = NDArray[Any]


def is_singular(matrix: ArrayLike, sizes: ArrayLike, rounding: float) -> bool:
    """Whether elimination comes to a remainder that is nothing but rounding; entries that are not finite make it so.

    Each entry is judged by what it is beside the sum of the absolute values that made it, which rows and columns in
    other units leave as it is; the pivot is the entry that cancelled least.

    Parameters
    ----------
    matrix
        (n, n), of any kind of number.
    sizes
        (n, n): of the terms that made each entry, such as |cos(x)| + |x sin(x)|.
    rounding
        The part of its terms that an entry must exceed to count.
    """
    rest, size = np.array(matrix), np.array(sizes)
    with np.errstate(all="ignore"):
        while rest.size:
            parts = _parts(rest, size)
            i, j = np.unravel_index(parts.argmax(), parts.shape)
            if parts[i, j] <= rounding:
                return True
            factors = rest[:, j] / rest[i, j]
            rest, size = without(rest, i, j, -factors), without(size, i, j, abs(factors))
    return False


def without(matrix: Numbers, i: Any, j: Any, factors: Numbers) -> Numbers:
    """Return a matrix with `factors` (n,) times row i added to its rows, and then without row i and column j."""
    return np.delete(np.delete(matrix + np.outer(factors, matrix[i]), i, 0), j, 1)


def _part(entry: Any, size: Any) -> float:
    """How much of its terms an entry is."""
    part = float(abs(entry) / size) if size != 0 else 0.0
    return part if part == part else 0.0


_parts = np.vectorize(_part, otypes=[float])
