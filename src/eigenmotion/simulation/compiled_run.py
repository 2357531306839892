"""Execution of a run: one compiled call, or an incremental run with controllers."""

from contextlib import suppress

from ..arguments.methods import Method
from ..arguments.tasks import Task
from ..results.solution import DenseOutput, Solution
from ..runtime import Run, StopReason
from .sampled_inputs import ControlledRun


def run_compiled(task: Task, method: Method) -> Solution:
    """Run a checked task.

    Raises
    ------
    BaseException
        The exception of a controller; its attribute `solution` is the motion so far.
    """
    if not task.inputs.sampled:
        return solution_of(task, method, Run(task, method.number))
    controlled = ControlledRun(task, method.number)
    try:
        controlled.go()
    except BaseException as error:
        controlled.run.close(StopReason.INTERRUPTED)
        with suppress(AttributeError):  # some exceptions accept no attributes
            error.solution = solution_of(controlled.recorded_task, method, controlled.run)  # type: ignore[attr-defined]
        raise
    controlled.run.close()
    return solution_of(controlled.recorded_task, method, controlled.run)


def solution_of(task: Task, method: Method, run: Run) -> Solution:
    """Return the solution of a finished run."""
    fields = run.fields(method.name)
    if run.n_dense:
        fields["sol"] = DenseOutput(run.step_times, run.interpolate)
    return Solution((task, run.segments), fields)
