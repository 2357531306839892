"""Many runs as one call: the same motions as run by run, bit for bit, and failures that are one member's own."""

import os
import pickle
import signal
import threading
import time

import numpy as np
import pytest
from sympy import cos, log, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Event, Model, Signal, StopReason, simulate_ensemble
from eigenmotion.batch import memory
from eigenmotion.runtime.ensemble import Chunk, Stop

from ..support.generation import system_for, system_of

Q, R, U = dynamicsymbols("q r u")
M, K, G = symbols("m k g")
SWING = Model(
    name="swing_by",
    coordinates=[Q, R],
    kinetic_energy=M * (R.diff() ** 2 + R**2 * Q.diff() ** 2) / 2,
    potential_energy=K * (R - 1) ** 2 / 2 - M * G * R * cos(Q),
    forces={Q: U * R, R: log(K + 0.5)},
    inputs={U: 0.0},
    outputs={"height": -R * cos(Q), "pull": R.diff(em.t, 2)},
    events={"lowest": sin(Q), "over": Event(cos(Q) + 0.9, terminal=True)},
    parameters={M: 1.0, K: 400.0, G: 9.81},
    initial={Q: 0.5, R: 1.2},
)
SPAN, ROWS = (0.0, 2.0), np.linspace(0.0, 2.0, 5)
TIGHT = {"rtol": 1e-8, "atol": 1e-8}
TOLD = ("nfev", "nsteps", "nrejected", "n_bounded", "n_stiff", "njev", "nlu", "stop", "message", "status", "method")
SPEEDS = np.linspace(0.0, 9.0, 13)  # the fast ones go over the top


@pytest.fixture(scope="module")
def swing() -> em.System:
    return system_for(SWING, "lagrange")


def same(one: em.Solution, other: em.Solution) -> bool:
    names = ("t", "y", "x", "v", "energy", "multipliers")
    arrays = all(np.array_equal(one[name], other[name], equal_nan=True) for name in names)
    events = zip([*one.t_events, *one.y_events], [*other.t_events, *other.y_events], strict=True)
    told = all(one[name] == other[name] for name in TOLD)
    outputs = all(np.array_equal(one.outputs[name], other.outputs[name]) for name in one.outputs)
    return set(one) == set(other) and arrays and told and outputs and all(np.array_equal(*pair) for pair in events)


@pytest.mark.parametrize(("method", "rtol", "count"), [("dop853", 1e-8, 13), ("ra15", 1e-8, 13), ("radau5", 1e-5, 13)])
def test_each_member_is_the_run_that_simulate_makes(swing, method, rtol, count):
    masses, speeds = np.linspace(1.0, 2.0, count), np.linspace(0.0, 9.0, count)
    push = Signal([0.0, 1.0, 2.0], [0.0, 1.0, 0.0])
    given = {"t_eval": ROWS, "method": method, "inputs": {"u": push}, "rtol": rtol, "atol": rtol}
    runs = simulate_ensemble(swing, SPAN, parameters={"m": masses}, v0={Q: speeds}, workers=2, **given)
    alone = [swing.simulate(SPAN, parameters={"m": m}, v0={Q: v}, **given) for m, v in zip(masses, speeds, strict=True)]
    assert len(runs) == count
    assert all(same(one, other) for one, other in zip(runs, alone, strict=True))
    assert set(runs.stop) == {StopReason.FINISHED, StopReason.TERMINAL_EVENT}
    for k, run in enumerate(alone):
        rows = len(run.t)
        for name in ("x", "v", "multipliers", "energy"):
            assert np.array_equal(getattr(runs, name)[k][..., :rows], run[name])
        assert np.array_equal(runs.outputs["pull"][k, :rows], run.outputs["pull"])
        assert np.isnan(runs.x[k, :, rows:]).all()
        assert np.isnan(runs.energy[k, rows:]).all()
    assert runs.x.shape == (count, 2, 5)
    assert runs.multipliers.shape == (count, 0, 5)


def test_only_the_end_is_kept_where_no_rows_are_asked_for(swing):
    runs = simulate_ensemble(swing, SPAN, v0={"q": SPEEDS}, **TIGHT)
    assert runs.x.shape == (13, 2, 1)
    for k, speed in enumerate(SPEEDS):
        alone = swing.simulate(SPAN, v0={"q": speed}, **TIGHT)
        assert np.array_equal(runs.x[k, :, 0], alone.x[:, -1])
        assert runs.t_end[k] == alone.t[-1] == runs[k].t[-1]
        assert runs.energy[k, 0] == alone.energy[-1]
    assert (runs.t_end < 2.0).any()


def bits(runs: em.Ensemble) -> list[bytes]:
    arrays = (runs.x, runs.v, runs.energy, runs.t_end, runs.nfev, *runs.outputs.values())
    return [b"".join(np.ascontiguousarray(array[k]).tobytes() for array in arrays) for k in range(len(runs))]


