"""Cost of short calls from Python, one place or one short run: microseconds, medians with quartiles.

Arguments are NumPy arrays. The run is one step of dop853. Its whole call stands beside the same run by the same sources
from C (common/run.c), which allocates, enters, steps and frees as the call does: the difference is what `simulate`
costs besides its steps. Python and C take turns.
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
    """Return the seconds of one call, over enough of them to be seen."""
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
    """Return the seconds of each call in each round, and those of the run in C."""
    model = em.load_model(MODELS / f"{name}.py")
    system = em.build(model, formulation=formulation)
    in_c = Runner.of_model(model, folder / f"{name} {formulation}", formulation=formulation)
    assert system.simulate((0.0, T_END), rtol=TOLERANCE, atol=TOLERANCE).nsteps == 1
    actions = {title: lambda call=call: timed(call) for title, call in calls(system).items()}
    actions["run in C"] = lambda: 1e-9 * in_c.nanoseconds(1000, T_END, TOLERANCE)
    rounds = [{title: action() for title, action in actions.items()} for _ in range(ROUNDS)]
    found = {title: np.array([each[title] for each in rounds]) for title in actions}
    found["besides its steps"] = found["simulate"] - np.median(found["run in C"])
    return found


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        for name, formulation in CASES:
            print(f"{name}, {formulation}")
            for title, seconds in measured(name, formulation, Path(folder)).items():
                print(f"  {title:<18} {spread(seconds, 1e-6)} us, least {1e6 * seconds.min():.3g}")


if __name__ == "__main__":
    main()
