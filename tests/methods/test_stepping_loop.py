"""Accuracy, step sizes, rows and settling of the stepping loop in `em_stepper.h`.

Oracles: elliptic functions, closed forms, and the step sequences of `scipy.integrate`.
"""

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from scipy.integrate import DOP853, RK45
from scipy.special import ellipk

from eigenmotion.arguments.methods import METHODS as TABLE

from ..support.stepping import (
    CIRCLE,
    FINISHED,
    METHODS,
    PENDULUM,
    RUNGE_KUTTA,
    TWO_MODES,
    Array,
    Build,
    Compiled,
    Mechanism,
    Result,
    builder,
    pendulum_angle,
    simulate,
)

CALLS_OF_A_STEP = {"rk34": 5, "dopri5": 6, "dop853": 12}
"""Right-hand sides, which the coefficients leave no choice about."""


@pytest.fixture(scope="module")
def build(tmp_path_factory: pytest.TempPathFactory) -> Build:
    return builder(tmp_path_factory.mktemp("mechanisms"))


# --- accuracy ---------------------------------------------------------------------------------------------------------


def fixed_steps(compiled: Compiled, method: str, count: int, t_end: float, **options: Any) -> Result:
    h = t_end / count
    return simulate(compiled, [2.0, 0.0], (0.0, t_end), method, rtol=1e9, first_step=h, max_step=h, **options)


@pytest.mark.parametrize("method", RUNGE_KUTTA)
def test_order_of_convergence(build: Build, method: str) -> None:
    order, errors = TABLE[method].order, []
    for count in (16, 32) if order > 5 else (80, 160):
        result = fixed_steps(build(PENDULUM), method, count, 8.0)
        assert abs(result.run.n_steps - count) <= 1
        errors.append(np.abs(result.y[0] - pendulum_angle(result.t, 2.0)).max())
    assert math.log2(errors[0] / errors[1]) > order - 0.4


@pytest.mark.parametrize("method", RUNGE_KUTTA)
def test_order_of_dense_output(build: Build, method: str) -> None:
    order, errors = TABLE[method].order, []
    for count in (16, 32) if order > 5 else (80, 160):
        result = fixed_steps(build(PENDULUM), method, count, 8.0, dense=1)
        inside = [(t + q * h, result.at(i, t + q * h)[0]) for i, t, h in result.steps() for q in (0.2, 0.5, 0.9)]
        t, x = np.array(inside).T
        errors.append(np.abs(x - pendulum_angle(t, 2.0)).max())
    assert math.log2(errors[0] / errors[1]) > order - 0.4


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("rtol", [1e-4, 1e-8])
def test_error_follows_the_tolerance(build: Build, method: str, rtol: float) -> None:
    result = simulate(build(PENDULUM), [2.0, 0.0], (0.0, 20.0), method, rtol=rtol, atol=rtol)
    error = np.abs(result.y[0] - pendulum_angle(result.t, 2.0)).max()
    assert 1e-3 * rtol < error < 1e3 * rtol


@pytest.mark.parametrize("t_end", [10.0, -10.0])
@pytest.mark.parametrize(
    ("method", "theirs", "rtol", "atol", "tolerance"),
    # DOP853 of SciPy scales its error by the velocity of y(t + h), ours by that of the last stage:
    # the same with atol alone. Its estimate is a small difference of large numbers, so that rounding shows sooner.
    [
        ("dopri5", RK45, 1e-6, 1e-8, 1e-8),
        ("dopri5", RK45, 1e-3, 1e-3, 1e-8),
        ("dop853", DOP853, 3e-14, 1e-7, 2e-6),
    ],
)
def test_step_sequences_are_those_of_scipy_under_our_controller(
    build: Build, method: str, theirs: type, rtol: float, atol: float, tolerance: float, t_end: float
) -> None:
    given = {"rtol": rtol, "atol": atol, "first_step": 0.1}  # theirs is chosen in seconds
    ours = simulate(build(PENDULUM), [2.0, 0.5], (0.0, t_end), method, **given)
    solver = theirs(lambda t, y: [y[1], -math.sin(y[0])], 0.0, [2.0, 0.5], t_end, **given)
    t, y = zip(*steps_under_gustafsson(solver), strict=True)
    np.testing.assert_allclose(ours.t, t, rtol=tolerance)
    np.testing.assert_allclose(ours.y.T, y, atol=3 * tolerance)


