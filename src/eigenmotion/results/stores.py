"""Sweeps as files: parts while they run, each there in full or not at all, and of all parts one store at the end.

The parts lie in a folder beside the store. What a store holds follows from its parts alone, byte by byte: zarr, netCDF
(both through xarray), .npz, or .csv with a line a run and time.
"""

import io
import json
import shutil
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..codegen.model.normalise import ModelError
from ..files import write
from ..pages.tables import as_csv
from .ensemble import Ensemble

Arrays = dict[str, NDArray[Any]]
_ALONG = {"x": ("run", "coordinate", "time"), "v": ("run", "coordinate", "time"), "multipliers": ("run", "row", "time"),
          "energy": ("run", "time")}  # fmt: skip
_SWEPT, _OUTPUT = "swept ", "output "


def arrays_of(runs: Ensemble, swept: Arrays) -> Arrays:
    """Return what is kept of runs, the first axis theirs; `swept`: name -> (K,)."""
    kept = {"x": runs.x, "v": runs.v, "energy": runs.energy, "multipliers": runs.multipliers, "t_end": runs.t_end,
            "success": runs.success, "stop": np.array([str(reason) for reason in runs.stop], dtype="U32"),
            "nfev": runs.nfev}  # fmt: skip
    kept |= {_OUTPUT + name: values for name, values in runs.outputs.items()}
    kept |= {_SWEPT + name: values for name, values in swept.items()}
    return {name: np.ascontiguousarray(values) for name, values in kept.items()}


@dataclass(frozen=True)
class Parts:
    """The parts of a sweep of a store.

    order : what the sweep is, as JSON has it; time (nt,), coordinates (n,) : what all runs share
    """

    store: Path
    order: dict[str, Any]
    count: int
    time: NDArray[np.float64]
    coordinates: tuple[str, ...]

    @property
    def folder(self) -> Path:
        """Where they lie."""
        return self.store.with_name(f".{self.store.name}.parts")

    def begin(self, *, resume: bool) -> None:
        """Make the folder, or go on in the one that is there.

        Raises
        ------
        ModelError
            There are parts and nobody said to go on, or they are of another sweep.
        """
        said = json.dumps(self.order, indent=1, sort_keys=True) + "\n"
        order = self.folder / "sweep.json"
        if order.is_file() and not resume:
            raise ModelError(
                f"{self.store}: a sweep into it was not finished. --resume goes on with it; remove {self.folder} to "
                "begin anew"
            )
        if order.is_file() and order.read_text(encoding="utf-8") != said:
            raise ModelError(f"{self.store}: what was begun there is another sweep; {order} says which")
        write(order, said.encode())

    def give_up(self) -> None:
        """Leave nothing behind of a sweep that kept no part."""
        if not any(self.has(number) for number in range(self.count)):
            shutil.rmtree(self.folder, ignore_errors=True)

    @property
    def is_done(self) -> bool:
        """Whether the store is there, of this sweep as far as it says which it is of."""
        if self.folder.is_dir() or not self.store.exists():
            return False
        try:
            return bool(_ORDERS[self.store.suffix](self.store) == self._order)
        except (OSError, ValueError, KeyError):
            return False

    @property
    def _order(self) -> str:
        return json.dumps(self.order, sort_keys=True)

    def has(self, number: int) -> bool:
        """Whether a part is there."""
        return self._path(number).is_file()

    def keep(self, number: int, arrays: Arrays) -> None:
        """Write a part."""
        write(self._path(number), _npz(arrays))

    def arrays(self) -> Iterator[Arrays]:
        """Read all parts, in order."""
        for number in range(self.count):
            with np.load(self._path(number)) as part:
                yield dict(part)

    def finish(self) -> None:
        """Make the store of the parts, which go."""
        temporary = self.folder / f"store{self.store.suffix}"
        if temporary.is_dir():
            shutil.rmtree(temporary)
        STORES[self.store.suffix](self, temporary)
        if self.store.is_dir() and self.store.suffix == ".zarr":
            shutil.rmtree(self.store)
        temporary.replace(self.store)
        shutil.rmtree(self.folder)

    def _path(self, number: int) -> Path:
        return self.folder / f"{number:06}.npz"


def require(store: Path) -> None:
    """Raise ModelError where a kind of store needs a package that is missing."""
    needs = {".zarr": ("xarray", "zarr"), ".nc": ("xarray",)}.get(store.suffix, ())
    if missing := [name for name in needs if find_spec(name) is None]:
        raise ModelError(f"{store}: needs {' and '.join(missing)}: pip install 'eigenmotion[xarray]'")


def _npz(arrays: Arrays) -> bytes:
    buffer = io.BytesIO()
    np.savez(buffer, allow_pickle=False, **arrays)
    return buffer.getvalue()


def _joined(parts: Parts) -> Arrays:
    every = list(parts.arrays())
    return {name: np.concatenate([part[name] for part in every]) for name in every[0]}


