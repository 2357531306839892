"""The gripper, the humanoid and the quadruped: loops, loads and steps against statics and geometry."""

import numpy as np
import pytest

import eigenmotion as em

from ..support.generation import MODELS

GRAVITY = 9.81


def system_of(name):
    return em.build(MODELS / f"{name}.py", formulation="articulated_body")


def test_the_gripper_closes_with_upright_pads():
    """Pads are parallel to the palm and mirror each other; the rod keeps its length between plunger and lever."""
    system = system_of("gripper")
    run = system.simulate((0, 1), inputs={"pull": 5.0}, rtol=1e-9, t_eval=np.linspace(0, 1, 51))
    assert np.abs(run.position_residual).max() < 1e-15
    for side, sign in (("left", 1), ("right", -1)):
        R, p = system.pose(f"{side}_pad", run.x)
        assert np.abs(R - np.eye(3)[:, :, None]).max() < 1e-12
        assert np.abs(sign * p[1] - run.outputs["gap"] / 2).max() < 1e-12
    s, crank = run.x[0, -1], run.x[system.coordinates.index("left_crank"), -1]
    lever = np.array([0.01 + 0.02 * (1 - np.cos(crank)), -0.02 * np.sin(crank)])
    assert np.hypot(lever[0] - 0.01, lever[1] + 0.03 - s) == pytest.approx(0.03, abs=1e-12)
    assert 0 < run.outputs["gap"].min() < run.outputs["gap"][-1] < 0.05


@pytest.mark.nightly
def test_the_humanoid_squats_with_loaded_feet():
    """The loops hold, the pelvis follows the legs' geometry, and a foot bears about half the weight at rest."""
    system = system_of("humanoid")
    times = np.linspace(0, 3, 151)
    down = np.minimum(1.0, (1 - np.cos(np.pi * times / 2)) / 2) * (times < 2) + (times >= 2)
    run = system.simulate((0, 3), inputs={"depth": (times, down)}, rtol=1e-7, t_eval=times)
    assert run.success
    assert np.abs(run.position_residual).max() < 1e-14
    held = run.x[system.coordinates.index("left_ankle"), -1]
    assert run.outputs["pelvis"][-1] == pytest.approx(0.08 + 2 * 0.42 * np.cos(held), abs=5e-3)
    assert run.outputs["right_load"].min() > 0
    mass = 2 * (4 + 8) + 10 + 1 + 25 + 5 + 2 * (2.5 + 2)
    assert run.outputs["right_load"][-1] == pytest.approx(mass * GRAVITY / 2, rel=0.1)


@pytest.fixture(scope="module")
def quadruped():
    return system_of("quadruped")


@pytest.mark.nightly
def test_the_quadruped_stands(quadruped):
    """Its feet bear its weight."""
    run = quadruped.simulate((0, 2), parameters={"stride": 0.0, "lift": 0.0}, rtol=1e-7)
    assert run.success
    assert run.outputs["load"][-1] == pytest.approx((12 + 4 * 1.3) * GRAVITY, rel=1e-3)
    assert np.abs(run.x[1]).max() < 1e-6


@pytest.mark.nightly
def test_the_quadruped_walks(quadruped):
    """It is ahead and upright; no foot is below the floor, and feet are lifted."""
    run = quadruped.simulate((0, 2), rtol=1e-5, t_eval=np.linspace(0, 2, 201))
    assert run.success
    assert run.x[0, -1] > 0.4
    assert np.abs(run.x[3:6]).max() < 0.05
    feet = [quadruped.pose(name, run.x) for name in quadruped.bodies if name.endswith("knee")]
    heights = [(p + R[:, 2] * -0.25)[2] for R, p in feet]
    assert np.min(heights) > -1e-6
    assert np.max(heights) > 0.01
