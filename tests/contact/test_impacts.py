"""Effects of impacts and resets on runs."""

from functools import cache

import numpy as np
import pytest
import sympy
from scipy.optimize import brentq
from sympy import symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Event, Model, ModelError, StopReason, System, t

from ..support.generation import model_of, system_for, system_of

x, z = dynamicsymbols("x z")
g, e = symbols("g e", real=True)


def ball(name: str, **more) -> Model:
    """A unit mass above z = 0."""
    events = more.pop("events", {"floor": Event(z, direction=-1, impact=(z, e))})
    return Model(name=name, coordinates=[x, z], kinetic_energy=(x.diff() ** 2 + z.diff() ** 2) / 2,
                 potential_energy=g * z, parameters={g: 9.81, e: 0.9}, events=events,
                 initial={z: 1.0, x.diff(): 1.0}, **more)  # fmt: skip


@cache
def struck_ball() -> System:
    hit = {"floor": Event(z, direction=-1, impact=(z, e)), "wall": Event(1 - x, direction=-1, impact=(1 - x, 1)),
           "high": Event(z.diff(), direction=-1), "far": Event(x - 5, terminal=True)}  # fmt: skip
    return system_for(ball("struck_ball", events=hit), "lagrange")


def bounces(count: int, e: float) -> np.ndarray:
    """When a ball that falls from z = 1 strikes the floor."""
    first = np.sqrt(2 / 9.81)
    return np.cumsum([first, *(2 * first * e**k for k in range(1, count))])


@pytest.mark.parametrize("tolerance", [1e-2, 1e-6, 1e-12])
def test_forty_bounces_then_zenos_end_by_name(tolerance):
    run = struck_ball().simulate((0.0, 20.0), v0={"x": 0.0}, rtol=tolerance, atol=tolerance)
    assert run.t_events[0][:40] == pytest.approx(bounces(40, 0.9), abs=1e-10)
    assert run.stop is StopReason.EVENTS_PILE_UP
    assert "'floor'" in run.message
    assert run.t[-1] == pytest.approx(bounces(2000, 0.9)[-1], rel=1e-9)
    assert run.x[1].min() > -1e-12
    assert run.energy[-1] < 1e-6


@pytest.mark.parametrize("method", ["rk34", "dopri5", "ra15", "radau5", "radau9"])
def test_every_method_goes_on_from_the_root(method):
    run = struck_ball().simulate((0.0, 3.0), method=method, rtol=1e-9, atol=1e-11, dense_output=True)
    assert run.t_events[0] == pytest.approx(bounces(5, 0.9)[:4], abs=1e-6)
    assert run.t_events[1] == pytest.approx([1.0], abs=1e-6)
    assert len(run.t_events[2]) == 4  # after each
    assert run.x[0, -1] == pytest.approx(-1.0, abs=1e-6)
    assert run.sol(1.5)[0] == pytest.approx(0.5, abs=1e-6)
    struck = np.flatnonzero(np.diff(run.t) == 0)
    assert len(struck) == 5  # a row before and one after each
    assert np.array_equal(run.x[:, struck], run.x[:, struck + 1])
    assert run.y_after_events[0][:, 3] == pytest.approx(-0.9 * run.y_events[0][:, 3])
    assert run.y_after_events[2] is run.y_events[2] or np.array_equal(run.y_after_events[2], run.y_events[2])


def test_rows_asked_for_are_on_their_side_of_an_impact():
    times = np.linspace(0.0, 3.0, 301)
    run = struck_ball().simulate((0.0, 3.0), v0={"x": 0.0}, t_eval=times, rtol=1e-9, atol=1e-11)
    starts = np.array([0.0, *bounces(5, 0.9)])
    k = np.searchsorted(starts, times, "right") - 1
    speed = np.array([0.0, *(9.81 * np.sqrt(2 / 9.81) * 0.9 ** np.arange(1, 6))])
    height = np.where(k == 0, 1.0, 0.0) + speed[k] * (times - starts[k]) - 9.81 / 2 * (times - starts[k]) ** 2
    assert run.x[1] == pytest.approx(height, abs=1e-9)


def test_what_energy_a_run_may_have_is_counted_from_the_last_impact():
    run = struck_ball().simulate((0.0, 4.5), v0={"x": 0.0}, rtol=1e-12, atol=1e-12)
    assert run.success
    assert run.energy[-1] == pytest.approx(9.81 * 0.9 ** (2 * len(run.t_events[0])), rel=1e-9)