def steps_under_gustafsson(solver: RK45 | DOP853) -> Iterator[tuple[float, Array]]:
    """SciPy's steps, errors and rejections; sizes of the steps that follow accepted ones by Gustafsson (1991)."""
    order, last = solver.error_estimator_order + 1, 0.0
    yield solver.t, solver.y
    while solver.status == "running":
        y, calls = solver.y, solver.nfev
        solver.step()
        yield solver.t, solver.y
        scale = solver.atol + solver.rtol * np.maximum(np.abs(y), np.abs(solver.y))
        error = solver._estimate_error_norm(solver.K, solver.t - solver.t_old, scale)
        factor = np.clip(0.9 * error ** (-0.7 / order) * math.exp(0.4 * last / order), 0.2, 4.0)
        rejected = solver.nfev - calls > solver.n_stages
        solver.h_abs = solver.step_size * (min(1.0, factor) if rejected else factor)
        last = max(math.log(error), -9.2)


def test_velocity_error_counts_in_units_of_atol(build: Build) -> None:
    """Two copies of one pendulum in units that differ by 1000 need equal steps when atol differs so too."""
    rhs = "dy[0] = y[1]; dy[1] = -sin(y[0] / {0}) * {0};"
    small, large = (build(Mechanism(rhs=rhs.format(unit))) for unit in ("1.0", "1000.0"))
    runs = [
        simulate(compiled, [2.0 * unit, 0.0], (0.0, 5.0), rtol=1e-12, atol=1e-7 * unit)
        for compiled, unit in ((small, 1.0), (large, 1000.0))
    ]
    np.testing.assert_allclose(runs[0].t, runs[1].t, rtol=1e-6)


RESTING = {"settle": "*mode = 1; return 0;", "settles": 1}
"""A mechanism that leaves the published equations, in which factors are integrated, at its start."""


@pytest.mark.parametrize("stabilise", [0, 1])
def test_factors_count_where_the_published_equations_run(build: Build, stabilise: int) -> None:
    """C turns fast while x is slow: the step sizes see it in mode 0, projected or not, and not where it rests."""
    rhs = "dy[0] = y[1]; dy[1] = -y[0]; dy[2] = 40.0 * cos(40.0 * t);"
    options = {"rtol": 1e-6, "atol": 1e-6, "stabilise": stabilise}
    counted = simulate(build(Mechanism(rhs=rhs, n_c=1)), [1.0, 0.0, 0.0], (0.0, 3.0), **options)
    assert abs(counted.y[2, -1] - math.sin(120.0)) < 1e-5
    if stabilise:
        resting = simulate(build(Mechanism(rhs=rhs, n_c=1, **RESTING)), [1.0, 0.0, 0.0], (0.0, 3.0), **options)
        assert counted.run.n_steps > 4 * resting.run.n_steps
        assert abs(resting.y[2, -1] - math.sin(120.0)) > 1e-4


@pytest.mark.parametrize("method", RUNGE_KUTTA)
def test_the_first_step_is_sized_by_the_norm_of_all_others(build: Build, method: str) -> None:
    """Over 2 n numbers where factors are added to the norm, and over all where they count like others: d1 and d2
    differ by sqrt(3 / 2), and with them the first step by the root of the order of that, but for how far is looked
    ahead for the rate at which the motion varies."""
    compiled = build(Mechanism(rhs="dy[0] = y[1]; dy[1] = -y[0]; dy[2] = cos(t);", n_c=1))
    options = {"rtol": 1e-6, "atol": 1e-6, "method": method}
    added, counted = (simulate(compiled, [1.0, 0.5, 0.5], (0.0, 3.0), stabilise=on, **options).t[1] for on in (1, 0))
    assert added / counted == pytest.approx(1.5 ** (-0.5 / TABLE[method].order), rel=1e-4)


