"""Registry of table data: each array is stored once, at an address that is valid as long as the process.

A parameter set refers to a table by a number: 0 for the model's own table, otherwise the address of an array in the
layout of em_table.h. Such numbers are copied freely (into the rows of an ensemble, for example), so nothing shows how
long one is in use. Therefore the arrays are never freed.
"""

from collections.abc import Iterable, Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

Vector = NDArray[np.float64]

_BY_CONTENT: dict[bytes, Vector] = {}
_BY_ADDRESS: dict[float, Vector] = {}


def table_address(numbers: ArrayLike) -> float:
    """Return the address of a stored array with these numbers."""
    own = np.array(numbers, dtype=np.float64)
    array = _BY_CONTENT.setdefault(own.tobytes(), own)
    address = float(array.ctypes.data)
    _BY_ADDRESS[address] = array
    return address


def is_table_address(address: float) -> bool:
    """Whether this is the address of a stored array."""
    return address in _BY_ADDRESS


def arguments_at(address: float) -> int:
    """Return the number of arguments of the table at an address."""
    return int(_BY_ADDRESS[address][0])


def packed(numbers: Iterable[float]) -> dict[float, Vector]:
    """Return address -> array for those numbers that are addresses: the data that another process needs."""
    return {number: _BY_ADDRESS[number] for number in set(numbers) if number in _BY_ADDRESS}


def unpacked(parameters: Vector, places: Sequence[int], arrays: Mapping[float, Vector]) -> Vector:
    """Return parameters (..., n_parameters) of another process with its addresses replaced by those of this process."""
    local = np.array(parameters, dtype=np.float64)
    for there, array in arrays.items():
        here = table_address(array)
        for place in places:
            column = local[..., place]
            column[np.asarray(parameters)[..., place] == there] = here
    return local
