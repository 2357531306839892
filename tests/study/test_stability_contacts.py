"""The contact cases of the stability matrix: what is right in them, and that a missed condition is seen."""

from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp
from sympy import cos, sin, symbols, sympify

from eigenmotion import Solution
from eigenmotion.stability import Outcome, Variant, described, examine
from eigenmotion.stability.cases import bearings, cones, contacts
from eigenmotion.stability.cases.case import EXPLICIT, TOLERANCES, Case
from eigenmotion.stability.cases.variants import CONTACTS, UNSTABILISED
from eigenmotion.stability.evaluation.contact_conditions import largest_violation
from eigenmotion.stability.evaluation.contact_outputs import with_contact_outputs
from eigenmotion.stability.expectation.piecewise_motion import DrivenFrictionMass, RockingBlock
from eigenmotion.stability.models.contacts import painleves_rod

from ..oracles.bearings import Bearings, Rubs
from ..support.generation import system_for

BY_DAY = ("brakes", "housner", "jams")


def check(case: Case, values: tuple[float, ...]) -> None:
    """All runs are right, but where there is no motion: those are refused by name."""
    for value in values:
        point = examine(case, value)
        bad = [f"{described(c)} {c.message}" for c in point.cells if c.outcome is not wanted(point.reference_error)]
        assert not bad, "\n".join(bad)


def wanted(reference_error: float) -> Outcome:
    return Outcome.RIGHT if np.isfinite(reference_error) else Outcome.REFUSED


@pytest.mark.usefixtures("hurried")
@pytest.mark.parametrize("case", [case for case in contacts.CASES if case.name in BY_DAY], ids=lambda case: case.name)
def test_contacts_are_right_in_some_cases(case):
    check(replace(case, variants=(Variant("lagrange"),), tolerances=EXPLICIT), case.reduced)


@pytest.mark.usefixtures("hurried")
@pytest.mark.parametrize(("value", "method"), [(0.1, "rk34"), (0.2, "dopri5"), (0.4, "radau9")])
def test_a_block_lands_whose_other_corner_has_drifted(value, method):
    """Without stabilisation: the friction of the corner that opens stopped what slips, and moved the other one."""
    case = next(case for case in contacts.CASES if case.name == "housner")
    check(replace(case, variants=(UNSTABILISED,), tolerances={method: TOLERANCES[method]}), (value,))


@pytest.mark.nightly
@pytest.mark.usefixtures("hurried")
@pytest.mark.parametrize("case", [*contacts.CASES, *cones.CASES, *bearings.CASES], ids=lambda case: case.name)
def test_contacts_are_right_in_all_cases(case):
    check(replace(case, variants=CONTACTS), case.values)


@pytest.mark.parametrize("alpha", [0.1, 0.4])
def test_a_block_comes_down_when_its_energy_says(alpha):
    """t = integral of da / a', a'^2 = 3/2 g (height lost) / (b^2 + h^2); Housner's acosh for slender ones."""
    block, p = RockingBlock(np.tan(alpha), 1.0, 9.81), 0.4 * alpha
    height = lambda a: block.b * np.sin(a) + block.h * np.cos(a)  # noqa: E731
    rate = lambda a: np.sqrt(1.5 * block.g * (height(p) - height(a)) / (block.b**2 + block.h**2))  # noqa: E731
    falls = quad(lambda s: 2 * s / rate(p - s**2), 0.0, np.sqrt(p), epsabs=1e-12)[0]
    assert block.until_the_first(p) == pytest.approx(falls, rel=1e-9)
    slender = np.arccosh(1 / (1 - 0.4)) / np.sqrt(0.75 * block.g / np.hypot(block.b, block.h))
    assert falls == pytest.approx(slender, rel=alpha**2)


