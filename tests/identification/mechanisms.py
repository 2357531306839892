"""Mechanisms whose parameters are identified: masses, first moments and inertias as parameters."""

import numpy as np
import sympy
from sympy import cos, sin
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

LENGTHS = (0.4, 1.1, 0.9)
GROUND = 1.0
REACH = 0.6


def crank_four_bar() -> em.Model:
    """A four-bar of bars with masses, first moments along and across them and inertias about their first ends."""
    q = dynamicsymbols("q_1:4")
    m, mx, my, J = (sympy.symbols(f"{letter}_1:4") for letter in ("m", "mx", "my", "J"))
    g, damping = sympy.symbols("g damping")
    bars = [sympy.Matrix([cos(one), sin(one)]) for one in q]
    feet = (sympy.zeros(2, 1), LENGTHS[0] * bars[0], sympy.Matrix([GROUND, 0]))
    T = V = sympy.S.Zero
    for k in range(3):
        moment = mx[k] * bars[k] + my[k] * sympy.Matrix([-sin(q[k]), cos(q[k])])
        v = feet[k].diff(em.t)
        T += m[k] * v.dot(v) / 2 + v.dot(moment.diff(em.t)) + J[k] * q[k].diff() ** 2 / 2
        V += g * (m[k] * feet[k][1] + moment[1])
    closed = feet[1] + LENGTHS[1] * bars[1] - feet[2] - LENGTHS[2] * bars[2]
    values = {m: (1.2, 2.1, 1.7), mx: (0.24, 1.1, 0.8), my: (0.02, -0.05, 0.03), J: (0.08, 0.9, 0.55)}
    parameters = {symbol: value for some, of in values.items() for symbol, value in zip(some, of, strict=True)}
    return em.Model(name="crank_four_bar", coordinates=q, kinetic_energy=T, potential_energy=V,
                    forces={q[0]: -damping * q[0].diff()}, parameters=parameters | {damping: 0.3, g: 9.81},
                    holonomic_constraints={"loop": list(closed)},
                    initial={q[0]: 0.6, q[1]: 0.5, q[2]: 1.3})  # fmt: skip


def crank_motion(t: np.ndarray, seed: int = 3) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """x, v, a (3, k) of the four-bar whose crank moves as a Fourier series, in closed form."""
    random, (a, b, c) = np.random.default_rng(seed), LENGTHS
    waves = [(random.normal(0, 0.5), random.normal(0, 0.5), w) for w in (2.0, 3.0, 5.0)]
    q, v, acc = (sum(values) for values in zip(*(_wave(t, *one) for one in waves), strict=True))
    q = q + 0.6
    along = GROUND - a * np.exp(1j * q)  # from the knee to the second ground pivot
    d = np.abs(along)
    second = np.angle(along) + np.arccos((b**2 + d**2 - c**2) / (2 * b * d))
    third = np.angle(a * np.exp(1j * q) + b * np.exp(1j * second) - GROUND)
    rates, accelerations = np.empty((2, len(t))), np.empty((2, len(t)))
    for k in range(len(t)):
        ends = 1j * np.array([b * np.exp(1j * second[k]), -c * np.exp(1j * third[k])])
        A, first = np.array([ends.real, ends.imag]), a * np.exp(1j * q[k])
        rates[:, k] = w = np.linalg.solve(A, _plane(-1j * first * v[k]))
        turning = first * v[k] ** 2 + b * np.exp(1j * second[k]) * w[0] ** 2 - c * np.exp(1j * third[k]) * w[1] ** 2
        accelerations[:, k] = np.linalg.solve(A, _plane(turning - 1j * first * acc[k]))
    return np.vstack([q, second, third]), np.vstack([v, rates]), np.vstack([acc, accelerations])


def _wave(t, sine, cosine, w):
    return (
        sine * np.sin(w * t) + cosine * np.cos(w * t),
        w * (sine * np.cos(w * t) - cosine * np.sin(w * t)),
        -(w**2) * (sine * np.sin(w * t) + cosine * np.cos(w * t)),
    )


def _plane(z: complex) -> np.ndarray:
    return np.array([z.real, z.imag])


def two_links(actuated: bool = False) -> em.Model:
    """A planar arm of two links in a vertical plane, by first moments; maybe with a motor's constant."""
    symbols = sympy.symbols("m_1 mx_1 my_1 J_1 m_2 mx_2 my_2 J_2")
    m1, mx1, my1, J1, m2, mx2, my2, J2 = symbols
    tree = em.Tree(gravity=(0, -9.81, 0))
    one = tree.body("q_1", joint="revolute", axis="z", mass=m1, moment=(mx1, my1, 0), inertia=(0, 0, J1))
    tree.body(
        "q_2", one, joint="revolute", axis="z", at=(REACH, 0, 0), mass=m2, moment=(mx2, my2, 0), inertia=(0, 0, J2)
    )
    values = dict(zip(symbols, (3.0, 0.9, 0.02, 0.5, 2.0, 0.5, -0.03, 0.25), strict=True))
    more = {}
    if actuated:
        current, constant = dynamicsymbols("current"), sympy.Symbol("constant")
        more = {"forces": {tree.coordinates[0]: constant * current}, "inputs": {current: 0.0}}
        values[constant] = 1.5
    return em.Model(name="motor_arm" if actuated else "two_links", coordinates=tree.coordinates, parameters=values,
                    kinetic_energy=tree.kinetic_energy, potential_energy=tree.potential_energy, **more)  # fmt: skip
