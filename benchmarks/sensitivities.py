"""Benchmark of sensitivities: time of a run with derivatives over that of a plain run, and the derivatives' error.

The paper's mechanism over 10 s at 1e-9, with derivatives with respect to its parameters, initial positions and initial
rates. Ratios are of the shortest processor times over rounds in which all runs alternate.
"""

from __future__ import annotations

import time
from functools import partial
from pathlib import Path

import numpy as np
from common.timing import interleaved
from eigenmotion.codegen.choices import FORMULATIONS

from eigenmotion import System, build

MODEL = Path(__file__).parents[1] / "models" / "dual_link.py"
SPAN, ROUNDS, TOLERANCE = (0.0, 10.0), 100, 1e-9


def run(system: System, method: str, names: list[str] | None) -> object:
    return system.simulate(SPAN, rtol=TOLERANCE, atol=TOLERANCE, t_eval=[SPAN[1]], method=method, sensitivities=names)


def off(system: System, names: list[str]) -> float:
    """Return the error of the derivatives at the end from those at 1e-13, relative to the largest of each name."""
    derivatives, exact = (
        system.simulate(SPAN, rtol=tolerance, atol=tolerance, t_eval=[SPAN[1]], sensitivities=names).sensitivity
        for tolerance in (TOLERANCE, 1e-13)
    )
    errors = {name: np.abs(derivatives[name].dx - exact[name].dx).max() for name in names}
    return max(float(errors[name] / np.abs(exact[name].dx).max()) for name in names)


def main() -> None:
    for formulation in FORMULATIONS:
        system = build(MODEL, formulation=formulation)
        names = [*system.parameters, *system.coordinates, *(f"{name}'" for name in system.coordinates)]
        for method in ("dop853", "ra15"):
            calls = {"plain": partial(run, system, method, None), "all": partial(run, system, method, names)}
            least = {name: seconds.min() for name, seconds in interleaved(calls, ROUNDS, time.thread_time).items()}
            print(
                f"{formulation:<12}{method:<8}{len(names)} derivatives over a plain run of "
                f"{1e6 * least['plain']:.0f} us: {least['all'] / least['plain']:.3g}"
            )
        print(f"{formulation:<12}off those of a run at 1e-13 by {off(system, names):.1e}")


if __name__ == "__main__":
    main()
