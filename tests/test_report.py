"""`eigenmotion report`: what it measures, against certified motions and by hand; what it writes and advises."""

import csv
import importlib.util
import io
import json
import re
import time
from contextlib import redirect_stdout
from dataclasses import replace
from types import SimpleNamespace
from xml.etree import ElementTree

import mpmath
import numpy as np
import pytest
import sympy
from eigenmotion.codegen.choices import FORMULATIONS
from eigenmotion.codegen.model import ModelError
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.cli import main
from eigenmotion.cli import report as cli
from eigenmotion.reference.classical import classical, double, explicit
from eigenmotion.reference.collocation import Collocation
from eigenmotion.reference.elimination import accelerations
from eigenmotion.reference.extended import extended
from eigenmotion.reference.integration import Midpoint, NotReachedError, followed
from eigenmotion.reference.motion import Reference, rates_of, reference, scaled_error
from eigenmotion.report import Ask, Budget, Findings, Measurement, examine, peers, recommendation, write_report
from eigenmotion.report.measure import Judge, measure, skipped
from eigenmotion.report.peers import Peers
from eigenmotion.report.recommend import Curve, curves, recommend
from eigenmotion.report.solvers import IMPLICIT, METHODS, Attempt, Problem, Solver, Track, implicit_solvers
from eigenmotion.stability.models import elastic_link
from eigenmotion.stability.truth import Collocated

from .generation import model_of, system_of
from .models_table import BY_NAME, MODELS, SCENARIOS
from .oracles import elliptic
from .oracles.published import DUAL_LINK_X

EXACT = np.array(DUAL_LINK_X, dtype=np.longdouble).astype(float)
TOLERANCES = tuple(10.0**-k for k in range(4, 13))
QUICK, GRAINY = Budget(rounds=3), Budget(grain=0.02, rounds=1)
HAS_SUNDIALS = importlib.util.find_spec("sksundae") is not None
STIFF = {"parameters": {"k": 1e10, "d": 1e6}, "x0": {"q": 0.01}}  # of elastic_link


def undisturbed(patch: pytest.MonkeyPatch) -> None:
    """Let the report measure the time that this process computes, which does not grow where others use the machine."""
    for module in ("measure", "peers"):
        patch.setattr(f"eigenmotion.report.{module}.time", SimpleNamespace(perf_counter=time.process_time))


@pytest.fixture(scope="module")
def progress() -> list[tuple[float, str]]:
    return []


