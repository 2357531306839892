"""Limits of a user's model: cases that are generated from it, their references, and what the summary says of them."""

import json
from dataclasses import replace
from math import pi

import numpy as np
import pytest
from eigenmotion.models import double_pendulum, heavy_top, pendulum_with_stop, slider_crank
from eigenmotion.models import pendulum as pendulum_model
from sympy import sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Contact, Model, build
from eigenmotion.arguments.named_values import Vector
from eigenmotion.cli import main
from eigenmotion.comparison.deadline import NONE, Deadline
from eigenmotion.stability import Outcome, Variant, examine, limits_of, summary_of, write_limits
from eigenmotion.stability.cases.case import Trial
from eigenmotion.stability.evaluation.expected_rows import Expected
from eigenmotion.stability.evaluation.judgement import judged
from eigenmotion.stability.limits.families import FACTORS, families
from eigenmotion.stability.limits.findings import ranges, records
from eigenmotion.stability.limits.references import Independent, TightRuns, system_of
from eigenmotion.stability.limits.singular_search import searches
from eigenmotion.stability.limits.subject import Subject, subject
from eigenmotion.stability.limits.survey import in_order

LAGRANGE = ("lagrange",)


def damped(sign: int = 1) -> Model:
    """A mass on a spring and a damper; with the sign -1 the spring pushes."""
    x = dynamicsymbols("x")
    m, k, d = symbols("m k d", positive=True)
    return Model(
        name="damped", coordinates=[x], kinetic_energy=m * x.diff() ** 2 / 2, potential_energy=sign * k * x**2 / 2,
        forces={x: -d * x.diff()}, parameters={m: 1.0, k: 1.0, d: 1.0}, initial={x: 1.0},
    )  # fmt: skip


def of(model: Model, formulations: tuple[str, ...] = LAGRANGE, t_end: float = 3.0, **settings) -> Subject:
    return subject(model, formulations, settings, t_end, patience=20.0)


def case_of(own: Subject, name: str, methods: tuple[str, ...], found=()):
    case = next(case for case in families(own, found) if case.name == name)
    return replace(case, tolerances={method: case.tolerances[method] for method in methods})


def outcomes(case, value: float) -> dict[str, tuple[Outcome, str]]:
    return {cell.method: (cell.outcome, cell.reason) for cell in examine(case, value).cells}


# --- references and judgement -----------------------------------------------------------------------------------------


def test_a_stiff_damper_stops_explicit_methods_and_no_implicit_one():
    """m x'' = -k x - d x' with d = 1e6: a decay in 1e-6 s, in a run of 3 s."""
    found = outcomes(case_of(of(damped()), "parameter_d", ("dop853", "radau9")), 1e6)
    assert found == {"dop853": (Outcome.REFUSED, "too many steps"), "radau9": (Outcome.RIGHT, "")}


def test_a_stiff_spring_is_judged_over_its_fastest_periods():
    point = examine(case_of(of(damped()), "parameter_k", ("ra15",)), 1e6)
    assert point.span == pytest.approx(20 * 2 * pi / np.sqrt(1e6), rel=1e-3)
    assert point.independent
    assert point.cells[0].outcome is Outcome.RIGHT


@pytest.mark.parametrize("independent", [True, False])
def test_a_planted_fault_is_found(independent):
    """A spring that pushes: against independent equations it is wrong, and against other runs it differs."""
    own = of(damped())
    case = case_of(own if independent else replace(own, why="a reason"), "tolerances", ("dop853", "radau9"))
    point = examine(case, 1e-8, {Variant("lagrange", dependent_constraints="auto"): build(damped(sign=-1))})
    assert {cell.outcome for cell in point.cells} == {Outcome.WRONG if independent else Outcome.DIFFERS}


def test_runs_without_a_reference_agree_and_are_never_called_right():
    own = replace(of(pendulum_model.model), why="a reason")
    point = examine(case_of(own, "tolerances", ("dop853",)), 1e-8)
    assert [cell.outcome for cell in point.cells] == [Outcome.AGREES]
    assert not point.independent


def test_contacts_have_no_independent_reference_and_say_so():
    own = of(pendulum_with_stop.model, ("lagrange", "cholesky"), t_end=1.0)
    assert own.why == "contacts and friction"
    point = examine(case_of(own, "tolerances", ("dop853",)), 1e-6)
    assert "contacts and friction" in point.how
    assert {cell.outcome for cell in point.cells} == {Outcome.AGREES}


def test_a_coordinate_that_is_held_has_no_size_of_its_own():
    """A crank held by a prescribed motion moves by rounding only, which is no unit of tolerances."""
    q, s, path = dynamicsymbols("q s path")
    model = Model(
        name="driven_crank", coordinates=[q, s], kinetic_energy=(2 * q.diff() ** 2 + (1 + s**2) * s.diff() ** 2) / 2,
        potential_energy=9.81 * s * sin(q) + 100 * (s - 0.5) ** 2, holonomic_constraints={"drive": q - path},
        inputs={path: 0.0}, initial={s: 0.6},
    )  # fmt: skip
    own = of(model, ("lagrange", "cholesky"), t_end=1.0)
    assert own.why == "prescribed motions"
    assert own.units[0] == 1.0
    point = examine(case_of(own, "tolerances", ("dop853", "radau9")), 1e-8)
    assert {cell.outcome for cell in point.cells} == {Outcome.AGREES}


