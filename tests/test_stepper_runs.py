"""Events, signals and the ways a run of `em_stepper.h` ends."""

import itertools
import math
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from .stepping import (
    CIRCLE,
    CONSTANT,
    CUBIC,
    DRIVEN,
    FINISHED,
    FREE_FALL,
    HOLD,
    INTERRUPTED,
    LINEAR,
    METHODS,
    NON_FINITE_STATE,
    OUT_OF_MEMORY,
    PENDULUM,
    POSITION_NOT_REACHED,
    SAMPLES,
    SINGULAR_MASS_MATRIX,
    STEP_SIZE_UNDERFLOW,
    TERMINAL_EVENT,
    TOO_MANY_STEPS,
    TWO_MODES,
    Build,
    Mechanism,
    Result,
    Signal,
    builder,
    compiler_command,
    numbers,
    pendulum_angle,
    sampled,
    signal,
    simulate,
)


@pytest.fixture(scope="module")
def build(tmp_path_factory: pytest.TempPathFactory) -> Build:
    return builder(tmp_path_factory.mktemp("mechanisms"))


# --- events -----------------------------------------------------------------------------------------------------------


def falling(build: Build, events: str, n_events: int, span: tuple[float, float] = (0.0, 3.0), **options: Any) -> Result:
    """x = t - t^2 / 2, which every method integrates exactly."""
    return simulate(build(replace(FREE_FALL, events=events, n_events=n_events)), [0.0, 1.0], span, **options)


@pytest.mark.parametrize("method", METHODS)
def test_events_are_located_to_rounding(build: Build, method: str) -> None:
    result = falling(build, "g[0] = x[0] - 0.375; g[1] = exp(v[0]) - 2.0;", 2, method=method, max_step=0.37)
    np.testing.assert_allclose(result.event_times(0), [0.5, 1.5], rtol=1e-14)
    np.testing.assert_allclose(result.event_times(1), [1.0 - math.log(2.0)], rtol=1e-14)
    _, rows = result.table(result.run.events[0])
    np.testing.assert_allclose(rows, [[0.375, 0.375], [0.5, -0.5]], rtol=1e-14)


def test_directions_are_those_of_the_run(build: Build) -> None:
    events = "g[0] = g[1] = g[2] = x[0] - 0.375;"
    for span in ((0.0, 3.0), (2.0, -1.0)):
        y0 = [span[0] - span[0] ** 2 / 2, 1.0 - span[0]]
        compiled = build(replace(FREE_FALL, events=events, n_events=3))
        result = simulate(compiled, y0, span, direction=[0, 1, -1], max_step=0.37)
        both, up, down = (result.event_times(i) for i in range(3))
        first, second = (0.5, 1.5) if span[1] > span[0] else (1.5, 0.5)
        np.testing.assert_allclose(both, [first, second], rtol=1e-13)
        np.testing.assert_allclose(up, [first], rtol=1e-13)
        np.testing.assert_allclose(down, [second], rtol=1e-13)


def test_a_zero_at_the_start_does_not_fire(build: Build) -> None:
    assert falling(build, "g[0] = x[0];", 1, max_step=0.3).event_times(0) == pytest.approx([2.0], rel=1e-14)


def test_events_of_one_step_come_in_order_and_a_terminal_one_stops(build: Build) -> None:
    events = "g[0] = t - 2.5; g[1] = t - 2.0; g[2] = t - 1.0; g[3] = t - 1.5;"
    options: dict[str, Any] = {"first_step": 3.0, "terminal": [1, 1, 0, 0], "method": "rk34"}
    result = falling(build, events, 4, **options)
    assert result.status == TERMINAL_EVENT
    assert [result.event_times(i).tolist() for i in range(4)] == [[], [2.0], [1.0], [1.5]]
    assert result.run.t_reached == 2.0
    np.testing.assert_allclose(result.t, [0.0, 2.0])
    np.testing.assert_allclose(result.y[:, -1], [0.0, -1.0], atol=1e-15)
    result = falling(build, events, 4, t_eval=np.arange(0.0, 3.1, 0.25), **options)
    np.testing.assert_array_equal(result.t, np.arange(0.0, 2.1, 0.25))


def test_an_event_on_the_settled_trajectory(build: Build) -> None:
    """The angle of a settled circle is found where the angle is, though steps are loose."""
    compiled = build(replace(CIRCLE, events="g[0] = y_angle(x);", n_events=1, preamble=ANGLE))
    result = simulate(compiled, [1.0, 0.0, 0.0, 1.0], (0.0, 3.0), rtol=1e-5, atol=1e-5)
    t, y = result.table(result.run.events[0])
    assert t == pytest.approx([1.0], abs=1e-4)
    assert math.atan2(y[1, 0], y[0, 0]) == pytest.approx(1.0, abs=1e-15)
    assert math.hypot(y[0, 0], y[1, 0]) == pytest.approx(1.0, abs=3e-16)


