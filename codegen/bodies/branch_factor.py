"""Factors M = L^T D L of a mass matrix, from the tips of a tree inwards, with the zeros of M (Featherstone 2008, 6.5).

It solves where bodies have coordinates in common, so that they are no tree of independent joints.
"""

from __future__ import annotations

from collections.abc import Sequence

from .scalar import Scalar


class BranchFactor:
    """M = L^T D L, with L lower triangular of unit diagonal.

    Attributes
    ----------
    pivots : (n,) the diagonal of D, positive
    """

    def __init__(self, M: Sequence[Sequence[Scalar]]) -> None:
        n = len(M)
        H = [list(row) for row in M]
        self.pivots = [H[k][k] for k in range(n)]
        self._L: list[dict[int, Scalar]] = [{} for _ in range(n)]
        for k in reversed(range(n)):
            self.pivots[k] = H[k][k]
            inverse = H[k][k] ** -1
            own = [i for i in range(k) if not H[k][i].is_zero]
            self._L[k] = {i: H[k][i] * inverse for i in own}
            for i in own:
                for j in own[: own.index(i) + 1]:
                    H[i][j] = H[i][j] - self._L[k][i] * H[k][j]

    def solve(self, forces: Sequence[Scalar]) -> list[Scalar]:
        """Return M^-1 forces (n,)."""
        y = list(forces)
        for k in reversed(range(len(y))):
            for i, entry in self._L[k].items():
                y[i] = y[i] - entry * y[k]
        x: list[Scalar] = []
        for k, pivot in enumerate(self.pivots):
            solved = y[k] / pivot
            for i, entry in self._L[k].items():
                solved = solved - entry * x[i]
            x.append(solved)
        return x