@pytest.mark.parametrize(("restitution", "speed"), [(0.0, 0.0), (1.0, 9.81 * np.sqrt(2 / 9.81))])
def test_plastic_and_elastic(restitution, speed):
    run = struck_ball().simulate((0.0, 0.46), parameters={"e": restitution}, rtol=1e-10, atol=1e-10)
    assert run.y_after_events[0][0, 3] == pytest.approx(speed, abs=1e-12)


def test_what_is_stuck_without_a_contact_says_so():
    run = struck_ball().simulate((0.0, 1.0), parameters={"e": 0.0}, rtol=1e-10, atol=1e-10)
    assert run.stop is StopReason.EVENTS_PILE_UP
    assert "Contact" in run.message


@pytest.mark.parametrize("value", [-0.1, 1.5])
def test_a_restitution_that_is_none_ends_the_run(value):
    run = struck_ball().simulate((0.0, 1.0), parameters={"e": value})
    assert run.stop is StopReason.IMPACT_UNDEFINED
    assert "restitution" in run.message


def test_on_the_floor_at_the_start_it_falls_no_further():
    run = struck_ball().simulate((0.0, 1.0), x0={"z": 0.0}, v0={"z": 2.0})
    assert run.t_events[0][0] == pytest.approx(4.0 / 9.81, rel=1e-12)
    down = struck_ball().simulate((0.0, 0.3), x0={"z": 0.0}, v0={"z": -2.0})
    assert down.t_events[0][0] == 0.0
    assert down.v[1, -1] == pytest.approx(1.8 - 9.81 * 0.3)


def test_grazing_the_wall_is_no_impact():
    system = struck_ball()
    touches = system.simulate((0.0, 0.6), x0={"x": 1.0 - 1e-9}, v0={"x": 0.0})
    assert len(touches.t_events[1]) == 0
    slow = system.simulate((0.0, 0.4), x0={"x": 1.0 - 1e-9}, v0={"x": 1e-8}, rtol=1e-12, atol=1e-14)
    assert slow.t_events[1] == pytest.approx([0.1], rel=1e-5)


def test_two_at_once_act_in_the_order_of_the_model():
    corner = struck_ball().simulate((0.0, 1.0), x0={"x": 1.0 - np.sqrt(2 / 9.81)}, rtol=1e-12, atol=1e-14)
    assert corner.t_events[0] == pytest.approx([np.sqrt(2 / 9.81)])
    assert corner.t_events[1] == pytest.approx(corner.t_events[0], rel=1e-13)
    assert corner.v[0, -1] == pytest.approx(-1.0)


def test_backwards_is_refused_by_name():
    with pytest.raises(em.ModelError, match=r"runs backwards.*'floor', 'wall'"):
        struck_ball().simulate((1.0, 0.0))
    with pytest.raises(em.ModelError, match="runs backwards"):
        em.simulate_ensemble(struck_ball(), (1.0, 0.0), parameters={"e": [0.5, 0.6]})


def test_members_of_an_ensemble_strike_as_runs_do():
    runs = em.simulate_ensemble(struck_ball(), (0.0, 3.0), parameters={"e": [0.9, 0.8]}, rtol=1e-9, atol=1e-11)
    for k, restitution in enumerate((0.9, 0.8)):
        alone = struck_ball().simulate((0.0, 3.0), parameters={"e": restitution}, rtol=1e-9, atol=1e-11)
        assert np.array_equal(runs.x[k, :, -1], alone.x[:, -1])
        assert np.array_equal(runs[k].t_events[0], alone.t_events[0])


# --- resets ---


def test_resets_see_the_state_before():
    swap = Event(x - 1, direction=1, reset={x: z, z: x, x.diff(): -z.diff() / 2, z.diff(): x.diff() + t})
    run = system_for(ball("swapped", events={"swap": swap}), "cholesky").simulate((0.0, 1.2), rtol=1e-10, atol=1e-12)
    before, after = run.y_events[0][0], run.y_after_events[0][0]
    assert after == pytest.approx([before[1], before[0], -before[3] / 2, before[2] + run.t_events[0][0]], rel=1e-13)


def test_an_impact_comes_before_the_reset_of_its_event():
    both = Event(z, direction=-1, impact=(z, 1), reset={x.diff(): z.diff()})
    run = system_for(ball("both", events={"both": both}), "lagrange").simulate((0.0, 0.5))
    assert run.y_after_events[0][0, 2] == pytest.approx(-run.y_events[0][0, 3])


