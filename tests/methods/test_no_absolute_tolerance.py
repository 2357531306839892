"""Runs without an absolute tolerance, of numbers that stay zero, in any unit of time."""

import numpy as np
import pytest
from sympy import symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.arguments.methods import METHODS

from ..support.generation import system_for

x, y = dynamicsymbols("x y")
w = symbols("w", positive=True)
beside = em.Model(
    name="beside", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
    potential_energy=w**2 * (x**2 + y**2) / 2, parameters={w: 1.0}, initial={x: 1.0},
)  # fmt: skip


@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e9])
@pytest.mark.parametrize("method", [*METHODS, "auto"])
def test_a_number_that_stays_zero_has_no_error(method: str, unit: float):
    """Of its size nothing is known; the other number moves as cos(w t), alone and in an ensemble."""
    system, end = system_for(beside, "lagrange"), 20.0 * unit
    given = {"parameters": {"w": 1.0 / unit}, "rtol": 1e-7, "atol": 0.0, "method": method}
    run = system.simulate((0.0, end), **given)
    assert run.success, run.message
    assert run.x[:, -1] == pytest.approx([np.cos(20.0), 0.0], abs=1e-6)
    starts = np.linspace(1.0, 1.5, 8)
    ends = em.simulate_ensemble(system, (0.0, end), x0={"x": starts}, **given).x[:, :, -1]
    assert ends[:, 0] == pytest.approx(starts * np.cos(20.0), abs=1e-6)
    assert not ends[:, 1].any()
