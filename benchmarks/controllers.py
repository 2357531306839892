"""Benchmark of closed loops: 200 runs with a controller at 1 kHz as one ensemble, compared with a loop of `simulate`.

Ratios are medians over rounds in which both alternate; above 1 the ensemble is faster. A call of the controller costs
from almost nothing to several microseconds, in both cases.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np
from common.timing import interleaved, ratio

from eigenmotion import Sampled, System, build, simulate, simulate_ensemble

MODEL = Path(__file__).parents[1] / "models" / "furuta_pendulum.py"
COUNT, SPAN, PERIOD, ROUNDS = 200, (0.0, 1.0), 1e-3, 3
TOLERANCES = {"rtol": 1e-9, "atol": 1e-9}


def law(_: float, x: np.ndarray, v: np.ndarray) -> float:
    """Return the torque that stabilises the rod upright and the arm at rest."""
    return 0.083 * x[0] + 1.036 * x[1] + 0.057 * v[0] + 0.105 * v[1]


def constant(*_: object) -> float:
    """Return 0: a controller without cost."""
    return 0.0


class Integral:
    """The law with an additional integral of the rod's angle: a controller with a state."""

    def __init__(self) -> None:
        self.sum = 0.0

    def __call__(self, t: float, x: np.ndarray, v: np.ndarray) -> float:
        self.sum += PERIOD * x[1]
        return law(t, x, v) + 0.01 * self.sum


def loop(system: System, make: Callable[[], Sampled], angles: np.ndarray) -> np.ndarray:
    """Return x (count, n) at the end, by a loop of `simulate`."""
    runs = [simulate(system, SPAN, x0={"phi": phi}, inputs={"u": make()}, **TOLERANCES) for phi in angles]
    return np.array([run.x[:, -1] for run in runs])


def ensemble(system: System, make: Callable[[], Sampled], angles: np.ndarray, workers: int | None) -> np.ndarray:
    """Return x (count, n) at the end, by one ensemble."""
    return simulate_ensemble(system, SPAN, x0={"phi": angles}, inputs={"u": make()}, workers=workers, **TOLERANCES).x[
        ..., 0
    ]


def main() -> None:
    """Print a line for each controller."""
    system, angles = build(MODEL, formulation="lagrange"), np.linspace(-0.05, 0.05, COUNT)
    controllers = {
        "nothing": partial(Sampled, constant, PERIOD), "a law": partial(Sampled, law, PERIOD),
        "a law with a state": partial(Sampled, make=Integral, period=PERIOD),
    }  # fmt: skip
    for name, make in controllers.items():
        assert np.array_equal(loop(system, make, angles[:8]), ensemble(system, make, angles[:8], 1))
        ways = {"loop": partial(loop, system, make, angles)}
        ways |= {f"{w} workers": partial(ensemble, system, make, angles, w) for w in (1, 2)}
        times = interleaved(ways, ROUNDS)
        print(f"{name}: {np.median(times['loop']):.2f} s in a loop;", end=" ")
        print(", ".join(f"{way}: {ratio(times['loop'], times[way])}" for way in list(ways)[1:]))


if __name__ == "__main__":
    main()
