"""How a motion changes with parameters, inputs and its start."""

from typing import NamedTuple

import numpy as np

from ..arguments.differentiated import Differentiated, names_of, rates_of
from ..arguments.names import Vector
from ..arguments.options import OptionError, Task
from ..codegen.model.normalise import ModelError
from ..results.sensitivity import Sensitivity
from ..results.solution import Solution
from ..runtime import EvaluationError
from ..runtime.variations import quasi_partials, tangent, vary
from .methods import Method
from .path import Path, path_of

_LOOSEST = 1e-6
"""Relative tolerance of sensitivities where that of the run is larger."""


class Directions(NamedTuple):
    """What a motion is differentiated by, in the order of `names`.

    S : (2 n, columns), of x and v at the start; P : (n_arguments - 2 n, columns), of inputs, parameters, time
    sizes : (columns,) how large they are themselves, 1 where they are 0
    """

    names: tuple[str, ...]
    S: Vector
    P: Vector
    sizes: Vector


def check_method(method: Method) -> None:
    """Refuse methods whose rows are not the motion's to the last digit.

    Raises
    ------
    ModelError
        A method that is not compiled.
    """
    if method.number is None:
        raise OptionError(f"sensitivities are of compiled methods, which {method.name!r} is not; for stiff scenes take "
                          "'radau5' or 'radau9'")  # fmt: skip


def directions(asked: Differentiated, task: Task) -> Directions:
    """Return the directions in which a run begins.

    Raises
    ------
    ModelError
        A sampled input is named, or a controller is asked on the way.
    """
    c, names = task.model, asked.names
    if task.inputs.sampled:
        raise ModelError(f"{c.name}: sensitivities do not go through a controller (Sampled): differentiate the closed "
                         "loop by a run with its control law in the model's forces")  # fmt: skip
    S, P = np.zeros((2 * c.n, len(names))), np.zeros((c.n_arguments - 2 * c.n, len(names)))
    state, given = (*c.coordinates, *rates_of(c)), (*c.inputs, *c.parameters)
    for column, name in enumerate(names):
        if name in state:
            S[state.index(name), column] = 1.0
        elif name in given:
            P[given.index(name), column] = 1.0
            _check_constant(task, name)
    if asked.from_quasi:
        _quasi(task, names, S, P)
    v = c.velocity_rows(np.array([task.t_start]), task.y[None, :], task.prepared)[0]
    z = np.concatenate([task.y[: c.n], v, np.ones(len(c.quasi_velocities)), task.inputs.at(task.t_start),
                        task.prepared.parameters])  # fmt: skip
    sizes = np.abs(z[[names_of(c).index(name) for name in names]])
    return Directions(names, S, P, np.where(sizes > 0.0, sizes, 1.0))


def _check_constant(task: Task, name: str) -> None:
    c = task.model
    if name in c.inputs and not isinstance(task.inputs.signals[c.inputs.index(name)], int | float):
        raise ModelError(f"sensitivities: input {name!r} is sampled; only inputs that are constant can be named")


def _quasi(task: Task, names: tuple[str, ...], S: Vector, P: Vector) -> None:
    """Where the start is given in quasi-velocities y = P v, these stay: P dv = dy - (dP v)."""
    c = task.model
    x, v = task.y[: c.n], c.velocity_rows(np.array([task.t_start]), task.y[None, :], task.prepared)[0]
    D = quasi_partials(c, task.t_start, x, v, task.prepared)
    moved = D[:, : c.n] @ S[: c.n] + D[:, 2 * c.n :] @ P
    for column, name in enumerate(names):
        if name in c.quasi_velocities:
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
