"""Derivatives of the members of a chunk, one after the other, along what their runs found."""

import numpy as np

from ..arguments.differentiated import Differentiated
from ..arguments.members import Asked, Members
from ..arguments.names import Vector
from ..arguments.options import Task
from ..codegen.model.normalise import ModelError
from ..results.found import REASONS, Found
from ..results.solution import Solution
from ..running.methods import METHODS
from ..running.sensitivities import directions, sensitivity
from ..running.simulate import run_task
from ..runtime import COUNTS, EvaluationError, StopReason, explain, record
from ..runtime.ensemble import Stop
from .start import task_of


def vary_members(asked: Asked, by: Differentiated, members: Members, found: Found, stop: Stop) -> None:
    """Fill `S` and `dt_events`; where a run that did well has none, say why in `words`."""
    shifts = np.full((len(found.event_times), len(by.names)), np.nan)
    ends = np.cumsum(found.event_counts.sum(axis=1))
    for k in range(members.count):
        if stop or REASONS[found.status[k]] is StopReason.START_REFUSED:
            continue
        try:
            task = task_of(asked, members, k)
            solution = _solution(asked, task, found, k, int(ends[k]))
            rows = list(sensitivity(task, solution, directions(by, task)).values())
        except (ModelError, EvaluationError) as error:
            words = found.words.get(k, explain(REASONS[found.status[k]], asked.model.coordinates))
            found.words[k] = f"{words} It has no sensitivities: {error}"
            continue
        if rows:
            S = np.array([np.vstack([one.dx, one.dv]).T for one in rows]).transpose(1, 2, 0)
            S = S[-1:] if asked.end_only else S
            found.S[k, : len(S)] = S
            own = [np.concatenate([*(one.dt_events or ()), np.empty(0)]) for one in rows]
            shifts[ends[k] - len(own[0]) : ends[k]] = np.array(own).T
    found.dt_events = shifts


def _solution(asked: Asked, task: Task, found: Found, k: int, end: int) -> Solution:
    """Return the run of member k; again, where events act: ensembles do not keep what they make of a state."""
    if asked.model.acts:
        return run_task(task, METHODS[asked.name])
    there = ~np.isnan(found.y[k]).any(axis=1)
    t = np.array([found.t_end[k]]) if asked.end_only else asked.t_eval
    counts = found.event_counts[k].tolist()
    first = end - sum(counts)
    pieces = [slice(first + sum(counts[:i]), first + sum(counts[: i + 1])) for i in range(len(counts))]
    events: list[list[Vector]] = [[table[piece] for piece in pieces] for table in (found.event_times, found.events)]
    rows = np.ascontiguousarray(found.y[k][there])
    t_events, y_events = events if counts else (None, None)
    stop = REASONS[found.status[k]]
    fields = record(t[there], rows.T, t_events, y_events, stop, "", asked.name, (None,) * len(COUNTS))
    return Solution(None, fields)
