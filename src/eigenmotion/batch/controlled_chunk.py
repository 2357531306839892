"""Execution of a chunk of members with controllers."""

import logging

import numpy as np

from ..arguments.methods import METHODS
from ..arguments.named_values import Vector
from ..arguments.shared_state import Watch
from ..arguments.tasks import EnsembleTask, Members, Task
from ..codegen.model.normalise import ModelError
from ..results.batch_arrays import BatchArrays
from ..results.solution import Solution
from ..runtime import EvaluationError, IncrementalRun
from ..runtime.ensemble import Stop
from ..simulation.compiled_run import solution_of
from .controlled_runs import ControlledRuns, pace
from .member_result import keep, refuse
from .member_start import task_of

_log = logging.getLogger("eigenmotion")


def run_controlled(common: EnsembleTask, members: Members, stop: Stop, workers: int = 1) -> BatchArrays:
    """Run members with controllers and return their results. `stop` ends the runs early.

    Raises
    ------
    ModelError
        A controller changes data that the runs share.
    """
    results, watch = BatchArrays.unrun(common, members.count), Watch(members.controllers)
    for tasks in _by_pace(common, members, results):
        assert common.method is not None
        runs = ControlledRuns(tasks, common.method)
        _advance(runs, watch, stop, workers)
        for k, task, run in runs.results():
            _store(common, k, task, run, results)
        for k, (t, error) in runs.failed.items():
            results.messages[k] = _message(members.first + k, t, error)
    watch.check()
    return results


def _by_pace(common: EnsembleTask, members: Members, results: BatchArrays) -> list[dict[int, Task]]:
    """Return the tasks of the members that can start, grouped by the sample times of their controllers."""
    groups: dict[object, dict[int, Task]] = {}
    for k in range(members.count):
        try:
            task = task_of(common, members, k)
        except (ModelError, EvaluationError) as error:
            refuse(common, k, str(error), results)
            continue
        groups.setdefault(pace(task), {})[k] = _with_rows(common, task)
    return list(groups.values())


def _with_rows(common: EnsembleTask, task: Task) -> Task:
    """Return the task, with a row at its end only if that is enough (event actions need every step)."""
    return task._replace(t_eval=np.array([common.t_end])) if common.end_only and not common.model.acts else task


def _advance(runs: ControlledRuns, watch: Watch, stop: Stop, workers: int) -> None:
    """Advance the runs to their end; Ctrl-C interrupts them."""
    try:
        for k, _ in enumerate(runs.advance(workers, stop)):
            if k == 0:
                watch.check()
    except KeyboardInterrupt:
        stop.set()


def _store(common: EnsembleTask, k: int, task: Task, run: IncrementalRun, results: BatchArrays) -> None:
    """Copy the results of member k into the arrays of the chunk."""
    solution = solution_of(task, METHODS[common.name], run)
    keep(common, k, solution, results)
    results.recorded_inputs[k], results.t_end[k] = task.inputs, run.reached
    if common.end_only and solution.success and not len(solution.t):
        results.y[k, 0] = _at_its_end(solution, run.reached)


def _at_its_end(solution: Solution, t: float) -> Vector:
    """Return y at the terminal event that ended a run at t."""
    pairs = zip(solution.t_events, solution.y_events, strict=True)
    return np.asarray(next(y[-1] for times, y in pairs if len(times) and times[-1] == t))


def _message(member: int, t: float, error: Exception) -> str:
    """Return the message of a member whose controller failed."""
    reason = str(error) if isinstance(error, ModelError) else f"a controller raised {type(error).__name__}: {error}"
    message = f"At t = {t:.9g}: member {member}: {reason}"
    _log.info("%s", message, exc_info=error)
    return message