ANGLE = "static double y_angle(const double *x) { return atan2(x[1], x[0]) - 1.0; }"


def test_a_jump_of_a_signal_fires_at_its_sample(build: Build) -> None:
    compiled = build(replace(DRIVEN, events="g[0] = u[0] - 0.5;", n_events=1))
    held = signal(HOLD, [0.0, 1.25, 2.0], [0.0, 1.0, 0.0])
    result = simulate(compiled, [0.0, 0.0], (0.0, 3.0), inputs=[held])
    np.testing.assert_allclose(result.event_times(0), [1.25, 2.0], rtol=1e-14)


# --- signals ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("kind", [HOLD, LINEAR, CUBIC])
@pytest.mark.parametrize("span", [(0.0, 3.0), (3.0, 0.0), (0.7, 1.9)])
def test_sampled_signals(build: Build, method: str, kind: int, span: tuple[float, float]) -> None:
    given, u = sampled(kind, span)
    longest = (
        0.02 if kind == CUBIC else math.inf
    )  # a spline's third derivative jumps at samples, where steps need not end
    options: dict[str, Any] = {"rtol": 1e-11, "atol": 1e-11, "max_step": longest}
    result = simulate(build(DRIVEN), [0.2, -0.1], span, method, inputs=[given], **options)
    v, x = u.antiderivative(1), u.antiderivative(2)
    exact_v = -0.1 + v(result.t) - v(span[0])
    exact_x = 0.2 + (-0.1 - v(span[0])) * (result.t - span[0]) + x(result.t) - x(span[0])
    tolerance = 1e-9 if kind == CUBIC else 1e-13
    np.testing.assert_allclose(result.y, [exact_x, exact_v], atol=tolerance)
    ends = SAMPLES[[0, -1]] if kind == CUBIC else SAMPLES
    assert set(ends[(ends > min(span)) & (ends < max(span))]) <= set(result.t)
    assert kind == CUBIC or result.run.n_rejected == 0


def test_a_constant_signal(build: Build) -> None:
    value = numbers([0.75])
    result = simulate(
        build(DRIVEN), [0.0, 0.0], (0.0, 4.0), inputs=[(Signal(CONSTANT, 0, None, value.ctypes.data), value)]
    )
    np.testing.assert_allclose(result.y, [0.375 * result.t**2, 0.75 * result.t], atol=1e-13)


def test_a_step_cut_at_a_sample_does_not_shorten_the_next(build: Build) -> None:
    times = np.sort(np.concatenate([np.arange(20.0), np.arange(20.0) + 1e-9]))
    result = simulate(
        build(DRIVEN), [0.0, 0.0], (0.0, 20.0), inputs=[signal(LINEAR, times, np.ones(40))], first_step=5.0
    )
    np.testing.assert_allclose(result.y[0], 0.5 * result.t**2, rtol=1e-13)
    assert result.run.n_steps == 40


def test_one_sample_holds(build: Build) -> None:
    for kind in (HOLD, LINEAR):
        result = simulate(build(DRIVEN), [0.0, 0.0], (0.0, 4.0), inputs=[signal(kind, [1.0], [0.75])])
        np.testing.assert_allclose(result.y, [0.375 * result.t**2, 0.75 * result.t], atol=1e-13)


# --- how runs end -----------------------------------------------------------------------------------------------------


def test_too_many_steps_keeps_what_there_is(build: Build) -> None:
    result = simulate(build(PENDULUM), [2.0, 0.0], (0.0, 1e3), max_steps=25)
    assert result.status == TOO_MANY_STEPS
    assert result.run.n_steps == 25
    assert len(result.t) == result.run.n_steps + 1
    np.testing.assert_allclose(result.y[0], pendulum_angle(result.t, 2.0), atol=1e-7)


WALL = "if (y[0] > 1.0) {{ {0} }} dy[0] = y[1]; dy[1] = 0.0;"


def at_the_wall(build: Build, obstacle: str, **options: Any) -> Result:
    return simulate(build(Mechanism(rhs=WALL.format(obstacle))), [0.0, 1.0], (0.0, 3.0), **options)


@pytest.mark.parametrize("method", METHODS)
def test_a_fault_on_the_way_ends_the_run_where_it_sits(build: Build, method: str) -> None:
    result = at_the_wall(build, "return em_fail(fault, EM_SINGULAR_MASS_MATRIX, 3, -1, 0.5);", method=method)
    fault = result.run.fault
    assert (fault.status, fault.first, fault.second, fault.size) == (SINGULAR_MASS_MATRIX, 3, -1, 0.5)
    assert result.y[0, -1] == pytest.approx(1.0, abs=1e-12)
    np.testing.assert_allclose(result.y[0], result.t, rtol=1e-14)


