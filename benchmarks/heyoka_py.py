"""Benchmark of the paper's mechanism compared with heyoka.py: whole Python calls over 10 s, at heyoka.py's tolerances.

Each of our runs has the loosest tolerance, in half decades, with at most twice the error of heyoka.py's run. Ratios are
medians over interleaved rounds, with quartiles. Errors are the largest of the four errors of theta(10).
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from importlib.util import find_spec
from time import thread_time

import numpy as np
from common.timing import interleaved, ratio, spread
from eigenmotion.codegen.choices import FORMULATIONS
from eigenmotion.models.dual_link import model
from paper_scene import CERTIFIED, T_END, of_scipy

from eigenmotion import System, build
from eigenmotion.reference.lagrange_equations import classical
from eigenmotion.report.peers import Peers, Start, peers

TOLERANCES = (1e-6, 1e-9, 1e-12)
OURS = 10.0 ** -np.arange(3.0, 14.0, 0.5)
METHODS = ("dop853", "ra15")
REPEATS, ROUNDS = 10, 21


def start() -> Start:
    return Start(np.concatenate([model.initial_x, model.initial_v]), len(model.initial_x), T_END)


def theirs(others: Peers, tolerance: float) -> tuple[Callable[[], object], float]:
    """Return the run of heyoka.py and its error."""
    attempt = next(solver for solver in others.solvers if solver.family == "heyoka.py").attempt(tolerance)
    track = attempt.track(np.array([0.0, T_END]), attempt.run())
    return attempt.run, float(np.abs(track.x[-1] - CERTIFIED).max())


def as_good(system: System, method: str, error: float) -> tuple[Callable[[], object], float, float] | None:
    """Return the run with the loosest tolerance whose error is at most `error`, its tolerance and its error."""
    for tolerance in OURS:
        run = partial(system.simulate, (0.0, T_END), rtol=tolerance, atol=tolerance, method=method)
        if (off := float(np.abs(run().x[:, -1] - CERTIFIED).max())) <= error:
            return run, tolerance, off
    return None


def repeated(run: Callable[[], object]) -> None:
    for _ in range(REPEATS):
        run()


def compared(systems: dict[str, System], others: Peers, tolerance: float) -> None:
    """Print the time of each of our runs over that of heyoka.py, at one of its tolerances."""
    run, error = theirs(others, tolerance)
    good = {f"{name} {method}": as_good(system, method, 2.0 * error)
            for name, system in systems.items() for method in METHODS}  # fmt: skip
    calls = {"heyoka.py": run, **{name: one[0] for name, one in good.items() if one}}
    seconds = interleaved({name: partial(repeated, call) for name, call in calls.items()}, ROUNDS, thread_time)
    scipy = interleaved({"": of_scipy(tolerance)}, 3, thread_time)[""]
    best = min(seconds, key=lambda name: np.median(seconds[name]))
    print(f"\nheyoka.py at {tolerance:g}: {spread(seconds['heyoka.py'] / REPEATS, 1e-6)} us, error {error:.1e}; "
          f"SciPy's DOP853 over {best}: {np.median(scipy) / np.median(seconds[best]) * REPEATS:.0f}")  # fmt: skip
    for name, one in good.items():
        if one is None:
            print(f"  {name:<20} never so good")
            continue
        beside = ratio(seconds[name], seconds["heyoka.py"])
        print(f"  {name:<20} {beside:<22} at {one[1]:.0e}, error {one[2]:.1e}")


def main() -> None:
    if find_spec("heyoka") is None:
        print("left out: heyoka.py is not installed (pip install 'eigenmotion[peers]')")
        return
    others = peers(classical(model), start())
    systems = {name: build(model, formulation=name) for name in FORMULATIONS}
    for tolerance in TOLERANCES:
        compared(systems, others, tolerance)


if __name__ == "__main__":
    main()
