"""Derivatives of the members of a chunk, one after the other, each along a run that keeps what is between its rows."""

import numpy as np

from ..arguments.differentiated import Differentiated
from ..arguments.members import Asked, Members
from ..codegen.model.normalise import ModelError
from ..results.found import REASONS, Found
from ..running.methods import METHODS
from ..running.sensitivities import directions, sensitivity
from ..running.simulate import run_task
from ..runtime import EvaluationError, StopReason, explain
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
            task = task_of(asked, members, k)._replace(dense=True)
            solution = run_task(task, METHODS[asked.name])
            rows = list(sensitivity(task, solution, directions(by, task), METHODS[asked.name]).values())
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
