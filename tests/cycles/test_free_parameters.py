"""Cycles whose parameters are found, too: closed forms, quadratures and runs by SciPy."""

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq
from scipy.special import ellipk
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Event, Model, ModelError

from ..support.generation import system_for, system_of
from .test_find_cycle import duffing, van_der_pol

x, z = dynamicsymbols("x z")
a, c, e, g, k, w, A = symbols("a c e g k w A")
WHEEL = {"x0": {"theta": -0.3}, "v0": {"theta": 1.2}, "section": "step"}


def slope_of(rate: float, length: float = 1.0) -> float:
    """The slope at which the rimless wheel has a rate after each step."""
    alpha = 0.392699081698724
    return float(np.arcsin(rate**2 * np.tan(2 * alpha) ** 2 * length / (4 * 9.81 * np.sin(alpha))))


def period_of(slope: float) -> float:
    """By quadrature of the rimless wheel's energy."""
    alpha = 0.392699081698724
    rate = np.sqrt(4 * 9.81 * np.sin(alpha) * np.sin(slope)) / np.tan(2 * alpha)
    energy = rate**2 + 2 * 9.81 * np.cos(slope - alpha)
    return quad(lambda q: 1 / np.sqrt(energy - 2 * 9.81 * np.cos(q)), slope - alpha, slope + alpha, epsabs=1e-14)[0]


@pytest.mark.parametrize("free", [["gamma"], {"gamma": 0.12}, [symbols("gamma", real=True)]])
def test_the_slope_for_a_rate(free):
    rate = dynamicsymbols("theta").diff()
    for condition in ("theta' - 1.5", rate - 1.5):
        cycle = em.find_cycle(system_of("rimless_wheel", "lagrange"), free=free, conditions=[condition], **WHEEL)
        assert cycle.success
        assert cycle.free == {"gamma": pytest.approx(slope_of(1.5), rel=1e-11)}
        assert cycle.parameters["gamma"] == cycle.free["gamma"]
        assert cycle.v0["theta"] == pytest.approx(1.5, rel=1e-11)
        assert cycle.multipliers == pytest.approx([0.5], rel=1e-10)
    assert "gamma = 0.1" in str(cycle)


def test_the_slope_for_a_period_and_for_a_speed():
    system, alpha = system_of("rimless_wheel", "lagrange"), 0.392699081698724
    given = em.find_cycle(system, free=["gamma"], period=0.8, **WHEEL)
    assert given.period == pytest.approx(0.8, abs=1e-11)
    assert given.free["gamma"] == pytest.approx(brentq(lambda s: period_of(s) - 0.8, 0.08, 0.4, xtol=1e-14), rel=1e-9)
    speed = em.find_cycle(system, free=["gamma"], conditions=["2*l*sin(alpha)/period - 0.9"], **WHEEL)
    wanted = brentq(lambda s: 2 * np.sin(alpha) / period_of(s) - 0.9, 0.08, 0.4, xtol=1e-14)
    assert speed.free["gamma"] == pytest.approx(wanted, rel=1e-9)


def test_two_parameters():
    """Rate and period of a rimless wheel: from them g and the slope, by the same closed forms."""
    cycle = em.find_cycle(system_of("rimless_wheel", "lagrange"), free=["gamma", "g"],
                          conditions=["theta' - 1.5", "period - 0.8"], **WHEEL)  # fmt: skip
    tempo = np.sqrt(cycle.free["g"] / 9.81)  # all rates are in proportion to sqrt(g)
    assert cycle.success
    assert period_of(cycle.free["gamma"]) / tempo == pytest.approx(0.8, rel=1e-9)
    assert slope_of(1.5 / tempo) == pytest.approx(cycle.free["gamma"], rel=1e-9)


def test_the_length_of_a_pendulum():
    """Of the family of swings the one of amplitude 1 and period 2."""
    cycle = em.find_cycle(system_of("pendulum", "lagrange"), x0={"theta": 0.9}, section="theta'", free=["l"],
                          conditions=["theta - 1", "period - 2"])  # fmt: skip
    assert cycle.success
    assert cycle.free["l"] == pytest.approx(9.81 * (2 / (4 * ellipk(np.sin(0.5) ** 2))) ** 2, rel=1e-10)


