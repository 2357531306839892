"""Actuators by name: coordinates on which forces act, and inputs."""

from collections.abc import Iterable
from typing import Any

import numpy as np

from ...arguments.named_values import Vector, by_spelling, is_named, spelled, unknown
from ...codegen.model.normalise import ModelError, number
from ...runtime import Actuators, CompiledModel


def actuators_of(c: CompiledModel, given: Any) -> Actuators:
    """Return actuators given by name, or as a mapping name -> weight of the squared force; None: all coordinates.

    Raises
    ------
    ModelError
        There are none; a name is neither a coordinate nor an input; an input prescribes a motion, or forces are not
        linear in the inputs among them; a weight is not positive.
    """
    if given is None:
        return _named(c, None)
    names = () if isinstance(given, str) or not isinstance(given, Iterable) else tuple(given)
    if not names:
        raise ModelError(f"actuators is {given!r}. Give names of coordinates or inputs, as ('{c.coordinates[0]}',).")
    if not is_named(given):
        return _named(c, tuple(map(spelled, names)))
    weights = by_spelling(given, "actuators")
    values = tuple(number(value, f"the weight of actuator {name!r}") for name, value in weights.items())
    if min(values) <= 0.0:
        raise ModelError(f"actuators: weights are positive, and {dict(zip(weights, values, strict=True))} are given")
    return _made(c, tuple(weights), values)


def _named(c: CompiledModel, names: tuple[str, ...] | None) -> Actuators:
    """Return actuators without weights, which the model keeps for later calls."""
    if names not in c.known_actuators:
        c.known_actuators[names] = _made(c, names or (), None)
    return c.known_actuators[names]


def _made(c: CompiledModel, names: tuple[str, ...], weights: tuple[float, ...] | None) -> Actuators:
    for name in names:
        _check(c, name, names)
    own = c.coordinates[: c.n_coordinates]
    coordinates = [own.index(name) if name in own else -1 for name in names]
    inputs = [c.inputs.index(name) if name in c.inputs else -1 for name in names]
    return Actuators(names, coordinates, inputs, weights)


def columns_of(c: CompiledModel, of: Actuators, by_inputs: Vector) -> Vector:
    """Return B (n, count): the forces that actuators give, from df / du (n, n_inputs)."""
    B = np.zeros((c.n_coordinates, len(of.names)))
    for k, name in enumerate(of.names):
        if name in c.inputs:
            B[:, k] = by_inputs[:, c.inputs.index(name)]
        else:
            B[c.coordinates.index(name), k] = 1.0
    return B


def _check(c: CompiledModel, name: str, names: tuple[str, ...]) -> None:
    """Raise ModelError if this is no actuator."""
    own = c.coordinates[: c.n_coordinates]
    if names.count(name) > 1:
        raise ModelError(f"{c.name}: actuator {name!r} is given twice")
    if name in c.prescribed:
        raise ModelError(f"{c.name}: input {name!r} prescribes a motion. The multiplier of its row is what drives it.")
    if name in c.coordinates and name not in own:
        raise ModelError(f"{c.name}: {name!r} is a first-order state, on which no force acts")
    if name not in own and name not in c.inputs:
        raise ModelError(f"{c.name}: {unknown('actuator', [name], (*own, *c.inputs))}")
    if name in c.inputs and (others := _mixed_with(c, name, names)):
        what = f"input {name!r}" if name in others else f"inputs {name!r} and {others[0]!r} together"
        raise ModelError(
            f"{c.name}: forces are not linear in {what}. Take the coordinates on which they act for actuators, and "
            "find the inputs that give their forces."
        )


def _mixed_with(c: CompiledModel, name: str, names: tuple[str, ...]) -> list[str]:
    """Return the actuators on which the effect of an input depends, itself among them."""
    place = c.inputs.index(name)
    return [one for one in names if one in c.inputs and (place, c.inputs.index(one)) in c.mixed_inputs]
