"""Symbolic inverse of a small symmetric matrix by cofactors with shared minors: the paper's "brute force"."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

from ..graph.graph import Graph
from ..graph.store import Node

LARGEST = 6
"""The largest size for which a symbolic inverse is formed; the number of its minors grows like 4^n."""


def inverse(graph: Graph, M: Sequence[Sequence[Node]]) -> tuple[list[list[Node]], Node]:
    """Return M^-1 (n, n), as cofactors divided by the determinant (Cramer's rule), and the determinant.

    Minors are expanded along their first row; each is computed once.
    """
    n = len(M)

    @cache
    def minor(rows: tuple[int, ...], columns: tuple[int, ...]) -> Node:
        if not rows:
            return graph.one
        terms = []
        for place, column in enumerate(columns):
            rest = columns[:place] + columns[place + 1 :]
            terms.append((graph.mul(M[rows[0]][column], minor(rows[1:], rest)), (-1) ** place))
        return graph.sum(terms)

    every = tuple(range(n))
    determinant = minor(every, every)
    over = graph.power(determinant, -1)
    result = [[graph.zero] * n for _ in range(n)]
    for i in every:
        for j in every[: i + 1]:
            cofactor = minor(every[:i] + every[i + 1 :], every[:j] + every[j + 1 :])
            result[i][j] = result[j][i] = graph.scale(graph.mul(cofactor, over), (-1) ** (i + j))
    return result, determinant