def test_the_force_for_an_amplitude():
    """A driven oscillator at x' = 0, whose time is found: closed forms of amplitude and phase; an input, too."""
    u = dynamicsymbols("u")
    model = Model(name="driven_oscillator", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2,
                  potential_energy=k * x**2 / 2, forces=[u * cos(w * em.t) - c * x.diff()],
                  parameters={k: 4.0, c: 0.3, w: 1.7}, inputs={u: 1.0})  # fmt: skip
    cycle = em.find_cycle(system_for(model, "lagrange"), x0={"x": 0.5}, section="x'", period="2*pi/w", free=["u"],
                          conditions=["x - 2"])  # fmt: skip
    assert cycle.success
    stiff, damped = 4 - 1.7**2, 0.3 * 1.7
    assert abs(cycle.free["u"]) == pytest.approx(2 * np.hypot(stiff, damped), rel=1e-10)
    phase = np.arctan2(damped, stiff) + (np.pi if cycle.free["u"] < 0 else 0.0)
    assert np.exp(1j * 1.7 * cycle.t) == pytest.approx(np.exp(1j * phase), abs=1e-9)
    assert cycle.free["t"] == cycle.t


def test_the_force_for_an_amplitude_of_duffings_oscillator():
    cycle = em.find_cycle(duffing(), x0={"x": 0.5}, section="x'", period="2*pi/w", free=["A"], conditions=["x - 0.7"])
    assert cycle.success
    force = cycle.free["A"]
    times = cycle.t, cycle.t + 2 * np.pi / 1.2
    run = solve_ivp(lambda t, s: [s[1], force * np.cos(1.2 * t) - 0.2 * s[1] - s[0] - s[0] ** 3], times, [0.7, 0.0],
                    method="DOP853", rtol=1e-12, atol=1e-13)  # fmt: skip
    assert run.y[:, -1] == pytest.approx([0.7, 0.0], abs=1e-9)
    fixed = em.find_cycle(duffing(), x0={"x": 0.7}, period="2*pi/w", t=cycle.t, parameters={"A": force})
    assert [fixed.x0["x"], fixed.v0["x"]] == pytest.approx([0.7, 0.0], abs=1e-9)
    assert np.sort_complex(fixed.multipliers) == pytest.approx(np.sort_complex(cycle.multipliers), rel=1e-8)


def ball() -> em.System:
    gap = z - a * sin(w * em.t)
    return system_for(
        Model(name="ball_on_free_table", coordinates=[z], kinetic_energy=z.diff() ** 2 / 2, potential_energy=g * z,
              parameters={g: 9.81, a: 0.01, w: 30.0, e: 0.8},
              events={"table": Event(gap, direction=-1, impact=(gap, e))}), "lagrange")  # fmt: skip


def test_a_hit_at_a_time():
    """From hit to hit of a ball on a driven table; the time of a hit is found, or the table's stroke for a time."""
    period, again = 2 * np.pi / 30.0, 0.8
    start = {"x0": {"z": 0.02}, "v0": {"z": 1.0}, "t": 0.02, "section": "table", "period": "2*pi/w"}
    cycle = em.find_cycle(ball(), **start)
    phase = np.arccos((1 - again) * 9.81 * period / (2 * (1 + again) * 0.01 * 30.0))
    assert cycle.success
    assert np.exp(1j * 30.0 * cycle.t) == pytest.approx(np.exp(1j * phase), abs=1e-9)
    assert cycle.v0["z"] == pytest.approx(9.81 * period / 2, rel=1e-9)
    assert np.prod(cycle.multipliers) == pytest.approx(again**2, rel=1e-8)
    stroke = em.find_cycle(ball(), free=["a"], conditions=["t - 0.03"], **start)
    assert stroke.t == pytest.approx(0.03, abs=1e-12)
    wanted = (1 - again) * 9.81 * period / (2 * (1 + again) * 30.0 * np.cos(30.0 * 0.03))
    assert stroke.free["a"] == pytest.approx(wanted, rel=1e-9)


def test_a_branch_with_a_free_parameter():
    """The slope at which the wheel keeps its rate, along its length."""
    start = em.find_cycle(system_of("rimless_wheel", "lagrange"), free=["gamma"], conditions=["theta' - 1.2"], **WHEEL)
    branch = em.follow(start, "l", to=1.5)
    assert branch.success
    assert branch.v0["theta"] == pytest.approx(1.2, rel=1e-10)
    assert branch.free["gamma"] == pytest.approx([slope_of(1.2, one) for one in branch.parameter], rel=1e-9)
    with pytest.raises(ModelError, match="gamma is free in this cycle"):
        em.follow(start, "gamma", to=0.2)


