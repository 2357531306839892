"""Benchmark of short calls from Python, at one state or of one short run: microseconds, medians with quartiles.

Arguments are NumPy arrays. The run is one step of dop853. It is also timed from C with the same sources (common/run.c),
where it allocates, opens, steps and frees as the call from Python does: the difference is the overhead of `simulate`.
Python and C alternate.
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from common.plain import Runner
from common.timing import spread

import eigenmotion as em

MODELS = Path(__file__).parents[1] / "models"
CASES = (("dual_link", "lagrange"), ("dual_link", "eigenfactor"), ("spatial_arm", "lagrange"))
ROUNDS, CALLS = 200, 100
T_END, TOLERANCE = 1e-4, 1e-6


def timed(action: Callable[[], object]) -> float:
    """Return the seconds of one call, as the mean over CALLS calls."""
    start = time.perf_counter()
    for _ in range(CALLS):
        action()
    return (time.perf_counter() - start) / CALLS


def calls(system: em.System) -> dict[str, Callable[[], object]]:
    x, v = system.initial
    return {
        "mass_matrix": lambda: system.mass_matrix(x),
        "energy": lambda: system.energy(x, v),
        "acceleration": lambda: system.acceleration(x, v),
        "simulate": lambda: system.simulate((0.0, T_END), x0=x, v0=v, rtol=TOLERANCE, atol=TOLERANCE),
    }


def measured(name: str, formulation: str, folder: Path) -> dict[str, np.ndarray]:
    """Return the seconds of each call in each round, and of the run in C."""
    model = em.load_model(MODELS / f"{name}.py")
    system = em.build(model, formulation=formulation)
    in_c = Runner.of_model(model, folder / f"{name} {formulation}", formulation=formulation)
    assert system.simulate((0.0, T_END), rtol=TOLERANCE, atol=TOLERANCE).nsteps == 1
    actions = {title: lambda call=call: timed(call) for title, call in calls(system).items()}
    actions["run in C"] = lambda: 1e-9 * in_c.nanoseconds(1000, T_END, TOLERANCE)
    rounds = [{title: action() for title, action in actions.items()} for _ in range(ROUNDS)]
    seconds = {title: np.array([each[title] for each in rounds]) for title in actions}
    seconds["besides its steps"] = seconds["simulate"] - np.median(seconds["run in C"])
    return seconds


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        for name, formulation in CASES:
            print(f"{name}, {formulation}")
            for title, seconds in measured(name, formulation, Path(folder)).items():
                print(f"  {title:<18} {spread(seconds, 1e-6)} us, least {1e6 * seconds.min():.3g}")


if __name__ == "__main__":
    main()
