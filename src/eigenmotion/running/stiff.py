"""Implicit methods, on the motion (x, v) whatever the formulation: eigenfactors follow from x row by row.

They solve with a Jacobian of (x, v) -> (v, xddot), 2 n numbers square: carrying C and s would multiply its size and
add a fast variable wherever axes turn, for nothing that x does not know (docs/theory.md).
"""

from dataclasses import dataclass
from functools import cache, partial
from itertools import pairwise
from pkgutil import resolve_name
from typing import Any

import numpy as np
from scipy.integrate import Radau

from ..arguments.names import Vector
from ..arguments.options import Task
from ..results.solution import DenseOutput, Solution
from ..results.trajectory import Trajectory
from ..runtime import EvaluationError, StopReason, explain, modes_of, record
from .drift import Drift
from .legs import Leg, between, event_rows, modes, published
from .methods import Method
from .watch import Function, Watch
from .witness import Witness


@dataclass(slots=True)
class _Progress:
    """Accepted steps so far: times, z = (x, v) (2 n,), and the legs that they are of.

    pile : (n_events, 2) of `act`
    obstacle : why the rate had no value last, since the last accepted step
    """

    t: list[float]
    z: list[Vector]
    watch: Watch
    drift: Drift
    witness: Witness
    legs: list[Leg]
    pile: Vector
    nsteps: int = 0
    nfev: int = 0
    njev: int = 0
    nlu: int = 0
    obstacle: EvaluationError | None = None

    def accept(self, solver: Any, u: Function, keep: bool) -> bool:
        """Take over a step; return whether an event cut it short that is terminal or acts."""
        ends = {self.t[-1]: self.z[-1], float(solver.t): solver.y.copy()}
        between, (start, end) = cache(solver.dense_output), ends
        self.drift.check(end, solver.y)
        self.witness.check(end, solver.y, abs(end - start))
        self.obstacle = None
        inside: Function = lambda t: ends[t] if t in ends else between()(t)  # noqa: E731
        stop = self.watch.step(start, end, inside, u) if self.watch.t else None
        self.nsteps += 1
        if stop == start:
            return True
        self.t.append(end if stop is None else stop)
        self.z.append(inside(self.t[-1]))
        self.legs[-1].t.append(self.t[-1])
        if keep:
            self.legs[-1].pieces.append(between())
        return stop is not None

    def act(self, u: Vector) -> None:
        """Do what the events do that have just happened; a leg begins."""
        task, t = self.legs[-1].task, self.t[-1]
        fired = self.watch.fired
        z, task, jumps = _acted(task, t, self.z[-1], u, fired, self.pile)
        self.t.append(t)
        self.z.append(z)
        self.legs.append(Leg(task, len(self.t) - 1, [t], z))
        self.watch.go_on(task, t, z, u, fired, jumps)
        self.drift, self.witness = Drift(task), Witness(task)
        self.witness.begin(z)

    def count(self, solver: Any) -> None:
        self.nfev, self.njev, self.nlu = self.nfev + solver.nfev, self.njev + solver.njev, self.nlu + solver.nlu


def _acted(task: Task, t: float, z: Vector, u: Vector, fired: Vector, pile: Vector) -> tuple[Vector, Task, Vector]:
    """Return z (2 n,) after the events that fired, the task in the mode of then, and the events whose number jumps."""
    model, n = task.model, task.model.n
    x, v = z[:n], z[n:]
    if task.stabilise and model.m:
        x, v = model.project(t, x, v, task.prepared, task.least_norm)
    x, v, prepared, jumps = model.act(t, x, v, task.prepared, u, task.least_norm, fired, pile)
    return np.concatenate((x, v)), task._replace(prepared=prepared), jumps


