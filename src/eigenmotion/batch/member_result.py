"""Results of a single member in the arrays of a chunk."""

import numpy as np

from ..arguments.members import Asked
from ..results.batch_arrays import REASONS, BatchArrays
from ..results.solution import Solution
from ..results.trajectory import Segment
from ..runtime import COUNTS, StopReason


def refuse(asked: Asked, k: int, words: str, found: BatchArrays) -> None:
    """Record why a member cannot start."""
    found.status[k], found.words[k] = REASONS.index(StopReason.START_REFUSED), words
    found.y[k], found.t_end[k] = np.nan, asked.t_start


def keep(asked: Asked, k: int, solution: Solution, found: BatchArrays) -> None:
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
