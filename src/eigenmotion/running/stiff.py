"""Implicit methods of SciPy and SUNDIALS: they make the steps, and a compiled run is told them (em_told.h).

They solve for the motion (x, v) whatever the formulation, with a Jacobian of (x, v) -> (v, xddot), 2 n numbers square:
carrying C and s would multiply its size and add a fast variable wherever axes turn, for nothing that x does not know
(docs/theory.md). All else, events and what they do, rows, modes, witnesses, dense output, is the run's.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from pkgutil import resolve_name
from typing import Any, NamedTuple

import numpy as np
import scipy

from ..arguments.names import Vector
from ..arguments.options import Task
from ..results.solution import Solution
from ..runtime import TOLD, EvaluationError, RunInParts, StopReason, explain
from .compiled import solution_of
from .leaving import FIRST_STEPS, joined
from .methods import METHODS, Method


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
    """Go from one kink in time to the next, over which no polynomial reaches, and from event to event that acts.

    Raises
    ------
    EvaluationError
        Steps have become too short: says what stood in the way.
    """
    fresh = task.model.acts and method.begins != ""
    for end, side in _pieces(task):
        while run.t != end:
            z = np.concatenate(run.now())
            if not np.isfinite(z).all():
                raise _not_finite(task, z)
            making = METHODS[method.begins] if fresh else method
            solver = _solver(_in_its_mode(task, run), making, side, (run.t, end), z, tally)
            try:
                goes_on = _tell(run, solver, tally, fresh)
            finally:
                tally.add(solver)
            if goes_on is False:
                return
            fresh = method.begins != "" and (goes_on is None or (fresh and solver.status != "running"))


def _tell(run: RunInParts, solver: Any, tally: _Tally, fresh: bool) -> bool | None:
    """Tell the steps of a solver up to its end, of a fresh leg the first ones.

    Returns
    -------
    bool or None
        Whether the run goes on; None: an event has acted.
    """

    def inside(t: Vector) -> Vector:
        values: Vector = (solver.dense_output() if between is None else between)(t)
        return values

    last = run.nsteps + FIRST_STEPS
    while solver.status == "running" and not (fresh and run.nsteps >= last):
        start, z, rate = solver.t, solver.y.copy(), solver.f.copy() if fresh else None
        if not _stepped(solver):
            stop = StopReason.STEP_SIZE_UNDERFLOW
            raise tally.obstacle or EvaluationError(explain(stop, run.model.coordinates), stop)
        tally.obstacle = None
        between = None if rate is None else joined((start, solver.t), (z, solver.y), (rate, solver.f))
        goes_on = run.tell(start, z, solver.t, solver.y, inside)
        if not goes_on:
            return goes_on
    return True


def _in_its_mode(task: Task, run: RunInParts) -> Task:
    parameters = run.parameters
    return task if parameters is None else task._replace(prepared=task.model.prepare(np.array(parameters)))


class _Side(NamedTuple):
    """What holds between two kinks: the times at which inputs and the model are asked there, and inputs that rest."""

    task: Task
    inputs: tuple[float, float]
    model: tuple[float, float]
    held: Vector | None

    def u(self, t: float) -> Vector:
        """Return the inputs; at the ends, held ones have the values they have between them."""
        low, high = self.inputs
        values: Vector = self.task.inputs.at(min(max(t, low), high))
        return values if self.held is None else self.held

    def clock(self, t: float) -> float:
        """Return when the model is asked: at a break, so that its conditions are those of this side (em_breaks.h)."""
        low, high = self.model
        return min(max(t, low), high)


def _pieces(task: Task) -> Iterator[tuple[float, _Side]]:
    """Yield where each piece of a run ends, a kink of an input or a break of the model, and what holds before."""
    t, sign = task.t_start, 1.0 if task.t_end >= task.t_start else -1.0
    kinks = task.inputs.kinks(task.t_start, task.t_end) if task.model.n_inputs else ()
    held = task.inputs.at(0.0) if task.inputs.constant else None
    while t != task.t_end:
        end, *clock = task.model.piece(t, sign, task.prepared)
        end = sign * min([sign * end, sign * task.t_end, *(sign * kink for kink in kinks if sign * kink > sign * t)])
        low, high = sorted((float(np.nextafter(t, end)), float(np.nextafter(end, t))))
        yield end, _Side(task, (low, high), (clock[0], clock[1]), held)
        t = end


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


def _solver(task: Task, method: Method, side: _Side, span: tuple[float, float], z: Vector, tally: _Tally) -> Any:
    """Return a solver between two kinks from z (2 n,). It sees NaN where there is no rate, and tries a shorter step."""
    start, end = span

    def rate(t: float, z: Vector) -> Vector:
        try:
            found = task.model.motion_rate(side.clock(t), z, task.prepared, side.u(t), task.least_norm)
        except EvaluationError as error:
            tally.obstacle = error
            return np.full_like(z, np.nan)
        if np.isfinite(z).all() and not np.isfinite(found).all():
            tally.obstacle = _not_finite(task, found)
        return found

    def jacobian(t: float, z: Vector) -> Vector:
        return task.model.motion_jacobian(side.clock(t), z, task.prepared, side.u(t), task.least_norm)

    kind, first = resolve_name(method.solver), min(task.first_step, abs(end - start)) or None
    if first is None and kind is scipy.integrate.LSODA:
        first, tally.nfev = _first_step(task, abs(end - start), z, rate(start, z)), tally.nfev + 1
    solver = kind(
        rate, start, z, end, jac=jacobian, rtol=task.rtol, atol=np.tile(task.atol, 2), first_step=first,
        max_step=task.max_step,
    )  # fmt: skip
    if isinstance(solver, scipy.integrate.Radau):
        solver.newton_tol = max(solver.newton_tol, _NEWTON)
    return solver


def _first_step(task: Task, way: float, z: Vector, dz: Vector) -> float | None:
    """Return how long LSODA's is by its own rule, where it has the larger |t| of both ends for the way between them.

    What it makes of a clock that started long ago is another motion, off by ten times as much.
    """
    with np.errstate(all="ignore"):
        size = np.max(np.abs(dz) / (task.rtol * np.abs(z) + np.tile(task.atol, 2)))
        part = np.clip(task.rtol or np.nanmax(np.tile(task.atol, 2) / np.abs(z)), 100 * np.finfo(float).eps, 1e-3)
        first = min(1 / np.sqrt(1 / (part * way**2) + part * size**2), way)
    return float(first) if first > 0 else None


def _not_finite(task: Task, z: Vector) -> EvaluationError:
    worst = int(np.flatnonzero(~np.isfinite(z))[0]) % task.model.n
    stop = StopReason.NON_FINITE_STATE
    return EvaluationError(explain(stop, task.model.coordinates, worst), stop)
