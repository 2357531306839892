"""Runs: in one go, or in parts where controllers are asked on the way."""

from contextlib import suppress

from ..arguments.methods import Method
from ..arguments.options import Task
from ..results.solution import DenseOutput, Solution
from ..runtime import Run, StopReason
from .sampled_inputs import DrivenRun


def run_compiled(task: Task, method: Method) -> Solution:
    """Run what has been checked.

    Raises
    ------
    BaseException
        What a controller raised, as it is; its `solution` is what was done up to there.
    """
    if not task.inputs.sampled:
        return solution_of(task, method, Run(task, method.number))
    driven = DrivenRun(task, method.number)
    try:
        driven.go()
    except BaseException as error:
        driven.run.close(StopReason.INTERRUPTED)
        with suppress(AttributeError):  # of exceptions that take none
            error.solution = solution_of(driven.as_held, method, driven.run)  # type: ignore[attr-defined]
        raise
    driven.run.close()
    return solution_of(driven.as_held, method, driven.run)


def solution_of(task: Task, method: Method, run: Run) -> Solution:
    """Return what came of a run."""
    fields = run.fields(method.name)
    if run.n_dense:
        fields["sol"] = DenseOutput(run.step_times, run.interpolate)
    return Solution((task, run.segments), fields)
