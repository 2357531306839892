"""Benchmark of tables: cost of a table of a thousand pieces compared with one of five, in builds and right-hand sides.

Both alternate; medians of the ratios are printed. Builds start from an empty cache, and take some seconds each.
"""

import os
import statistics
import tempfile
import time

import numpy as np
import sympy
from scipy.interpolate import CubicSpline
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

BUILDS, RUNS, PIECES = 3, 15, (5, 1000)
theta = dynamicsymbols("theta")


def model(pieces: int) -> em.Model:
    """Return a pendulum under a torque that is a table of its angle."""
    angles = np.linspace(-np.pi, np.pi, pieces + 1)
    values = np.sin(angles)
    values[-1] = values[0]
    load = em.Table(CubicSpline(angles, values, bc_type="periodic"), outside="periodic", name="load")
    return em.Model(name="loaded", coordinates=[theta], kinetic_energy=theta.diff() ** 2 / 2,
                    potential_energy=-9.81 * sympy.cos(theta), forces={theta: load(theta)},
                    initial={theta: 1.0})  # fmt: skip


def built(pieces: int) -> float:
    """Return the seconds of a build, with the stepper in the cache."""
    start = time.perf_counter()
    em.build(model(pieces))
    return time.perf_counter() - start


def evaluated(system: em.System) -> float:
    """Return the seconds of a right-hand side within a run."""
    start = time.perf_counter()
    run = system.simulate((0.0, 200.0), rtol=1e-9, t_eval=[200.0])
    return (time.perf_counter() - start) / run.nfev


def main() -> None:
    """Print the additional seconds of a build, and the ratio of the times of a right-hand side."""
    added = []
    for _ in range(BUILDS):
        with tempfile.TemporaryDirectory() as cache:
            os.environ["EIGENMOTION_CACHE"] = cache
            built(2)  # compiles the stepper
            few, many = map(built, PIECES)
            added.append(many - few)
    print(f"build: {statistics.median(added):+.2f} s for {PIECES[1]} pieces over {PIECES[0]}")
    systems = [em.build(model(pieces)) for pieces in PIECES]
    pairs = [[evaluated(system) for system in systems] for _ in range(RUNS)]
    ratio = statistics.median(many / few for few, many in pairs)
    print(f"right-hand side: {ratio:.2f} times, {1e9 * statistics.median(few for few, _ in pairs):.0f} ns with few")


if __name__ == "__main__":
    main()
