"""Messages about multipliers that are not unique, since constraint rows depend on each other."""

from collections.abc import Sequence

from ..arguments.tasks import Task
from ..runtime import CompiledModel


def in_words(model: CompiledModel, rows: Sequence[int]) -> str:
    """Return the labels of constraint rows as text."""
    return ", ".join(model.row_names[row] for row in rows)


def with_shared(message: str, model: CompiledModel, rows: Sequence[int]) -> str:
    """Return the message with a note about multipliers of these rows, which are not unique."""
    return (
        f"{message} The multipliers of constraints {in_words(model, rows)} are not unique, since these rows depend on "
        "each other: they are those of least norm. The motion is unique."
    )


def shared(task: Task, message: str) -> dict[str, object]:
    """Return the fields `not_unique` and `message` of a run from this start; {} if all multipliers are unique."""
    if not task.least_norm:
        return {}
    rows = task.model.redundant(task.t_start, task.y[: task.model.n], task.prepared)[1]
    return {"not_unique": rows, "message": with_shared(message, task.model, rows)} if rows else {}
