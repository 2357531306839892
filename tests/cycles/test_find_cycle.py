"""Cycles against closed forms, published gaits, and quadratures that share no code."""

from functools import cache

import numpy as np
import pytest
from scipy.integrate import quad, solve_bvp, solve_ivp
from scipy.optimize import brentq
from scipy.special import ellipk
from sympy import cos, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Event, Friction, Model, ModelError, System

from ..support.generation import system_for, system_of

x, z = dynamicsymbols("x z")
mu, alpha, beta, delta, A, w, g, e, a, c, F = symbols("mu alpha beta delta A w g e a c F")


@cache
def van_der_pol() -> System:
    return system_for(
        Model(name="van_der_pol", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=x**2 / 2,
              forces=[mu * (1 - x**2) * x.diff()], parameters={mu: 1.0}), "lagrange")  # fmt: skip


@cache
def duffing() -> System:
    return system_for(
        Model(name="duffing", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2,
              potential_energy=alpha * x**2 / 2 + beta * x**4 / 4, forces=[-delta * x.diff() + A * cos(w * em.t)],
              parameters={alpha: 1.0, beta: 1.0, delta: 0.2, A: 0.3, w: 1.2}), "lagrange")  # fmt: skip


@cache
def simplest_walker() -> System:
    """Garcia et al., J. Biomech. Eng. 120 (1998) 281: massless feet, so forces are stated as accelerations."""
    theta, phi = dynamicsymbols("theta phi")
    gamma = symbols("gamma")
    stance = sin(theta - gamma)
    swing = stance + (theta.diff() ** 2 - cos(theta - gamma)) * sin(phi)
    half = cos(2 * theta)
    reset = {theta: -theta, phi: -2 * theta, theta.diff(): half * theta.diff(),
             phi.diff(): half * (1 - half) * theta.diff()}  # fmt: skip
    return system_for(
        Model(name="simplest_walker", coordinates=[theta, phi],
              kinetic_energy=(theta.diff() ** 2 + phi.diff() ** 2) / 2, forces=[stance, swing],
              parameters={gamma: 0.009}, events={"strike": Event(phi - 2 * theta, direction=1, reset=reset)}),
        "lagrange")  # fmt: skip


def walker(theta: float, rate: float) -> em.Cycle:
    start = {"theta": theta, "phi": 2 * theta}
    rates = {"theta": rate, "phi": (1 - np.cos(2 * theta)) * rate}
    return em.find_cycle(simplest_walker(), x0=start, v0=rates, section="strike")


def test_rimless_wheel():
    """Energy after an impact: E' = cos(2 alpha)^2 (E + constant)."""
    system = system_of("rimless_wheel", "lagrange")
    p = system.parameters
    cycle = em.find_cycle(system, x0={"theta": -0.3}, v0={"theta": 1.2}, section="step")
    speed = np.sqrt(4 * p["g"] * np.sin(p["alpha"]) * np.sin(p["gamma"])) / np.tan(2 * p["alpha"])
    assert cycle.success
    assert cycle.stable is True
    assert cycle.v0["theta"] == pytest.approx(speed, rel=1e-11)
    assert cycle.multipliers == pytest.approx([np.cos(2 * p["alpha"]) ** 2], rel=1e-10)
    assert cycle.closes < 1e-10
    assert abs(cycle.solution.t[-1] - cycle.t - cycle.period) < 1e-14


def test_simplest_walker():
    """Two gaits at one slope: the published fixed point, stable, and the shorter one, unstable."""
    long = walker(0.2, -0.2)
    assert [long.x0["theta"], long.v0["theta"]] == pytest.approx([0.200310900544287, -0.199832473004977], abs=1e-10)
    assert long.stable is True
    assert abs(long.multipliers[0].real + 0.19) < 0.005
    assert abs(abs(long.multipliers[0].imag) - 0.56) < 0.005
    short = walker(0.194, -0.204)
    assert short.success
    assert short.stable is False
    assert short.period < long.period


