"""Tables as arguments of a run, which replace the model's own: by name, among the parameters."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from ..codegen.model import Table
from ..codegen.model.normalise import ModelError, shown
from ..runtime import CompiledModel
from ..runtime.tables import table_address
from .named_values import is_named, spelled


def with_tables(c: CompiledModel, argument: Any, several: bool = False) -> Any:
    """Return parameters with tables replaced by the numbers that refer to them in compiled code.

    Parameters
    ----------
    several
        Whether a list contains one table for each member of an ensemble.

    Raises
    ------
    ModelError
        The value for a table is not a table, or has another number of arguments.
    """
    if not c.tables or not is_named(argument):
        return argument
    return {key: _numbers(c, spelled(key), value, several) if spelled(key) in c.tables else value
            for key, value in argument.items()}  # fmt: skip


def _numbers(c: CompiledModel, name: str, value: Any, several: bool) -> Any:
    if several and isinstance(value, list):
        return np.array([_number(c, name, one) for one in value])
    return value if isinstance(value, np.ndarray) else _number(c, name, value)


def _number(c: CompiledModel, name: str, value: Any) -> float:
    """Return the number of a table: 0 for the model's own. A number is returned as it is; `prepare` checks it."""
    if isinstance(value, float | int) and not isinstance(value, bool):
        return float(value)
    what = f"parameter {name!r} of {c.name}, a table,"
    try:
        table = value if isinstance(value, Table) else Table(value, outside=_outside(c, name), name=name)
    except ModelError as error:
        raise ModelError(f"{what} is given {shown(value)}: {error}") from error
    _, arguments = c.tables[name]
    if table.arguments != arguments:
        raise ModelError(f"{what} is a function of {arguments} argument(s), and is given one of {table.arguments}.")
    return address_of(table)


def _outside(c: CompiledModel, name: str) -> str:
    return c.outside_of(name)


_ADDRESSES: dict[str, float] = {}
"""The addresses of tables in use by their digests; the data at an address stays (runtime/tables.py)."""


def address_of(table: Table) -> float:
    """Return the address by which compiled code knows a table."""
    if table.digest not in _ADDRESSES:
        _ADDRESSES[table.digest] = table_address(table.pieces.numbers())
    return _ADDRESSES[table.digest]


def refuse_tables(c: CompiledModel, names: Mapping[str, object] | tuple[str, ...], what: str) -> None:
    """Raise ModelError if a name is that of a table, which cannot be varied as a number can."""
    for name in names:
        if name in c.prescribed:
            raise ModelError(
                f"{what} names {name!r}, an input that prescribes a motion, which is a curve and no number."
            )
        if name in c.tables:
            raise ModelError(f"{what} names {name!r}, which is a table and no number. Name numbers.")
