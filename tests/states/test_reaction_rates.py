"""Rates of first-order states that depend on multipliers: a bristle under the reaction of a guide."""

import math
from functools import cache

import numpy as np
import pytest
import sympy
from scipy.integrate import solve_ivp
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import multiplier

from ..support.generation import system_for

FORMULATIONS = ("eigenfactor", "cholesky", "lagrange", "inverse")
x, y, z = dynamicsymbols("x y z")
k, sigma, mu, belt = 20.0, 1e3, sympy.Symbol("mu", positive=True), 0.2


def rate_of(slip, normal):
    """LuGre's bristle without the Stribeck effect."""
    return slip - sigma * sympy.Abs(slip) * z / (mu * sympy.Abs(normal))


def on_a_hilly_belt() -> em.Model:
    """A mass on a spring that a belt drags along: its reaction varies with the hills."""
    return em.Model(
        name="hilly_belt", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
        potential_energy=9.81 * y + k * x**2 / 2, holonomic_constraints={"belt": y - sympy.sin(2 * x) / 10},
        forces={x: sigma * z}, states={z: rate_of(belt - x.diff(), multiplier("belt"))}, parameters={mu: 0.3},
        initial={x.diff(): 0.05, y.diff(): 0.01}, outputs={"normal": -multiplier("belt"), "rate": z.diff()},
    )  # fmt: skip


def eliminated(t, state, friction=0.3):
    """The same in x alone: y = h(x), N = 9.81 + y''."""
    place, velocity, bristle = map(float, state)
    slope, bend = 0.2 * math.cos(2 * place), -0.4 * math.sin(2 * place)
    push = sigma * bristle - k * place - 9.81 * slope - slope * bend * velocity**2
    a = push / (1 + slope**2)
    normal = 9.81 + slope * a + bend * velocity**2
    slip = belt - velocity
    return [velocity, a, slip - sigma * abs(slip) * bristle / (friction * abs(normal))]


@cache
def ends(friction=0.3, span=3.0):
    found = solve_ivp(eliminated, (0, span), [0, 0.05, 0], args=(friction,), method="Radau", rtol=1e-11, atol=1e-13)
    return found.y[:, -1]


@pytest.fixture(scope="module", params=FORMULATIONS)
def system(request):
    return system_for(on_a_hilly_belt(), request.param)


@pytest.mark.parametrize("method", ["dop853", "ra15", "radau9"])
def test_the_motion_is_that_of_one_coordinate(system, method):
    found = system.simulate((0, 3), method=method, rtol=1e-10, atol=1e-12)
    right = ends()
    assert found.success
    np.testing.assert_allclose([found.x[0, -1], found.v[0, -1]], right[:2], rtol=0, atol=1e-8)
    np.testing.assert_allclose(found.states["z"][-1], right[2], rtol=0, atol=1e-10)
    at = eliminated(0.0, right)
    np.testing.assert_allclose(found.outputs["rate"][-1], at[2], rtol=0, atol=1e-7)


def test_derivatives_are_exact(system):
    place, velocity = 0.1, 0.03
    start = {"x": place, "y": 0.1 * np.sin(0.2), "z": 1e-3}, {"x": velocity, "y": 0.2 * np.cos(0.2) * velocity}
    state = system.state(*start)
    found = system.jacobian(0.0, state)
    h = 1e-6
    columns = [system.rhs(0.0, state + h * e) - system.rhs(0.0, state - h * e) for e in np.eye(len(state))]
    np.testing.assert_allclose(found, np.array(columns).T / (2 * h), rtol=0, atol=1e-8 * np.abs(found).max())


def test_sensitivities_follow_the_reaction(system):
    found = system.simulate((0, 0.5), rtol=1e-9, atol=1e-12, sensitivities=["mu"]).sensitivity["mu"]
    h = 1e-5
    right = (np.array(ends(0.3 + h, 0.5)) - ends(0.3 - h, 0.5)) / (2 * h)
    np.testing.assert_allclose(found.dx[0, -1], right[0], rtol=1e-5)
    np.testing.assert_allclose(found.dz[0, -1], right[2], rtol=1e-5)