def test_the_same_bits_whatever_the_order_and_the_number_of_workers(swing):
    order = np.random.default_rng(1).permutation(13)
    first = bits(simulate_ensemble(swing, SPAN, v0={"q": SPEEDS}, t_eval=ROWS, workers=1))
    for workers in (1, 2, 5):
        other = bits(simulate_ensemble(swing, SPAN, v0={"q": SPEEDS[order]}, t_eval=ROWS, workers=workers))
        assert [first[k] for k in order] == other
    assert bits(simulate_ensemble(swing, SPAN, v0={"q": SPEEDS[3]}, t_eval=ROWS)) == first[3:4]


def test_one_input_for_each_member(swing):
    pushes = [0.5, Signal([0.0, 2.0], [0.0, 1.0]), ([0.0, 1.0, 2.0], [1.0, 0.0, 1.0])]
    runs = simulate_ensemble(swing, SPAN, inputs={"u": pushes}, t_eval=ROWS)
    assert all(same(runs[k], swing.simulate(SPAN, inputs={"u": u}, t_eval=ROWS)) for k, u in enumerate(pushes))
    assert not np.array_equal(runs.outputs["pull"][0], runs.outputs["pull"][1])
    held = simulate_ensemble(swing, SPAN, inputs={"u": np.array([0.5, 0.7])}, t_eval=ROWS)
    assert same(held[0], runs[0])
    short = simulate_ensemble(swing, SPAN, inputs={"u": [0.5, Signal([0.0, 1.0], [0.0, 1.0])]})
    assert (list(short.failed), short.stop[1]) == ([1], StopReason.START_REFUSED)
    assert "input 'u' is sampled on [0, 1]" in short.message(1)


def failing(count: int) -> tuple[dict[str, np.ndarray], dict[int, StopReason]]:
    """Parameters and starts, some of which fail in four ways; member -> how."""
    ways = {"m": (-1.0, StopReason.START_REFUSED), "k": (-1.0, StopReason.START_REFUSED),
            "g": (np.nan, StopReason.START_REFUSED), "r": (0.0, StopReason.START_REFUSED)}  # fmt: skip
    given = {"m": np.ones(count), "k": np.full(count, 400.0), "g": np.full(count, 9.81), "r": np.full(count, 1.2)}
    wrong = {}
    for place, (name, (value, stop)) in zip(range(0, count, count // 4), ways.items(), strict=False):
        given[name][place], wrong[place] = value, stop
    return given, wrong


def test_a_member_that_fails_is_named_and_costs_the_others_nothing(swing):
    given, wrong = failing(16)
    wrong[4] = StopReason.NON_FINITE_STATE  # log(k + 0.5)
    radii = given.pop("r")
    runs = simulate_ensemble(swing, SPAN, parameters=given, x0={"r": radii}, t_eval=ROWS)
    sound = simulate_ensemble(swing, SPAN, t_eval=ROWS)
    assert list(runs.failed) == sorted(wrong)
    assert {k: runs.stop[k] for k in wrong} == wrong
    assert all(np.array_equal(runs.x[k], sound.x[0]) for k in range(16) if k not in wrong)
    assert np.isnan(runs.x[runs.failed][:, :, 1:]).all()
    words = {
        0: "not positive definite",
        4: "not finite",
        8: "parameter 'g' is not a finite number",
        12: "not positive definite",
    }
    assert all(text in runs.message(k) for k, text in words.items())
    assert "4 failed (1 non-finite state, 3 start refused)" in repr(runs)
    for k in wrong:
        assert (runs[k].success, runs[k].message, runs[k].x.shape[0]) == (False, runs.message(k), 2)
        assert set(runs[k]) == set(runs[1])
        assert (runs[k].drawing, runs[k].method) == (None, "dop853")


def test_the_method_is_chosen_once_for_all(swing):
    together = simulate_ensemble(swing, SPAN, v0={"q": [0.0, 1.0]}, method="auto", rtol=1e-9)
    least_norm = simulate_ensemble(swing, SPAN, method="auto", rtol=1e-9, dependent_constraints="least_norm")
    alone = swing.simulate(SPAN, method="auto", rtol=1e-9, dependent_constraints="least_norm")
    assert together.method == together[1].method
    assert swing.simulate(SPAN, v0={"q": 1.0}, method=together.method, rtol=1e-9).nfev == together.nfev[1]
    assert least_norm.method == alone.method


def test_words_of_a_refused_start_are_those_of_simulate():
    system = system_of("four_bar", "lagrange")
    angles = system.initial[0][0] + np.array([0.0, 0.3])
    runs = simulate_ensemble(system, (0.0, 0.2), x0={"q1": angles})
    with pytest.raises(em.ModelError) as caught:
        system.simulate((0.0, 0.2), x0={"q1": angles[1]})
    assert (list(runs.failed), runs.message(1)) == ([1], str(caught.value))
    assert runs.multipliers.shape == (2, 2, 1)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"parameters": {"mass": [1.0]}}, "known: m, k, g"),
        ({"parameters": {"m": [1.0, 2.0]}, "x0": {"q": [1.0, 2.0, 3.0]}}, "differ in length (parameter 'm': 2, "),
        ({"parameters": {"m": []}}, "parameter 'm' is empty"),
        ({"parameters": {"m": np.ones((2, 2))}}, "has shape (2, 2)"),
        ({"parameters": {"m": np.inf}}, "parameter 'm' is not a finite number"),
        ({"x0": np.ones((3, 5))}, "rows of 5 numbers, but 2 are needed: q, r"),
        ({"workers": 0}, "workers is 0"),
        ({"workers": True}, "workers is True"),
        ({"executor": "dask"}, "executor is 'dask'"),
        ({"dense_output": True}, "unknown option 'dense_output'"),
        ({"y0": [0.0]}, "x0"),
        ({"t_eval": [0.0, 3.0]}, "3 is outside t_span"),
        ({"inputs": {"u": np.array([0.0, np.nan])}}, "input 'u' of member 1"),
        ({"inputs": {"u": ([0.0, 1.0], [0.0, 1.0])}}, "does not cover t_span"),
    ],
)
def test_what_no_member_can_be_is_refused_before_the_runs(swing, options, words):
    with pytest.raises(em.ModelError) as caught:
        simulate_ensemble(swing, SPAN, **options)
    assert words in str(caught.value)


