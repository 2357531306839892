"""simulate on a model written by hand: methods, inputs, how runs end, mistakes."""

import os
import signal
import threading
import time

import numpy as np
import pytest
from eigenmotion.codegen.model import ModelError
from scipy.interpolate import CubicSpline

from eigenmotion.arguments.methods import METHODS
from eigenmotion.arguments.signals import Signal
from eigenmotion.results.solution import Solution
from eigenmotion.runtime import StopReason
from eigenmotion.simulation.simulate import simulate

from ..support.hand_written import bead
from ..support.hand_written.swing import START, TIGHT, L, pendulum


@pytest.mark.parametrize("method", [*METHODS, "DOP853"])
def test_follows_the_pendulum(method):
    t = np.linspace(0, 3, 31)
    found = simulate(bead(), (0, 3), **START, rtol=1e-8, atol=1e-10, t_eval=t, method=method)
    np.testing.assert_array_equal(found.t, t)
    np.testing.assert_allclose(found.x, pendulum(t), atol=2e-6)


def test_backwards_is_the_mirror_of_forwards():
    there = bead().simulate((0, 2), **START, **TIGHT)
    back = bead().simulate((2, 0), x0=there.x[:, -1], v0=there.v[:, -1], **TIGHT)
    np.testing.assert_allclose(back.x[:, -1], START["x0"], atol=1e-8)
    assert back.t[-1] == 0


@pytest.mark.parametrize("kind", ["hold", "linear", "cubic"])
def test_inputs_are_signals(kind):
    times, values = np.linspace(0, 3, 7), np.array([0, 3, -2, 5, 1, -4, 2.0])
    u = Signal(times, values, kind)
    truth = {
        "hold": lambda t: values[np.minimum((t / 0.5).astype(int), 6)],
        "linear": lambda t: np.interp(t, times, values),
        "cubic": CubicSpline(times, values),
    }[kind]
    t = np.linspace(0, 3, 40)
    found = bead().simulate((0, 3), **START, **TIGHT, t_eval=t, inputs={"push": u})
    loose = 1e-3 if kind == "hold" else 1e-8  # the reference steps over the jumps of "hold"
    np.testing.assert_allclose(found.x, pendulum(t, lambda t: truth(np.asarray(t))), atol=loose)
    np.testing.assert_allclose(found.outputs["push_seen"], truth(t), atol=1e-12)


def test_a_pair_of_samples_is_linear():
    samples = [0, 1], [0, 4]
    pair = bead().simulate((0, 1), **START, inputs={"push": samples})
    np.testing.assert_array_equal(pair.y, bead().simulate((0, 1), **START, inputs={"push": Signal(*samples)}).y)


def test_a_terminal_event_ends_the_run():
    found = bead().simulate((0, 5), x0=[0, -L], v0=[8.0, 0], rtol=1e-9)
    assert (found.stop, found.status, found.success) == (StopReason.TERMINAL_EVENT, 1, True)
    assert found.t[-1] == found.t_events[1][0]
    np.testing.assert_allclose(found.x[:, -1], [L, 0], atol=1e-9)


def test_too_many_steps_keeps_what_was_computed():
    found = bead().simulate((0, 5), **START, max_steps=7)
    assert (found.stop, found.status, found.success) == (StopReason.TOO_MANY_STEPS, -1, False)
    assert 0 < found.t[-1] < 5
    assert "max_steps" in found.message
    assert found.energy.size == found.t.size


def test_ctrl_c_ends_a_run_within_a_tenth_of_a_second():
    system, sent = bead(), []

    def press() -> None:
        sent.append(time.process_time())  # does not go on while others have the processor
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(0.3, press)
    timer.start()
    found = system.simulate((0, 1e9), **START, max_steps=10**12, t_eval=[0.0, 1.0])
    assert time.process_time() - sent[0] < 0.1
    assert (found.stop, found.success) == (StopReason.INTERRUPTED, False)
    assert found.t.size == 2


def test_other_exceptions_of_signal_handlers_are_raised():
    def complain(*_: object) -> None:
        raise TimeoutError

    before = signal.signal(signal.SIGALRM, complain)
    signal.setitimer(signal.ITIMER_REAL, 0.2)
    try:
        with pytest.raises(TimeoutError):
            bead().simulate((0, 1e9), **START, max_steps=10**12, t_eval=[0.0])
    finally:
        signal.signal(signal.SIGALRM, before)


