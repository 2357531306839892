"""Gaussian elimination with full pivoting, for any number type.

It does not use NumPy, whose import would delay a build by a tenth of a second.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

Rows = Sequence[Sequence[Any]]


def is_singular(matrix: Rows, sizes: Rows, rounding: float) -> bool:
    """Whether elimination leaves a remainder that is only rounding error; entries that are not finite count as such.

    Each entry is compared with the sum of the absolute values of its terms. This ratio does not change if rows and
    columns are scaled to other units. The pivot is the entry with the least cancellation.

    Parameters
    ----------
    matrix
        (n, n), of any number type.
    sizes
        (n, n): the sum of the absolute values of each entry's terms, such as |cos(x)| + |x sin(x)|.
    rounding
        An entry counts as nonzero if its ratio to `sizes` exceeds this.
    """
    rest, size = matrix, sizes
    while rest:
        part, i, j = max((_part(a, size[i][j]), i, j) for i, row in enumerate(rest) for j, a in enumerate(row))
        if part <= rounding:
            return True
        factors = [row[j] / rest[i][j] for row in rest]
        rest = without(rest, i, j, [-factor for factor in factors])
        size = without(size, i, j, [abs(factor) for factor in factors])
    return False


def without(matrix: Rows, i: int, j: int, factors: Sequence[Any]) -> list[list[Any]]:
    """Add `factors` (n,) times row i to the rows of a matrix, then delete row i and column j."""
    return [
        [a + factor * b for l, (a, b) in enumerate(zip(row, matrix[i], strict=True)) if l != j]
        for k, (row, factor) in enumerate(zip(matrix, factors, strict=True)) if k != i
    ]  # fmt: skip


def _part(entry: Any, size: Any) -> float:
    """Return the ratio of an entry to the size of its terms, 0 where that is not a number."""
    part = float(abs(entry) / size) if size != 0 else 0.0
    return part if part == part else 0.0
