"""Friction that sticks and slides: against closed forms, in every kind of method."""

from functools import cache

import numpy as np
import pytest
from sympy import cos, sign, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Contact, Friction, Model, StopReason, System, t

from ..support.generation import FORMULATIONS, system_for, system_of

G = 9.81
METHODS = ("dop853", "ra15", "radau5")
x, z = dynamicsymbols("x z")
m, g, e, mu = symbols("m g e mu", positive=True)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("friction", [0.5, 0.3])
def test_a_block_on_an_incline_stops_in_closed_form(method, friction):
    run = system_of("block_on_incline", "lagrange").simulate(
        (0.0, 2.0), method=method, parameters={"mu": friction}, rtol=1e-9, atol=1e-11
    )
    slope, held = np.sin(0.4), friction * np.cos(0.4)
    stops = 3 / (G * (slope + held))
    back = 0.0 if friction > np.tan(0.4) else G * (slope - held) / 2 * (2 - stops) ** 2
    assert run.t_events[0] == pytest.approx([stops], rel=1e-12)
    assert run.x[0, -1] == pytest.approx(1.5 * stops - back, rel=1e-11)
    assert run.modes[-1][1] == {"friction_stuck": float(not back), "friction_slides": -float(back > 0)}
    assert run.multipliers[0, -1] == pytest.approx(0.0 if back else -G * slope)


@cache
def dragged() -> System:
    """A block on a belt of speed w, held by a spring: the violin string, which sticks and slips for ever."""
    k, w = symbols("k w", positive=True)
    return system_for(
        Model(name="dragged", coordinates=[x], kinetic_energy=m * x.diff() ** 2 / 2, potential_energy=k * x**2 / 2,
              contacts={"belt": Friction(x.diff() - w, limit=mu)},
              parameters={m: 1.0, k: 4.0, w: 0.5, mu: 1.0}), "cholesky")  # fmt: skip


@pytest.mark.parametrize("method", METHODS)
def test_a_block_on_a_belt_is_let_go_where_the_spring_pulls_as_much(method):
    run = dragged().simulate((0.0, 1.5), v0={"x": 0.5}, method=method, rtol=1e-10, atol=1e-12)
    lets_go = 1.0 / 4.0 / 0.5
    assert run.t_events[0][0] == pytest.approx(lets_go, rel=1e-9)
    times = run.t[run.t > lets_go]
    assert run.x[0][run.t > lets_go] == pytest.approx(0.25 + 0.25 * np.sin(2 * (times - lets_go)), abs=1e-8)


@pytest.mark.parametrize("method", ["dop853", "ra15", "radau5"])
@pytest.mark.parametrize("formulation", ["eigenfactor", "lagrange"])
@pytest.mark.parametrize("push", [0.0, 1e-17, -1e-30])
def test_what_begins_to_slip_begins_with_no_tiny_step(formulation, method, push):
    """Without speed, and with an acceleration of rounding: a step of 3e-15 s ended one run by ra15 in forty."""
    begins = symbols("begins")
    model = Model(name="grows", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, forces={x: t + begins},
                  parameters={begins: 0.0})  # fmt: skip
    run = system_for(model, formulation).simulate((0.0, 3.0), parameters={"begins": push}, method=method)
    assert run.x[0, -1] == pytest.approx(4.5, rel=1e-6)
    assert run.t[1] > 1e-5


def test_friction_at_rest_balances_what_changes_and_never_chatters():
    """A push that grows and falls: stuck up to the limit, sliding beyond, stuck again as it is slow enough."""
    model = Model(name="pushed", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, forces={x: 2 * sin(t)},
                  contacts={"ground": Friction(x.diff(), limit=1)})  # fmt: skip
    run = system_for(model, "lagrange").simulate((0.0, 20.0), rtol=1e-9, atol=1e-11)
    assert run.success
    assert run.t_events[0][0] == pytest.approx(np.pi / 6, rel=1e-9)
    assert len(run.t_events[0]) <= 14  # two of each half period
    stuck = np.array([mode["ground_stuck"] for _, mode in run.modes])
    assert set(stuck) == {0.0, 1.0}
    assert run.nsteps < 1000


@cache
def thrown(formulation: str) -> System:
    """A block thrown on to the floor, which holds it back by mu times what it presses; a plumb load may press, too."""
    load = symbols("load")
    return system_for(
        Model(name="thrown", coordinates=[x, z], kinetic_energy=m * (x.diff() ** 2 + z.diff() ** 2) / 2,
              potential_energy=m * g * z, forces={z: -load},
              contacts={"floor": Contact(z), "rub": Friction(x.diff(), limit=mu, normal="floor")},
              parameters={m: 2.0, g: G, mu: 0.3, load: 0.0}, initial={z: 1.0, x.diff(): 2.0}), formulation)  # fmt: skip


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("method", METHODS)
def test_friction_is_in_proportion_to_what_presses(formulation, method):
    system, load = thrown(formulation), 5.0
    run = system.simulate((0.0, 3.0), method=method, parameters={"load": load}, rtol=1e-9, atol=1e-11)
    assert run.success, run.message
    falls, slows = np.sqrt(2 / (G + load / 2)), 0.3 * (G + load / 2)
    left = 2.0 - slows * falls  # the floor's impulse takes mu times its own of the speed
    stops = falls + left / slows
    assert run.t_events[0] == pytest.approx([falls], rel=1e-8)
    assert run.t_events[1] == pytest.approx([stops], rel=1e-8)
    assert run.x[:, -1] == pytest.approx([2.0 * falls + left**2 / (2 * slows), 0.0], abs=1e-8)
    assert [tuple(mode.values()) for _, mode in run.modes] == [(0, 0, 0), (1, 0, 1), (1, 1, 0)]
    sliding = (run.t > falls + 1e-9) & (run.t < stops)
    assert run.multipliers[0, sliding] == pytest.approx(-2 * G - load)


