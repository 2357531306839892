"""An ensemble as xarray takes it."""

from typing import TYPE_CHECKING, Any

import numpy as np

from .columns import columns

if TYPE_CHECKING:
    from .ensemble import Ensemble


def dataset(runs: "Ensemble") -> tuple[dict[str, Any], dict[str, Any]]:
    """Return data variables and coordinates, each (dimensions, values)."""
    along = ("run", "coordinate", "time")
    data: dict[str, Any] = {
        "x": (along, runs.x), "v": (along, runs.v), "energy": (("run", "time"), runs.energy),
        "t_end": ("run", runs.t_end), "success": ("run", runs.success), "nfev": ("run", runs.nfev),
        "stop": ("run", np.array([str(reason) for reason in runs.stop], dtype=np.str_)),
    }  # fmt: skip
    model = runs._model
    if model.m:
        data["multipliers"] = (("run", "row", "time"), runs.multipliers)
    places: dict[str, Any] = {"time": runs.t, "coordinate": np.array(model.coordinates), "run": np.arange(len(runs))}
    users = [*(("output", name) for name in runs.outputs), *(("swept", name) for name in runs.swept)]
    names = iter(columns({*data, *places, "row"}, users))
    data |= {name: (("run", "time"), values) for values, name in zip(runs.outputs.values(), names, strict=False)}
    places |= {name: ("run", values) for values, name in zip(runs.swept.values(), names, strict=True)}
    return data, places
