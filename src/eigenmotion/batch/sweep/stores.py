"""Stores of sweeps: one file or folder with the results of all parts.

The kinds are zarr and netCDF (both through xarray), .npz, and .csv with a line for each run and time. The bytes of a
store depend only on the parts.
"""

import tempfile
import warnings
from collections.abc import Callable, Collection, Iterable, Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from ...codegen.model.normalise import ModelError
from ...presentation.tables import as_csv
from ...presentation.units import time_unit, unit_of, unit_of_marked, with_unit
from ...results.columns import columns, moving
from ...results.ensemble import Ensemble
from .order import differences
from .unfinished_store import Arrays, Parts, remove

_ALONG = {"x": ("run", "coordinate", "time"), "v": ("run", "coordinate", "time"), "multipliers": ("run", "row", "time"),
          "energy": ("run", "time")}  # fmt: skip
_WORDS = ("unit", "rate_unit")
_OURS = frozenset({*_ALONG, "time", "coordinate", "run", "row", "t_end", "success", "stop", "nfev", *_WORDS})
_DURATIONS = ("days", "hours", "minutes", "seconds", "milliseconds", "microseconds", "nanoseconds")
_SWEPT, _OUTPUT = "swept ", "output "


def arrays_of(runs: Ensemble, swept: Arrays) -> Arrays:
    """Return the arrays to store, with the runs as first axis; `swept`: name -> (K,)."""
    arrays = {"x": runs.x, "v": runs.v, "energy": runs.energy, "multipliers": runs.multipliers, "t_end": runs.t_end,
            "success": runs.success, "stop": np.array([str(reason) for reason in runs.stop], dtype="U32"),
            "nfev": runs.nfev}  # fmt: skip
    arrays |= {_OUTPUT + name: values for name, values in (runs.states | runs.outputs).items()}
    arrays |= {_SWEPT + name: values for name, values in swept.items()}
    return {name: np.ascontiguousarray(values) for name, values in arrays.items()}


def require(store: Path) -> None:
    """Raise ModelError where a kind of store needs a package that is missing."""
    needs = {".zarr": ("xarray", "zarr"), ".nc": ("xarray",)}.get(store.suffix, ())
    if missing := [name for name in needs if find_spec(name) is None]:
        raise ModelError(f"{store}: needs {' and '.join(missing)}: pip install 'eigenmotion[xarray]'")


def check_names(store: Path, swept: Collection[str], outputs: Collection[str]) -> None:
    """Check before the runs that a store can hold all names: one column for each is written and read back.

    Raises
    ------
    ModelError
        The store cannot hold a name; the error gives it.
    """
    if store.suffix not in _DATASETS:
        return
    keys = [*(_OUTPUT + name for name in outputs), *(_SWEPT + name for name in swept)]
    for key, column in _named(keys, _OURS).items():
        if not _holds(store.suffix, column):
            raise ModelError(
                f"{store}: {store.suffix} files hold no column of the name {column!r} ({key.partition(' ')[0]}). "
                "Rename it, or store .csv or .npz, which hold any"
            )


def _holds(suffix: str, column: str) -> bool:
    import xarray  # noqa: PLC0415, an optional package

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"rehearsal{suffix}"
        try:
            _write(xarray.Dataset({column: ("run", np.ones(1))}, {"run": np.zeros(1)}), path)
            with _opened(path) as dataset:
                return column in dataset.data_vars
        except Exception:  # any exception of xarray, zarr, SciPy or the file system about a name
            return False


def finish(parts: Parts) -> None:
    """Write the store from the parts, and delete the parts."""
    finished = parts.folder / f"store{parts.store.suffix}"
    remove(finished)
    remove(parts.folder / "before")
    STORES[parts.store.suffix](parts, finished)
    parts.move_into_place(finished)


def is_done(parts: Parts, computed: Callable[[], Iterable[Arrays]]) -> bool:
    """Return whether the store of this sweep is in place. `computed` makes its parts anew, for .csv, which names none.

    Raises
    ------
    ModelError
        There is a file, but no store of this sweep, and none has begun to take its place; says what differs.
    """
    if parts.is_stored:
        return True
    if parts.is_begun or not parts.store.exists():
        return False
    if difference := _csv_difference(parts, computed()) if parts.store.suffix == ".csv" else store_difference(parts):
        raise ModelError(
            f"{parts.store} {difference}. It was left as it is: name another file with -o, or leave --resume out, and "
            "this sweep replaces it"
        )
    return True