def rod(friction: float) -> Model:
    """One that leans into the floor and slides there on its tip."""
    y, phi = dynamicsymbols("y phi")
    rub = Friction(x.diff() - (sin(phi)).diff(t), friction, "tip")
    return Model(name="rod", coordinates=[x, y, phi],
                 kinetic_energy=(x.diff() ** 2 + y.diff() ** 2 + phi.diff() ** 2 / 30) / 2, potential_energy=g * y,
                 contacts={"tip": Contact(y - cos(phi)), "rub": rub},
                 parameters={g: G}, initial={y: cos(0.6), phi: 0.6})  # fmt: skip


@pytest.mark.parametrize("mode", [{"tip_held": 1.0, "rub_slides": 1.0}, {"tip_held": 1.0, "rub_stuck": 1.0}, {}])
def test_slopes_where_friction_takes_part_of_multipliers(mode):
    """Of accelerations by x and v, against differences: sliding, sticking, in the air."""
    system = system_for(rod(0.3), "lagrange")
    p, z = system.prepare(mode), np.array([0.1, 0.8, 0.6, 0.7, -0.2, 0.4])
    J, h = system.compiled.motion_jacobian(0.0, z, p, [], False), 1e-5
    for k, column in enumerate(J[3:].T):
        beside = (z + sign * h * (np.arange(6) == k) for sign in (1, -1))
        there, back = (system.acceleration(one[:3], one[3:], parameters=p)[0] for one in beside)
        assert column == pytest.approx((there - back) / (2 * h), rel=1e-7, abs=1e-7)


def test_friction_that_jams_is_named():
    """No acceleration satisfies contact and friction (Painleve)."""
    model = rod(3.0)
    slips = {"x": -3.0}
    runs = [system_for(model, "lagrange").simulate((0.0, 0.5), v0={"x": sign * slips["x"]}) for sign in (1, -1)]
    assert any(
        run.stop is StopReason.CONTACTS_CLASH and "jams" in run.message and "'tip'" in run.message for run in runs
    )


def test_a_friction_takes_no_impulse():
    """What strikes a block that sticks to the ground moves it; the friction then stops it."""
    q = dynamicsymbols("q")
    model = Model(name="hit", coordinates=[x, q], kinetic_energy=(x.diff() ** 2 + q.diff() ** 2) / 2,
                  contacts={"ground": Friction(q.diff(), limit=2)},
                  events={"hit": em.Event(q - x - 1, direction=-1, impact=(q - x - 1, 1))},
                  initial={x.diff(): 1.0, q: 2.0})  # fmt: skip
    run = system_for(model, "lagrange").simulate((0.0, 3.0), rtol=1e-10, atol=1e-12)
    assert run.t_events[0] == pytest.approx([1.0])
    assert run.v[:, -1] == pytest.approx([0.0, 0.0], abs=1e-12)
    assert run.x[:, -1] == pytest.approx([1.0, 2.25], abs=1e-10)


@pytest.mark.parametrize("press", [-2.0, ([0.0, 1.0, 3.0], [1.0, -1.0, -3.0])])
def test_what_does_not_press_does_not_rub(press):
    """A negative limit, as where a normal force in it changes its sign, must not drive what slides."""
    N = dynamicsymbols("N")
    system = system_for(
        Model(name="pressed", coordinates=[x], kinetic_energy=m * x.diff() ** 2 / 2, inputs={N: 1.0},
              contacts={"pad": Friction(x.diff(), limit=mu * N)}, parameters={m: 1.0, mu: 0.5}),
        "lagrange",
    )  # fmt: skip
    run = system.simulate((0.0, 3.0), v0=[1.0], inputs={"N": press}, rtol=1e-9, atol=1e-11)
    impulse = 0.5 * 0.5 / 2 if isinstance(press, tuple) else 0.0  # until the force is gone at t = 1/2
    assert run.v[0, -1] == pytest.approx(1.0 - impulse, rel=1e-8)


@pytest.mark.parametrize("method", ["dop853", "ra15", "radau9"])
def test_what_chatters_is_told_of_friction(method):
    chatters = system_for(
        Model(name="chatters", coordinates=[x], kinetic_energy=m * x.diff() ** 2 / 2, forces={x: -sign(x.diff())},
              parameters={m: 1.0}), "lagrange")  # fmt: skip
    run = chatters.simulate((0.0, 2.0), v0=[1.0], method=method, max_steps=2000)
    assert not run.success
    assert "that is a Friction" in run.message
