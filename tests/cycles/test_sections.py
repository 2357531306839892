"""Sections that are expressions: the same cycles as without, their crossings, derivatives of the map between them."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from sympy import sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import ModelError

from ..support.generation import system_of
from .test_find_cycle import duffing, van_der_pol, walker

x = dynamicsymbols("x")


def crossing(start: np.ndarray, direction: int) -> np.ndarray:
    """Van der Pol's state where x + x' / 2 - 0.3 next crosses zero in a direction: by SciPy."""

    def side(t: float, s: np.ndarray) -> float:
        return s[0] + s[1] / 2 - 0.3 if t > 0.1 else 1.0 * direction

    side.terminal, side.direction = True, direction
    run = solve_ivp(lambda _, s: [s[1], (1 - s[0] ** 2) * s[1] - s[0]], (0, 20), start, method="DOP853", rtol=1e-13,
                    atol=1e-13, events=side)  # fmt: skip
    return run.y_events[0][0]


@pytest.mark.parametrize("section", ["x + x'/2 - 0.3", x + x.diff() / 2 - 0.3])
@pytest.mark.parametrize("direction", [1, -1])
def test_a_map_between_crossings(section, direction):
    cycle = em.find_cycle(van_der_pol(), x0={"x": 0.3}, v0={"x": 0.1}, section=section, direction=direction)
    assert cycle.success
    start = np.array([cycle.x0["x"], cycle.v0["x"]])
    assert start[0] + start[1] / 2 == pytest.approx(0.3, abs=1e-11)
    assert np.sign(start[1] + ((1 - start[0] ** 2) * start[1] - start[0]) / 2) == direction
    assert crossing(start, direction) == pytest.approx(start, abs=1e-10)
    assert cycle.period == pytest.approx(6.663286859323130, rel=1e-11)
    along = 1e-4 * np.array([1.0, -2.0])  # in the section, of which x is the coordinate
    slope = (crossing(start + along, direction) - crossing(start - along, direction))[0] / 2e-4
    assert cycle.multipliers[0].real == pytest.approx(slope, rel=1e-3)


def test_the_direction_is_that_of_the_first_crossing():
    for start, side in (({"x": 2.0}, -1), ({"x": -2.0}, 1)):
        cycle = em.find_cycle(van_der_pol(), x0=start, v0={"x": 0.0}, section="x - 0.5")
        assert cycle.success
        assert cycle.x0["x"] == pytest.approx(0.5, abs=1e-12)
        assert np.sign(cycle.v0["x"]) == side


def test_a_walker_where_its_legs_pass():
    gait = walker(0.2, -0.2)
    passing = em.find_cycle(gait.system, x0=gait.x0, v0=gait.v0, section="phi - theta/10 - 0.02", direction=-1)
    assert passing.success
    assert passing.period == pytest.approx(gait.period, rel=1e-10)
    assert passing.events == ("strike",)
    assert passing.x0["phi"] - passing.x0["theta"] / 10 == pytest.approx(0.02, abs=1e-11)
    assert passing.multipliers[:2] == pytest.approx(gait.multipliers[:2], abs=1e-8)


def test_a_section_of_time_and_state():
    """The time of the start is found, as an angle of the forcing: sin(w t) = x / 2."""
    fixed = em.find_cycle(duffing(), x0={"x": 0.3}, period="2*pi/w")
    for section in ("sin(w*t) - x/2", sin(symbols("w") * em.t) - x / 2):
        cycle = em.find_cycle(duffing(), x0={"x": 0.3}, period="2*pi/w", section=section, direction=1)
        assert cycle.success
        assert np.sin(1.2 * cycle.t) == pytest.approx(cycle.x0["x"] / 2, abs=1e-10)
        there = fixed.solution.sol((cycle.t - fixed.t) % fixed.period + fixed.t)
        assert [cycle.x0["x"], cycle.v0["x"]] == pytest.approx(there, abs=1e-8)
        assert np.sort_complex(cycle.multipliers) == pytest.approx(np.sort_complex(fixed.multipliers), rel=1e-7)


def test_a_section_with_a_parameter_is_followed():
    """x = a on the section, as mu changes; the period is SciPy's."""
    start = em.find_cycle(van_der_pol(), x0={"x": 2.0}, section="x - mu", direction=1)
    branch = em.follow(start, "mu", to=1.5)
    assert branch.success
    assert branch.x0["x"] == pytest.approx(branch.parameter, abs=1e-9)
    last = np.array([branch.x0["x"][-1], branch.v0["x"][-1]])
    run = solve_ivp(lambda _, s: [s[1], 1.5 * (1 - s[0] ** 2) * s[1] - s[0]], (0, branch.period[-1]), last,
                    method="DOP853", rtol=1e-12, atol=1e-12)  # fmt: skip
    assert run.y[:, -1] == pytest.approx(last, abs=1e-8)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"section": "x - 5"}, r"does not cross x - 5 = 0 within .*another section"),
        ({"section": "x + speed"}, r"unknown name in section 'speed'"),
        ({"section": "mu - 1"}, "does not depend on the state"),
        ({"section": "x - 1", "direction": 2}, "direction is 2. Give 1 or -1"),
        ({"section": "x", "direction": 1}, "section 'x' is a name"),
        ({"direction": 1}, "there is no section"),
        ({"section": 3.0}, "section is 3.0. Give an expression"),
    ],
)
def test_wrong_sections(given, words):
    with pytest.raises(ModelError, match=words):
        em.find_cycle(van_der_pol(), x0={"x": 1.0}, **given)


def test_an_event_in_an_expression():
    with pytest.raises(ModelError, match="contains the event 'step'"):
        em.find_cycle(system_of("rimless_wheel", "lagrange"), x0={"theta": -0.3}, section="step + theta")


def test_a_section_that_is_touched():
    """The largest x is a section that the cycle only touches; the motion that decays to it crosses."""
    top = em.find_cycle(van_der_pol(), x0={"x": 2.0}, section="x'").x0["x"]
    with pytest.raises(ModelError, match="does not cross"):
        em.find_cycle(van_der_pol(), x0={"x": 2.0}, section=f"x - {top!r}")
    cycle = em.find_cycle(van_der_pol(), x0={"x": 2.2}, section=f"x - {top!r}", period=6.66)
    assert not cycle.success
    assert "touches x - 2.00" in cycle.message
