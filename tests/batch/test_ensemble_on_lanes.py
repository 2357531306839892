"""Runs of an ensemble side by side in the lanes of vectors: the motions that numbers give, and bits of one's own."""

import signal
import threading
import time
from os import getpid, kill
from pathlib import Path

import numpy as np
import pytest

import eigenmotion as em
from eigenmotion import Signal, StopReason, simulate_ensemble

from ..methods.test_implicit_methods import damped_link
from ..support.generation import system_for
from .test_ensemble import ROWS, SPAN, SWING, TIGHT, bits

MODELS = Path(__file__).parents[2] / "models"
COUNT = 21
SPEEDS = np.linspace(0.0, 9.0, COUNT)


@pytest.fixture(scope="module")
def swing() -> em.System:
    return em.build(SWING, formulation="lagrange")


@pytest.fixture(scope="module")
def link() -> em.System:
    """One with a constraint on velocities, which steps are settled on."""
    return em.build(MODELS / "dual_link.py", formulation="inverse")


@pytest.fixture(scope="module")
def turning() -> em.System:
    """The same by its eigenfactors, with runs that change their mode on the way."""
    return em.build(MODELS / "dual_link.py", formulation="eigenfactor", flags="-O1")


@pytest.fixture(scope="module")
def loop() -> em.System:
    """One with constraints on positions, on which numbers put every step."""
    return em.build(MODELS / "four_bar.py", formulation="inverse")


def check_alike(one: em.Solution, other: em.Solution) -> None:
    """Say that they are the same but for rounding."""
    told = ("stop", "nsteps", "nrejected", "nfev", "n_bounded", "n_stiff", "method")
    assert [one[name] for name in told] == [other[name] for name in told]
    assert np.allclose(one.t, other.t, rtol=0, atol=1e-10)
    assert np.allclose(one.y, other.y, rtol=1e-9, atol=1e-9)
    for mine, theirs in zip(one.t_events or [], other.t_events or [], strict=True):
        assert np.allclose(mine, theirs, rtol=0, atol=1e-9)


def test_members_move_as_they_do_alone(swing):
    """At rows, with events of both kinds, a constant input and without."""
    given = {"t_eval": ROWS, "inputs": {"u": 0.3}, **TIGHT}
    runs = simulate_ensemble(swing, SPAN, v0={"q": SPEEDS}, **given)
    for k, speed in enumerate(SPEEDS):
        check_alike(runs[k], swing.simulate(SPAN, v0={"q": speed}, **given))
    assert set(runs.stop) == {StopReason.FINISHED, StopReason.TERMINAL_EVENT}
    assert any(len(run.t_events[0]) > 1 for run in runs)


@pytest.mark.parametrize("span", [(0.0, 2.0), (2.0, 0.5), (1.0, 1.0)])
def test_members_with_constraints_move_as_they_do_alone(link, span):
    springs = np.linspace(0.5, 2.0, COUNT)
    rows = np.linspace(*span, 4) if span[0] != span[1] else None
    runs = simulate_ensemble(link, span, parameters={"K1": springs}, t_eval=rows, **TIGHT)
    for k in range(0, COUNT, 4):
        check_alike(
            runs[k],
            link.simulate(span, parameters={"K1": springs[k]}, t_eval=[span[1]] if rows is None else rows, **TIGHT),
        )
    assert np.abs(runs[3].constraint_residual).max() < 1e-13


@pytest.mark.parametrize("span", [(0.0, 2.0), (2.0, 0.5)])
@pytest.mark.parametrize(
    "formulation",
    ["inverse", *(pytest.param(f, marks=pytest.mark.nightly) for f in ("eigenfactor", "cholesky", "lagrange"))],
)
def test_members_with_constraints_on_positions_move_as_they_do_alone(loop, formulation, span):
    system = loop if formulation == "inverse" else em.build(MODELS / "four_bar.py", formulation=formulation)
    assert system.compiled.lane_groups == (system.compiled.lanes > 1)
    weights, rows = np.linspace(5.0, 15.0, COUNT), np.linspace(*span, 4)
    runs = simulate_ensemble(system, span, parameters={"g": weights}, t_eval=rows, **TIGHT)
    for k in range(0, COUNT, 4):
        check_alike(runs[k], system.simulate(span, parameters={"g": weights[k]}, t_eval=rows, **TIGHT))
    assert np.abs(runs[3].position_residual).max() < 1e-12