def store_difference(parts: Parts) -> str:
    """Return in which way a store that exists is not of this sweep, as words after its name; "" if it is."""
    try:
        order = _ORDERS[parts.store.suffix](parts.store)
    except Exception:  # NumPy, SciPy, zarr and zipfile raise all kinds of exceptions for damaged and for strange files
        return "is no store of a sweep, or damaged"
    return f"holds another sweep: {differences(order, parts.order)}" if order != parts.order_text else ""


def _csv_difference(parts: Parts, every: Iterable[Arrays]) -> str:
    with parts.store.open("rb") as file:
        same = all(file.read(len(text)) == text for text in _texts(parts, every)) and not file.read(1)
    return "" if same else "holds other lines than this sweep"


def _joined(parts: Parts) -> Arrays:
    every = list(parts.arrays())
    return {name: np.concatenate([part[name] for part in every]) for name in every[0]}


def _save_npz(parts: Parts, path: Path) -> None:
    shared = {"time": parts.time, "coordinates": np.array(parts.coordinates), "sweep": np.array(parts.order_text)}
    # only the first space is of our prefix; others are in the user's names
    with path.open("wb") as file:
        np.savez(
            file,
            allow_pickle=False,
            **shared,
            **{name.replace(" ", "_", 1): array for name, array in _joined(parts).items()},
        )


def _named(keys: Collection[str], ours: Collection[str]) -> dict[str, str]:
    """Return key -> column for those keys that contain a user's name."""
    theirs = [key for key in keys if key.startswith((_SWEPT, _OUTPUT))]
    parted = [key.partition(" ") for key in theirs]
    return dict(zip(theirs, columns(ours, [(kind, name) for kind, _, name in parted]), strict=True))


def _dataset(parts: Parts, arrays: Arrays, first: int) -> Any:
    """Return an `xarray.Dataset` of some runs, counted from `first`."""
    import xarray  # noqa: PLC0415, an optional package

    named = _named(arrays, _OURS)
    units = parts.units
    of_ours = {"energy": unit_of(units, "energy"), "t_end": time_unit(units)}
    data = {
        name: (_ALONG.get(name, ("run",)), array, _attribute(of_ours.get(name, "")))
        for name, array in arrays.items()
        if name not in named
    }
    data |= {
        column: (("run", "time"), arrays[key], _attribute(unit_of(units, _users(key))))
        for key, column in named.items()
        if key.startswith(_OUTPUT)
    }
    places: dict[str, Any] = {
        column: ("run", arrays[key], _attribute(unit_of_marked(units, _users(key))))
        for key, column in named.items()
        if key.startswith(_SWEPT)
    }
    if units:  # x and v mix them, as in Ensemble.to_xarray
        places |= {
            word: ("coordinate", np.array([unit_of(units, name, order) for name in parts.coordinates]))
            for order, word in enumerate(_WORDS)
        }
    runs = np.arange(first, first + len(arrays["t_end"]))
    if not arrays["multipliers"].shape[1]:
        del data["multipliers"]
    time = ("time", parts.time, _attribute(time_unit(units)))
    shared = {"run": runs, "time": time, "coordinate": np.array(parts.coordinates)}
    return xarray.Dataset(data, shared | places, {"sweep": parts.order_text})


def _attribute(unit: str) -> dict[str, str]:
    """Return the attributes of a variable with a unit. xarray would read numbers of "seconds" as durations."""
    return {"unit" if unit in _DURATIONS or " since " in unit else "units": unit} if unit else {}


def _users(key: str) -> str:
    return key.partition(" ")[2]


def _save_netcdf(parts: Parts, path: Path) -> None:
    _write(_dataset(parts, _joined(parts), 0), path)


def _save_zarr(parts: Parts, path: Path) -> None:
    """Append the parts one by one, so that only one is in memory at a time."""
    first = 0
    for arrays in parts.arrays():
        _write(_dataset(parts, arrays, first), path, **({"append_dim": "run"} if first else {"mode": "w"}))
        first += len(arrays["t_end"])


