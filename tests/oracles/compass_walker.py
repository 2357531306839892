"""The compass-gait walker of Goswami, Thuilot and Espiau: equations written by hand, steps by SciPy.

A. Goswami, B. Thuilot, B. Espiau, "A Study of the Passive Gait of a Compass-Like Biped Robot", Int. J. Robotics
Research 17 (1998) 1282: hip 10 kg, legs of 1 m with 5 kg in the middle. s, n [rad]: angles of the stance leg and of
the other leg, backwards from the vertical; the slope descends by `slope` [rad]. A start (s, s', n') is right after a
strike, where s + n = -2 slope.
"""

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

HIP, LEG, LENGTH, LOWER, UPPER, GRAVITY = 10.0, 5.0, 1.0, 0.5, 0.5, 9.81
Vector = NDArray[np.float64]


def rates(_: float, z: Vector) -> list[float]:
    """Return (s', n', s'', n'')."""
    s, n, u, v = z
    cross, turn = LEG * LENGTH * UPPER * np.cos(s - n), LEG * LENGTH * UPPER * np.sin(s - n)
    m11, m22 = HIP * LENGTH**2 + LEG * LOWER**2 + LEG * LENGTH**2, LEG * UPPER**2
    f1 = turn * v * v + GRAVITY * (HIP * LENGTH + LEG * LOWER + LEG * LENGTH) * np.sin(s)
    f2 = -turn * u * u - GRAVITY * LEG * UPPER * np.sin(n)
    det = m11 * m22 - cross * cross
    return [u, v, (m22 * f1 + cross * f2) / det, (cross * f1 + m11 * f2) / det]


def struck(s: float, n: float, u: float, v: float) -> tuple[float, float]:
    """Return the rates (s', n') after a strike: of a mechanism with a free stance foot, whose other foot is stopped."""

    def across(angle: float) -> Vector:
        return np.array([-np.cos(angle), -np.sin(angle)])

    def jacobian(of_s: float, of_n: float) -> Vector:
        return np.column_stack([np.eye(2), of_s * across(s), of_n * across(n)])

    parts = [(HIP, jacobian(LENGTH, 0)), (LEG, jacobian(LOWER, 0)), (LEG, jacobian(LENGTH, -UPPER))]
    M = sum((mass * J.T @ J for mass, J in parts), np.zeros((4, 4)))
    foot = jacobian(LENGTH, -LENGTH)
    whole = np.block([[M, -foot.T], [foot, np.zeros((2, 2))]])
    after = np.linalg.solve(whole, np.append(M @ [0.0, 0.0, u, v], [0.0, 0.0]))
    return float(after[2]), float(after[3])


def walked(start: Vector, slope: float, steps: int) -> tuple[Vector, float]:
    """Return the state right after some steps, and the time that they take."""

    def strike(t: float, z: Vector) -> float:
        return float(z[0] + z[1] + 2 * slope) if t > 0.1 else -1.0

    strike.terminal, strike.direction = True, -1  # type: ignore[attr-defined]
    (s, u, v), time = start, 0.0
    for _ in range(steps):
        run = solve_ivp(rates, (0, 3), [s, -2 * slope - s, u, v], method="DOP853", rtol=1e-13, atol=1e-14,
                        events=strike)  # fmt: skip
        before = run.y_events[0][0]
        time += run.t_events[0][0]
        v, u = struck(*before)
        s = before[1]
    return np.array([s, u, v]), time


def derivative(start: Vector, slope: float, steps: int) -> Vector:
    """Return the derivative (3, 3) of the steps by the start, by differences of fourth order."""
    h = 1e-4
    sides = [[walked(start + k * e, slope, steps)[0] for k in (1, -1, 2, -2)] for e in h * np.eye(3)]
    return np.array([(8 * (a - b) - (c - d)) / (12 * h) for a, b, c, d in sides]).T


def gait(start: Vector, slope: float, steps: int) -> tuple[Vector, Vector]:
    """Return the start of a gait that repeats after some steps, and the derivative of these, by Newton's method."""
    for _ in range(20):
        D = derivative(start, slope, steps)
        change = np.linalg.solve(D - np.eye(3), start - walked(start, slope, steps)[0])
        start = start + change
        if np.abs(change).max() < 1e-9:
            return start, derivative(start, slope, steps)
    raise AssertionError(f"no gait of {steps} steps at {slope}")


def doubling(start: Vector, near: float, steps: int) -> tuple[float, Vector]:
    """Return the slope at which a multiplier is -1, and the start there, by secants."""
    slopes = [near, near + 1e-6]
    values: list[float] = []
    for k in range(12):
        start, D = gait(start, slopes[k], steps)
        values.append(float(np.linalg.det(D + np.eye(3))))
        if k and abs(slopes[k] - slopes[k - 1]) < 1e-11:
            break
        if k:
            part = values[k] / (values[k] - values[k - 1])
            slopes.append(slopes[k] - part * (slopes[k] - slopes[k - 1]))
    return slopes[k], start
