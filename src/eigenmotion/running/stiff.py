"""Implicit methods of SciPy and SUNDIALS: they make the steps, and a compiled run is told them (em_told.h).

They solve for the motion (x, v) whatever the formulation, with a Jacobian of (x, v) -> (v, xddot), 2 n numbers square:
carrying C and s would multiply its size and add a fast variable wherever axes turn, for nothing that x does not know
(docs/theory.md). All else, events and what they do, rows, modes, witnesses, dense output, is the run's.
"""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from pkgutil import resolve_name
from typing import Any

import numpy as np
from scipy.integrate import Radau

from ..arguments.names import Vector
from ..arguments.options import Task
from ..results.solution import Solution
from ..runtime import TOLD, EvaluationError, RunInParts, StopReason, explain
from .compiled import solution_of
from .methods import Method

Function = Callable[[float], Vector]


@dataclass(slots=True)
class _Tally:
    """What solvers have counted; and why the rate had no value last, since the last step."""

    nfev: int = 0
    njev: int = 0
    nlu: int = 0
    obstacle: EvaluationError | None = None

    def add(self, solver: Any) -> None:
        self.nfev, self.njev, self.nlu = self.nfev + solver.nfev, self.njev + solver.njev, self.nlu + solver.nlu


def simulate_stiff(task: Task, method: Method) -> Solution:
    """Run a method whose steps are made in Python. They are not projected; every row that is given out is."""
    run, tally = RunInParts(task._replace(first_step=np.inf, max_step=np.inf), TOLD), _Tally()
    try:
        _follow(task, method, run, tally)
        run.close()
    except EvaluationError as error:
        run.close(error.stop, str(error))
    except KeyboardInterrupt:
        run.close(StopReason.INTERRUPTED)
    unknown = None if task.t_start != task.t_end else 0  # how many steps were rejected
    return solution_of(task, method, run, (tally.nfev, run.nsteps, unknown, 0, 0, tally.njev, tally.nlu))


def _follow(task: Task, method: Method, run: RunInParts, tally: _Tally) -> None:
    """Go from one kink of the inputs to the next, over which no polynomial reaches, and from event to event that acts.

    Raises
    ------
    EvaluationError
        Steps have become too short: says what stood in the way.
    """
    kinks = task.inputs.kinks(task.t_start, task.t_end)
    forward = task.t_end > task.t_start
    for start, end in pairwise([task.t_start, *(kinks if forward else kinks[::-1]), task.t_end]):
        u = _inputs(task, start, end)
        while run.t != end:
            z = np.concatenate(run.now())
            if not np.isfinite(z).all():
                raise _not_finite(task, z)
            solver = _solver(_in_its_mode(task, run), method, u, (run.t, end), z, tally)
            try:
                if not _tell(run, solver, tally):
                    return
            finally:
                tally.add(solver)


def _tell(run: RunInParts, solver: Any, tally: _Tally) -> bool:
    """Tell the steps of a solver up to its end, or an event that acts; return whether the run goes on."""

    def inside(t: Vector) -> Vector:
        values: Vector = solver.dense_output()(t)
        return values

    while solver.status == "running":
        start, z = solver.t, solver.y.copy()
        if not _stepped(solver):
            stop = StopReason.STEP_SIZE_UNDERFLOW
            raise tally.obstacle or EvaluationError(explain(stop, run.model.coordinates), stop)
        tally.obstacle = None
        goes_on = run.tell(start, z, solver.t, solver.y, inside)
        if not goes_on:
            return goes_on is None
    return True


def _in_its_mode(task: Task, run: RunInParts) -> Task:
    parameters = run.parameters
    return task if parameters is None else task._replace(prepared=task.model.prepare(np.array(parameters)))


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


def _solver(task: Task, method: Method, u: Function, span: tuple[float, float], z: Vector, tally: _Tally) -> Any:
    """Return a solver between two kinks from z (2 n,). It sees NaN where there is no rate, and tries a shorter step."""
    start, end = span

    def rate(t: float, z: Vector) -> Vector:
        try:
            found = task.model.motion_rate(t, z, task.prepared, u(t), task.least_norm)
        except EvaluationError as error:
            tally.obstacle = error
            return np.full_like(z, np.nan)
        if np.isfinite(z).all() and not np.isfinite(found).all():
            tally.obstacle = _not_finite(task, found)
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
