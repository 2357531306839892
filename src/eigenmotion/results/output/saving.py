"""Files of solutions: .npz contains all arrays, .csv the motion as a table."""

import io
from collections.abc import Callable
from pathlib import Path

import numpy as np

from ...compiled.compiled_system import CompiledSystem
from ...files import write
from ...presentation.tables import as_csv
from ..columns import columns, moving
from ..solution import Solution

_ARRAYS = (
    "t", "y", "x", "v", "eta", "C", "s", "multipliers", "energy", "jacobi_integral",
    "constraint_residual", "position_residual", "factor_residual",
)  # fmt: skip


def save(system: CompiledSystem, solution: Solution, path: Path) -> None:
    """Write a solution in the format of the ending of `path`, atomically: no incomplete file remains."""
    write(path, SAVERS[path.suffix](system, solution))


def _npz(system: CompiledSystem, solution: Solution) -> bytes:
    buffer = io.BytesIO()
    arrays = {name: solution[name] for name in _ARRAYS}
    arrays |= {f"output_{name}": values for name, values in solution.outputs.items()}
    arrays |= {f"state_{name}": values for name, values in solution.states.items()}
    arrays |= {f"quasi_velocity_{name}": values for name, values in solution.quasi_velocities.items()}
    np.savez_compressed(buffer, coordinates=np.array(system.coordinates), **arrays)
    return buffer.getvalue()


def _csv(system: CompiledSystem, solution: Solution) -> bytes:
    """Columns: t, each coordinate, rate (marked '), multiplier, energy, output, state; full precision."""
    ours = ["t", *(f"lambda{k}" for k in range(system.m)), "energy"]
    motion = moving(ours, system.coordinates)
    others = [*(("output", name) for name in solution.outputs), *(("state", name) for name in solution.states)]
    named = columns({*ours, *motion, *system.coordinates}, others)
    numbers = np.vstack([solution.t, solution.x, solution.v, solution.multipliers, solution.energy,
                         *solution.outputs.values(), *solution.states.values()])  # fmt: skip
    return as_csv(["t", *motion, *ours[1:], *named], numbers.T.tolist()).encode()


SAVERS: dict[str, Callable[[CompiledSystem, Solution], bytes]] = {".npz": _npz, ".csv": _csv}
