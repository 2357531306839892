"""Error messages of a compiled model, with the model's names."""

from typing import Any

from .stop_reasons import StopReason, explain


def refusal(model: Any, stop: StopReason, first: int, second: int, size: float) -> str:
    """Return the message of a stop, as `explain`, with the names of a model; for a refused value, its symbol."""
    if stop is not StopReason.VALUE_REFUSED:
        return explain(stop, model.coordinates, first, second, size, model.events, model.row_names, tuple(model.tables))
    name = (model.parameters + model.coordinates + model.inputs)[first]
    return (
        f"'{name}' was declared {model.declared[first]}, and given {size:g}. Expressions were simplified by that: give "
        "it such a value, or declare it otherwise in the model."
    )
