"""The four-bar linkage of models/four_bar.py, written by hand: its sizes, its equations, and how a trial is judged.

Three slender bars of 1 kg/m: crank a, coupler b, rocker c, and pins at a distance d. Coordinates: their directions.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import acos, atan2, cos, hypot, pi, sin
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

A, B, C, D, G = 0.4, 1.0, 0.8, 1.0, 9.81
SPAN = 10.0
RATE = 4.0
"""Of the crank at the start [rad/s]."""


def start() -> tuple[np.ndarray, np.ndarray]:
    """Return directions and rates (3,) of a closed loop, with a vertical crank and the coupler above."""
    diagonal = hypot(A, D)
    q1 = pi / 2
    q2 = atan2(-A, D) + acos((B**2 + diagonal**2 - C**2) / (2 * B * diagonal))
    q3 = atan2(A + B * sin(q2), B * cos(q2) - D)
    v2 = RATE * A * sin(q1 - q3) / (B * sin(q3 - q2))
    v3 = RATE * A * sin(q1 - q2) / (C * sin(q3 - q2))
    return np.array([q1, q2, q3]), np.array([RATE, v2, v3])


def parts(q: Any, v: Any, xp: Any) -> tuple[Any, Any, Any, Any]:
    """Return M (3, 3), forces f (3,), rows (2, 3), and their rates times v (2,), with the functions of `xp`."""
    s, c = [xp.sin(q[k]) for k in range(3)], [xp.cos(q[k]) for k in range(3)]
    both = A * B**2 / 2
    across, along = both * xp.cos(q[0] - q[1]), both * xp.sin(q[0] - q[1])
    mass = [[A**3 / 3 + B * A**2, across, 0.0], [across, B**3 / 3, 0.0], [0.0, 0.0, C**3 / 3]]
    force = [
        -along * v[1] ** 2 - G * (A**2 / 2 + B * A) * c[0],
        along * v[0] ** 2 - G * B**2 / 2 * c[1],
        -G * C**2 / 2 * c[2],
    ]
    rows = [[-A * s[0], -B * s[1], C * s[2]], [A * c[0], B * c[1], -C * c[2]]]
    squares = [v[0] ** 2, v[1] ** 2, v[2] ** 2]
    turning = [
        -A * c[0] * squares[0] - B * c[1] * squares[1] + C * c[2] * squares[2],
        -A * s[0] * squares[0] - B * s[1] * squares[1] + C * s[2] * squares[2],
    ]
    return mass, force, rows, turning


def system(q: Any, v: Any, xp: Any) -> tuple[list[list[Any]], list[Any]]:
    """Return the matrix (5, 5) and the right side (5,) of accelerations and multipliers."""
    mass, force, rows, turning = parts(q, v, xp)
    matrix = [[*mass[i], rows[0][i], rows[1][i]] for i in range(3)] + [[*row, 0.0, 0.0] for row in rows]
    return matrix, [*force, *(-one for one in turning)]


def rhs(_: float, y: np.ndarray) -> np.ndarray:
    """Return the rates of (q, v), (6,): constraints differentiated twice, without stabilisation."""
    matrix, right = system(y[:3], y[3:], np)
    return np.concatenate([y[3:], np.linalg.solve(np.array(matrix), np.array(right))[:3]])


def gap(q: Any) -> float:
    """Return the distance between the ends of coupler and rocker [m]."""
    return float(
        hypot(
            A * cos(q[0]) + B * cos(q[1]) - C * cos(q[2]) - D, A * sin(q[0]) + B * sin(q[1]) - C * sin(q[2])
        )
    )  # fmt: skip


def energy(q: Any, v: Any) -> float:
    """Return T + V [J]."""
    mass = np.array(parts(q, v, np)[0])
    height = A * A / 2 * sin(q[0]) + B * (A * sin(q[0]) + B / 2 * sin(q[1])) + C * C / 2 * sin(q[2])
    return float(v @ mass @ v / 2 + G * height)


def reference(span: float = SPAN) -> np.ndarray:
    """Return directions (3,) at the end, by SciPy's DOP853 at 1e-13."""
    return solve_ivp(rhs, (0.0, span), np.concatenate(start()), method="DOP853", rtol=1e-13, atol=1e-13).y[:3, -1]


@dataclass(frozen=True)
class Trial:
    """What a tool did: directions (3,) and rates at the end, the seconds of the run, and how it was run."""

    how: str
    q: np.ndarray
    v: np.ndarray
    seconds: float

    def line(self, truth: np.ndarray) -> str:
        """Return a line for the page: the loop, the energy, the crank, the time."""
        lost = abs(energy(self.q, self.v) - energy(*start()))
        off = abs((self.q[0] - truth[0] + pi) % (2 * pi) - pi)
        return f"{self.how}: gap {gap(self.q):.0e} m, energy {lost:.0e} J, crank {off:.0e} rad, {self.seconds:.2g} s"
