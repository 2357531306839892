"""Inputs that prescribe a motion: those in constraints, as tables of the time.

A constraint takes in the first two derivatives of a prescribed motion, and an input that a run holds or steps has none.
So an input in a constraint, a gap or the surface of an impact is a table of the time from the start: its default is a
constant, and a run gives it the pieces of a signal.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import sympy

from .check.assumptions import ANY, allowed, declared
from .normalise import ModelError, name_of, t
from .statement.contacts import expressions_of
from .statement.substitution import substituted
from .table import Table

HIGHEST_RATE = 2
"""Of a prescribed motion that other fields may contain: the acceleration."""


class PrescribedInput(Table):
    """An input in a constraint as a table of the time, by the name of the input."""

    __slots__ = ()

    def __init__(self, u: sympy.Expr, default: float) -> None:
        super().__init__(((0.0, 1.0), (default, default)), outside="hold", name=name_of(u))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, PrescribedInput) and super().__eq__(other)

    def __hash__(self) -> int:
        return hash((super().__hash__(), "input"))

    def __reduce__(self) -> tuple[Callable[..., Table], tuple[Any, ...]]:
        return _restored, (self.name, self.pieces.coefficients[0])


def _restored(name: str, default: float) -> Table:
    return PrescribedInput(sympy.Function(name)(t), default)


def with_prescribed_inputs(fields: dict[str, Any]) -> dict[str, Any]:
    """Return the fields of a model in which each input in a constraint is a table, and no longer an input.

    Raises
    ------
    ModelError
        Such an input was declared under an assumption: nothing keeps a signal to it. Names both.
    """
    inputs = {u: value for u, value in fields["inputs"] if isinstance(u, sympy.Basic)}  # others are refused later
    standing = {u for row in _rows(fields) for u in row.atoms(sympy.Function)}
    found = {u: PrescribedInput(u, value) for u, value in inputs.items() if u in standing}
    if not found:
        return fields
    for u in found:
        if allowed(u) != ANY:
            raise ModelError(
                f"inputs contains {name_of(u)!r}, declared {declared(allowed(u))}, which prescribes a motion in a "
                "constraint. A signal may take any value: declare it without."
            )
    rates = {u.diff(t, order): table(t).diff(t, order) for u, table in found.items()
             for order in range(1, HIGHEST_RATE + 1)}  # fmt: skip
    kept = tuple((u, value) for u, value in fields["inputs"] if u not in found)
    values = {u: table(t) for u, table in found.items()}
    return {name: substituted(substituted(field, rates), values) for name, field in fields.items()} | {"inputs": kept}


def _rows(fields: dict[str, Any]) -> Iterator[sympy.Expr]:
    """Yield constraint rows, gaps of contacts and the surfaces of impacts."""
    yield from fields["holonomic_constraints"]
    yield from fields["nonholonomic_constraints"]
    for name, entry in fields["contacts"]:
        yield from (part for _, part, free in expressions_of(name, entry) if not free)
    yield from (event.impact[0] for _, event in fields["events"] if event.impact)
