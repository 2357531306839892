"""Execution of a chunk of members in the calling thread: in compiled code, or one by one in Python."""

from dataclasses import replace

import numpy as np

from ..arguments.members import Asked, Members
from ..arguments.methods import METHODS
from ..arguments.options import TO_DERIVE
from ..codegen.model.normalise import ModelError
from ..results.batch_arrays import REASONS, BatchArrays
from ..results.solution import Solution
from ..results.trajectory import Segment
from ..runtime import COUNTS, EvaluationError, StopReason
from ..runtime.ensemble import Chunk, Stop
from ..simulation.simulate import run_task
from .member_sensitivities import Shifts, in_one_run, together, vary, vary_members
from .member_start import task_of

_REFUSED, _INTERRUPTED = (REASONS.index(stop) for stop in (StopReason.START_REFUSED, StopReason.INTERRUPTED))
_OF_CHUNK = ("y", "t_end", "status", "first", "second", "size", "counts", "event_times", "events", "event_counts")


def run_chunk(asked: Asked, members: Members, stop: Stop) -> BatchArrays:
    """Run the members and return their results. `stop` ends the runs early."""
    model = asked.model
    if _one_by_one(asked):
        found = BatchArrays.none(asked, members.count)
        doubtful = list(range(members.count))
    else:
        chunk = Chunk(asked, members, stop)
        found = replace(BatchArrays.none(asked, members.count), **{name: getattr(chunk, name) for name in _OF_CHUNK})
        doubtful = np.flatnonzero(found.status == _REFUSED).tolist()
        if model.formulation == "eigenfactor" and model.close_eigenvalues == "extrapolate":
            doubtful = list(range(members.count))  # eigenvalues that coincide at the start are handled in Python
    shifts: Shifts = {}
    for k in doubtful:
        if not stop:
            _look_again(asked, members, k, found, stop, shifts)
    if asked.differentiated is not None:
        shifts = shifts if in_one_run(asked) else vary_members(asked, members, found, stop)
        found.dt_events = together(found, shifts, len(asked.differentiated.names))
    return found


def _one_by_one(asked: Asked) -> bool:
    """Return whether each member needs a run of `simulate`, because of contact modes or sensitivities."""
    return bool(asked.model.switches) or in_one_run(asked)


def _look_again(asked: Asked, members: Members, k: int, found: BatchArrays, stop: Stop, shifts: Shifts) -> None:
    """Start a member as `simulate` does, in words where it cannot; and run it unless that is done."""
    try:
        task = task_of(asked, members, k)
    except (ModelError, EvaluationError) as error:
        found.status[k], found.words[k] = _REFUSED, str(error)
        found.y[k], found.t_end[k] = np.nan, asked.t_start
        return
    if _one_by_one(asked) or found.status[k] == _REFUSED:
        task = task._replace(dense=TO_DERIVE if in_one_run(asked) else 0)
        solution = run_task(task, METHODS[asked.name])
        _keep(asked, k, solution, found)
        if task.dense:
            vary(asked, k, task, solution, found, shifts)
        if found.status[k] == _INTERRUPTED:
            stop.set()


def _keep(asked: Asked, k: int, solution: Solution, found: BatchArrays) -> None:
    """Copy the results of a single run into the arrays of the chunk."""
    found.status[k], found.words[k] = REASONS.index(solution.stop), solution.message
    rows = solution.y.T
    if asked.end_only:
        rows = rows[-1:] if solution.success else rows[:0]
    found.y[k, : len(rows)] = rows
    found.t_end[k] = _reached(asked, solution)
    if solution.modes:
        found.segments[k] = _segments(solution, end_only=asked.end_only)
    found.counts[k] = [solution[name] for name in COUNTS]
    if solution.t_events is None:
        return
    place = int(found.event_counts[:k].sum())
    found.event_counts[k] = [len(times) for times in solution.t_events]
    found.event_times = np.insert(found.event_times, place, np.concatenate(solution.t_events))
    found.events = np.insert(found.events, place, np.concatenate(solution.y_events), axis=0)


def _segments(solution: Solution, *, end_only: bool) -> tuple[Segment, ...]:
    """Return the segments of a run; if only the last row is kept, each begins at row 0."""
    rows = solution._rows
    if rows is None or not end_only:
        return () if rows is None else rows.segments
    return tuple((0, t, parameters) for _, t, parameters in rows.segments)


def _reached(asked: Asked, solution: Solution) -> float:
    """Return the time that a run reached, according to its rows."""
    if solution.stop is StopReason.FINISHED:
        return asked.t_end
    if solution.get("sol") is not None:
        return float(solution["sol"].ts[-1])
    times = [solution.t, *(solution.t_events or [])]
    sign = 1.0 if asked.t_end >= asked.t_start else -1.0
    return sign * max((sign * float(each[-1]) for each in times if len(each)), default=sign * asked.t_start)
