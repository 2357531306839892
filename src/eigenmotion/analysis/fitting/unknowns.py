"""Unknowns of a fit: parameters, constant inputs and initial values, with their guesses and bounds."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ...arguments.differentiation import names_of, rates_of, variable_name
from ...arguments.named_values import Vector, by_spelling, is_named, unknown, vector
from ...arguments.states import names_of_states
from ...arguments.tables import refuse_tables
from ...codegen.model.normalise import ModelError, number, shown
from ...compiled.compiled_system import CompiledSystem
from ..state.active_contacts import switches_of


@dataclass(frozen=True)
class Given:
    """The start, parameters and inputs that users give; unknowns go over them. t : of the start [s]"""

    system: CompiledSystem
    x0: Any
    v0: Any
    parameters: Any
    inputs: Any
    t: float


@dataclass(frozen=True)
class Unknowns:
    """Names of unknowns in the order of users, with guesses and bounds, each (k,)."""

    system: CompiledSystem
    names: tuple[str, ...]
    guesses: Vector
    lower: Vector
    upper: Vector

    @cached_property
    def parameters(self) -> tuple[str, ...]:
        """Names of parameters."""
        return self._among(self.system.compiled.parameters)

    @cached_property
    def inputs(self) -> tuple[str, ...]:
        """Names of constant inputs."""
        return self._among(self.system.compiled.inputs)

    @cached_property
    def positions(self) -> tuple[str, ...]:
        """Names of coordinates and states: initial values that x0 has."""
        return self._among(self.system.compiled.coordinates)

    @cached_property
    def rates(self) -> tuple[str, ...]:
        """Names of rates and quasi-velocities: initial values that v0 has."""
        others = {*self.parameters, *self.inputs, *self.positions}
        return tuple(name for name in self.names if name not in others)

    def _among(self, known: Iterable[str]) -> tuple[str, ...]:
        chosen = set(known)
        return tuple(name for name in self.names if name in chosen)


def unknowns_of(given: Given, argument: Any, bounds: Any) -> Unknowns:
    """Return the unknowns that users name, with the guesses of a mapping, or else the given values.

    Raises
    ------
    ModelError
        A name is unknown, given twice, or none of a number; a guess is not finite or not within its bounds.
    """
    c, named = given.system.compiled, is_named(argument)
    if not named and (isinstance(argument, str) or not isinstance(argument, Iterable)):
        raise ModelError(f"{c.name}: unknowns is {shown(argument)}. Give a mapping name -> guess, or a list of names.")
    guesses = by_spelling(argument, "unknowns", variable_name) if named else {}
    names = tuple(guesses) if named else tuple(map(variable_name, argument))
    _check_names(given.system, names)
    values = np.array([number(guesses[name], f"unknown {name!r}") for name in names]) if named else _own(given, names)
    lower, upper = _bounds(c.name, names, bounds)
    for name, low, value, high in zip(names, lower, values, upper, strict=True):
        if not low <= value <= high:
            raise ModelError(
                f"{c.name}: the guess of {name!r}, {value:g}, is not within its bounds, {low:g} ... {high:g}"
            )
    return Unknowns(given.system, names, values, lower, upper)


def _check_names(system: CompiledSystem, names: tuple[str, ...]) -> None:
    c = system.compiled
    modes = {c.parameters[k] for one in switches_of(c) for k in one.parameters}
    known = [name for name in dict.fromkeys(names_of(c)) if name not in modes]
    if not names:
        raise ModelError(f"{c.name}: no unknowns are named. Known: {', '.join(known)}.")
    if wrong := set(names) - set(known):
        raise ModelError(f"{c.name}: {unknown('name in unknowns', wrong, known)}")
    if twice := [name for name in names if names.count(name) > 1]:
        raise ModelError(f"{c.name}: unknown {twice[0]!r} is given twice")
    refuse_tables(c, names, "unknowns")


def _own(given: Given, names: tuple[str, ...]) -> Vector:
    """Return the values that a run without unknowns has."""
    c, n = given.system.compiled, given.system.compiled.n_coordinates
    prepared, inputs = given.system.prepare_both(given.parameters, given.inputs)
    x, v = given.system.begin(given.x0, given.v0, given.t, prepared)
    values = dict(zip(c.parameters, prepared.parameters, strict=True))
    values |= dict(zip(c.coordinates[:n], x, strict=False)) | dict(zip(names_of_states(c), v[n:], strict=True))
    values |= dict(zip(rates_of(c.coordinates[:n]), v, strict=False))
    if c.quasi_velocities:
        y = c.quasi_rows(np.array([given.t]), x[None], v[None], prepared)[0]
        values |= dict(zip(c.quasi_velocities, y, strict=True))
    for name, signal in zip(c.inputs, given.system.bind(inputs).signals, strict=True):
        if isinstance(signal, int | float):
            values[name] = float(signal)
        elif name in names:
            raise ModelError(f"{c.name}: input {name!r} is sampled; only a constant input can be unknown")
    return np.array([float(values[name]) for name in names])


def _bounds(model: str, names: tuple[str, ...], argument: Any) -> tuple[Vector, Vector]:
    """Return lower and upper bounds (k,), infinite where there are none."""
    lower, upper = np.full(len(names), -np.inf), np.full(len(names), np.inf)
    if argument is None:
        return lower, upper
    if not isinstance(argument, Mapping):
        raise ModelError(f"{model}: bounds is {shown(argument)}. Give a mapping name -> (low, high).")
    given = by_spelling(argument, "bounds", variable_name)
    if wrong := set(given) - set(names):
        raise ModelError(f"{model}: {unknown('name in bounds', wrong, names)}")
    for name, pair in given.items():
        ends = vector(pair, f"bounds of {name!r}")
        if ends.shape != (2,) or not ends[0] < ends[1]:
            raise ModelError(
                f"{model}: the bounds of {name!r} are {shown(pair)}. Give (low, high), infinite ends included."
            )
        k = names.index(name)
        lower[k], upper[k] = ends
    return lower, upper
