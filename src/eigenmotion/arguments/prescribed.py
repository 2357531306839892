"""Inputs in constraints: signals with continuous velocities, which prescribe a motion."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from ..codegen.model import Table
from ..codegen.model.normalise import ModelError, number
from ..runtime import CompiledModel, Prepared
from ..runtime.tables import is_table_address
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
        A signal jumps, or its rate does where a constraint takes in the acceleration; or it is a controller; or it is
        given among the parameters. Names the input, the time and the remedy.
    """
    if not c.prescribed:
        return parameters, inputs
    _check_places(c, parameters, inputs)
    given = {key: inputs[key] for key in inputs if spelled(key) in c.prescribed} if is_named(inputs) else {}
    if not given:
        return parameters, inputs
    rest = {key: value for key, value in inputs.items() if key not in given}
    motions = {name: _addresses(c, name, value, several) for name, value in by_spelling(given, "input").items()}
    return _with_motions(c, parameters, motions), rest


def _check_places(c: CompiledModel, parameters: Any, inputs: Any) -> None:
    """Raise ModelError if a prescribed motion is given among the parameters, or to a controller of several inputs."""
    for key in parameters if is_named(parameters) else ():
        if spelled(key) in c.prescribed and not _is_handle(parameters[key]):
            name = spelled(key)
            raise ModelError(f"{c.name}: {name!r} is an input, not a parameter: give it as inputs={{{name!r}: ...}}")
    for key in inputs if is_named(inputs) else ():
        held = [spelled(one) for one in key if spelled(one) in c.prescribed] if isinstance(key, tuple) else []
        if held:
            raise _held(_what(c, held[0]))


def _is_handle(value: Any) -> bool:
    """Whether this is what the parameter of a table is in a `Solution` or in `System.parameters`: 0 or an address."""
    return isinstance(value, np.ndarray) or (isinstance(value, float) and (value == 0.0 or is_table_address(value)))


def _with_motions(c: CompiledModel, parameters: Any, motions: Mapping[str, Any]) -> Any:
    """Add motions to parameters, which are given by name or in order."""
    if parameters is None:
        return motions
    if is_named(parameters):
        return by_spelling(parameters, "parameter") | dict(motions)
    if isinstance(parameters, Prepared):
        if parameters.model is not c:
            raise ModelError(f"parameters were prepared for {parameters.model.name}, another compiled model")
        parameters = parameters.parameters
    columns = np.moveaxis(np.asarray(with_tables(c, parameters), dtype=np.float64), -1, 0)
    if len(columns) != len(c.parameters):
        return overlay(parameters, c.parameters, c.parameter_defaults, "parameter")  # raises: wrong length
    return dict(zip(c.parameters, columns, strict=True)) | dict(motions)


def _addresses(c: CompiledModel, name: str, value: Any, several: bool) -> Any:
    """Return the address of the table of one signal, or an array of addresses for the members of an ensemble."""
    if several and isinstance(value, list | np.ndarray):
        return np.array([address_of(motion(c, name, one)) for one in value])
    return address_of(motion(c, name, value))


def motion(c: CompiledModel, name: str, value: Any) -> Table:
    """Return what prescribes a motion as a table of the time.

    Raises
    ------
    ModelError
        As `with_prescribed`.
    """
    what = _what(c, name)
    table = _table(value, what)
    if table.arguments != 1:
        raise ModelError(f"{what}: it is a function of the time, and is given one of two arguments")
    jumps = [(order, at) for at, order in table.pieces.joins(0) if order < c.prescribed[name]]
    if jumps:
        order, at = min(jumps)
        raise ModelError(f"{what}, and its {_DERIVATIVES[order]} jumps at t = {at:g}, as no joint can. {_REMEDY}")
    return table


def _what(c: CompiledModel, name: str) -> str:
    return f"input {name!r} of {c.name} prescribes a motion in a constraint"


def _held(what: str) -> ModelError:
    return ModelError(f"{what}, and a controller holds its values: such a motion jumps. Let it act through forces.")


def _table(value: Any, what: str) -> Table:
    if isinstance(value, Controlled | Sampled):
        raise _held(what)
    if isinstance(value, Signal) and value.kind == "hold":
        raise ModelError(f"{what}, and a signal of kind 'hold' jumps, as no joint can. {_REMEDY}")
    if isinstance(value, Table | Signal):
        return value if isinstance(value, Table) else value.table
    if isinstance(value, tuple | list) or hasattr(value, "c") or hasattr(value, "tck"):  # interpolants of SciPy
        try:
            return Table(value, name="signal")
        except ModelError as error:
            raise ModelError(f"{what}: {error}") from error
    if callable(value):
        raise ModelError(f"{what}, and this is a function. {_REMEDY}")
    at = number(value, f"{what}: a number or a signal is needed; what is given")
    return Table(((0.0, 1.0), (at, at)), outside="hold")


def covering(c: CompiledModel, inputs: Any, start: float, end: float, several: bool = False) -> Any:
    """Return inputs with prescribed motions as tables, all of which cover a span of time.

    A list of `several`, one for each member of an ensemble, is returned as it is: a member not covered fails alone.

    Raises
    ------
    ModelError
        As `with_prescribed`, or a table that refuses what is outside of its range does not cover the span.
    """
    if not c.prescribed or not is_named(inputs):
        return inputs
    made = {key: inputs[key] for key in inputs}
    for key, value in made.items():
        name = spelled(key)
        if name in c.prescribed and not (several and isinstance(value, list | np.ndarray)):
            made[key] = motion(c, name, value)
            _check_covered(c, name, made[key], start, end)
    return made


def _check_covered(c: CompiledModel, name: str, table: Table, start: float, end: float) -> None:
    knots = table.pieces.axes[0].knots
    if table.pieces.outside == "refuse" and (min(start, end) < knots[0] or max(start, end) > knots[-1]):
        raise ModelError(
            f"{c.name}: input {name!r} is sampled on [{knots[0]:g}, {knots[-1]:g}], which does not cover t_span "
            f"({start:g}, {end:g})"
        )
