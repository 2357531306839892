"""SciPy's stiff methods on the published right-hand side, with every failure named and nothing lost."""

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
from .trajectory import Trajectory

METHODS = {"radau": Radau, "bdf": BDF, "lsoda": LSODA}


@dataclass(slots=True)
class _Progress:
    """Accepted steps so far: times, states (n_state,) and the interpolants between them."""

    t: list[float]
    y: list[Vector]
    pieces: list[Any] = field(default_factory=list)
    nfev: int = 0
    njev: int = 0
    nlu: int = 0

    def count(self, solver: Any) -> None:
        self.nfev, self.njev, self.nlu = self.nfev + solver.nfev, self.njev + solver.njev, self.nlu + solver.nlu


def simulate_stiff(task: Task, method: str) -> Solution:
    """Run one of METHODS; no projection takes place."""
    progress = _Progress([task.t_start], [task.y])
    try:
        stop, said = _advance(task, METHODS[method], progress)
    except EvaluationError as error:
        stop, said = error.stop, str(error)
    except KeyboardInterrupt:
        stop, said = StopReason.INTERRUPTED, ""
    words = said or explain(stop, task.model.coordinates)
    message = words if stop.success else f"At t = {progress.t[-1]:.9g}: {words}"
    return _solution(task, progress, stop, message)


def _advance(task: Task, kind: Callable[..., Any], progress: _Progress) -> tuple[StopReason, str]:
    """Integrate from one kink of the inputs to the next: no polynomial reaches across a jump."""
    kinks = task.inputs.kinks(task.t_start, task.t_end)
    forward = task.t_end > task.t_start
    ends = [task.t_start, *(kinks if forward else kinks[::-1]), task.t_end]
    for start, end in pairwise(ends):
        solver = kind(_fun(task, start, end), start, progress.y[-1], end, **_options(task, abs(end - start)))
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
        progress.y.append(solver.y.copy())
        if task.dense or task.t_eval is not None:
            progress.pieces.append(solver.dense_output())
    return StopReason.FINISHED


def _fun(task: Task, start: float, end: float) -> Callable[[float, Vector], Vector]:
    """Return f(t, y) between two kinks; at the ends, held inputs have the values they have between them."""
    rhs, c = task.model.rhs, task.prepared
    if task.inputs.constant:
        u = task.inputs.at(0.0)
        return lambda t, y: rhs(t, y, c, u)
    low, high = sorted((np.nextafter(start, end), np.nextafter(end, start)))
    return lambda t, y: rhs(t, y, c, task.inputs.at(min(max(t, low), high)))


def _options(task: Task, length: float) -> dict[str, Any]:
    """rtol, atol of y, and steps. C has no unit and is measured against rtol, s against itself."""
    atol = np.zeros(task.model.n_state)
    for name, start, size in task.model.layout:
        atol[start : start + size] = task.rtol if name.startswith("C") else 0.0
    atol[: 2 * task.model.n] = np.tile(task.atol, 2)
    first = min(task.first_step, length) or None
    return {"rtol": task.rtol, "atol": atol, "first_step": first, "max_step": task.max_step}


def _solution(task: Task, progress: _Progress, stop: StopReason, message: str) -> Solution:
    t, rows = np.array(progress.t), np.array(progress.y)
    dense = OdeSolution(t, progress.pieces) if progress.pieces else None
    if task.t_eval is not None:
        reached = np.abs(task.t_eval - task.t_start) <= abs(t[-1] - task.t_start)
        t_eval = task.t_eval[reached]
        rows = np.ascontiguousarray(dense(t_eval).T) if dense else np.repeat(rows, len(t_eval), axis=0)
        t = t_eval
    trajectory = Trajectory(task.model, task.prepared, task.inputs, task.least_norm, t, rows)
    return Solution(
        trajectory,
        t=t, y=rows.T, sol=dense if task.dense else None, t_events=None, y_events=None,
        nfev=progress.nfev, njev=progress.njev, nlu=progress.nlu,
        status=0 if stop.success else -1, message=message, success=stop.success,
        nsteps=len(progress.t) - 1, nrejected=0, n_bounded=0, stop=stop,
    )  # fmt: skip
