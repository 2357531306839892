"""Gaussian elimination in any algebra: arrays, extended precision, and expressions of other packages."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray


def accelerations(
    M: Sequence[Any], A: Sequence[Any], f: Sequence[Any], g: Sequence[Any]
) -> tuple[list[Any], list[Any]]:
    """Return a and lambda of M a + A^T lambda = f, A a = g; M positive definite, A of full rank.

    The entries may be of any algebra with + - * /. Numbers that are zero are skipped.
    """
    free, *columns = solve(M, [f, *A])
    if not A:
        return list(free), []
    delta = [[_dot(row, column) for column in columns] for row in A]
    (multipliers,) = solve(delta, [[_dot(row, free) - g_i for row, g_i in zip(A, g, strict=True)]])
    return [a - _dot(multipliers, [column[k] for column in columns]) for k, a in enumerate(free)], multipliers


def solve(M: Sequence[Sequence[Any]], rights: Sequence[Sequence[Any]]) -> list[list[Any]]:
    """Return M^-1 r for each r by M = L D L^T, without pivoting, since M is positive definite."""
    n = len(M)
    L: list[list[Any]] = [[0] * n for _ in range(n)]
    D: list[Any] = []
    for j in range(n):
        scaled = [_product(L[j][k], D[k]) for k in range(j)]
        D.append(M[j][j] - _dot(L[j][:j], scaled))
        for i in range(j + 1, n):
            rest = M[i][j] - _dot(L[i][:j], scaled)
            L[i][j] = 0 if _is_zero(rest) else rest / D[j]
    return [_substituted(L, D, list(right)) for right in rights]


def solve_array(M: NDArray[Any], right: NDArray[Any]) -> NDArray[Any]:
    """Return M^-1 right (n,) by elimination on whole rows, which is fast for many coordinates."""
    a, b, n = M.copy(), right.copy(), len(right)
    for k in range(n - 1):
        factors = a[k + 1 :, k] / a[k, k]
        a[k + 1 :, k + 1 :] -= np.outer(factors, a[k, k + 1 :])
        b[k + 1 :] -= factors * b[k]
    for k in reversed(range(n)):
        b[k] = (b[k] - a[k, k + 1 :] @ b[k + 1 :]) / a[k, k]
    return b


def _substituted(L: list[list[Any]], D: list[Any], z: list[Any]) -> list[Any]:
    n = len(D)
    for i in range(n):
        z[i] = z[i] - _dot(L[i][:i], z[:i])
    z = [0 if _is_zero(value) else value / pivot for value, pivot in zip(z, D, strict=True)]
    for i in reversed(range(n)):
        z[i] = z[i] - _dot([L[k][i] for k in range(i + 1, n)], z[i + 1 :])
    return z


_NUMBERS = (int, float)


def _is_zero(value: Any) -> bool:
    return isinstance(value, _NUMBERS) and value == 0


def _product(a: Any, b: Any) -> Any:
    return 0 if _is_zero(a) or _is_zero(b) else a * b


def _dot(a: Sequence[Any], b: Sequence[Any]) -> Any:
    """Return the sum of the products that do not vanish."""
    first, *rest = [x * y for x, y in zip(a, b, strict=True) if not (_is_zero(x) or _is_zero(y))] or [0]
    return sum(rest, first)
