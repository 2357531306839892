"""A Solution of a model written by hand, against the pendulum on paper."""

import pickle
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import OptimizeResult
from scipy.special import ellipk

from eigenmotion.results.solution import Solution
from eigenmotion.results.trajectory import _filled
from eigenmotion.runtime import StopReason

from ..support.hand_written import bead
from ..support.hand_written.swing import START, TIGHT, G, L, M, pendulum

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def motion() -> Solution:
    return bead().simulate((0, 5), **START, **TIGHT, dense_output=True)


def test_is_a_result_of_scipy(motion):
    assert isinstance(motion, OptimizeResult)
    assert isinstance(motion, Solution)
    assert motion.__class__.__doc__ == Solution.__doc__
    assert motion.success is True
    assert motion.status == 0
    assert motion.stop is StopReason.FINISHED
    assert motion.y.shape == (4, motion.t.size)
    assert motion["y"] is motion.y
    assert motion.nsteps == motion.t.size - 1
    assert motion.nfev > 12 * motion.nsteps
    assert motion.sol.t_min == 0
    assert motion.sol.t_max == 5


def test_period_is_that_of_the_elliptic_integral(motion):
    crossings = motion.t_events[0]
    np.testing.assert_allclose(np.diff(crossings), 2 * np.sqrt(L / G) * ellipk(np.sin(0.5) ** 2), rtol=1e-9)
    assert motion.y_events[0].shape == (crossings.size, 4)
    np.testing.assert_allclose(motion.y_events[0][:, :2], np.tile([0, -L], (crossings.size, 1)), atol=1e-12)


def test_derived_rows(motion):
    angle = np.arctan2(motion.x[0], -motion.x[1])
    speed = np.hypot(*motion.v)
    k = motion.t.size
    assert motion.x.shape == motion.v.shape == motion.eta.shape == motion.s.shape == (2, k)
    assert motion.C.shape == (2, 2, k)
    np.testing.assert_array_equal(motion.v, motion.y[2:])
    np.testing.assert_allclose(motion.eta, np.sqrt(M) * motion.v, atol=1e-14)
    np.testing.assert_allclose(motion.s, np.sqrt(M))
    np.testing.assert_allclose(motion.energy, M * speed**2 / 2 + M * G * motion.x[1])
    np.testing.assert_allclose(motion.energy, motion.energy[0], atol=1e-8)
    np.testing.assert_array_equal(motion.jacobi_integral, motion.energy)
    tension = M * speed**2 / L + M * G * np.cos(angle)
    np.testing.assert_allclose(motion.multipliers, [tension / L], atol=1e-9)
    np.testing.assert_allclose(motion.outputs["tension"], tension, atol=1e-9)
    assert motion.constraint_residual.shape == motion.position_residual.shape == (1, k)
    assert abs(motion.constraint_residual).max() < 1e-13
    assert abs(motion.position_residual).max() < 1e-14
    assert motion.factor_residual.shape == (k,)
    assert motion.factor_residual.max() < 1e-15


def test_residuals_are_those_of_the_rows():
    drifting = bead().simulate((0, 5), **START, rtol=1e-4, stabilisation="none")
    (x, y), (vx, vy) = drifting.y[:2], drifting.y[2:]
    np.testing.assert_allclose(drifting.position_residual[0], (x**2 + y**2 - L**2) / 2, atol=1e-15)
    np.testing.assert_allclose(drifting.constraint_residual[0], x * vx + y * vy, atol=1e-14)
    assert abs(drifting.position_residual[0, -1]) > 1e-6


def test_derived_rows_are_found_like_any_other():
    found = bead().simulate((0, 1), **START)
    assert "eta" in found
    assert "eta" in found.keys()  # noqa: SIM118
    assert "nonsense" not in found
    assert found["eta"] is found.eta
    assert set(found) == set(found.keys()) == {name for name, _ in found.items()}
    assert len(found) == len(list(found))
    assert {"t", "y", "C", "factor_residual"} <= set(dir(found))
    assert found.get("nonsense", 3) == 3
    assert dict(found)["multipliers"].shape == (1, found.t.size)
    with pytest.raises(AttributeError):
        found.nonsense  # noqa: B018
    with pytest.raises(KeyError):
        found["nonsense"]


def test_coordinates_are_said_to_be_elsewhere(systems):
    found = systems("pendulum").simulate((0, 1))
    with pytest.raises(AttributeError, match=r"'theta' is a coordinate: its values are x\[0\]"):
        found.theta  # noqa: B018
    with pytest.raises(KeyError, match=r"its rates v\[0\]"):
        found["theta"]
    assert not hasattr(found, "nowhere")


def test_representation_is_a_summary(motion):
    assert repr(motion).startswith("<Solution of bead: finished, t = 0 ... 5 in")
    assert len(repr(motion)) < 300


def test_a_copy_travels_between_processes(motion):
    twin = pickle.loads(pickle.dumps(motion))
    np.testing.assert_array_equal(twin.multipliers, motion.multipliers)
    assert twin.stop is StopReason.FINISHED
    assert twin.sol is None


def test_dense_output_is_projected_and_joins_the_rows(motion):
    t = np.linspace(0, 5, 999)
    y = motion.sol(t)
    assert y.shape == (4, 999)
    np.testing.assert_allclose(y[:2], pendulum(t), atol=1e-7)
    np.testing.assert_allclose(np.hypot(*y[:2]), L, atol=1e-14)
    np.testing.assert_allclose(motion.sol(motion.t), motion.y, atol=1e-13)
    assert motion.sol(2.5).shape == (4,)
    np.testing.assert_array_equal(motion.sol(2.5), motion.sol([2.5])[:, 0])
    with pytest.raises(ValueError, match="outside"):
        motion.sol(5.1)


def test_dense_output_outlives_the_solution():
    dense = bead().simulate((1, 0), **START, dense_output=True).sol
    assert (dense.t_min, dense.t_max) == (0, 1)
    np.testing.assert_allclose(np.hypot(*dense(np.linspace(0, 1, 50))[:2]), L, atol=1e-14)


def test_carried_factors_are_put_into_their_blocks():
    """Three blocks {0, 2}, {1}, {3, 4}; the state carries the last."""
    found = np.tile(np.eye(5), (3, 1, 1)), np.ones((3, 5))
    carried, roots = np.arange(12.0).reshape(3, 4), np.arange(6.0).reshape(3, 2) + 7
    C, s = _filled(found, carried, roots, [[3, 4]])
    np.testing.assert_array_equal(C[1, 3:, 3:], [[4, 5], [6, 7]])
    np.testing.assert_array_equal(C[1, :3, :3], np.eye(3))
    np.testing.assert_array_equal(s[1], [1, 1, 1, 9, 10])


def test_a_run_does_not_wait_for_scipy():
    scipys = "[name for name in sys.modules if name.startswith('scipy.') and name.count('.') == 1 and '._' not in name]"
    script = f"""
import sys
from tests.support.hand_written import bead
motion = bead().simulate((0, 1))
print(motion.success, {scipys}, type(motion) is motion.__class__)
"""
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True, cwd=ROOT)
    assert done.stdout.strip() == "True ['scipy.version'] True"