def _save_npz(parts: Parts, path: Path) -> None:
    shared = {"time": parts.time, "coordinates": np.array(parts.coordinates), "sweep": np.array(parts._order)}
    path.write_bytes(_npz({**shared, **{name.replace(" ", "_"): array for name, array in _joined(parts).items()}}))


def _dataset(parts: Parts, arrays: Arrays, first: int) -> Any:
    """Return an `xarray.Dataset` of some runs, counted from `first`."""
    import xarray  # noqa: PLC0415, an optional package

    names = {name.removeprefix(_SWEPT).removeprefix(_OUTPUT) for name in arrays}
    plain = {*_ALONG, "time", "coordinate", "run", "row", "t_end", "success", "stop", "nfev"}

    def free(name: str, kind: str) -> str:
        bare = name.removeprefix(kind)
        return f"{kind.strip()}_{bare}" if bare in plain or len(names) < len(arrays) else bare

    data = {name: (_ALONG.get(name, ("run",)), array) for name, array in arrays.items() if " " not in name}
    data |= {
        free(name, _OUTPUT): (("run", "time"), array) for name, array in arrays.items() if name.startswith(_OUTPUT)
    }
    places = {free(name, _SWEPT): ("run", array) for name, array in arrays.items() if name.startswith(_SWEPT)}
    runs = np.arange(first, first + len(arrays["t_end"]))
    if not arrays["multipliers"].shape[1]:
        del data["multipliers"]
    shared = {"run": runs, "time": parts.time, "coordinate": np.array(parts.coordinates)}
    return xarray.Dataset(data, shared | places, {"sweep": parts._order})


def _save_netcdf(parts: Parts, path: Path) -> None:
    _dataset(parts, _joined(parts), 0).to_netcdf(path, engine="scipy")


def _save_zarr(parts: Parts, path: Path) -> None:
    """Append part by part: no more than one is in memory."""
    first = 0
    for arrays in parts.arrays():
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", message=".*does not have a Zarr V3 specification.*")
            warnings.filterwarnings("ignore", message=".*Consolidated metadata.*")
            some = _dataset(parts, arrays, first)
            some.to_zarr(path, consolidated=False, **({"append_dim": "run"} if first else {"mode": "w"}))
        first += len(arrays["t_end"])


def _save_csv(parts: Parts, path: Path) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        first = 0
        for arrays in parts.arrays():
            head, rows = _lines(parts, arrays, first)
            text = as_csv(head, rows)
            file.write(text if not first else text.partition("\n")[2])
            first += len(arrays["t_end"])


def _lines(parts: Parts, arrays: Arrays, first: int) -> tuple[list[str], Iterator[list[Any]]]:
    """Return names of columns, and a line for each run and time."""
    swept = {name.removeprefix(_SWEPT): array for name, array in arrays.items() if name.startswith(_SWEPT)}
    outputs = {name.removeprefix(_OUTPUT): array for name, array in arrays.items() if name.startswith(_OUTPUT)}
    reactions = [f"lambda{k}" for k in range(arrays["multipliers"].shape[1])]
    head = ["run", *swept, "t", *parts.coordinates, *(f"{name}'" for name in parts.coordinates), *reactions, "energy",
            *outputs, "t_end", "stop"]  # fmt: skip

    def rows() -> Iterator[list[Any]]:
        for k in range(len(arrays["t_end"])):
            for j, t in enumerate(parts.time.tolist()):
                motion = [arrays[name][k, :, j].tolist() for name in ("x", "v", "multipliers")]
                yield [first + k, *(column[k].item() for column in swept.values()), t, *motion[0], *motion[1],
                       *motion[2], arrays["energy"][k, j].item(), *(column[k, j].item() for column in outputs.values()),
                       arrays["t_end"][k].item(), str(arrays["stop"][k])]  # fmt: skip

    return head, rows()


def _order_of_npz(store: Path) -> str:
    with np.load(store) as arrays:
        return str(arrays["sweep"])


def _order_of_netcdf(store: Path) -> str:
    import xarray  # noqa: PLC0415, an optional package

    with xarray.open_dataset(store, engine="scipy") as found:
        return str(found.attrs["sweep"])


def _order_of_zarr(store: Path) -> str:
    return str(json.loads((store / "zarr.json").read_text(encoding="utf-8"))["attributes"]["sweep"])


_ORDERS: dict[str, Callable[[Path], str]] = {
    ".zarr": _order_of_zarr, ".nc": _order_of_netcdf, ".npz": _order_of_npz, ".csv": lambda _store: "",
}  # fmt: skip
STORES: dict[str, Callable[[Parts, Path], None]] = {
    ".zarr": _save_zarr, ".nc": _save_netcdf, ".npz": _save_npz, ".csv": _save_csv,
}  # fmt: skip
