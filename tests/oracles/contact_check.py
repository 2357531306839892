"""Check of an acceleration, or of a velocity after an impact, against the laws of contacts and frictions.

Given it, forces are looked for by a linear program. No mode is tried, and what is not unique needs no care.
"""

from collections.abc import Iterator

import numpy as np
from scipy.optimize import linprog

from .contact_modes import Problem, Rub, sides

TIED = 1e-7
"""An acceleration of a gap or slip up to this is zero."""


def off(problem: Problem, a: np.ndarray, tied: float = TIED, *, within: bool = False) -> float:
    """Return by how much the law is missed with the forces that miss it least: M a = h + forces, and their bounds.

    A disc is a polygon about it, or `within` it: between the two nothing is known.
    """
    A0, g0 = problem.permanent
    gaps = problem.N @ a + problem.c
    columns = np.vstack([A0, problem.N, *(rub.rows for rub in problem.rubs)]).T
    m, nc, size = len(A0), len(gaps), columns.shape[1]
    numbers, rows = [], []
    for number, row in bounds(problem, a, gaps, m, size, tied, within):
        numbers.append(number)
        rows.append(row)
    residual = problem.M @ a - problem.h
    equal = np.vstack([columns, -columns])
    A = np.vstack([np.hstack([equal, -np.ones((len(equal), 1))]),
                   np.hstack([-np.array(rows).reshape(len(rows), size), -np.ones((len(rows), 1))])])  # fmt: skip
    b = np.concatenate([residual, -residual, numbers])
    free = [(None, None)] * m + [(0, None if gap <= tied else 0) for gap in gaps] + [(None, None)] * (size - m - nc)
    done = linprog(np.append(np.zeros(size), 1.0), A_ub=A, b_ub=b, bounds=[*free, (0, None)])
    missed = done.x[-1] if done.status == 0 else np.inf
    return float(max(missed, -gaps.min(initial=0.0), np.abs(A0 @ a + g0).max(initial=0.0)))


def bounds(
    problem: Problem, a: np.ndarray, gaps: np.ndarray, m: int, size: int, tied: float, within: bool
) -> Iterator[tuple[float, np.ndarray]]:
    """Yield number + row @ (l, p, f) >= 0 of each friction."""
    at = m + len(gaps)
    for rub in problem.rubs:
        d, own = len(rub.rows), np.eye(size)[at : at + len(rub.rows)]
        at += d
        rest, way = way_of(rub, a, tied)
        L, mu = rub.grip if rest else rub.drag
        row = np.zeros(size)
        if rub.normal >= 0:
            row[m + rub.normal] = mu
        if rest:
            shrunk = np.cos(np.pi / len(sides(d))) if within and d == 2 else 1.0
            yield from ((shrunk * L, shrunk * row - side @ own) for side in sides(d))
        else:
            for k in range(d):  # f = -(L + mu p) way
                yield from ((sign * L * way[k], sign * (own[k] + row * way[k])) for sign in (1.0, -1.0))


def way_of(rub: Rub, a: np.ndarray, tied: float) -> tuple[bool, np.ndarray]:
    """Return whether a friction sticks, and the way it slides, or begins to."""
    if rub.way is not None:
        return False, rub.way
    begins = rub.rows @ a + rub.offset
    size = np.linalg.norm(begins)
    return bool(size <= tied), begins / max(size, 1e-300)
