"""Case with friction in joints: a crank drives a slider, whose guide and bearings rub in proportion to their forces."""

from dataclasses import dataclass
from functools import cache
from math import asin, ceil, cos, hypot, pi, sin, sqrt
from typing import Any

import numpy as np
import sympy
from scipy.integrate import solve_ivp
from sympy import symbols
from sympy.physics.mechanics import dynamicsymbols

from ...arguments.named_values import Vector
from ...codegen.model import Friction, Model
from ..expectation.truth import ClosedForm
from .case import Case, Trial, rows
from .variants import CONTACTS

G = 9.81
SIZES = {"a": 0.2, "l": 0.5, "I": 0.01, "m_2": 1.5, "I_2": 0.02, "m_3": 1.1, "drive": 3.0, "drag": 0.1}
RADII = {"r_pin": 0.03, "r_end": 0.02}  # [m] of the bearings
START = 0.9, 6.0  # [rad, rad/s] of the crank


@cache
def driven_slider() -> Model:
    """Return a crank phi, a rod at (X, Y) turned by psi, and a slider at (s, w), joined by five constraint rows."""
    phi, X, Y, psi, s, w = coordinates = dynamicsymbols("phi X Y psi s w")
    a, l, I, m_2, I_2, m_3, drive, drag = symbols(list(SIZES), positive=True)
    mu, g, r_pin, r_end = symbols("mu g r_pin r_end", positive=True)
    along, across = l / 2 * sympy.cos(psi), l / 2 * sympy.sin(psi)
    masses = (I, m_2, m_2, I_2, m_3, m_3)
    return Model(
        name="driven_slider",
        coordinates=coordinates,
        kinetic_energy=sum(m * q.diff() ** 2 for m, q in zip(masses, coordinates, strict=True)) / 2,
        potential_energy=g * (m_2 * Y + m_3 * w),
        forces={phi: drive - drag * phi.diff()},
        holonomic_constraints={
            "pin": [X - along - a * sympy.cos(phi), Y - across - a * sympy.sin(phi)],
            "end": [X + along - s, Y + across - w],
            "guide": w,
        },
        contacts={
            "rub_guide": Friction(s.diff(), mu, "guide"),
            "rub_pin": Friction(psi.diff() - phi.diff(), mu * r_pin, "pin"),
            "rub_end": Friction(psi.diff(), mu * r_end, "end"),
        },
        parameters=dict(zip((a, l, I, m_2, I_2, m_3, drive, drag), SIZES.values(), strict=True))
        | {mu: 0.25, g: G, r_pin: RADII["r_pin"], r_end: RADII["r_end"]},
    )