@pytest.fixture(scope="module")
def found(progress) -> Findings:
    """A reduced matrix on the paper's mechanism, over its 10 s."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("EIGENMOTION_CFLAGS", "-O1")  # quick to compile; times are compared with SciPy's only
        undisturbed(patch)
        patch.setattr("eigenmotion.report.peers.DECADES", (1e-4, 1e-6, 1e-8, 1e-10))
        patch.setattr("eigenmotion.report.peers._TAYLOR_TOLERANCES", (1e-8,))
        patch.setattr("eigenmotion.report.solvers.IMPLICIT_TOLERANCES", tuple(10.0**-k for k in range(4, 9)))
        ask = Ask(error=1e-8, t_end=10.0, tolerances=TOLERANCES, budget=QUICK)
        return examine(model_of("dual_link"), ask, lambda done, what: progress.append((done, what)))


# --- what errors are measured against


def test_the_reference_is_the_certified_motion(found):
    np.testing.assert_allclose(found.reference.x[-1], EXACT, rtol=0, atol=1e-15)
    assert found.reference.errors.max() < 1e-14


def test_the_reference_follows_an_ellipse_function():
    model = model_of("pendulum")
    start = np.array([*model.initial_x, *model.initial_v])
    made = reference(classical(model), start, 10.0)
    exact = np.array([elliptic.pendulum(model, t).x for t in made.t[1::40]], dtype=float)
    assert np.abs(made.x[1::40] - exact).max() < 1e-13


def test_the_references_estimate_bounds_its_error():
    """A pendulum let go almost upright magnifies rounding by 1e9: the estimate grows along, and stays above."""
    pendulum = model_of("pendulum")
    (angle,) = pendulum.coordinates
    upright = replace(pendulum, initial={angle: sympy.Float(3.14159265)})
    made = reference(classical(upright), np.array([*upright.initial_x, 0.0]), 8.0)
    with mpmath.workdps(40):
        k, w = mpmath.sin(mpmath.mpf(upright.initial_x[0]) / 2), mpmath.sqrt(mpmath.mpf(9.81))
        exact = [float(2 * mpmath.asin(k * mpmath.ellipfun("cd", w * float(t), k=k))) for t in made.t[::10]]
    errors = scaled_error(made.x[::10], np.array(exact)[:, None])
    assert errors.max() > 1e-12
    assert (errors <= made.errors[::10] + 1e-15).all()
    assert made.errors.max() < 1e4 * errors.max()


def test_no_reference_across_a_singularity():
    model = model_of("polar_particle")
    fall = replace(model, initial={model.coordinates[0]: 1, model.coordinates[1]: 0})
    with pytest.raises(ModelError, match="no reference"):
        reference(classical(fall), np.array([*fall.initial_x, *fall.initial_v]), 50.0)


def test_extrapolation_has_its_order():
    """Steps of fixed length: the error falls with the power 2 columns."""

    def rhs(time: float, y: np.ndarray) -> np.ndarray:
        return np.array([y[1], -y[0]])

    errors = [
        float(abs(followed(Midpoint(3), rhs, np.array([1.0, 0.0]), np.linspace(0, 8, n + 1), 1.0)[-1, 0] - np.cos(8.0)))
        for n in (16, 32)
    ]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(6, abs=0.7)


def test_extrapolation_stops_where_steps_vanish():
    with np.errstate(all="ignore"), pytest.raises(NotReachedError):
        followed(Midpoint(8), lambda time, y: y**2, np.array([1.0]), np.array([0.0, 2.0]), 1e-15)


def test_collocation_has_its_order():
    """Steps of fixed length: order 2 stages - 1, and that of the estimate one above the stages."""

    def rhs(time: float, y: np.ndarray) -> np.ndarray:
        return np.array([y[1], -y[0]])

    ends, estimates = [], []
    for n in (16, 32):
        y = np.array([1.0, 0.0], dtype=np.longdouble)
        for k in range(n):
            y, estimate = Collocation(3).step(rhs, np.longdouble(8 * k / n), y, np.longdouble(8) / n)
        ends.append(float(abs(y[0] - np.cos(np.longdouble(8)))))
        estimates.append(estimate)
    assert np.log2(ends[0] / ends[1]) == pytest.approx(5, abs=0.5)
    assert np.log2(estimates[0] / estimates[1]) == pytest.approx(4, abs=0.5)


def test_collocation_crosses_a_strongly_damped_start():
    """y'' + 1e6 y' + 1e10 y = 0, whose parts die out at the rates 1e4 and 1e6."""
    times = np.linspace(0.0, 1e-3, 11)
    rows = followed(Collocation(7), lambda time, y: np.array([y[1], -1e6 * y[1] - 1e10 * y[0]]), np.array([1.0, 0.0]),
                    times, 1e-14)  # fmt: skip
    with mpmath.workdps(40):
        root = mpmath.sqrt(mpmath.mpf(10) ** 12 / 4 - mpmath.mpf(10) ** 10)
        a, b = -mpmath.mpf(500000) + root, -mpmath.mpf(500000) - root
        exact = [float((a * mpmath.exp(b * float(t)) - b * mpmath.exp(a * float(t))) / (a - b)) for t in times]
    assert np.abs(rows[:, 0] - exact).max() < 1e-15


def test_collocation_does_not_go_on_without_a_solution():
    with np.errstate(all="ignore"), pytest.raises(NotReachedError):
        followed(Collocation(5), lambda time, y: y**2, np.array([1.0]), np.array([0.0, 2.0]), 1e-12)


def stiff_start() -> np.ndarray:
    model = elastic_link()
    return np.array([*model.initial_x[:2], 0.01, *model.initial_v])


def test_the_reference_of_a_stiff_motion_is_implicit():
    """Against steps on a graded mesh: other steps, the same equations."""
    equations = classical(elastic_link()).with_values(STIFF["parameters"])
    made = reference(equations, stiff_start(), 0.2)
    assert "implicit steps" in made.how
    assert made.errors.max() < 1e-15
    graded = Collocated(extended(equations), np.ones(6)).rows(stiff_start(), made.t, 0)
    assert np.abs(graded[:, :3] - made.x).max() < 1e-12
    rates = rates_of(extended(equations), made.t[:1], stiff_start()[None])
    assert rates.real.min() == pytest.approx(-1.6e6, rel=0.01)


def test_both_kinds_of_reference_agree(monkeypatch):
    model = model_of("double_pendulum")
    start = np.array([*model.initial_x, *model.initial_v])
    explicit_ = reference(classical(model), start, 2.0)
    monkeypatch.setattr("eigenmotion.reference.motion._DECAYS", -1.0)
    implicit = reference(classical(model), start, 2.0)
    assert explicit_.how != implicit.how
    np.testing.assert_allclose(implicit.x, explicit_.x, rtol=0, atol=1e-14)


def test_decays_are_found_on_the_way():
    """A damper that acts at t = 1 only."""
    times = np.linspace(0.0, 2.0, 5)
    rates = rates_of(lambda time, y: -1e3 * y * (time == 1), times, np.ones((5, 1)))
    assert rates.real.min() == pytest.approx(-1e3)


