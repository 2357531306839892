"""No event is missed that the step's own interpolant can show: one set of tests for every method, both ways in time."""

from functools import cache

import numpy as np
import pytest
from sympy import Abs, Heaviside, Max, Rational, exp, log, pi, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Event, Model, System, t
from eigenmotion.arguments.methods import METHODS
from eigenmotion.arguments.signals import Signal
from eigenmotion.results.solution import Solution
from eigenmotion.runtime import StopReason

from ..support.generation import system_for

X = dynamicsymbols("x")
WAYS = pytest.mark.parametrize("way", [1, -1])
EVERY = pytest.mark.parametrize("method", METHODS)


@cache
def thrown() -> System:
    """x = t - t^2 / 2, which every method but the implicit ones integrates exactly; all is even about t = 1."""
    level, root = symbols("level root")
    events = {
        "up": Event(X - level, direction=1),
        "down": Event(X - level, direction=-1),
        "level": X - level,
        "floor": X,
        "falling": Event(X, direction=-1),
        "rising": Event(X, direction=1),
        "still": X.diff() * X.diff(),
        "top": X.diff(),
        "clock": t - 2,
        "domain": sqrt(root - X),
    }
    return system_for(
        Model(name="thrown", coordinates=[X], kinetic_energy=X.diff() ** 2 / 2, potential_energy=X, events=events,
              parameters={level: 0.375, root: 10.0}, initial={X.diff(): 1.0})
    )  # fmt: skip


def fired(found: Solution, name: str) -> np.ndarray:
    return found.t_events[thrown().events.index(name)]


def throw(start: float, end: float, **options: object) -> Solution:
    """From time `start` of the throw on; whole in one step where the method can."""
    x0, v0 = [start - start**2 / 2], [1 - start]
    return thrown().simulate((start, end), x0=x0, v0=v0, first_step=abs(end - start), **options)


@WAYS
@EVERY
@pytest.mark.parametrize("depth", [0.375, 1e-3, 1e-5])
def test_two_crossings_within_a_step_fire_in_order(method, way, depth):
    found = throw(1 - way, 1 + way, method=method, parameters={"level": 0.5 - depth}, rtol=1e-8)
    times = 1 + way * np.array([-1, 1]) * np.sqrt(2 * depth)
    np.testing.assert_allclose(fired(found, "level"), times, atol=1e-12)
    np.testing.assert_allclose(fired(found, "up"), times[:1], atol=1e-12)
    np.testing.assert_allclose(fired(found, "down"), times[1:], atol=1e-12)


@WAYS
@pytest.mark.parametrize("method", METHODS)
def test_a_touch_does_not_fire_and_a_graze_fires_twice(method, way):
    for depth in 10.0 ** -np.arange(4, 13):
        options = {"method": method, "rtol": 1e-12}
        assert len(fired(throw(1 - way, 1 + way, parameters={"level": 0.5 + depth}, **options), "level")) == 0, depth
        times = fired(throw(1 - way, 1 + way, parameters={"level": 0.5 - depth}, **options), "level")
        np.testing.assert_allclose(np.abs(times - 1), np.sqrt(2 * depth), rtol=1e-3)
        assert len(times) == 2, depth
    found = throw(1 - way, 1 + way, parameters={"level": 0.5}, **options)
    assert len(fired(found, "level")) in (0, 2)  # which is rounding, but never only one of two


@WAYS
@EVERY
def test_what_touches_zero_exactly_keeps_its_sign(method, way):
    found = throw(1 - way, 1 + way, method=method)
    assert len(fired(found, "still")) == 0
    np.testing.assert_allclose(fired(found, "top"), [1.0], atol=1e-5)


@WAYS
@EVERY
def test_leaving_zero_does_not_fire_and_returning_does(method, way):
    end = 1 + 1.5 * way
    found = throw(1 - way, end, method=method, rtol=1e-9, atol=1e-9)
    for name in ("floor", "falling"):
        np.testing.assert_allclose(fired(found, name), [1 + way], atol=1e-6)
    assert len(fired(found, "rising")) == 0


@WAYS
@EVERY
def test_a_zero_at_the_end_fires(method, way):
    found = thrown().simulate((2 - way, 2), v0=[way], method=method, t_eval=[2.0])
    assert fired(found, "clock").tolist() == [2.0]
    beyond = thrown().simulate((2, 2 + way), v0=[way], method=method)
    assert len(fired(beyond, "clock")) == 0  # nor again where the next run starts