def _write(some: Any, path: Path, **how: Any) -> None:
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", message=".*has a space in its name")  # then it is a data variable
        if path.suffix == ".nc":
            some.to_netcdf(path, engine="scipy")
            return
        warnings.filterwarnings("ignore", message=".*does not have a Zarr V3 specification.*")
        warnings.filterwarnings("ignore", message=".*Consolidated metadata.*")
        some.to_zarr(path, consolidated=False, **how)


def _opened(path: Path) -> Any:
    import xarray  # noqa: PLC0415, an optional package

    return xarray.open_dataset(path, **_DATASETS[path.suffix])


def _save_csv(parts: Parts, path: Path) -> None:
    with path.open("wb") as file:
        file.writelines(_texts(parts, parts.arrays()))


def _texts(parts: Parts, every: Iterable[Arrays]) -> Iterator[bytes]:
    """Yield the text of each part; the first begins with the names of the columns."""
    first = 0
    for arrays in every:
        head, rows = _lines(parts, arrays, first)
        text = as_csv(head, rows)
        yield (text if not first else text[len(as_csv(head, ())) :]).encode()
        first += len(arrays["t_end"])


def _lines(parts: Parts, arrays: Arrays, first: int) -> tuple[list[str], Iterator[list[Any]]]:
    """Return the names of the columns, and the lines, one for each run and time."""
    ours = ["run", "t", *parts.reactions, "energy", "t_end", "stop"]
    motion = moving(ours, parts.coordinates)
    named = _named(arrays, {*ours, *motion, *parts.coordinates})
    swept, outputs = ({column: arrays[key] for key, column in named.items() if key.startswith(kind)}
                      for kind in (_SWEPT, _OUTPUT))  # fmt: skip
    units, rates = parts.units, [unit_of(parts.units, name, 1) for name in parts.coordinates]
    words = ["", *(unit_of_marked(units, _users(key)) for key in named if key.startswith(_SWEPT)), time_unit(units),
             *(unit_of(units, name) for name in parts.coordinates), *rates, *("" for _ in parts.reactions),
             unit_of(units, "energy"), *(unit_of(units, _users(key)) for key in named if key.startswith(_OUTPUT)),
             time_unit(units), ""]  # fmt: skip
    names = ["run", *swept, "t", *motion, *parts.reactions, "energy", *outputs, "t_end", "stop"]
    head = [with_unit(name, unit) for name, unit in zip(names, words, strict=True)]

    def rows() -> Iterator[list[Any]]:
        for k in range(len(arrays["t_end"])):
            for j, t in enumerate(parts.time.tolist()):
                moved = [arrays[name][k, :, j].tolist() for name in ("x", "v", "multipliers")]
                yield [first + k, *(column[k].item() for column in swept.values()), t, *moved[0], *moved[1],
                       *moved[2], arrays["energy"][k, j].item(), *(column[k, j].item() for column in outputs.values()),
                       arrays["t_end"][k].item(), str(arrays["stop"][k])]  # fmt: skip

    return head, rows()


def _order_of_npz(store: Path) -> str:
    with store.open("rb") as file, np.load(file) as arrays:
        return str(arrays["sweep"])


def _order_of_dataset(store: Path) -> str:
    with _opened(store) as dataset:
        return str(dataset.attrs["sweep"])


_DATASETS: dict[str, dict[str, Any]] = {
    ".nc": {"engine": "scipy"}, ".zarr": {"engine": "zarr", "consolidated": False},
}  # fmt: skip
_ORDERS: dict[str, Callable[[Path], str]] = {
    ".zarr": _order_of_dataset, ".nc": _order_of_dataset, ".npz": _order_of_npz,
}  # fmt: skip
STORES: dict[str, Callable[[Parts, Path], None]] = {
    ".zarr": _save_zarr, ".nc": _save_netcdf, ".npz": _save_npz, ".csv": _save_csv,
}  # fmt: skip
JOINED = (".npz", ".nc")
"""Kinds of stores that need all runs in memory at the end."""