def test_compass_gait():
    """With light feet it is the walker of Garcia et al."""
    system = system_of("compass_gait", "lagrange")
    cycle = em.find_cycle(system, x0=[0.2, 0.4], v0=[-0.2, -0.0158], section="heel strike", parameters={"m": 1e-3})
    assert [cycle.x0["theta"], cycle.v0["theta"]] == pytest.approx([0.200310900544287, -0.199832473004977], abs=1e-6)
    assert abs(cycle.multipliers[2]) < 1e-9  # the strike leaves two freedoms


def test_van_der_pol():
    cycle = em.find_cycle(van_der_pol(), x0={"x": 2.0}, v0={"x": 0.0})
    assert cycle.period == pytest.approx(6.663286859323130, rel=1e-12)
    trace = quad(lambda t: 1 - cycle.solution.sol(t)[0] ** 2, 0.0, cycle.period, epsabs=1e-12, limit=200)[0]
    assert cycle.multipliers == pytest.approx([np.exp(trace)], rel=1e-8)
    assert cycle.stable is True


def test_a_first_order_state_follows():
    """A filter of the motion: its deviations decay by exp(-rate T)."""
    filtered = Model(name="filtered", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=x**2 / 2,
                     forces=[(1 - x**2) * x.diff()], states={z: c * (x - z)}, parameters={c: 0.1})  # fmt: skip
    cycle = em.find_cycle(system_for(filtered, "lagrange"), x0={"x": 2.0, "z": 0.3}, period=6.6)
    assert cycle.period == pytest.approx(6.663286859323130, rel=1e-11)
    assert cycle.multipliers[0] == pytest.approx(np.exp(-0.1 * cycle.period), rel=1e-9)
    again = cycle.solution.states["z"]
    assert again[-1] == pytest.approx(again[0], abs=1e-9)


def test_van_der_pol_from_elsewhere():
    """The period is the shortest, and half of it up to the symmetry."""
    whole = em.find_cycle(van_der_pol(), x0={"x": 0.1}, v0={"x": 0.0})
    half = em.find_cycle(van_der_pol(), x0={"x": 2.0}, v0={"x": 0.0}, symmetry={"x": "-x"})
    assert whole.period == pytest.approx(6.663286859323130, rel=1e-10)
    assert half.period == pytest.approx(whole.period / 2, rel=1e-10)
    assert half.multipliers**2 == pytest.approx(whole.multipliers, rel=1e-6)


def test_forced_duffing():
    period = 2 * np.pi / 1.2
    cycle = em.find_cycle(duffing(), x0={"x": 0.3}, period=period)
    assert cycle.success
    assert np.prod(cycle.multipliers) == pytest.approx(np.exp(-0.2 * period), rel=1e-10)
    half = em.find_cycle(duffing(), x0=cycle.x0, v0=cycle.v0, period=period / 2, symmetry={"x": "-x"})
    assert np.prod(half.multipliers) == pytest.approx(np.exp(-0.1 * period), rel=1e-10)
    later = em.find_cycle(duffing(), x0={"x": 0.9}, period=period, t=0.7)
    there = cycle.solution.sol(0.7)
    assert [later.x0["x"], later.v0["x"]] == pytest.approx(there, abs=1e-9)
    assert np.sort_complex(later.multipliers) == pytest.approx(np.sort_complex(cycle.multipliers), rel=1e-8)


def swing(angle: float) -> float:
    return 4 * np.sqrt(1 / 9.81) * ellipk(np.sin(angle / 2) ** 2)


def test_swings_of_a_pendulum_are_a_family():
    system = system_of("pendulum", "lagrange")
    cycle = em.find_cycle(system, x0={"theta": 1.0}, free=["theta'", "period"])
    assert cycle.x0["theta"] == pytest.approx(1.0, abs=1e-14)
    assert cycle.period == pytest.approx(swing(1.0), rel=1e-11)
    assert cycle.stable is None
    assert cycle.neutral == 1
    assert "one of a family" in cycle.message
    given = em.find_cycle(system, x0={"theta": 1.0}, period=2.1, free=["theta"])
    assert given.period == 2.1
    assert swing(given.x0["theta"]) == pytest.approx(2.1, rel=1e-10)


