"""The paper's mechanism: every formulation, per right-hand side and per run of 10 s, beside SciPy on Lagrange's equations.

Ratios are medians over interleaved rounds, with quartiles; errors are those of theta(10), the largest of four, against
values that independent integrations in many digits agree on.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np
from common.classical import classical
from common.plain import right_hand_side
from common.timing import interleaved, ratio, spread
from eigenmotion import System, build
from eigenmotion.models.dual_link import model
from scipy.integrate import solve_ivp

FORMULATIONS = ("eigenfactor", "cholesky", "lagrange", "inverse")
CERTIFIED = np.array([0.700265153433880811, 2.454211044030905019, 0.141975525603218242, 1.677302668798167215])
TOLERANCES = (1e-6, 1e-9, 1e-12)
SPAN = (0.0, 10.0)
OURS, THEIRS, ROUNDS = 20, 1, 15
"""Runs a round, so that both sides take a time that can be measured; rounds."""


def right_hand_sides(rounds: int = 21, calls: int = 200_000) -> None:
    """Print nanoseconds of one right-hand side in C, and the ratios to lagrange."""
    with tempfile.TemporaryDirectory() as folder:
        timers = {name: right_hand_side(model, name, Path(folder)) for name in FORMULATIONS}
        found = {name: np.empty(rounds) for name in FORMULATIONS}
        for k in range(rounds):
            for name, timer in timers.items():
                found[name][k] = timer(calls)
    print("one right-hand side, called from C     ns                       / lagrange")
    for name, nanoseconds in found.items():
        print(f"  {name:<36} {spread(nanoseconds, 1.0):<24} {ratio(nanoseconds, found['lagrange'])}")


def runs(systems: dict[str, System], tolerance: float) -> None:
    """Print the time of a run at rtol = atol, as a user calls it, and the error it leaves."""
    f, p = classical(model), np.array([value for _, value in model.parameters])
    start = np.concatenate(next(iter(systems.values())).initial)

    def scipy() -> np.ndarray:
        return solve_ivp(f, SPAN, start, method="DOP853", rtol=tolerance, atol=tolerance, args=(p,)).y[:4, -1]

    def ours(system: System) -> None:
        for _ in range(OURS):
            system.simulate(SPAN, rtol=tolerance, atol=tolerance)

    actions = {name: lambda system=system: ours(system) for name, system in systems.items()}
    seconds = interleaved({**actions, "scipy": scipy}, ROUNDS)
    for name in systems:
        seconds[name] /= OURS
    print(f"\nrtol = atol = {tolerance:g}  ms a run           scipy / it         it / lagrange      rhs    ns/rhs   error")
    for name, system in systems.items():
        solution = system.simulate(SPAN, rtol=tolerance, atol=tolerance)
        error = np.abs(solution.x[:, -1] - CERTIFIED).max()
        report(name, seconds, solution.nfev, error)
    nfev = solve_ivp(f, SPAN, start, method="DOP853", rtol=tolerance, atol=tolerance, args=(p,)).nfev
    report("scipy", seconds, nfev, np.abs(scipy() - CERTIFIED).max())


def report(name: str, seconds: dict[str, np.ndarray], nfev: int, error: float) -> None:
    own = seconds[name]
    slower, beside = ratio(seconds["scipy"], own), ratio(own, seconds["lagrange"])
    each = 1e9 * np.median(own) / nfev
    print(f"  {name:<18} {spread(own, 1e-3):<20} {slower:<18} {beside:<18} {nfev:<6} {each:<8.3g} {error:.1e}")


def main() -> None:
    right_hand_sides()
    systems = {name: build(model, formulation=name) for name in FORMULATIONS}
    for tolerance in TOLERANCES:
        runs(systems, tolerance)


if __name__ == "__main__":
    main()
