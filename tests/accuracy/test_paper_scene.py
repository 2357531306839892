"""The paper's experiment at rtol = atol = 1e-11: certified values and what happens on the way."""

from functools import cache

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from eigenmotion import Solution

from ..oracles import published
from ..support.generation import FORMULATIONS, system_of


def simulate(formulation: str, **options) -> Solution:
    solution = system_of("dual_link", formulation).simulate((0, 10), rtol=1e-11, atol=1e-11, **options)
    assert solution.success, solution.message
    return solution


@cache
def between() -> tuple[np.ndarray, Solution]:
    """The eigenfactor run at many times that are no steps."""
    times = np.linspace(0, 10, 2003)
    return times, simulate("eigenfactor", t_eval=times, dense_output=True)


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_certified_state_and_multiplier_and_what_is_kept_on_the_way(formulation):
    end = simulate(formulation)
    assert end.t[-1] == 10.0
    assert np.abs(end.x[:, -1] - np.array(published.DUAL_LINK_X, dtype=float)).max() < 1e-9
    assert end.multipliers[0, -1] == pytest.approx(float(published.DUAL_LINK_MULTIPLIER), abs=1e-9)
    assert np.ptp(end.energy) < 1e-10 * abs(end.energy[0])
    assert np.abs(height(end) - height(end)[0]).max() < 1e-11
    assert end.factor_residual.max() < 1e-13


def test_certified_state_without_projection():
    end = simulate("eigenfactor", stabilisation="none")
    assert np.abs(end.x[:, -1] - np.array(published.DUAL_LINK_X, dtype=float)).max() < 1e-8


@pytest.mark.parametrize("close_eigenvalues", ["bounded", "extrapolate"])
def test_the_published_equations_run_where_eigenvalues_are_apart(close_eigenvalues):
    """Whatever its pace, "bounded" leaves them only where two of a block are within a factor of two."""
    system = system_of("dual_link", close_eigenvalues=close_eigenvalues)
    end = system.simulate((0, 10), rtol=1e-11, atol=1e-11)
    close = np.sum(closest_ratio(end.s[:3]) < 2.0)
    assert 0 < close < 0.5 * end.nsteps
    assert end.n_bounded <= (close if close_eigenvalues == "bounded" else 0)
    assert np.abs(end.x[:, -1] - np.array(published.DUAL_LINK_X, dtype=float)).max() < 1e-9


def closest_ratio(s: np.ndarray) -> np.ndarray:
    """Of two eigenvalues s^2, the larger over the smaller."""
    eigenvalues = np.sort(s**2, axis=0)
    return (eigenvalues[1:] / eigenvalues[:-1]).min(axis=0)


def height(solution: Solution) -> np.ndarray:
    """y of the hand (57)."""
    theta1, theta2, stretch, _ = solution.x
    return (0.5 + stretch) * np.sin(theta1) + np.sin(theta2) / np.sqrt(2)


def test_what_is_kept_between_steps():
    """The hand's height to the error of the interpolant, of order 7, in a step of order 8; the others to rounding."""
    _, solution = between()
    y = height(solution)
    assert np.abs(y - y[0]).max() < 3e-11
    assert np.abs(solution.constraint_residual).max() < 1e-13
    assert solution.factor_residual.max() < 1e-13
    assert np.abs(np.einsum("ijt,kjt->ikt", solution.C, solution.C) - np.eye(4)[..., None]).max() < 1e-13


# --- eigenvalues ------------------------------------------------------------------------------------------------------


def mass_matrix(x: np.ndarray) -> np.ndarray:
    """(60), written out for unit masses."""
    reach, turn, l2 = 0.5 + x[2], x[0] - x[1], 1 / np.sqrt(2)
    M = np.diag([2 * reach**2, l2**2, 2.0, 0.25])
    M[0, 1] = M[1, 0] = reach * l2 * np.cos(turn)
    M[1, 2] = M[2, 1] = l2 * np.sin(turn)
    return M


def gap(time: float, size: int) -> float:
    """Smallest distance of two eigenvalues of the leading (size, size) part of M on the trajectory."""
    x = between()[1].sol(time)[:4]
    return float(np.diff(np.linalg.eigvalsh(mass_matrix(x)[:size, :size])).min())


def smallest(start: float, end: float, size: int) -> tuple[float, float]:
    """Return the time and size of the smallest gap: densely sampled, then refined."""
    times = np.linspace(start, end, 401)
    best = times[np.argmin([gap(time, size) for time in times])]
    step = times[1] - times[0]
    around = (max(start, best - step), min(end, best + step))
    found = minimize_scalar(gap, bounds=around, args=(size,), method="bounded", options={"xatol": 1e-10})
    return float(found.x), float(found.fun)


def test_eigenvalues_of_the_run_are_those_of_the_mass_matrix():
    _, solution = between()
    for k in range(0, 2003, 97):
        right = np.linalg.eigvalsh(mass_matrix(solution.x[:, k]))
        np.testing.assert_allclose(np.sort(solution.s[:, k] ** 2), right, rtol=1e-13)


def test_closest_approach_of_two_eigenvalues():
    """Across blocks: nothing turns there."""
    assert smallest(0, 10, 4)[1] == pytest.approx(0.0305, abs=1e-4)


@pytest.mark.parametrize(("about", "size"), [(2.02, 0.137), (4.26, 0.251), (6.50, 0.111)])
def test_gaps_within_the_block(about, size):
    time, found = smallest(about - 0.4, about + 0.4, 3)
    assert time == pytest.approx(about, abs=0.01)
    assert found == pytest.approx(size, abs=6e-4)


def test_signs_and_order_of_eigenfactors_stay_continuous():
    _, solution = between()
    assert np.abs(np.diff(solution.C, axis=-1)).max() < 0.1
    assert np.abs(np.diff(solution.s, axis=-1)).max() < 0.05
