"""Whether a matrix of numbers is singular, in whatever units its rows and columns are."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any


def is_singular(matrix: Sequence[Sequence[Any]], sizes: Sequence[Sequence[Any]], rounding: float) -> bool:
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
    rest = [list(zip(row, terms, strict=True)) for row, terms in zip(matrix, sizes, strict=True)]
    while rest:
        part, i, j = max((_part(*entry), i, j) for i, row in enumerate(rest) for j, entry in enumerate(row))
        if part <= rounding:
            return True
        pivot_row = rest.pop(i)
        pivot, _ = pivot_row.pop(j)
        for row in rest:
            factor, _ = row.pop(j)
            factor /= pivot
            row[:] = [(a - factor * b, size + abs(factor) * b_size)
                      for (a, size), (b, b_size) in zip(row, pivot_row, strict=True)]  # fmt: skip
    return False


def _part(entry: Any, size: Any) -> float:
    """How much of its terms an entry is."""
    part = float(abs(entry) / size) if size != 0 else 0.0
    return part if part == part else 0.0