def test_nothing_begins_where_an_impact_lets_nothing_come():
    """It would fall for ever; nor may a reset put it there. Whichever sign the event has."""
    strikes = {"floor": Event(-z, direction=1, impact=(z, 0.5)), "hole": Event(z - 0.5, -1, reset={z: -e})}
    system = system_for(ball("hole", events=strikes), "lagrange")
    for height in (-0.5, -1e-14):
        with pytest.raises(ModelError, match="impact of event 'floor' lets nothing come"):
            system.simulate((0.0, 1.0), x0={"z": height})
    run = system.simulate((0.0, 1.0), x0={"z": 1.0})
    assert run.stop is StopReason.RESET_INSIDE
    assert "'hole'" in run.message
    assert "'floor'" in run.message
    assert system.simulate((0.0, 0.4), x0={"z": 1.0}, parameters={"e": 0.0}).success


def test_a_terminal_event_acts_before_it_ends_the_run():
    last = Event(z, direction=-1, impact=(z, 1), terminal=True)
    run = system_for(ball("last", events={"last": last}), "lagrange").simulate((0.0, 5.0))
    assert run.stop is StopReason.TERMINAL_EVENT
    assert run.v[1, -1] == pytest.approx(np.sqrt(2 * 9.81))
    assert run.v[1, -2] == pytest.approx(-run.v[1, -1])


def test_quasi_velocities_are_reset_by_what_they_stand_for():
    r, phi, w, u = dynamicsymbols("r phi w u")
    model = Model(name="turned", coordinates=[r, phi], kinetic_energy=(w**2 + u**2) / 2,
                  quasi_velocities={w: r * phi.diff(), u: r.diff() + phi.diff()},
                  events={"turn": Event(t - 1, direction=1, reset={w: -w, r: 2 * r})},
                  initial={r: 1.0, phi.diff(): 0.3, r.diff(): 0.1})  # fmt: skip
    run = system_for(model, "lagrange").simulate((0.0, 1.5), rtol=1e-10, atol=1e-12)
    at = np.flatnonzero(np.diff(run.t) == 0)[0]
    quasi = run.quasi_velocities
    assert quasi["w"][at + 1] == pytest.approx(-quasi["w"][at])
    assert quasi["u"][at + 1] == pytest.approx(quasi["u"][at])
    assert run.x[0, at + 1] == pytest.approx(2 * run.x[0, at])


def test_a_reset_that_leaves_a_constraint_ends_the_run_by_name():
    l = sympy.Integer(1)
    off = Event(x, direction=1, reset={x.diff(): 2 * x.diff(), z.diff(): z.diff() + 1})
    model = ball("left", events={"off": off}, holonomic_constraints=[x**2 + z**2 - l])
    run = system_for(model, "lagrange").simulate((0.0, 5.0), x0={"x": -0.6, "z": -0.8}, v0={"x": 0.0})
    assert run.stop is StopReason.RESET_OFF
    assert "'off'" in run.message
    assert "row 0" in run.message


def test_a_blocked_impact_ends_the_run_by_name():
    model = ball("blocked", events={"b": Event(t - 1, impact=(x - z, e))}, holonomic_constraints=[x - z - 1])
    run = system_for(model, "lagrange").simulate((0.0, 5.0), x0={"x": 2.0}, v0={"x": 1.0, "z": 1.0})
    assert run.stop is StopReason.FINISHED  # what a constraint keeps apart already does not approach
    model = ball("blocked", events={"b": Event(t - 1, impact=(x - 2 * z, e))},
                 nonholonomic_constraints=[x.diff() - 1, z.diff() - 2])  # fmt: skip
    run = system_for(model, "lagrange").simulate((0.0, 5.0), v0={"x": 1.0, "z": 2.0})
    assert run.stop is StopReason.IMPACT_UNDEFINED
    assert "'b'" in run.message


# --- what is refused ---


@pytest.mark.parametrize(
    ("event", "words"),
    [
        (lambda: Event(z, reset={g: 1}), "reset.*neither a coordinate nor"),
        (lambda: Event(z, reset={x: dynamicsymbols("q")}), r"reset\[x\] of events\[e\] contains 'q'"),
        (lambda: Event(z, impact=(z, symbols("k"))), "restitution of events.*'k'"),
        (lambda: Event(z, impact=(x.diff(), 1)), "phi of the impact.*velocity"),
        (lambda: Event(z, impact=(g, 1)), "phi of the impact.*no coordinate"),
        (lambda: Event(z, impact=z), "Give \\(phi, restitution\\)"),
        (lambda: Event(z, impact=(z, 2)), "from 0"),
        (lambda: Event(z, reset=3), "reset of an event must be a mapping"),
    ],
)
def test_what_no_event_does_is_refused_by_name(event, words):
    with pytest.raises(em.ModelError, match=words):
        ball("refused", events={"e": event()})


