"""Mechanisms whose joints rub: Newton's equations with constant masses, the implicit forces found by SciPy's fsolve.

    M a + A^T lambda + sum_f sign_f mu_f |lambda of f| s_f = F,    A a + gamma = 0

The signs of slip are kept until one of the slips is zero, where they turn: what moves through zero does not stick.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import sympy
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve


@dataclass(frozen=True)
class Rubs:
    """A friction: its coefficient, its slip in the rates, the rows that press."""

    coefficient: float
    slip: sympy.Expr
    rows: tuple[int, ...]


class Bearings:
    """x, v: (n,) plain symbols; masses (n,); forces (n,) and phi (m,) in x, v and the time."""

    def __init__(
        self,
        x: Sequence[sympy.Symbol],
        v: Sequence[sympy.Symbol],
        masses: Sequence[float],
        forces: Sequence[sympy.Expr],
        phi: Sequence[sympy.Expr],
        rubs: Sequence[Rubs],
    ) -> None:
        time = sympy.Symbol("t")
        self.n, self.masses, self.rubs = len(x), np.array(masses), rubs
        rates = [sum(row.diff(q) * w for q, w in zip(x, v, strict=True)) for row in phi]
        gamma = [sum(rate.diff(q) * w for q, w in zip(x, v, strict=True)) for rate in rates]
        A = [[row.diff(q) for q in x] for row in phi]
        slips = [[rub.slip.diff(w) for w in v] for rub in rubs]
        function = sympy.lambdify([time, *x, *v], [list(forces), A, gamma, slips], "math", cse=True)
        self._coefficients = np.array([rub.coefficient for rub in rubs])
        self._pressing = np.array([[float(row in rub.rows) for row in range(len(phi))] for rub in rubs])
        self._terms: Callable[..., list] = function

    def terms(self, t: float, y: np.ndarray) -> list[np.ndarray]:
        """F (n,), A (m, n), gamma (m,), slips (r, n)."""
        return [np.array(part, dtype=float) for part in self._terms(t, *y.tolist())]

    def solved(self, t: float, y: np.ndarray, signs: Sequence[float]) -> tuple[np.ndarray, np.ndarray]:
        """Accelerations and multipliers, sliding in these directions."""
        F, A, gamma, slips = self.terms(t, y)

        push = np.array(signs) * self._coefficients * slips.T

        def accelerations(multipliers: np.ndarray) -> np.ndarray:
            return (F - A.T @ multipliers - push @ self._presses(multipliers)) / self.masses

        def slopes(multipliers: np.ndarray) -> np.ndarray:
            return -(A / self.masses) @ (A.T + (push / self._presses(multipliers)) @ (self._pressing * multipliers))

        free = np.linalg.solve((A / self.masses) @ A.T, A @ (F / self.masses) + gamma)
        found, _, ended, words = fsolve(
            lambda m: A @ accelerations(m) + gamma, free, fprime=slopes, xtol=1e-13, full_output=True
        )
        assert ended == 1 or np.abs(A @ accelerations(found) + gamma).max() < 1e-9, words
        return accelerations(found), found

    def _presses(self, multipliers: np.ndarray) -> np.ndarray:
        """Norms of the multipliers that press, (r,)."""
        return np.sqrt(self._pressing @ multipliers**2)

    def slips(self, t: float, y: np.ndarray) -> np.ndarray:
        """Rates of slip (r,)."""
        return self.terms(t, y)[3] @ y[self.n :]

    def motion(self, y: np.ndarray, times: Sequence[float]) -> np.ndarray:
        """States (2 n, nt) at these times, from y at the first of them; and the work lost to friction by the last."""
        signs = np.sign(self.slips(times[0], y))
        events = [lambda t, z, k=k: self.slips(t, z[:-1])[k] for k in range(len(self.rubs))]
        for event in events:
            event.terminal = True  # type: ignore[attr-defined]
        t, z, rows = times[0], np.append(y, 0.0), [np.append(y, 0.0)[:, None]]
        while t < times[-1]:
            later = [s for s in times if s > t]
            run = solve_ivp(lambda t, z: self._rates(t, z, signs), (t, times[-1]), z, "DOP853", later, rtol=1e-11,
                            atol=1e-12, events=events)  # fmt: skip
            assert run.success or run.status == 1, run.message
            rows.extend([run.y] if np.size(run.y) else [])
            if run.status == 0:
                break
            (k,) = (k for k, found in enumerate(run.t_events) if len(found))
            t, z = run.t_events[k][0], run.y_events[k][0]
            signs[k] = -signs[k]
            ahead = self._rates(t, z, signs)
            t, z = t + 1e-9, z + 1e-9 * ahead  # beside the root, which would be found again
        return np.concatenate(rows, axis=1)

    def _rates(self, t: float, z: np.ndarray, signs: Sequence[float]) -> np.ndarray:
        y = z[:-1]
        a, multipliers = self.solved(t, y, signs)
        presses = self._coefficients * self._presses(multipliers)
        return np.concatenate([y[self.n :], a, [np.abs(self.slips(t, y)) @ presses]])