@pytest.mark.parametrize(("e", "limit"), [(None, 1.2), (0.5, 3.0)])
def test_slides_between_events_are_those_of_newtons_law(e, limit):
    """Where neither is at rest nor struck, the rate of v is the force over m; and v is that of x."""
    mass, times = DrivenFrictionMass(2.0, 10.0, 1.0, limit, e, 1e-3), np.linspace(0.0, 5.0, 40001)
    x, v = mass(np.zeros(2), times).T
    assert np.abs(np.gradient(x, times) - v)[np.abs(np.gradient(v, times)) < 20].max() < 1e-3
    a, slides = np.gradient(v, times), np.abs(v) > 1e-2
    smooth = slides & (np.abs(a) < 20) & np.append(slides[1:], False) & np.append(False, slides[:-1])
    off = 2.0 * a - 10.0 * np.sin(times) + limit * np.sign(v)
    assert np.quantile(np.abs(off[smooth]), 0.999) < 1e-3
    if e is not None:
        assert x.max() <= 1.0 + 1e-12


def test_a_ball_rolls_at_the_end_and_a_top_keeps_jelletts_constant():
    """L . (a e_3 - R e_z), which no force at the point of contact changes."""
    trial = cones.rolls(0.2)
    x, y, _, alpha, beta = trial.truth.rows(np.append(trial.x0, trial.v0), np.array([0.0, 1.0]), 0)[-1, 5:]
    assert (x, y) == pytest.approx((cones.BALL * beta, -cones.BALL * alpha))
    top = cones.turns_over(0.08)
    found = top.truth.rows(np.append(top.x0, top.v0), np.append(0.0, top.times), 0)
    constants = [jellett(*row[3:5], *row[9:12]) for row in found]
    assert np.ptp(constants) < 1e-12 * abs(constants[0])
    assert found[:, 4].min() < 0.2
    assert found[-1, 4] > 1.4


def jellett(psi: float, theta: float, turn: float, nod: float, spin: float) -> float:
    s, c = np.sin(theta), np.cos(theta)
    e1, e3 = np.array([np.cos(psi), np.sin(psi), 0]), np.array([s * np.sin(psi), -s * np.cos(psi), c])
    L = cones.INERTIA * (nod * e1 + turn * s * np.cross(e3, e1) + (spin + turn * c) * e3)
    return float(L @ (cones.OFF * e3 - [0, 0, cones.TOP]))


@cache
def slid() -> tuple[Any, Solution, dict[str, float]]:
    trial, system = contacts.slides(0.5), system_for(with_contact_outputs(painleves_rod()), "lagrange")
    run = system.simulate((0.0, 0.03), x0=trial.x0, v0=trial.v0, parameters=trial.parameters, rtol=1e-8, atol=1e-8)
    assert run.success
    return system, run, dict(trial.parameters)


def test_conditions_hold_in_a_run_that_is_right():
    system, run, parameters = slid()
    assert largest_violation(run, system, with_contact_outputs(painleves_rod()), parameters) < 1e-7


@pytest.mark.parametrize("what", ["multipliers", "tip_gap", "tip_opens", "rub_slip"])
def test_a_missed_condition_is_seen(what):
    """Turned round, or moved: a force that pulls, a gap that is inside or accelerates, a slip the wrong way."""
    system, run, parameters = slid()
    wrong = Solution(run._source, dict(run))
    if what == "multipliers":
        wrong["multipliers"] = -run.multipliers
    else:
        moved = -run.outputs[what] if what == "rub_slip" else run.outputs[what] - 0.1
        wrong["outputs"] = run.outputs | {what: moved}
    assert largest_violation(wrong, system, with_contact_outputs(painleves_rod()), parameters) > 0.01


@cache
def rolled() -> tuple[Any, Solution, dict[str, float]]:
    trial, system = cones.rolls(0.2), system_for(with_contact_outputs(cones.billiard_ball()), "lagrange")
    run = system.simulate((0.0, 1.0), x0=trial.x0, v0=trial.v0, parameters=trial.parameters, rtol=1e-8, atol=1e-8)
    assert run.success
    assert len(run.modes) == 2
    return system, run, dict(trial.parameters)


def test_conditions_hold_of_a_cone_that_slides_and_sticks():
    system, run, parameters = rolled()
    assert largest_violation(run, system, with_contact_outputs(cones.billiard_ball()), parameters) < 1e-7


