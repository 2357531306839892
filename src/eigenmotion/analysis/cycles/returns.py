"""One return: a run from a start over one period, with its derivatives."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from ...results.solution import Solution
from ...runtime import EvaluationError, StopReason
from ...simulation.simulate import simulate
from ..state.operating_point import OperatingPoint
from ..state.tangent_space import Tangent, shift, tangent
from .periodic_problem import Problem
from .quantities import TIME, Quantity

_AT_ONCE = 1e-8
"""Part of a period within which an event at the start of a run belongs to the period before."""


class NoReturnError(ModelError):
    """A run that does not return: it failed, ended before, or has no derivatives."""


@dataclass(frozen=True)
class Section:
    """Where a motion starts and ends; if nothing is given, the hyperplane normal to the motion.

    event : the number of an event of the model; times : how often it happens in a period
    place : a number of the state that keeps its value
    quantity : an expression that is zero; direction : 1 where it increases, -1 where it decreases, 0 for both
    """

    event: int | None = None
    times: int = 1
    place: int | None = None
    quantity: Quantity | None = None
    direction: int = 0


@dataclass(frozen=True)
class Shift:
    """Derivatives by each name of `by` of the problem, with the start moved along the constraints.

    start, end : (2 n, k) of the start and the end, the latter at the end of the period; period : (k,) of the period
    """

    start: Vector
    end: Vector
    period: Vector


@dataclass(frozen=True)
class Return:
    """A motion of a problem from q (2 n,) at t until t + period.

    end : (2 n,); rows : (rows, 2 n) along the motion, at times (rows,)
    basis : the tangent space of the constraints at q; S : (2 n, k) derivatives of the end in its directions, at fixed
    time; dt : (k,) derivatives of the period, 0 if it is given
    flow, end_flow : dq/dt at both ends
    order, moments : numbers of the events within, in order, and when they happen after the start
    shift : derivatives by what `by` of the problem names
    drift : (2 n,) the largest change of each column of the derivatives, in units of the scales: 0 if nothing depends
        on the number
    """

    problem: Problem
    q: Vector
    period: float
    end: Vector
    rows: Vector
    scale: Vector
    basis: Tangent
    S: Vector
    dt: Vector
    flow: Vector
    end_flow: Vector
    order: tuple[int, ...]
    moments: tuple[float, ...]
    drift: Vector
    gap: Vector
    times: Vector
    shift: Shift

    @property
    def residual(self) -> Vector:
        """(2 n,) the distance by which the motion does not close, in units of the scales."""
        return self.gap / self.scale


def run(problem: Problem, q: Vector, end: float, **more: Any) -> Solution:
    """Return a run from q until `end`.

    Raises
    ------
    NoReturnError
        It fails, or there are no more runs.
    """
    if problem.count.spent:
        raise NoReturnError(f"{problem.count.most} runs were not enough; begin nearer, or give max_runs")
    problem.count.runs += 1
    x0, v0 = problem.start(q)
    try:
        solution = simulate(
            problem.system, (problem.t, end), x0=x0, v0=v0, parameters=problem.parameters, inputs=problem.inputs,
            **dict(problem.options) | more,
        )  # fmt: skip
    except (ModelError, EvaluationError) as error:
        raise NoReturnError(str(error)) from error
    if solution.stop is StopReason.INTERRUPTED:
        raise KeyboardInterrupt
    if not solution.success:
        raise NoReturnError(solution.message)
    return solution


def firings(problem: Problem, solution: Solution, event: int, period: float) -> Vector:
    """Return the times at which an event happens after the start."""
    times = solution.t_events[event]
    return np.asarray(times[times - problem.t > _AT_ONCE * period])


def returned(problem: Problem, section: Section, q: Vector, period: float) -> Return:
    """Return the motion from q over about one period, with derivatives.

    Raises
    ------
    NoReturnError
        A run fails, has no derivatives, or does not reach the section.
    """
    if section.event is None:
        solution = run(problem, q, problem.t + period, sensitivities=problem.variables)
        return _measured(problem, solution, q, (problem.t + period, len(solution.t) - 1), None)
    return _until_event(problem, section, q, period)


def _until_event(problem: Problem, section: Section, q: Vector, period: float) -> Return:
    event, ahead = section.event, 1.02 * period
    assert event is not None
    for _ in range(12):
        solution = run(problem, q, problem.t + ahead, sensitivities=problem.variables)
        times = firings(problem, solution, event, period)
        if len(times) >= section.times:
            break
        if solution.stop is StopReason.TERMINAL_EVENT:
            raise NoReturnError(f"the run ends at a terminal event before {problem.c.events[event]!r} happens")
        ahead *= 2.0
    else:
        raise NoReturnError(f"event {problem.c.events[event]!r} does not happen within {ahead / 2:.3g} s of the start")
    at = float(times[section.times - 1])
    which = int(np.flatnonzero(solution.t_events[event] == at)[0])
    if problem.c.acting[event]:
        row = int(np.flatnonzero(solution.t == at)[-1])
        return _measured(problem, solution, q, (at, row), (event, which))
    steps = np.append(np.linspace(problem.t, at, 50)[:-1], at)
    rows = run(problem, q, problem.t + ahead, sensitivities=problem.variables, t_eval=steps)
    return _measured(problem, rows, q, (at, len(steps) - 1), (event, which))


def _measured(
    problem: Problem, solution: Solution, q: Vector, last: tuple[float, int], event: tuple[int, int] | None
) -> Return:
    (at, row), period = last, last[0] - problem.t
    with np.errstate(all="ignore"):
        rows = problem.rows(solution)[: row + 1]
        scale = problem.scales(rows, problem.t, period)
        start, end = problem.in_mode(solution, problem.t), problem.in_mode(solution, at)
        basis = tangent(problem.point(q, problem.t, start))
        every = _derivatives(problem, solution, row)
        dt = np.zeros(basis.Z.shape[1])
        if event is not None:
            dt = _later(solution, event, problem.names) @ basis.Z[problem.places]
        end_flow = problem.flow(rows[-1], at, end)
        flow = problem.flow(q, problem.t, start)
        moved = _shift(problem, solution, problem.point(q, problem.t, start), (every[-1], row), (flow, end_flow), event)
        made = Return(
            problem, q, period, rows[-1], rows, scale, basis, every[-1] @ basis.Z, dt, flow, end_flow,
            *_order(problem, solution, at), _drift(every, scale), rows[-1] - problem.symmetry(q),
            solution.t[: row + 1], moved,
        )  # fmt: skip
    if not all(np.isfinite(part).all() for part in (made.end, made.S, made.dt, made.end_flow)):
        raise NoReturnError("the run, or its derivatives, are not finite")
    return made


def _later(solution: Solution, event: tuple[int, int], names: tuple[str, ...]) -> Vector:
    """Return the derivatives of the time of an event."""
    return np.array([solution.sensitivity[name].dt_events[event[0]][event[1]] for name in names])


def _shift(problem: Problem, solution: Solution, at: OperatingPoint, last: tuple[Vector, int],
           flows: tuple[Vector, Vector], event: tuple[int, int] | None) -> Shift:  # fmt: skip
    """Return derivatives by what `by` names; `last` are the derivatives of the end and its row, flows dq/dt.

    A start that is later by dt is on the same motion if it is moved by the flow, too, and its end is that of the motion
    a time dt later.
    """
    (S, row), n, every, count = last, problem.c.n_coordinates, problem.c.n, len(problem.by)
    start, own, period = np.zeros((2 * every, count)), np.zeros((2 * every, count)), problem.period_slopes
    for k, name in enumerate(problem.by):
        start[:, k] = shift(at, problem.column(name))
        moved = start[:, k] - (flows[0] if name == TIME else 0.0)
        if event is not None:
            period[k] = _later(solution, event, problem.names) @ moved[problem.places] - (name == TIME)
        if name == TIME:
            own[:, k] = flows[1]
        else:
            one = solution.sensitivity[name]
            own[:n, k], own[every : every + n, k] = one.dx[:, row], one.dv[:, row]
            own[every + n :, k] = one.dz[:, row]
            period[k] += float(_later(solution, event, (name,))[0]) if event is not None else 0.0
        own[:, k] += S @ moved
    return Shift(start, own + np.outer(flows[1], period), period)


def _derivatives(problem: Problem, solution: Solution, row: int) -> Vector:
    """Return (rows, 2 n, 2 n) derivatives of q at rows up to one."""
    n, every = problem.c.n_coordinates, problem.c.n
    S = np.zeros((row + 1, 2 * every, 2 * every))
    for name, place in zip(problem.names, problem.places, strict=True):
        one = solution.sensitivity[name]
        S[:, :n, place] = one.dx[:, : row + 1].T
        S[:, every : every + n, place] = one.dv[:, : row + 1].T
        S[:, every + n :, place] = one.dz[:, : row + 1].T
    return S


def _drift(every: Vector, scale: Vector) -> Vector:
    changes = (every - np.eye(len(scale))) / scale[:, None] * scale
    return np.asarray(np.abs(changes).max(axis=(0, 1)))


def _order(problem: Problem, solution: Solution, at: float) -> tuple[tuple[int, ...], tuple[float, ...]]:
    """Return the numbers of the events within a period, in order, and when they happen; none at its ends."""
    margin = _AT_ONCE * (at - problem.t)
    times = [(float(t), k) for k, one in enumerate(solution.t_events or ()) for t in one]
    inner = [(t - problem.t, k) for t, k in sorted(times) if problem.t + margin < t < at - margin]
    return tuple(k for _, k in inner), tuple(t for t, _ in inner)
