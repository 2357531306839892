"""Conversion of velocities: rates xdot and quasi-velocities y = P(x, t) xdot (3)."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..arguments.named_values import Vector, by_spelling, is_named, overlay, rate_name, unknown
from ..arguments.states import refuse_states, split_states, whole_v, whole_x
from ..codegen.model import ModelError
from ..codegen.model.check.elimination import is_singular
from ..runtime import CompiledModel, Prepared

_SINGULAR = 1e-14  # pivots of P below this part of their terms leave no correct digit of xdot = P^-1 y
_NEARBY = 2.0**-26  # relative change of a coordinate, for the effect of its rounding on P


def transformation(model: CompiledModel, c: Prepared, t: float, x: Vector) -> Vector:
    """Return P (n, n) of y = P(x, t) xdot (3): the compiled P xdot for unit velocities."""
    rows = np.full(model.n, t), np.tile(x, (model.n, 1))
    return np.ascontiguousarray(model.quasi_rows(*rows, np.eye(model.n), c).T)


def rates_from(model: CompiledModel, c: Prepared, t: float, x: Vector, y: Vector) -> Vector:
    """Return xdot (n,) = P(x, t)^-1 y.

    Raises
    ------
    ModelError
        P is singular or not finite at x, such as P of body rates with Euler angles in gimbal lock.
    """
    P = transformation(model, c, t, x)
    if not np.isfinite(P).all() or is_singular(P.tolist(), _terms(model, c, t, x, P).tolist(), _SINGULAR):
        raise ModelError(
            f"{model.name}: the quasi-velocities ({', '.join(model.quasi_velocities)}) do not determine the rates at "
            "x0, where P of y = P(x) xdot is singular. Start elsewhere, give v0 in rates, or choose other coordinates."
        )
    return np.asarray(np.linalg.solve(P, y))


def _terms(model: CompiledModel, c: Prepared, t: float, x: Vector, P: Vector) -> Vector:
    """Return about |P_ij| + sum_k |x_k dP_ij / dx_k| (n, n), to which the rounding of P and x is proportional."""
    moved = [transformation(model, c, t, place) for place in x * (1.0 + _NEARBY * np.eye(model.n))]
    return np.asarray(np.abs(P) + sum(np.abs(at - P) for at in moved) / _NEARBY)


def converted_start(
    model: CompiledModel,
    c: Prepared,
    t: float,
    x0: Mapping[Any, float] | ArrayLike | None,
    v0: Mapping[Any, float] | ArrayLike | None,
) -> tuple[Vector, Vector]:
    """Return new x, v (n + p,) of compiled functions: x0 and v0 over the model's `initial`, with states in v."""
    x0, z = split_states(model, x0)
    x = whole_x(model, x0)
    v = initial_rates(model, c, t, x, v0)
    return x, whole_v(model, v, z) if model.n_states else v


def initial_rates(
    model: CompiledModel, c: Prepared, t: float, x: Vector, v0: Mapping[Any, float] | ArrayLike | None
) -> Vector:
    """Return v (n,) at x: v0 (an array of rates, or rates or quasi-velocities by name) over the model's `initial`.

    If `initial` has quasi-velocities, these apply at any x, t and parameters.

    Raises
    ------
    ModelError
        Unknown names, rates and quasi-velocities together, or quasi-velocities where P is singular.
    """
    if not is_named(v0):
        n = model.n_coordinates
        if v0 is None:
            return _default(model, c, t, x)
        return whole_v(model, overlay(v0, model.coordinates[:n], model.initial_v[:n], "v0"), None)
    argument = by_spelling(v0, "v0", rate_name)
    refuse_states(model, argument)
    quasi = argument.keys() & set(model.quasi_velocities)
    if not quasi:
        _check_names(model, argument)
        complete = len(argument) == model.n_coordinates
        start = model.initial_v if complete else _default(model, c, t, x)
        return overlay(argument, model.coordinates, start, "coordinate of v0")
    if rates := argument.keys() & set(model.coordinates):
        raise ModelError(
            f"{model.name}: v0 gives rates ({', '.join(sorted(rates))}) and quasi-velocities "
            f"({', '.join(sorted(quasi))}). Give the velocities in one of the two."
        )
    y = overlay(argument, model.quasi_velocities, _default_quasi(model, c, t, x), "quasi-velocity of v0")
    return rates_from(model, c, t, x, y)


def _default(model: CompiledModel, c: Prepared, t: float, x: Vector) -> Vector:
    if model.initial_y is None:
        return model.initial_v.copy()
    return rates_from(model, c, t, x, model.initial_y)


def _default_quasi(model: CompiledModel, c: Prepared, t: float, x: Vector) -> Vector:
    if model.initial_y is not None:
        return model.initial_y
    return transformation(model, c, t, x) @ model.initial_v


def _check_names(model: CompiledModel, argument: Mapping[str, Any]) -> None:
    if wrong := argument.keys() - set(model.coordinates):
        raise ModelError(unknown("coordinate of v0", wrong, (*model.coordinates, *model.quasi_velocities)))