def test_threads_run_side_by_side():
    alone = bead().simulate((0, 20), **START)
    found: list[Solution] = []
    threads = [threading.Thread(target=lambda: found.append(bead().simulate((0, 20), **START))) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for other in found:
        np.testing.assert_array_equal(other.y, alone.y)


def test_stiff_methods_follow_the_same_pendulum():
    t = np.linspace(0, 2, 9)
    for method in ("radau5", "radau9"):
        found = bead().simulate((0, 2), **START, method=method, rtol=1e-7, t_eval=t, dense_output=True)
        np.testing.assert_allclose(found.x, pendulum(t), atol=1e-4)
        np.testing.assert_allclose(found.sol(t), found.y)
        assert found.multipliers.shape == (1, 9)
        assert found.success


def test_stiff_methods_stop_at_the_samples_of_held_inputs():
    push = {"push": Signal([0, 0.5, 0.501], [0.0, 4000.0, 0.0], "hold")}  # an impulse of 4: narrow enough to step over
    options = {**START, "inputs": push, "rtol": 1e-8}
    compiled, stiff = bead().simulate((0, 1), **options), bead().simulate((0, 1), **options, method="radau5")
    assert 0.501 in stiff.t
    np.testing.assert_allclose(stiff.x[:, -1], compiled.x[:, -1], atol=1e-4)
    assert abs(compiled.x[0, -1] - bead().simulate((0, 1), **START).x[0, -1]) > 0.1


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"x0": [1, 0]}, r"x0 is off holonomic constraint row 0 by -0\.625.*x0 = \[1\.5, 0\]"),
        ({"v0": {"x": 2, "y": 1}}, r"v0 .*row 0 by 3\..*project_initial_state.*v0 = \[0, 1\]"),
        ({"x0": [np.nan, 0]}, "'x' is not a finite number"),
        ({"parameters": {"m": 0}}, "not positive definite at coordinate 'x'"),
        ({"parameters": {"mass": 0}}, "known: m, g, l"),
        ({"inputs": {"pushh": 0}}, "Did you mean 'push'"),
        ({"inputs": {"push": ([0, 0.5], [1, 1])}}, "does not cover"),
        ({"inputs": {"push": ([0, 1, 1], [1, 1, 1])}}, "'push'.*increase"),
        ({"inputs": {"push": "hard"}}, "'push'"),
        ({"t_eval": [0.5, 2]}, "outside t_span"),
        ({"t_eval": [0.5, 0.2]}, "increase"),
        ({"t_eval": [0.5, np.nan]}, "not finite"),
        ({"t_eval": [-np.inf, 0.5]}, "not finite"),
        ({"rtol": -1}, "rtol"),
        ({"atol": -1}, "atol of 'x'"),
        ({"atol": {"z": 1}}, "known: x, y"),
        ({"rtol": 0, "atol": {"y": 0}}, "both 0"),
        ({"first_step": 0}, "first_step"),
        ({"max_step": -1}, "max_step"),
        ({"max_steps": 0}, "max_steps"),
        ({"method": "dop583"}, "Did you mean 'dop853'"),
        ({"stabilisation": "projects"}, "Did you mean 'project'"),
        ({"dependent_constraints": "ignore"}, "refuse, least_norm"),
        ({"rtoll": 1e-3}, "Did you mean 'rtol'"),
    ],
)
def test_mistakes_are_named_before_the_run(options, words):
    with pytest.raises(ModelError, match=words):
        bead().simulate((0, 1), **options)


@pytest.mark.parametrize("span", [(0, np.inf), (1, np.nan), (0,), (0, 1, 2), "ab", 3])
def test_bad_spans(span):
    with pytest.raises(ModelError, match="t_span"):
        bead().simulate(span)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("t_eval", [None, [1.0], []])
def test_a_run_of_no_length_ends_at_once(method, t_eval):
    near = {"x0": START["x0"] * (1 + 1e-8), "v0": [0.0, 0.0]}
    first = bead().simulate((1, 2), **near, method=method)
    found = bead().simulate((1, 1), **near, method=method, t_eval=t_eval, dense_output=True)
    assert (found.stop, found.status, found.success) == (StopReason.FINISHED, 0, True)
    assert (found.nfev, found.nsteps, found.nrejected) == (0, 0, 0)
    assert [t.size for t in found.t_events] == [0, 0]
    np.testing.assert_array_equal(found.t, [1.0] if t_eval is None else t_eval)
    np.testing.assert_array_equal(found.y, first.y[:, :1] if found.t.size else np.empty((4, 0)))
    assert found.energy.shape == found.t.shape
    if found.t.size:
        np.testing.assert_array_equal(found.sol([1.0, 1.0]), first.y[:, [0, 0]])
        with pytest.raises(ValueError, match="outside"):
            found.sol(1.5)


@pytest.mark.parametrize("options", [{"t_eval": [1.0, 1.0]}, {"t_eval": [1.5]}, {"first_step": 0.1}])
def test_a_run_of_no_length_has_options_of_no_length(options):
    with pytest.raises(ModelError, match=r"increase|outside|first_step"):
        bead().simulate((1, 1), **START, **options)


def test_a_run_of_no_length_has_no_error_to_estimate():
    found = bead().simulate((1, 1), **START, estimate_error=True)
    assert "no rows to compare" in found.error_estimate.message


def test_unknown_options_are_type_errors_too():
    with pytest.raises(TypeError, match="rtoll"):
        bead().simulate((0, 1), rtoll=1)


@pytest.mark.parametrize(
    ("given", "ours"),
    [({"y0": [0, 1]}, "x0 and v0"), ({"args": ()}, "parameters="), ({"events": []}, r"Model\(events=")],
)  # fmt: skip
def test_words_of_solve_ivp_are_answered_with_ours(given, ours):
    with pytest.raises(ModelError, match=rf"of SciPy: .*{ours}"):
        bead().simulate((0, 1), **given)


def test_tolerance_of_a_coordinate_counts():
    fine = bead().simulate((0, 1), **START, rtol=1e-12, atol={"x": 1e-12, "y": 1e-12})
    half = bead().simulate((0, 1), **START, rtol=1e-12, atol={"x": 1e-12, "y": 10.0})
    coarse = bead().simulate((0, 1), **START, rtol=1e-12, atol=10.0)
    assert fine.nsteps >= half.nsteps > coarse.nsteps