def test_the_reference_of_a_stiff_spring_minds_its_rounding():
    """A mass on a spring of stiffness 1e8, for 100 periods, in steps that rounding does not shorten."""
    model = model_of("elastic_pendulum")
    equations = classical(model).with_values({"k": 1e8, "g": 0.0})
    made = reference(equations, np.array([0.0, 1.001, 0.0, 0.0]), 200 * np.pi / 1e4)
    exact = 1 + 1e-3 * np.cos(1e4 * made.t)
    assert np.abs(made.x[:, 1] - exact).max() < 1e-14
    assert made.errors.max() < 1e-14


# --- what peers integrate


@pytest.mark.parametrize("scenario", SCENARIOS, ids=lambda scenario: scenario.name)
def test_classical_equations_agree_with_plain_differentiation(scenario):
    model, n = scenario.model(), len(scenario.model().coordinates)
    equations = classical(model)
    rhs, exact = double(equations), extended(equations)
    for state in scenario.random_states(2):
        expected, _ = scenario.lagrange()(state.x, state.v, 0.3)
        y = np.concatenate([state.x, state.v])
        size = 1e-10 * (1 + np.abs(expected).max())
        np.testing.assert_allclose(rhs(0.3, y)[n:], expected, atol=size)
        np.testing.assert_allclose(exact(np.longdouble(0.3), y.astype(np.longdouble))[n:].astype(float), expected,
                                   atol=size)  # fmt: skip
        np.testing.assert_array_equal(rhs(0.3, y)[:n], state.v)


def test_inputs_are_held_at_what_is_set():
    """q'' = (u + w) / m."""
    q, u, w = dynamicsymbols("q u w")
    m = sympy.Symbol("m")
    model = em.Model(name="pushed", coordinates=[q], kinetic_energy=m * q.diff() ** 2 / 2, forces=[u + w],
                     parameters={m: 2.0}, inputs={u: 1.0, w: 0.5})  # fmt: skip
    for values, rate in (({}, 0.75), ({"w": 3.0}, 2.0), ({"u": 0.0, "w": 3.0, "m": 4.0}, 0.75)):
        assert double(classical(model).with_values(values))(0.0, np.array([0.0, 7.0])).tolist() == [7.0, rate]


def test_written_out_accelerations_agree():
    """The elimination that heyoka.py and CasADi get, done by SymPy's numbers."""
    scenario = BY_NAME["dual_link"]
    functions = {"sin": sympy.sin, "cos": sympy.cos}
    state = scenario.random_states(1)[0]
    a = explicit(classical(scenario.model()), functions, list(map(sympy.Float, state.x)),
                 list(map(sympy.Float, state.v)), sympy.Float(0))  # fmt: skip
    np.testing.assert_allclose(np.array(a, dtype=float), scenario.lagrange()(state.x, state.v)[0], rtol=1e-11)


def test_elimination_skips_zeros():
    """Two free particles and one held together with the second: zeros stay numbers, and nothing divides by them."""
    a = accelerations([[2, 0, 0], [0, 1, 0], [0, 0, 3]], [[0, 1, -1]], [4, 0, 8], [0])
    assert a == [2, 2, 2]


def test_peers_that_are_missing_are_named(monkeypatch):
    monkeypatch.setattr("eigenmotion.report.peers.find_spec", lambda name: None)
    assert _peers().absent == (
        ("heyoka.py", "not installed (pip install heyoka)"),
        ("CasADi/CVODES", "not installed (pip install casadi)"),
    )
    assert {solver.family for solver in _peers().solvers} == {"SciPy"}


def test_scipys_runs_are_stopped(monkeypatch):
    monkeypatch.setattr(peers, "LONGEST", 0.0)
    model = model_of("pendulum")
    known = reference(classical(model), np.array([*model.initial_x, *model.initial_v]), 1.0)
    chosen = [solver for solver in _peers().solvers if solver.family == "SciPy"]
    measured = measure(chosen, Judge(known, system_of("pendulum")), QUICK, lambda *_: None)
    assert {m.method for m in measured} == {"DOP853", "LSODA", "Radau"}
    assert {m.message for m in measured} == {"TimeoutError: stopped after 0 s"}


def test_casadis_failures_are_told_in_brief(monkeypatch):
    pytest.importorskip("casadi")
    monkeypatch.setattr(peers, "MOST_STEPS", {False: 3})
    (cvodes, _) = [solver for solver in _peers().solvers if solver.family == "CVODES"]
    with pytest.raises(RuntimeError, match=r"^CVode returned .CV_TOO_MUCH_WORK"):
        cvodes.attempt(1e-6).run()


def _peers() -> Peers:
    model = model_of("pendulum")
    return peers.peers(classical(model), peers.Start(np.array([*model.initial_x, *model.initial_v]), 1.0))


