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

if TYPE_CHECKING:
    from ..system.system import System

_LOOSEST = 1e-6
"""Relative tolerance of sensitivities where that of the run is larger."""


class Sensitivity(NamedTuple):
    """d x / d p and d xdot / d p at the rows of a run, each (n, k), at fixed time."""

    dx: Vector
    dv: Vector


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
        A name that is none of these; a sampled input; an implicit method; events that act; a controller.
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
    """Refuse what changes the motion by more than its forces: the derivatives of these would be left out."""
    if c.acts:
        acting = ", ".join(repr(name) for name, acts in zip(c.events, c.acting, strict=True) if acts)
        raise ModelError(f"{c.name}: sensitivities do not go through events that change the state ({acting})")
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
        A force jumps where no event of the model says so: what depends on when it does is not known.
    """
    n = task.model.n
    t, z, at = _rows(task, solution)
    found, fault = _varied(task, asked, t, z, at)
    if fault is not None and solution.success:  # else the run has ended for a reason of its own, and says it
        remedy = ("give the model an event whose expression passes through zero where the force jumps, or make it "
                  "smooth" if "jumps" in str(fault) else "end the run before")  # fmt: skip
        raise ModelError(f"{fault}. Sensitivities end there: {remedy}")
    rows = found[_of_solution(t, solution.t)]
    return {name: Sensitivity(rows[:, :n, column].T, rows[:, n:, column].T) for column, name in enumerate(asked.names)}


def _varied(task: Task, asked: Directions, t: Vector, z: Vector, at: Vector) -> tuple[Vector, EvaluationError | None]:
    """Return directions (k, 2 n, columns) at all rows, NaN from where they end, and why they do."""
    c, n = task.model, task.model.n
    try:
        S = tangent(c, t[0], z[0, :n], z[0, n:], task.prepared, task.least_norm, asked.S, asked.P)
    except EvaluationError as error:
        return np.full((len(t), 2 * n, len(asked.names)), np.nan), error
    if len(t) == 1:
        return S[None], None
    rtol = min(max(task.rtol, 1e-14), _LOOSEST)
    found, fault, _, _ = vary(c, task.prepared, task.inputs.compiled, t, z, at, S, asked.P, asked.sizes, rtol,
                              task.atol, task.max_steps, task.stabilise, task.least_norm)  # fmt: skip
    return found, fault


def _rows(task: Task, solution: Solution) -> tuple[Vector, Vector, Vector]:
    """Return times, states (k, 2 n) and events (-1: none) of the start, the rows and what happened between them."""
    c, n = task.model, task.model.n
    times, rows, events = (
        [np.array([task.t_start]), solution.t],
        [task.y[None], solution.y.T],
        [[-1], [-1] * len(solution.t)],
    )
    for event, (when, state) in enumerate(zip(solution.t_events or (), solution.y_events or (), strict=True)):
        times.append(np.asarray(when))
        rows.append(np.asarray(state).reshape(-1, c.n_state))
        events.append([event] * len(when))
    t, y, at = np.concatenate(times), np.concatenate(rows), np.concatenate(events).astype(int)
    order = np.lexsort((-at, t if task.t_end >= task.t_start else -t))
    keep = np.concatenate([[True], np.diff(t[order]) != 0.0])
    t, y, at = t[order][keep], y[order][keep], at[order][keep]
    v = c.velocity_rows(t, np.ascontiguousarray(y), task.prepared)
    return t, np.ascontiguousarray(np.hstack([y[:, :n], v])), at


def _of_solution(t: Vector, wanted: Vector) -> Vector:
    place = {time: k for k, time in enumerate(t.tolist())}
    return np.array([place[time] for time in wanted.tolist()], dtype=int)
