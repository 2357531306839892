"""Units of inverse dynamics: a motion gives the forces of actuators."""

from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ..analysis.inverse.actuators import actuators_of
from ..analysis.state.active_contacts import switches_of
from ..analysis.state.tangent_space import null_space
from ..arguments.named_values import spelled, unknown
from ..codegen.model import ModelError
from ..runtime import Actuators, CompiledModel
from .unit import Constant, Content, Variable

if TYPE_CHECKING:
    from ..system.system import System


def inverse_unit(system: "System", actuators: Any, motion: Any) -> Content:
    """Return the content of a unit with the forces of these actuators, of the motion of these coordinates.

    Parameters
    ----------
    actuators
        Names of coordinates and inputs, or a mapping name -> weight of the squared force.
    motion
        Names of coordinates whose motion is given: as many as there are degrees of freedom, or all. None: all, or with
        constraints those of the actuators.

    Raises
    ------
    ModelError
        Actuators or coordinates are unknown, too few or too many; or the model has contacts, or
        nonholonomic constraints whose positions would have to be integrated.
    """
    c = system.compiled
    if not c.inverts:
        raise ModelError(f"{c.name} was written by hand and has no inverse dynamics")
    if contacts := [one for one in switches_of(c) if one.is_contact]:
        raise ModelError(
            f"{c.name}: a unit of inverse dynamics has no contacts, and {c.events[contacts[0].event]!r} is one. "
            "System.inverse_dynamics decides them."
        )
    of = actuators_of(c, actuators)
    given = _given(c, of, motion)
    _check_freedoms(system, of, given)
    return Content(
        headers=("em_branch.h", "em_no_flow.h", "em_inverse_unit.h"),
        variables=tuple(_variables(system, of, given)),
        constants=tuple(_constants(system, of, given)),
        options=f"{{{len(of.names)}, on_coordinates, by_inputs, {'weights' if of.weights else 'NULL'}}}, is_given, "
        "initial_velocities",
        rtol=None,
        co_simulation_only="inverse dynamics integrates nothing, and has no states",
    )


def _given(c: CompiledModel, of: Actuators, motion: Any) -> tuple[str, ...]:
    """Return the names of the coordinates whose motion is given."""
    own = c.coordinates[: c.n_coordinates]
    constrained = _constraints(c) > 0
    if motion is None and constrained and not set(of.names) <= set(own):
        raise ModelError(
            f"{c.name}: which coordinates move as prescribed? Actuators are inputs, too: give motion=, the names of as "
            "many coordinates as there are degrees of freedom, on the command line --path."
        )
    if motion is None:
        return of.names if constrained else own
    names = (motion,) if isinstance(motion, str) or not isinstance(motion, Iterable) else tuple(motion)
    named = tuple(map(spelled, names))
    if wrong := set(named) - set(own):
        raise ModelError(f"{c.name}: {unknown('coordinate of the motion', wrong, own)}")
    return named


def _constraints(c: CompiledModel) -> int:
    """Return the number of rows that hold in every mode."""
    return c.m - sum(2 if one.shift >= 0 else 1 for one in switches_of(c))


def _check_freedoms(system: "System", of: Actuators, given: tuple[str, ...]) -> None:
    """Raise ModelError unless the coordinates determine the motion, and there are actuators for it."""
    c, n = system.compiled, system.compiled.n_coordinates
    x, prepared = system.begin()[0], system.prepare_both(None, None)[0]
    A = c.pfaffian(0.0, x, prepared)[0][:, :n]
    unit = 1.0 / np.sqrt(np.diag(c.factored_matrix(0.0, x, prepared))[:n])
    others = [k for k in range(n) if c.coordinates[k] not in given]
    freedoms = len(null_space(A, unit)[0])
    has = f"{c.name} has {freedoms} degree{'s' * (freedoms != 1)} of freedom"
    if len(of.names) < freedoms:
        count = len(of.names)
        raise ModelError(
            f"{has}, and {count} actuator{'s' * (count > 1)} ({', '.join(of.names)}): most motions lack a force. Give "
            "as many actuators."
        )
    if not others:
        return
    if _constraints(c) > c.h:
        raise ModelError(
            f"{c.name} has nonholonomic constraints, through which positions do not follow from others: the motion of "
            f"all coordinates is given, motion={list(c.coordinates[:n])}"
        )
    if len(given) != freedoms:
        raise ModelError(
            f"{has}, and the motion of {len(given)} coordinates is given ({', '.join(given)}). Give that of "
            f"{freedoms}, or of all."
        )
    if loose := null_space(A[:, others], unit[others])[0]:
        raise ModelError(
            f"{c.name}: at the start, {' and '.join(given)} do not determine {c.coordinates[others[loose[0]]]}. Choose "
            "other coordinates, or a start that is no dead centre."
        )


def _variables(system: "System", of: Actuators, given: tuple[str, ...]) -> Iterator[Variable]:
    """Yield all variables, with the references of em_inverse_unit.h."""
    c, first = system.compiled, len(system.parameters)
    x, v = (values.tolist() for values in system.begin())
    for k, (name, value) in enumerate(system.parameters.items()):
        yield Variable(k, name, "parameter", "fixed", "exact", repr(value))
    for order, name, starts in ((0, "{}", x), (1, "der({})", v), (2, "der(der({}))", [0.0] * c.n)):
        for k, coordinate in enumerate(c.coordinates[: c.n_coordinates]):
            reference, spelling, start = first + order * c.n + k, name.format(coordinate), repr(starts[k])
            if coordinate in given:
                yield Variable(reference, spelling, "input", "continuous", "", start)
            elif order == 0:
                yield Variable(reference, spelling, "output", "continuous", "approx", start)
            else:
                yield Variable(reference, spelling, "output", "continuous", "calculated", None)
    for k in range(c.n_coordinates, c.n):
        yield Variable(first + c.n + k, c.coordinates[k], "input", "continuous", "", repr(v[k]))
    first += 3 * c.n
    for k, (name, value) in enumerate(system.inputs.items()):
        if name not in of.names:
            yield Variable(first + k, name, "input", "continuous", "", repr(value))
    first += c.n_inputs
    forces = (name if name in c.inputs else f"force({name})" for name in of.names)
    for k, name in enumerate((*forces, *system.outputs)):
        yield Variable(first + k, name, "output", "continuous", "calculated", None)


def _constants(system: "System", of: Actuators, given: tuple[str, ...]) -> Iterator[Constant]:
    c = system.compiled
    coordinates: Mapping[str, int] = {name: k for k, name in enumerate(c.coordinates[: c.n_coordinates])}
    inputs: Mapping[str, int] = {name: k for k, name in enumerate(c.inputs)}
    yield Constant("int", "is_given", tuple(str(int(name in given)) for name in c.coordinates))
    yield Constant("int", "on_coordinates", tuple(str(coordinates.get(name, -1)) for name in of.names))
    yield Constant("int", "by_inputs", tuple(str(inputs.get(name, -1)) for name in of.names))
    if of.weights:
        yield Constant("double", "weights", tuple(map(repr, of.weights)))
    yield Constant("double", "initial_velocities", tuple(map(repr, system.begin()[1].tolist())))
