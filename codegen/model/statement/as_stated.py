"""Fields of a model that also keep what the user stated: a copy of the model with other fields starts from that.

A model adds rows, forces, parameters and events of its contacts to the fields, and replaces names of multipliers by the
numbers of rows. `dataclasses.replace` hands these fields to the new model, whose contacts and rows may be others.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy

from ..normalise import ModelError, name_of
from .contacts import Contact, Friction, parameters_of


class AsStated(tuple[Any, ...]):
    """The entries of a field of a model; `stated` are those that the user gave."""

    stated: Any

    def __new__(cls, entries: tuple[Any, ...], stated: Any) -> AsStated:
        made = super().__new__(cls, entries)
        made.stated = stated
        return made

    def __reduce__(self) -> tuple[type[AsStated], tuple[tuple[Any, ...], Any]]:
        return AsStated, (tuple(self), self.stated)


def as_stated(arguments: Mapping[str, Any]) -> dict[str, Any]:
    """Return the arguments of a model, where those that are fields of another model are what was stated for it."""
    return {name: value.stated if isinstance(value, AsStated) else value for name, value in arguments.items()}


def keeping(fields: Mapping[str, Any], stated: Mapping[str, Any]) -> dict[str, Any]:
    """Return the fields of a model, which keep what was stated where the model changed it."""
    changed: dict[str, Any] = {
        name: old for name, old in stated.items() if isinstance(old, tuple) and fields[name] != old
    }
    changed["constraint_names"] = stated["constraint_names"]  # equal, and with the rows that were stated
    for name, missing in ("forces", 0), ("scales", 1):  # by coordinate: those of a copy may be others
        values = zip(stated["coordinates"], stated[name], strict=True)
        changed[name] = {x: value for x, value in values if value != missing}
    return dict(fields) | {name: AsStated(fields[name], old) for name, old in changed.items()}


def without_contacts(fields: Mapping[str, Any]) -> dict[str, Any]:
    """Return fields without what contacts of these names added to them in another model, as a list of its rows has it.

    Raises
    ------
    ModelError
        A force has the parameter of a friction in another way than the friction's own force; names both.
    """
    made = dict(fields)
    for name, entry in fields["contacts"]:
        holds, slides, *_ = added = parameters_of(name, entry)
        made["parameters"] = tuple(pair for pair in made["parameters"] if pair[0] not in added)
        kind = "holonomic_constraints" if isinstance(entry, Contact) else "nonholonomic_constraints"
        made[kind] = tuple(row for row in made[kind] if holds not in row.free_symbols)
        made["events"] = tuple(pair for pair in made["events"] if not _is_of(pair, name, entry))
        for x, force in zip(made["coordinates"], made["forces"], strict=True):
            if slides in force.free_symbols:
                raise ModelError(
                    f"forces[{name_of(x)}] has the force of contacts[{name}], which the model adds by itself. "
                    "State the forces without it."
                )
    return made


def _is_of(pair: tuple[Any, Any], name: str, entry: Contact | Friction) -> bool:
    """Return whether an event is that of a contact or friction: of its own gap, or with the sign of its slip."""
    if pair[0] != name:
        return False
    expression: sympy.Expr = pair[1].expression
    if isinstance(entry, Contact):
        return pair[1].impact is not None and bool(expression == entry.gap)
    return parameters_of(name, entry)[1] in expression.free_symbols
