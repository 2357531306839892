"""First-order states z: conversion between the arguments of users and arrays of compiled functions.

A model of n coordinates and p states is compiled with n + p coordinates (codegen.model.statement.states). The arrays
x, v of compiled functions are (x, integrals of z) and (xdot, z).
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..codegen.model.normalise import ModelError
from ..runtime import CompiledModel
from .named_values import Vector, by_spelling, is_named, overlay, vector

Given = Mapping[Any, Any] | ArrayLike | None


def names_of_states(c: CompiledModel) -> tuple[str, ...]:
    """Return the names of the states."""
    return c.coordinates[c.n_coordinates :]


def split_states(c: CompiledModel, x0: Given) -> tuple[Given, Given]:
    """Split x0 into coordinates and states; None for states that x0 does not have.

    x0 is a mapping of names, an array (..., n), or an array (..., n + p) with the states behind the coordinates.
    """
    if x0 is None or not c.n_states:
        return x0, None
    if not is_named(x0):
        values, n = vector(x0, "x0"), c.n_coordinates
        whole = values.ndim > 0 and values.shape[-1] == c.n
        return (values[..., :n], values[..., n:]) if whole else (values, None)
    named, states = by_spelling(x0, "x0"), names_of_states(c)
    return (
        {name: value for name, value in named.items() if name not in states},
        {name: value for name, value in named.items() if name in states},
    )


def whole_x(c: CompiledModel, x: Given, what: str = "coordinate of x0") -> Vector:
    """Return x (n + p,) of compiled functions: coordinates over the model's `initial`, and zeros for the integrals."""
    n = c.n_coordinates
    return np.concatenate([overlay(x, c.coordinates[:n], c.initial_x[:n], what), np.zeros(c.n_states)])


def whole_v(c: CompiledModel, v: Vector, z: Given) -> Vector:
    """Return v (n + p,) of compiled functions: the first n of v, and the states z over `initial`."""
    n = c.n_coordinates
    return np.concatenate([v[:n], overlay(z, names_of_states(c), c.initial_v[n:], "state of x0")])


def refuse_states(c: CompiledModel, v0: Mapping[str, Any]) -> None:
    """Raise ModelError if v0 names a state."""
    if c.n_states and (wrong := sorted(set(v0) & set(names_of_states(c)))):
        raise ModelError(f"{c.name}: v0 gives {wrong[0]!r}, which is a state: give its value in x0.")