def simulate_stiff(task: Task, method: Method) -> Solution:
    """Run a method whose steps are made in Python. They are not projected; every row that is given out is."""
    model = task.model
    rows = np.ascontiguousarray(task.y[None, :])
    v = model.velocity_rows(np.array([task.t_start]), rows, task.prepared)[0]
    z, pile = np.concatenate((task.y[: model.n], v)), np.zeros((len(model.events), 2))
    leg = Leg(task, 0, [task.t_start], z)
    progress = _Progress([task.t_start], [z], Watch(task), Drift(task), Witness(task), [leg], pile)
    try:
        if model.switches:
            _choose_mode(progress)
        stop, said = _advance(method, progress)
    except EvaluationError as error:
        stop, said = error.stop, str(error)
    except KeyboardInterrupt:
        stop, said = StopReason.INTERRUPTED, ""
    words = said or explain(stop, model.coordinates)
    message = words if stop is StopReason.FINISHED else f"At t = {progress.t[-1]:.9g}: {words}"
    return _solution(task, progress, stop, message, method.name)


def _choose_mode(progress: _Progress) -> None:
    """The mode in which a run starts."""
    task, t = progress.legs[0].task, progress.t[0]
    u = _inputs(task, t, task.t_end)(t)
    z, task, _ = _acted(task, t, progress.z[0], u, np.zeros(len(task.model.events)), progress.pile)
    progress.z[0], progress.legs[0] = z, Leg(task, 0, [t], z)
    progress.watch, progress.drift, progress.witness = Watch(task), Drift(task), Witness(task)


def _advance(method: Method, progress: _Progress) -> tuple[StopReason, str]:
    """Integrate from one kink of the inputs to the next: no polynomial reaches across a jump."""
    task = progress.legs[0].task
    kinks = task.inputs.kinks(task.t_start, task.t_end)
    forward = task.t_end > task.t_start
    ends = [task.t_start, *(kinks if forward else kinks[::-1]), task.t_end]
    progress.watch.start(ends[0], progress.z[0], _inputs(task, *ends[:2])(ends[0]))
    if task.t_start == task.t_end:
        return StopReason.FINISHED, ""
    progress.witness.begin(progress.z[0])
    for start, end in pairwise(ends):
        stop = _to(end, method, _inputs(task, start, end), progress)
        if stop is not StopReason.FINISHED:
            return stop, ""
    return StopReason.FINISHED, ""


def _to(end: float, method: Method, u: Function, progress: _Progress) -> StopReason:
    """Integrate to the next kink, leg by leg."""
    while progress.t[-1] != end:
        task = progress.legs[-1].task
        solver = _solver(task, method, u, (progress.t[-1], end), progress)
        try:
            stop = _steps(task, solver, u, progress)
        finally:
            progress.count(solver)
        if stop is StopReason.TERMINAL_EVENT and progress.watch.fired.any():
            progress.act(u(progress.t[-1]))
            stop = StopReason.TERMINAL_EVENT if progress.watch.ends else StopReason.FINISHED
        if stop is not StopReason.FINISHED:
            return stop
    return StopReason.FINISHED


def _steps(task: Task, solver: Any, u: Function, progress: _Progress) -> StopReason:
    while solver.status == "running":
        if progress.nsteps >= task.max_steps:
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


def _solution(task: Task, progress: _Progress, stop: StopReason, message: str, method: str) -> Solution:
    t, legs = np.array(progress.t), progress.legs
    dense = task.dense and any(leg.pieces for leg in legs)
    sol = DenseOutput(np.unique(t), partial(between, legs, "right")) if dense else None
    if task.t_eval is None:
        which = np.searchsorted([leg.first for leg in legs[1:]], np.arange(len(t)), "right")
        rows = published(legs, which, t, np.array(progress.z))
    else:
        t = task.t_eval[np.abs(task.t_eval - task.t_start) <= abs(t[-1] - task.t_start)]
        rows = between(legs, "left", t)
    found = modes(legs, t, task.t_eval is None) if task.model.switches else ()
    unknown = None if task.t_start != task.t_end else 0
    counts = progress.nfev, progress.nsteps, unknown, 0, 0, progress.njev, progress.nlu
    t_events, y_events = event_rows(legs, progress.watch.t, progress.watch.z)
    after = event_rows(legs, progress.watch.t, progress.watch.after)[1] if task.model.acts else None
    if y_events and after:
        after = [now if acts else y for now, y, (acts, _) in zip(after, y_events, task.model.deeds, strict=True)]
    fields = record(
        t, rows.T, t_events, y_events, stop, message, method, counts, sol, after, modes_of(task.model, found)
    )
    return Solution(Trajectory(task, t, rows, found), fields)