@pytest.mark.parametrize("what", ["rub_slip", "rub_aside", 1, 2])
def test_a_missed_condition_of_a_cone_is_seen(what):
    """What sticks slips, either way; or is held by more than its limit, either way."""
    system, run, parameters = rolled()
    wrong = Solution(run._source, dict(run))
    if isinstance(what, str):
        wrong["outputs"] = run.outputs | {what: run.outputs[what] + 0.1}
    else:
        wrong["multipliers"] = run.multipliers + np.where(np.arange(3) == what, 0.17 * 9.81 * 0.3, 0.0)[:, None]
    assert largest_violation(wrong, system, with_contact_outputs(cones.billiard_ball()), parameters) > 0.01


def test_conditions_know_norms_of_reactions():
    """Frictions that are pressed by two rows, behind rows of other constraints."""
    trial, model = bearings.turns(0.2), with_contact_outputs(bearings.driven_slider())
    system = system_for(model, "lagrange")
    given = {"x0": trial.x0, "v0": trial.v0, "parameters": trial.parameters, "rtol": 1e-8, "atol": 1e-8}
    run = system.simulate((0.0, 0.5), **given)
    assert largest_violation(run, system, model, dict(trial.parameters)) < 1e-7
    wrong = Solution(run._source, dict(run))
    wrong["outputs"] = run.outputs | {"rub_pin_slip": -run.outputs["rub_pin_slip"]}
    assert largest_violation(wrong, system, model, dict(trial.parameters)) > 0.01


@pytest.mark.parametrize("friction", [0.05, 0.5])
def test_a_slider_turns_as_newtons_law_of_its_bodies_says(friction):
    """Against all bodies' coordinates on their constraints, forces by SciPy's fsolve, signs of slip by events."""
    trial = bearings.turns(friction)
    x, v = symbols("phi X Y psi s w"), symbols("v0:6")
    phi, X, Y, psi, s, w = x
    z = {name: sympify(value) for name, value in bearings.SIZES.items()}
    along, across = z["l"] / 2 * cos(psi), z["l"] / 2 * sin(psi)
    rows = [X - along - z["a"] * cos(phi), Y - across - z["a"] * sin(phi), X + along - s, Y + across - w, w]
    masses = [float(z[name]) for name in ("I", "m_2", "m_2", "I_2", "m_3", "m_3")]
    forces = [z["drive"] - z["drag"] * v[0], 0, -9.81 * z["m_2"], 0, 0, -9.81 * z["m_3"]]
    radii = bearings.RADII["r_pin"], bearings.RADII["r_end"]
    rubs = [
        Rubs(friction, v[4], (4,)), Rubs(friction * radii[0], v[3] - v[0], (0, 1)),
        Rubs(friction * radii[1], v[3], (2, 3)),
    ]  # fmt: skip
    times = np.linspace(0.0, 0.6, 4)
    oracle = Bearings(x, v, masses, [sympify(force) for force in forces], rows, rubs)
    found = oracle.motion(np.append(trial.x0, trial.v0), times)[:12]
    ours = trial.truth.rows(np.append(trial.x0, trial.v0), times, 0).T
    assert ours == pytest.approx(found, abs=2e-8)


def test_the_rod_slides_as_newtons_law_says():
    """Contact and friction forces by a linear system at each state, integrated by SciPy."""
    mu, g = 0.5, 9.81
    trial = contacts.slides(mu)

    def rates(_: float, z: np.ndarray) -> np.ndarray:
        s, c, w = np.sin(z[2]), np.cos(z[2]), z[5]
        rows = np.array([[1, 0, 0, mu], [0, 1, 0, -1], [0, 0, 1 / 3, mu * c - s], [0, 1, s, 0]])
        a = np.linalg.solve(rows, [0, -g, 0, -c * w**2])
        return np.append(z[3:], a[:3])

    start = np.append(trial.x0, trial.v0)
    end = solve_ivp(rates, (0.0, 0.03), start, "DOP853", rtol=1e-12, atol=1e-12).y[:, -1]
    assert trial.truth.rows(start, np.array([0.0, 0.03]), 0)[-1] == pytest.approx(end, abs=1e-10)
