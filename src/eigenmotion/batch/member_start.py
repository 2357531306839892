"""Task of one member of an ensemble."""

from ..arguments.tasks import EnsembleTask, Members, Task
from ..codegen.model.normalise import ModelError
from ..simulation.initial_state.consistency import start_state


def task_of(common: EnsembleTask, members: Members, k: int) -> Task:
    """Return the task of member k.

    Raises
    ------
    ModelError
        The member cannot start.
    """
    if k in members.reasons:
        raise ModelError(f"{common.model.name}: {members.reasons[k]}")
    prepared = common.model.prepare(members.row("parameters", k))
    start = members.row("x", k), members.row("v", k)
    y = start_state(common.model, prepared, common.t_start, *start, common.rtol, common.atol)
    return common.task(prepared, members.inputs_of(k), y)
