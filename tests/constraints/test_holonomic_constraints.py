"""Holonomic constraints: the start that is nearest, and 100 000 steps that stay on them."""

import copy

import numpy as np
import pytest
from scipy.optimize import minimize
from sympy import sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, ModelError
from eigenmotion.runtime import EvaluationError, StopReason

from ..support.generation import FORMULATIONS, system_for, system_of

APPROXIMATE = {"q1": 1.5, "q2": 0.35, "q3": 1.5}


def nearest(system, x0: np.ndarray) -> np.ndarray:
    """The consistent x (n,) with least (x - x0)^T M(x0) (x - x0), by sequential quadratic programming."""
    M = system.mass_matrix(x0)
    phi = {"type": "eq", "fun": lambda x: system.compiled.position(0.0, x, system.prepare())[0]}
    found = minimize(
        lambda x: (x - x0) @ M @ (x - x0), system.initial[0], jac=lambda x: 2 * M @ (x - x0), method="SLSQP",
        constraints=[phi], options={"ftol": 1e-15, "maxiter": 500},
    )  # fmt: skip
    return found.x


# --- start-up ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("name", "x0"), [("four_bar", APPROXIMATE), ("slider_crank", {"phi": 0.0, "x": 1.2})])
def test_an_approximate_start_goes_to_the_nearest_in_the_mass_metric(name, x0):
    system = system_of(name)
    given, v0 = system.start(x0)
    moved = system.project_initial_state(x0)
    np.testing.assert_allclose(moved.x, nearest(system, given), atol=2e-7)
    assert np.abs(system.compiled.position(0.0, moved.x, system.prepare())[0]).max() < 1e-15
    M, A = system.mass_matrix(moved.x), system.pfaffian(moved.x)[0]
    np.testing.assert_allclose(A @ moved.v, 0, atol=1e-14)
    null = np.linalg.svd(A)[2][system.m :]  # v0 - v has no part along the constraints, in the mass metric
    np.testing.assert_allclose(null @ M @ (moved.v - v0), 0, atol=1e-13)
    assert system.simulate((0, 0.1), x0=moved.x, v0=moved.v).success


def test_it_is_nearer_than_newton_alone():
    system = system_of("four_bar")
    x0, v0 = system.start(APPROXIMATE)
    M = system.mass_matrix(x0)
    newton = system.compiled.project(0.0, x0, v0, system.prepare(), False)[0]
    assert system.project_initial_state(APPROXIMATE).distance < np.sqrt((newton - x0) @ M @ (newton - x0)) - 1e-5


def test_it_reports_how_far_it_moved():
    system = system_of("four_bar")
    x0, v0 = system.start(APPROXIMATE, [4.0, 0.1, 2.0])
    moved = system.project_initial_state(APPROXIMATE, [4.0, 0.1, 2.0])
    x, v = moved
    assert isinstance(moved, tuple)
    np.testing.assert_array_equal(moved.dx, x - x0)
    np.testing.assert_array_equal(moved.dv, v - v0)
    assert moved.distance == pytest.approx(np.sqrt(moved.dx @ system.mass_matrix(x0) @ moved.dx), rel=1e-12)
    assert moved.velocity_distance == pytest.approx(np.sqrt(moved.dv @ system.mass_matrix(x) @ moved.dv), rel=1e-12)
    assert f"distance={moved.distance:.3g}" in repr(moved)
    twin = copy.deepcopy(moved)
    assert (twin.distance, list(twin.x)) == (moved.distance, list(x))


def test_a_consistent_start_stays_where_it_is():
    system = system_of("four_bar")
    moved = system.project_initial_state()
    np.testing.assert_allclose(moved.x, system.initial[0], atol=1e-15)
    np.testing.assert_allclose(moved.v, system.initial[1], atol=1e-14)
    assert moved.distance < 1e-15


def test_a_moving_constraint_counts_at_its_time():
    system, time = system_of("driven_pendulum"), 0.37
    p = system.parameters
    x, v = system.project_initial_state([0.9, -0.5], [0.2, 0.1], time)
    pivot, rate = p["a"] * np.cos(p["w"] * time), -p["a"] * p["w"] * np.sin(p["w"] * time)
    assert np.hypot(x[0], x[1] - pivot) == pytest.approx(p["l"], rel=1e-15)
    assert x @ v - pivot * v[1] - (x[1] - pivot) * rate == pytest.approx(0, abs=1e-15)
    given = np.array([0.9, -0.5 - pivot])  # all masses are equal: the nearest point is that in the same direction
    np.testing.assert_allclose([x[0], x[1] - pivot], p["l"] * given / np.hypot(*given), rtol=1e-14)


