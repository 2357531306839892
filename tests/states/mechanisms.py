"""Mechanisms with first-order states, and their equations by hand."""

from functools import cache

import mpmath
import numpy as np
import sympy
from scipy.integrate import solve_ivp
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

from ..support.generation import model_of

theta, i, e, ref, x, s, q, z = dynamicsymbols("theta i e ref x s q z")
J, K, R, L, kp, ki = sympy.symbols("J K R L kp ki", positive=True)
SERVO = {J: 1.0, K: 1.0, R: 2.0, L: 0.1, kp: 5.0, ki: 3.0}


def servo(**more) -> em.Model:
    """An arm under gravity, driven by a motor with a current i, whose voltage is that of a PI controller."""
    given = {
        "name": "servo", "coordinates": [theta], "kinetic_energy": J * theta.diff() ** 2 / 2,
        "potential_energy": -3 * sympy.cos(theta), "forces": {theta: K * i},
        "states": {i: (kp * (ref - theta) + ki * e - R * i - K * theta.diff()) / L, e: ref - theta},
        "inputs": {ref: 1.0}, "parameters": SERVO, "initial": {i: 0.1, theta: 0.5},
        "outputs": {"voltage": L * i.diff() + R * i + K * theta.diff(), "power": K * i * theta.diff()},
    }  # fmt: skip
    return em.Model(**given | more)


def servo_rate(t: float, y: np.ndarray) -> list[float]:
    """Of (theta, theta', i, e)."""
    angle, rate, current, integral = y
    return [rate, current - 3 * np.sin(angle), (5 * (1 - angle) + 3 * integral - 2 * current - rate) / 0.1, 1 - angle]


def integrated(rate, start, times, **options) -> np.ndarray:
    """(n, k) by SciPy."""
    given = {"method": "DOP853", "rtol": 1e-13, "atol": 1e-14} | options
    return solve_ivp(rate, (times[0], times[-1]), start, t_eval=times, **given).y


# --- a four-bar linkage with a motor at its crank ---

current, integral = dynamicsymbols("current integral")
MOTOR = {"constant": 0.5, "resistance": 1.0, "inductance": 0.05, "gain": 2.0, "rate": 4.0}
"""V s, Ohm, H, V s, V."""


def motor_rate(current, integral, crank_rate, wanted=4.0):
    """Rates of the current and of the integral of the error of the crank's speed."""
    error = wanted - crank_rate
    voltage = MOTOR["gain"] * error + MOTOR["rate"] * integral
    return (voltage - MOTOR["resistance"] * current - MOTOR["constant"] * crank_rate) / MOTOR["inductance"], error


@cache
def driven_four_bar() -> em.Model:
    """models/four_bar.py with a motor whose speed a PI controller keeps."""
    bars = model_of("four_bar")
    crank = bars.coordinates[0]
    rates = motor_rate(current, integral, crank.diff())
    fields = ("coordinates", "kinetic_energy", "potential_energy", "holonomic_constraints", "parameters", "initial")
    known = {field: getattr(bars, field) for field in fields}
    return em.Model(
        name="driven_four_bar", **known, forces={crank: MOTOR["constant"] * current},
        states={current: rates[0], integral: rates[1]},
    )  # fmt: skip


class OneCoordinate:
    """The four-bar linkage as a function of its crank angle alone: effective inertia and potential energy by hand."""

    def __init__(self) -> None:
        bars = model_of("four_bar")
        self.start = np.array(bars.initial_x)
        lengths = {p.name: value for p, value in bars.parameters}
        self.a, self.b, self.c, self.d = (lengths[name] for name in "abcd")

    def closed(self, q1: float, near=None) -> np.ndarray:
        """All angles, those of coupler and rocker by Newton's method."""
        angles = np.array([q1, *(self.start[1:] if near is None else near[1:])])
        for _ in range(30):
            gap = self._loop(angles)
            turn = np.array([[-self.b * np.sin(angles[1]), self.c * np.sin(angles[2])],
                             [self.b * np.cos(angles[1]), -self.c * np.cos(angles[2])]])  # fmt: skip
            step = np.linalg.solve(turn, gap)
            angles[1:] -= step
            if np.abs(step).max() < 1e-12:  # the next would be its square
                break
        return angles

    def _loop(self, q) -> np.ndarray:
        return np.array([self.a * np.cos(q[0]) + self.b * np.cos(q[1]) - self.c * np.cos(q[2]) - self.d,
                         self.a * np.sin(q[0]) + self.b * np.sin(q[1]) - self.c * np.sin(q[2])])  # fmt: skip

    def ratios(self, q) -> np.ndarray:
        """dq / dq1."""
        q1, q2, q3 = q
        return np.array([1.0, self.a * np.sin(q1 - q3) / (self.b * np.sin(q3 - q2)),
                         self.a * np.sin(q1 - q2) / (self.c * np.sin(q3 - q2))])  # fmt: skip

    def inertia(self, q1: float) -> float:
        """Of slender bars of 1 kg/m: crank and rocker about pins, the coupler about its middle, which moves."""
        q = self.closed(q1)
        r1, r2, r3 = self.ratios(q)
        a, b, c = self.a, self.b, self.c
        middle = (a * r1) ** 2 + (b / 2 * r2) ** 2 + a * b * r1 * r2 * np.cos(q[0] - q[1])
        return a**3 / 3 * r1**2 + b * middle + b**3 / 12 * r2**2 + c**3 / 3 * r3**2

    def potential(self, q1: float) -> float:
        q = np.sin(self.closed(q1))
        a, b, c = self.a, self.b, self.c
        return 9.81 * (a * a / 2 * q[0] + b * (a * q[0] + b / 2 * q[1]) + c * c / 2 * q[2])

    def stiffness(self, q1: float) -> float:
        """The second derivative of the potential energy, by mpmath with 40 digits."""
        guess = self.closed(q1)
        a, b, c, d = self.a, self.b, self.c, self.d

        def gaps(angle, q2, q3):
            return (a * mpmath.cos(angle) + b * mpmath.cos(q2) - c * mpmath.cos(q3) - d,
                    a * mpmath.sin(angle) + b * mpmath.sin(q2) - c * mpmath.sin(q3))  # fmt: skip

        def potential(angle):
            q2, q3 = mpmath.findroot(lambda *others: gaps(angle, *others), tuple(guess[1:]))
            pin, above, rocker = a * mpmath.sin(angle), b * mpmath.sin(q2), c * mpmath.sin(q3)
            return mpmath.mpf("9.81") * (a / 2 * pin + b * (pin + above / 2) + c / 2 * rocker)

        with mpmath.workdps(40):
            return float(mpmath.diff(potential, mpmath.mpf(q1), 2))

    def rate(self, t: float, y: np.ndarray) -> list[float]:
        """Of (q1, q1', current, integral)."""
        q1, w, amperes, error = y
        pull = MOTOR["constant"] * amperes - slope(self.potential, q1)
        a = (pull - slope(self.inertia, q1) * w**2 / 2) / self.inertia(q1)
        return [w, a, *motor_rate(amperes, error, w)]


def slope(function, at: float, h: float = 2e-3) -> float:
    """By differences of eighth order."""
    weights = {1: 4 / 5, 2: -1 / 5, 3: 4 / 105, 4: -1 / 280}
    return sum(w * (function(at + k * h) - function(at - k * h)) for k, w in weights.items()) / h