def test_a_reference_that_takes_too_long_is_replaced_and_named():
    own = replace(of(pendulum_model.model, ("lagrange", "cholesky")), patience=0.0)
    point = examine(case_of(own, "tolerances", ("dop853",)), 1e-8)
    assert "takes too long" in point.how
    assert {cell.outcome for cell in point.cells} == {Outcome.AGREES}


def expected(kappa: float, own: float, independent: bool) -> Expected:
    one = np.ones(1)
    reference = Independent(lambda t, y: y, one)
    tight = TightRuns(pendulum_model.model, LAGRANGE, {}, {}, one, "a reason")
    truth = reference if independent else tight
    trial = Trial("", {}, one, one, one, 0.0, one, truth, may_lose_digits=True)
    return Expected(trial, "", np.ones((1, 2)), np.ones(2), own, kappa)


@pytest.mark.parametrize(
    ("kappa", "own", "independent", "error", "indicator", "outcome"),
    [
        (1.0, 0.0, True, 1e-7, 0.0, Outcome.RIGHT),
        (1.0, 0.0, True, 1e-5, 0.0, Outcome.DEGRADED),
        (1.0, 0.0, True, 1e-3, 0.0, Outcome.WRONG),
        (1e9, 0.0, True, 1.0, 0.0, Outcome.NO_DIGITS),
        (1e9, 0.0, True, 1.0, 1.0, Outcome.WRONG),
        (1.0, 0.5, True, 1.0, 0.0, Outcome.NO_DIGITS),
        (1.0, 0.0, False, 1e-7, 0.0, Outcome.AGREES),
        (1.0, 0.0, False, 1e-7, 1e-5, Outcome.DEGRADED),
        (1.0, 0.0, False, 1e-3, 0.0, Outcome.DIFFERS),
        (1.0, 0.0, False, 1e-7, 1.0, Outcome.WRONG),
        (1.0, 0.0, False, float("nan"), 0.0, Outcome.WRONG),
        (1.0, 0.5, False, 1e-7, 0.0, Outcome.DIFFERS),
        (0.0, float("nan"), False, float("nan"), 0.0, Outcome.NO_DIGITS),
    ],
)
def test_every_outcome(kappa, own, independent, error, indicator, outcome):
    assert judged(expected(kappa, own, independent), 1e-8, error, indicator).outcome is outcome


@pytest.mark.parametrize("independent", [True, False])
def test_chaos_is_no_fault_of_a_run(independent):
    """Two pendulums that start almost upright: perturbations of 1e-6 grow to the size of the motion in 16 s.

    Their growth is then no measure of that of smaller ones: errors that these explain were called degraded.
    """
    model = replace(double_pendulum.model, initial={double_pendulum.theta1: 3.0, double_pendulum.theta2: 3.0})
    own = replace(of(model, ("lagrange", "inverse"), t_end=60.0), why="" if independent else "a reason")
    point = examine(case_of(own, "spans", ("dopri5", "dop853", "radau9")), 10.0)
    assert {cell.outcome for cell in point.cells} == {Outcome.NO_DIGITS}
    assert max(cell.error for cell in point.cells) > 0.1
    assert examine(case_of(own, "spans", ("dop853",)), 1.0).cells[0].outcome in (Outcome.RIGHT, Outcome.AGREES)


def test_chaos_with_contacts_is_no_fault_of_a_run():
    """Two pendulums above a floor: no start is near for contacts, and a rougher run tells how errors grow."""
    tip = double_pendulum.position2[1]
    model = replace(
        double_pendulum.model, contacts={"floor": Contact(tip + 5)},
        initial={double_pendulum.theta1: 3.0, double_pendulum.theta2: 3.0},
    )  # fmt: skip
    own = of(model, ("lagrange", "inverse"), t_end=60.0)
    assert own.why == "contacts and friction"
    case = case_of(own, "spans", ("dopri5", "dop853"))
    assert {cell.outcome for cell in examine(case, 1.0).cells} == {Outcome.AGREES}
    assert {cell.outcome for cell in examine(case, 10.0).cells} == {Outcome.NO_DIGITS}
    heavier = system_of(replace(model, parameters=dict(model.parameters) | {double_pendulum.m2: 1.01}), "lagrange")
    faulty = examine(case, 1.0, {Variant("lagrange", dependent_constraints="auto"): heavier})
    assert {cell.outcome for cell in faulty.cells if cell.variant == "lagrange"} == {Outcome.DIFFERS}


# --- singular positions -----------------------------------------------------------------------------------------------