def test_a_loop_that_comes_near_a_singular_position_is_run_by_numbers(loop):
    """A parallelogram that flattens, fast and slowly, beside one that does not: numbers settle the stages there."""
    (x, v), flat, speeds = loop.initial, [np.pi / 2, 0.0, np.pi / 2], (4.0, 1.0)
    starts = {"x0": np.array([x, flat, flat]), "v0": np.array([v, *([speed, 0.0, speed] for speed in speeds)])}
    options = {"t_eval": ROWS, "rtol": 1e-10, "atol": 1e-10}
    runs = simulate_ensemble(loop, SPAN, parameters={"c": [0.8, 0.4, 0.4]}, **starts, **options)
    check_alike(runs[0], loop.simulate(SPAN, **options))
    for k in (1, 2):
        alone = loop.simulate(SPAN, parameters={"c": 0.4}, x0=flat, v0=starts["v0"][k], **options)
        assert (runs.stop[k], runs.message(k)) == (alone.stop, alone.message)
        np.testing.assert_allclose(runs[k].y, alone.y, atol=1e-8)  # rounding says how near they come
    assert runs.nfev[2] == alone.nfev
    assert np.array_equal(runs[2].y, alone.y, equal_nan=True)
    assert set(runs.stop[1:]) <= {StopReason.FINISHED, StopReason.DEPENDENT_CONSTRAINTS}


@pytest.mark.parametrize("rows", [None, 3])
def test_members_change_their_modes_as_they_do_alone(turning, rows):
    """C, s and eta are those of numbers, too; more runs than both lane groups have lanes."""
    springs, span = np.linspace(0.5, 2.0, COUNT), (0.0, 8.0)
    t_eval = None if rows is None else np.linspace(*span, rows)
    runs = simulate_ensemble(turning, span, parameters={"K1": springs}, t_eval=t_eval, **TIGHT)
    for k in range(0, COUNT, 3):
        given = {"parameters": {"K1": springs[k]}, "t_eval": [span[1]] if rows is None else t_eval, **TIGHT}
        check_alike(runs[k], turning.simulate(span, **given))
    changed = [0 < run.n_bounded < run.nsteps for run in runs]
    assert sum(changed) > COUNT // 2
    assert max(run.factor_residual.max() for run in runs) < 1e-13


def test_roots_that_vary_are_kept_in_lanes():
    """A triangular root of a block, and of one that is a number."""
    system = system_for(SWING, "cholesky")
    assert system.compiled.lane_groups == (system.compiled.lanes > 1)
    runs = simulate_ensemble(system, SPAN, v0={"q": SPEEDS}, t_eval=ROWS, **TIGHT)
    for k in range(0, COUNT, 4):
        check_alike(runs[k], system.simulate(SPAN, v0={"q": SPEEDS[k]}, t_eval=ROWS, **TIGHT))


@pytest.mark.parametrize("rows", [None, ROWS])
def test_the_bits_are_the_members_own(swing, link, turning, loop, rows):
    """Whatever lane, neighbours, order and number of threads; alone, too."""
    springs, weights = {"parameters": {"K1": 0.5 + SPEEDS / 6}}, {"parameters": {"g": 5.0 + SPEEDS}}
    for system, given in ((swing, {"v0": {"q": SPEEDS}}), (link, springs), (turning, springs), (loop, weights)):
        ((kind, table),) = given.items()
        ((name, values),) = table.items()
        first = bits(simulate_ensemble(system, SPAN, **given, t_eval=rows, workers=1))
        order = np.random.default_rng(2).permutation(COUNT)
        other = bits(simulate_ensemble(system, SPAN, **{kind: {name: values[order]}}, t_eval=rows, workers=3))
        assert [first[k] for k in order] == other
        for k in (0, 8, COUNT - 1):
            assert bits(simulate_ensemble(system, SPAN, **{kind: {name: values[k]}}, t_eval=rows)) == first[k : k + 1]


