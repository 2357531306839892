"""Many pendulums under torques, as steppers of each kind."""

from functools import cache

import numpy as np
import pytest
from sympy import Rational, cos, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Model

from ..support.generation import system_for

K = 21
ANGLES = np.linspace(-2.5, 2.5, K)
TORQUES = np.linspace(-3.0, 3.0, K)


def driven(**options) -> Model:
    """A pendulum under a torque u, with a length to vary."""
    theta, u = dynamicsymbols("theta u")
    l, g = symbols("l g", positive=True)
    return Model(
        name="driven",
        coordinates=[theta],
        kinetic_energy=Rational(1, 2) * (l * theta.diff()) ** 2,
        potential_energy=-g * l * cos(theta),
        forces={theta: u},
        inputs={u: 0.0},
        parameters={l: 1.0, g: 9.81},
        outputs={"height": -l * cos(theta), "push": u / l},
        initial={theta: 1.0},
        **options,
    )


@cache
def in_lanes():
    return em.build(driven(), formulation="lagrange")


@cache
def one_by_one(formulation="lagrange"):
    return system_for(driven(), formulation)


FIXED = {"method": "rk4", "step": 0.01}
KINDS = {
    "lanes": (in_lanes, FIXED),
    "fixed": (one_by_one, FIXED),
    "dop853": (one_by_one, {"rtol": 1e-8}),
    "eigenfactor": (lambda: one_by_one("eigenfactor"), {"method": "midpoint", "step": 0.005}),
}
kinds = pytest.mark.parametrize("kind", KINDS)


def opened(kind, count=K, **given):
    system, options = KINDS[kind]
    return system().steppers(count, **({"x0": {"theta": ANGLES}} | options | given))


def told(envs, torques=TORQUES, steps=5):
    """Advance by steps of 0.07 s, with other inputs each."""
    for k in range(steps):
        envs.advance(envs.t + 0.07, {"u": torques * (k + 1)})
    return np.hstack([envs.x, envs.v, envs.t[:, None]])
