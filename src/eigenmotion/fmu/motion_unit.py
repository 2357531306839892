"""Units that move: forces and a start give the motion."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

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
    """Return the content of a unit that steps."""
    return Content(
        headers=("em_unit.h",),
        variables=tuple(_variables(system)),
        constants=(Constant("double", "initial_velocities", tuple(map(repr, system.begin()[1].tolist()))),),
        options=f"{', '.join(map(repr, stepping))}, initial_velocities",
        rtol=repr(stepping.rtol),
    )


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
    x, v = (values.tolist() for values in system.begin())
    places = (*system.coordinates, *(f"integral({name})" for name in system.states))
    rates = (*(f"der({name})" for name in system.coordinates), *system.states)
    rows = [
        *((name, "parameter", "fixed", "exact", repr(value)) for name, value in system.parameters.items()),
        *((name, "output", "continuous", "exact", repr(value)) for name, value in zip(places, x, strict=True)),
        *((name, "output", "continuous", "exact", repr(value)) for name, value in zip(rates, v, strict=True)),
        *((name, "input", "continuous", "", repr(value)) for name, value in system.inputs.items()),
        *((name, "output", "continuous", "calculated", None) for name in system.outputs),
    ]
    for reference, row in enumerate(rows):
        yield Variable(reference, *row)
