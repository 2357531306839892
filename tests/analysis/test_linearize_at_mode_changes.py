"""Linearised where contacts and frictions hold, let go or are about to: the mode that is meant, and where two meet."""

from typing import Any

import numpy as np
import pytest
from sympy import cos, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Friction, ModelError, System

from ..support.generation import system_for
from .mechanisms_in_contact import block, leaning, pendulum
from .test_linearize import same


def test_where_modes_meet_the_side_is_named():
    weightless = {"g": 0.0}
    with pytest.raises(
        ModelError, match=r"modes meet .* contact 'wall' touches without force.*mode=\{'wall_held': 1\} or"
    ):
        pendulum().linearize(parameters=weightless)
    assert pendulum().linearize(parameters=weightless, mode={"wall_held": 1}).eigenvalues().size == 0
    assert len(pendulum().linearize(parameters=weightless, mode={"wall_held": 0}).A) == 2
    rest = em.find_equilibrium(pendulum(), [0.1], parameters=weightless)
    assert "contact 'wall' touches without force" in rest.message
    assert rest.linearize(mode=rest.mode).mode == rest.mode


@pytest.mark.parametrize("contact", [False, True])
def test_a_friction_at_its_limit_or_about_to_slide(contact):
    system, steep, limit = block(contact), {"al": 0.6}, {"al": np.arctan(0.5)}
    with pytest.raises(ModelError, match=r"'rub' has no slip and begins to slide.*mode=.'rub_slides': 1.$"):
        system.linearize(parameters=steep)
    assert system.linearize(parameters=steep, mode={"rub_slides": 1}).acceleration[0] > 0
    with pytest.raises(ModelError, match=r"does not hold at this state: friction 'rub' would take more than its limit"):
        system.linearize(parameters=steep, mode={"rub_stuck": 1})
    with pytest.raises(ModelError, match=r"would slide the other way"):
        system.linearize(parameters=steep, mode={"rub_slides": -1})
    with pytest.raises(ModelError, match=r"'rub' is at its limit"):
        system.linearize(parameters=limit)
    assert len(system.linearize(parameters=limit, mode={"rub_stuck": 1}).A) == 1
    assert len(system.linearize(parameters=limit, mode={"rub_slides": 1}).A) == 2
    with pytest.raises(ModelError, match=r"does not hold at this state: friction 'rub' would stick$"):
        system.linearize(mode={"rub_slides": 1})
    with pytest.raises(ModelError, match=r"does not hold at this state: friction 'rub' would stick or slide$"):
        system.linearize(mode={"rub_slides": 0, "rub_stuck": 0})
    slides = system.linearize(v={"x": 1.0})
    assert slides.mode["rub_slides"] == 1.0
    assert slides.acceleration[0] == pytest.approx(9.81 * (np.sin(0.3) - 0.5 * np.cos(0.3)), rel=1e-12)


@pytest.mark.parametrize(("mode", "why"), [
    ({"wall": 1}, "unknown name in mode 'wall'"), ({"wall_held": 2}, "give 0 or 1"), (1, "give a mapping"),
    ({"wall_held": 0}, "contact 'wall' would close"),
])  # fmt: skip
def test_mistakes_of_modes_have_names(mode, why):
    with pytest.raises(ModelError, match=why):
        pendulum().linearize(mode=mode)


def test_a_state_inside_a_contact_is_refused_and_one_that_comes_of_a_run_is_not():
    with pytest.raises(ModelError, match=r"inside 'wall', whose gap is -0.05"):
        pendulum().linearize([0.05])
    run = em.simulate(leaning(), (0.0, 20.0), x0=[0.1, 0.3])
    found = leaning().linearize(run.x[:, -1], run.v[:, -1], run.t[-1])
    assert found.mode == run.modes[-1][1]
    same(
        pendulum().linearize([0.3], parameters={"wall": 0.1}).eigenvalues(),
        np.array([1j, -1j]) * np.sqrt(9.81 * np.cos(0.3)),
    )


def test_what_leaves_is_free():
    """Thrown off the wall, or pulled from it: one mode alone goes on."""
    assert pendulum().linearize(v=[1.0]).mode == {"wall_held": 0.0}
    assert pendulum().linearize(parameters={"g": -9.81}).mode == {"wall_held": 0.0}


