"""Constraint rows by name and by number, and the normal forces given by their multipliers."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy

from ..normalise import MULTIPLIER, ModelError, expression, sequence_of, shown

KINDS = ("holonomic_constraints", "nonholonomic_constraints")
Normal = str | int | tuple[str | int, ...] | None


@dataclass(frozen=True, slots=True)
class NamedRows:
    """Constraint rows with a name: `count` rows of a kind, from index `first` among the rows of that kind.

    rows : as they were stated: in a copy of the model, the name stays with these
    """

    name: str
    kind: str
    first: int
    count: int
    rows: tuple[sympy.Expr, ...] = field(default=(), compare=False, repr=False)

    def is_in(self, rows: Sequence[sympy.Expr]) -> bool:
        """Return whether its rows are at their places among the rows of a kind."""
        return not self.rows or tuple(rows[self.first : self.first + self.count]) == self.rows


def rows_of(constraints: Any, kind: str) -> tuple[tuple[sympy.Expr, ...], tuple[NamedRows, ...]]:
    """Return the rows of constraints, and the named rows of a mapping name -> one or several expressions.

    Raises
    ------
    ModelError
        A row is not an expression, or a name is not an identifier; shows it.
    """
    if not isinstance(constraints, Mapping):
        return tuple(expression(row, f"{kind}[{k}]") for k, row in enumerate(sequence_of(constraints, kind))), ()
    rows: list[sympy.Expr] = []
    names: list[NamedRows] = []
    for name, entry in constraints.items():
        if not isinstance(name, str) or not name.isidentifier():
            raise ModelError(
                f"{kind} has an entry named {shown(name)}. Name it as parameters are: a Python identifier."
            )
        several = isinstance(entry, list | tuple | sympy.MatrixBase)
        parts = sequence_of(entry, f"{kind}[{name}]") if several else (entry,)
        if not parts:
            raise ModelError(f"{kind}[{name}] has no row. Give one, or leave it out.")
        read = tuple(expression(row, f"{kind}[{name}][{k}]") for k, row in enumerate(parts))
        names.append(NamedRows(name, kind, len(rows), len(read), read))
        rows.extend(read)
    return tuple(rows), tuple(names)


def numbers_of(names: Iterable[NamedRows], h: int) -> dict[str, tuple[int, ...]]:
    """Return the row numbers of each name, counted like those of `multiplier`; the first h rows are holonomic."""
    starts = {one.name: one.first + (0 if one.kind == KINDS[0] else h) for one in names}
    return {one.name: tuple(range(starts[one.name], starts[one.name] + one.count)) for one in names}


def names_of_rows(names: Iterable[NamedRows], h: int, m: int) -> tuple[str, ...]:
    """Return a name for each of m rows, of which h are holonomic; "" for rows without a name, () if no row has one."""
    by_row = [""] * m
    for name, rows in numbers_of(names, h).items():
        for place, row in enumerate(rows):
            by_row[row] = f"{name}[{place}]" if len(rows) > 1 else name
    return tuple(by_row) if any(by_row) else ()


def check_names(names: Iterable[NamedRows], contacts: Iterable[str], counts: Mapping[str, int]) -> None:
    """Raise unless the names of constraints and contacts are unique, and the named rows exist."""
    taken = list(contacts)
    for one in names:
        if one.name in taken:
            raise ModelError(f"{one.kind} has an entry named {one.name!r}, a name that is taken. Rename one of them.")
        if one.first + one.count > counts[one.kind]:
            raise ModelError(f"constraint_names has {one.name!r} for rows that {one.kind} does not have. Leave it out.")
        taken.append(one.name)


def numbered(source: sympy.Expr, what: str, numbers: Mapping[str, tuple[int, ...]]) -> sympy.Expr:
    """Return an expression with multipliers of named constraints replaced by multipliers of numbered rows."""
    named = [one for one in source.atoms(MULTIPLIER) if len(one.args) == 2]
    return source.xreplace({one: MULTIPLIER(sympy.Integer(_row(one, what, numbers))) for one in named})


def _row(multiplier: sympy.Expr, what: str, numbers: Mapping[str, tuple[int, ...]]) -> int:
    name, place = str(multiplier.args[0]), int(multiplier.args[1])
    rows = numbers.get(name)
    if rows is None:
        raise ModelError(f"{what} contains the multiplier of {name!r}. No constraint or contact has that name.")
    if place < 0 and len(rows) > 1:
        raise ModelError(f"{what} contains the multiplier of {name!r}, which are {len(rows)} rows. Say which of them.")
    if place >= len(rows):
        raise ModelError(
            f"{what} contains the multiplier of {name!r}, row {place}. It has {len(rows)}, counted from 0."
        )
    return rows[max(place, 0)]


def normal_of(normal: Any) -> Normal:
    """Return the `normal` of a friction: a name, a row number, a tuple of these, or None.

    Raises
    ------
    ModelError
        It is none of these; shows it.
    """
    if normal is None or isinstance(normal, str) or (isinstance(normal, int) and not isinstance(normal, bool)):
        return normal
    parts = sequence_of(normal, "normal of a friction")
    if not parts or any(isinstance(part, bool) or not isinstance(part, str | int) for part in parts):
        raise ModelError(
            f"normal of a friction is {shown(normal)}. Give names of contacts or constraints, or rows' numbers."
        )
    return parts


def normal_force(rows: Iterable[int]) -> sympy.Expr:
    """Return the Euclidean norm of the multipliers of these rows."""
    return sympy.sqrt(sympy.Add(*(MULTIPLIER(sympy.Integer(row)) ** 2 for row in rows)))


class Normals:
    """The rows whose multipliers can be normal forces: those of contacts and constraints, not those of frictions."""

    def __init__(self, contacts: Iterable[str], constraints: Mapping[str, int], names: Iterable[NamedRows]) -> None:
        first, several = constraints[KINDS[0]], constraints[KINDS[1]]
        self.contacts = {name: first + k for k, name in enumerate(contacts)}
        h = first + len(self.contacts)
        self.rows = range(h + several)
        self.known = numbers_of(names, h)
        self.by_name = self.known | {name: (row,) for name, row in self.contacts.items()}

    def of(self, name: str, normal: Normal) -> tuple[str | None, tuple[int, ...]]:
        """Return the contact whose multiplier is the normal force of a friction, or else the rows whose norm it is.

        Raises
        ------
        ModelError
            There is no contact or constraint of that name or number, or a row occurs twice.
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
        """Return the normal force of a friction, 1 where it has none; that of a contact is minus its multiplier."""
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
