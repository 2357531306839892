"""The run of one member."""

from ..arguments.members import Asked, Members
from ..arguments.options import Task
from ..codegen.model.normalise import ModelError
from ..simulation.initial_state.consistency import start_state


def task_of(asked: Asked, members: Members, k: int) -> Task:
    """Return the run of member k.

    Raises
    ------
    ModelError
        The member cannot start.
    """
    if k in members.reasons:
        raise ModelError(f"{asked.model.name}: {members.reasons[k]}")
    prepared = asked.model.prepare(members.row("parameters", k))
    start = members.row("x", k), members.row("v", k)
    y = start_state(asked.model, prepared, asked.t_start, *start, asked.rtol, asked.atol)
    return asked.task(prepared, members.inputs_of(k), y)
