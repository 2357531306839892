"""Sensitivities of a motion with respect to parameters, inputs and its start."""

from functools import lru_cache, partial
from typing import NamedTuple

import numpy as np

from ...arguments.differentiation import Differentiated, rates_of
from ...arguments.methods import Method
from ...arguments.named_values import Vector
from ...arguments.tasks import Task
from ...codegen.model.normalise import ModelError
from ...results.sensitivity import Sensitivity, parts_of
from ...results.solution import Solution
from ...runtime import CompiledModel, EvaluationError, Run
from ...runtime.variations import Variations, quasi_partials, tangent
from .collocation_mesh import A2, PLACE, SERIES, A, Mesh, mesh_of
from .run_path import Path, dense_run, path_of

TOGETHER = {"ra15": 1.5, "radau5": 1.0, "radau9": 1.0, "dop853": 3.0}
"""Initial step of the variational equations, in steps of the run; their polynomials are of higher degree. Later steps
follow from an error estimate (em_variation_error.h)."""
_LEAST = 1e-13
"""Least relative tolerance of that error."""


class Directions(NamedTuple):
    """The directions in which a motion is differentiated, in the order of `names`.

    S : (2 n, columns) directions of x and v at the start; P : (n_arguments - 2 n, columns) of inputs, parameters, time
    """

    names: tuple[str, ...]
    S: Vector
    P: Vector


def through_no_controller(name: str) -> ModelError:
    """Return the error for sensitivities of runs with controllers."""
    return ModelError(
        f"{name}: sensitivities do not go through a controller (Sampled): differentiate the closed loop by a run with "
        "its control law in the model's forces"
    )


def directions(varied: Differentiated, task: Task) -> Directions:
    """Return the directions at the start of a run.

    Raises
    ------
    ModelError
        A sampled input is named, or the run has a controller.
    """
    c, names = task.model, varied.names
    if task.inputs.sampled:
        raise through_no_controller(c.name)
    S, P = np.zeros((2 * c.n, len(names))), np.zeros((c.n_arguments - 2 * c.n, len(names)))
    state, given = _places(c.coordinates, c.n_states, c.inputs, c.parameters)
    for column, name in enumerate(names):
        if name in state:
            S[state[name], column] = 1.0
        elif name in given:
            P[given[name], column] = 1.0
            if given[name] < c.n_inputs:
                _check_constant(task, given[name])
    if varied.from_quasi:
        _quasi(task, names, S, P)
    return Directions(names, S, P)


@lru_cache(maxsize=16)
def _places(
    coordinates: tuple[str, ...], n_states: int, inputs: tuple[str, ...], parameters: tuple[str, ...]
) -> tuple[dict[str, int], dict[str, int]]:
    """Return name -> row of S, and name -> row of P; states are velocities (`arguments.states`)."""
    n = len(coordinates) - n_states
    moving, given = (*rates_of(coordinates[:n]), *coordinates[n:]), (*inputs, *parameters)
    state = {name: row for row, name in enumerate(coordinates[:n])}
    state |= {name: len(coordinates) + row for row, name in enumerate(moving)}
    return state, {name: row for row, name in enumerate(given)}


def _check_constant(task: Task, k: int) -> None:
    if not isinstance(task.inputs.signals[k], int | float):
        name = task.model.inputs[k]
        raise ModelError(f"sensitivities: input {name!r} is sampled; only inputs that are constant can be named")


def _quasi(task: Task, names: tuple[str, ...], S: Vector, P: Vector) -> None:
    """Convert directions of a start in quasi-velocities y = P v, which stay fixed: P dv = dy - (dP v)."""
    c = task.model
    x, v = task.y[: c.n], c.velocity_rows(np.array([task.t_start]), task.y[None, :], task.prepared)[0]
    D = quasi_partials(c, task.t_start, x, v, task.prepared)
    moved = D[:, : c.n] @ S[: c.n] + D[:, 2 * c.n :] @ P
    for column, name in enumerate(names):
        if name in c.quasi_velocities:
            moved[c.quasi_velocities.index(name), column] -= 1.0
    free = [column for column, name in enumerate(names) if not name.endswith("'")]
    S[c.n :, free] = -np.linalg.solve(D[:, c.n : 2 * c.n], moved[:, free])


