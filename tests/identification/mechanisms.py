"""Mechanisms whose parameters are identified: masses, first moments and inertias as parameters."""

import sympy
from sympy import cos, sin
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

LENGTHS = (0.4, 1.1, 0.9)
GROUND = 1.0


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