def test_units_make_no_difference():
    system = system_of("rimless_wheel", "lagrange")
    for length, mass, hour in ((1e-6, 1.0, 1.0), (1e5, 1e-4, 1.0), (1.0, 1.0, 3600.0)):
        given = {"l": length, "m": mass, "g": 9.81 * length * hour**2}
        cycle = em.find_cycle(system, x0={"theta": -0.3}, v0={"theta": 1.2 * hour}, section="step", parameters=given)
        assert cycle.multipliers == pytest.approx([0.5], rel=1e-10)
        assert cycle.period * hour == pytest.approx(1.034553, rel=1e-5)


def test_a_ball_on_a_driven_table():
    """It bounces once a period: the phase, the trace and the determinant of its map are in closed form."""
    table = a * sin(w * em.t)
    gap = z - table
    ball = Model(name="ball_on_table", coordinates=[z], kinetic_energy=z.diff() ** 2 / 2, potential_energy=g * z,
                 parameters={g: 9.81, a: 0.01, w: 30.0, e: 0.8},
                 events={"table": Event(gap, direction=-1, impact=(gap, e))})  # fmt: skip
    period, again = 2 * np.pi / 30.0, 0.8
    phase = np.arccos((1 - again) * 9.81 * period / (2 * (1 + again) * 0.01 * 30.0))
    start, top = phase / 30.0 + period / 2, 0.01 * np.sin(phase) + 9.81 * period**2 / 8
    cycle = em.find_cycle(system_for(ball, "lagrange"), x0={"z": top * 1.01}, v0={"z": 0.01}, period=period, t=start)
    assert [cycle.x0["z"], cycle.v0["z"]] == pytest.approx([top, 0.0], abs=1e-11)
    bend = -0.01 * 30.0**2 * np.sin(phase)
    assert np.sum(cycle.multipliers) == pytest.approx(1 + again**2 + (1 + again) ** 2 * bend / 9.81, rel=1e-9)
    assert np.prod(cycle.multipliers) == pytest.approx(again**2, rel=1e-9)
    assert cycle.events == ("table",)


def test_a_motor_turns_a_slider_crank():
    """With a constraint, and with the slider as a function of the crank's angle: the same cycle."""
    q, tau = dynamicsymbols("q"), symbols("tau")
    slide = cos(q) + sqrt(9 - sin(q) ** 2)
    values = {tau: 3.0, c: 0.5}
    reduced = Model(name="crank", coordinates=[q], kinetic_energy=q.diff() ** 2 + 2 * slide.diff(em.t) ** 2,
                    forces=[tau - c * q.diff()], parameters=values)  # fmt: skip
    closed = Model(name="slider", coordinates=[q, x], kinetic_energy=q.diff() ** 2 + 2 * x.diff() ** 2,
                   holonomic_constraints=[(x - cos(q)) ** 2 + sin(q) ** 2 - 9], forces=[tau - c * q.diff(), 0],
                   parameters=values, initial={x: 4.0})  # fmt: skip
    turn = {"symmetry": {"q": "q + 2*pi"}, "section": "q"}
    right = em.find_cycle(system_for(reduced, "lagrange"), x0={"q": 0.0}, v0={"q": 5.0}, **turn)
    for formulation in ("lagrange", "eigenfactor"):
        found = em.find_cycle(system_for(closed, formulation), x0={"q": 0.0, "x": 4.0}, v0={"q": 5.0}, **turn)
        assert found.success
        assert found.period == pytest.approx(right.period, rel=1e-10)
        assert found.multipliers == pytest.approx(right.multipliers, rel=1e-8)
        assert found.v0["q"] == pytest.approx(right.v0["q"], rel=1e-10)


def test_what_nothing_depends_on_advances():
    """A cart that an oscillator pushes: its mean speed is that of the mean force."""
    y = dynamicsymbols("y")
    cart = Model(name="pushed_cart", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
                 potential_energy=x**2 / 2, forces=[(1 - x**2) * x.diff(), x**2 - c * y.diff()],
                 parameters={c: 0.5})  # fmt: skip
    cycle = em.find_cycle(system_for(cart, "lagrange"), x0={"x": 2.0}, v0={"x": 0.0, "y": 3.0})
    start = [cycle.x0["x"], cycle.v0["x"], 0.0]
    run = solve_ivp(lambda t, s: [s[1], (1 - s[0] ** 2) * s[1] - s[0], s[0] ** 2], (0, cycle.period), start,
                    method="DOP853", rtol=1e-12, atol=1e-12)  # fmt: skip
    assert cycle.advance == {"y": pytest.approx(run.y[2, -1] / 0.5, rel=1e-9)}
    assert max(cycle.multipliers.real) == pytest.approx(np.exp(-0.5 * cycle.period), rel=1e-8)