def sensitivity(task: Task, solution: Solution, varied: Directions, method: Method) -> dict[str, Sensitivity]:
    """Return name -> derivatives of all rows of a run with dense output.

    Raises
    ------
    ModelError
        A force jumps without an event of the model, or the time of an event action has no derivative: two happen at
        once, or the event function only touches zero.
    """
    path, parts = path_of(task, solution), partial(parts_of, task.model)
    S, shifts, fault = _varied(task, solution, varied, path, _together(solution, method))
    if fault is not None and solution.success:  # otherwise the message of the failed run says why
        raise ModelError(remedied(task.model, fault))
    rows = S[path.of_rows].T  # (columns, 2 n, k)
    if not task.model.events:
        return {name: Sensitivity.of(*parts(one), None) for name, one in zip(varied.names, rows, strict=True)}
    return {
        name: Sensitivity.of(*parts(one), [shifts[marks, column] for marks in path.of_events])
        for column, (name, one) in enumerate(zip(varied.names, rows, strict=True))
    }


def _together(solution: Solution, method: Method) -> float:
    """Return the initial step of the variational equations, in steps of the run."""
    return 1.0 if solution["methods"] else TOGETHER.get(method.name, 3.0)


def remedied(c: CompiledModel, fault: EvaluationError) -> str:
    """Return the message of derivatives that end early, with what to do."""
    words = str(fault)
    remedy = _APART if "at once" in words else _remedy(c) if "jumps" in words else "end the run before"
    return f"{fault}. Sensitivities end there: {remedy}"


_APART = "end the run before, start where one of them is clearly first, or vary only what keeps them at once"


def _remedy(c: CompiledModel) -> str:
    """Return what to do about a force that jumps."""
    event = "give the model an event whose expression passes through zero where the force jumps, or make it smooth"
    names = ", ".join(dict.fromkeys([*c.prescribed, *c.tables]))
    if not names:
        return event
    return (f"where it jumps at a join of a table or a signal ({names}), give it a smoother one, CubicSpline(points, "
            f"values) or make_interp_spline(points, values, k=5) of SciPy; elsewhere, {event}")  # fmt: skip


def _varied(
    task: Task, solution: Solution, varied: Directions, path: Path, together: float
) -> tuple[Vector, Vector, EvaluationError | None]:
    """Return directions (k, 2 n, columns) at all nodes, derivatives (marks, columns) of event times, and an error.

    With an error, they are NaN from some time on.
    """
    c, n, columns = task.model, task.model.n, len(varied.names)
    try:
        S = tangent(c, path.t[0], path.z[0, :n], path.z[0, n:], path.prepared, task.least_norm, varied.S, varied.P)
    except EvaluationError as error:
        return np.full((len(path.t), 2 * n, columns), np.nan), np.full((len(path.mark_row), columns), np.nan), error
    along, mesh = variations_of(task, dense_run(solution), path, S, varied.P, together)
    fault = along.integrate()
    if not len(along.at_rows):
        return along.at_stops, along.shifts, fault
    along.at_rows[mesh.stops] = along.at_stops
    return along.at_rows, along.shifts, fault


def variations_of(
    task: Task, run: Run | None, path: Path, S: Vector, P: Vector, together: float
) -> tuple[Variations, Mesh]:
    """Return the integration of directions S (2 n, columns), P (n_forcing, columns) along a path, and its mesh.

    Its rows are the nodes of the path, if any of these lies between the stops.
    """
    kinks = np.empty(0)
    if task.model.n_inputs:
        kinks = np.array(task.inputs.kinks(*sorted((task.t_start, task.t_end))), dtype=float)
    mesh = mesh_of(path, np.union1d(kinks, _breaks(task, path)))
    marks = mesh.stops.searchsorted(path.mark_row), path.mark_event
    rows = path.t if len(mesh.stops) < len(path.t) else np.empty(0)
    along = Variations(
        task.model, path.prepared, run, task.inputs.compiled,
        1.0 if task.t_end >= task.t_start else -1.0, max(task.rtol, _LEAST), together,
        (path.t[mesh.stops], path.z[mesh.stops], mesh.spans_after), (mesh.start, mesh.end), marks,
        (PLACE, A, A2, SERIES), rows, S, P, task.stabilise, task.least_norm,
    )  # fmt: skip
    return along, mesh


def _breaks(task: Task, path: Path) -> Vector:
    """Return the times (k,) of the time events along a path."""
    end, times = float(path.t[-1]), []
    t, sign = float(path.t[0]), 1.0 if task.t_end >= task.t_start else -1.0
    while sign * (t := task.model.smooth_interval(t, sign, path.prepared)[0]) < sign * end:
        times.append(t)
    return np.array(times)
