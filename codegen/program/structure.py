"""Structural zeros of the equations of motion: which entries of M and of the constraint rows can differ from 0."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from ..equations.terms import Rows, Terms


@dataclass(frozen=True, slots=True)
class Structure:
    """Places of the entries that are not structurally zero.

    masses : of M (n, n); rows : of A (m, n)
    chained : (n, n) pairs of coordinates on one path from the ground, if C adds the trees in loops, which are then
        missing in the kernels of partial derivatives: these depend on the coordinates of such pairs
    """

    masses: frozenset[tuple[int, int]]
    rows: frozenset[tuple[int, int]]
    chained: frozenset[tuple[int, int]]


def structure_of(terms: Terms) -> Structure:
    """Return the structure of the terms of which there are derivatives."""
    chained = frozenset(_chained(terms)) if terms.scene.in_loops else frozenset()
    return Structure(frozenset(_nonzero(terms, terms.M)) | chained, frozenset(_nonzero(terms, terms.A)), chained)


def _nonzero(terms: Terms, rows: Rows) -> Iterator[tuple[int, int]]:
    zero = terms.graph.zero
    return ((i, j) for i, row in enumerate(rows) for j, node in enumerate(row) if node != zero)


def _chained(terms: Terms) -> Iterator[tuple[int, int]]:
    """Yield the pairs of coordinates of which one moves the body of the other."""
    trees = terms.mechanics.trees
    rows = trees.table.rows if trees and trees.table else ()
    moving: list[tuple[int, ...]] = []
    for row in rows:
        moving.append((*(moving[row.parent] if row.parent >= 0 else ()), *row.coordinates))
        for i in row.coordinates:
            for j in moving[-1]:
                yield i, j
                yield j, i
