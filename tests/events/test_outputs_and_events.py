"""Outputs with accelerations and multipliers, and events located on the projected trajectory, in every method."""

from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from sympy import Rational, cos, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Event, Model, ModelError, System, multiplier, t
from eigenmotion.arguments.methods import IMPLICIT, METHODS
from eigenmotion.arguments.signals import Signal
from eigenmotion.runtime import StopReason

from ..support.generation import FORMULATIONS, system_for

M, G, L = 2.0, 9.81, 1.5
X0 = L * np.array([np.sin(1.0), -np.cos(1.0)])
TIGHT = {"rtol": 1e-10, "atol": 1e-12}


@cache
def pendulum(formulation: str = "eigenfactor") -> System:
    """A bob on a rod in Cartesian coordinates, and a cart and arm of their own so that M varies; pushed by u."""
    x, y, cart, arm, u = dynamicsymbols("x y cart arm u")
    m, g, l = symbols("m g l", positive=True)
    beside = cart.diff() ** 2 + arm.diff() ** 2 / 2 + cart.diff() * arm.diff() * cos(arm)
    return system_for(
        Model(
            name="watched",
            coordinates=[x, y, cart, arm],
            kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2) / 2 + beside,
            potential_energy=m * g * y - cos(arm),
            forces={x: u},
            inputs={u: 0.0},
            holonomic_constraints=[(x**2 + y**2 - l**2) * Rational(1, 2)],
            parameters={m: M, g: G, l: L},
            outputs={
                "tension": multiplier(0) * l,
                "accelerometer": (x.diff(t, 2) * x + (y.diff(t, 2) + g) * y) / l,  # along the rod
                "power": u * x.diff(),
                "cart": cart.diff(t, 2),
                "clock": t**2,
            },
            events={
                "lowest": x,
                "rightwards": Event(x, direction=1),
                "leftwards": Event(x, direction=-1),
                "turning": x.diff() * cos(t) ** 2 + y.diff() * x / 10 + x.diff() / 2,
                "pushed": u - Rational(1, 2),
                "over": Event(y, direction=1, terminal=True),
            },
            initial={x: X0[0], y: X0[1], arm: 1.0},
        ),
        formulation,
    )


def on_paper(at: np.ndarray) -> np.ndarray:
    """(angle, rate) (2, k) of the pendulum from rest at one radian."""
    rate = lambda _, q: [q[1], -G / L * np.sin(q[0])]  # noqa: E731
    return solve_ivp(rate, (0, at[-1]), [1.0, 0.0], "DOP853", t_eval=at, rtol=1e-12, atol=1e-13).y


# --- outputs ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_outputs_with_accelerations_and_multipliers(formulation):
    at = np.linspace(0, 3, 31)
    found = pendulum(formulation).simulate((0, 3), t_eval=at, **TIGHT)
    angle, rate = on_paper(at)
    tension = M * L * rate**2 + M * G * np.cos(angle)
    np.testing.assert_allclose(found.outputs["tension"], tension, atol=1e-8)
    np.testing.assert_allclose(found.outputs["accelerometer"], -tension / M, atol=1e-8)  # it feels the rod alone
    np.testing.assert_allclose(found.outputs["clock"], at**2, rtol=1e-15)
    np.testing.assert_array_equal(found.outputs["power"], 0)


def test_an_acceleration_is_the_second_derivative_of_the_motion():
    h, at = 1e-3, np.array([0.4, 1.1, 1.9])
    times = np.sort(np.concatenate([at - h, at, at + h]))
    found = pendulum().simulate((0, 3), t_eval=times, **TIGHT)
    cart = found.x[2].reshape(-1, 3)
    second = (cart[:, 0] - 2 * cart[:, 1] + cart[:, 2]) / h**2
    np.testing.assert_allclose(found.outputs["cart"][1::3], second, rtol=1e-5, atol=1e-5)


def test_outputs_see_the_inputs_of_their_time():
    push = {"u": Signal([0, 1, 2], [0.0, 3.0, -2.0], "linear")}
    found = pendulum().simulate((0, 2), inputs=push, **TIGHT)
    u = np.interp(found.t, [0, 1, 2], [0, 3, -2])
    np.testing.assert_allclose(found.outputs["power"], u * found.v[0], atol=1e-13)


# --- events -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("method", METHODS)
def test_events_lie_on_the_projected_trajectory_to_rounding(method, formulation):
    """Also where steps are long: the state at an event is on the constraint, and the event's expression zero there."""
    system = pendulum(formulation)
    found = system.simulate((0, 6), method=method, rtol=1e-4, atol=1e-6)
    times = dict(zip(system.events, found.t_events, strict=True))
    rows = dict(zip(system.events, found.y_events, strict=True))
    assert len(times["lowest"]) == 5
    x = rows["lowest"][:, :2]
    np.testing.assert_allclose(np.hypot(*x.T), L, rtol=1e-15)
    assert np.abs(x[:, 0]).max() < 8e-15  # three units in the last place of the time, at that speed
    for time, y in zip(times["turning"], rows["turning"], strict=True):
        q, v = y[:4], system.compiled.velocity_rows(np.array([time]), y[None], system.prepare())[0]
        assert abs(v[0] * np.cos(time) ** 2 + v[1] * q[0] / 10 + v[0] / 2) < 1e-13
        assert abs(q[:2] @ v[:2]) < 1e-14


