"""How a motion changes with parameters, inputs and its start."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..arguments.names import Vector, by_spelling, rate_name, spelled, unknown
from ..arguments.options import OptionError, Task
from ..codegen.model.normalise import ModelError, shown
from ..results.solution import Solution
from ..runtime import CompiledModel, EvaluationError
from ..runtime.variations import quasi_partials, tangent, vary
from .methods import Method
from .path import Path, path_of

if TYPE_CHECKING:
    from ..system.system import System

_LOOSEST = 1e-6
"""Relative tolerance of sensitivities where that of the run is larger."""


class Sensitivity(NamedTuple):
    """How a run changes with one number p.

    dx, dv : (n, k), d x / d p and d xdot / d p at its rows, at fixed time: of rows at an event that acts, those of the
        motion before it and of the motion after it; at a terminal event, of the motion up to there
    dt_events : for each event of the model (e,), d t_events / d p; None where it has none. With it, dx + v dt is how
        the place of an event changes
    """

    dx: Vector
    dv: Vector
    dt_events: list[Vector] | None


class Directions(NamedTuple):
    """What a motion is differentiated by, in the order of `names`.

    S : (2 n, columns), of x and v at the start; P : (n_arguments - 2 n, columns), of inputs, parameters, time
    sizes : (columns,) how large they are themselves, 1 where they are 0
    """

    names: tuple[str, ...]
    S: Vector
    P: Vector
    sizes: Vector


def directions(system: "System", asked: Sequence[Any], task: Task, method: Method, v0: Any) -> Directions:
    """Read what a run is to be differentiated by: parameters ("K1"), constant inputs, initial x ("theta") and v.

    Initial rates are "theta'", or quasi-velocities by their names.

    Raises
    ------
    ModelError
        A name that is none of these; a sampled input; an implicit method; a controller.
    """
    c = system.compiled
    _check_smooth(task, c)
    if isinstance(asked, str) or not isinstance(asked, Sequence):
        raise OptionError(f"sensitivities is {shown(asked)}: give a list of names")
    if method.implicit:
        raise OptionError("sensitivities come by explicit steps, of which stiff scenes take too many: "
                          f"method={method.name!r} gives none; use a method that is not implicit")  # fmt: skip
    rates = tuple(f"{name}'" for name in c.coordinates)
    known = (*c.coordinates, *rates, *c.quasi_velocities, *c.inputs, *c.parameters)
    names = tuple(dict.fromkeys(_name(one) for one in asked))
    if wrong := set(names) - set(known):
        raise ModelError(unknown("name in sensitivities", wrong, known))
    S, P = np.zeros((2 * c.n, len(names))), np.zeros((c.n_arguments - 2 * c.n, len(names)))
    for column, name in enumerate(names):
        if name in c.coordinates + rates:
            S[(c.coordinates + rates).index(name), column] = 1.0
        elif name in c.inputs + c.parameters:
            P[(c.inputs + c.parameters).index(name), column] = 1.0
            _check_constant(task, c, name)
    _quasi(system, task, v0, names, S, P)
    v = c.velocity_rows(np.array([task.t_start]), task.y[None, :], task.prepared)[0]
    z = np.concatenate([task.y[: c.n], v, np.ones(len(c.quasi_velocities)), task.inputs.at(task.t_start),
                        task.prepared.parameters])  # fmt: skip
    sizes = np.abs(z[[known.index(name) for name in names]])
    return Directions(names, S, P, np.where(sizes > 0.0, sizes, 1.0))


def _name(key: object) -> str:
    return f"{rate_name(key)}'" if rate_name(key) != spelled(key) else spelled(key)


def _check_smooth(task: Task, c: CompiledModel) -> None:
    """Refuse what changes the motion by more than its forces and events: its derivatives would be left out."""
    if task.inputs.sampled:
        raise ModelError(f"{c.name}: sensitivities do not go through a controller (Sampled): differentiate the closed "
                         "loop by a run with its control law in the model's forces")  # fmt: skip


def _check_constant(task: Task, c: CompiledModel, name: str) -> None:
    if name in c.inputs and not isinstance(task.inputs.signals[c.inputs.index(name)], int | float):
        raise ModelError(f"sensitivities: input {name!r} is sampled; only inputs that are constant can be named")


def _quasi(system: "System", task: Task, v0: Any, names: tuple[str, ...], S: Vector, P: Vector) -> None:
    """Where the start is given in quasi-velocities y = P v, these stay: P dv = dy - (dP v)."""
    c = system.compiled
    quasi = [name for name in names if name in c.quasi_velocities]
    given = set(by_spelling(v0, "v0", rate_name)) if isinstance(v0, Mapping) else set()
    from_quasi = bool(given & set(c.quasi_velocities)) or (v0 is None and c.initial_y is not None)
    if quasi and not from_quasi:
        raise ModelError(f"sensitivities: the run does not start from quasi-velocities, as {quasi[0]!r} is; name rates")
    if isinstance(v0, Mapping) and (c.initial_y is not None) != from_quasi and len(given) < c.n:
        raise ModelError("sensitivities: the start mixes rates and quasi-velocities; give all of one kind in v0")
    if not from_quasi:
        return
    x, v = task.y[: c.n], c.velocity_rows(np.array([task.t_start]), task.y[None, :], task.prepared)[0]
    D = quasi_partials(c, task.t_start, x, v, task.prepared)
    moved = D[:, : c.n] @ S[: c.n] + D[:, 2 * c.n :] @ P
    for column, name in enumerate(names):
        if name in quasi:
            moved[c.quasi_velocities.index(name), column] -= 1.0
    free = [column for column, name in enumerate(names) if not name.endswith("'")]
    S[c.n :, free] = -np.linalg.solve(D[:, c.n : 2 * c.n], moved[:, free])


def sensitivity(task: Task, solution: Solution, asked: Directions) -> dict[str, Sensitivity]:
    """Return name -> derivatives of all rows of a run.

    Raises
    ------
    ModelError
        A force jumps where no event of the model says so, or events act whose times have no derivative: two at
        once, or one that only touches zero.
    """
    n, path = task.model.n, path_of(task, solution)
    found, shifts, fault = _varied(task, asked, path)
    if fault is not None and solution.success:  # else the run has ended for a reason of its own, and says it
        remedy = ("give the model an event whose expression passes through zero where the force jumps, or make it "
                  "smooth" if "jumps" in str(fault) else "end the run before")  # fmt: skip
        raise ModelError(f"{fault}. Sensitivities end there: {remedy}")
    rows = found[path.of_rows]
    times = [[shifts[marks, column] for marks in path.of_events] for column in range(len(asked.names))]
    return {
        name: Sensitivity(rows[:, :n, k].T, rows[:, n:, k].T, times[k] if task.model.events else None)
        for k, name in enumerate(asked.names)
    }


def _varied(task: Task, asked: Directions, path: Path) -> tuple[Vector, Vector, EvaluationError | None]:
    """Return directions (k, 2 n, columns) at all nodes, changes (marks, columns) of event times, and why they end.

    They are NaN from there on.
    """
    c, n, columns = task.model, task.model.n, len(asked.names)
    prepared, t, z = path.prepared, path.t, path.z
    nothing = np.full((len(t), 2 * n, columns), np.nan), np.full((len(path.mark_row), columns), np.nan)
    try:
        S = tangent(c, t[0], z[0, :n], z[0, n:], prepared, task.least_norm, asked.S, asked.P)
    except EvaluationError as error:
        return *nothing, error
    rtol = min(max(task.rtol, 1e-14), _LOOSEST)
    found, shifts, fault, _, _ = vary(
        c, prepared, task.inputs.compiled, t, z, path.mark_row, path.mark_event, S, asked.P, asked.sizes, rtol,
        task.atol, task.max_steps, task.stabilise, task.least_norm,
    )  # fmt: skip
    return found, shifts, fault
