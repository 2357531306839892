"""A run that can be differentiated: its solution, and its derivative as an adjoint."""

from collections.abc import Sequence
from inspect import signature
from typing import Any, NamedTuple

from ..arguments.differentiation import differentiated
from ..arguments.methods import AUTO, METHODS, Method, method_of
from ..arguments.tasks import TO_DERIVE, Task
from ..codegen.model.normalise import ModelError, shown
from ..compiled.compiled_system import CompiledSystem
from ..results.multiplier_uniqueness import with_shared
from ..results.solution import Solution
from ..runtime import CompiledModel
from ..runtime.checkpoints import CheckpointedRun
from .compiled_run import solution_of
from .initial_state.consistency import check_direction
from .method_selection import automatic_of_run, longest_of
from .sensitivity.adjoint import Adjoint, steps_within
from .sensitivity.run_path import path_of
from .sensitivity.sensitivities import Directions, directions
from .simulate import NAMES, refused, run_changing, simulate
from .task_of_run import task_of_run

_NOT_HERE = ("system", "t_span", "positional", "misspelt", "estimate_error", "sensitivities", "method", "dense_output")
_DEFAULTS = {name: one.default for name, one in signature(simulate).parameters.items() if name not in _NOT_HERE}
_ORDER = tuple(name for name in signature(simulate).parameters if name in _DEFAULTS or name == "dense_output")


class DerivableRun(NamedTuple):
    """A run, and its derivative, which needs `steps` steps between two saved states.

    It is pickled as its task, and made again with the same bits.
    """

    task: Task
    solution: Solution
    adjoint: Adjoint
    steps: int

    def __reduce__(self) -> tuple[Any, ...]:
        shared = self.solution.get("not_unique", ())
        return _derived, (self.task, self.adjoint.method, self.adjoint.varied, self.steps, shared)


def derivable_run(
    call: str, system: CompiledSystem, t_span: tuple[float, float], by: Sequence[Any], memory: float,
    method: str = "dop853", **options: Any,
) -> DerivableRun:  # fmt: skip
    """Simulate with options of `simulate`, to be differentiated by names; memory: [MB] of the derivative.

    Raises
    ------
    ModelError
        As `simulate` with `sensitivities`; the run fails.
    """
    compiled = getattr(system, "compiled", None)
    misspelt = {name: value for name, value in options.items() if name not in _DEFAULTS}
    if misspelt or not isinstance(compiled, CompiledModel):
        raise refused(call, system, (), misspelt, (*_DEFAULTS, "method", "by", "memory"))
    given = _DEFAULTS | options | {"dense_output": False}
    if not (isinstance(memory, int | float) and memory >= 0.0):
        raise ModelError(f"{compiled.name}: memory is {shown(memory)}; give a number of megabytes, 0 or more")
    task, shared = task_of_run(system, compiled, t_span, *(given[name] for name in _ORDER))
    named = method_of(method, NAMES)
    chosen = longest_of(run_changing(task, automatic_of_run(task))) if named == AUTO else METHODS[named]
    if task.t_end < task.t_start:
        check_direction(compiled, task.t_start, task.t_end)
    varied = directions(differentiated(compiled, by, given["v0"], "by"), task)
    return _derived(task._replace(dense=TO_DERIVE), chosen, varied, steps_within(task, varied, memory), shared)


def _derived(task: Task, chosen: Method, varied: Directions, steps: int, shared: tuple[int, ...]) -> DerivableRun:
    """Run a checked task by a method; shared: the constraint rows whose multipliers are not unique."""
    run = CheckpointedRun(task, chosen.number, steps)
    solution = solution_of(task, chosen, run)
    if not solution.success:
        raise ModelError(f"{task.model.name}: the run has no gradient, because it failed. {solution.message}")
    solution["sol"] = None
    if shared:
        solution["not_unique"] = shared
        solution["message"] = with_shared(solution["message"], task.model, shared)
    path = path_of(task, solution, run)
    return DerivableRun(task, solution, Adjoint(task, chosen, varied, run, path, run.checkpoints), steps)