@pytest.mark.parametrize("method", METHODS)
def test_times_are_those_of_the_elliptic_integral_and_directions_are_told_apart(method):
    system = pendulum()
    found = system.simulate((0, 5), method=method, rtol=1e-7, atol=1e-9, max_step=0.5)
    times = dict(zip(system.events, found.t_events, strict=True))
    quarter = solve_ivp(
        lambda _, q: [q[1], -G / L * np.sin(q[0])], (0, 2), [1.0, 0.0], "DOP853", rtol=1e-12, atol=1e-13,
        events=lambda _, q: q[0],
    ).t_events[0][0]  # fmt: skip
    np.testing.assert_allclose(times["lowest"], quarter * np.arange(1, 10, 2)[: len(times["lowest"])], atol=5e-6)
    assert len(times["lowest"]) == 4
    np.testing.assert_allclose(times["leftwards"], times["lowest"][::2], rtol=1e-12)
    np.testing.assert_allclose(times["rightwards"], times["lowest"][1::2], rtol=1e-12)
    assert all(rows.shape == (len(t), system.n_state) for t, rows in zip(found.t_events, found.y_events, strict=True))


@pytest.mark.parametrize("method", IMPLICIT)
def test_implicit_methods_locate_events_on_the_projected_trajectory_too(method):
    found = pendulum().simulate((0, 3), method=method, rtol=1e-5)
    rows = found.y_events[0]
    assert len(rows)
    np.testing.assert_allclose(np.hypot(rows[:, 0], rows[:, 1]), L, rtol=1e-14)
    assert np.abs(rows[:, 0]).max() < 4e-15


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("options", [{}, {"t_eval": [0.0, 0.1, 5.0]}, {"dense_output": True}])
def test_a_terminal_event_ends_the_run_where_it_happens(method, options):
    fast = np.array([8.0, 0.0, 0.0, 0.0])
    found = pendulum().simulate((0, 5), x0=[0, -L, 0, 1], v0=fast, method=method, rtol=1e-8, **options)
    assert (found.stop, found.status, found.success) == (StopReason.TERMINAL_EVENT, 1, True)
    (time,), (row,) = found.t_events[5], found.y_events[5]
    assert "terminal event" in found.message
    assert f"{time:.6g}" in found.message
    np.testing.assert_allclose(np.abs(row[:2]), [L, 0], atol=1e-12)
    if "t_eval" in options:
        assert list(found.t) == [0.0, 0.1]
    else:
        assert found.t[-1] == time
        np.testing.assert_allclose(found.y[:, -1], row, atol=1e-13)
    if options.get("dense_output"):
        np.testing.assert_allclose(found.sol(time)[:2], row[:2], atol=1e-12)


@pytest.mark.parametrize("method", METHODS)
def test_a_jump_of_an_input_fires_at_its_sample(method):
    push = {"u": Signal([0, 0.75, 1.25], [0.0, 1.0, 0.0], "hold")}
    found = pendulum().simulate((0, 2), inputs=push, method=method, rtol=1e-6)
    np.testing.assert_allclose(found.t_events[4], [0.75, 1.25], rtol=1e-14)


@pytest.mark.parametrize("method", ["dop853", "radau5", "radau9"])
def test_backwards_directions_are_those_of_the_run(method):
    there = pendulum().simulate((0, 3), **TIGHT)
    back = pendulum().simulate((3, 0), x0=there.x[:, -1], v0=there.v[:, -1], method=method, rtol=1e-8)
    np.testing.assert_allclose(back.t_events[0], there.t_events[0][::-1], atol=1e-5)
    np.testing.assert_allclose(back.t_events[1], there.t_events[2][::-1], atol=1e-5)


def test_implicit_methods_agree_with_explicit_ones_on_every_event():
    explicit = pendulum().simulate((0, 4), rtol=1e-9, max_step=0.1)
    implicit = pendulum().simulate((0, 4), method="radau5", rtol=1e-8, max_step=0.1)
    for ours, theirs in zip(explicit.t_events, implicit.t_events, strict=True):
        np.testing.assert_allclose(theirs, ours, atol=1e-6)


def test_a_model_without_events_has_none():
    x = dynamicsymbols("x")
    system = system_for(Model(name="free", coordinates=[x], kinetic_energy=x.diff() ** 2))
    for method in ("dop853", "radau5"):
        found = system.simulate((0, 1), v0=[1.0], method=method)
        assert found.t_events is None
        assert found.y_events is None


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("apart", [1e-2, 1e-5])
def test_two_passages_close_together_fire_wherever_in_a_long_step(method, apart):
    """Uniform motion, which every interpolant holds exactly, in steps of seconds: q = t. Some lie at nodes."""
    q, (first, gap) = dynamicsymbols("q"), symbols("first gap")
    at = q - first
    system = system_for(
        Model(name="close_passages", coordinates=[q], kinetic_energy=q.diff() ** 2 / 2, initial={q.diff(): 1.0},
              parameters={first: 1.0, gap: 0.1}, events={"pair": at * (at - gap)}), "lagrange")  # fmt: skip
    for place in np.linspace(0.1, 9.9, 99):
        run = system.simulate((0.0, 10.0), parameters={"first": place, "gap": apart}, method=method)
        assert run.t_events[0] == pytest.approx([place, place + apart], abs=1e-9)


def test_an_event_of_parameters_alone_is_refused():
    """It never changes its sign, and was taken without a word."""
    x, a = dynamicsymbols("x"), symbols("a")
    with pytest.raises(ModelError, match=r"events\[never\] contains neither the time nor anything that moves: a - 1"):
        Model(
            name="idle", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=0, parameters={a: 2.0},
            events={"never": Event(a - 1)},
        )  # fmt: skip
