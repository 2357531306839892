"""An ensemble as xarray takes it."""

from typing import TYPE_CHECKING, Any

import numpy as np

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
    if model.outputs:
        data |= {
            _free(name, "output", data, places): (("run", "time"), values) for name, values in runs.outputs.items()
        }
    places |= {_free(name, "swept", data, places): ("run", values) for name, values in runs.swept.items()}
    return data, places


def _free(name: str, kind: str, *taken: dict[str, Any]) -> str:
    """Return a name that is not taken: of the user's names some may be those of dimensions."""
    return f"{kind}_{name}" if any(name in names for names in (*taken, {"row": 0})) else name