def test_peers_that_are_installed_find_the_motion(found):
    by_family = {m.family: m for m in found.measurements if m.tolerance == 1e-8}
    assert {"SciPy", "eigenmotion"} <= by_family.keys()
    for measurement in by_family.values():
        assert measurement.message == ""
        assert measurement.error_max < 1e-4


# --- what is measured


def test_every_formulation_method_and_tolerance_is_there(found):
    ours = [m for m in found.measurements if m.family == "eigenmotion" and m.method in METHODS]
    assert {(m.formulation, m.method) for m in ours} == {(f, m) for f in FORMULATIONS for m in METHODS}
    assert {m.tolerance for m in ours} == set(TOLERANCES)
    for m in ours:
        assert m.message == ""
        assert 0 < m.error_end <= m.error_max
        assert m.seconds_low <= m.seconds <= m.seconds_high
        assert m.repeats >= 3
        assert m.nfev > m.nsteps > 0
        assert m.constraint_violation < 1e-14
        assert m.position_violation is None
        assert m.energy_integral < 1e3 * m.error_max
        assert (m.factor_residual is None) == (m.formulation != "eigenfactor")


def test_every_implicit_method_is_there_once(found):
    ours = [m for m in found.measurements if m.family == "eigenmotion" and m.method in IMPLICIT]
    assert {m.formulation for m in ours} == {"lagrange"}
    assert {m.method for m in ours} == set(IMPLICIT[: 3 + HAS_SUNDIALS])
    for m in ours:
        assert m.message == ""
        assert 0 < m.error_end <= m.error_max
        assert m.seconds_low <= m.seconds <= m.seconds_high
        assert m.repeats >= 3
        assert m.nfev > m.nsteps > 0
        assert m.constraint_violation < 1e-14
        assert m.energy_integral < 1e3 * m.error_max
    run = system_of("dual_link", "lagrange").simulate((0, 10), rtol=1e-6, atol=1e-6, method="Radau")
    (m,) = [m for m in ours if m.method == "Radau" and m.tolerance == 1e-6]
    assert m.error_end == pytest.approx(np.max(np.abs(run.x[:, -1] - EXACT) / (1 + np.abs(EXACT))), rel=1e-3)


def test_an_implicit_method_that_is_missing_is_named(monkeypatch):
    monkeypatch.setattr("eigenmotion.running.methods.find_spec", lambda name: None)
    solvers, absent = implicit_solvers([system_of("pendulum"), system_of("pendulum", "lagrange")], Problem(1.0, {}))
    assert [solver.label for solver in solvers] == ["lagrange Radau", "lagrange BDF", "lagrange LSODA"]
    assert absent == [("CVODE", "not installed (pip install 'eigenmotion[stiff]')")]
    (solver, *_), _ = implicit_solvers([system_of("pendulum")], Problem(1.0, {}))
    assert solver.label == "eigenfactor Radau"


def test_the_error_at_the_end_is_that_of_a_run(found):
    (m,) = [m for m in found.measurements if m.label == "eigenfactor dop853" and m.tolerance == 1e-7]
    run = system_of("dual_link").simulate((0, 10), rtol=1e-7, atol=1e-7)
    assert m.error_end == pytest.approx(np.max(np.abs(run.x[:, -1] - EXACT) / (1 + np.abs(EXACT))), rel=1e-3)
    assert (m.nfev, m.nsteps) == (run.nfev, run.nsteps)


def test_curves_slope_as_the_orders_say(found):
    ours = [c for c in found.curves if c.family == "eigenmotion"]
    (radau,) = [c for c in ours if c.method == "Radau"]
    assert 4 < radau.order(found.floor) < 6
    orders = {c.label: c.order(found.floor) for c in ours if not c.is_implicit}
    assert len(orders) == len(FORMULATIONS) * len(METHODS)
    for label, order in orders.items():
        expected = METHODS[label.split()[1]]
        assert expected - 0.5 < order < expected + 1.5, label


def test_the_judge_by_hand():
    times = np.array([0.0, 1.0, 2.0])
    x = np.array([[0.1], [0.2], [0.3]])
    known = Reference(times, x, np.zeros((3, 1)), np.zeros(3), "by hand")
    system = system_of("pendulum")
    off = Track(x + np.array([[0.0], [1e-3], [-1e-4]]), np.array([[0.0], [2.0], [0.0]]), nfev=1, nsteps=1)
    m = Judge(known, system)(Measurement("f", "g", "h", "l", 1e-3), off)
    assert m.error_max == pytest.approx(1e-3 / 1.2)
    assert m.error_end == pytest.approx(1e-4 / 1.3)
    assert m.velocity_error_max == 2.0
    P = [system.energy(x, v) for x, v in zip(off.x, off.v, strict=True)]
    assert m.energy_integral == pytest.approx(abs(P[1] - P[0]) + abs(P[2] - P[0]) / 2)


