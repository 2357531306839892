"""Measurements of a motion: samples of coordinates, rates, states and outputs, and their standard deviations."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...arguments.differentiation import rates_of, variable_name
from ...arguments.named_values import Vector, by_spelling, is_named, unknown, vector
from ...arguments.states import names_of_states
from ...codegen.model.normalise import ModelError, number
from ...results.solution import Solution
from ...runtime import CompiledModel
from ..state.operating_point import OperatingPoint
from ..state.output_derivatives import output_derivatives


@dataclass(frozen=True)
class Quantity:
    """A measured quantity.

    samples : (nt,), NaN where one is missing
    seen : (nt,) whether there is one
    deviation : standard deviation of a sample, or None: it is to be estimated
    """

    name: str
    samples: Vector
    seen: Vector
    deviation: float | None

    @property
    def count(self) -> int:
        """The number of samples."""
        return int(self.seen.sum())


def quantities_of(c: CompiledModel, measured: Any, times: Vector, deviations: Any) -> tuple[Quantity, ...]:
    """Return what users have measured at times (nt,).

    Raises
    ------
    ModelError
        A name is unknown, a shape is another, a sample is infinite, all are missing, or a deviation is not positive.
    """
    samples = _samples(c, measured)
    known = _known_deviations(c, tuple(samples), deviations)
    made = []
    for name, values in samples.items():
        if values.shape != times.shape:
            raise ModelError(f"{c.name}: measured {name!r} has shape {values.shape}, but there are {len(times)} times")
        if np.isinf(values).any():
            raise ModelError(f"{c.name}: measured {name!r} is infinite. Give NaN for a sample that is missing.")
        if np.isnan(values).all():
            raise ModelError(f"{c.name}: all samples of measured {name!r} are missing. Leave it out.")
        made.append(Quantity(name, values, ~np.isnan(values), known.get(name)))
    return tuple(made)


def _samples(c: CompiledModel, measured: Any) -> dict[str, Vector]:
    own = c.coordinates[: c.n_coordinates]
    if not is_named(measured):
        array = vector(measured, "measured")
        if array.ndim != 2 or len(array) != len(own):
            raise ModelError(f"{c.name}: measured has shape {array.shape}. Give ({len(own)}, times), of "
                             f"{', '.join(own)}, or a mapping name -> (times,).")  # fmt: skip
        return dict(zip(own, array, strict=True))
    given = by_spelling(measured, "measured", variable_name)
    known = (*own, *rates_of(own), *names_of_states(c), *c.outputs)
    if wrong := set(given) - set(known):
        raise ModelError(f"{c.name}: {unknown('name in measured', wrong, known)}")
    if not given:
        raise ModelError(f"{c.name}: nothing is measured. Known: {', '.join(known)}.")
    return {name: vector(values, f"measured {name!r}") for name, values in given.items()}


def _known_deviations(c: CompiledModel, names: tuple[str, ...], argument: Any) -> dict[str, float]:
    if argument is None:
        return {}
    given = by_spelling(argument, "deviations", variable_name) if isinstance(argument, Mapping) else None
    if given is not None and (wrong := set(given) - set(names)):
        raise ModelError(f"{c.name}: {unknown('name in deviations', wrong, names)}")
    known = given if given is not None else dict.fromkeys(names, argument)
    values = {name: number(value, f"deviation of {name!r}") for name, value in known.items()}
    for name, value in values.items():
        if not value > 0.0:
            raise ModelError(f"{c.name}: the standard deviation of {name!r} is {value:g}, but must be positive")
    return values


def predictions(
    c: CompiledModel, names: tuple[str, ...], solution: Solution, Z: Vector, columns: list[int]
) -> list[tuple[Vector, Vector]]:
    """Return values (nt,) and derivatives (nt, k) of measured quantities along a run.

    Parameters
    ----------
    Z
        (2 n, nt, k), derivatives of x, v of compiled functions.
    columns
        (k,) the argument of compiled functions that each unknown is, or -1.
    """
    n, every = c.n_coordinates, c.n
    own = c.coordinates[:n]
    places = {name: (solution.x, j, j) for j, name in enumerate(own)}
    places |= {name: (solution.v, j, every + j) for j, name in enumerate(rates_of(own))}
    rows = [(values, Z[every + n + j]) for j, values in enumerate(solution.states.values())]
    states = dict(zip(names_of_states(c), rows, strict=True))
    slopes = _output_slopes(solution, Z, columns) if set(names) & set(c.outputs) else Z
    made = []
    for name in names:
        if name in places:
            array, row, place = places[name]
            made.append((array[row], Z[place]))
        elif name in states:
            made.append(states[name])
        else:
            made.append((solution.outputs[name], slopes[c.outputs.index(name)]))
    return made


def _output_slopes(solution: Solution, Z: Vector, columns: list[int]) -> Vector:
    """Return derivatives (n_outputs, nt, k) of outputs along a run."""
    run = solution.trajectory
    if run is None:
        raise RuntimeError("a run of this process has its rows")
    made = np.zeros((len(run.model.outputs), *Z.shape[1:]))
    moved = [(j, column) for j, column in enumerate(columns) if column >= 0]
    for rows, prepared in run.modes:
        for k in range(*rows.indices(len(run.t))):
            at = OperatingPoint(run.model, prepared, float(run.t[k]), run.x[k], run.v[k], run.u[k])
            D = output_derivatives(at)
            made[:, k] = D[:, : len(Z)] @ Z[:, k]
            for j, column in moved:
                made[:, k, j] += D[:, column]
    return made
