"""Measurements of the report: errors and times by hand; solvers that are slow, fail or are not there."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from eigenmotion.reference.lagrange_equations import classical
from eigenmotion.reference.motion import Reference, reference
from eigenmotion.report import Budget, Measurement, peers
from eigenmotion.report.measure import Judge, measure, skipped
from eigenmotion.report.peers import Peers
from eigenmotion.report.solvers import Attempt, Problem, Solver, Track, implicit_solvers

from ..support.generation import model_of, system_of

QUICK, GRAINY = Budget(rounds=3), Budget(grain=0.02, rounds=1)


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
    (slow, *_) = measured_of(slow_solver(0.05, clock))
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


def test_a_run_that_raises_as_it_is_timed_has_no_time(clock):
    """Runs of SciPy end after some seconds: one that took a little less at first may take more when it is timed."""

    def attempt(tolerance: float) -> Attempt:
        runs = []

        def run() -> None:
            runs.append(tolerance)
            if tolerance < 1e-2 and len(runs) > 1:
                raise TimeoutError("stopped after 5 s")
            clock.now += 0.001

        return Attempt(run, lambda times, done: Track(np.zeros((2, 1)), np.zeros((2, 1)), nfev=1, nsteps=1))

    sound, stopped = measured_of(Solver("peer", "", "slow", (1e-1, 1e-3), attempt))
    assert (sound.message, sound.seconds) == ("", pytest.approx(0.001))
    assert (stopped.seconds, stopped.error_max) == (None, None)
    assert stopped.message == "TimeoutError as it was timed: stopped after 5 s"


def _peers() -> Peers:
    model = model_of("pendulum")
    return peers.peers(classical(model), peers.Start(np.array([*model.initial_x, *model.initial_v]), model.n, 1.0))


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
    monkeypatch.setattr(peers, "MOST_STEPS", 3)
    (cvodes, _) = [solver for solver in _peers().solvers if solver.family == "CVODES"]
    with pytest.raises(RuntimeError, match=r"^CVode returned .CV_TOO_MUCH_WORK"):
        cvodes.attempt(1e-6).run()


def test_implicit_methods_are_measured_once_on_the_plainest_formulation():
    solvers = implicit_solvers([system_of("pendulum"), system_of("pendulum", "lagrange")], Problem(1.0, {}))
    assert [solver.label for solver in solvers] == ["lagrange radau5", "lagrange radau9"]
    solver, _ = implicit_solvers([system_of("pendulum")], Problem(1.0, {}))
    assert solver.label == "eigenfactor radau5"