@pytest.mark.parametrize("method", METHODS)
def test_values_that_are_not_finite(build: Build, method: str) -> None:
    for obstacle in ("dy[0] = dy[1] = NAN; return 0;", "dy[0] = 1.0; dy[1] = INFINITY; return 0;"):
        result = at_the_wall(build, obstacle, method=method)
        assert result.status == NON_FINITE_STATE
        assert result.y[0, -1] == pytest.approx(1.0, abs=1e-12)
        assert np.isfinite(result.y).all()


def test_a_step_that_cannot_be_short_enough(build: Build) -> None:
    result = simulate(build(Mechanism(rhs="dy[0] = y[1]; dy[1] = pow(fabs(1.0 - t), -1.5);")), [0.0, 1.0], (0.0, 3.0))
    assert result.status == STEP_SIZE_UNDERFLOW
    assert result.run.t_reached == pytest.approx(1.0, abs=1e-6)
    assert result.run.t_reached == result.t[-1]


def test_faults_at_the_start(build: Build) -> None:
    result = at_the_wall(build, "return 0;")
    assert result.status == FINISHED
    compiled = build(Mechanism(rhs=WALL.format("return em_fail(fault, EM_SINGULAR_MASS_MATRIX, 0, -1, 0.0);")))
    assert simulate(compiled, [2.0, 1.0], (0.0, 1.0)).status == SINGULAR_MASS_MATRIX
    assert simulate(compiled, [math.nan, 1.0], (0.0, 1.0)).status == NON_FINITE_STATE
    assert simulate(compiled, [0.0, math.inf], (0.0, 1.0)).status == NON_FINITE_STATE


def test_a_state_that_cannot_be_settled(build: Build) -> None:
    settle = "if (y[0] > 1.0) return em_fail(fault, EM_POSITION_NOT_REACHED, 0, -1, 1.0);"
    compiled = build(Mechanism(rhs="dy[0] = y[1]; dy[1] = 0.0;", settle=settle, settles=1))
    result = simulate(compiled, [0.0, 1.0], (0.0, 3.0))
    assert result.status == POSITION_NOT_REACHED
    assert result.t[-1] == pytest.approx(1.0, abs=1e-12)
    assert simulate(compiled, [1.5, 1.0], (0.0, 3.0)).status == POSITION_NOT_REACHED


def test_a_long_run_is_interrupted_within_a_tenth_of_a_second(build: Build) -> None:
    slow = "for (volatile int i = 0; i < 400000; ++i) {}" + PENDULUM.rhs
    for compiled in (build(PENDULUM), build(Mechanism(rhs=slow))):
        calls: list[float] = []
        busy = [time.process_time()]  # does not go on while others have the processor

        def poll(calls: list[float] = calls, busy: list[float] = busy) -> int:
            calls.append(time.perf_counter())
            busy.append(time.process_time())
            return len(calls) == 4

        begun = time.perf_counter()
        result = simulate(compiled, [2.0, 0.0], (0.0, 1e9), t_eval=[], max_steps=10**12, poll=poll)
        assert result.status == INTERRUPTED
        assert len(calls) == 4
        assert min(np.diff([begun, *calls])) > 0.015
        assert np.median(np.diff(busy)) < 0.1
        assert 0.0 < result.run.t_reached < 1e9


def test_rows_without_end_are_interrupted_too(build: Build) -> None:
    times = np.linspace(0.0, 1.0, 3_000_000)
    begun = time.process_time()
    result = simulate(build(PENDULUM), [2.0, 0.0], (0.0, 1.0), t_eval=times, first_step=1.0, poll=lambda: 1)
    assert result.status == INTERRUPTED
    assert time.process_time() - begun < 0.2
    assert result.t.size < times.size


LITTLE_MEMORY = """
#include <stdlib.h>
static int granted = GRANTED;
static void *sparing_realloc(void *block, size_t size) { return granted-- > 0 ? realloc(block, size) : NULL; }
#define realloc sparing_realloc
"""


@pytest.mark.parametrize(("granted", "rows"), [(0, 0), (1, 0), (2, 2), (3, 2), (4, 64), (5, 64)])
def test_no_memory_left(build: Build, granted: int, rows: int) -> None:
    compiled = build(replace(PENDULUM, preamble=LITTLE_MEMORY.replace("GRANTED", str(granted))))
    result = simulate(compiled, [2.0, 0.0], (0.0, 500.0), dense=1)
    assert result.status == OUT_OF_MEMORY
    assert len(result.t) == rows
    assert result.run.n_dense == max(0, rows - 1 if rows > 2 else 0)


# --- use --------------------------------------------------------------------------------------------------------------


