"""Mechanisms whose rows depend on each other on the constraints only, and motions through singular positions."""

from functools import cache
from itertools import pairwise
from math import sqrt

import numpy as np
import pytest
from scipy.integrate import simpson, solve_ivp
from sympy import Matrix, Rational, cos, eye, sin
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, System, t
from eigenmotion.runtime import StopReason

from ..support.failing_runs import check_honest
from ..support.generation import system_for

G = Rational(981, 100)
EDGES = ((0, 1), (1, 1), (2, 1), (0, -1), (1, -1))
LEAST_NORM = {"dependent_constraints": "least_norm"}


def rotation(axis: int, angle) -> Matrix:
    i, j = (axis + 1) % 3, (axis + 2) % 3
    R = eye(3)
    R[i, i] = R[j, j] = cos(angle)
    R[i, j], R[j, i] = -sin(angle), sin(angle)
    return R


@cache
def bricard() -> Model:
    """Bricard's mechanism of the IFToMM benchmarks: five bars on the edges of a cube and six revolute joints.

    One degree of freedom, five relative angles and five rows that close the loop, of which four are independent on the
    constraints and five beside them.
    """
    q = dynamicsymbols("q1:6")
    R, foot, T, V = eye(3), Matrix([0, 0, 0]), 0, 0
    for angle, axis, (place, sign) in zip(q, (1, 2, 0, 1, 2), EDGES, strict=True):
        R = R * rotation(axis, angle)
        tip = foot + sign * R[:, place]
        a, b = foot.diff(t), tip.diff(t)
        T += (a.dot(a) + a.dot(b) + b.dot(b)) / 6  # slender, of one kilogramme
        V += G * (foot[1] + tip[1]) / 2
        foot = tip
    rows = [*(foot - Matrix([0, 0, 1])), R[1, 0], R[2, 0]]
    return Model(name="bricard", coordinates=q, kinetic_energy=T, potential_energy=V,
                 holonomic_constraints=rows)  # fmt: skip


@cache
def bricard_system(formulation: str) -> System:
    return system_for(bricard(), formulation)


def bars_energy(q: np.ndarray, v: np.ndarray) -> float:
    """T + V of the five bars by numbers: their ends at q, and along v by differences of complex step."""

    def ends(angles: np.ndarray) -> np.ndarray:
        R, points = np.eye(3, dtype=complex), [np.zeros(3, dtype=complex)]
        for angle, axis, (place, sign) in zip(angles, (1, 2, 0, 1, 2), EDGES, strict=True):
            i, j = (axis + 1) % 3, (axis + 2) % 3
            turn = np.eye(3, dtype=complex)
            turn[i, i] = turn[j, j] = np.cos(angle)
            turn[j, i] = np.sin(angle)
            turn[i, j] = -turn[j, i]
            R = R @ turn
            points.append(points[-1] + sign * R[:, place])
        return np.array(points)

    moving = ends(q + 1e-30j * v)
    height, velocity = moving.real[:, 1], moving.imag / 1e-30
    kinetic = [(a @ a + a @ b + b @ b) / 6 for a, b in pairwise(velocity)]
    return float(sum(kinetic) + 9.81 * (height[:-1] + height[1:]).sum() / 2)


@pytest.mark.parametrize("method", ["rk34", "dopri5", "dop853"])
@pytest.mark.parametrize("formulation", ["eigenfactor", "cholesky", "lagrange"])
def test_bricards_mechanism_leaves_its_published_pose(formulation, method):
    """With one degree of freedom, the constraints, the energy and xdot = v are the motion."""
    tolerance = 1e-6 if method == "rk34" else 1e-10
    system, at = bricard_system(formulation), np.linspace(0, 2, 401)
    found = system.simulate((0, 2), method=method, rtol=tolerance, atol=tolerance, t_eval=at, **LEAST_NORM)
    check_honest(found)
    assert found.success, found.message
    assert np.abs(found.position_residual).max() < 2e-14  # of terms that are about 5
    assert np.abs(found.x[:, -1]).max() > 0.5
    start = bars_energy(np.zeros(5), np.zeros(5))
    worst = max(abs(bars_energy(x, v) - start) for x, v in zip(found.x.T[::5], found.v.T[::5], strict=True))
    assert worst < 1e3 * tolerance
    np.testing.assert_allclose(simpson(found.v, x=at), found.x[:, -1], atol=max(1e-7, 100 * tolerance))


