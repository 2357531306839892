"""Results of a single member in the arrays of a chunk."""

import numpy as np

from ..arguments.tasks import EnsembleTask
from ..results.batch_arrays import REASONS, BatchArrays
from ..results.solution import Solution
from ..results.trajectory import Segment
from ..runtime import COUNTS, StopReason


def refuse(common: EnsembleTask, k: int, message: str, results: BatchArrays) -> None:
    """Record why a member cannot start."""
    results.status[k], results.messages[k] = REASONS.index(StopReason.START_REFUSED), message
    results.y[k], results.t_end[k] = np.nan, common.t_start


def keep(common: EnsembleTask, k: int, solution: Solution, results: BatchArrays) -> None:
    """Copy the results of a single run into the arrays of the chunk."""
    results.status[k], results.messages[k] = REASONS.index(solution.stop), solution.message
    rows = solution.y.T
    if common.end_only:
        rows = rows[-1:] if solution.success else rows[:0]
    results.y[k, : len(rows)] = rows
    results.t_end[k] = _reached(common, solution)
    if solution.modes:
        results.segments[k] = _segments(solution, end_only=common.end_only)
    results.counts[k] = [solution[name] for name in COUNTS]
    if solution.t_events is None:
        return
    place = int(results.event_counts[:k].sum())
    results.event_counts[k] = [len(times) for times in solution.t_events]
    results.event_times = np.insert(results.event_times, place, np.concatenate(solution.t_events))
    results.events = np.insert(results.events, place, np.concatenate(solution.y_events), axis=0)


def _segments(solution: Solution, *, end_only: bool) -> tuple[Segment, ...]:
    """Return the segments of a run; if only the last row is kept, each begins at row 0."""
    rows = solution._rows
    if rows is None or not end_only:
        return () if rows is None else rows.segments
    return tuple((0, t, parameters) for _, t, parameters in rows.segments)


def _reached(common: EnsembleTask, solution: Solution) -> float:
    """Return the time that a run reached, according to its rows."""
    if solution.stop is StopReason.FINISHED:
        return common.t_end
    if solution.get("sol") is not None:
        return float(solution["sol"].ts[-1])
    times = [solution.t, *(solution.t_events or [])]
    sign = 1.0 if common.t_end >= common.t_start else -1.0
    return sign * max((sign * float(each[-1]) for each in times if len(each)), default=sign * common.t_start)