def test_a_loop_is_closed_outside_of_contacts():
    found = em.assemble(leaning(), {"p": -0.3, "q": 0.2}, keep=["q"])
    np.testing.assert_allclose(found.x, [0.1, 0.2], atol=1e-14)
    with pytest.raises(ModelError, match=r"inside contact 'wall', and with p kept it cannot be put on the surface"):
        em.assemble(leaning(), {"p": -0.3}, keep=["p"])


def rubbing(cone: bool) -> System:
    """A mass that a rod holds at the distance r = l and that rubs on the rod's force; or one in a bowl that rubs."""
    theta, r = dynamicsymbols("theta r")
    mu = symbols("mu", nonnegative=True)
    slip, kinetic = (theta.diff(), r.diff()), (r * theta.diff()) ** 2 + r.diff() ** 2
    rod: dict[str, Any] = {
        "kinetic_energy": kinetic / 2, "potential_energy": -9.81 * r * cos(theta),
        "holonomic_constraints": {"rod": r - 0.5}, "outputs": {"tension": em.multiplier("rod")},
        "contacts": {"rub": Friction(slip[0], limit=mu, normal="rod")}, "initial": {r: 0.5},
    }  # fmt: skip
    bowl = {
        "kinetic_energy": (theta.diff() ** 2 + r.diff() ** 2) / 2, "potential_energy": 9.81 * (theta**2 + r**2),
        "contacts": {"rub": Friction(slip, limit=mu)},
    }  # fmt: skip
    model = em.Model(name="rubbing", coordinates=[theta, r], parameters={mu: 0.1}, **(bowl if cone else rod))
    return system_for(model, "lagrange")


@pytest.mark.parametrize("cone", [False, True])
def test_a_friction_without_force_is_none(cone):
    """A coefficient of 0 is the mechanism without friction, at rest too, where one with a force would stick."""
    system, frequency = rubbing(cone), np.sqrt(9.81 * 2)
    assert system.linearize().mode["rub_stuck"] == 1.0
    rest = em.find_equilibrium(system, parameters={"mu": 0.0})
    for found in rest.linearize(), system.linearize(parameters={"mu": 0.0}):
        assert found.mode == {"rub_stuck": 0.0, "rub_slides": 0.0}
        same(found.eigenvalues(), np.array([1j, -1j] * (2 if cone else 1)) * frequency)
    assert rest.message == "at rest"


def test_an_output_of_a_reaction_while_a_friction_slides():
    """The tension of the rod is g cos theta + l theta'^2, and the sliding friction is no row that shares it."""
    linear = rubbing(False).linearize({"theta": 0.4}, {"theta": 2.0})
    np.testing.assert_allclose(linear.full.C[0, [0, 2]], [-9.81 * np.sin(0.4), 2 * 0.5 * 2.0], rtol=1e-12)


@pytest.mark.parametrize("unit", [1e-6, 1.0, 1e6])
def test_a_gap_is_inside_by_more_than_the_rounding_of_the_whole_state(unit):
    """Of a body at x = 0.3 that rests on z = 0, runs leave z = 1e-34 or -1e-34."""
    x, z = dynamicsymbols("x z")
    g, k = symbols("g k", positive=True)
    resting = em.Model(
        name="resting", coordinates=[x, z], kinetic_energy=(x.diff() ** 2 + z.diff() ** 2) / 2,
        potential_energy=g * z + k * x**2 / 2, contacts={"floor": em.Contact(z)}, parameters={g: 1.0, k: 4.0},
    )  # fmt: skip
    system = system_for(resting, "lagrange")
    for gap in (-1e-34, -1e-17, 0.0, 1e-34):
        found = system.linearize([0.3 * unit, gap * unit], [0.0, 0.0], parameters={"g": unit})
        same(found.eigenvalues(), [2j, -2j])
    with pytest.raises(ModelError, match="inside 'floor'"):
        system.linearize([0.3 * unit, -1e-14 * unit], [0.0, 0.0], parameters={"g": unit})
