"""Tries frax: its own Panda robot, since it takes no equations and, by the names of its methods, no loops."""

from collections.abc import Iterator
from time import perf_counter

import frax
import jax
import numpy as np
from four_bar import Trial

ROBOTS, RUNS = 1000, 20


def trials() -> Iterator[Trial]:
    """Print the time of forward dynamics of many robots at once, and which methods are about constraints."""
    jax.config.update("jax_enable_x64", True)
    robot = frax.load_panda()
    dynamics = jax.jit(jax.vmap(lambda q, v, tau: robot.forward_dynamics(q, v, tau, None)))
    q, v, tau = np.random.default_rng(0).uniform(-1.0, 1.0, (3, ROBOTS, robot.num_joints))
    dynamics(q, v, tau).block_until_ready()
    before = perf_counter()
    for _ in range(RUNS):
        dynamics(q, v, tau).block_until_ready()
    each = (perf_counter() - before) / RUNS / ROBOTS
    print(f"  forward dynamics of {robot.num_joints} joints, {ROBOTS} at once: {1e6 * each:.2g} us each")
    named = [name for name in dir(robot) if any(word in name for word in ("constraint", "loop", "contact"))]
    print(f"  methods about constraints, loops, contacts: {', '.join(named) or 'none'}")
    yield from ()
