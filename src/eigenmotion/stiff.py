"""Implicit methods, on the motion (x, v) whatever the formulation: eigenfactors follow from x row by row.

They solve with a Jacobian of (x, v) -> (v, xddot), 2 n numbers square: carrying C and s would multiply its size and
add a fast variable wherever axes turn, for nothing that x does not know (docs/theory.md).
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np
from scipy.integrate import BDF, LSODA, OdeSolution, Radau

from .names import Vector
from .options import Task
from .runtime import EvaluationError, StopReason, explain
from .solution import Solution
from .sundials import Cvode
from .trajectory import Trajectory

METHODS: dict[str, Callable[..., Any]] = {"radau": Radau, "bdf": BDF, "lsoda": LSODA, "cvode": Cvode}


@dataclass(slots=True)
class _Progress:
    """Accepted steps so far: times, z = (x, v) (2 n,) and the interpolants between them."""

    t: list[float]
    z: list[Vector]
    pieces: list[Any] = field(default_factory=list)
    nfev: int = 0
    njev: int = 0
    nlu: int = 0

    def count(self, solver: Any) -> None:
        self.nfev, self.njev, self.nlu = self.nfev + solver.nfev, self.njev + solver.njev, self.nlu + solver.nlu


class Motion:
    """Dense output: y (n_state, k) at times (k,), made of the interpolated x and v like any row."""

    def __init__(self, task: Task, between: OdeSolution) -> None:
        self._task, self._between = task, between
        self.t_min, self.t_max = between.t_min, between.t_max

    def __call__(self, t: Any) -> Vector:
        """Return y at t (a number or (k,))."""
        times = np.atleast_1d(np.asarray(t, dtype=float))
        rows = _published(self._task, times, self._between(times).T)
        return rows[0] if np.ndim(t) == 0 else rows.T


def simulate_stiff(task: Task, method: str) -> Solution:
    """Run one of METHODS. The integration itself is not projected; every row that is given out is."""
    model = task.model
    rows = np.ascontiguousarray(task.y[None, :])
    v = model.velocity_rows(np.array([task.t_start]), rows, task.prepared)[0]
    progress = _Progress([task.t_start], [np.concatenate((task.y[: model.n], v))])
    try:
        stop, said = _advance(task, METHODS[method], progress)
    except EvaluationError as error:
        stop, said = error.stop, str(error)
    except KeyboardInterrupt:
        stop, said = StopReason.INTERRUPTED, ""
    words = said or explain(stop, model.coordinates)
    message = words if stop.success else f"At t = {progress.t[-1]:.9g}: {words}"
    return _solution(task, progress, stop, message)


def _advance(task: Task, kind: Callable[..., Any], progress: _Progress) -> tuple[StopReason, str]:
    """Integrate from one kink of the inputs to the next: no polynomial reaches across a jump."""
    kinks = task.inputs.kinks(task.t_start, task.t_end)
    forward = task.t_end > task.t_start
    ends = [task.t_start, *(kinks if forward else kinks[::-1]), task.t_end]
    for start, end in pairwise(ends):
        solver = _solver(task, kind, start, end, progress.z[-1])
        try:
            stop = _leg(task, solver, progress)
        finally:
            progress.count(solver)
        if stop is not StopReason.FINISHED:
            return stop, ""
    return StopReason.FINISHED, ""


def _leg(task: Task, solver: Any, progress: _Progress) -> StopReason:
    while solver.status == "running":
        if len(progress.t) > task.max_steps:
            return StopReason.TOO_MANY_STEPS
        solver.step()
        if solver.status == "failed":
            return StopReason.STEP_SIZE_UNDERFLOW
        if not np.isfinite(solver.y).all():
            return StopReason.NON_FINITE_STATE
        progress.t.append(float(solver.t))
        progress.z.append(solver.y.copy())
        if task.dense or task.t_eval is not None:
            progress.pieces.append(solver.dense_output())
    return StopReason.FINISHED


def _solver(task: Task, kind: Callable[..., Any], start: float, end: float, z: Vector) -> Any:
    """Return a solver between two kinks; at the ends, held inputs have the values they have between them."""
    low, high = sorted((np.nextafter(start, end), np.nextafter(end, start)))
    held = task.inputs.at(0.0) if task.inputs.constant else None

    def inputs(t: float) -> Vector:
        return task.inputs.at(min(max(t, low), high)) if held is None else held

    def rate(t: float, z: Vector) -> Vector:
        return task.model.motion_rate(t, z, task.prepared, inputs(t), task.least_norm)

    def jacobian(t: float, z: Vector) -> Vector:
        return task.model.motion_jacobian(t, z, task.prepared, inputs(t), task.least_norm)

    first = min(task.first_step, abs(end - start)) or None
    return kind(
        rate, start, z, end, jac=jacobian, rtol=task.rtol, atol=np.tile(task.atol, 2), first_step=first,
        max_step=task.max_step,
    )  # fmt: skip


def _published(task: Task, t: Vector, z: Vector) -> Vector:
    """Return y (k, n_state) at z (k, 2 n): projected where asked, eigenfactors continuous from row to row."""
    n, model = task.model.n, task.model
    x, v = np.ascontiguousarray(z[:, :n]), np.ascontiguousarray(z[:, n:])
    if task.project and model.m:
        for k, time in enumerate(t):
            x[k], v[k] = model.project(time, x[k], v[k], task.prepared, task.least_norm)
    return model.state_rows(t, x, v, task.prepared)


def _solution(task: Task, progress: _Progress, stop: StopReason, message: str) -> Solution:
    t, z = np.array(progress.t), np.array(progress.z)
    dense = OdeSolution(t, progress.pieces) if progress.pieces else None
    if task.t_eval is not None:
        reached = np.abs(task.t_eval - task.t_start) <= abs(t[-1] - task.t_start)
        t_eval = task.t_eval[reached]
        z = np.ascontiguousarray(dense(t_eval).T) if dense else np.repeat(z[:1], len(t_eval), axis=0)
        t = t_eval
    rows = _published(task, t, z)
    trajectory = Trajectory(task.model, task.prepared, task.inputs, task.least_norm, t, rows)
    return Solution(
        trajectory,
        t=t, y=rows.T, sol=Motion(task, dense) if task.dense and dense else None, t_events=None, y_events=None,
        nfev=progress.nfev, njev=progress.njev, nlu=progress.nlu,
        status=0 if stop.success else -1, message=message, success=stop.success,
        nsteps=len(progress.t) - 1, nrejected=0, n_bounded=0, stop=stop,
    )  # fmt: skip
