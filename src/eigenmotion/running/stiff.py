"""Implicit methods, on the motion (x, v) whatever the formulation: eigenfactors follow from x row by row.

They solve with a Jacobian of (x, v) -> (v, xddot), 2 n numbers square: carrying C and s would multiply its size and
add a fast variable wherever axes turn, for nothing that x does not know (docs/theory.md).
"""

from contextlib import suppress
from dataclasses import dataclass, field
from functools import cache, partial
from itertools import pairwise
from pkgutil import resolve_name
from typing import Any

import numpy as np
from scipy.integrate import OdeSolution, Radau

from ..arguments.names import Vector
from ..arguments.options import Task
from ..results.solution import DenseOutput, Solution
from ..results.trajectory import Trajectory
from ..runtime import EvaluationError, StopReason, explain, record
from .drift import Drift
from .methods import Method
from .watch import Function, Watch
from .witness import Witness


@dataclass(slots=True)
class _Progress:
    """Accepted steps so far: times, z = (x, v) (2 n,) and the interpolants between them.

    obstacle : why the rate had no value last, since the last accepted step
    """

    t: list[float]
    z: list[Vector]
    watch: Watch
    drift: Drift
    witness: Witness
    pieces: list[Any] = field(default_factory=list)
    nfev: int = 0
    njev: int = 0
    nlu: int = 0
    obstacle: EvaluationError | None = None

    def accept(self, solver: Any, u: Function, keep: bool) -> bool:
        """Take over a step; return whether a terminal event cut it short."""
        ends = {self.t[-1]: self.z[-1], float(solver.t): solver.y.copy()}
        between, (start, end) = cache(solver.dense_output), ends
        self.drift.check(end, solver.y)
        self.witness.check(end, solver.y, abs(end - start))
        self.obstacle = None
        inside: Function = lambda t: ends[t] if t in ends else between()(t)  # noqa: E731
        stop = self.watch.step(start, end, inside, u) if self.watch.t else None
        if stop == start:
            return True
        self.t.append(end if stop is None else stop)
        self.z.append(inside(self.t[-1]))
        if keep:
            self.pieces.append(between())
        return stop is not None

    def count(self, solver: Any) -> None:
        self.nfev, self.njev, self.nlu = self.nfev + solver.nfev, self.njev + solver.njev, self.nlu + solver.nlu


def simulate_stiff(task: Task, method: Method) -> Solution:
    """Run a method whose steps are made in Python. They are not projected; every row that is given out is."""
    model = task.model
    rows = np.ascontiguousarray(task.y[None, :])
    v = model.velocity_rows(np.array([task.t_start]), rows, task.prepared)[0]
    progress = _Progress(
        [task.t_start], [np.concatenate((task.y[: model.n], v))], Watch(task), Drift(task), Witness(task)
    )
    try:
        stop, said = _advance(task, method, progress)
    except EvaluationError as error:
        stop, said = error.stop, str(error)
    except KeyboardInterrupt:
        stop, said = StopReason.INTERRUPTED, ""
    words = said or explain(stop, model.coordinates)
    message = words if stop is StopReason.FINISHED else f"At t = {progress.t[-1]:.9g}: {words}"
    return _solution(task, progress, stop, message, method.name)


def _advance(task: Task, method: Method, progress: _Progress) -> tuple[StopReason, str]:
    """Integrate from one kink of the inputs to the next: no polynomial reaches across a jump."""
    kinks = task.inputs.kinks(task.t_start, task.t_end)
    forward = task.t_end > task.t_start
    ends = [task.t_start, *(kinks if forward else kinks[::-1]), task.t_end]
    progress.watch.start(ends[0], progress.z[0], _inputs(task, *ends[:2])(ends[0]))
    if task.t_start == task.t_end:
        return StopReason.FINISHED, ""
    progress.witness.begin(progress.z[0])
    for start, end in pairwise(ends):
        u = _inputs(task, start, end)
        solver = _solver(task, method, u, (start, end), progress)
        try:
            stop = _leg(task, solver, u, progress)
        finally:
            progress.count(solver)
        if stop is not StopReason.FINISHED:
            return stop, ""
    return StopReason.FINISHED, ""


def _leg(task: Task, solver: Any, u: Function, progress: _Progress) -> StopReason:
    while solver.status == "running":
        if len(progress.t) - 1 >= task.max_steps:
            return StopReason.TOO_MANY_STEPS
        if not _stepped(solver):
            if progress.obstacle is not None:
                raise progress.obstacle
            return StopReason.STEP_SIZE_UNDERFLOW
        if progress.accept(solver, u, keep=task.dense or task.t_eval is not None):
            return StopReason.TERMINAL_EVENT
    return StopReason.FINISHED