def test_rows_that_do_not_fit_are_refused_before_they_are_taken(swing, monkeypatch):
    with pytest.raises(em.ModelError, match=r"100000 runs with 1000000 rows of 4 numbers take .* GB"):
        simulate_ensemble(swing, SPAN, x0={"q": np.full(10**5, 0.5)}, t_eval=np.linspace(*SPAN, 10**6))
    assert memory.available() > 10**6
    monkeypatch.setattr(memory, "available", lambda: None)
    assert len(simulate_ensemble(swing, (0.0, 0.1), x0={"q": [0.1, 0.2]})) == 2


def test_ensembles_travel():
    system = system_of("pendulum", "lagrange")
    runs = simulate_ensemble(system, (0.0, 1.0), x0={system.coordinates[0]: [0.1, 0.2]})
    assert runs.swept.keys() == {f"{system.coordinates[0]}(0)"}
    with pytest.raises(TypeError, match="capsule alone"):  # compiled for tests, without a way to build it
        pickle.dumps(runs)


def test_ctrl_c_returns_what_is_done(swing):
    slow = np.full(40, 1.0)
    for workers in (1, 2):
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        start = time.monotonic()
        runs = simulate_ensemble(
            swing, (0.0, 1e7), parameters={"m": slow, "g": 1e-3}, x0={"r": 1.0}, max_steps=10**9,
            workers=workers,
        )  # fmt: skip
        assert time.monotonic() - start < 20
        assert len(runs) == 40
        assert StopReason.INTERRUPTED in runs.stop
        assert np.isnan(runs.x[runs.failed]).all()


def test_a_stop_that_was_asked_for_keeps_members_from_starting(swing):
    stop = Stop()
    stop.set()
    runs = simulate_ensemble(swing, SPAN, x0={"q": [0.1, 0.2]})
    chunk = Chunk(runs._common, runs._members, stop)
    assert {tuple(StopReason)[k] for k in chunk.status} == {StopReason.INTERRUPTED}
    assert not np.isfinite(chunk.y).any()


def test_an_ensemble_is_a_dataset_with_names(swing):
    pytest.importorskip("xarray")
    masses = np.array([1.0, 2.0, -1.0])
    runs = simulate_ensemble(swing, SPAN, parameters={"m": masses}, v0={"q": masses}, t_eval=ROWS)
    found = runs.to_xarray()
    assert dict(found.sizes) == {"run": 3, "coordinate": 2, "time": 5}
    assert np.array_equal(found.x.sel(coordinate="r", run=1), runs.x[1, 1])
    assert found["m"].dims == ("run",)
    assert found.coords["q'(0)"].to_numpy().tolist() == masses.tolist()
    assert found.stop.to_numpy().tolist() == ["finished", "finished", "start refused"]
    assert np.array_equal(found["height"], runs.outputs["height"], equal_nan=True)
    assert found.attrs["model"] == "swing_by"


def test_arrays_that_are_aligned_to_nothing_serve(swing):
    """As those are that came over a network."""
    y = np.array([0.1, 1.2, 0.3, 0.4])
    crooked = np.frombuffer(b"." + y.tobytes(), dtype=np.float64, offset=1)
    assert not crooked.flags.aligned
    assert np.array_equal(swing.rhs(0.0, crooked), swing.rhs(0.0, y))
