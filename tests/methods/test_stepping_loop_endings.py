"""The ways a run of `em_stepper.h` ends, and what else is asked of it: threads, sanitizers, everything at once."""

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

from ..support.stepping import (
    CONSTANT,
    CUBIC,
    EXPLICIT,
    FINISHED,
    HOLD,
    INTERRUPTED,
    LINEAR,
    METHODS,
    NON_FINITE_STATE,
    OUT_OF_MEMORY,
    PENDULUM,
    POSITION_NOT_REACHED,
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
    simulate,
)


@pytest.fixture(scope="module")
def build(tmp_path_factory: pytest.TempPathFactory) -> Build:
    return builder(tmp_path_factory.mktemp("mechanisms"))


def test_too_many_steps_keeps_what_there_is(build: Build) -> None:
    result = simulate(build(PENDULUM), [2.0, 0.0], (0.0, 1e3), max_steps=25)
    assert result.status == TOO_MANY_STEPS
    assert result.run.n_steps == 25
    assert len(result.t) == result.run.n_steps + 1
    np.testing.assert_allclose(result.y[0], pendulum_angle(result.t, 2.0), atol=1e-7)


AT_WALL = {method: 1e-12 if method in EXPLICIT else 1e-9 for method in METHODS}
"""How near runs come to a wall: slopes of what is written by hand are differences, which need some room."""
WALL = "if (y[0] > 1.0) {{ {0} }} dy[0] = y[1]; dy[1] = 0.0;"


def at_the_wall(build: Build, obstacle: str, **options: Any) -> Result:
    return simulate(build(Mechanism(rhs=WALL.format(obstacle))), [0.0, 1.0], (0.0, 3.0), **options)


@pytest.mark.parametrize("method", METHODS)
def test_a_fault_on_the_way_ends_the_run_where_it_sits(build: Build, method: str) -> None:
    result = at_the_wall(build, "return em_fail(fault, EM_SINGULAR_MASS_MATRIX, 3, -1, 0.5);", method=method)
    fault = result.run.fault
    assert (fault.status, fault.first, fault.second, fault.size) == (SINGULAR_MASS_MATRIX, 3, -1, 0.5)
    assert result.y[0, -1] == pytest.approx(1.0, abs=AT_WALL[method])
    np.testing.assert_allclose(result.y[0], result.t, rtol=1e-14)


@pytest.mark.parametrize("method", METHODS)
def test_values_that_are_not_finite(build: Build, method: str) -> None:
    for obstacle in ("dy[0] = dy[1] = NAN; return 0;", "dy[0] = 1.0; dy[1] = INFINITY; return 0;"):
        result = at_the_wall(build, obstacle, method=method)
        assert result.status == NON_FINITE_STATE
        assert result.y[0, -1] == pytest.approx(1.0, abs=AT_WALL[method])
        assert np.isfinite(result.y).all()


def test_a_step_that_cannot_be_short_enough(build: Build) -> None:
    result = simulate(build(Mechanism(rhs="dy[0] = y[1]; dy[1] = pow(fabs(1.0 - t), -1.5);")), [0.0, 1.0], (0.0, 3.0))
    assert result.status == STEP_SIZE_UNDERFLOW
    assert result.run.t_reached == pytest.approx(1.0, abs=1e-6)
    assert result.run.t_reached == result.t[-1]


@pytest.mark.parametrize("method", METHODS)
def test_an_underflow_names_the_coordinate_that_forbids_steps(build: Build, method: str) -> None:
    rhs = "dy[0] = y[2]; dy[1] = y[3]; dy[2] = -y[0]; dy[3] = pow(fabs(1.0 - t), -1.5);"
    result = simulate(build(Mechanism(rhs=rhs, n=2)), [0.3, 0.0, 0.0, 1.0], (0.0, 3.0), method)
    assert (result.status, result.run.fault.first) == (STEP_SIZE_UNDERFLOW, 1)


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
    int ended = simulate(&run);
    for (size_t i = 0; i < run.n_dense; ++i)
        if (interpolate(&run, i, run.dense_steps[i].t + 0.5 * run.dense_steps[i].h, inside)) ended = -1;
    release(&run);
    run = again;
    run.t_eval = t_eval, run.n_t_eval = 3;
    if (simulate(&run) != ended) ended = -1;
    release(&run);
    return ended;
}
int main(void) {
    const em_method methods[] = METHODS;
    for (size_t k = 0; k < sizeof methods / sizeof *methods; ++k)
        printf("%d %d\n", one_run(methods[k], 5.0), one_run(methods[k], -5.0));
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
    sanitizers = "-g -O0 -fsanitize=address,undefined -fno-sanitize-recover=all".split()  # at -O1 Clang takes minutes
    source.write_text("int main(void) { return 0; }\n")
    probe = subprocess.run(compiler_command(source, target, *sanitizers), capture_output=True, check=False)
    if probe.returncode != 0 or subprocess.run([target], capture_output=True, check=False).returncode != 0:
        pytest.skip("the compiler has no sanitizers")
    source.write_text(EVERYTHING.text())
    built = subprocess.run(compiler_command(source, target, *sanitizers), capture_output=True, text=True, check=False)
    assert built.returncode == 0, built.stderr
    done = subprocess.run([target], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.split() == [str(TERMINAL_EVENT)] * 2 * len(METHODS)


@pytest.mark.parametrize("pair", list(itertools.combinations(EXPLICIT, 2)))
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
    np.testing.assert_allclose(first.y[:2], second.y[:2], atol=1e-8)
    carried = first.y[0] > 0.0  # in the other mode factors rest, from the end of a step on
    np.testing.assert_allclose(first.y[2:, carried], second.y[2:, carried], atol=1e-8)
    np.testing.assert_allclose(first.event_times(0), second.event_times(0), rtol=1e-8)


@pytest.mark.parametrize("method", ["rk34", "dopri5", "dop853", "ra15"])
def test_a_span_on_which_nothing_happens_takes_a_step(systems, method):
    """However short: its first size is not a fraction of the span."""
    system = systems("dual_link")
    whole = system.simulate((0.0, 1e-6), method=method)
    for span in (1e-9, 1e-12, 1e-15):
        short = system.simulate((0.0, span), method=method)
        assert (short.nsteps, short.nrejected) == (1, 0)
        assert np.allclose(short.x[:, -1], whole.x[:, 0], rtol=0, atol=1e-12)
