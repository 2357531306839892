"""Inverse dynamics of robots against the recursive Newton-Euler algorithm of Pinocchio."""

import numpy as np
import pytest

import eigenmotion as em

from ..support.example_robots import bodies_alone, pinocchio, robot_file

ROBOTS = {
    "ur5": ("ur_description/urdf/ur5_robot.urdf", 6),
    "panda": ("panda_description/urdf/panda.urdf", 9),
    "talos": ("talos_data/robots/talos_reduced.urdf", 32),
}


@pytest.mark.nightly
@pytest.mark.parametrize("name", ROBOTS)
def test_inverse_dynamics_of_a_robot_against_pinocchio(name, tmp_path):
    pin, (path, joints) = pinocchio(), ROBOTS[name]
    file = bodies_alone(robot_file(path), tmp_path)
    theirs = pin.buildModelFromUrdf(str(file))
    system = em.build(em.load_urdf(file))
    assert system.n == joints == theirs.nv
    order = [theirs.joints[theirs.getJointId(one)].idx_v for one in system.coordinates]
    random, data = np.random.default_rng(2), theirs.createData()
    for _ in range(20):
        x, v, a = random.uniform(-2, 2, joints), random.normal(0, 2, joints), random.normal(0, 5, joints)
        given = np.zeros((3, joints))
        given[:, order] = x, v, a
        right = pin.rnea(theirs, data, *given)[order]
        assert np.abs(system.inverse_dynamics(x, v, a).forces - right).max() < 1e-12 * np.abs(right).max()
