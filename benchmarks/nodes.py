"""Benchmark of ra15 (Gauss-Radau collocation) compared with dop853 at equal error.

It runs every model in two formulations, and two models with a kinked and a sampled force. The time of whole calls is
measured in interleaved rounds over tolerances, with the largest error of x at eleven times; the time at a given error
is interpolated. Ratios are ra15 over dop853, at errors from 1e-3 to 1e-9 relative to the size of the motion. At the end
the choice of "auto" (simulation/method_selection.py): the time of the method it chooses over that of the faster one.
"""

from __future__ import annotations

from functools import partial
from pathlib import Path
from time import thread_time

import numpy as np
import sympy
from common.timing import interleaved
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, Signal, System, build

MODELS = sorted(path for path in (Path(__file__).parents[1] / "models").glob("*.py") if path.stem != "__init__")
FORMULATIONS = ("lagrange", "eigenfactor")
METHODS = ("dop853", "ra15")
TOLERANCES = 10.0 ** -np.arange(2.0, 12.0)
TARGETS = (1e-3, 1e-5, 1e-7, 1e-9)
SPAN, ROUNDS = 5.0, 7

Both = dict[str, tuple[np.ndarray, np.ndarray]]


def kinked() -> Model:
    """Return an oscillator that touches a one-sided spring in every period."""
    q = dynamicsymbols("q")
    force = -q - 2 * sympy.Max(q, 0)
    return Model(name="kinked", coordinates=[q], kinetic_energy=q.diff() ** 2 / 2, forces={q: force}, initial={q: 1.0})


def held() -> Model:
    """Return a pendulum driven by a torque that is constant between samples."""
    q, u = dynamicsymbols("q u")
    return Model(name="held", coordinates=[q], kinetic_energy=q.diff() ** 2 / 2, potential_energy=-9.81 * sympy.cos(q),
                 forces={q: u}, inputs={u: 0.0}, initial={q: 1.0})  # fmt: skip


def inputs_of(system: System) -> dict[str, Signal]:
    times = np.arange(0.0, SPAN + 0.1, 0.1)
    return {name: Signal(times, np.sin(3.0 * times), "hold") for name in system.inputs}


def times_and_errors(system: System) -> Both:
    """Return seconds and relative errors of each method at each tolerance; NaN if a run or its reference run fails."""
    at, inputs = np.linspace(0.0, SPAN, 11), inputs_of(system)
    tight = system.simulate((0.0, SPAN), rtol=1e-13, atol=1e-13, t_eval=at, method="dop853", inputs=inputs)
    exact = tight.x if tight.success else np.full((system.n, len(at)), np.nan)
    size = max(1.0, np.abs(exact).max())
    calls = {f"{method} {tolerance}": partial(system.simulate, (0.0, SPAN), rtol=tolerance, atol=tolerance, t_eval=at,
                                              method=method, inputs=inputs)
             for method in METHODS for tolerance in TOLERANCES}  # fmt: skip
    runs = {name: call() for name, call in calls.items()}
    errors = {name: np.abs(run.x - exact).max() / size if run.success else np.nan for name, run in runs.items()}
    seconds = interleaved(calls, ROUNDS, thread_time)
    names = {method: [f"{method} {tolerance}" for tolerance in TOLERANCES] for method in METHODS}
    return {method: (np.array([np.median(seconds[name]) for name in names[method]]),
                     np.array([errors[name] for name in names[method]])) for method in METHODS}  # fmt: skip


def seconds_at(target: float, seconds: np.ndarray, errors: np.ndarray) -> float:
    """Interpolate the time for an error; NaN if no run reaches it."""
    known = np.isfinite(errors) & (errors > 0)
    order = np.argsort(errors[known])
    x, y = np.log(errors[known][order]), np.log(seconds[known][order])
    return float(np.exp(np.interp(np.log(target), x, y, left=np.nan))) if known.any() else np.nan


def chosen(system: System) -> list[str]:
    """Return the method that "auto" chooses at each tolerance."""
    return [system.simulate((0.0, SPAN), rtol=tolerance, atol=tolerance, method="auto", inputs=inputs_of(system)).method
            for tolerance in TOLERANCES]  # fmt: skip


def lost(system: System, both: Both) -> dict[str, np.ndarray]:
    """Return, at each tolerance, the time of each method, and of `auto`, over that of the faster method.

    NaN if a run fails, or `auto` chooses a stiff method.
    """
    better = np.where(np.isfinite(both["dop853"][1]), np.minimum(both["dop853"][0], both["ra15"][0]), np.nan)
    times = {method: both[method][0] / better for method in METHODS}
    taken = [times[method][k] if method in times else np.nan for k, method in enumerate(chosen(system))]
    return {**times, "auto": np.array(taken)}


def main() -> None:
    heads = [f"{formulation} {target:.0e}" for formulation in FORMULATIONS for target in TARGETS]
    print("time of ra15 over that of dop853 at equal error\n" + f"{'model':<18}" + "".join(f"{h:>18}" for h in heads))
    table, losses = [], []
    for model in (*MODELS, kinked(), held()):
        ratios = []
        for formulation in FORMULATIONS:
            system = build(model, formulation=formulation)
            both = times_and_errors(system)
            losses.append(lost(system, both))
            at = [[seconds_at(target, *both[method]) for method in METHODS] for target in TARGETS]
            ratios += [nodes / stages for stages, nodes in at]
        table.append(ratios)
        print(f"{system.name:<18}" + "".join(f"{ratio:>18.2f}" for ratio in ratios), flush=True)
    print(f"{'median':<18}" + "".join(f"{ratio:>18.2f}" for ratio in np.nanmedian(table, axis=0)))
    print("\ntime over that of the better method at equal tolerance, geometric mean over all of these: rtol")
    print(f"{'':<18}" + "".join(f"{tolerance:>8.0e}" for tolerance in TOLERANCES))
    for method in (*METHODS, "auto"):
        means = np.exp(np.nanmean([np.log(loss[method]) for loss in losses], axis=0))
        print(f"{method:<18}" + "".join(f"{mean:>8.2f}" for mean in means))


if __name__ == "__main__":
    main()