def test_roots_of_eigenvalues_count_relative_to_themselves(build: Build) -> None:
    rhs = "dy[0] = y[1]; dy[1] = -y[0]; dy[2] = y[2] * cos(40.0 * t);"
    compiled, resting = build(Mechanism(rhs=rhs, n_s=1)), build(Mechanism(rhs=rhs, n_s=1, **RESTING))
    small, large = (simulate(compiled, [1.0, 0.0, s], (0.0, 3.0), stabilise=0) for s in (1e-6, 1e6))
    assert abs(large.run.n_steps - small.run.n_steps) <= 1
    assert large.run.n_steps > 2 * simulate(resting, [1.0, 0.0, 1.0], (0.0, 3.0), stabilise=1).run.n_steps


@pytest.mark.parametrize("method", RUNGE_KUTTA)
def test_counts_and_end(build: Build, method: str) -> None:
    result = simulate(build(PENDULUM), [2.0, 0.0], (0.0, 7.3), method, max_step=0.05, first_step=0.01)
    assert result.status == FINISHED
    assert result.t[0] == 0.0
    assert result.t[-1] == result.run.t_reached == 7.3
    assert result.t[1] == 0.01
    assert np.diff(result.t).max() <= 0.05 * (1 + 1e-12)
    assert result.run.n_steps == len(result.t) - 1
    assert result.run.n_rejected == 0
    assert result.run.n_rhs == 1 + CALLS_OF_A_STEP[method] * result.run.n_steps


# --- rows -------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("t_end", [6.0, -6.0])
def test_rows_at_given_times(build: Build, method: str, t_end: float) -> None:
    times = np.linspace(0.0, t_end, 61)
    result = simulate(build(PENDULUM), [2.0, 0.0], (0.0, t_end), method, t_eval=times, dense=1)
    np.testing.assert_array_equal(result.t, times)
    np.testing.assert_allclose(result.y[0], pendulum_angle(times, 2.0), atol=2e-7)
    for i, t, h in result.steps():
        within = (times - t) * (times - t - h) <= 0
        for time_, row in zip(times[within], result.y.T[within], strict=True):
            np.testing.assert_allclose(result.at(i, time_), row, atol=1e-14)


def test_rows_inside_part_of_the_span(build: Build) -> None:
    result = simulate(build(PENDULUM), [2.0, 0.0], (0.0, 6.0), t_eval=[1.0, 1.0, 5.5])
    np.testing.assert_array_equal(result.t, [1.0, 1.0, 5.5])
    assert result.run.t_reached == 6.0
    assert simulate(build(PENDULUM), [2.0, 0.0], (0.0, 6.0), t_eval=[]).t.size == 0


@pytest.mark.parametrize("t_eval", [None, [1.5], [1.5, 1.5]])
def test_span_of_no_length(build: Build, t_eval: list[float] | None) -> None:
    result = simulate(build(PENDULUM), [2.0, 0.1], (1.5, 1.5), t_eval=t_eval)
    assert result.status == FINISHED
    np.testing.assert_array_equal(result.t, t_eval or [1.5])
    np.testing.assert_array_equal(result.y[:, 0], [2.0, 0.1])


def test_dense_steps_join_the_rows(build: Build) -> None:
    result = simulate(build(PENDULUM), [2.0, 0.0], (0.0, 6.0), dense=1)
    for i, t, h in result.steps():
        np.testing.assert_array_equal(result.at(i, t), result.y[:, i])
        np.testing.assert_allclose(result.at(i, t + h), result.y[:, i + 1], rtol=1e-14, atol=1e-15)


