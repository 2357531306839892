"""Joints driven along a recorded path: a table of the time in a constraint."""

import numpy as np
import pytest
import sympy
from scipy.interpolate import CubicSpline, make_interp_spline
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import multiplier, t

from ..support.generation import system_for

q, u = dynamicsymbols("q u")
TIMES = np.linspace(0.0, 10.0, 10_000)


def motion(times, order=0):
    """A motion of a crank, or a derivative of it."""
    phase = order * np.pi / 2
    return np.sin(times + phase) + 0.1 * 7**order * np.sin(7 * times + phase)


def driven(path) -> em.Model:
    """A crank with an inertia that varies and a weight."""
    return em.Model(
        name="driven", coordinates=[q], kinetic_energy=q.diff() ** 2 / 2 * (2 + sympy.cos(q)),
        potential_energy=9.81 * sympy.sin(q), holonomic_constraints={"drive": q - path(t)},
        outputs={"torque": -multiplier("drive")}, initial={q: 0.0, q.diff(): 1.7},
    )  # fmt: skip


def torque(place, rate, acceleration):
    """By hand: d/dt of (2 + cos q) q', less the half of -sin q q'^2, and the weight's."""
    return (2 + np.cos(place)) * acceleration - np.sin(place) * rate**2 / 2 + 9.81 * np.cos(place)


@pytest.fixture(scope="module")
def system():
    return system_for(driven(em.Table(make_interp_spline(TIMES, motion(TIMES), k=5), name="path")), "lagrange")


@pytest.mark.parametrize("method", ["dop853", "ra15", "radau9"])
def test_a_recorded_motion_is_kept_and_its_torque_found(system, method):
    rows = np.linspace(0, 10, 501)
    found = system.simulate((0, 10), t_eval=rows, rtol=1e-9, atol=1e-9, method=method)
    assert found.success
    np.testing.assert_allclose(found.x[0], motion(rows), rtol=0, atol=1e-12)
    right = torque(motion(rows), motion(rows, 1), motion(rows, 2))
    np.testing.assert_allclose(found.outputs["torque"], right, rtol=0, atol=2e-8)
    assert found.nsteps < 500


def test_of_a_cubic_spline_all_is_that_of_the_spline(system):
    """Whose second derivative bends at each sample."""
    spline = CubicSpline(TIMES, motion(TIMES))
    rows = np.linspace(0, 1, 101)
    found = system.simulate(
        (0, 1), t_eval=rows, rtol=1e-9, parameters={"path": spline}, v0={"q": float(spline(0.0, 1))}
    )
    assert found.success
    right = torque(spline(rows), spline(rows, 1), spline(rows, 2))
    np.testing.assert_allclose(found.x[0], spline(rows), rtol=0, atol=1e-12)
    np.testing.assert_allclose(found.outputs["torque"], right, rtol=0, atol=1e-8)
    recorded = torque(motion(rows), motion(rows, 1), motion(rows, 2))
    assert 1e-5 < np.abs(found.outputs["torque"] - recorded).max() < 1e-3  # as docs/prescribed.md warns


def test_an_unknown_function_names_the_way():
    with pytest.raises(em.ModelError, match=r"give it by numbers: eigenmotion\.Table"):
        em.Model(name="driven", coordinates=[q], kinetic_energy=q.diff() ** 2, forces={q: sympy.Function("load")(q)})


def test_a_massless_coordinate_names_the_way():
    with pytest.raises(em.ModelError, match="put it under states"):
        em.Model(name="driven", coordinates=[q, dynamicsymbols("s")], kinetic_energy=q.diff() ** 2)
