"""Stops of friction cones: closed forms, by every method, at every tolerance and in every unit."""

from functools import cache
from itertools import product

import numpy as np
import pytest
import sympy
from scipy.integrate import solve_ivp
from sympy import symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion
from eigenmotion import Friction, Model
from eigenmotion.stability.cases.cones import billiard_ball, rolls

METHODS = ("radau5", "radau9", "auto", "dop853", "ra15")
TOLERANCES = (1e-6, 1e-8, 1e-10, 1e-12)
RUNS = tuple(product(METHODS, TOLERANCES))
x, y = dynamicsymbols("x y")
m, f, F, G = symbols("m f F G", real=True)


@cache
def puck():
    """Return a puck under a constant force (F, G), held back by a friction f."""
    model = Model(
        name="puck_in_a_plane",
        coordinates=[x, y],
        kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2) / 2,
        forces={x: F, y: G},
        contacts={"rub": Friction((x.diff(), y.diff()), f)},
        parameters={m: 1.0, f: 3.0, F: 0.0, G: 0.0},
    )
    return eigenmotion.build(model)


def stops(force, friction, speed, angle):
    """Return when and where a puck of mass 1 stops: along the force and across.

    At an angle p from the force, u = tan(p / 2), k = friction / force: speed = C u^k / sin p, and
    dt = -speed dp / (force sin p).
    """
    u, k = np.tan(angle / 2), friction / force
    C = speed * np.sin(angle) / u**k
    t = C / (2 * force) * (u ** (k - 1) / (k - 1) + u ** (k + 1) / (k + 1))
    along = C**2 / (4 * force) * (u ** (2 * k - 2) / (2 * k - 2) - u ** (2 * k + 2) / (2 * k + 2))
    across = C**2 / (2 * force) * (u ** (2 * k - 1) / (2 * k - 1) + u ** (2 * k + 1) / (2 * k + 1))
    return t, np.array([along, across])


def run(method, rtol, length, v0, **parameters):
    scaled = {name: value * length for name, value in parameters.items()}
    return eigenmotion.simulate(
        puck(), (0.0, 3.0), x0=[0.0, 0.0], v0=length * np.array(v0), method=method, rtol=rtol,
        atol=1e-3 * rtol * length, parameters=scaled,
    )  # fmt: skip


def stopped_at(solution):
    return solution.modes[-1][0]


@pytest.mark.parametrize(("method", "rtol"), RUNS)
@pytest.mark.parametrize("length", [1e-3, 1.0, 1e3])
@pytest.mark.parametrize("turned", [0.4636, -0.4636, np.pi / 2, np.pi, 3.6])
def test_a_puck_stops_on_a_straight_line(method, rtol, length, turned):
    way = np.array([np.cos(turned), np.sin(turned)])
    solution = run(method, rtol, length, 1.1 * way, f=2.943)
    assert solution.success, solution.message
    assert not solution.v[:, -1].any()
    np.testing.assert_allclose(solution.x[:, -1] / length, 1.1**2 / (2 * 2.943) * way, rtol=0, atol=10 * rtol)
    np.testing.assert_allclose(stopped_at(solution), 1.1 / 2.943, rtol=0, atol=10 * rtol)


@pytest.mark.parametrize(("method", "rtol"), RUNS)
@pytest.mark.parametrize("length", [1e-3, 1.0, 1e3])
@pytest.mark.parametrize(("force", "turned", "side"), [(1.0, 0.3, 1), (1.0, 2.0, -1), (-2.5, 0.0, 1), (2.8, 4.0, -1)])
def test_a_puck_stops_under_a_side_force(method, rtol, length, force, turned, side):
    """Its direction turns into that of the force, ever faster."""
    way = np.sign(force) * np.array([np.cos(turned), np.sin(turned)])
    across = side * np.array([-way[1], way[0]])
    angle, speed = 1.2, 0.9
    t, (far, aside) = stops(abs(force), 3.0, speed, angle)
    v0 = speed * (np.cos(angle) * way + np.sin(angle) * across)
    span = 1.5 * t
    solution = eigenmotion.simulate(
        puck(), (0.0, span), x0=[0.0, 0.0], v0=length * v0, method=method, rtol=rtol, atol=1e-3 * rtol * length,
        parameters={"f": 3.0 * length, "F": abs(force) * way[0] * length, "G": abs(force) * way[1] * length},
    )  # fmt: skip
    assert solution.success, solution.message
    assert not solution.v[:, -1].any()
    np.testing.assert_allclose(solution.x[:, -1] / length, far * way + aside * across, rtol=0, atol=100 * rtol * far)
    np.testing.assert_allclose(stopped_at(solution), t, rtol=0, atol=100 * rtol * t)


