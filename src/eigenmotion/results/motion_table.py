"""Table of a motion: a column for each quantity, by name, for files and for other tools."""

import io
from collections.abc import Callable, Mapping
from importlib import import_module
from importlib.util import find_spec
from os import PathLike
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from ..arguments.named_values import Vector
from ..codegen.model.normalise import ModelError
from ..files import write
from ..presentation.units import time_unit, unit_of
from .columns import columns, moving, reactions
from .trajectory import Trajectory

_ARRAYS = (
    "t", "y", "x", "v", "eta", "C", "s", "multipliers", "energy", "jacobi_integral",
    "constraint_residual", "position_residual", "factor_residual",
)  # fmt: skip
Result = TypeVar("Result")


def table(rows: Trajectory) -> dict[str, Vector]:
    """Return column -> (k,): t, coordinates, rates (marked '), multipliers, energy, outputs, states."""
    return {name: values for name, (values, _) in _columns(rows).items()}


def units_of_columns(rows: Trajectory) -> dict[str, str]:
    """Return column -> unit, for those that have one."""
    return {name: unit for name, (_, unit) in _columns(rows).items() if unit} if rows.model.units else {}


def _columns(rows: Trajectory) -> dict[str, tuple[Vector, str]]:
    """Return column -> its values (k,) and its unit, "" if there is none."""
    model, units, n = rows.model, rows.model.units or {}, rows.n
    built_in, coordinates = ["t", *reactions(model), "energy"], model.coordinates[:n]
    motion = moving(built_in, coordinates)
    others = [*(("output", name) for name in rows.outputs), *(("state", name) for name in rows.states)]
    named = columns({*built_in, *motion, *coordinates}, others)
    quantities = [
        (rows.t, time_unit(units)),
        *((x, unit_of(units, name)) for name, x in zip(coordinates, rows.x.T[:n], strict=True)),
        *((v, unit_of(units, name, 1)) for name, v in zip(coordinates, rows.v.T[:n], strict=True)),
        *((multiplier, "") for multiplier in rows.multipliers.T),
        (rows.energies.sum(axis=1), units.get("energy", "")),
        *((values, unit_of(units, name)) for name, values in (*rows.outputs.items(), *rows.states.items())),
    ]
    return dict(zip(["t", *motion, *built_in[1:], *named], quantities, strict=True))


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


def save(result: Result, path: str | PathLike[str], savers: Mapping[str, Callable[[Result], bytes]]) -> None:
    """Write a result in the format of the ending of `path`, atomically: no incomplete file remains.

    Raises
    ------
    ModelError
        Another ending, or the file cannot be written.
    """
    target = Path(path)
    if target.suffix not in savers:
        raise ModelError(f"{target}: known endings are {', '.join(savers)}")
    _put(target, savers[target.suffix](result))


def text_or_file(text: str, path: str | PathLike[str] | None) -> str | None:
    """Write a table to a file; return its text if there is no path.

    Raises
    ------
    ModelError
        The file cannot be written.
    """
    if path is None:
        return text
    _put(Path(path), text.encode())
    return None


def _put(path: Path, content: bytes) -> None:
    try:
        write(path, content)
    except OSError as error:
        raise ModelError(f"{path}: it cannot be written there ({error.strerror})") from error


def _npz(solution: Any) -> bytes:
    buffer = io.BytesIO()
    arrays = {name: solution[name] for name in _ARRAYS}
    arrays |= {f"output_{name}": values for name, values in solution.outputs.items()}
    arrays |= {f"state_{name}": values for name, values in solution.states.items()}
    arrays |= {f"quasi_velocity_{name}": values for name, values in solution.quasi_velocities.items()}
    np.savez_compressed(buffer, coordinates=np.array(_coordinates(solution)), **arrays)
    return buffer.getvalue()


def _coordinates(solution: Any) -> tuple[str, ...]:
    """Return the names of the coordinates; raises ModelError where these are not known."""
    return tuple(solution.table())[1 : 1 + len(solution.x)]


def _csv(solution: Any) -> bytes:
    """Return the columns of `Solution.table`, in full precision."""
    return str(solution.to_csv()).encode()


SAVERS: dict[str, Callable[[Any], bytes]] = {".npz": _npz, ".csv": _csv}
