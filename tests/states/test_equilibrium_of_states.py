"""Equilibria of systems with first-order states whose slopes do not show the way there."""

import numpy as np
import pytest
import sympy
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

from ..support.generation import system_for

theta, i, e, ref = dynamicsymbols("theta i e ref")


def saturated(limit=12.0, damping=0.02) -> em.Model:
    """An arm, balanced upright by a motor whose voltage is limited; the controller starts far in saturation."""
    command = 20 * (ref - theta) + 10 * e - 0.3 * theta.diff()
    volts = sympy.Max(-limit, sympy.Min(limit, command))
    return em.Model(
        name="saturated", coordinates=[theta], kinetic_energy=theta.diff() ** 2 / 200,
        potential_energy=sympy.cos(theta) / 2, forces={theta: i / 10 - damping * theta.diff()},
        states={i: (volts - i - theta.diff() / 10) / 0.002, e: ref - theta}, inputs={ref: 1.0},
    )  # fmt: skip


@pytest.mark.parametrize("target", [1.0, 3.0, -2.0])
def test_a_saturated_controller_finds_its_target(target):
    """The motor holds the weight: i K = -sin(theta) / 2, and the integral has what the voltage needs."""
    found = em.find_equilibrium(system_for(saturated()), inputs={"ref": target})
    current = -5 * np.sin(target)
    assert found.success
    assert found.x[0] == pytest.approx(target, abs=1e-9)
    assert found.states["i"] == pytest.approx(current, abs=1e-8)
    assert found.states["e"] == pytest.approx(current / 10, abs=1e-9)


def test_a_motor_too_weak_for_its_target_says_what_is_left():
    """At 90 degrees the weight takes 5 A, of which the voltage gives 2: the integral grows for ever."""
    found = em.find_equilibrium(system_for(saturated(limit=2.0)), inputs={"ref": np.pi / 2})
    assert not found.success
    assert "no equilibrium found" in found.message
