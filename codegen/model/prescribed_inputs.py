"""Inputs that prescribe a motion: those in constraints, as tables of the time.

A constraint takes in the first two derivatives of a prescribed motion, and an input that a run holds or steps has none.
So an input in a constraint, a gap, the slip of a friction or the surface of an impact is a table of the time from the
start: its default is a constant, and a run gives it the pieces of a signal.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any

import sympy

from .check.assumptions import ANY, allowed, declared
from .normalise import ModelError, name_of, t
from .recursion_depth import expressions_in
from .statement.contacts import Friction
from .statement.substitution import substituted
from .table import Table, TableCall


class PrescribedInput(Table):
    """An input in a constraint as a table of the time, by the name of the input: any name that an input may have."""

    __slots__ = ()

    def __init__(self, name: str, default: float) -> None:
        super().__init__(((0.0, 1.0), (default, default)), outside="hold")
        self.name = name

    def __eq__(self, other: object) -> bool:
        return isinstance(other, PrescribedInput) and super().__eq__(other)

    def __hash__(self) -> int:
        return hash((super().__hash__(), "input"))

    def __reduce__(self) -> tuple[Callable[..., Table], tuple[Any, ...]]:
        return PrescribedInput, (self.name, self.pieces.coefficients[0])


def with_prescribed_inputs(fields: dict[str, Any]) -> dict[str, Any]:
    """Return the fields of a model in which each input in a constraint is a table, and no longer an input.

    Raises
    ------
    ModelError
        Such an input was declared under an assumption: nothing keeps a signal to it. Names both.
    """
    inputs = {u: value for u, value in fields["inputs"] if isinstance(u, sympy.Basic)}  # others are refused later
    standing = {part for row in _rows(fields) for part in row.atoms(sympy.Function)}
    prescribed = {part.table.name for part in standing if _is_prescribed(part)}  # in a model that was copied
    found = {u: PrescribedInput(name_of(u), value) for u, value in inputs.items()
             if u in standing or name_of(u) in prescribed}  # fmt: skip
    if not found:
        return fields
    _check_assumptions(found)
    kept = tuple((u, value) for u, value in fields["inputs"] if u not in found)
    rates, values = _rates(fields, found), {u: table(t) for u, table in found.items()}
    return {name: substituted(substituted(field, rates), values) for name, field in fields.items()} | {"inputs": kept}


def _is_prescribed(part: sympy.Basic) -> bool:
    return isinstance(part, TableCall) and isinstance(part.table, PrescribedInput)


def _check_assumptions(found: Iterable[sympy.Expr]) -> None:
    for u in found:
        if allowed(u) != ANY:
            raise ModelError(
                f"inputs contains {name_of(u)!r}, declared {declared(allowed(u))}, which prescribes a motion in a "
                "constraint. A signal may take any value: declare it without."
            )


def _rates(fields: dict[str, Any], found: dict[sympy.Expr, PrescribedInput]) -> dict[sympy.Expr, sympy.Expr]:
    """Return the derivatives of inputs in the fields, and the calls of tables that these inputs were in another model.

    Each is mapped to the derivative of the table.
    """
    by_name = {table.name: table for table in found.values()}
    rates: dict[sympy.Expr, sympy.Expr] = {}
    for part in {part for one in expressions_in(fields) for part in one.atoms(sympy.Derivative, TableCall)}:
        if isinstance(part, TableCall):
            if _is_prescribed(part) and part.table.name in by_name:
                rates[part] = by_name[part.table.name].function(part.orders)(*part.args)
        elif part.expr in found and set(part.variables) == {t}:
            rates[part] = found[part.expr](t).diff(t, len(part.variables))
    return rates


def _rows(fields: dict[str, Any]) -> Iterator[sympy.Expr]:
    """Yield constraint rows, gaps of contacts, slips of frictions and the surfaces of impacts."""
    yield from fields["holonomic_constraints"]
    yield from fields["nonholonomic_constraints"]
    for _, entry in fields["contacts"]:
        yield from entry.slips if isinstance(entry, Friction) else (entry.gap,)
    yield from (event.impact[0] for _, event in fields["events"] if event.impact)
