"""Regularisation of a mass matrix that is singular for every x, but regular on the constraints (augmented Lagrangian).

For a quaternion with |q| = 1, or a massless coordinate in a constraint, M has no inverse but [M A^T; A 0] has one.
Since A a + gamma = 0, the system has the same solution a, lambda if M is replaced by M + A^T W A and f by
f - A^T W gamma, for any weights W. This module decides whether that is needed, for which rows, and with which weights.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence

from ..graph.graph import Graph
from ..graph.store import Node
from ..model.check.elimination import without
from .row_weights import Weights
from .sample_states import Numbers, Rows, Samples

DEPENDENT = 1e-11
"""Pivots below this part of the diagonal entry count as rounding errors."""
ENOUGH = 0.1
"""A subset of rows suffices if its least pivot is at least this part of the least pivot with all rows."""


def weights(
    graph: Graph, M: Rows, A: Rows, phi: Sequence[Node], start: Mapping[str, float], constants: Mapping[str, float]
) -> list[Node]:
    """Return the weights W (m,) of the rows of A in M + A^T W A; all zero if M itself can be factored.

    phi : (h,), whose gradients are the first rows of A
    start : coordinates and time -> their initial values; constants : parameters -> their default values
    """
    none = [graph.zero] * len(A)
    if not A:
        return none
    samples = Samples(graph, M, A, phi, start, constants)
    places = [samples.at(values) for values in samples.states()]
    masses = [(place, numbers) for place in places if _finite(numbers := place.rows(M))]
    if not masses or max(_rank(numbers) for _, numbers in masses) == len(M):
        return none
    W = Weights(samples).all()
    augmented = _Augmented([(m, place.rows(A), [place(w) for w in W]) for place, m in masses])
    rows = augmented.needed(sorted(range(len(A)), key=lambda row: sum(entry != graph.zero for entry in A[row])))
    return [W[row] if row in rows else graph.zero for row in range(len(A))]


def _finite(rows: Iterable[Iterable[float]]) -> bool:
    return all(math.isfinite(entry) for row in rows for entry in row)


class _Augmented:
    """Numerical values of M + A^T W A at several states, for chosen rows of A."""

    def __init__(self, states: Iterable[tuple[Numbers, Numbers, list[float]]]) -> None:
        self.states = [state for state in states if _finite([*state[1], state[2]])]
        self.wholes = [_sum(*state, range(len(state[1]))) for state in self.states]

    def needed(self, rows: Sequence[int]) -> list[int]:
        """Return a subset of rows, preferably early ones, that makes the matrix regular; [] if even all rows do not."""
        if max(self.least_pivots(rows), default=0.0) <= DEPENDENT:
            return []
        chosen: list[int] = []
        for row in rows:
            if self.suffice(chosen, rows):
                break
            if self.rank([*chosen, row]) > self.rank(chosen):
                chosen.append(row)
        for row in rows:
            if row not in chosen and not self.suffice(chosen, rows):
                chosen.append(row)
        for row in rows[::-1]:
            if row in chosen and self.suffice(rest := [other for other in chosen if other != row], rows):
                chosen = rest
        return chosen

    def suffice(self, some: Sequence[int], rows: Sequence[int]) -> bool:
        """Whether some of the rows suffice at every state; which rows are needed may differ between states."""
        pairs = zip(self.least_pivots(some), self.least_pivots(rows), strict=True)
        return all(part >= ENOUGH * whole for part, whole in pairs if whole > DEPENDENT)

    def rank(self, rows: Iterable[int]) -> int:
        return max((_rank(_sum(*state, rows)) for state in self.states), default=0)

    def least_pivots(self, rows: Iterable[int]) -> list[float]:
        """Return the least pivot at each state, relative to the diagonal entry with all rows.

        Relative to its own diagonal entry, the pivot of a massless coordinate in a single row would always be 1,
        however small that entry is.
        """
        return [min(_pivots(_sum(*state, rows), whole)) for state, whole in zip(self.states, self.wholes, strict=True)]


def _sum(M: Numbers, A: Numbers, W: Sequence[float], rows: Iterable[int]) -> Numbers:
    for row in rows:
        M = [
            [entry + W[row] * a * b for entry, b in zip(line, A[row], strict=True)]
            for line, a in zip(M, A[row], strict=True)
        ]
    return M


def _rank(M: Numbers) -> int:
    return sum(pivot > DEPENDENT for pivot in _pivots(M))


def _pivots(M: Numbers, whole: Numbers | None = None) -> list[float]:
    """Return the pivots of a pivoted Cholesky factorisation of M, scaled by the diagonal of `whole` or else of M."""
    size = [1 / math.sqrt(row[k]) if row[k] > 0 else 0.0 for k, row in enumerate(whole or M)]
    rest = [[a * s * t for a, t in zip(row, size, strict=True)] for row, s in zip(M, size, strict=True)]
    pivots: list[float] = []
    while rest:
        best = max(range(len(rest)), key=lambda k: rest[k][k])
        pivots.append(max(rest[best][best], 0.0))
        counts = pivots[-1] > DEPENDENT
        rest = without(rest, best, best, [-a / rest[best][best] if counts else 0.0 for a in rest[best]])
    return pivots
