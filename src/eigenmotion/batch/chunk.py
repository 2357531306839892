"""Execution of a chunk of members in the calling thread: in compiled code, or one by one in Python."""

from dataclasses import replace

import numpy as np

from ..arguments.methods import METHODS
from ..arguments.tasks import TO_DERIVE, EnsembleTask, Members
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


def run_chunk(common: EnsembleTask, members: Members, stop: Stop, workers: int = 1) -> BatchArrays:
    """Run the members and return their results.

    stop : ends the runs early
    workers : threads for runs with controllers
    """
    model = common.model
    if members.controllers:
        return run_controlled(common, members, stop, workers)
    if _runs_in_python(common):
        results = BatchArrays.unrun(common, members.count)
        to_check = list(range(members.count))
    else:
        chunk = Chunk(common, members, stop)
        computed = {name: getattr(chunk, name) for name in _OF_CHUNK}
        results = replace(BatchArrays.unrun(common, members.count), **computed)
        to_check = np.flatnonzero(results.status == _REFUSED).tolist()
        if model.formulation == "eigenfactor" and model.close_eigenvalues == "extrapolate":
            to_check = list(range(members.count))  # eigenvalues that coincide at the start are handled in Python
    shifts: Shifts = {}
    for k in to_check:
        if not stop:
            _run_in_python(common, members, k, results, stop, shifts)
    if common.differentiated is not None:
        shifts = shifts if in_one_run(common) else vary_members(common, members, results, stop)
        results.dt_events = together(results, shifts, len(common.differentiated.names))
    return results


def _runs_in_python(common: EnsembleTask) -> bool:
    """Return whether members run one by one as in `simulate`, because of contact modes or sensitivities."""
    return bool(common.model.switches) or in_one_run(common)


def _run_in_python(
    common: EnsembleTask, members: Members, k: int, results: BatchArrays, stop: Stop, shifts: Shifts
) -> None:
    """Check the start of a member as `simulate` does; run the member if compiled code has not."""
    try:
        task = task_of(common, members, k)
    except (ModelError, EvaluationError) as error:
        refuse(common, k, str(error), results)
        return
    if _runs_in_python(common) or results.status[k] == _REFUSED:
        task = task._replace(dense=TO_DERIVE if in_one_run(common) else 0)
        solution = run_task(task, METHODS[common.name])
        keep(common, k, solution, results)
        if task.dense:
            vary(common, k, task, solution, results, shifts)
        if results.status[k] == _INTERRUPTED:
            stop.set()