def test_a_consistent_pose_is_found_from_one_at_which_all_rows_are_independent():
    system, x0 = bricard_system("lagrange"), np.array([0.1, 0.1, -0.1, -0.1, -0.12])
    assert np.linalg.matrix_rank(system.pfaffian(x0)[0], 1e-4) == 5
    x, v = system.project_initial_state(x0, np.ones(5), **LEAST_NORM)
    A = system.pfaffian(x)[0]
    assert np.linalg.matrix_rank(A, 1e-12) == 4
    assert np.abs(system.compiled.position(0.0, x, system.prepare())[0]).max() < 1e-15
    assert np.abs(A @ v).max() < 1e-14
    assert np.abs(x - x0).max() < 0.03


@cache
def four_bars(n: int) -> Model:
    """The n loops of the IFToMM benchmark: n + 1 cranks and n couplers of a metre and a kilogramme, by their joints."""
    x, y = dynamicsymbols(f"x0:{n + 1}"), dynamicsymbols(f"y0:{n + 1}")
    T, V, rows = 0, 0, []
    for k in range(n + 1):
        tip = Matrix([x[k], y[k]])
        T, V = T + tip.diff(t).dot(tip.diff(t)) / 6, V + G * y[k] / 2
        rows.append((x[k] - k) ** 2 + y[k] ** 2 - 1)
        if k:
            foot = Matrix([x[k - 1], y[k - 1]])
            a, b = foot.diff(t), tip.diff(t)
            T, V = T + (a.dot(a) + a.dot(b) + b.dot(b)) / 6, V + G * (y[k - 1] + y[k]) / 2
            rows.append((tip - foot).dot(tip - foot) - 1)
    start = {x[k]: k + sqrt(0.5) for k in range(n + 1)} | {y[k]: sqrt(0.5) for k in range(n + 1)}
    rates = {x[k].diff(): 1.0 for k in range(n + 1)} | {y[k].diff(): -1.0 for k in range(n + 1)}
    return Model(name=f"four_bars_{n}", coordinates=[*x, *y], kinetic_energy=T, potential_energy=V,
                 holonomic_constraints=rows, initial=start | rates)  # fmt: skip


@cache
def crank_angle(n: int, end: float) -> float:
    """All cranks are parallel, and turn as one pendulum."""
    inertia, weight = (n + 1) / 3 + n, 9.81 * ((n + 1) / 2 + n)
    run = solve_ivp(lambda _, z: [z[1], -weight / inertia * np.cos(z[0])], (0, end), [np.pi / 4, -sqrt(2)],
                    method="DOP853", rtol=1e-12, atol=1e-12)  # fmt: skip
    return float(run.y[0, -1])


@pytest.mark.parametrize(("n", "tolerance"), [(1, 1e-6), (1, 1e-8), (2, 1e-6), (2, 1e-8)])
def test_loops_of_four_bars_pass_the_positions_in_which_all_bars_align(n, tolerance):
    """Twenty times in ten seconds, where every loop may cross over."""
    found = system_for(four_bars(n), "lagrange").simulate((0, 10), rtol=tolerance, atol=tolerance)
    check_honest(found)
    assert found.success, found.message
    assert np.abs(np.diff(found.x[n + 1 :], axis=0)).max() < 1e4 * tolerance  # no loop crossed over
    angle = crank_angle(n, 10.0)
    np.testing.assert_allclose(found.x[[0, n + 1], -1], [np.cos(angle), np.sin(angle)], atol=2e4 * tolerance)


@pytest.mark.parametrize(("n", "tolerance"), [(1, 1e-10), (2, 1e-10), (1, 1e-12), (2, 1e-12)])
def test_where_short_steps_may_end_there_it_is_passed_or_named_with_a_way_out(n, tolerance):
    """It is a matter of where steps end: of 21 tolerances in the decade about 1e-10 some 13 pass, all about 1e-8."""
    found = system_for(four_bars(n), "lagrange").simulate((0, 10), rtol=tolerance, atol=tolerance)
    check_honest(found)
    assert found.success or found.stop is StopReason.DEPENDENT_CONSTRAINTS
    assert np.abs(np.diff(found.x[n + 1 :], axis=0)).max() < 1e4 * tolerance
    assert found.success or "loosen rtol" in " ".join(found.message.split())


def test_a_start_in_a_singular_position_is_named_in_least_norm_too():
    """Flat, with a push that holds for one branch: more rows are independent beside it."""
    x = four_bars(1).coordinates
    flat = {x[0]: 1.0, x[1]: 2.0, x[2]: 0.0, x[3]: 0.0}
    system = system_for(four_bars(1), "lagrange")
    names = {str(key.func): value for key, value in flat.items()}
    found = system.simulate((0, 1), x0=names, v0=[0.0, 0.0, 1.0, 1.0], **LEAST_NORM)
    check_honest(found)
    assert found.stop is StopReason.DEPENDENT_CONSTRAINTS
    assert "singular position" in found.message
    assert "Start beside it" in found.message
