"""A ball bounces ever faster, on plates at any place that rest or move, and comes to rest on them, or ends by name."""

import numpy as np
import pytest
from scipy.optimize import brentq
from sympy import sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.arguments.methods import METHODS

from ..support.generation import system_for

x = dynamicsymbols("x")
at, far, w, unit = symbols("at far w unit", real=True)
gap = x - at - far * sin(w * em.t)
FREE = {
    "coordinates": [x], "kinetic_energy": x.diff() ** 2 / 2, "potential_energy": unit * x, "initial": {x: 2.0},
    "parameters": {at: 0.0, far: 0.0, w: 2.0, unit: 1.0},
}  # fmt: skip
contact = em.Model(name="ball_on_plate", contacts={"plate": em.Contact(gap, 0.6)}, **FREE)
impact = em.Model(name="ball_on_event", events={"plate": em.Event(gap, direction=-1, impact=(gap, 0.6))}, **FREE)
PLATES = [(0.0, 2.0), (0.06, 2.0), (0.3, 1.0), (0.01, 5.0)]
START = {"x": 1.2}, {"x": 0.5}


def bounces(far: float, w: float) -> tuple[float, int]:
    """When a ball under unit gravity has come to rest, and how often it has bounced until flights take 1e-4."""
    plate, speed = lambda t: far * np.sin(w * t), lambda t: far * w * np.cos(w * t)
    t, h, v, last, count = 0.0, START[0]["x"], START[1]["x"], 10.0, 0
    while last > 1e-4:

        def above(s: float, t: float = t, h: float = h, v: float = v) -> float:
            return h + v * s - s * s / 2 - plate(t + s)

        steps = np.linspace(1e-3, 1.0, 400) * last
        down = next(s for s in steps if above(s) < 0.0)
        last = brentq(above, max(down - 1e-2 * last, 1e-6 * last), down, xtol=1e-15)
        t, h, v, count = t + last, plate(t + last), v - last, count + 1
        v = speed(t) - 0.6 * (v - speed(t))
        last = 1.3 * max(2.0 * (v - speed(t)) / (1.0 - far * w * w * np.sin(w * t)), 0.0)
    return t + 0.6 / 0.4 * last, count


@pytest.mark.parametrize("place", [0.0, 1.0, -3.0, 1e3])
@pytest.mark.parametrize("plate", PLATES)
@pytest.mark.parametrize("method", [*METHODS, "auto"])
def test_a_ball_comes_to_rest_on_a_contact_without_a_speed_of_rest(method, plate, place):
    far, w = plate
    system, (x0, v0) = system_for(contact, "lagrange"), START
    run = system.simulate(
        (0.0, 20.0), x0={"x": place + x0["x"]}, v0=v0, rtol=1e-9, atol=1e-10, method=method,
        parameters={"at": place, "far": far, "w": w},
    )  # fmt: skip
    assert run.success, run.message
    gaps, (end, count) = run.x[0] - place - far * np.sin(w * run.t), bounces(far, w)
    assert gaps.min() > -1e-13 * (1.0 + abs(place))
    assert gaps[-1] == pytest.approx(0.0, abs=1e-14 * (1.0 + abs(place)))
    assert count < len(run.t_events[0]) < count + 60
    assert run.t_events[0][-1] == pytest.approx(end, abs=1e-3)


@pytest.mark.parametrize("place", [0.0, 1.0, 1e3])
@pytest.mark.parametrize("plate", PLATES)
@pytest.mark.parametrize("method", ["dop853", "ra15", "radau9"])
def test_a_ball_on_an_impact_ends_by_name(method, plate, place):
    far, w = plate
    run = system_for(impact, "lagrange").simulate(
        (0.0, 20.0), x0={"x": place + 1.2}, v0=START[1], rtol=1e-9, atol=1e-10, method=method,
        parameters={"at": place, "far": far, "w": w},
    )  # fmt: skip
    assert run.stop is em.StopReason.EVENTS_PILE_UP
    assert run.t[-1] == pytest.approx(bounces(far, w)[0], abs=0.05)
    assert (run.x[0] - place - far * np.sin(w * run.t)).min() > -5e-8 * (1.0 + abs(place))


@pytest.mark.parametrize("length", [1e-6, 1.0, 1e6])
@pytest.mark.parametrize("time", [1e-6, 1.0, 1e6])
def test_it_does_so_in_any_units(length, time):
    far, w, atol = 0.06, 2.0, 1e-10 * length * min(1.0, 1.0 / time)
    run = system_for(contact, "lagrange").simulate(
        (0.0, 20.0 * time), x0={"x": 2.2 * length}, v0={"x": 0.5 * length / time}, rtol=1e-9, atol=atol,
        parameters={"at": length, "far": far * length, "w": w / time, "unit": length / time**2},
    )  # fmt: skip
    assert run.success, run.message
    assert run.x[0, -1] / length == pytest.approx(1.0 + far * np.sin(w * 20.0), abs=1e-13)
    assert run.t_events[0][-1] / time == pytest.approx(bounces(far, w)[0], abs=1e-3)
