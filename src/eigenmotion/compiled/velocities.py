"""Velocities in rates xdot and in quasi-velocities y = P(x, t) xdot (3)."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..arguments.named_values import Vector, by_spelling, is_named, overlay, rate_name, unknown
from ..arguments.states import refuse_states, whole_v
from ..codegen.model import ModelError
from ..codegen.model.check.elimination import is_singular
from ..runtime import CompiledModel, Prepared

_SINGULAR = 1e-14  # the part of its terms below which a pivot of P leaves no digit of xdot = P^-1 y right
_NEARBY = 2.0**-26  # relative change of a coordinate, for what the rounding of x makes of P


def transformation(model: CompiledModel, c: Prepared, t: float, x: Vector) -> Vector:
    """Return P (n, n) of y = P(x, t) xdot (3): what the compiled P xdot makes of unit velocities."""
    rows = np.full(model.n, t), np.tile(x, (model.n, 1))
    return np.ascontiguousarray(model.quasi_rows(*rows, np.eye(model.n), c).T)


def rates_from(model: CompiledModel, c: Prepared, t: float, x: Vector, y: Vector) -> Vector:
    """Return xdot (n,) = P(x, t)^-1 y.

    Raises
    ------
    ModelError
        P is singular or not finite at x, as that of body rates in Euler angles in gimbal lock.
    """
    P = transformation(model, c, t, x)
    if not np.isfinite(P).all() or is_singular(P.tolist(), _terms(model, c, t, x, P).tolist(), _SINGULAR):
        raise ModelError(
            f"{model.name}: the quasi-velocities ({', '.join(model.quasi_velocities)}) do not determine the rates at "
            "x0, where P of y = P(x) xdot is singular. Start elsewhere, give v0 in rates, or choose other coordinates."
        )
    return np.asarray(np.linalg.solve(P, y))


def _terms(model: CompiledModel, c: Prepared, t: float, x: Vector, P: Vector) -> Vector:
    """(n, n) about |P_ij| + sum_k |x_k dP_ij / dx_k|: what the rounding of P and of x is in proportion to."""
    moved = [transformation(model, c, t, place) for place in x * (1.0 + _NEARBY * np.eye(model.n))]
    return np.asarray(np.abs(P) + sum(np.abs(at - P) for at in moved) / _NEARBY)


def initial_rates(
    model: CompiledModel, c: Prepared, t: float, x: Vector, v0: Mapping[Any, float] | ArrayLike | None
) -> Vector:
    """Return v (n,) at x: an array of rates, or a mapping of rates or of quasi-velocities over the model's `initial`.

    Where the model starts from given quasi-velocities, these hold, also at another x, t or parameters.

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
    given = by_spelling(v0, "v0", rate_name)
    refuse_states(model, given)
    quasi = given.keys() & set(model.quasi_velocities)
    if not quasi:
        _check_names(model, given)
        complete = len(given) == model.n_coordinates
        start = model.initial_v if complete else _default(model, c, t, x)
        return overlay(given, model.coordinates, start, "coordinate of v0")
    if rates := given.keys() & set(model.coordinates):
        raise ModelError(
            f"{model.name}: v0 gives rates ({', '.join(sorted(rates))}) and quasi-velocities "
            f"({', '.join(sorted(quasi))}). Give the velocities in one of the two."
        )
    y = overlay(given, model.quasi_velocities, _default_quasi(model, c, t, x), "quasi-velocity of v0")
    return rates_from(model, c, t, x, y)


def _default(model: CompiledModel, c: Prepared, t: float, x: Vector) -> Vector:
    if model.initial_y is None:
        return model.initial_v.copy()
    return rates_from(model, c, t, x, model.initial_y)


def _default_quasi(model: CompiledModel, c: Prepared, t: float, x: Vector) -> Vector:
    if model.initial_y is not None:
        return model.initial_y
    return transformation(model, c, t, x) @ model.initial_v


def _check_names(model: CompiledModel, given: Mapping[str, Any]) -> None:
    if wrong := given.keys() - set(model.coordinates):
        raise ModelError(unknown("coordinate of v0", wrong, (*model.coordinates, *model.quasi_velocities)))
