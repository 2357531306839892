"""Runs without an absolute tolerance, of numbers that stay zero, in any unit of time."""

import numpy as np
import pytest
from sympy import sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.arguments.methods import METHODS

from ..support.generation import system_for
from ..support.random_units_in_contact import Choice, Scene

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


crossed = em.Model(
    name="crossed", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=w**2 * x**2 / 2,
    parameters={w: 1.0}, events={"place": em.Event(x - 0.5), "rate": em.Event(x.diff() - w / 2)},
)  # fmt: skip


@pytest.mark.parametrize("unit", [1e-6, 1.0, 1e6])
@pytest.mark.parametrize("method", [*METHODS, "auto"])
def test_events_of_a_number_that_is_zero_at_the_start_are_found(method: str, unit: float):
    """From x = 0, sin(w t) passes 1/2 at pi/6; from x' = 0, -sin(w t) does at 7 pi/6."""
    system, given = system_for(crossed, "lagrange"), {"rtol": 1e-9, "atol": 0.0, "method": method}
    given["parameters"] = {"w": 1.0 / unit}
    for x0, v0, event, right in ((0.0, 1.0 / unit, 0, (1, 5, 13)), (1.0, 0.0, 1, (7, 11))):
        run = system.simulate((0.0, 8.0 * unit), x0={"x": x0}, v0={"x": v0}, **given)
        assert run.success, run.message
        assert run.t_events[event] == pytest.approx(np.pi / 6 * np.array(right) * unit, rel=1e-7)


def test_a_friction_holds_again_where_a_velocity_has_become_zero():
    """Under a constant limit mu each swing of x'' = -x - mu sign(x') is shorter by 2 mu, and lasts pi."""
    model = em.Model(
        name="rubbed", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=x**2 / 2,
        contacts={"pad": em.Friction(x.diff(), limit=0.1)}, initial={x: 1.0},
    )  # fmt: skip
    run = system_for(model, "lagrange").simulate((0.0, 20.0), rtol=1e-9, atol=0.0, method="dop853")
    assert run.success, run.message
    assert run.x[0, -1] == pytest.approx(0.0, abs=1e-7)
    assert run.t_events[0] == pytest.approx(np.pi * np.arange(1, 6), rel=1e-7)


@pytest.mark.parametrize("formulation", ["lagrange", "eigenfactor"])
@pytest.mark.parametrize("unit", [1e-6, 1.0, 1e6])
def test_ra15_takes_no_more_steps_where_numbers_start_from_zero(formulation: str, unit: float):
    """Three masses in a row, the first pushed by sin(w t): it starts as t^3, the next ones as t^5 and t^7."""
    q = dynamicsymbols("q1:4")
    row = em.Model(
        name="pushed_row", coordinates=q, kinetic_energy=sum(one.diff() ** 2 for one in q) / 2,
        potential_energy=w**2 * (q[0] ** 2 + (q[0] - q[1]) ** 2 + (q[1] - q[2]) ** 2) / 2,
        forces=[w**2 * sin(w * em.t), 0, 0], parameters={w: 1.0},
    )  # fmt: skip
    system, end = system_for(row, formulation), 20.0 * unit
    given = {"rtol": 1e-9, "parameters": {"w": 1.0 / unit}}
    run = system.simulate((0.0, end), method="ra15", atol=0.0, **given)
    usual = system.simulate((0.0, end), method="ra15", atol=1e-9 * min(1.0, 1.0 / unit), **given)
    assert run.success, run.message
    assert run.nsteps <= usual.nsteps + 5
    right = system.simulate((0.0, end), rtol=1e-13, atol=1e-14 * min(1.0, 1.0 / unit), parameters=given["parameters"])
    assert run.x[:, -1] == pytest.approx(right.x[:, -1], abs=1e-7)


@pytest.mark.parametrize("seed", [1, 3, 4, 6, 7, 19, 26])
@pytest.mark.parametrize("method", ["dop853", "ra15", "dopri5", "radau9"])
def test_what_contacts_and_frictions_keep_at_rest_has_no_error(method: str, seed: int):
    """What they hold is zero to rounding, of which the rest of the motion decides: as with a tolerance for it."""
    of = Scene(seed)
    system, plain = system_for(of.model(), "lagrange"), Choice(of, np.random.default_rng(0), 0.0)
    given = plain.given(system.parameters, 1e-9) | {"method": method}
    usual = system.simulate((0.0, of.end), **given)
    run = system.simulate((0.0, of.end), **given | {"atol": 0.0})
    assert usual.success
    assert run.success, run.message
    assert run.x[:, -1] == pytest.approx(usual.x[:, -1], abs=1e-6)
    assert run.v[:, -1] == pytest.approx(usual.v[:, -1], abs=1e-6)
    assert run.nsteps <= 10 * usual.nsteps
