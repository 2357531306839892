"""Kernel of the arguments of tables in the motion."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from ..equations.terms import Terms
from ..graph.store import Node
from ..graph.table_calls import is_table_call, orders_of, table_of
from ..kernel.kernel import Array, Draft, Entry, Symbols, written
from .kernel_roles import TableKernel, TableUse

Place = tuple[str, int, Node]
"""The name of a table, the index of one of its arguments, and the node of that argument."""


def table_kernel(terms: Terms, symbols: Symbols) -> TableKernel:
    """Return the kernel, which computes each distinct argument once, with the highest derivative for each."""
    if not terms.graph.tables:
        return TableKernel(None, ())
    places = _places(terms, terms.evaluated)
    entries = [Entry(Array("at", ""), (f"[{k}]",), node) for k, (_, _, node) in enumerate(places)]
    uses = tuple(
        TableUse(table, axis, order, int(terms.graph.varies_with(node, terms.mechanics.time.name)))
        for (table, axis, node), order in places.items()
    )
    draft = Draft("table_arguments", entries, ("t", "x", "v", "c", "u", "at"))
    return TableKernel(written(terms.graph, [draft], symbols, None)[0], uses)


def _places(terms: Terms, roots: Sequence[Node]) -> dict[Place, int]:
    """Return place -> the highest derivative, over all calls of tables."""
    highest: dict[Place, int] = {}
    for node in _calls(terms, roots):
        name, _, *arguments = terms.graph.records[node].operands
        for axis, (argument, order) in enumerate(zip(arguments, orders_of(name), strict=True)):
            place = table_of(name), axis, argument
            highest[place] = max(order, highest.get(place, 0))
    return highest


def _calls(terms: Terms, roots: Sequence[Node]) -> Iterable[Node]:
    return (node for node in terms.graph.reachable(roots) if is_table_call(terms.graph, node))