def test_what_cannot_be_reached_is_named():
    with pytest.raises(EvaluationError, match=r"holonomic constraint row \d") as caught:
        system_of("four_bar").project_initial_state(parameters={"b": 5.0})
    assert caught.value.stop in (StopReason.POSITION_NOT_REACHED, StopReason.DEPENDENT_CONSTRAINTS)


def test_newton_that_is_still_on_its_way_has_not_arrived():
    """phi = sqrt(x^2 + 1e-30) vanishes nowhere: each step gets nearer to 0, where the root of phi is not."""
    x, y = dynamicsymbols("x y")
    size = symbols("size", positive=True)
    system = system_for(
        Model(
            name="unreachable",
            coordinates=[x, y],
            kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
            holonomic_constraints=[sqrt(x**2 + size**2)],
            parameters={size: 0.1},
        )
    )
    with pytest.raises(EvaluationError, match="row 0"):
        system.project_initial_state({"x": 1.0})


def test_a_start_off_the_constraints_is_refused_and_the_nearest_is_offered():
    system = system_of("four_bar")
    offered = ", ".join(f"{x:.9g}" for x in system.project_initial_state(APPROXIMATE).x)
    with pytest.raises(ModelError, match=rf"x0 is off holonomic constraint row 0 by -?0\.\d+.*x0 = \[{offered}\]"):
        system.simulate((0, 1), x0=APPROXIMATE)
    with pytest.raises(ModelError, match=r"v0 does not satisfy A v \+ b = 0 in constraint row 0 by.*v0 = \["):
        system.simulate((0, 1), v0=[1.0, 0.0, 0.0])


def test_a_start_off_by_less_than_the_tolerance_is_projected():
    system = system_of("four_bar")
    x, v = system.initial
    found = system.simulate((0, 0.5), x0=x + 1e-7, v0=v, rtol=1e-6)
    assert np.abs(found.position_residual).max() < 1e-14
    assert np.abs(found.x[:, 0] - x).max() < 1e-6


# --- 100 000 steps ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("formulation", "method"), [("eigenfactor", "rk34"), ("lagrange", "dopri5")])
def test_positions_stay_within_1e_12_over_100_000_steps(formulation, method):
    system = system_of("four_bar", formulation)
    found = system.simulate((0, 20), method=method, rtol=1e-6, atol=1e-9, max_step=2e-4)
    assert found.success
    assert found.nsteps >= 100_000
    assert found.t.size == found.nsteps + 1
    assert np.abs(found.position_residual).max() < 1e-12
    assert np.abs(found.constraint_residual).max() < 1e-12
    assert np.ptp(found.energy) < 1e-8


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_every_row_is_on_the_constraints_also_between_steps(formulation):
    system = system_of("four_bar", formulation)
    found = system.simulate((0, 2), rtol=1e-4, t_eval=np.linspace(0, 2, 301), dense_output=True)
    assert np.abs(found.position_residual).max() < 1e-12
    assert np.abs(found.constraint_residual).max() < 1e-12
    for t in (0.333, 1.777):
        assert np.abs(system.compiled.position(t, found.sol(t)[:3], system.prepare())[0]).max() < 1e-12


def test_without_stabilisation_they_drift_by_the_tolerance():
    drifts = []
    for rtol in (1e-5, 1e-7, 1e-9):
        found = system_of("four_bar").simulate((0, 2), rtol=rtol, atol=rtol, stabilisation="none")
        drifts.append(np.abs(found.position_residual).max())
    assert 1e-12 < drifts[2] < drifts[1] / 10 < drifts[0] / 100


@pytest.mark.parametrize("tiny", [10.0**-p for p in range(270, 306, 3)])
def test_a_residual_whose_correction_has_no_digits_is_zero(tiny: float):
    """Rows of length 1e15: a multiplier is 1e-30 of a residual, and rounded to zero before the residual is."""
    (x, y), u = dynamicsymbols("x y"), symbols("u", positive=True)
    beside = Model(
        name="beside_a_wall", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
        potential_energy=y**2 / 2, holonomic_constraints=[u * x], parameters={u: 1.0}, initial={y: 1.0},
    )  # fmt: skip
    run = system_for(beside, "lagrange").simulate((0.0, 3.0), x0={"x": tiny}, parameters={"u": 1e15}, rtol=1e-9)
    assert run.success, run.message
    assert run.x[:, -1] == pytest.approx([0.0, np.cos(3.0)], abs=1e-7)
