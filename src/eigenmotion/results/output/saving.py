"""Files of solutions: .npz contains all arrays, .csv the motion as a table."""

import io
from collections.abc import Callable
from pathlib import Path

import numpy as np

from ...files import write
from ..solution import Solution

_ARRAYS = (
    "t", "y", "x", "v", "eta", "C", "s", "multipliers", "energy", "jacobi_integral",
    "constraint_residual", "position_residual", "factor_residual",
)  # fmt: skip


def save(solution: Solution, path: Path) -> None:
    """Write a solution in the format of the ending of `path`, atomically: no incomplete file remains."""
    write(path, SAVERS[path.suffix](solution))


def _npz(solution: Solution) -> bytes:
    buffer = io.BytesIO()
    arrays = {name: solution[name] for name in _ARRAYS}
    arrays |= {f"output_{name}": values for name, values in solution.outputs.items()}
    arrays |= {f"state_{name}": values for name, values in solution.states.items()}
    arrays |= {f"quasi_velocity_{name}": values for name, values in solution.quasi_velocities.items()}
    np.savez_compressed(buffer, coordinates=np.array(_coordinates(solution)), **arrays)
    return buffer.getvalue()


def _coordinates(solution: Solution) -> tuple[str, ...]:
    """Return the names of the coordinates; raises ModelError where these are not known."""
    return tuple(solution.table())[1 : 1 + len(solution.x)]


def _csv(solution: Solution) -> bytes:
    """Return the columns of `Solution.table`, in full precision."""
    return str(solution.to_csv()).encode()


SAVERS: dict[str, Callable[[Solution], bytes]] = {".npz": _npz, ".csv": _csv}
