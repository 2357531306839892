"""Exact derivatives of accelerations, multipliers, constraints and outputs, against differences in sixty digits."""

from collections.abc import Callable, Iterable, Sequence
from functools import cache
from typing import Any

import mpmath
import numpy as np
import pytest

from eigenmotion.runtime.variations import motion_derivatives

from ..oracles import Lagrange
from ..support.generation import system_for
from ..support.models_table import BY_NAME, SCENARIOS, Scenario

DIGITS = 60
STEP = mpmath.mpf(10) ** -20
BY_DAY = ("dual_link", "rolling_disk", "four_bar", "driven_pendulum", "quaternion_top")
EVERY = [pytest.param(one, id=one.name, marks=() if one.name in BY_DAY else pytest.mark.nightly) for one in SCENARIOS]


@cache
def lagrange(name: str) -> Lagrange:
    """Lagrange's equations of a model in as many digits."""
    with mpmath.workdps(DIGITS):
        return Lagrange(BY_NAME[name].model(), "arbitrary")


def differences(function: Callable[[list[Any]], Iterable[Any]], arguments: Sequence[float]) -> np.ndarray:
    """d function / d argument, (values, arguments), to forty digits."""
    with mpmath.workdps(DIGITS):
        z, columns = [mpmath.mpf(value) for value in arguments], []
        for k in range(len(z)):
            ahead, behind = (function([*z[:k], z[k] + step, *z[k + 1 :]]) for step in (STEP, -STEP))
            columns.append([float((b - a) / (2 * STEP)) for b, a in zip(ahead, behind, strict=True)])
        return np.array(columns).T


def far(found: np.ndarray, right: np.ndarray, sizes: np.ndarray) -> float:
    """How far derivatives are off, each relative to the most that arguments of these sizes make of its row."""
    most = np.abs(right * sizes).max(axis=1, keepdims=True)
    return float((np.abs(found - right) * sizes / np.where(most > 1e-9, most, 1.0)).max(initial=0.0))


def moved(scenario: Scenario, z: Sequence[Any]) -> np.ndarray:
    """Accelerations and multipliers at x, v, inputs, parameters, time, in a row."""
    oracle, model = lagrange(scenario.name), scenario.model()
    n, names = oracle.n, [*(u.func.__name__ for u, _ in model.inputs), *(str(p) for p, _ in model.parameters)]
    given = dict(zip(names, z[2 * n : -1], strict=True))
    inputs = {u.func.__name__: given.pop(u.func.__name__) for u, _ in model.inputs}
    return np.concatenate(oracle(z[:n], z[n : 2 * n], z[-1], given, inputs))


@pytest.mark.parametrize("scenario", EVERY)
def test_motion(scenario):
    system, (state,), p, t = (
        system_for(scenario.model(), "lagrange"), scenario.random_states(1, 3), scenario.random_parameters(3), 0.7
    )  # fmt: skip
    arguments = [*state.x, *state.v, *system.inputs.values(), *p.values(), t]
    right = differences(lambda z: moved(scenario, z), arguments)
    c = system.compiled
    a, multipliers, da, dm = motion_derivatives(c, t, state.x, state.v, system.prepare(p), c.input_defaults, False)
    exact = np.array([float(value) for value in moved(scenario, arguments)])
    np.testing.assert_allclose([*a, *multipliers], exact, atol=1e-11 * max(1.0, np.abs(exact).max()))
    assert far(np.vstack([da, dm]), right, np.maximum(np.abs(arguments), 1.0)) < 1e-12
