"""Benchmark of the paper's mechanism: right-hand sides and runs of every formulation, compared with SciPy.

SciPy integrates Lagrange's equations. Ratios are medians over interleaved rounds, with quartiles. Errors are the
largest of the four errors of theta(10), compared with values on which independent integrations in many digits agree.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np
from common.classical import classical
from common.plain import right_hand_side
from common.timing import interleaved, ratio, spread
from eigenmotion.codegen.choices import FORMULATIONS
from eigenmotion.models.dual_link import model
from scipy.integrate import solve_ivp

from eigenmotion import System, build

CERTIFIED = np.array([0.700265153433880811, 2.454211044030905019, 0.141975525603218242, 1.677302668798167215])
TOLERANCES = (1e-6, 1e-9, 1e-12)
T_END, LONG = 10.0, 1000.0
REPEATS, ROUNDS = 20, 15
"""Our runs in a round, enough to be measured; rounds."""

Outcome = tuple[np.ndarray, int]
"""theta(10) (4,) and the number of right-hand sides."""


def alone(rounds: int = 21, calls: int = 200_000) -> None:
    """Print the time of one right-hand side in C, where each call depends on the one before, as in an integration."""
    with tempfile.TemporaryDirectory() as folder:
        timers = {name: right_hand_side(model, name, Path(folder)) for name in FORMULATIONS}
        nanoseconds_of = {name: np.empty(rounds) for name in FORMULATIONS}
        for k in range(rounds):
            for name, timer in timers.items():
                nanoseconds_of[name][k] = timer(calls)
    print(f"{'one right-hand side, called from C':<36} {'ns':<22} / lagrange")
    for name, nanoseconds in nanoseconds_of.items():
        print(f"  {name:<34} {spread(nanoseconds, 1.0):<22} {ratio(nanoseconds, nanoseconds_of['lagrange'])}")


def within(systems: dict[str, System]) -> None:
    """Print the time of a run at 1e-9 per right-hand side, which includes its share of steps, projection and rows.

    It is the difference between runs of two lengths, so that the constant cost of a run cancels.
    """
    at = {"rtol": 1e-9, "atol": 1e-9}
    more = {name: one.simulate((0.0, LONG), **at).nfev - one.simulate((0.0, T_END), **at).nfev
            for name, one in systems.items()}  # fmt: skip
    short = interleaved({name: partial(one.simulate, (0.0, T_END), **at) for name, one in systems.items()}, ROUNDS)
    long = interleaved({name: partial(one.simulate, (0.0, LONG), **at) for name, one in systems.items()}, ROUNDS)
    each = {name: 1e9 * (long[name] - np.median(short[name])) / more[name] for name in systems}
    print(f"\n{'one right-hand side, within a run':<36} {'ns':<22} / lagrange")
    for name, nanoseconds in each.items():
        print(f"  {name:<34} {spread(nanoseconds, 1.0):<22} {ratio(nanoseconds, each['lagrange'])}")


def around(systems: dict[str, System]) -> None:
    """Print the overhead of a run: the time of a run of zero length, with its checks and its result."""
    still = {name: partial(repeated, partial(one.simulate, (0.0, 0.0))) for name, one in systems.items()}
    print(f"\n{'a run of no length':<36} us")
    for name, seconds in interleaved(still, ROUNDS).items():
        print(f"  {name:<34} {spread(seconds / REPEATS, 1e-6)}")


def of_scipy(tolerance: float) -> Callable[[], Outcome]:
    """Return the run of `solve_ivp` on the classical equations."""
    f, p = classical(model), np.array([value for _, value in model.parameters])
    x, v = np.array(model.initial_x), np.array(model.initial_v)

    def run() -> Outcome:
        result = solve_ivp(f, (0.0, T_END), np.concatenate([x, v]), method="DOP853", rtol=tolerance, atol=tolerance,
                           args=(p,))  # fmt: skip
        return result.y[: len(x), -1], result.nfev

    return run


def of_system(system: System, tolerance: float) -> Callable[[], Outcome]:
    """Return our run as users call it, including checks of arguments."""

    def run() -> Outcome:
        solution = system.simulate((0.0, T_END), rtol=tolerance, atol=tolerance)
        return solution.y[: system.n, -1], solution.nfev

    return run


def repeated(run: Callable[[], object]) -> None:
    for _ in range(REPEATS):
        run()


def runs(systems: dict[str, System], tolerance: float) -> None:
    """Print the time of a run of 10 s at rtol = atol, and its error."""
    outcomes = {name: of_system(system, tolerance) for name, system in systems.items()}
    scipy = of_scipy(tolerance)
    seconds = interleaved({**{name: partial(repeated, run) for name, run in outcomes.items()}, "scipy": scipy}, ROUNDS)
    seconds |= {name: seconds[name] / REPEATS for name in outcomes}
    title = f"a run of 10 s, rtol = atol = {tolerance:g}"
    print(f"\n{title:<36} {'ms':<22} {'scipy / it':<18} {'/ lagrange':<18} {'rhs':<6} error")
    for name, run in (outcomes | {"scipy": scipy}).items():
        theta, nfev = run()
        beside = (ratio(seconds["scipy"], seconds[name]), ratio(seconds[name], seconds["lagrange"]))
        error = np.abs(theta - CERTIFIED).max()
        print(f"  {name:<34} {spread(seconds[name], 1e-3):<22} {beside[0]:<18} {beside[1]:<18} {nfev:<6} {error:.1e}")


def main() -> None:
    alone()
    systems = {name: build(model, formulation=name) for name in FORMULATIONS}
    within(systems)
    around(systems)
    for tolerance in TOLERANCES:
        runs(systems, tolerance)


if __name__ == "__main__":
    main()