# --- settling ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("method", METHODS)
def test_rows_of_all_kinds_are_settled(build: Build, method: str) -> None:
    options: dict[str, Any] = {"rtol": 1e-5, "atol": 1e-5, "dense": 1}
    steps = simulate(build(CIRCLE), [1.0, 0.0, 0.0, 1.0], (0.0, 20.0), method, **options)
    times = simulate(build(CIRCLE), [1.0, 0.0, 0.0, 1.0], (0.0, 20.0), method, t_eval=np.linspace(0, 20, 99), **options)
    inside = np.array([steps.at(i, t + 0.37 * h) for i, t, h in steps.steps()]).T
    for y in (steps.y, times.y, inside):
        np.testing.assert_allclose(np.hypot(y[0], y[1]), 1.0, atol=4e-16)
        np.testing.assert_allclose(y[0] * y[2] + y[1] * y[3], 0.0, atol=4e-16)
    loose = simulate(build(CIRCLE), [1.0, 0.0, 0.0, 1.0], (0.0, 20.0), method, stabilise=0, **options)
    assert np.abs(np.hypot(loose.y[0], loose.y[1]) - 1.0).max() > 1e-9


def test_settled_steps_evaluate_the_first_stage_anew(build: Build) -> None:
    run = simulate(build(CIRCLE), [1.0, 0.0, 0.0, 1.0], (0.0, 20.0), "dopri5", first_step=0.1).run
    assert run.n_rhs == 1 + 7 * run.n_steps + 6 * run.n_rejected
    run = simulate(build(CIRCLE), [1.0, 0.0, 0.0, 1.0], (0.0, 20.0), "dop853", first_step=0.1).run
    assert run.n_rhs == 1 + 12 * run.n_steps + 11 * run.n_rejected


@pytest.mark.parametrize("method", RUNGE_KUTTA)
def test_a_change_of_mode_leaves_no_trace(build: Build, method: str) -> None:
    """The internal state jumps at the change; rows, interpolants, events and step sizes do not."""
    times = np.linspace(0.0, 20.0, 201)
    options: dict[str, Any] = {"rtol": 1e-10, "atol": 1e-10, "dense": 1}
    modes = simulate(build(TWO_MODES), [2.0, 0.0], (0.0, 20.0), method, t_eval=times, **options)
    plain = simulate(build(PENDULUM), [2.0, 0.0], (0.0, 20.0), method, t_eval=times, **options)
    np.testing.assert_allclose(modes.y, plain.y, atol=1e-12)
    assert modes.run.n_steps == plain.run.n_steps
    assert 0 < modes.run.n_bounded < modes.run.n_steps
    assert modes.run.n_bounded == sum(modes.run.dense_steps[i].mode for i in range(modes.run.n_dense))
    for i, t, h in modes.steps():
        np.testing.assert_allclose(modes.at(i, t + 0.9 * h), plain.at(i, t + 0.9 * h), atol=1e-12)
    period = 4 * ellipk(math.sin(1.0) ** 2)
    np.testing.assert_allclose(modes.event_times(0), period / 2 * np.arange(1, 5), rtol=1e-8)


def test_memory_is_that_of_the_last_accepted_step(build: Build) -> None:
    """The memory notes the time of the last accepted step; no stage lies before it, or beyond the longest step."""
    rhs = "if (t < memory[0] || t > memory[0] + 0.1001) return em_fail(fault, EM_SINGULAR_MASS_MATRIX, 0, -1, t);\n"
    settle = "memory[0] = t; (void)h;"
    compiled = build(Mechanism(rhs=rhs + PENDULUM.rhs, settle=settle, settles=1, n_memory=1))
    for method in METHODS:
        result = simulate(compiled, [2.0, 0.0], (0.0, 3.0), method, max_step=0.1, t_eval=[0.05, 1.0, 2.99])
        assert result.status == FINISHED
        assert result.run.n_rejected == 0
