"""First-order states z of a compiled model: to it they are the last of its velocities, to users a part of the start.

A model of n coordinates and p states is compiled with n + p coordinates (codegen.model.statement.states): arrays x, v
of compiled functions are (x, integrals of z) and (xdot, z).
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
    """Return the names of the states; () where there are none."""
    return c.coordinates[c.n_coordinates :]


def apart(c: CompiledModel, x0: Given) -> tuple[Given, Given]:
    """Return what x0 says of coordinates, and what it says of states: None where it says nothing.

    x0 is a mapping of names, or an array (..., n), or (..., n + p) with the states behind the coordinates.
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
    """Return x (n + p,) of compiled functions: coordinates over the model's `initial`, and integrals, which are 0."""
    n = c.n_coordinates
    return np.concatenate([overlay(x, c.coordinates[:n], c.initial_x[:n], what), np.zeros(c.n_states)])


def whole_v(c: CompiledModel, v: Vector, z: Given) -> Vector:
    """Return v (n + p,) of compiled functions: rates, of which the first n are given, and states over `initial`."""
    n = c.n_coordinates
    return np.concatenate([v[:n], overlay(z, names_of_states(c), c.initial_v[n:], "state of x0")])


def refuse_states(c: CompiledModel, v0: Mapping[str, Any]) -> None:
    """Raise ModelError where velocities name a state."""
    if c.n_states and (wrong := sorted(set(v0) & set(names_of_states(c)))):
        raise ModelError(f"{c.name}: v0 gives {wrong[0]!r}, which is a state: give its value in x0.")
