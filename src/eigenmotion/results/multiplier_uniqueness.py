"""Constraint rows that depend on each other: what a result says of their multipliers."""

from collections.abc import Sequence

from ..arguments.options import Task
from ..runtime import CompiledModel


def in_words(model: CompiledModel, rows: Sequence[int]) -> str:
    """Name constraint rows whose multipliers are not unique; by number where they have no names."""
    return ", ".join(model.row_names[row] for row in rows)


def with_shared(message: str, model: CompiledModel, rows: Sequence[int]) -> str:
    """Add to a message what the multipliers of such rows are."""
    return (
        f"{message} The multipliers of constraints {in_words(model, rows)} are not unique, since these rows depend on "
        "each other: they are those of least norm. The motion is unique."
    )


def shared(task: Task, message: str) -> dict[str, object]:
    """Return what a run from this start says of its rows, message too: nothing where all multipliers are unique."""
    if not task.least_norm:
        return {}
    rows = task.model.redundant(task.t_start, task.y[: task.model.n], task.prepared)[1]
    return {"not_unique": rows, "message": with_shared(message, task.model, rows)} if rows else {}