def test_threads_share_nothing(build: Build) -> None:
    compiled = build(TWO_MODES)

    def last(method: str) -> tuple[float, ...]:
        return tuple(simulate(compiled, [2.0, 0.0], (0.0, 300.0), method, dense=1).y[:, -1])

    methods = METHODS * 4
    alone = {method: last(method) for method in METHODS}
    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(last, methods)) == [alone[method] for method in methods]


MAIN = r"""
#include <stdio.h>
static int one_run(em_method method, double t_end) {
    const double y[N_STATE] = {2.0, 0.1, 1.0, 3.0, 0.5}, atol[N] = {1e-8}, t_eval[] = {0.0, 0.4 * t_end, t_end};
    const double times[] = {-1.5, -0.5, 0.5, 1.5}, values[] = {0.0, 1.0, -1.0, 0.5}, cubic[3][4] = {{1.0, 0.5}};
    const em_signal u[] = {{EM_HOLD, 4, times, values}, {EM_LINEAR, 4, times, values}, {EM_CUBIC, 4, times, cubic[0]},
                           {EM_CONSTANT, 0, NULL, values}};
    const int direction[] = {0, 0}, terminal[] = {0, 1};
    double inside[N_STATE];
    em_run run = {.t_end = t_end, .y_start = y, .inputs = u, .method = method, .rtol = 1e-8, .atol = atol,
                  .max_step = INFINITY, .max_steps = 10000, .dense = 1, .event_direction = direction,
                  .event_terminal = terminal};
    const em_run again = run;
    int ended = em_simulate(&run);
    for (size_t i = 0; i < run.n_dense; ++i)
        if (em_interpolate(&run, i, run.dense_steps[i].t + 0.5 * run.dense_steps[i].h, inside)) ended = -1;
    em_release(&run);
    run = again;
    run.t_eval = t_eval, run.n_t_eval = 3;
    if (em_simulate(&run) != ended) ended = -1;
    em_release(&run);
    return ended;
}
int main(void) {
    for (int method = EM_RK34; method <= EM_DOP853; ++method)
        printf("%d %d\n", one_run((em_method)method, 5.0), one_run((em_method)method, -5.0));
    return 0;
}
"""
EVERYTHING = Mechanism(
    rhs="""
    dy[0] = y[1] / (mode ? 2.0 : 1.0);
    dy[1] = (mode ? 2.0 : 1.0) * (u[0] + 0.1 * (u[1] + u[2]) - u[3] - sin(y[0]) + 0.0 * memory[0]);
    dy[2] = dy[3] = dy[4] = cos(t);""",
    settle=TWO_MODES.settle,
    settles=1,
    n_c=2,
    n_s=1,
    n_inputs=4,
    n_events=2,
    n_memory=3,
    events="g[0] = v[0]; g[1] = fabs(t) - 4.5;",
    main=MAIN,
)


def test_clean_under_sanitizers_without_python(tmp_path: Path) -> None:
    source, target = tmp_path / "program.c", tmp_path / "program"
    sanitizers = ("-g", "-O1", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
    source.write_text("int main(void) { return 0; }\n")
    probe = subprocess.run(compiler_command(source, target, *sanitizers), capture_output=True, check=False)
    if probe.returncode != 0 or subprocess.run([target], capture_output=True, check=False).returncode != 0:
        pytest.skip("the compiler has no sanitizers")
    source.write_text(EVERYTHING.text())
    built = subprocess.run(compiler_command(source, target, *sanitizers), capture_output=True, text=True, check=False)
    assert built.returncode == 0, built.stderr
    done = subprocess.run([target], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.split() == [str(TERMINAL_EVENT)] * 6


@pytest.mark.parametrize("pair", list(itertools.combinations(METHODS, 2)))
def test_methods_agree_on_everything_at_once(build: Build, pair: tuple[str, str]) -> None:
    given = [sampled(HOLD, (0.0, 5.0))[0], sampled(LINEAR, (0.0, 5.0))[0], sampled(CUBIC, (0.0, 5.0))[0]]
    constant = numbers([0.2])
    given.append((Signal(CONSTANT, 0, None, constant.ctypes.data), constant))
    times = np.linspace(0.0, 4.0, 23)
    first, second = (
        simulate(build(EVERYTHING), [2.0, 0.1, 1.0, 3.0, 0.5], (0.0, 5.0), method, inputs=given, t_eval=times,
                 terminal=[0, 1], rtol=1e-11, atol=1e-11, stabilise=0)
        for method in pair
    )  # fmt: skip
    assert first.status == second.status == TERMINAL_EVENT
    assert first.run.t_reached == pytest.approx(4.5, rel=1e-14)
    np.testing.assert_allclose(first.y, second.y, atol=1e-8)
    np.testing.assert_allclose(first.event_times(0), second.event_times(0), rtol=1e-8)
