"""Summary of a run as a few lines of text."""

from itertools import zip_longest

import numpy as np

from ...arguments.named_values import Vector
from ...compiled.compiled_system import CompiledSystem
from ...presentation.units import unit_of, with_unit
from ..multiplier_uniqueness import in_words
from ..solution import Solution


def summary(system: CompiledSystem, solution: Solution, seconds: float) -> str:
    """Return a summary: how and where a run ended, its events, drifts and cost.

    Parameters
    ----------
    seconds
        Wall time of the run [s], including the error estimate.
    """
    checking = solution.error_cost.seconds if solution.error_cost else 0.0
    rows = [
        ("model", f"{system.name}, {system.formulation}, {system.n_state} states"),
        ("ended", f"{solution.stop} at t = {solution.t[-1]:.10g}"),
        *_events(system, solution),
        *_invariants(system, solution),
        ("cost", f"{solution.cost}, by {_methods(solution)}"),
        ("time", f"{_duration(seconds - checking)} for the run"),
        *_estimate(solution),
        *_not_unique(system, solution),
    ]
    lines = [f"{label:<22} {text}" for label, text in rows]
    if not solution.success:
        lines.append(f"{'':<22} {solution.message}")
    return "\n".join([*lines, "", _final_state(system, solution)])


_MODES = {
    ("held", 1.0): "held",
    ("stuck", 1.0): "stuck",
    ("slides", 1.0): "slides forward",
    ("slides", -1.0): "slides back",
}


def _methods(solution: Solution) -> str:
    return " and ".join(dict.fromkeys(name for _, name in solution.methods)) or solution.method


def _events(system: CompiledSystem, solution: Solution) -> list[tuple[str, str]]:
    """Return the number of times and the last time of each event, and the mode at the end."""
    rows = []
    for name, times in zip(system.events, solution.t_events or (), strict=True):
        last = (
            "" if not len(times) else f"at t = {times[0]:.10g}" if len(times) == 1 else f"last at t = {times[-1]:.10g}"
        )
        rows.append((f"event {name}", f"{len(times)} times, {last}" if len(times) > 1 else last or "did not happen"))
    if solution.modes:
        mode = ((*name.rpartition("_"), value) for name, value in solution.modes[-1][1].items())
        texts = [f"{name} {_MODES[kind, value]}" for name, _, kind, value in mode if (kind, value) in _MODES]
        rows.append(("mode at the end", ", ".join(texts) or "nothing touches or rubs"))
    return rows


def _invariants(system: CompiledSystem, solution: Solution) -> list[tuple[str, str]]:
    """Return the drifts of this scene: energy if it is conserved, constraints and factors if there are any."""
    rows = []
    if system.conserves_energy:
        label = "energy change" if _acted(system, solution) else "energy drift"
        with np.errstate(invalid="ignore"):  # of energies that overflow, the change is not a number
            drift = solution.jacobi_integral - solution.jacobi_integral[0]
        rows.append((label, f"{_largest(drift):.2e} of {solution.jacobi_integral[0]:.6g}"))
    if system.h:
        rows.append(("position violation", f"{_largest(solution.position_residual):.2e}"))
    if system.m:
        rows.append(("constraint violation", f"{_largest(solution.constraint_residual):.2e}"))
    if system.formulation == "eigenfactor":
        rows.append(("factor residual", f"{_largest(solution.factor_residual):.2e}"))
    return rows


def _not_unique(system: CompiledSystem, solution: Solution) -> list[tuple[str, str]]:
    """Return the constraint rows whose multipliers are not unique."""
    rows = in_words(system.compiled, solution.not_unique)
    return [("multipliers", f"of {rows} not unique: those of least norm")] if rows else []


def _acted(system: CompiledSystem, solution: Solution) -> bool:
    """Return whether an event changed the state, and thus the energy."""
    happened = zip(solution.t_events or (), system.compiled.acting, strict=True)
    return any(len(times) > 0 and acts for times, acts in happened)


def _estimate(solution: Solution) -> list[tuple[str, str]]:
    """Return the estimated error and the cost of the estimate, if there is one."""
    estimate, cost = solution.error_estimate, solution.error_cost
    if estimate is None or cost is None:
        return []
    if np.isnan(estimate.scaled):
        return [("estimated error", estimate.message)]
    size = (
        f"{estimate.scaled:.1e} at t = {estimate.t:.10g}, at most {estimate.scaled_largest:.1e} on the way: "
        "largest |error of x| / (1 + |x|)"
    )
    second = (
        f"{cost.method} at rtol {cost.rtol:.1e}, {cost.nfev} right-hand sides, {_duration(cost.seconds)}: "
        f"{cost.share:.2g} times as long as the steps of the first"
    )
    rows = [("estimated error", size), ("from a second run", second)]
    return [*rows, ("", estimate.message)] if estimate.message else rows


def _final_state(system: CompiledSystem, solution: Solution) -> str:
    """Return the last row, with the error of each number if it was estimated there."""
    units, estimate = system.units, solution.error_estimate
    named = {name: with_unit(name, unit_of(units, name)) for name in (*system.coordinates, *system.states)}
    width = max(map(len, named.values()))
    table = {"x": solution.x[:, -1], "xdot": solution.v[:, -1]}
    lines = [f"{'':<{width}} " + " ".join(f"{head:>23}" for head in table)]
    for name, *numbers in zip(system.coordinates, *table.values(), strict=True):
        lines.append(f"{named[name]:<{width}} " + " ".join(f"{number + 0.0:>23.16g}" for number in numbers))
    lines += [f"{named[name]:<{width}} {values[-1] + 0.0:>23.16g}" for name, values in solution.states.items()]
    if estimate is None or np.isnan(estimate.scaled) or estimate.t != solution.t[-1]:
        return "\n".join(lines)
    errors = ["errors of x, xdot", *(f"{x:>14.1e} {v:>8.1e}" for x, v in zip(estimate.x, estimate.v, strict=True))]
    return "\n".join(f"{line}   {more}".rstrip() for line, more in zip_longest(lines, errors, fillvalue=""))


def _largest(values: Vector) -> float:
    return float(np.max(np.abs(values), initial=0.0))


def _duration(seconds: float) -> str:
    return f"{seconds:.3g} s" if seconds >= 1 else f"{1e3 * seconds:.3g} ms"