@EVERY
def test_an_event_at_a_row_and_at_the_end_of_a_step(method):
    """Steps that end where g is zero, and then go on."""
    found = thrown().simulate((1, 4), v0=[0.0], method=method, first_step=0.25, max_step=0.25, t_eval=[1.0, 2.0, 4.0])
    np.testing.assert_allclose(fired(found, "clock"), [2.0], rtol=1e-15)
    assert found.t.tolist() == [1.0, 2.0, 4.0]


# --- a ball that bounces ----------------------------------------------------------------------------------------------


@cache
def ball() -> System:
    events = {"floor": Event(X, terminal=True), "also": X, "top": X.diff()}
    energy = X.diff() ** 2 / 2
    return system_for(Model(name="ball", coordinates=[X], kinetic_energy=energy, potential_energy=X, events=events,
                            initial={X: 1.0}))  # fmt: skip


@WAYS
@EVERY
@pytest.mark.parametrize("clock", ["goes on", "starts anew"])
def test_a_bouncing_ball_does_not_fall_through_the_floor(method, way, clock):
    """Restarted from each event's row; flights become shorter than any first step, 2 sqrt(2) 0.8^k."""
    start, x, v = 0.0, [1.0], [0.0]
    for k in range(60):
        found = ball().simulate((start, start + 10 * way), x0=x, v0=v, method=method, rtol=1e-8, atol=1e-12)
        assert found.stop is StopReason.TERMINAL_EVENT, k
        flight = np.sqrt(2) * (1 if k == 0 else 2 * 0.8**k)
        assert abs(found.t[-1] - start) == pytest.approx(flight, rel=1e-4), k
        assert [len(times) for times in found.t_events] == [1, 1, int(k > 0)], k  # starting at the top is no event
        assert found.x.min() > -1e-14
        start = float(found.t[-1]) if clock == "goes on" else 0.0
        x, v = found.x[:, -1], -0.8 * found.v[:, -1]


# --- many events on a motion known in closed form ---------------------------------------------------------------------

LEVELS = [Rational(k, 100) for k in (-99, -90, -71, -40, -13, 2, 35, 62, 88, 97)]


@cache
def swinging() -> System:
    """x = sin t."""
    events = {f"x{k}": X - level for k, level in enumerate(LEVELS)}
    events |= {f"v{k}": X.diff() - level for k, level in enumerate(LEVELS)}
    events |= {f"w{k}": sin(2 * X) + exp(X.diff()) - 1 - level for k, level in enumerate(LEVELS)}
    return system_for(Model(name="swinging", coordinates=[X], kinetic_energy=X.diff() ** 2 / 2,
                            potential_energy=X**2 / 2, events=events, initial={X.diff(): 1.0}))  # fmt: skip


def on_paper(end: float) -> list[int]:
    at = np.linspace(0, end, 400_001)
    x, v = np.sin(at), np.cos(at)
    levels = np.array(LEVELS, dtype=float)[:, None]
    rows = [*(x - levels), *(v - levels), *(np.sin(2 * x) + np.exp(v) - 1 - levels)]
    return [int(np.sum(np.sign(row[1:]) != np.sign(row[:-1]))) for row in rows]


@WAYS
@EVERY
@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-10])
def test_none_of_many_is_missed_however_long_the_steps(method, way, rtol):
    end = way * 20.0
    found = swinging().simulate((0, end), method=method, rtol=rtol, atol=0.1 * rtol)
    assert found.success
    exact = on_paper(end)
    wrong = [k for k, (times, count) in enumerate(zip(found.t_events, exact, strict=False)) if len(times) != count]
    loose = rtol > 1e-6  # where the amplitude itself is off by a per cent, the highest level may not be reached
    assert not [k for k in wrong if not (loose and abs(LEVELS[k % 10]) > 0.85)], wrong


# --- jumps, and places without a value --------------------------------------------------------------------------------


@cache
def pushed() -> System:
    u = dynamicsymbols("u")
    events = {"on": u - Rational(1, 2), "off": Event(Rational(1, 2) - u, terminal=True, direction=1)}
    return system_for(Model(name="pushed", coordinates=[X], kinetic_energy=X.diff() ** 2 / 2, forces={X: u},
                            inputs={u: 0.0}, events=events))  # fmt: skip


