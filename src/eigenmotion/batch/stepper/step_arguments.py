"""Arguments of calls of a batch of steppers, for K members."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...arguments.named_values import Vector, by_name, is_named, vector
from ...codegen.model.normalise import ModelError, shown
from ...runtime import CompiledModel


def numbers(argument: ArrayLike, count: int, what: str) -> Vector:
    """Return a finite number, or (K,) of them."""
    values = vector(argument, what)
    if values.shape not in ((), (count,)):
        raise ModelError(f"{what} has shape {values.shape}; give a number, or ({count},), one for each member")
    if not np.isfinite(values).all():
        raise ModelError(f"{what} holds a number that is not finite")
    return values


def columns(argument: Mapping[Any, ArrayLike] | ArrayLike, names: tuple[str, ...], over: Vector) -> Vector:
    """Return inputs (K, n_inputs): the current ones updated by name, or all new; (K,) is allowed for a single input."""
    updated = over.copy()
    if is_named(argument):
        for name, value in by_name(argument, names, "input").items():
            updated[:, names.index(name)] = numbers(value, len(updated), f"input {name!r}")
        return updated
    values = vector(argument, "inputs")
    if len(names) == 1 and values.shape == (len(updated),):
        values = values[:, None]
    if values.shape not in ((len(names),), updated.shape):
        raise ModelError(f"inputs has shape {values.shape}, but must be {updated.shape}: {', '.join(names) or 'none'}")
    updated[...] = values
    _check_finite(updated, names, np.arange(len(updated)), "input")
    return updated


def rows(argument: Any, names: tuple[str, ...], over: Vector, chosen: NDArray[np.intp], what: str) -> Vector:
    """Return (K, n): the current values updated by name, or new rows; rows of members not chosen are ignored."""
    if argument is None:
        return over
    updated = over.copy()
    if is_named(argument):
        for name, value in by_name(argument, names, what).items():
            updated[:, names.index(name)] = _column(value, len(updated), f"{what} {name!r}")
    else:
        values = vector(argument, what)
        if values.shape not in (updated.shape, updated.shape[1:]):
            raise ModelError(f"{what}: shape {values.shape}, but must be {updated.shape}: {', '.join(names)}")
        updated[...] = values
    _check_finite(updated, names, chosen, what)
    return updated


def _column(argument: ArrayLike, count: int, what: str) -> Vector:
    values = vector(argument, what)
    if values.shape not in ((), (count,)):
        raise ModelError(f"{what} has shape {values.shape}; give a number, or ({count},) numbers")
    return values


def _check_finite(updated: Vector, names: tuple[str, ...], chosen: NDArray[np.intp], what: str) -> None:
    if not np.isfinite(updated[chosen]).all():
        k, place = np.argwhere(~np.isfinite(updated[chosen]))[0]
        raise ModelError(f"{what} {names[place]!r} of member {chosen[k]} is not a finite number")


def check_way(model: CompiledModel, goals: Vector, t: Vector, ended: NDArray[np.bool_]) -> None:
    """Raise ModelError if a member would go backwards in a model with event actions."""
    back = (goals < t) & ~ended if model.acts else ended[:0]
    if back.any():
        raise ModelError(
            f"{model.name}: events that act do so forwards only, so member {int(back.argmax())} cannot go back: "
            "restore what was saved"
        )


def chosen_by(mask: ArrayLike | None, count: int) -> NDArray[np.intp]:
    """Return the members that a mask selects: (K,) booleans, or indices; None: all."""
    if mask is None:
        return np.arange(count)
    array = np.asarray(mask)
    if array.dtype == np.bool_ and array.shape == (count,):
        return np.flatnonzero(array)
    if array.ndim == 1 and (array.dtype.kind in "iu" or array.size == 0):
        if array.size and not (array.min() >= 0 and array.max() < count):
            raise ModelError(f"mask names members from {array.min()} to {array.max()}; there are 0 ... {count - 1}")
        return np.unique(array).astype(np.intp)
    raise ModelError(f"mask is {shown(mask)}, neither ({count},) truth values nor indices of members")
