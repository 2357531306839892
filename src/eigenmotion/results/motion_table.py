"""Table of a motion: a column for each quantity, by name, for files and for other tools."""

from collections.abc import Mapping
from importlib import import_module
from importlib.util import find_spec
from typing import Any

from ..arguments.named_values import Vector
from ..codegen.model.normalise import ModelError
from ..presentation.units import time_unit, unit_of
from .columns import columns, moving, reactions
from .trajectory import Trajectory


def table(rows: Trajectory) -> dict[str, Vector]:
    """Return column -> (k,): t, coordinates, rates (marked '), multipliers, energy, outputs, states."""
    model, n = rows.model, rows.n
    ours = ["t", *reactions(model), "energy"]
    coordinates = model.coordinates[:n]
    motion = moving(ours, coordinates)
    others = [*(("output", name) for name in rows.outputs), *(("state", name) for name in rows.states)]
    named = columns({*ours, *motion, *coordinates}, others)
    values = [
        rows.t,
        *rows.x.T[:n],
        *rows.v.T[:n],
        *rows.multipliers.T,
        rows.energies.sum(axis=1),
        *rows.outputs.values(),
        *rows.states.values(),
    ]
    return dict(zip(["t", *motion, *ours[1:], *named], values, strict=True))


def units_of_columns(rows: Trajectory) -> dict[str, str]:
    """Return column -> unit, for those that have one."""
    units, names, n = rows.model.units, list(table(rows)), rows.n
    if not units:
        return {}
    coordinates, m = rows.model.coordinates[:n], rows.model.m
    words = [
        time_unit(units),
        *(unit_of(units, name) for name in coordinates),
        *(unit_of(units, name, 1) for name in coordinates),
        *("" for _ in range(m)),
        units.get("energy", ""),
        *(unit_of(units, name) for name in (*rows.outputs, *rows.states)),
    ]
    return {name: unit for name, unit in zip(names, words, strict=True) if unit}


def data_frame(columns: Mapping[str, Vector], attributes: Mapping[str, Any]) -> Any:
    """Return a `pandas.DataFrame` over t.

    Raises
    ------
    ModelError
        pandas is not installed.
    """
    _require("pandas", "to_pandas", "pandas")
    pd: Any = import_module("pandas")  # optional, and without types
    index = pd.Index(columns["t"], name="t")
    frame = pd.DataFrame({name: values for name, values in columns.items() if name != "t"}, index=index)
    frame.attrs.update(attributes)
    return frame


def data_set(columns: Mapping[str, Vector], attributes: Mapping[str, Any]) -> Any:
    """Return an `xarray.Dataset` with the dimension t.

    Raises
    ------
    ModelError
        xarray is not installed.
    """
    _require("xarray", "to_xarray", "eigenmotion[xarray]")
    import xarray  # noqa: PLC0415, an optional package

    units = attributes.get("units", {})
    words = {name: {"units": units[name]} if name in units else {} for name in columns}
    variables = {name: ("t", values, words[name]) for name, values in columns.items() if name != "t"}
    others = {name: value for name, value in attributes.items() if name != "units"}
    return xarray.Dataset(variables, {"t": ("t", columns["t"], words["t"])}, others)


def _require(package: str, call: str, installs: str) -> None:
    if find_spec(package) is None:
        raise ModelError(f"{call} needs {package}: pip install '{installs}'")