def test_stick_and_slip_on_a_belt():
    """Sticking forgets the past: the multiplier is 0. While it slips, the motion is linear."""
    v, pushed = symbols("v pushed")
    rub = Model(name="belt", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=x**2 / 2,
                forces=[pushed * x.diff()], contacts={"belt": Friction(x.diff() - v, limit=F)},
                parameters={F: 1.0, v: 0.5, pushed: 0.1})  # fmt: skip
    rate, root = 0.05, np.sqrt(1 - 0.05**2)
    # from x = F + pushed v, x' = v, about x = F: x - F = exp(rate t) (b cos + d sin)(root t)
    b = 0.05
    d = (0.5 - rate * b) / root

    def speed(t: float) -> float:
        C, S = np.cos(root * t), np.sin(root * t)
        return float(np.exp(rate * t) * (rate * (b * C + d * S) + root * (d * C - b * S)) - 0.5)

    slips = brentq(speed, 4.0, 6.2, xtol=1e-14)
    ends = np.exp(rate * slips) * (b * np.cos(root * slips) + d * np.sin(root * slips))
    cycle = em.find_cycle(system_for(rub, "lagrange"), x0={"x": 0.0}, v0={"x": 0.2})
    assert cycle.success
    assert cycle.period == pytest.approx(slips + (b - ends) / 0.5, rel=1e-10)
    assert abs(cycle.multipliers[0]) < 1e-9


def test_bristles_stick_and_slip():
    """LuGre friction on a belt, stiff; SciPy's Radau with equations of its own comes back after the same period."""
    cycle = em.find_cycle(system_of("lugre_oscillator", "lagrange"), x0={"x": 1.0}, v0={"x": 0.1}, period=7.0,
                          method="radau9", rtol=1e-9)  # fmt: skip
    assert cycle.success
    assert cycle.stable is True

    def rates(_: float, s: np.ndarray) -> list[float]:
        slip = 0.1 - s[1]
        bend = slip - 1e5 * abs(slip) * s[2] / (1.0 + 0.5 * np.exp(-((slip / 1e-3) ** 2)))
        return [s[1], -2 * s[0] + 1e5 * s[2] + 1e5**0.5 * bend + 0.4 * slip, bend]

    start = [cycle.x0["x"], cycle.v0["x"], cycle.x0["z"]]
    end = solve_ivp(rates, (0, cycle.period), start, method="Radau", rtol=1e-9, atol=1e-13).y[:, -1]
    assert end == pytest.approx(start, rel=1e-5)


def test_a_block_leaves_a_table_and_rests_again():
    """It leaves where the table's acceleration is -g, lands without bouncing, and forgets: multipliers are 0."""
    table = a * sin(w * em.t)
    block = Model(name="block_on_table", coordinates=[z], kinetic_energy=z.diff() ** 2 / 2, potential_energy=g * z,
                  parameters={g: 9.81, a: 0.015, w: 30.0}, contacts={"table": em.Contact(z - table)})  # fmt: skip
    period, size, rate = 2 * np.pi / 30.0, 0.015, 30.0
    leaves = np.arcsin(9.81 / (size * rate**2)) / rate

    def gap(t: float) -> float:
        flies = size * np.sin(rate * leaves) + size * rate * np.cos(rate * leaves) * (t - leaves)
        return float(flies - 9.81 * (t - leaves) ** 2 / 2 - size * np.sin(rate * t))

    lands = brentq(gap, leaves + 0.05, leaves + 0.95 * period, xtol=1e-15)
    start = 0.5 * (leaves + lands)  # in the air
    height = gap(start) + size * np.sin(rate * start)
    cycle = em.find_cycle(system_for(block, "lagrange"), x0={"z": height + 1e-3}, v0={"z": 0.0}, period=period, t=start)
    speed = size * rate * np.cos(rate * leaves) - 9.81 * (start - leaves)
    assert cycle.success
    assert [cycle.x0["z"], cycle.v0["z"]] == pytest.approx([height, speed], abs=1e-10)
    assert np.abs(cycle.multipliers).max() < 1e-9
    assert cycle.solution.t_events[0][0] == pytest.approx(lands, abs=1e-10)


