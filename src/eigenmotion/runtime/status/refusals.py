"""Error messages of a compiled model, with the model's names."""

from collections.abc import Sequence
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


def values_by_name(model: Any, t: float, x: Any, v: Any, parameters: Sequence[float], u: Any) -> dict[str, float]:
    """Return the numbers of a state by name, as messages have them: rates with a mark. None: v or u is not known.

    x, v : (n) coordinates, then states, whose values are in v; u : (n_inputs)
    """
    coordinates, states = model.coordinates[: model.n_coordinates], model.coordinates[model.n_coordinates :]
    values = {"t": t} | dict(zip(model.parameters, parameters, strict=True))
    values |= dict(zip(coordinates, x.tolist(), strict=False))
    if v is not None:
        values |= dict(zip([*(f"{name}'" for name in coordinates), *states], v.tolist(), strict=True))
    if u is not None:
        values |= dict(zip(model.inputs, u.tolist(), strict=True))
    return values