def test_euler_angles_of_a_top_are_singular_upright():
    own = of(heavy_top.model, t_end=1.0)
    (mass,) = searches(own, Deadline().sooner(30.0))
    assert mass.found is not None
    theta = own.system.coordinates.index("theta")
    assert np.sin(mass.found.x[theta]) == pytest.approx(0.0, abs=1e-5)
    found = outcomes(case_of(own, "singular_mass_matrix", ("dop853",), [mass.found]), 1e-2)
    assert found["dop853"][0] in (Outcome.RIGHT, Outcome.REFUSED, Outcome.NO_DIGITS)


def test_a_rod_as_short_as_the_crank_has_a_dead_centre():
    """phi = theta = 90 degrees, where the rod lies on the crank and the rows of the loop depend on each other."""
    values = {"theta": 1.0, "phi": 1.0, "x": 0.6 * np.cos(1.0)}
    rates = {"theta": 1.0, "phi": 1.0, "x": -0.6 * np.sin(1.0)}
    own = of(slider_crank.model, t_end=0.3, parameters={"r": 0.3, "l": 0.3}, x0=values, v0=rates)
    found = searches(own, Deadline().sooner(60.0))[1].found
    assert found is not None
    assert np.cos(found.x[0]) == pytest.approx(0.0, abs=1e-4)
    x, v = near_on_the_constraints(own, found.near(1e-3, own.units))
    assert np.abs(np.array(own.system.pfaffian(x, 0.0, own.parameters)[0]) @ v).max() < 1e-9


def near_on_the_constraints(own: Subject, x: Vector) -> tuple[Vector, Vector]:
    return own.consistent(x, own.v0, own.parameters)


def test_a_pendulum_has_no_singular_position():
    (mass,) = searches(of(pendulum_model.model), Deadline().sooner(20.0))
    assert mass.found is None
    assert "no singular position found" in mass.words


# --- budget, summary and files ----------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def short() -> object:
    """A budget that allows the first points only."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("eigenmotion.stability.limits.survey.FORMULATIONS", LAGRANGE)
        return limits_of(damped(), t_end=1.0, budget=6.0, workers=1)


def test_what_was_not_run_is_said(short, tmp_path):
    points = {(case, label) for case, labels in short.left_out for label in labels}
    every = in_order(families(short.own, ()))
    assert len(short.matrix.points) + len(points) == len(every)
    lines = "\n".join(summary_of(short))
    assert ("raise --budget" in lines) == bool(points)
    assert short.matrix.count(Outcome.WRONG) == 0
    page, *others = write_limits(short, tmp_path)
    assert "damped" in page.read_text(encoding="utf-8")
    numbers = json.loads((tmp_path / "stability.json").read_text(encoding="utf-8"))
    assert numbers["model"] == "damped"
    assert numbers["summary"] == list(summary_of(short))
    assert (tmp_path / "stability.png") in others


@pytest.mark.parametrize("workers", [1, 2])
def test_one_point_is_examined_however_short_the_budget_is(workers):
    found = limits_of(damped(), t_end=1.0, budget=1e-3, workers=workers)
    assert len(found.matrix.points) == 1
    assert found.matrix.cells


def test_nothing_is_recommended_that_was_never_right():
    """The root of 2 - p - x ends every motion where the mass arrives at 2 - p."""
    x, p = dynamicsymbols("x"), symbols("p", real=True)
    ends = Model(
        name="ends", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=3 * sqrt(2 - p - x),
        parameters={p: 1.0}, initial={x: 0.5},
    )  # fmt: skip
    lines = summary_of(limits_of(ends, t_end=2.0, budget=2.0))
    assert any(line.startswith("no formulation with any method is known to be right in any of") for line in lines)
    assert not any(line.startswith("use ") for line in lines)


def test_first_values_of_all_cases_run_first():
    cases = families(of(damped()), ())
    first = in_order(cases)[: len(cases)]
    assert [name for name, _ in first] == [case.name for case in cases]
    assert {value for name, value in first if name.startswith("parameter")} == {FACTORS[0]}


def test_ranges_end_before_the_first_refusal(short):
    own = replace(short.own, patience=20.0, deadline=NONE)
    case = replace(case_of(own, "parameter_d", ("dop853", "radau9")), values=(1e-2, 1e2, 1e4, 1e6))
    points = tuple(examine(case, value) for value in case.values)
    matrix = replace(short.matrix, points=points, own=(case,))
    (explicit,) = ranges(matrix, (own.formulations[0], "dop853"))
    assert (explicit.least, explicit.below) == (1e-2, "")
    assert explicit.most < 1e6
    assert "too many steps" in explicit.above
    assert records(matrix)[0].combination[1] == "radau9"
    found = replace(short, matrix=matrix)
    assert any("with radau9: right in all 4 points" in line for line in summary_of(found))


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--set", "a=1"], "--set and -D are for a MODEL: name one"),
        (["absent.py"], "no such file"),
        (["absent.py", "--case", "gap"], "--case gap is a built-in case"),
        (["absent.py", "--budget", "0"], "not above 0"),
    ],
)
def test_mistakes_are_named(words, said, tmp_path, capsys):
    assert main(["stability", *words, "-o", str(tmp_path)]) != 0
    assert said in capsys.readouterr().err