@pytest.mark.parametrize(("method", "rtol"), RUNS)
def test_a_ball_with_side_rolls(method, rtol):
    """The point that touches stops on a straight line, the centre on a parabola."""
    trial = rolls(0.2)
    start = np.concatenate([trial.x0, trial.v0])
    system = eigenmotion.build(billiard_ball())
    times = np.append(0.0, trial.times)
    solution = system.simulate(
        (0.0, times[-1]), x0=trial.x0, v0=trial.v0, t_eval=times, method=method, rtol=rtol, atol=1e-3 * rtol
    )
    assert solution.success, solution.message
    found = np.vstack([solution.x, solution.v]).T
    right = trial.truth.rows(start, times, 0)
    np.testing.assert_allclose(found, right, rtol=0, atol=100 * rtol * np.abs(right).max())


# --- a disc that rubs beside its middle ---

J, r = symbols("J r", positive=True)
p = dynamicsymbols("p")
OUTSET = np.array([0.0, 0.0, 0.3])
SETS_OUT = ((0.0, 1.2, -0.4, -5.0), (-0.7, 1.2, -0.4, -5.0), (0.7, -0.9, 3.3, 1.1), (1.3, -2.6, 0.4, -2.8))


@cache
def disc():
    slips = x.diff() - r * sympy.sin(p) * p.diff(), y.diff() + r * sympy.cos(p) * p.diff()
    model = Model(
        name="disc_with_a_foot",
        coordinates=[x, y, p],
        kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2) / 2 + J * p.diff() ** 2 / 2,
        forces={x: F},
        contacts={"rub": Friction(slips, f)},
        parameters={m: 1.0, J: 0.2, r: 0.5, f: 3.0, F: 0.0},
    )
    return eigenmotion.build(model)


def slip_of(z):
    return z[3:5] + 0.5 * z[5] * np.array([-np.sin(z[2]), np.cos(z[2])])


@cache
def until_it_stops(force, *v0):
    """Return when its slip is 1e-7, and the state there, by SciPy."""

    def rates(_, z):
        way = slip_of(z) / np.hypot(*slip_of(z))
        push = force - 3.0 * way[0], -3.0 * way[1]
        torque = -3.0 * 0.5 * (np.cos(z[2]) * way[1] - np.sin(z[2]) * way[0])
        return np.array([*z[3:], *push, torque / 0.2])

    def stops(_, z):
        return np.hypot(*slip_of(z)) - 1e-7

    stops.terminal = True
    run = solve_ivp(rates, (0.0, 5.0), [*OUTSET, *v0], "DOP853", rtol=1e-12, atol=1e-13, events=stops)
    assert run.status == 1
    return run.t[-1], run.y[:, -1]


@pytest.mark.parametrize("method", ["rk34", "dopri5", "dop853", "ra15", "radau5", "radau9"])
@pytest.mark.parametrize("rtol", [1e-4, 1e-6, 1e-8])
@pytest.mark.parametrize("start", SETS_OUT)
def test_a_slip_that_is_a_difference_of_speeds_stops(method, rtol, start):
    """However small atol is, and by methods whose steps would go to and fro over no slip."""
    force, *v0 = start
    t, state = until_it_stops(*start)
    run = eigenmotion.simulate(
        disc(), (0.0, t + 0.1), x0=OUTSET, v0=v0, parameters={"F": force}, method=method, rtol=rtol, atol=1e-3 * rtol,
        t_eval=[0.0, t, t + 0.1], max_steps=5000,
    )  # fmt: skip
    assert run.success, run.message
    found = np.append(run.x[:, 1], run.v[:, 1])
    assert found == pytest.approx(state, abs=100 * rtol * np.abs(v0).max())