def test_what_a_lane_cannot_do_is_done_number_by_number(swing):
    """Refused, not finite, too many steps, an input that moves: as `simulate` has them, bit for bit."""
    ramp = Signal([0.0, 2.0], [0.0, 1.0])
    inputs = [0.0] * COUNT
    inputs[5] = ramp
    parameters = {"m": np.ones(COUNT), "k": np.full(COUNT, 400.0), "g": np.full(COUNT, 9.81)}
    parameters["m"][2], parameters["k"][9], parameters["k"][11] = -1.0, -1.0, 1e10
    options = {"t_eval": ROWS, "max_steps": 2000, **TIGHT}
    runs = simulate_ensemble(swing, SPAN, parameters=parameters, inputs={"u": inputs}, v0={"q": SPEEDS}, **options)
    sound = simulate_ensemble(swing, SPAN, v0={"q": SPEEDS}, **options)
    odd = {
        2: StopReason.START_REFUSED,
        5: StopReason.FINISHED,
        9: StopReason.NON_FINITE_STATE,
        11: StopReason.TOO_MANY_STEPS,
    }
    assert {k: runs.stop[k] for k in odd} == odd
    term = " log(k + 0.5) in forces[r] has no finite value or derivative, where k + 0.5 = -0.5."  # of single runs only
    for k in (5, 9, 11):
        given = {name: values[k] for name, values in parameters.items()}
        alone = swing.simulate(SPAN, parameters=given, inputs={"u": inputs[k]}, v0={"q": SPEEDS[k]}, **options)
        message = runs.message(k) + (term if k == 9 else "")
        assert (runs.stop[k], message, runs.nfev[k]) == (alone.stop, alone.message, alone.nfev)
        assert np.array_equal(runs[k].y, alone.y)
    assert [one for k, one in enumerate(bits(runs)) if k not in odd] == [
        one for k, one in enumerate(bits(sound)) if k not in odd
    ]


@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-12])
def test_any_tolerance_serves(link, rtol):
    runs = simulate_ensemble(link, SPAN, parameters={"K1": [0.5, 1.0]}, rtol=rtol, atol=rtol)
    for k, spring in enumerate((0.5, 1.0)):
        check_alike(runs[k], link.simulate(SPAN, parameters={"K1": spring}, rtol=rtol, atol=rtol, t_eval=[SPAN[1]]))


def test_a_run_in_each_lane_is_chosen_before_nodes_in_them(swing):
    assert swing.compiled.lane_groups == (swing.compiled.lanes > 1)
    found = simulate_ensemble(swing, SPAN, v0={"q": SPEEDS}, method="auto", rtol=1e-9)
    assert found.method == ("dop853" if swing.compiled.lanes > 1 else swing.simulate(SPAN, method="auto").method)


def test_where_lanes_do_not_pay_they_are_not_chosen(loop):
    at_rest = {"parameters": {"density": [1.0, 2.0]}, "method": "auto"}
    assert simulate_ensemble(loop, (0.0, 0.01), rtol=1e-8, **at_rest).method == "dop853"
    alone = loop.simulate((0.0, 0.01), rtol=1e-11, method="auto").method
    assert simulate_ensemble(loop, (0.0, 0.01), rtol=1e-11, **at_rest).method == alone


def test_a_lane_that_stability_holds_back_says_so():
    stiff = system_for(damped_link(), formulation="lagrange")
    runs = simulate_ensemble(stiff, (0.0, 0.02), parameters={"g": [9.0, 9.81]}, rtol=1e-5)
    alone = stiff.simulate((0.0, 0.02), parameters={"g": 9.0}, rtol=1e-5, t_eval=[0.02])
    assert runs.message(0) == alone.message
    assert "The scene is stiff" in runs.message(0)
    check_alike(runs[0], alone)


def test_unstabilised_and_other_methods_are_run_number_by_number(link):
    for options in ({"stabilisation": "none"}, {"method": "dopri5"}, {"dependent_constraints": "least_norm"}):
        runs = simulate_ensemble(link, SPAN, parameters={"K1": [0.5, 1.0]}, **options)
        alone = link.simulate(SPAN, parameters={"K1": 0.5}, **options)
        assert np.array_equal(runs.y[0, :, 0], alone.y[:, -1])


def press_ctrl_c(after: float) -> None:
    """After so many seconds of this process's own, which are as many steps wherever others use the machine."""
    start = time.process_time()
    while time.process_time() - start < after:
        time.sleep(0.01)
    kill(getpid(), signal.SIGINT)


@pytest.mark.parametrize("formulation", ["inverse", "eigenfactor"])
def test_ctrl_c_ends_lanes(formulation, request):
    link = request.getfixturevalue({"inverse": "link", "eigenfactor": "turning"}[formulation])
    threading.Thread(target=press_ctrl_c, args=(1.0,)).start()
    start = time.process_time()
    springs = np.linspace(0.5, 2.0, COUNT)
    runs = simulate_ensemble(link, (0.0, 1e7), parameters={"K1": springs}, max_steps=10**12, workers=1)
    assert time.process_time() - start < 20
    assert set(runs.stop) == {StopReason.INTERRUPTED}
    assert (runs.t_end > 0).sum() >= 2  # by chance: far out some begin anew, or wait for the other lane group
    assert np.isnan(runs.x).all()