# --- mechanisms that step and strike ---


def test_a_rimless_wheel_comes_to_its_closed_form_speed():
    model = model_of("rimless_wheel")
    run = system_for(model).simulate((0.0, 30.0), rtol=1e-10, atol=1e-12)
    alpha, gamma = (dict(model.parameters)[symbols(name, real=True)] for name in ("alpha", "gamma"))
    speed = np.sqrt(4 * 9.81 * np.sin(alpha) * np.sin(gamma)) / np.tan(2 * alpha)
    assert run.y_after_events[0][-1, 1] == pytest.approx(speed, rel=1e-9)


def test_a_clock_swings_as_far_as_its_escapement_pays_for():
    """Swing by swing by the balance of work, and in the end by A = E / (2 tau); without the escapement it stops."""
    system = system_for(model_of("clock"), "lagrange")
    run = system.simulate((0.0, 120.0), rtol=1e-10, atol=1e-12)
    ticks = [0.5 * 0.994**2 * v**2 for v in run.y_after_events[0][:, 1]]
    weight, tau, paid = 9.81 * 0.994, 0.1, 0.04
    work = weight * (1 - np.cos(0.1)) - tau * 0.1 + paid
    for found in ticks:
        assert found == pytest.approx(work, abs=1e-9)
        reach = brentq(lambda A, work=work: weight * (1 - np.cos(A)) + tau * A - work, 0.0, 1.0)
        work += paid - 2 * tau * reach
    assert len(ticks) > 110
    late = run.t > 100
    assert np.abs(run.y_events[1][-5:, 0]) == pytest.approx(paid / (2 * tau), abs=1e-6)  # where it turns
    assert np.abs(run.x[0, late]).max() < 0.2
    alone = system.simulate((0.0, 20.0), parameters={"E": 0.0}, rtol=1e-10, atol=1e-12)
    assert alone.modes[-1][1]["pivot_stuck"] == 1.0
    assert abs(np.sin(alone.x[0, -1])) <= tau / weight


def test_a_compass_gait_comes_to_the_published_fixed_point():
    run = system_for(model_of("compass_gait"), "lagrange").simulate((0.0, 300.0), rtol=1e-11, atol=1e-12)
    published = [0.200161072169750, 0.400322144339512, -0.199906060087682, -0.015805473227965]
    assert run.y_after_events[0][-1] == pytest.approx(published, abs=1e-10)


@pytest.mark.parametrize("method", ["dop853", "radau5"])
def test_newtons_cradle_hands_its_swing_on(method):
    run = system_for(model_of("newtons_cradle"), "lagrange").simulate((0.0, 1.0), method=method, rtol=1e-9, atol=1e-11)
    assert run.success
    assert np.ptp(run.energy) < 1e-9
    assert run.x.max(axis=1) == pytest.approx([0, 0, 0, 0.5], abs=2e-4)
    assert run.x.min(axis=1) == pytest.approx([-0.5, 0, 0, 0], abs=1e-6)


@pytest.mark.parametrize("method", ["dop853", "ra15", "radau5"])
@pytest.mark.parametrize("tolerance", [1e-7, 1e-9, 1e-11])
def test_balls_that_touch_at_rest_are_struck_again_and_again(method, tolerance):
    """Gaps between those at rest are 1e-17 or less, of either sign; what strikes never goes through."""
    at = np.linspace(0.0, 20.0, 401)
    run = system_for(model_of("newtons_cradle"), "lagrange").simulate(
        (0.0, 20.0), method=method, rtol=tolerance, atol=tolerance / 100, t_eval=at
    )
    alone = system_of("pendulum", "lagrange").simulate(
        (0.0, 20.0), x0={"theta": -0.5}, parameters={"l": 0.2}, rtol=1e-13, atol=1e-14, t_eval=at
    )
    swing = alone.x[0]
    expected = np.array([np.minimum(swing, 0), 0 * at, 0 * at, np.maximum(swing, 0)])
    assert run.success, run.message
    assert run.x == pytest.approx(expected, abs=1e3 * tolerance)