def test_what_is_not_determined():
    """Rates depend on g / l alone."""
    cycle = em.find_cycle(system_of("rimless_wheel", "lagrange"), free=["g", "l"],
                          conditions=["theta' - 1.5", "2*theta' - 3"], **WHEEL)  # fmt: skip
    assert not cycle.success
    assert "g, l not determined" in cycle.message
    assert "g by +1, l by +0.05" in cycle.message
    assert cycle.parameters["g"] / cycle.parameters["l"] == pytest.approx(9.81 * (1.5 / 1.0644) ** 2, rel=0.2)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"free": ["gamma"]}, "free names gamma, and 0 conditions are stated"),
        ({"free": ["gama"], "conditions": ["theta"]}, r"unknown name in free 'gama'.*Did you mean 'gamma'"),
        ({"free": {"theta": 0.1}, "conditions": ["theta"]}, "unknown guess in free 'theta'.*x0 and v0"),
        ({"free": ["gamma"], "conditions": ["thet' - 1"]}, r"name in conditions \"thet'\".*Did you mean \"theta'\""),
        ({"free": ["gamma"], "conditions": ["theta'' - 1"]}, "conditions is .*Give an expression"),
        ({"free": ["gamma"], "conditions": "theta"}, "Give a list of expressions"),
        ({"free": ["gamma"], "conditions": ["m - 2"]}, "'m - 2' does not depend on gamma"),
        ({"free": ["t"], "conditions": ["t"]}, "equations do not depend on time"),
        ({"free": ["gamma"], "conditions": [1.0]}, "conditions is 1.0"),
    ],
)
def test_wrong_arguments(given, words):
    with pytest.raises(ModelError, match=words):
        em.find_cycle(system_of("rimless_wheel", "lagrange"), **WHEEL | given)


def test_the_damping_for_an_amplitude():
    """Van der Pol's oscillator of a given amplitude and SciPy's: mu for which it is 2.01, at x' = 0."""
    cycle = em.find_cycle(van_der_pol(), x0={"x": 2.0}, v0={"x": 0.0}, section="x'", free=["mu"],
                          conditions=["x - 2.01"])  # fmt: skip
    assert cycle.success
    mu = cycle.free["mu"]
    run = solve_ivp(lambda _, s: [s[1], mu * (1 - s[0] ** 2) * s[1] - s[0]], (0, cycle.period), [2.01, 0.0],
                    method="DOP853", rtol=1e-13, atol=1e-13)  # fmt: skip
    assert run.y[:, -1] == pytest.approx([2.01, 0.0], abs=1e-9)


def test_a_doubling_at_a_given_period():
    """Gravity keeps the period of the walker, and changes nothing else: it doubles at the slopes of a fixed gravity."""
    walker = system_of("compass_gait", "lagrange")
    gait = em.find_cycle(walker, section="heel strike", free=["g"], period=4.0)
    assert gait.free["g"] == pytest.approx((em.find_cycle(walker, section="heel strike").period / 4) ** 2, rel=1e-10)
    branch = em.follow(gait, "gamma", to=0.018)
    limping = em.follow(branch.special[0], to=0.018)
    for one, period, slope in ((branch, 4.0, 0.0149350875), (limping, 8.0, 0.017518265)):
        assert one.success
        assert [each.kind for each in one.special] == ["doubling"]
        assert one.special[0].parameter == pytest.approx(slope, abs=1e-9)
        assert one.period == pytest.approx(period, rel=1e-8)
        assert len(one.free["g"]) == len(one.parameter)


def test_from_one_event_that_does_not_act_to_the_next():
    """The time of the largest x is found, from starts at any time; at a fixed time it is the same cycle."""
    model = Model(name="topped", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2,
                  potential_energy=x**2 / 2 + x**4 / 4, forces=[A * cos(w * em.t) - c * x.diff()],
                  parameters={c: 0.2, w: 1.2, A: 0.3}, events={"top": Event(x.diff(), direction=-1)})  # fmt: skip
    fixed = em.find_cycle(duffing(), x0={"x": 0.3}, period="2*pi/w")
    for t in (0.0, 3.0):
        cycle = em.find_cycle(system_for(model, "lagrange"), x0={"x": 0.3}, period="2*pi/w", section="top", t=t)
        assert cycle.success
        there = fixed.solution.sol(cycle.t % fixed.period)
        assert [cycle.x0["x"], cycle.v0["x"]] == pytest.approx(there, abs=1e-8)
        assert cycle.x0["x"] == pytest.approx(
            fixed.solution.sol(np.linspace(0, fixed.period, 10001))[0].max(), rel=1e-6
        )


def test_conditions_that_no_motion_meets():
    """The wheel rolls forwards."""
    cycle = em.find_cycle(system_of("rimless_wheel", "lagrange"), free=["gamma"], conditions=["theta' + 1"], **WHEEL)
    assert not cycle.success
    assert "Conditions are not met: theta' + 1 = " in cycle.message


def test_one_segment_for_what_is_free():
    with pytest.raises(ModelError, match="these are for one segment"):
        em.find_cycle(van_der_pol(), x0={"x": 2.0}, free=["mu"], conditions=["x - 2.01"], section="x'", segments=4)