def test_an_overturned_pendulum_that_is_shaken():
    """Deviations grow by 2e8 in a period: in segments; SciPy's boundary-value solver finds the same motion."""
    model = Model(name="overturned", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=9 * cos(x),
                  forces=[A * cos(em.t)], parameters={A: 2.0})  # fmt: skip
    cycle = em.find_cycle(system_for(model, "lagrange"), x0={"x": 0.0}, v0={"x": 0.0}, period=2 * np.pi)
    assert cycle.success
    assert "segments" in cycle.message
    assert cycle.stable is False
    times = np.linspace(0, 2 * np.pi, 101)
    right = solve_bvp(lambda t, s: [s[1], 9 * np.sin(s[0]) + 2 * np.cos(t)], lambda a, b: a - b, times,
                      [-0.2 * np.cos(times), 0.2 * np.sin(times)], tol=1e-11, max_nodes=100000)  # fmt: skip
    assert right.success
    assert [cycle.x0["x"], cycle.v0["x"]] == pytest.approx(right.y[:, 0], abs=1e-9)
    assert cycle.closes < 1e-11
    slope = quad(lambda t: 3 * np.sqrt(np.cos(right.sol(t)[0])), 0, 2 * np.pi, epsabs=1e-10)[0]
    assert np.log(cycle.multipliers[0].real) == pytest.approx(slope, rel=1e-3)  # as if the rate changed slowly


def test_segments_find_what_one_run_finds():
    one = em.find_cycle(van_der_pol(), x0={"x": 2.0}, v0={"x": 0.0})
    four = em.find_cycle(van_der_pol(), x0={"x": 2.1}, v0={"x": 0.1}, period=6.5, segments=4)
    assert four.success
    assert four.period == pytest.approx(one.period, rel=1e-11)
    assert four.multipliers == pytest.approx(one.multipliers, rel=1e-8)
    half = em.find_cycle(van_der_pol(), x0={"x": 2.0}, v0={"x": 0.0}, period=3.3, symmetry={"x": "-x"}, segments=3)
    assert half.period == pytest.approx(one.period / 2, rel=1e-11)
    with pytest.raises(ModelError, match="segments is 0"):
        em.find_cycle(van_der_pol(), x0={"x": 2.0}, segments=0)


def test_equilibria_are_no_cycles():
    with pytest.raises(ModelError, match="nothing moves, it is an equilibrium"):
        em.find_cycle(system_of("pendulum", "lagrange"), x0={"theta": 0.0})
    still = em.find_cycle(system_of("pendulum", "lagrange"), x0={"theta": 0.0}, period=1.0)
    assert not still.success
    assert "equilibrium" in still.message
    assert "equilibrium" in str(still)
    assert still.stable is None


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"section": "bottom"}, "unknown section"),
        ({"symmetry": {"theta": "theta + 1"}}, "symmetry is none of the equations"),
        ({"symmetry": {"theta": "theta**2"}}, "constant factors"),
        ({"symmetry": {"theta": "0"}}, "cannot be inverted"),
        ({"free": ["thet"]}, "name in free"),
        ({"free": "theta"}, "list of names"),
        ({"period": -1.0}, "positive"),
    ],
)
def test_wrong_arguments(given, words):
    with pytest.raises(ModelError, match=words):
        em.find_cycle(system_of("pendulum", "lagrange"), x0={"theta": 1.0}, **given)


