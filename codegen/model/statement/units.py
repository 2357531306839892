"""Units of a model's quantities: words for axes, tables and other tools, which nothing checks."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..normalise import ModelError, name_of, nearest, pairs_of, shown

OF_ALL = ("time", "length", "energy")
"""Names that have a unit in each model: the time, the axes of the drawing, energies and what has their unit."""
_NAMED = ("coordinates", "states", "quasi_velocities", "parameters", "inputs", "outputs")


def units_of(given: Any, fields: Mapping[str, Any]) -> tuple[tuple[str, str], ...]:
    """Return pairs name, unit from the argument `units` of a Model with these fields.

    Raises
    ------
    ModelError
        A name is that of nothing in the model, or occurs twice; or a unit is no word.
    """
    pairs = tuple((name_of(key), unit) for key, unit in pairs_of(given, "units"))
    known = {*OF_ALL, *_names(fields)}
    for k, (name, unit) in enumerate(pairs):
        if name not in known:
            hint = nearest(name, known)
            raise ModelError(
                f"units has an entry for {shown(name)}, which is no coordinate, state, parameter, input or output, and "
                f"none of {', '.join(OF_ALL)}.{hint} Units of rates follow from those of coordinates."
            )
        if name in [other for other, _ in pairs[:k]]:
            raise ModelError(f"units has two entries for {shown(name)}. Keep one.")
        if not isinstance(unit, str) or not unit.strip() or not unit.isprintable():
            raise ModelError(f"units[{name}] is {shown(unit)}, but must be a word such as 'mm'.")
    return pairs


def _names(fields: Mapping[str, Any]) -> list[str]:
    entries = [entry for kind in _NAMED for entry in fields[kind]]
    return [name_of(entry[0] if isinstance(entry, tuple) else entry) for entry in entries]
