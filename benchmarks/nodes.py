"""Steps by nodes, "ra15", beside dop853 at equal error: every model in two formulations, and a force that has kinks.

Time of whole calls in interleaved rounds over tolerances, and the largest error of x at eleven times; between them
both are interpolated. Ratios are ra15 over dop853, at errors of 1e-6 and 1e-9 relative to the size of the motion.
"""

from __future__ import annotations

from functools import partial
from pathlib import Path

import numpy as np
import sympy
from common.timing import interleaved
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, System, build

MODELS = sorted(path for path in (Path(__file__).parents[1] / "models").glob("*.py") if path.stem != "__init__")
FORMULATIONS = ("lagrange", "eigenfactor")
METHODS = ("dop853", "ra15")
TOLERANCES = 10.0 ** -np.arange(4.0, 12.0)
TARGETS = (1e-6, 1e-9)
SPAN, ROUNDS = 5.0, 9


def kinked() -> Model:
    """An oscillator that a one-sided spring meets in every period."""
    q = dynamicsymbols("q")
    force = -q - 2 * sympy.Max(q, 0)
    return Model(name="kinked", coordinates=[q], kinetic_energy=q.diff() ** 2 / 2, forces={q: force}, initial={q: 1.0})


def times_and_errors(system: System) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Seconds and relative errors of each method at each tolerance; NaN where a run fails."""
    at = np.linspace(0.0, SPAN, 11)
    exact = system.simulate((0.0, SPAN), rtol=1e-13, atol=1e-13, t_eval=at, method="dop853").x
    size = max(1.0, np.abs(exact).max())
    calls = {f"{method} {tolerance}": partial(system.simulate, (0.0, SPAN), rtol=tolerance, atol=tolerance, t_eval=at,
                                              method=method)
             for method in METHODS for tolerance in TOLERANCES}  # fmt: skip
    runs = {name: call() for name, call in calls.items()}
    errors = {name: np.abs(run.x - exact).max() / size if run.success else np.nan for name, run in runs.items()}
    seconds = interleaved(calls, ROUNDS)
    names = {method: [f"{method} {tolerance}" for tolerance in TOLERANCES] for method in METHODS}
    return {method: (np.array([np.median(seconds[name]) for name in names[method]]),
                     np.array([errors[name] for name in names[method]])) for method in METHODS}  # fmt: skip


def seconds_at(target: float, seconds: np.ndarray, errors: np.ndarray) -> float:
    """Interpolate the time for an error; NaN where no run is so good."""
    known = np.isfinite(errors) & (errors > 0)
    order = np.argsort(errors[known])
    x, y = np.log(errors[known][order]), np.log(seconds[known][order])
    return float(np.exp(np.interp(np.log(target), x, y, left=np.nan))) if known.any() else np.nan


def main() -> None:
    heads = [f"{formulation} {target:.0e}" for formulation in FORMULATIONS for target in TARGETS]
    print("time of ra15 over that of dop853 at equal error\n" + f"{'model':<20}" + "".join(f"{h:>18}" for h in heads))
    found = []
    for model in (*MODELS, kinked()):
        ratios = []
        for formulation in FORMULATIONS:
            system = build(model, formulation=formulation)
            both = times_and_errors(system)
            at = [[seconds_at(target, *both[method]) for method in METHODS] for target in TARGETS]
            ratios += [nodes / stages for stages, nodes in at]
        found.append(ratios)
        print(f"{system.name:<20}" + "".join(f"{ratio:>18.2f}" for ratio in ratios), flush=True)
    print(f"{'median':<20}" + "".join(f"{ratio:>18.2f}" for ratio in np.nanmedian(found, axis=0)))


if __name__ == "__main__":
    main()