def test_linear_models_know_the_reaction(system):
    """A at a state that moves, against differences of the one coordinate's equations."""
    right, h = ends(span=0.5), 1e-6
    slope = 0.2 * np.cos(2 * right[0])
    start = {"x": right[0], "y": 0.1 * np.sin(2 * right[0]), "z": right[2]}, {"x": right[1], "y": slope * right[1]}
    found = system.linearize(*start)
    columns = [np.subtract(eliminated(0, right + h * e), eliminated(0, right - h * e)) / (2 * h) for e in np.eye(3)]
    eigenvalues = np.linalg.eigvals(np.array(columns).T)
    np.testing.assert_allclose(np.sort_complex(found.eigenvalues()), np.sort_complex(eigenvalues), rtol=1e-5)


def test_runs_on_lanes_are_those_of_single_runs(system):
    frictions = np.array([0.2, 0.3, 0.4, 0.5, 0.6])
    many = em.simulate_ensemble(system, (0, 1), parameters={"mu": frictions}, rtol=1e-10, atol=1e-12)
    assert many.success.all()
    for one, friction in enumerate(frictions):
        np.testing.assert_allclose(many.states["z"][one, -1], ends(friction, 1.0)[2], rtol=0, atol=1e-10)


def test_under_a_contact_the_bristle_has_its_normal_force():
    """A block that falls onto the belt: LuGre's friction takes the contact's force, and is 0 in flight."""
    pressed = sympy.Max(-multiplier(0), 0)
    model = em.Model(
        name="dropped", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
        potential_energy=9.81 * y, contacts={"floor": em.Contact(y, 0.0)}, forces={x: -sigma * z},
        states={z: sympy.Piecewise((x.diff() - sigma * sympy.Abs(x.diff()) * z / (0.3 * pressed), pressed > 1e-6),
                                   (-100 * z, True))},
        initial={y: 0.1, x.diff(): 0.5},
    )  # fmt: skip
    system = system_for(model, "eigenfactor")
    found = system.simulate((0, 0.3), rtol=1e-10, atol=1e-12, method="radau9")
    assert found.success
    lands = np.sqrt(0.2 / 9.81)

    def sliding(t, state):
        _, velocity, bristle = state
        return [velocity, -sigma * bristle, velocity - sigma * abs(velocity) * bristle / (0.3 * 9.81)]

    right = solve_ivp(sliding, (lands, 0.3), [0.5 * lands, 0.5, 0.0], method="Radau", rtol=1e-11, atol=1e-13).y[:, -1]
    np.testing.assert_allclose([found.x[0, -1], found.v[0, -1]], right[:2], rtol=0, atol=1e-7)


def test_a_rate_may_be_linear_in_a_multiplier_without_any_contact():
    """A filter of the rod's force of a pendulum."""
    model = em.Model(
        name="weighed", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
        potential_energy=9.81 * y, holonomic_constraints={"rod": (x**2 + y**2 - 1) / 2},
        states={z: 5 * (multiplier("rod") - z)}, initial={x: 1.0},
    )  # fmt: skip
    system = system_for(model, "eigenfactor")
    found = system.simulate((0, 1), rtol=1e-10, atol=1e-12)

    def pendulum(t, state):
        angle, velocity, filtered = state
        return [velocity, -9.81 * np.cos(angle), 5 * (velocity**2 - 9.81 * np.sin(angle) - filtered)]

    right = solve_ivp(pendulum, (0, 1), [0.0, 0.0, 0.0], method="DOP853", rtol=1e-12, atol=1e-13).y[:, -1]
    np.testing.assert_allclose(found.states["z"][-1], right[2], rtol=0, atol=1e-8)
