"""Constraint rows that depend on each other: refused by name, or run with the multipliers of least norm."""

from functools import cache

import numpy as np
import pytest
from sympy import Max, cos, sin
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, System, t
from eigenmotion.results.output.summary import summary
from eigenmotion.runtime import StopReason

from ..support.failing_runs import X, check_honest, plane
from ..support.generation import system_for

Q = dynamicsymbols("q:4")
M_TURNING = (
    (2 + sin(Q[1])) * Q[0].diff() ** 2 + Q[0].diff() * Q[1].diff() * cos(Q[2]) + 3 * Q[1].diff() ** 2
    + 2 * Q[2].diff() ** 2 + Q[3].diff() ** 2 + Q[2].diff() * Q[3].diff()
) / 2  # fmt: skip
ROWS = [Q[0] - Q[1] + Q[2] ** 2 / 2, Q[1] + 2 * Q[3]]
REDUNDANT = {
    "doubled": [ROWS[0], 2 * ROWS[0], ROWS[1]],
    "combined": [ROWS[0], ROWS[1], 3 * ROWS[0] - ROWS[1]],
    "in_micrometres": [ROWS[0], ROWS[1] / 10**6, ROWS[0] + ROWS[1]],
    "vanishing": [ROWS[0], sin(Q[0]) ** 2 + cos(Q[0]) ** 2 - 1, ROWS[1]],
    "on_the_constraints_only": [ROWS[0], ROWS[1], ROWS[0] * (2 + Q[0] + Q[3])],
}


@cache
def redundant(name: str, formulation: str = "eigenfactor") -> System:
    rows = REDUNDANT.get(name, ROWS)
    potential = 5 * Q[0] ** 2 + Q[1] * Q[2] + 3 * Q[3] ** 2
    model = Model(
        name=name, coordinates=Q, kinetic_energy=M_TURNING, potential_energy=potential, holonomic_constraints=rows,
        initial={Q[0]: 0.6, Q[1]: 0.6, Q[3]: -0.3, Q[0].diff(): 1.0, Q[1].diff(): 1.0, Q[3].diff(): -0.5},
    )  # fmt: skip
    return system_for(model, formulation)


@pytest.mark.parametrize("name", list(REDUNDANT))
def test_dependent_rows_are_refused_with_the_way_out(name):
    found = redundant(name).simulate((0, 1), dependent_constraints="refuse")
    check_honest(found)
    assert found.stop is StopReason.DEPENDENT_CONSTRAINTS
    assert found.t.size == 1
    assert "least_norm" in found.message
    row = 1 if name in ("doubled", "vanishing") else 2
    assert f"Constraint row {row} " in found.message
    assert "dependent constraints" in summary(redundant(name), found, 0.1)


@pytest.mark.parametrize("formulation", ["eigenfactor", "lagrange"])
@pytest.mark.parametrize("name", list(REDUNDANT))
def test_least_norm_gives_the_motion_of_the_independent_rows(name, formulation):
    at = np.linspace(0, 2, 9)
    options = {"t_eval": at, "rtol": 1e-10, "atol": 1e-10}
    right = redundant("independent", formulation).simulate((0, 2), **options)
    found = redundant(name, formulation).simulate((0, 2), dependent_constraints="least_norm", **options)
    assert found.success, found.message
    np.testing.assert_allclose(found.x, right.x, atol=1e-8)
    assert np.abs(found.position_residual).max() < 1e-12
    force = [redundant("independent").pfaffian(x)[0].T @ m for x, m in zip(right.x.T, right.multipliers.T, strict=True)]
    same = [redundant(name).pfaffian(x)[0].T @ m for x, m in zip(found.x.T, found.multipliers.T, strict=True)]
    np.testing.assert_allclose(same, force, atol=1e-6)


@pytest.mark.parametrize("name", ["doubled", "combined", "in_micrometres", "vanishing"])
def test_multipliers_of_least_norm_are_those_of_numpy(name):
    system, random = redundant(name), np.random.default_rng(4)
    for _ in range(10):
        x = random.normal(size=4)
        x, v = system.project_initial_state(x, random.normal(size=4), dependent_constraints="least_norm")
        a, found = system.acceleration(x, v, dependent_constraints="least_norm")
        A = system.pfaffian(x)[0]
        force = redundant("independent").pfaffian(x)[0].T @ redundant("independent").acceleration(x, v)[1]
        right = np.linalg.pinv(A.T, rcond=1e-9) @ force  # the least multipliers with that force
        np.testing.assert_allclose(found, right, rtol=1e-7, atol=1e-9 * max(1, np.abs(right).max()))
        np.testing.assert_allclose(a, redundant("independent").acceleration(x, v)[0], atol=1e-8)


@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-12])
def test_rows_that_depend_on_the_constraints_only_at_any_tolerance(rtol):
    system = redundant("on_the_constraints_only")
    found = system.simulate((0, 2), rtol=rtol, atol=rtol, dependent_constraints="least_norm")
    right = redundant("independent").simulate((0, 2), rtol=1e-12, atol=1e-12)
    check_honest(found)
    assert found.success, found.message
    np.testing.assert_allclose(found.x[:, -1], right.x[:, -1], atol=max(100 * rtol, 1e-9))


def test_rows_that_contradict_each_other_are_named():
    rows = [X.diff() - 1, 2 * X.diff() - 2 - Max(0, t - 1)]
    system = system_for(plane("torn_apart", nonholonomic_constraints=rows, initial={X.diff(): 1.0}))
    found = system.simulate((0, 2), dependent_constraints="least_norm")
    check_honest(found)
    assert found.stop is StopReason.DEPENDENT_CONSTRAINTS
    assert found.t[-1] == pytest.approx(1.0, abs=1e-9)
    assert "row 1 (counted from 0) contradicts" in found.message