def _inputs(task: Task, start: float, end: float) -> Function:
    """Return u(t) between two kinks; at the ends, held inputs have the values they have between them."""
    low, high = sorted((np.nextafter(start, end), np.nextafter(end, start)))
    held = task.inputs.at(0.0) if task.inputs.constant else None
    return lambda t: task.inputs.at(min(max(t, low), high)) if held is None else held


def _stepped(solver: Any) -> bool:
    """Take a step; a Jacobian of infinities, which no solver can factor, is a failure like others."""
    before = solver.t
    try:
        solver.step()
    except (ValueError, np.linalg.LinAlgError) as error:
        if isinstance(error, EvaluationError):
            raise
        return False
    on = solver.status == "finished" or abs(solver.t - before) > 4 * np.spacing(abs(before))  # LSODA runs on the spot
    return solver.status != "failed" and on and bool(np.isfinite(solver.y).all())


_NEWTON = 0.01
"""How near to its stages Radau must come, in tolerances. SciPy asks for sqrt(rtol), which may be less than rounding
leaves of the rates of stiff springs: then stages seem not to converge, and steps get thousands of times too short."""


def _solver(task: Task, method: Method, u: Function, span: tuple[float, float], progress: _Progress) -> Any:
    """Return a solver between two kinks. It sees NaN where the rate has no value, and tries a shorter step."""
    (start, end), z = span, progress.z[-1]

    def rate(t: float, z: Vector) -> Vector:
        try:
            found = task.model.motion_rate(t, z, task.prepared, u(t), task.least_norm)
        except EvaluationError as error:
            progress.obstacle = error
            return np.full_like(z, np.nan)
        if np.isfinite(z).all() and not np.isfinite(found).all():
            progress.obstacle = _not_finite(task, found)
        return found

    def jacobian(t: float, z: Vector) -> Vector:
        return task.model.motion_jacobian(t, z, task.prepared, u(t), task.least_norm)

    first = min(task.first_step, abs(end - start)) or None
    solver = resolve_name(method.solver)(
        rate, start, z, end, jac=jacobian, rtol=task.rtol, atol=np.tile(task.atol, 2), first_step=first,
        max_step=task.max_step,
    )  # fmt: skip
    if isinstance(solver, Radau):
        solver.newton_tol = max(solver.newton_tol, _NEWTON)
    return solver


def _not_finite(task: Task, z: Vector) -> EvaluationError:
    worst = int(np.flatnonzero(~np.isfinite(z))[0]) % task.model.n
    stop = StopReason.NON_FINITE_STATE
    return EvaluationError(explain(stop, task.model.coordinates, worst), stop)


def _published(task: Task, t: Vector, z: Vector) -> Vector:
    """Return y (k, n_state) at z (k, 2 n): projected where asked, eigenfactors continuous from row to row."""
    n, model = task.model.n, task.model
    x, v = np.ascontiguousarray(z[:, :n]), np.ascontiguousarray(z[:, n:])
    if task.stabilise and model.m:
        for k, time in enumerate(t):
            with suppress(EvaluationError):  # the run has ended there, and says why
                x[k], v[k] = model.project(time, x[k], v[k], task.prepared, task.least_norm)
    return model.state_rows(t, x, v, task.prepared)


def _between(task: Task, interpolant: OdeSolution, t: Vector) -> Vector:
    """Return y (k, n_state) at t (k,) from what gives z (2 n, k) there."""
    return _published(task, t, interpolant(t).T)


def _solution(task: Task, progress: _Progress, stop: StopReason, message: str, method: str) -> Solution:
    t, z = np.array(progress.t), np.array(progress.z)
    between = OdeSolution(t, progress.pieces) if progress.pieces else None
    sol = DenseOutput(t, partial(_between, task, between)) if task.dense and between else None
    if task.t_eval is not None:
        reached = np.abs(task.t_eval - task.t_start) <= abs(t[-1] - task.t_start)
        t_eval = task.t_eval[reached]
        if between is not None and t_eval.size:  # SciPy's interpolants take no empty array
            z = np.ascontiguousarray(between(t_eval).T)
        else:
            z = np.repeat(z[:1], len(t_eval), axis=0)
        t = t_eval
    rows = _published(task, t, z)
    t_events, y_events = _events(task, progress.watch)
    unknown = None if task.t_start != task.t_end else 0
    counts = progress.nfev, len(progress.t) - 1, unknown, 0, 0, progress.njev, progress.nlu
    fields = record(t, rows.T, t_events, y_events, stop, message, method, counts, sol)
    return Solution(Trajectory(task, t, rows), fields)


def _events(task: Task, watch: Watch) -> tuple[list[Vector], list[Vector]] | tuple[None, None]:
    """Return t_events and y_events; None where the model has no events."""
    if not task.model.events:
        return None, None
    times, n = [np.array(t) for t in watch.t], task.model.n
    return times, [_published(task, t, np.array(z).reshape(-1, 2 * n)) for t, z in zip(times, watch.z, strict=True)]
