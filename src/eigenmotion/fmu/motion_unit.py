"""Units that move: forces and a start give the motion."""

from collections.abc import Iterator
from math import isfinite
from typing import TYPE_CHECKING, NamedTuple

from ..analysis.state.active_contacts import switches_of
from ..arguments.methods import FIXED, STEPPED, Method, method_of
from ..codegen.model import ModelError
from ..codegen.model.normalise import real
from .unit import Constant, Content, Variable

if TYPE_CHECKING:
    from ..system.system import System


class Stepping(NamedTuple):
    """How a unit steps; step 0: by the method's own control."""

    method: int
    rtol: float
    atol: float
    step: float


def stepping_of(method: str, rtol: float, atol: float, step: float | None) -> Stepping:
    """Return the checked options of a unit that moves.

    Raises
    ------
    ModelError
        There is no such method; a tolerance or a step is no number between 0 and 1, or the step is not wanted.
    """
    chosen: Method = method_of(method, STEPPED)
    return Stepping(chosen.number, _positive(rtol, "rtol"), _positive(atol, "atol"), _step(chosen, step))


def motion_unit(system: "System", stepping: Stepping) -> Content:
    """Return the content of a unit that steps and, where no mode has to be decided, flows."""
    return Content(
        headers=("em_flow.h", "em_unit.h"),
        variables=tuple(_variables(system)),
        constants=(Constant("double", "initial_velocities", tuple(map(repr, system.begin()[1].tolist()))),),
        options=f"{', '.join(map(repr, stepping))}, initial_velocities",
        rtol=repr(stepping.rtol),
        co_simulation_only=_why_no_flow(system),
    )


def _why_no_flow(system: "System") -> str:
    """Return what keeps a solver from integrating the states, or ""."""
    c = system.compiled
    if switched := switches_of(c):
        kind = "contact" if switched[0].is_contact else "friction"
        return f"the {kind} {c.events[switched[0].event]!r} has a mode, which only a run of the stepper decides"
    prepared = system.prepare_both(None, None)[0]
    if any(isfinite(c.smooth_interval(0.0, direction, prepared)[0]) for direction in (1.0, -1.0)):
        return "the model changes at certain times, at which only a run of the stepper stops"
    return ""


def _positive(value: float, name: str) -> float:
    number = real(value, name)
    if not 0 < number < 1:
        raise ModelError(f"{name} is {number}, but must be above 0 and less than 1")
    return number


def _step(method: Method, step: float | None) -> float:
    if (step is not None) != (method.name in FIXED):
        raise ModelError(
            f"step= is for methods of fixed step ({', '.join(FIXED)}), which need it; method is {method.name}"
        )
    return 0.0 if step is None else _positive(step, "step")


def _variables(system: "System") -> Iterator[Variable]:
    """Yield all variables in the order of em_unit.h."""
    parameters, n, inputs = len(system.parameters), system.compiled.n, len(system.inputs)
    for k, (name, value) in enumerate(system.parameters.items()):
        yield Variable(k, name, "parameter", "fixed", "exact", repr(value), "parameter")
    yield from _states(system, parameters)
    first = parameters + 2 * n
    for k, (name, value) in enumerate(system.inputs.items(), first):
        yield Variable(k, name, "input", "continuous", "", repr(value), "input")
    first += inputs
    for k, name in enumerate(system.outputs, first):
        yield Variable(k, name, "output", "continuous", "calculated", None, "output of the model")
    first += len(system.outputs)
    rates = (*(f"der(der({name}))" for name in system.coordinates), *(f"der({name})" for name in system.states))
    for k, name in enumerate(rates):
        text = "acceleration" if k < len(system.coordinates) else "rate of a state"
        yield Variable(first + k, name, "local", "continuous", "calculated", None, text, parameters + n + k)
    for k, name in enumerate(system.compiled.events, first + n):
        text = f"event indicator of {name}"
        yield Variable(k, f"indicator({name})", "local", "continuous", "calculated", None, text, indicates=True)


def _states(system: "System", first: int) -> Iterator[Variable]:
    """Yield x, v: both may jump where an event acts."""
    n, jumps = system.compiled.n, system.compiled.acts or system.compiled.m > 0 or bool(system.compiled.rotations)
    x, v = (values.tolist() for values in system.begin())
    places = (*system.coordinates, *(f"integral({name})" for name in system.states))
    rates = (*(f"der({name})" for name in system.coordinates), *system.states)
    texts = (("coordinate", "rate of a coordinate"), ("integral of a state", "first-order state"))
    for order, (names, starts) in enumerate(((places, x), (rates, v))):
        for k, (name, start) in enumerate(zip(names, starts, strict=True)):
            text = texts[k >= len(system.coordinates)][order]
            of = first + k if order else None
            yield Variable(
                first + order * n + k, name, "output", "continuous", "exact", repr(start), text, of, reinit=jumps
            )
