"""Errors of derivatives where the motion itself rests and says nothing about them."""

from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from sympy import Abs, Piecewise, Rational, cos, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Model, ModelError, System

from ..support.generation import system_for

MOST = 100.0
"""Tolerances of a run by which derivatives may be off, where nothing grows."""
x = dynamicsymbols("x")
METHODS = ["rk34", "dopri5", "dop853", "ra15", "radau5", "radau9"]


@cache
def hanging() -> System:
    return system_for(Model(name="hanging", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2,
                            potential_energy=-9.81 * cos(x)), "lagrange")  # fmt: skip


@pytest.mark.parametrize("t_eval", [None, [10.0], np.linspace(0.0, 10.0, 301)])
@pytest.mark.parametrize("rtol", [1e-4, 1e-7, 1e-10, 1e-12])
def test_a_pendulum_at_rest(rtol, t_eval):
    """d theta(t) / d theta(0) = cos(w t), whatever the run's own steps; 10 s in five of them gave 3.93."""
    run = hanging().simulate((0.0, 10.0), rtol=rtol, atol=rtol, t_eval=t_eval, sensitivities=["x"])
    w, found = np.sqrt(9.81), run.sensitivity["x"]
    assert np.abs(found.dx[0] - np.cos(w * run.t)).max() < MOST * rtol
    assert np.abs(found.dv[0] + w * np.sin(w * run.t)).max() < MOST * rtol * w


@pytest.mark.parametrize("method", METHODS)
def test_every_method_at_rest(method):
    run = hanging().simulate((0.0, -10.0), rtol=1e-8, atol=1e-8, method=method, sensitivities=["x'"])
    w = np.sqrt(9.81)
    np.testing.assert_allclose(run.sensitivity["x'"].dx[0], np.sin(w * run.t) / w, atol=MOST * 1e-8)


@pytest.mark.parametrize("rtol", [1e-5, 1e-8, 1e-11])
def test_the_zero_solution_of_mathieus_equation(rtol):
    model = Model(name="mathieu", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2,
                  potential_energy=(1 + cos(2 * em.t) / 2) * x**2 / 2 + x**4 / 4)  # fmt: skip
    end = 20 * np.pi
    right = solve_ivp(lambda t, z: [z[1], -(1 + np.cos(2 * t) / 2) * z[0]], (0, end), [1, 0], rtol=1e-13, atol=1e-14,
                      method="DOP853").y[:, -1]  # fmt: skip
    run = system_for(model, "lagrange").simulate((0, end), rtol=rtol, atol=rtol, sensitivities=["x"])
    found = run.sensitivity["x"]
    np.testing.assert_allclose([found.dx[0, -1], found.dv[0, -1]], right, atol=MOST * rtol * np.abs(right).max())


@pytest.mark.parametrize("rtol", [1e-5, 1e-8, 1e-11])
def test_a_triangular_point_of_three_bodies(rtol):
    """In the frame that turns with two of them, 1 and 99 hundredths of the mass, the third rests."""
    a, b = dynamicsymbols("a b")
    mu = Rational(1, 100)
    far, near = sqrt((a + mu) ** 2 + b**2), sqrt((a - 1 + mu) ** 2 + b**2)
    spin = a * b.diff() - b * a.diff() + (a**2 + b**2) / 2
    model = Model(name="triangular", coordinates=[a, b], kinetic_energy=(a.diff() ** 2 + b.diff() ** 2) / 2 + spin,
                  potential_energy=-(1 - mu) / far - mu / near, initial={a: 0.49, b: np.sqrt(3) / 2})  # fmt: skip
    system, end = system_for(model, "lagrange"), 60.0
    right = expm(end * system.linearize(*system.start()).full.A)
    run = system.simulate((0, end), rtol=rtol, atol=rtol, sensitivities=["a", "b", "a'", "b'"])
    found = np.array([np.concatenate([one.dx[:, -1], one.dv[:, -1]]) for one in run.sensitivity.values()]).T
    np.testing.assert_allclose(found, right, atol=4 * MOST * rtol * np.abs(right).max())


def test_where_slopes_of_forces_jump():
    """A spring that is four times as stiff on one side: no force jumps there, and a period has two halves."""
    model = Model(name="two_springs", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2,
                  forces=[-Piecewise((4 * x, x < 0), (x, True))], initial={x: 1.0})  # fmt: skip
    run = system_for(model, "lagrange").simulate((0, 1.5 * np.pi), rtol=1e-9, atol=1e-9, t_eval=[1.5 * np.pi],
                                                 sensitivities=["x", "x'"])  # fmt: skip
    by_x, by_v = run.sensitivity["x"], run.sensitivity["x'"]  # a period is over, whatever its amplitude
    np.testing.assert_allclose([by_x.dx[0, 0], by_x.dv[0, 0], by_v.dx[0, 0], by_v.dv[0, 0]], [1, 0, 0, 1], atol=1e-6)


@pytest.mark.parametrize("jump", [1e-3, 1.0])
def test_a_jump_that_no_event_states_is_found_where_it_is_small(jump):
    force = -10 * (1 + jump * Piecewise((1, x < 1), (0, True)))
    model = Model(name=f"jumps{jump:g}".replace(".", "").replace("-", ""), coordinates=[x],
                  kinetic_energy=x.diff() ** 2 / 2, forces=[force], initial={x: 2.25})  # fmt: skip
    with pytest.raises(ModelError, match=r"a force jumps at about t = 0\.5"):
        system_for(model, "lagrange").simulate((0, 0.8), rtol=1e-9, atol=1e-9, sensitivities=["x"])


def test_a_kink_at_rest_is_none_of_a_force():
    model = Model(name="kink", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2,
                  potential_energy=x**2 / 2 + Abs(x) ** 3, initial={x: 0.0})  # fmt: skip
    run = system_for(model, "lagrange").simulate((0, 3.0), sensitivities=["x"])
    np.testing.assert_allclose(run.sensitivity["x"].dx[0], np.cos(run.t), atol=1e-4)


def test_what_would_take_for_ever_is_refused():
    """A slope that changes ten thousand million times at y = 0, where the force, and the motion, know nothing of it."""
    y = dynamicsymbols("y")
    model = Model(name="crawls", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
                  forces=[0, y * cos(10**10 * x)], initial={x.diff(): 1.0})  # fmt: skip
    with pytest.raises(ModelError, match="forces change faster than steps can follow"):
        system_for(model, "lagrange").simulate((0, 1.0), rtol=1e-9, atol=1e-9, sensitivities=["y"])


def test_what_rests_on_a_floor_from_the_start():
    """Pushed by F t it leaves at s = g / F; then z = F (t^3 - s^3) / 6 - g (t - s)^2 / 2 - F s^2 (t - s) / 2."""
    z = dynamicsymbols("z")
    g, F = symbols("g F", positive=True)
    model = Model(name="rests_first", coordinates=[z], kinetic_energy=z.diff() ** 2 / 2, potential_energy=g * z,
                  forces={z: F * em.t}, parameters={g: 10.0, F: 20.0}, contacts={"floor": em.Contact(z)},
                  initial={z: 0.0})  # fmt: skip
    asked = {"rtol": 1e-10, "atol": 1e-10, "sensitivities": ["g", "F", "z"]}
    run = system_for(model, "lagrange").simulate((0.0, 1.0), **asked)
    by_g, by_F, by_z = run.sensitivity.values()
    np.testing.assert_allclose([by_g.dx[0, -1], by_F.dx[0, -1], by_z.dx[0, -1]], [-0.125, 1 / 12, 0.0], atol=1e-8)
    assert by_g.dt_events[0] == pytest.approx([0.05])
