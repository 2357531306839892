"""Task of a run, and checks of its options."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..codegen.model.normalise import ModelError, number, real, shown
from ..runtime import CompiledModel, Prepared
from ..runtime.plain import MOST_STEPS
from .named_values import Vector, overlay, unknown, vector
from .signals import Inputs

DEFAULT_ATOL = 1e-9
DEPENDENT = {"auto": 2, "refuse": 0, "least_norm": 1}  # em_dependent
SHARED_FROM_START = DEPENDENT["auto"]


class OptionError(ModelError, TypeError):
    """An unknown option of `simulate`: a TypeError as Python's own, and a ValueError as all our argument errors."""


def is_system(argument: object) -> bool:
    """Return whether an object is a `System`."""
    return isinstance(getattr(argument, "compiled", None), CompiledModel)


def no_system(call: str, argument: object, more: str = "") -> OptionError:
    """Return the error of a call without a System; `more` are the other arguments of the call."""
    return OptionError(
        f"{call}: system is {shown(argument)}, not a System. Compile the model, or the file that defines it, "
        f"first: {call}(em.build(model){more})"
    )


TO_DERIVE = 2
"""Value of Task.dense: keep the dense output for sensitivities, which need no steps shortened for its accuracy."""


class Task(NamedTuple):
    """One run.

    y : (n_state,), published meaning, at t_start
    atol : (n,), of x_k [u_k] and of its velocity [u_k / s]
    t_eval : (k,) in the direction of time, or None: a row for every accepted step
    dense : 1 to keep the dense output for states between rows; TO_DERIVE to keep it for sensitivities
    first_step : [s]; 0: estimated
    stabilise : whether accepted states are projected onto the constraints and eigenfactors are restored
    least_norm : the treatment of dependent constraint rows, a value of DEPENDENT
    """

    model: CompiledModel
    prepared: Prepared
    inputs: Inputs
    t_start: float
    t_end: float
    y: Vector
    rtol: float
    atol: Vector
    t_eval: Vector | None
    dense: int
    first_step: float
    max_step: float
    max_steps: int
    stabilise: bool
    least_norm: int


SCIPY_OPTIONS = {
    "args": "parameters={...}, by name",
    "events": "Model(events={...}): they belong to the mechanism, and are compiled",
    "fun": "nothing: the system has its right-hand side",
    "jac": "nothing: implicit methods have their Jacobian",
    "y0": "x0 and v0, by name or as arrays",
}
"""Options of `solve_ivp` -> the corresponding argument here."""


def choice(argument: object, known: Mapping[str, Any], what: str) -> Any:
    """Return the value of a keyword option, in upper or lower case; the keys of `known` are in lower case.

    Raises
    ------
    ModelError
        The word is unknown; lists the known ones.
    """
    if type(argument) is str and argument in known:
        return known[argument]
    if not isinstance(argument, str):
        raise ModelError(f"{what} is {shown(argument)}, not one of the words {', '.join(known)}")
    if argument.lower() not in known:
        raise ModelError(unknown(what, [argument], list(known)))
    return known[argument.lower()]


def least_norm_of(dependent_constraints: str) -> int:
    """Return the treatment of dependent constraint rows, em_dependent of em_run.h: e.g. multipliers of least norm."""
    chosen: int = choice(dependent_constraints, DEPENDENT, "dependent_constraints")
    return chosen


def span(t_span: tuple[float, float]) -> tuple[float, float]:
    """Return the start and end of a time span, two finite numbers [s]."""
    try:
        start, end = t_span
    except (TypeError, ValueError) as error:
        raise ModelError(f"t_span is {shown(t_span)}, not a pair of numbers (start, end)") from error
    return number(start, "the start of t_span"), number(end, "the end of t_span")


def rows_at(t_eval: ArrayLike | None, start: float, end: float) -> Vector | None:
    """Return t_eval (k,), strictly sorted in the direction of time and inside the span."""
    if t_eval is None:
        return None
    times = vector(t_eval, "t_eval")
    if times.ndim != 1:
        raise ModelError(f"t_eval has shape {times.shape}, but must be one-dimensional")
    inside = (times >= min(start, end)) & (times <= max(start, end))
    if not inside.all():
        if not np.isfinite(times).all():
            raise ModelError("t_eval holds a number that is not finite")
        raise ModelError(f"t_eval: {times[~inside][0]:.9g} is outside t_span ({start:g}, {end:g})")
    before, after = (times[1:], times[:-1]) if end < start else (times[:-1], times[1:])
    if not (before < after).all():
        way = "decrease" if end < start else "increase"
        raise ModelError(f"t_eval must {way} strictly, as t_span runs from {start:g} to {end:g}")
    return times


def tolerances(
    model: CompiledModel, rtol: float, atol: float | Mapping[Any, float] | ArrayLike
) -> tuple[float, Vector]:
    """Return rtol and atol (n,); coordinates missing from a mapping get 1e-9."""
    absolute = _absolute(model, atol)
    relative = real(rtol, "rtol")
    if not (0 <= relative < 1):
        raise ModelError(f"rtol is {relative}, but must be at least 0 and less than 1")
    least = min(absolute.tolist())
    if least < 0:
        name = model.coordinates[int(absolute.argmin())]
        raise ModelError(f"atol of {name!r} is {least}, but must not be negative")
    if relative == least == 0:
        name = model.coordinates[int(absolute.argmin())]
        raise ModelError(f"rtol and the atol of {name!r} are both 0: no step can be that accurate")
    return relative, absolute


def _absolute(model: CompiledModel, atol: float | Mapping[Any, float] | ArrayLike) -> Vector:
    if isinstance(atol, Mapping | list | tuple) or getattr(atol, "ndim", 0) != 0:
        return overlay(atol, model.coordinates, np.full(model.n, DEFAULT_ATOL), "coordinate of atol")
    absolute = np.empty(model.n)
    absolute.fill(number(atol, "atol"))
    return absolute


def step_limits(first_step: float | None, max_step: float, max_steps: int, length: float) -> tuple[float, float, int]:
    """Return first_step (0: estimated), max_step and max_steps."""
    first = 0.0 if first_step is None else real(first_step, "first_step")
    if first_step is not None and not (0 < first <= length):
        raise ModelError(f"first_step is {first}, but must be above 0 and at most the length of t_span, {length:g}")
    longest = real(max_step, "max_step")
    if not longest > 0:
        raise ModelError(f"max_step is {longest}, but must be above 0")
    most = real(max_steps, "max_steps")
    if not (1 <= most <= MOST_STEPS and most.is_integer()):
        raise ModelError(f"max_steps is {shown(max_steps)}, but must be a whole number from 1 to {MOST_STEPS:.0e}")
    return first, longest, int(most)