@EVERY
@pytest.mark.parametrize("options", [{}, {"dense_output": True}, {"t_eval": [0.0, 1.0, 2.0, 3.0]}])
def test_a_jump_of_an_input_fires_there_and_ends_the_run_once(method, options):
    push = {"u": Signal([0, 1, 2], [0.0, 1.0, 0.0], "hold")}
    found = pushed().simulate((0, 3), inputs=push, method=method, **options)
    assert [times.tolist() for times in found.t_events] == [[1.0, 2.0], [2.0]]
    assert found.stop is StopReason.TERMINAL_EVENT
    assert found.t[-1] == 2.0
    assert (np.diff(found.t) > 0).all()
    back = pushed().simulate((3, 0), inputs={"u": Signal([0, 1, 2], [1.0, 0.0, 1.0], "hold")}, method=method)
    assert [times.tolist() for times in back.t_events] == [[2.0, 1.0], [2.0]] or back.t[-1] == 2.0


@EVERY
def test_an_event_without_a_value_is_named(method):
    start = thrown().simulate((0, 2), method=method, parameters={"root": -1.0})
    assert (start.stop, start.t.tolist()) == (StopReason.EVENT_UNDEFINED, [0.0])
    assert "'domain'" in start.message
    later = thrown().simulate((0, 2), method=method, parameters={"root": 0.375, "level": 0.3}, max_step=0.2)
    assert later.stop is StopReason.EVENT_UNDEFINED
    assert "'domain'" in later.message
    assert not later.success
    assert later.t[-1] == pytest.approx(0.5, abs=1e-6)
    assert len(fired(later, "level")) == 1


@EVERY
def test_a_run_that_ends_before_an_event_loses_its_value_succeeds(method):
    system = system_for(
        Model(name="sinking", coordinates=[X], kinetic_energy=X.diff() ** 2 / 2, initial={X: 1.0, X.diff(): -1.0},
              events={"near": Event(X - Rational(1, 10), terminal=True), "log": log(X) + 1})
    )  # fmt: skip
    found = system.simulate((0, 5), method=method, first_step=0.5, rtol=1e-8)
    assert found.stop is StopReason.TERMINAL_EVENT
    np.testing.assert_allclose(np.concatenate(found.t_events), [0.9, 1 - np.exp(-1)], rtol=1e-6)


@EVERY
def test_what_came_to_zero_before_the_end_and_rests_there_does_not_fire_at_the_end(method):
    system = system_for(
        Model(name="resting", coordinates=[X], kinetic_energy=X.diff() ** 2 / 2, initial={X: 1.0, X.diff(): -1.0},
              events={"overlap": Max(X, 0)})
    )  # fmt: skip
    found = system.simulate((0, 5), method=method, max_step=0.4, first_step=0.25)
    assert found.success
    assert found.t_events[0].size == 0


@WAYS
@EVERY
@pytest.mark.parametrize(
    ("g", "count"),
    [(sin(20 * pi * X + Rational(1, 10)), 200), (Heaviside(X - 3) - Rational(1, 2), 1), (Abs(X - 3) - 1, 2)],
    ids=["wild", "jump", "kink"],
)
def test_events_that_vary_faster_than_the_motion_are_not_missed(g, count, method, way):
    """x = t: steps of the motion alone would hold up to fifty periods of g."""
    free = system_for(Model(name="free", coordinates=[X], kinetic_energy=X.diff() ** 2 / 2, events={"g": g}))
    start, end = (0.0, 10.0)[::way]
    found = free.simulate((start, end), x0=[start], v0=[1.0], method=method)
    assert found.success, found.message
    assert len(found.t_events[0]) == count


@WAYS
@EVERY
@pytest.mark.parametrize("max_step", [np.inf, 0.07])
def test_what_rests_at_zero_between_its_signs_fires_where_it_leaves(method, way, max_step):
    """It fired anywhere in between, by each method elsewhere: x = t, and nothing happens from 3 to 7."""
    free = system_for(Model(name="slack", coordinates=[X], kinetic_energy=X.diff() ** 2 / 2,
                            events={"slack": Max(X - 7, 0) - Max(3 - X, 0)}))  # fmt: skip
    start, end = (0.0, 10.0)[::way]
    found = free.simulate((start, end), x0=[start], v0=[1.0], method=method, max_step=max_step)
    np.testing.assert_allclose(found.t_events[0], [5 + 2 * way], rtol=1e-8)