@pytest.mark.parametrize("fault", ["short", "nan", "raises"])
def test_a_run_that_fails_has_no_error_and_no_time(fault):
    times = np.array([0.0, 1.0])
    known = Reference(times, np.zeros((2, 1)), np.zeros((2, 1)), np.zeros(2), "by hand")

    def motion(rows: np.ndarray) -> Track:
        if fault == "raises":
            raise RuntimeError("no such function")
        x = np.zeros((1, 1)) if fault == "short" else np.full((2, 1), np.nan)
        return Track(x, x, nfev=1, nsteps=1)

    solver = Solver("peer", "", "method", (1e-3,), lambda tolerance: Attempt(lambda: None, lambda t, _: motion(t)))
    (m,) = measure([solver], Judge(known, system_of("pendulum")), QUICK, lambda done, what: None)
    assert m.error_end is m.seconds is None
    assert {"short": "reach the end", "nan": "not finite", "raises": "no such function"}[fault] in m.message


@pytest.fixture
def clock(monkeypatch) -> SimpleNamespace:
    """A clock by hand, which only the runs of `slow_solver` move on."""
    clock = SimpleNamespace(now=0.0)
    clock.perf_counter = lambda: clock.now
    monkeypatch.setattr("eigenmotion.report.measure.time", clock)
    return clock


def slow_solver(seconds: float, clock: SimpleNamespace, fails: bool = False) -> Solver:
    def run() -> None:
        clock.now += seconds

    def motion(times: np.ndarray, done: object) -> Track:
        rows = np.zeros((2, 1))
        return Track(rows, rows, nfev=1, nsteps=1, message="too many steps" if fails else "")

    tolerances = tuple(10.0**-k for k in range(1, 9))
    return Solver("peer", "", "slow", tolerances, lambda tolerance: Attempt(run, motion))


def measured_of(solver: Solver) -> list[Measurement]:
    known = Reference(np.array([0.0, 1.0]), np.zeros((2, 1)), np.zeros((2, 1)), np.zeros(2), "by hand")
    return measure([solver], Judge(known, system_of("pendulum")), GRAINY, lambda *_: None)


def test_slow_runs_are_made_at_fewer_tolerances(clock):
    solver = slow_solver(0.05, clock)
    measured = measured_of(solver)
    assert [m.tolerance for m in measured] == pytest.approx([1e-1, 1e-4, 1e-7])
    why = "5 of 8 tolerances left out, as runs took more than 0.02 s"
    assert skipped([solver], measured, GRAINY) == (("peer slow", why),)


def test_after_a_slow_failure_nothing_tighter_is_tried(clock):
    solver = slow_solver(0.03, clock, fails=True)
    measured = measured_of(solver)
    assert [m.tolerance for m in measured] == [0.1]
    why = "7 of 8 tolerances left out, as the run at 1e-01 ended early: too many steps"
    assert skipped([solver], measured, GRAINY) == (("peer slow", why),)


def test_both_reasons_are_given_where_both_hold(clock):
    slow = replace(point(1e-3, 0.05), family="peer", formulation="", method="slow", tolerance=0.1)
    failed = replace(slow, tolerance=1e-4, error_end=None, message="too many steps")
    ((_, why),) = skipped([slow_solver(0.0, clock)], [slow, failed], GRAINY)
    assert why == (
        "6 of 8 tolerances left out, as runs took more than 0.02 s and the run at 1e-04 ended early: too many steps"
    )


def test_quick_runs_skip_nothing(clock):
    solver = slow_solver(1e-3, clock, fails=True)
    measured = measured_of(solver)
    assert len(measured) == 8
    assert skipped([solver], measured, GRAINY) == ()


def test_slow_runs_are_timed_from_the_first(clock, monkeypatch):
    monkeypatch.setattr("eigenmotion.report.measure.SLOW", 0.01)
    (first, *_) = measured_of(slow_solver(0.02, clock))
    assert first.repeats == 2
    assert first.seconds == pytest.approx(0.02)


def test_progress_runs_from_start_to_end(found, progress):
    done = [fraction for fraction, _ in progress]
    assert done == sorted(done)
    assert 0 <= done[0] < 0.1
    assert 0.8 < done[-1] <= 1


# --- what it advises


def point(
    error: float, seconds: float, method: str = "dop853", tolerance: float = 1e-3, nsteps: int = 1
) -> Measurement:
    return Measurement(
        "eigenmotion", "cholesky", method, f"cholesky {method}", tolerance, error, error, seconds=seconds,
        seconds_low=0.99 * seconds, seconds_high=1.01 * seconds, nsteps=nsteps, nfev=10 * nsteps,
    )  # fmt: skip


def test_the_recommendation_is_the_soonest_of_all(found):
    chosen = found.recommendation.chosen
    assert chosen.error_max <= 1e-8
    able = [p for c in found.curves if c.family == "eigenmotion" for p in c.reaching(1e-8)]
    assert chosen in able
    assert chosen.seconds == min(p.seconds for p in able)


