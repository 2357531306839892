"""Radau IIA collocation in extended precision, for motions with strongly damped parts.

Hairer and Wanner, Solving Ordinary Differential Equations II, IV.5 and IV.8: Y_i = y + h sum_j A_ij f(Y_j), c the right
Radau points, s stages, order 2 s - 1, the last stage the new value. Residuals are evaluated in extended precision;
Newton's matrix is in double precision. The error of a step is that of an embedded formula of order s (8.17) ff.,
filtered by (1 - h gamma J)^-1; without stiffness it overestimates the error of the step.
"""

from dataclasses import dataclass
from functools import cache
from typing import Any

import mpmath
import numpy as np
from numpy.polynomial import legendre
from scipy.linalg import lu_factor, lu_solve

from ..arguments.named_values import Vector
from .extended_precision import Extended, Rhs

_MOST = 20  # Newton steps
_DIGITS = 40


@dataclass(frozen=True, slots=True)
class _Tableau:
    """A (s, s), c (s,), and the weights of the embedded formula minus those of the method: gamma at c = 0, d (s,)."""

    c: Extended
    A: Extended
    gamma: float
    d: Extended


@cache
def _tableau(stages: int) -> _Tableau:
    """Solve the order conditions sum_j A_ij c_j^(k-1) = c_i^k / k, sum_j d_j c_j^(k-1) = -gamma [k = 1], k <= s."""
    gamma, orders = 1.0 / (stages + 1), range(1, stages + 1)
    with mpmath.workdps(_DIGITS):
        c = _radau_points(stages)
        powers = mpmath.matrix([[node ** (k - 1) for k in orders] for node in c])
        A = mpmath.matrix([[node**k / k for k in orders] for node in c]) * powers**-1
        d = mpmath.lu_solve(powers.T, mpmath.matrix([-gamma] + [0] * (stages - 1)))
        rows = [_extended(A[i, :]) for i in range(stages)]
        return _Tableau(_extended(c), np.array(rows), gamma, _extended(d))


def _radau_points(stages: int) -> list[Any]:
    """Return the zeros of P_s - P_s-1 on [0, 1], the last of which is 1."""
    rough = 0.5 + 0.5 * legendre.legroots([0.0] * (stages - 1) + [-1.0, 1.0])

    def difference(x: Any) -> Any:
        return mpmath.legendre(stages, 2 * x - 1) - mpmath.legendre(stages - 1, 2 * x - 1)

    return [*(mpmath.findroot(difference, root) for root in sorted(rough)[:-1]), mpmath.mpf(1)]


def _extended(numbers: Any) -> Extended:
    return np.array([np.longdouble(mpmath.nstr(number, 30)) for number in numbers])


class Collocation:
    """Steps with `stages` stages; Newton's method has converged if a correction is as small as `rounding`."""

    def __init__(self, stages: int, rounding: float = 1e-17) -> None:
        self.stages, self.rounding, self.tableau = stages, rounding, _tableau(stages)
        self.power = stages + 1

    def step(self, rhs: Rhs, time: Any, y: Extended, h: Any) -> tuple[Extended, float]:
        """Return y at time + h and the scaled error of the embedded formula; NaN if Newton's method fails."""
        tableau, J, short = self.tableau, jacobian(rhs, time, y), float(h)
        if not np.isfinite(J).all():
            return y, np.nan
        size = self.stages * len(y)
        factors = lu_factor(np.eye(size) - short * np.kron(tableau.A.astype(np.float64), J))
        slopes, stages = self._solved(rhs, time, y, h, factors)
        if stages is None:
            return y, np.nan
        embedded = h * (tableau.gamma * rhs(time, y) + tableau.d @ slopes)
        filtered = np.linalg.solve(np.eye(len(y)) - short * tableau.gamma * J, embedded.astype(np.float64))
        return stages[-1], float(np.max(np.abs(filtered) / (1 + np.abs(y))))

    def _solved(self, rhs: Rhs, time: Any, y: Extended, h: Any, factors: Any) -> tuple[Extended, Extended | None]:
        """Return the slopes and the stages (s, 2n) by Newton's method, or None if it does not converge."""
        stages, older, before = np.tile(y, (self.stages, 1)), np.inf, np.inf
        for _ in range(_MOST):
            slopes = np.array([rhs(time + c * h, Y) for c, Y in zip(self.tableau.c, stages, strict=True)])
            residual = y + h * (self.tableau.A @ slopes) - stages
            correction = lu_solve(factors, residual.astype(np.float64).ravel(), check_finite=False)
            stages = stages + correction.reshape(stages.shape)
            change = float(np.max(np.abs(correction) / (1 + np.abs(stages.ravel()))))
            if change < self.rounding or (change < 1e3 * self.rounding and change > 0.3 * before):
                return slopes, stages
            if not change < 0.9 * max(older, before):  # one correction may be larger than a small one before it
                break
            older, before = before, change
        return slopes, None


def jacobian(rhs: Rhs, time: Any, y: Extended) -> Vector:
    """Return df/dy (2n, 2n) by forward differences in extended precision: about nine digits."""
    here, columns = rhs(time, y), []
    for k in range(len(y)):
        moved = y.copy()
        moved[k] += np.longdouble(1e-9) * (1 + abs(y[k]))
        columns.append((rhs(time, moved) - here) / (moved[k] - y[k]))
    return np.array(columns, dtype=np.float64).T
