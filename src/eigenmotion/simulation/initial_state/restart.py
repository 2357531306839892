"""Restart of a run from the end of another, or from a given state."""

from typing import Any

import numpy as np

from ...arguments.named_values import Vector, vector
from ...codegen.model.normalise import ModelError, number, shown
from ...results.solution import Solution
from ...runtime import CompiledModel, Prepared
from .consistency import start_state

_ROUNDED = 1e-9  # relative rounding error of a velocity
_OF_A_FACTOR = 1e-6  # relative tolerance of s and of eta^T eta = v^T M v for factors of M


def restart_state(
    model: CompiledModel, prepared: Prepared, start: Any, rtol: float, atol: Vector
) -> tuple[float, Vector]:
    """Return t and y (n_state,) of the last row of a Solution, or of a pair (t, y), checked like any start.

    Raises
    ------
    ModelError
        It is neither, it belongs to another model, or y is not a state of this model at t.
    """
    is_pair = not isinstance(start, Solution)
    t, y, x, v = _of_pair(model, prepared, start) if is_pair else _of_solution(model, start)
    fresh = start_state(model, prepared, t, x, v, rtol, atol)
    if y is not None and _means(model, prepared, t, y, v) and _has_factors(model, y, fresh):
        return t, y
    if is_pair:
        raise ModelError(
            f"{model.name}: in the y of start C and s are not the eigenfactors of M(x): give x0 and v0 instead, or a y "
            "that System.state or a Solution gave with these parameters"
        )
    return t, fresh


def _of_solution(model: CompiledModel, start: Solution) -> tuple[float, Vector | None, Vector, Vector]:
    if len(start.t) == 0:
        raise ModelError(f"{model.name}: start is a Solution without rows: there is no state to go on from")
    (x, v), y, other = (part[:, -1] for part in start.motion), start.y[:, -1], start.model
    if len(x) != model.n or (other is not None and (other.name, other.coordinates) != (model.name, model.coordinates)):
        raise ModelError(f"{model.name}: start is a Solution of {other.name if other else 'another model'}")
    same = len(y) == model.n_state and (other is None or other.formulation == model.formulation)
    return float(start.t[-1]), y.copy() if same else None, x.copy(), v.copy()


def _of_pair(model: CompiledModel, prepared: Prepared, start: Any) -> tuple[float, Vector, Vector, Vector]:
    try:
        t, y = start
    except (TypeError, ValueError) as error:
        raise ModelError(f"start is {shown(start)}, neither a Solution nor a pair (t, y)") from error
    time, state = number(t, "the t of start"), vector(y, "the y of start")
    if state.shape != (model.n_state,):
        raise ModelError(f"{model.name}: the y of start has shape {state.shape}, but must be ({model.n_state},)")
    if not np.isfinite(state).all():
        raise ModelError(f"{model.name}: the y of start holds a number that is not finite")
    v = model.velocity_rows(np.array([time]), state[None], prepared)[0]
    return time, state, state[: model.n].copy(), v


def _means(model: CompiledModel, prepared: Prepared, t: float, y: Vector, v: Vector) -> bool:
    """Return whether y has velocity v: with other parameters, the same eta means another velocity."""
    velocity = model.velocity_rows(np.array([t]), y[None], prepared)[0]
    return bool(np.allclose(velocity, v, rtol=_ROUNDED, atol=_ROUNDED * float(np.abs(v).max(initial=0.0))))


def _has_factors(model: CompiledModel, y: Vector, fresh: Vector) -> bool:
    """Return whether C and s in y are eigenfactors of M(x), like those of a fresh state except for signs and order."""
    parts, there = ({name: of[a : a + length] for name, a, length in model.layout} for of in (y, fresh))
    if "s" not in parts:
        return True
    s, expected = np.sort(parts["s"]), np.sort(there["s"])
    energy = float(there["eta"] @ there["eta"])
    return bool(
        np.allclose(s, expected, rtol=_OF_A_FACTOR, atol=0.0)
        and abs(float(parts["eta"] @ parts["eta"]) - energy) <= _OF_A_FACTOR * energy
    )
