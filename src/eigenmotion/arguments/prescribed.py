"""Inputs in constraints: signals with continuous velocities, which prescribe a motion."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from ..codegen.model import Table
from ..codegen.model.normalise import ModelError, number
from ..runtime import CompiledModel, Prepared
from .named_values import by_spelling, is_named, overlay, spelled
from .sampled import Controlled, Sampled
from .signals import Signal
from .tables import address_of, with_tables

_REMEDY = (
    "Give a signal with smooth rates: em.Signal(times, values, kind='cubic'), or an interpolant of SciPy, as "
    "em.Signal(make_interp_spline(times, values, k=5))."
)
_DERIVATIVES = ("value", "velocity", "acceleration", "third derivative")


def with_prescribed(c: CompiledModel, parameters: Any, inputs: Any, several: bool = False) -> tuple[Any, Any]:
    """Return parameters and inputs, where signals that prescribe motions have become tables among the parameters.

    Parameters
    ----------
    several
        Whether a list holds one signal for each member of an ensemble.

    Raises
    ------
    ModelError
        A signal jumps, or its rate does where a constraint takes in the acceleration; or it is a controller. Names the
        input, the time and the remedy.
    """
    if not c.prescribed or not is_named(inputs):
        return parameters, inputs
    given = {key: inputs[key] for key in inputs if spelled(key) in c.prescribed}
    if not given:
        return parameters, inputs
    rest = {key: value for key, value in inputs.items() if key not in given}
    motions = {name: _addresses(c, name, value, several) for name, value in by_spelling(given, "input").items()}
    return _with_motions(c, parameters, motions), rest


def _with_motions(c: CompiledModel, parameters: Any, motions: Mapping[str, Any]) -> Any:
    """Add motions to parameters, which are given by name or in order."""
    if parameters is None:
        return motions
    if is_named(parameters):
        return {**parameters, **motions}
    order = parameters.parameters if isinstance(parameters, Prepared) else parameters
    columns = np.moveaxis(np.asarray(with_tables(c, order), dtype=np.float64), -1, 0)
    if len(columns) != len(c.parameters):
        return overlay(parameters, c.parameters, c.parameter_defaults, "parameter")  # raises: wrong length
    return dict(zip(c.parameters, columns, strict=True)) | dict(motions)


def _addresses(c: CompiledModel, name: str, value: Any, several: bool) -> Any:
    """Return the address of the table of one signal, or an array of addresses for the members of an ensemble."""
    if several and isinstance(value, list | np.ndarray):
        return np.array([_address(c, name, one) for one in value])
    return _address(c, name, value)


def _address(c: CompiledModel, name: str, value: Any) -> float:
    what = f"input {name!r} of {c.name} prescribes a motion in a constraint"
    table = _table(value, name, what)
    jumps = [(order, at) for at, order in table.pieces.joins(0) if order < c.prescribed[name]]
    if jumps:
        order, at = min(jumps)
        raise ModelError(f"{what}, and its {_DERIVATIVES[order]} jumps at t = {at:g}, as no joint can. {_REMEDY}")
    return address_of(table)


def _table(value: Any, name: str, what: str) -> Table:
    if isinstance(value, Controlled | Sampled):
        raise ModelError(f"{what}, and a controller holds its values: such a motion jumps. Let it act through forces.")
    if isinstance(value, Signal):
        if value.kind == "hold":
            raise ModelError(f"{what}, and a signal of kind 'hold' jumps, as no joint can. {_REMEDY}")
        value = value.interpolant or (value.times, value.values)
    if isinstance(value, Table | tuple | list) or hasattr(value, "c"):  # interpolants of SciPy have coefficients
        return Table(value, name=name)
    if callable(value):
        raise ModelError(f"{what}, and this is a function. {_REMEDY}")
    at = number(value, f"{what}: a number or a signal is needed; what is given")
    return Table(((0.0, 1.0), (at, at)), outside="hold", name=name)


def check_covered(c: CompiledModel, inputs: Any, start: float, end: float) -> None:
    """Raise ModelError where the samples of a prescribed motion do not cover a span of time."""
    given = by_spelling(inputs, "input") if c.prescribed and is_named(inputs) else {}
    for name, signal in given.items():
        if name in c.prescribed and isinstance(signal, Signal):
            first, last = float(signal.times[0]), float(signal.times[-1])
            if min(start, end) < first or max(start, end) > last:
                raise ModelError(
                    f"{c.name}: input {name!r} is sampled on [{first:g}, {last:g}], which does not cover t_span "
                    f"({start:g}, {end:g})"
                )
