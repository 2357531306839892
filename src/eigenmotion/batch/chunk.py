"""Execution of a chunk of members in the calling thread: in compiled code, or one by one in Python."""

from dataclasses import replace

import numpy as np

from ..arguments.members import Asked, Members
from ..arguments.methods import METHODS
from ..arguments.options import TO_DERIVE
from ..codegen.model.normalise import ModelError
from ..results.batch_arrays import REASONS, BatchArrays
from ..runtime import EvaluationError, StopReason
from ..runtime.ensemble import Chunk, Stop
from ..simulation.simulate import run_task
from .controlled_chunk import run_controlled
from .member_result import keep, refuse
from .member_sensitivities import Shifts, in_one_run, together, vary, vary_members
from .member_start import task_of

_REFUSED, _INTERRUPTED = (REASONS.index(stop) for stop in (StopReason.START_REFUSED, StopReason.INTERRUPTED))
_OF_CHUNK = ("y", "t_end", "status", "first", "second", "size", "counts", "event_times", "events", "event_counts")


def run_chunk(asked: Asked, members: Members, stop: Stop, workers: int = 1) -> BatchArrays:
    """Run the members and return their results. `stop` ends the runs early; `workers` share runs with controllers."""
    model = asked.model
    if members.controllers:
        return run_controlled(asked, members, stop, workers)
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
        refuse(asked, k, str(error), found)
        return
    if _one_by_one(asked) or found.status[k] == _REFUSED:
        task = task._replace(dense=TO_DERIVE if in_one_run(asked) else 0)
        solution = run_task(task, METHODS[asked.name])
        keep(asked, k, solution, found)
        if task.dense:
            vary(asked, k, task, solution, found, shifts)
        if found.status[k] == _INTERRUPTED:
            stop.set()
