"""Implicit steps within which a motion ceases to be stiff, or becomes so: errors stay near the tolerance.

The motion is known: x'' = -sin t - D (x' - cos t) - K (x - sin t) has the solution sin t for every damping D and
stiffness K, however they depend on t and x.
"""

from functools import cache

import numpy as np
import pytest
from sympy import cos, sin, symbols, tanh
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Model, t

from ..support.generation import system_for

END = 60.0
ROWS = np.linspace(0.0, END, 241)
TIMES_TOLERANCE = 300.0
"""Errors of v become errors of x while nothing holds the motion, up to 16 s, which is 60 steps and more."""
BY_DAY, AT_NIGHT = range(4), range(4, 60)


@cache
def system() -> em.System:
    x = dynamicsymbols("x")
    d, k, sharp, w, p = symbols("d k sharp w p", real=True)
    switch = (1 + tanh(sharp * sin(w * t + p * x))) / 2
    pull = d * (x.diff() - cos(t)) + k * (x - sin(t))
    return system_for(Model(
        name="switched_stiffness", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=0,
        forces={x: -sin(t) - switch * pull}, parameters={d: 1e5, k: 0.0, sharp: 50.0, w: 0.6, p: 0.0},
        initial={x.diff(): 1.0},
    ), formulation="lagrange")  # fmt: skip


def times_tolerance(method, tolerance, direction=1.0, **parameters):
    """Return the largest error of x in tolerances."""
    rows = direction * ROWS
    sol = system().simulate(
        (0.0, rows[-1]), method=method, rtol=tolerance, atol=tolerance, t_eval=rows, parameters=parameters,
        max_steps=10**6,
    )  # fmt: skip
    assert sol.success, sol.message
    return abs(sol.x[0] - np.sin(rows)).max() / tolerance


def random_case(rng):
    d = 10 ** rng.uniform(2, 8)
    return {
        "d": d, "k": rng.choice([0.0, d * 10 ** rng.uniform(-2, 2)]), "sharp": 10 ** rng.uniform(0, 3),
        "w": rng.uniform(0.2, 2.0), "p": rng.choice([0.0, rng.uniform(-3.0, 3.0)]),
    }  # fmt: skip


@pytest.mark.parametrize("method", ["radau5", "radau9", "auto"])
@pytest.mark.parametrize("block", [*BY_DAY, *(pytest.param(block, marks=pytest.mark.nightly) for block in AT_NIGHT)])
def test_errors_stay_near_the_tolerance(block, method):
    """Steps were accepted up to 1e5 tolerances off: their stages had not converged where stiffness had ended."""
    rng = np.random.default_rng(block)
    for _ in range(15):
        case, tolerance = random_case(rng), 10 ** rng.uniform(-9, -4)
        found = times_tolerance(method, tolerance, **case)
        assert found < TIMES_TOLERANCE, (found, tolerance, case)


@pytest.mark.parametrize("method", ["radau5", "radau9", "auto"])
def test_so_they_do_backwards(method):
    """A damper of negative strength holds the motion backwards in time."""
    rng = np.random.default_rng(0)
    for _ in range(30):
        case, tolerance = random_case(rng), 10 ** rng.uniform(-9, -4)
        found = times_tolerance(method, tolerance, -1.0, **(case | {"d": -case["d"]}))
        assert found < TIMES_TOLERANCE, (found, tolerance, case)
