"""Elimination with the best pivot first, in any kind of number.

Not NumPy's: a compiler would wait a tenth of a second for its import.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

Rows = Sequence[Sequence[Any]]


def is_singular(matrix: Rows, sizes: Rows, rounding: float) -> bool:
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
    """Return a matrix with `factors` (n,) times row i added to its rows, and then without row i and column j."""
    return [
        [a + factor * b for l, (a, b) in enumerate(zip(row, matrix[i], strict=True)) if l != j]
        for k, (row, factor) in enumerate(zip(matrix, factors, strict=True)) if k != i
    ]  # fmt: skip


def _part(entry: Any, size: Any) -> float:
    """How much of its terms an entry is."""
    part = float(abs(entry) / size) if size != 0 else 0.0
    return part if part == part else 0.0
