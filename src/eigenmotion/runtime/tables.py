"""Memory of the tables that runs are given: each array once, at an address that stays as long as the process.

A parameter set knows a table by a number: 0, that of the model itself, or else the address of an array as em_table.h
has it. Nothing says how long such a number is in use, as in the rows of an ensemble; so what is kept is never freed.
"""

from collections.abc import Iterable, Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

Vector = NDArray[np.float64]

_BY_CONTENT: dict[bytes, Vector] = {}
_BY_ADDRESS: dict[float, Vector] = {}


def kept(numbers: ArrayLike) -> float:
    """Return the address of an array with these numbers, which stays."""
    own = np.array(numbers, dtype=np.float64)
    array = _BY_CONTENT.setdefault(own.tobytes(), own)
    address = float(array.ctypes.data)
    _BY_ADDRESS[address] = array
    return address


def is_kept(address: float) -> bool:
    """Whether this is the address of an array that stays."""
    return address in _BY_ADDRESS


def arguments_at(address: float) -> int:
    """Return how many arguments the table there has."""
    return int(_BY_ADDRESS[address][0])


def packed(numbers: Iterable[float]) -> dict[float, Vector]:
    """Return the arrays at those of these numbers that are addresses: what has to travel to another process."""
    return {one: _BY_ADDRESS[one] for one in set(numbers) if one in _BY_ADDRESS}


def unpacked(parameters: Vector, places: Sequence[int], arrays: Mapping[float, Vector]) -> Vector:
    """Return parameters (..., n_parameters) of another process with the addresses that the arrays have in this one."""
    made = np.array(parameters, dtype=np.float64)
    for there, array in arrays.items():
        here = kept(array)
        for place in places:
            column = made[..., place]
            column[np.asarray(parameters)[..., place] == there] = here
    return made
