"""The kernel that says where motion looks up its tables."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from ..equations.terms import Terms
from ..graph.store import Node
from ..graph.table_calls import is_table_call, orders_of, table_of
from ..kernel.kernel import Array, Draft, Entry, Symbols, written
from .kernel_roles import TableKernel, TableUse

Place = tuple[str, int, Node]
"""A table, which of its arguments, and the expression there."""


def table_kernel(terms: Terms, symbols: Symbols) -> TableKernel:
    """Write it: each expression that is an argument of a table once, with the highest derivative that is taken."""
    if not terms.graph.tables:
        return TableKernel(None, ())
    found = _places(terms, terms.evaluated)
    entries = [Entry(Array("at", ""), (f"[{k}]",), node) for k, (_, _, node) in enumerate(found)]
    uses = tuple(
        TableUse(table, axis, order, int(terms.graph.varies_with(node, terms.mechanics.time.name)))
        for (table, axis, node), order in found.items()
    )
    draft = Draft("table_arguments", entries, ("t", "x", "v", "c", "u", "at"))
    return TableKernel(written(terms.graph, [draft], symbols, None)[0], uses)


def _places(terms: Terms, roots: Sequence[Node]) -> dict[Place, int]:
    found: dict[Place, int] = {}
    for node in _calls(terms, roots):
        name, _, *arguments = terms.graph.records[node].operands
        for axis, (argument, order) in enumerate(zip(arguments, orders_of(name), strict=True)):
            place = table_of(name), axis, argument
            found[place] = max(order, found.get(place, 0))
    return found


def _calls(terms: Terms, roots: Sequence[Node]) -> Iterable[Node]:
    return (node for node in terms.graph.reachable(roots) if is_table_call(terms.graph, node))
