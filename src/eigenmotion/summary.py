"""What a run came to, in a few lines of text."""

import numpy as np

from .names import Vector
from .solution import Solution
from .system import System


def summary(system: System, solution: Solution, seconds: float) -> str:
    """Say how a run ended, where, how well it kept its invariants, and what it cost.

    Parameters
    ----------
    seconds
        Wall time of the run [s].
    """
    rows = [
        ("model", f"{system.name}, {system.formulation}, {system.n_state} states"),
        ("ended", f"{solution.stop} at t = {solution.t[-1]:.10g}"),
        *_invariants(system, solution),
        ("cost", f"{solution.nsteps} steps, {solution.nrejected} rejected, {solution.nfev} right-hand sides"),
        ("time", f"{_duration(seconds)} for the run"),
    ]
    lines = [f"{label:<22} {text}" for label, text in rows]
    if not solution.success:
        lines.append(f"{'':<22} {solution.message}")
    return "\n".join([*lines, "", _final_state(system, solution)])


def _invariants(system: System, solution: Solution) -> list[tuple[str, str]]:
    """Only what this scene has: energy where it is conserved, constraints and factors where there are any."""
    rows = []
    if system.conserves_energy:
        drift = solution.jacobi_integral - solution.jacobi_integral[0]
        rows.append(("energy drift", f"{_largest(drift):.2e} of {solution.jacobi_integral[0]:.6g}"))
    if system.h:
        rows.append(("position violation", f"{_largest(solution.position_residual):.2e}"))
    if system.m:
        rows.append(("constraint violation", f"{_largest(solution.constraint_residual):.2e}"))
    if system.formulation == "eigenfactor":
        rows.append(("factor residual", f"{_largest(solution.factor_residual):.2e}"))
    return rows


def _final_state(system: System, solution: Solution) -> str:
    width = max(map(len, system.coordinates))
    lines = [f"{'':<{width}} {'x':>23} {'xdot':>23}"]
    for name, x, v in zip(system.coordinates, solution.x[:, -1], solution.v[:, -1], strict=True):
        lines.append(f"{name:<{width}} {x:>23.16g} {v:>23.16g}")
    return "\n".join(lines)


def _largest(values: Vector) -> float:
    return float(np.max(np.abs(values), initial=0.0))


def _duration(seconds: float) -> str:
    return f"{seconds:.3g} s" if seconds >= 1 else f"{1e3 * seconds:.3g} ms"
