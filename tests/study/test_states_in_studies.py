"""First-order states in `eigenmotion report` and `eigenmotion stability MODEL`, against equations by hand."""

import json
from dataclasses import replace

import numpy as np
import pytest
import sympy
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Model, multiplier
from eigenmotion.reference.extended_precision import extended
from eigenmotion.reference.lagrange_equations import classical, double, explicit
from eigenmotion.reference.motion import reference
from eigenmotion.report import Budget, Findings, ReportOptions, examine
from eigenmotion.report.output import recommendation, write_report
from eigenmotion.stability import Outcome, Variant
from eigenmotion.stability import examine as examine_point
from eigenmotion.stability.limits.families import families
from eigenmotion.stability.limits.subject import subject

from ..states.mechanisms import i, integrated, servo, servo_rate
from .measuring import undisturbed

SPAN = 2.0


def hilly_belt() -> Model:
    """A mass on a hill, with friction that has a memory and is limited by the reaction of the hill."""
    x, y, z = dynamicsymbols("x y z")
    slip = sympy.Rational(1, 5) - x.diff()
    return Model(
        name="hilly", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
        potential_energy=9.81 * y + 10 * x**2, holonomic_constraints={"belt": y - sympy.sin(2 * x) / 10},
        forces={x: 30 * z}, states={z: slip - 100 * sympy.Abs(slip) * z / sympy.Abs(multiplier("belt"))},
    )  # fmt: skip


def hilly_rate(x: float, v: float, z: float) -> tuple[float, float, float]:
    """By hand: the mass as a function of x alone, y = sin(2 x) / 10; the reaction is that of the row y - y(x) = 0."""
    slope, bend = np.cos(2 * x) / 5, -2 * np.sin(2 * x) / 5
    pull = 30 * z - 20 * x - 9.81 * slope
    a = (pull - slope * bend * v**2) / (1 + slope**2)
    reaction = -(slope * a + bend * v**2) - 9.81
    slip = 0.2 - v
    return v, a, slip - 100 * abs(slip) * z / abs(reaction)


@pytest.mark.parametrize("state", [(0.3, 0.5, 0.02), (-0.7, 0.1, -0.05)])
def test_rates_of_states_know_reactions(state):
    x, v, z = state
    equations, y = classical(hilly_belt()), np.array([x, np.sin(2 * x) / 10, v, np.cos(2 * x) / 5 * v, z])
    _, a, rate = hilly_rate(*state)
    written = explicit(equations, {"sin": np.sin, "cos": np.cos, "Abs": abs}, y, 0.0)
    for found in (extended(equations)(0.0, y.astype(np.longdouble)), double(equations)(0.0, y), np.array(written)):
        np.testing.assert_allclose(found[[0, 2, 4]].astype(float), [v, a, rate], rtol=1e-13)


def test_the_reference_of_a_servo_is_its_motion_by_hand():
    made = reference(classical(servo()), np.array([0.5, 0.0, 0.1, 0.0]), SPAN)
    exact = integrated(servo_rate, (0.5, 0.0, 0.1, 0.0), made.t)
    np.testing.assert_allclose(made.x.T, exact[[0, 2, 3]], rtol=0, atol=1e-10)  # SciPy's rows are interpolated
    np.testing.assert_allclose(made.v.T, exact[[1]], rtol=0, atol=1e-10)


@pytest.fixture(scope="module")
def found() -> Findings:
    """A report of the servo, reduced."""
    with undisturbed() as patch:
        patch.setattr("eigenmotion.report.peers.DECADES", (1e-6, 1e-8))
        patch.setattr("eigenmotion.report.peers._TAYLOR_TOLERANCES", (1e-8,))
        patch.setattr("eigenmotion.report.solvers.IMPLICIT_TOLERANCES", (1e-6, 1e-8, 1e-10))
        for name in ("SLOW", "_TURN"):
            patch.setattr(f"eigenmotion.report.measure.{name}", 0.0)
        ask = ReportOptions(error=1e-6, t_end=SPAN, tolerances=(1e-6, 1e-8, 1e-10), budget=Budget(np.inf, rounds=3))
        return examine(servo(), ask, lambda *_: None)


def test_a_report_compares_states(found, tmp_path):
    """The error is that of the worst of the angle, the current and the integral."""
    run = em.simulate(em.build(servo(), formulation="lagrange"), (0, SPAN), rtol=1e-6, atol=1e-6)
    exact = integrated(servo_rate, (0.5, 0.0, 0.1, 0.0), (0.0, SPAN))[:, -1]
    ends = np.array([run.x[0, -1], *(run.states[name][-1] for name in ("i", "e"))])
    error = np.max(np.abs(ends - exact[[0, 2, 3]]) / (1 + np.abs(exact[[0, 2, 3]])))
    (m,) = [m for m in found.measurements if m.label == "lagrange dop853" and m.tolerance == 1e-6]
    assert m.error_end == pytest.approx(error, rel=1e-3)
    assert {m.family for m in found.measurements} >= {"eigenmotion", "SciPy"}
    for measurement in found.measurements:
        assert measurement.message == ""
        assert measurement.error_max < 1e-2
    assert recommendation(found)[0].startswith("formulation ")
    page, *_ = write_report([found], tmp_path)
    assert "First-order states: i, e." in page.read_text(encoding="utf-8")
    numbers = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))["models"][0]
    assert numbers["states_start"] == {"i": 0.1, "e": 0.0}
    assert numbers["reference"]["states_end"]["i"] == pytest.approx(exact[2], abs=1e-10)


# --- stability of models with states ----------------------------------------------------------------------------------


def case_of(model: Model, methods: tuple[str, ...], name: str = "tolerances"):
    own = subject(model, ("lagrange",), {}, 1.0, patience=20.0)
    case = next(case for case in families(own, ()) if case.name == name)
    return replace(case, tolerances={method: case.tolerances[method] for method in methods})


@pytest.mark.parametrize("model", [servo(), hilly_belt()], ids=lambda model: model.name)
def test_runs_with_states_are_right_by_an_independent_reference(model):
    point = examine_point(case_of(model, ("dop853", "radau9")), 1e-8)
    assert point.independent
    assert point.reference_error < 1e-8  # |slip| has a kink
    assert {cell.outcome for cell in point.cells} == {Outcome.RIGHT}


def test_a_fault_in_a_state_is_found():
    """A current with a resistance too many."""
    rates = dict(servo().states)
    faulty = em.build(servo(states=rates | {i: rates[i] - i}))
    point = examine_point(
        case_of(servo(), ("dop853",)), 1e-8, {Variant("lagrange", dependent_constraints="auto"): faulty}
    )
    assert {cell.outcome for cell in point.cells} == {Outcome.WRONG}


def test_a_start_of_states_is_that_of_the_runs():
    """A current of 2 A, given as an initial value."""
    own = subject(servo(), ("lagrange",), {"x0": {"i": 2.0}}, 1.0, patience=20.0)
    trial = own.trial("")
    np.testing.assert_array_equal(trial.row, [0.5, 0.0, 2.0, 0.0])
    end = trial.truth.rows(trial.row, np.array([0.0, 0.5, 1.0]), 0)[-1]
    np.testing.assert_allclose(end, integrated(servo_rate, (0.5, 0.0, 2.0, 0.0), (0.0, 1.0))[:, -1], atol=1e-10)
