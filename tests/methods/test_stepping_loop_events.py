"""Events and signals of a run of `em_stepper.h`."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from ..support.stepping import (
    CIRCLE,
    CONSTANT,
    CUBIC,
    DRIVEN,
    FREE_FALL,
    HOLD,
    LINEAR,
    METHODS,
    SAMPLES,
    TERMINAL_EVENT,
    Build,
    Result,
    Signal,
    builder,
    numbers,
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