def test_a_lucky_point_is_not_recommended():
    quick = [point(1e-9, 1.0), point(1e-5, 2.0), point(1e-9, 5.0), point(1e-10, 6.0)]
    slow = [point(1e-9, 4.0, "rk34"), point(1e-10, 7.0, "rk34")]
    advice = recommend(curves([*quick, *slow]), 1e-8)
    assert (advice.chosen.method, advice.chosen.seconds) == ("rk34", 4.0)
    assert advice.as_fast == ()


def test_what_is_as_fast_is_named_once_a_solver():
    advice = recommend(curves([point(1e-9, 1.0), point(1e-9, 1.001, "rk34"), point(1e-9, 1.002, "rk34")]), 1e-8)
    assert [p.seconds for p in advice.as_fast] == [1.001]


@pytest.fixture(scope="module")
def stiff() -> Findings:
    """An elastic link of stiffness 1e10 with damping 1e6, in one formulation, without peers."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("EIGENMOTION_CFLAGS", "-O1")
        undisturbed(patch)
        patch.setattr("eigenmotion.report.subject.FORMULATIONS", ("lagrange",))
        patch.setattr(importlib.import_module("eigenmotion.report.examine"), "peers", lambda *_: Peers((), ()))
        patch.setattr("eigenmotion.report.solvers.IMPLICIT_TOLERANCES", (1e-5, 1e-7, 1e-9, 1e-11))
        ask = Ask(error=1e-6, t_end=0.5, tolerances=(1e-4, 1e-8), settings=STIFF, budget=Budget(rounds=2))
        return examine(elastic_link(), ask, lambda done, what: None)


def test_on_a_stiff_model_an_implicit_method_is_recommended(stiff):
    chosen = stiff.recommendation.chosen
    assert chosen.method in IMPLICIT
    assert chosen.error_max <= 1e-6
    explicit_ = [m for m in stiff.measurements if m.method in METHODS and m.error_end is not None]
    assert explicit_
    assert all(m.seconds > 2 * chosen.seconds and m.nsteps > 20 * chosen.nsteps for m in explicit_)
    words = " ".join(recommendation(stiff))
    assert f"formulation lagrange, method {chosen.method}" in words
    assert "parameters={'k': 10000000000.0, 'd': 1000000.0}, x0={'q': 0.01}" in words
    assert re.search(r"Times as long to that error: .*lagrange \d", words)


def test_the_recommended_call_can_be_made(stiff):
    """As it is printed; compiled otherwise, its steps may differ, and so does its error."""
    _, call, *_ = recommendation(stiff)
    names = {"eigenmotion": em, "model": elastic_link()}
    exec(call.replace("; eigenmotion.simulate", "; solution = eigenmotion.simulate"), names)
    error = scaled_error(names["solution"].x[:, -1], stiff.reference.x[-1])
    assert 0.2 < error / stiff.recommendation.chosen.error_end < 5


def test_pictures_and_page_of_a_stiff_model(stiff, tmp_path):
    pytest.importorskip("matplotlib")
    write_report([stiff], tmp_path)
    page = (tmp_path / "report.html").read_text()
    assert "Set: k = 1e+10, d = 1e+06, q = 0.01." in page
    assert "Radau IIA" in page
    (model,) = json.loads((tmp_path / "report.json").read_text())["models"]
    assert model["settings"] == STIFF
    assert model["x_start"] == [0.4, 1.3, 0.01]


def test_an_accuracy_out_of_reach_is_said_to_be():
    advice = recommend(curves([point(1e-5, 1.0), point(1e-6, 2.0)]), 1e-8)
    assert advice.chosen is None
    assert advice.closest.error_max == 1e-6


def test_times_are_interpolated_in_logarithms():
    curve = Curve("", "", "", "", (point(1e-4, 1.0), point(1e-6, 4.0), point(1e-8, 16.0)))
    assert curve.seconds_at(1e-5) == pytest.approx(2.0)
    assert curve.seconds_at(1e-8) == pytest.approx(16.0)
    assert curve.seconds_at(1e-2) == 1.0
    assert curve.seconds_at(1e-9) is None


def test_a_tighter_run_that_is_quicker_counts():
    """Too loose a tolerance costs an explicit method rejected steps, and an implicit one iterations."""
    curve = Curve("", "", "", "", (point(1e-4, 5.0), point(1e-6, 4.0), point(1e-7, 3.0), point(1e-9, 6.0)))
    assert curve.seconds_at(1e-5) == 3.0
    assert curve.seconds_at(1e-8) == pytest.approx(np.sqrt(18.0))
    advice = recommend(curves([replace(p, family="eigenmotion") for p in curve.points]), 1e-5)
    assert advice.chosen.seconds == 3.0


def test_times_that_spread_are_said_to(found):
    def said(high: float) -> bool:
        chosen = replace(found.recommendation.chosen, seconds_low=1.0, seconds=1.1, seconds_high=high)
        words = recommendation(replace(found, recommendation=replace(found.recommendation, chosen=chosen)))
        return any("Measure again on a quiet one" in sentence for sentence in words)

    assert said(1.5)
    assert not said(1.2)


def test_order_and_cost_of_a_made_up_curve():
    points = tuple(replace(point(float(n) ** -5, 1e-4 + 2e-6 * n), nsteps=n) for n in (10, 20, 40, 80))
    points = tuple(replace(p, nfev=10 * p.nsteps) for p in points)
    curve = Curve("", "", "", "", points)
    assert curve.order(1e-16) == pytest.approx(5)
    assert curve.cost() == pytest.approx((1e-4, 2e-7))
    assert replace(curve, points=tuple(replace(p, nsteps=70) for p in points)).order(1e-16) is None


# --- what it writes


@pytest.fixture(scope="module")
def called(found, tmp_path_factory) -> SimpleNamespace:
    """What the command asked for, said and wrote, given what was found."""
    pytest.importorskip("matplotlib")
    asked, said, folder = [], io.StringIO(), tmp_path_factory.mktemp("report") / "out"
    with pytest.MonkeyPatch.context() as patch, redirect_stdout(said):
        patch.setattr(cli, "examine", lambda model, ask, progress: asked.append((model.name, ask)) or found)
        model = str(MODELS / "dual_link.py")
        assert main(["report", model, "-o", str(folder), "--error", "1e-6", "--t-end", "3"]) == 0
    return SimpleNamespace(asked=asked, said=said.getvalue(), folder=folder)


@pytest.fixture(scope="module")
def folder(called):
    return called.folder


def test_the_files(folder):
    names = {path.name for path in folder.iterdir()}
    pictures = {f"dual_link_{kind}.{ending}" for kind in ("time", "methods", "order") for ending in ("png", "svg")}
    assert names == {"report.html", "report.json", "report.csv", *pictures}
    for name in pictures:
        content = (folder / name).read_bytes()
        assert content.startswith(b"\x89PNG" if name.endswith("png") else b"<svg")
        if name.endswith("svg"):
            ElementTree.fromstring(content.decode())


def test_the_numbers_as_json(folder, found):
    text = (folder / "report.json").read_text()
    (model,) = json.loads(text, parse_constant=pytest.fail)["models"]
    assert model["name"] == "dual_link"
    assert model["reference"]["x_end"] == pytest.approx(EXACT, abs=1e-15)
    assert {built["formulation"] for built in model["formulations"]} == set(FORMULATIONS)
    assert all(built["compilation_seconds"] > 0 and built["left_out"] for built in model["formulations"])
    assert len(model["measurements"]) == len(found.measurements)
    needed = {"error_end", "error_max", "seconds", "seconds_low", "seconds_high", "nfev", "nsteps",
              "constraint_violation", "energy_integral", "factor_residual", "ns_per_rhs"}  # fmt: skip
    assert all(needed <= measurement.keys() for measurement in model["measurements"])
    assert model["recommendation"]["chosen"]["error_max"] <= 1e-8
    ratios = {c["label"]: c["seconds_to_reach"] for c in model["curves"]}
    assert ratios["SciPy DOP853"]["1e-06"] > 10 * ratios["eigenfactor dop853"]["1e-06"]


def test_the_numbers_as_csv(folder, found):
    rows = list(csv.DictReader(io.StringIO((folder / "report.csv").read_text())))
    assert len(rows) == len(found.measurements)
    for row, m in zip(rows, found.measurements, strict=True):
        assert (row["model"], row["label"]) == ("dual_link", m.label)
        assert float(row["error_max"]) == m.error_max
        assert float(row["seconds"]) == m.seconds


def test_the_page_needs_nothing_else(folder):
    page = (folder / "report.html").read_text()
    assert page.count("<svg") == 3
    addresses = re.findall(r'(?:src|href)\s*=\s*"([^"]*)"', page)
    assert all(address.startswith("#") for address in addresses)
    assert "@import" not in page
    assert "url(http" not in page
    assert "do not couple" in page  # what was left out
    assert "None" not in page
    assert "measured once, on lagrange" in page
    assert "the model's own" in page.replace("&#39;", "'")
    assert "nan" not in re.sub(r"<svg.*?</svg>", "", page, flags=re.DOTALL).lower().split()
    for sentence in recommendation_words(page):
        assert sentence


def recommendation_words(page: str) -> list[str]:
    advice = re.search(r'<div class="advice">(.*?)</div>', page, flags=re.DOTALL)
    assert advice
    return re.findall(r"<p>(.*?)</p>", advice[1])


def test_nothing_tells_whose_machine_it_was(folder):
    home = str(MODELS.parent)
    for path in folder.iterdir():
        assert home.encode() not in path.read_bytes()


def test_the_advice_in_words(found):
    words = " ".join(recommendation(found))
    chosen = found.recommendation.chosen
    assert f"formulation {chosen.formulation}, method {chosen.method}, rtol = atol = {chosen.tolerance:.1e}" in words
    assert "SciPy DOP853" in words
    assert "Caution" not in words
    vague = replace(found, reference=replace(found.reference, errors=found.reference.errors + 1e-7))
    assert "Caution" in " ".join(recommendation(vague))
    hopeless = replace(found, recommendation=recommend(found.curves, 1e-30))
    assert "No run reaches" in " ".join(recommendation(hopeless))


# --- the command


def test_the_command_writes_and_advises(called):
    assert called.asked == [("dual_link", Ask(error=1e-6, t_end=3.0))]
    assert "formulation" in called.said
    assert (called.folder / "report.html").is_file()


def test_the_command_sets_arguments_of_models(found, monkeypatch, tmp_path, capsys):
    names = []
    monkeypatch.setattr(cli, "examine", lambda model, ask, progress: names.append(model.name) or found)
    monkeypatch.setattr(cli, "write_report", lambda reports, folder: (folder / "report.html",))
    assert main(["report", str(MODELS / "chain.py"), "-D", "n=2", "-o", str(tmp_path)]) == 0
    assert names == [em.load_model(MODELS / "chain.py", n=2).name]


def test_the_command_sets_parameters_and_starts(found, monkeypatch, tmp_path):
    asked = []
    monkeypatch.setattr(cli, "examine", lambda model, ask, progress: asked.append(ask.settings) or found)
    monkeypatch.setattr(cli, "write_report", lambda reports, folder: (folder / "report.html",))
    monkeypatch.setattr(cli, "recommendation", lambda found: ())
    settings = ["--set", "k=2e3", "--set", "theta=0.25", "--set", "theta'=1", "--set", "r'=-1"]
    assert main(["report", str(MODELS / "elastic_pendulum.py"), *settings, "-o", str(tmp_path)]) == 0
    assert asked == [{"parameters": {"k": 2e3}, "x0": {"theta": 0.25}, "v0": {"theta": 1.0, "r": -1.0}}]


def test_settings_reach_every_run_and_the_reference(monkeypatch):
    """A pendulum of another length let go elsewhere: every measurement agrees with its closed form."""
    monkeypatch.setenv("EIGENMOTION_CFLAGS", "-O1")
    monkeypatch.setattr("eigenmotion.report.subject.FORMULATIONS", ("eigenfactor",))
    monkeypatch.setattr("eigenmotion.report.peers.DECADES", (1e-8,))
    monkeypatch.setattr("eigenmotion.report.peers._TAYLOR_TOLERANCES", (1e-8,))
    monkeypatch.setattr("eigenmotion.report.solvers.IMPLICIT_TOLERANCES", (1e-8,))
    settings = {"parameters": {"l": 0.4}, "x0": {"theta": 1.0}}
    ask = Ask(t_end=2.0, tolerances=(1e-8,), settings=settings, budget=Budget(rounds=1))
    made = examine(model_of("pendulum"), ask, lambda done, what: None)
    k, w = mpmath.sin(mpmath.mpf(0.5)), mpmath.sqrt(mpmath.mpf(9.81) / mpmath.mpf(0.4))
    exact = float(2 * mpmath.asin(k * mpmath.ellipfun("cd", 2 * w, k=k)))
    assert made.reference.x[-1, 0] == pytest.approx(exact, abs=1e-14)
    assert made.start.tolist() == [1.0, 0.0]
    assert all(m.message == "" and m.error_max < 1e-4 and m.energy_integral < 1e-4 for m in made.measurements)


PENDULUM = str(MODELS / "pendulum.py")


@pytest.mark.parametrize("arguments", [
    [], ["nowhere.py"], ["--paper", "--set", "l=1"], [PENDULUM, "--error", "0"], [PENDULUM, "--t-end", "-1"],
    [PENDULUM, "--set", "gee=1"], [PENDULUM, "--set", "l=long"],
])  # fmt: skip
def test_mistakes_in_the_call(arguments, capsys):
    assert main(["report", *arguments]) == 2
    assert capsys.readouterr().err


def test_a_run_that_cannot_get_to_the_end_is_a_mistake(monkeypatch):
    monkeypatch.setattr("eigenmotion.report.subject.FORMULATIONS", ("lagrange",))
    theta = dynamicsymbols("theta")
    falling = em.Model(name="falling", coordinates=[theta], kinetic_energy=theta.diff() ** 2 / 2,
                       potential_energy=-1 / theta, initial={theta: 1})  # fmt: skip
    with pytest.raises(ModelError, match="--t-end"):
        examine(falling, Ask(t_end=10.0, tolerances=(1e-6,), budget=QUICK), lambda done, what: None)
