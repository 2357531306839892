"""Execution of a run: one compiled call, or an incremental run with controllers."""

from collections.abc import Sequence
from contextlib import suppress
from typing import Any

import numpy as np

from ..arguments.methods import METHODS, Method
from ..arguments.tasks import Task
from ..results.solution import DenseOutput, Solution
from ..results.trajectory import Trajectory
from ..runtime import MAYBE_UNDEFINED, Run, StopReason
from .sampled_inputs import ControlledRun

_MOST_LISTED = 4


def run_compiled(task: Task, method: Method, other: Method | None = None) -> Solution:
    """Run a checked task; `other` is the method to which the run may change.

    Raises
    ------
    BaseException
        The exception of a controller; its attribute `solution` is the motion so far.
    """
    change = -1 if other is None else other.number
    if not task.inputs.sampled:
        return solution_of(task, method, Run(task, method.number, change))
    controlled = ControlledRun(task, method.number, change)
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
    if run.methods:
        add_changes(fields, task.t_start, method, run.methods)
    if run.unchanged is not None:
        why = str(run.unchanged).partition("\n")[0]
        fields["message"] += (
            f" method='auto' kept {fields['method']}, although radau9 would cost less, because its derivatives cannot "
            f"be compiled: {why}"
        )
    if run.n_dense:
        fields["sol"] = DenseOutput(run.step_times, run.interpolate)
    if run.last is not None and fields["stop"] in MAYBE_UNDEFINED:
        t, y = run.last
        last = Trajectory(task, np.array([t]), y[None], run.segments[-1:])
        fields["message"] += task.model.undefined(t, last.x[0], last.v[0], last.modes[-1][1], last.u[0])
    return Solution((task, run.segments), fields)


def add_changes(fields: dict[str, Any], start: float, first: Method, changes: list[tuple[float, int]]) -> None:
    """Add the changes of the method, (time, number) each, to the fields of a solution."""
    name_of = {method.number: method.name for method in METHODS.values()}
    methods = ((start, first.name), *((t, name_of[number]) for t, number in changes))
    fields["methods"], fields["method"] = methods, methods[-1][1]
    fields["message"] += f" method='auto' changed to {_listed(methods[1:])}, where it cost less."


def _listed(changes: Sequence[tuple[float, str]]) -> str:
    """Return the changes in words; of many only the first and the last."""
    words = [f"{name} at t = {t:.6g}" for t, name in changes]
    if len(words) > _MOST_LISTED:
        words[1:-1] = [f"{len(words) - 2} more"]
    return ", ".join(words)
