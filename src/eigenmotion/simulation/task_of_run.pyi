from typing import Any

from ..arguments.tasks import Task
from ..runtime import CompiledModel

def task_of_run(
    system: Any,
    model: CompiledModel,
    t_span: Any,
    x0: Any,
    v0: Any,
    argument: Any,
    parameters: Any,
    inputs: Any,
    rtol: Any,
    atol: Any,
    t_eval: Any,
    dense_output: Any,
    first_step: Any,
    max_step: Any,
    max_steps: Any,
    stabilisation: Any,
    dependent_constraints: Any,
) -> tuple[Task, tuple[int, ...]]: ...
