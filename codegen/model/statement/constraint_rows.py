"""Constraint rows by name and by number, and the normal forces that their multipliers are."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import sympy

from ..normalise import MULTIPLIER, ModelError, expression, sequence_of, shown

KINDS = ("holonomic_constraints", "nonholonomic_constraints")
Normal = str | int | tuple[str | int, ...] | None


@dataclass(frozen=True, slots=True)
class NamedRows:
    """Constraint rows that have a name: `count` of a kind, from `first` on among those of that kind."""

    name: str
    kind: str
    first: int
    count: int


def rows_of(given: Any, kind: str) -> tuple[tuple[sympy.Expr, ...], tuple[NamedRows, ...]]:
    """Return the rows of constraints, and their names where they are given by a mapping name -> one or several.

    Raises
    ------
    ModelError
        One is not an expression, or its name is no text; shows it.
    """
    if not isinstance(given, Mapping):
        return tuple(expression(row, f"{kind}[{k}]") for k, row in enumerate(sequence_of(given, kind))), ()
    rows: list[sympy.Expr] = []
    names: list[NamedRows] = []
    for name, entry in given.items():
        if not isinstance(name, str) or not name.isidentifier():
            raise ModelError(
                f"{kind} has an entry named {shown(name)}. Name it as parameters are: a Python identifier."
            )
        several = isinstance(entry, list | tuple | sympy.MatrixBase)
        parts = sequence_of(entry, f"{kind}[{name}]") if several else (entry,)
        if not parts:
            raise ModelError(f"{kind}[{name}] has no row. Give one, or leave it out.")
        names.append(NamedRows(name, kind, len(rows), len(parts)))
        rows.extend(expression(row, f"{kind}[{name}][{k}]") for k, row in enumerate(parts))
    return tuple(rows), tuple(names)


def numbers_of(names: Iterable[NamedRows], h: int) -> dict[str, tuple[int, ...]]:
    """Return by name the rows as `multiplier` counts them, h of them being holonomic."""
    starts = {one.name: one.first + (0 if one.kind == KINDS[0] else h) for one in names}
    return {one.name: tuple(range(starts[one.name], starts[one.name] + one.count)) for one in names}


def names_of_rows(names: Iterable[NamedRows], h: int, m: int) -> tuple[str, ...]:
    """Return a name for each of m rows, h of them holonomic; "" for those without, () where none has one."""
    found = [""] * m
    for name, rows in numbers_of(names, h).items():
        for place, row in enumerate(rows):
            found[row] = f"{name}[{place}]" if len(rows) > 1 else name
    return tuple(found) if any(found) else ()


def check_names(names: Iterable[NamedRows], contacts: Iterable[str], counts: Mapping[str, int]) -> None:
    """Raise unless constraints have each a name of its own, which no contact has, and the rows are there."""
    taken = list(contacts)
    for one in names:
        if one.name in taken:
            raise ModelError(f"{one.kind} has an entry named {one.name!r}, a name that is taken. Rename one of them.")
        if one.first + one.count > counts[one.kind]:
            raise ModelError(f"constraint_names has {one.name!r} for rows that {one.kind} does not have. Leave it out.")
        taken.append(one.name)


def numbered(given: sympy.Expr, what: str, numbers: Mapping[str, tuple[int, ...]]) -> sympy.Expr:
    """Return an expression with the multipliers that it names by the names of constraints counted as rows."""
    named = [one for one in given.atoms(MULTIPLIER) if len(one.args) == 2]
    return given.xreplace({one: MULTIPLIER(sympy.Integer(_row(one, what, numbers))) for one in named})


def _row(multiplier: sympy.Expr, what: str, numbers: Mapping[str, tuple[int, ...]]) -> int:
    name, place = str(multiplier.args[0]), int(multiplier.args[1])
    rows = numbers.get(name)
    if rows is None:
        raise ModelError(f"{what} contains the multiplier of {name!r}. No constraint has that name.")
    if place < 0 and len(rows) > 1:
        raise ModelError(f"{what} contains the multiplier of {name!r}, which are {len(rows)} rows. Say which of them.")
    if place >= len(rows):
        raise ModelError(
            f"{what} contains the multiplier of {name!r}, row {place}. It has {len(rows)}, counted from 0."
        )
    return rows[max(place, 0)]


def normal_of(given: Any) -> Normal:
    """Return what presses on a friction as a name, a number or a tuple of such.

    Raises
    ------
    ModelError
        It is nothing of that kind; shows it.
    """
    if given is None or isinstance(given, str) or (isinstance(given, int) and not isinstance(given, bool)):
        return given
    parts = sequence_of(given, "normal of a friction")
    if not parts or any(isinstance(part, bool) or not isinstance(part, str | int) for part in parts):
        raise ModelError(
            f"normal of a friction is {shown(given)}. Give names of contacts or constraints, or rows' numbers."
        )
    return parts


def normal_force(rows: Iterable[int]) -> sympy.Expr:
    """Return the root of the sum of squares of these rows' multipliers."""
    return sympy.sqrt(sympy.Add(*(MULTIPLIER(sympy.Integer(row)) ** 2 for row in rows)))


class Normals:
    """Which rows press: those of contacts and of constraints. Rows of frictions do not."""

    def __init__(self, contacts: Iterable[str], constraints: Mapping[str, int], names: Iterable[NamedRows]) -> None:
        first, several = constraints[KINDS[0]], constraints[KINDS[1]]
        self.contacts = {name: first + k for k, name in enumerate(contacts)}
        h = first + len(self.contacts)
        self.rows = range(h + several)
        self.known = numbers_of(names, h)

    def of(self, name: str, normal: Normal) -> tuple[str | None, tuple[int, ...]]:
        """Return the contact whose multiplier presses on a friction, and else the rows of which the norm does.

        Raises
        ------
        ModelError
            There is nothing of that name or number; says what is asked for.
        """
        if normal is None:
            return None, ()
        if isinstance(normal, str) and normal in self.contacts:
            return normal, ()
        parts = normal if isinstance(normal, tuple) else (normal,)
        rows = sorted(row for part in parts for row in self._rows(name, part))
        if len(set(rows)) < len(rows):
            raise ModelError(f"normal of contacts[{name}] has row {max(rows, key=rows.count)} twice. Keep one.")
        return None, tuple(rows)

    def force(self, name: str, normal: Normal) -> sympy.Expr:
        """Return the normal force of a friction, 1 where it has none: a contact presses with minus its multiplier."""
        over, rows = self.of(name, normal)
        if over is not None:
            return -MULTIPLIER(sympy.Integer(self.contacts[over]))
        return normal_force(rows) if rows else sympy.Integer(1)

    def _rows(self, name: str, part: str | int) -> tuple[int, ...]:
        if isinstance(part, str) and part in self.contacts:
            return (self.contacts[part],)
        if isinstance(part, str) and part in self.known:
            return self.known[part]
        if isinstance(part, int) and part in self.rows:
            return (part,)
        raise ModelError(
            f"normal of contacts[{name}] is {shown(part)}. Name a Contact or a constraint, or give the number of a "
            "row, which `multiplier` counts; those of frictions do not press."
        )
