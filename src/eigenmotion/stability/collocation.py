"""Radau IIA collocation, for references of motions with strongly damped parts.

Hairer and Wanner, Solving Ordinary Differential Equations II, IV.5 and IV.8: s stages, order 2s - 1, stiffly accurate.
Residuals are evaluated in extended precision; Newton's matrix is a double.
"""

from itertools import pairwise

import numpy as np
from numpy.polynomial import Polynomial, legendre
from scipy.linalg import lu_factor, lu_solve

from ..arguments.names import Vector
from ..reference.collocation import jacobian
from ..reference.extended import Extended, NotReachedError, Rhs

STAGES = 5
_MOST = 40  # Newton steps


def _tableau(stages: int) -> tuple[Vector, Vector]:
    """Return c (s,), the right Radau points of [0, 1], and A (s, s) with A_ij the integral of l_j from 0 to c_i."""
    difference = np.zeros(stages + 1)
    difference[stages - 1 :] = (1.0, -1.0)
    c = np.sort(0.5 + 0.5 * legendre.legroots(difference))
    c[-1] = 1.0
    A = np.empty((stages, stages))
    for j in range(stages):
        others = np.delete(c, j)
        integral = (Polynomial.fromroots(others) / np.prod(c[j] - others)).integ()
        A[:, j] = integral(c) - integral(0.0)
    return c, A


_C, _A = _tableau(STAGES)


def collocated(rhs: Rhs, y: Vector, times: Vector, per_decade: int) -> Extended:
    """Return rows (k, n) at increasing times (k,), the first of which is the start.

    The mesh grows geometrically from a trillionth of the span, `per_decade` steps to a factor of ten, and holds the
    times; no step is longer than a part in 8 per_decade of the span.

    Raises
    ------
    NotReachedError
        Newton's method does not converge.
    """
    here, rows = np.array(y, dtype=np.longdouble), [np.array(y, dtype=np.longdouble)]
    wanted = set(times.tolist())
    for start, end in pairwise(_mesh(times, per_decade)):
        here = _step(rhs, start, end - start, here)
        if end in wanted:
            rows.append(here)
    return np.array(rows)


def _mesh(times: Vector, per_decade: int) -> list[float]:
    span = float(times[-1])
    graded = span * np.logspace(-12, 0, 12 * per_decade + 1)
    even = np.linspace(0.0, span, 8 * per_decade + 1)
    return sorted({0.0, *graded[:-1].tolist(), *even[:-1].tolist(), *times.tolist()})


def _step(rhs: Rhs, t: float, h: float, y: Extended) -> Extended:
    """One step: stages Y_i = y + h sum_j A_ij f(Y_j), of which the last is the new state."""
    n = len(y)
    matrix = lu_factor(np.eye(STAGES * n) - h * np.kron(_A, jacobian(rhs, t, y)))
    stages, change = np.tile(y, (STAGES, 1)), np.inf
    for _ in range(_MOST):
        slopes = np.array([rhs(t + c * h, Y) for c, Y in zip(_C, stages, strict=True)])
        residual = y + h * (_A @ slopes) - stages
        correction = lu_solve(matrix, residual.astype(np.float64).ravel()).reshape(STAGES, n)
        stages = stages + correction
        before, change = change, float(np.max(np.abs(correction) / (1 + np.abs(stages))))
        if change < 1e-15 or (change < 1e-12 and change > 0.3 * before):
            return np.asarray(stages[-1])
    raise NotReachedError(f"Newton's method stops at t = {t:.6g} with changes of {change:.1e}")