def test_forcing_needs_its_period():
    with pytest.raises(ModelError, match=r"depend on time\. Give the period"):
        em.find_cycle(duffing(), x0={"x": 0.3})
    with pytest.raises(ModelError, match=r"depend on time\. Give the period"):
        em.find_cycle(duffing(), x0={"x": 0.3}, section="x")
    later = em.find_cycle(duffing(), x0={"x": 0.3}, period=2 * np.pi / 1.2, section="x")  # at the time that it finds
    assert later.success
    assert later.x0["x"] == pytest.approx(0.3, abs=1e-14)


def test_too_few_runs():
    found = em.find_cycle(van_der_pol(), x0={"x": 1.0}, period=6.0, max_runs=4)
    assert not found.success
    assert "4 runs were not enough" in found.message


def refused(cycle: em.Cycle, inputs: dict | None = None) -> None:
    """The motion closes once, does not come back after the second period, and is no success."""
    T = cycle.period
    run = cycle.system.simulate((0.0, 2 * T), x0=cycle.x0, v0=cycle.v0, inputs=inputs, rtol=1e-10, t_eval=[0, T, 2 * T])
    assert run.x[0][1] == pytest.approx(run.x[0][0], abs=1e-7)
    assert abs(run.x[0][2] - run.x[0][0]) > 1e-3
    assert not cycle.success
    assert cycle.stable is None
    assert "the forcing does not repeat after period" in cycle.message


def test_a_period_that_is_not_that_of_the_forcing():
    refused(em.find_cycle(duffing(), period=4.0))
    twice = em.find_cycle(duffing(), x0={"x": 0.3}, period=4 * np.pi / 1.2)
    assert twice.success


@cache
def pushed() -> System:
    u = dynamicsymbols("u")
    return system_for(
        Model(name="pushed", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=x**2 / 2,
              forces=[u - c * x.diff()], parameters={c: 0.3}, inputs={u: 0.0}), "lagrange")  # fmt: skip


def test_a_signal_that_does_not_repeat():
    times = np.linspace(0.0, 10.0, 101)
    wave = {"u": (times, np.sin(2 * times))}
    refused(em.find_cycle(pushed(), period=3.0, inputs=wave), wave)
    once = np.linspace(0.0, np.pi, 101)
    for samples in (once, np.append(once, once[1:] + np.pi)):  # as far as it is known
        cycle = em.find_cycle(pushed(), period=np.pi, inputs={"u": (samples, np.sin(2 * samples))})
        assert cycle.success
    steps = em.Signal(np.arange(0.0, 8.0, 0.5), [1.0, -1.0] * 8, kind="hold")
    assert em.find_cycle(pushed(), period=1.0, inputs={"u": steps}).success
    refused(em.find_cycle(pushed(), period=1.5, inputs={"u": steps}), {"u": steps})


def test_kicks_of_other_sizes():
    """Kicks once a second, of three sizes in turn: accelerations and events repeat after a second, sizes do not."""
    kick = 1 + sin(2 * np.pi * em.t / 3) / 2
    model = Model(name="kicked", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=x**2 / 2,
                  forces=[-c * x.diff()], parameters={c: 0.3},
                  events={"kick": Event(sin(2 * np.pi * em.t), direction=1, reset={x.diff(): x.diff() + kick})},
                  initial={x: 0.5})  # fmt: skip
    system = system_for(model, "lagrange")
    once = em.find_cycle(system, period=1.0, t=0.5)
    assert not once.success
    assert "the second period does not close" in once.message
    assert em.find_cycle(system, period=3.0, t=0.5).success


def test_a_prescribed_support():
    """At y = sin(t)^3 the support and its speed are 0 at 0 and at pi, and go to the other side after it."""
    y, load = dynamicsymbols("y load")
    model = Model(name="supported", coordinates=[y, load], kinetic_energy=(y.diff() ** 2 + load.diff() ** 2) / 2,
                  potential_energy=(load - y) ** 2, forces=[0, -c * load.diff()], parameters={c: 0.3},
                  holonomic_constraints=[y - sin(em.t) ** 3])  # fmt: skip
    system = system_for(model, "lagrange")
    half = em.find_cycle(system, period=np.pi)
    assert not half.success
    assert "accelerations a period later differ" in half.message
    assert em.find_cycle(system, period=2 * np.pi).success