@dataclass(frozen=True)
class CrankMotion:
    """Motion of the crank, from whose angle the other bodies follow; forces by Newton's method, quarter by quarter.

    Friction changes its sign where sin phi = 0 (the guide) or cos phi = 0 (the rod's end), never at the pin (a < l).
    """

    mu: float

    def __call__(self, start: Vector, elapsed: Vector) -> Vector:
        """Return rows (k, 12)."""
        return np.array([self.shown(*row) for row in self._turned(start[0], start[6], elapsed)])

    def _turned(self, phi: float, rate: float, elapsed: Vector) -> Vector:
        values, t = np.empty((len(elapsed), 2)), 0.0
        quarter = ceil(2 * phi / pi)
        while t < elapsed[-1]:
            done = self._within(quarter, t, elapsed[-1], phi, rate)
            here = (elapsed >= t) & (elapsed <= done.t[-1])
            if here.any():
                values[here] = done.sol(elapsed[here]).T
            t, phi, rate, quarter = float(done.t[-1]), quarter * pi / 2, float(done.y[1, -1]), quarter + 1
        return values

    def _within(self, quarter: int, t: float, end: float, phi: float, rate: float) -> Any:
        """Return the motion to the end of a quarter turn, forwards."""
        middle = (quarter - 0.5) * pi / 2
        signs = -np.sign(sin(middle)), -1.0, -np.sign(cos(middle))  # of the slips of guide, pin, end

        def rates(_: float, z: Vector) -> list[float]:
            return [z[1], self.forces(z[0], z[1], signs)[0]]

        def ends(_: float, z: Vector) -> float:
            return float(z[0] - quarter * pi / 2)

        ends.terminal, ends.direction = True, 1  # type: ignore[attr-defined]
        accuracy: dict[str, Any] = {"rtol": 1e-13, "atol": 1e-14, "dense_output": True}
        return solve_ivp(rates, (t, end), [phi, rate], "DOP853", events=ends, **accuracy)

    def forces(self, phi: float, rate: float, signs: tuple[float, float, float]) -> Vector:
        """Return phi'', the forces on the rod at its pin and its end (2 each), and of the guide on the slider."""
        constant, linear = self._newtons(phi, rate)
        guide, pin, end = (sign * self.mu * r for sign, r in zip(signs, (1.0, *RADII.values()), strict=True))
        rubs = np.array([[0, pin, 0], [0, 0, 0], [0, 0, 0], [0, -pin, -end], [-guide, 0, 0], [0, 0, 0]])
        u = np.linalg.solve(linear, -constant)
        for _ in range(50):
            P, E, N = u[1:3], u[3:5], u[5]
            sizes = np.array([abs(N), hypot(*P), hypot(*E)])
            slopes = np.zeros((3, 6))
            slopes[0, 5], slopes[1, 1:3], slopes[2, 3:5] = np.sign(N), P / sizes[1], E / sizes[2]
            change = np.linalg.solve(linear + rubs @ slopes, -(constant + linear @ u + rubs @ sizes))
            u = u + change
            if np.max(np.abs(change)) <= 1e-13 * np.max(np.abs(u)):
                break
        return np.asarray(u, dtype=np.float64)

    def _newtons(self, phi: float, rate: float) -> tuple[Vector, Vector]:
        """Return Newton's law of crank, rod and slider without friction: 0 = constant (6,) + linear (6, 6) u."""
        a, l, I, m_2, I_2, m_3, drive, drag = SIZES.values()
        s, c = sin(phi), cos(phi)
        place, slope, bend = _followers(phi)
        by_rate = bend * rate**2
        sp, cp = sin(place[2]), cos(place[2])
        constant = np.array([
            drive - drag * rate, -m_2 * by_rate[0], -m_2 * (G + by_rate[1]), -I_2 * by_rate[2], -m_3 * by_rate[3],
            -m_3 * G,
        ])  # fmt: skip
        linear = np.array([
            [-I, a * s, -a * c, 0, 0, 0],
            [-m_2 * slope[0], 1, 0, 1, 0, 0],
            [-m_2 * slope[1], 0, 1, 0, 1, 0],
            [-I_2 * slope[2], l / 2 * sp, -l / 2 * cp, -l / 2 * sp, l / 2 * cp, 0],
            [-m_3 * slope[3], 0, 0, -1, 0, 0],
            [0, 0, 0, 0, -1, 1],
        ])  # fmt: skip
        return constant, linear

    @staticmethod
    def shown(phi: float, rate: float) -> Vector:
        place, slope, _ = _followers(phi)
        return np.concatenate([[phi], place, [0.0], [rate], slope * rate, [0.0]])


def _followers(phi: float) -> tuple[Vector, Vector, Vector]:
    """Return X, Y, psi, s and their first and second derivatives by phi."""
    a, l = SIZES["a"], SIZES["l"]
    s, c = sin(phi), cos(phi)
    sp = -a * s / l
    cp = sqrt(1 - sp**2)
    turn = -a * c / (l * cp)
    turns = a * s / (l * cp) + sp / cp * turn**2  # (l cos psi psi' = -a cos phi)' = a sin phi
    place = [a * c + l / 2 * cp, a * s + l / 2 * sp, asin(sp), a * c + l * cp]
    slope = [-a * s - l / 2 * sp * turn, a * c + l / 2 * cp * turn, turn, -a * s - l * sp * turn]
    along, across = sp * turns + cp * turn**2, cp * turns - sp * turn**2
    bend = [-a * c - l / 2 * along, -a * s + l / 2 * across, turns, -a * c - l * along]
    return np.array(place), np.array(slope), np.array(bend)


def turns(friction: float) -> Trial:
    """Return about four turns of the crank: in each, the slips of guide and rod's end change their sign twice."""
    start = CrankMotion.shown(*START)
    truth = ClosedForm(
        CrankMotion(friction), "the crank alone, forces by Newton's method, quarter by quarter", own=1e-11
    )
    times = rows(0.0, 1.5)
    return Trial(
        f"{friction:g}", {"mu": friction}, start[:6], start[6:], np.ones(6), 0.0, times, truth, conserves=False
    )


CASES = (
    Case(
        "bearings", "A slider whose bearings rub",
        "A crank drives a slider. Friction in guide, pin and rod's end is in proportion to the reactions, and changes "
        "its sign.",
        "friction coefficient", (0.05, 0.2, 0.5), lambda _: driven_slider(), turns, variants=CONTACTS, reduced=(0.2,),
    ),
)  # fmt: skip
