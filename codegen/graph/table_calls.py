"""Calls of tables in a graph. Their operands are the table's handle, then its arguments.

The function's name encodes the table and the orders of the derivative: "load[0]" is load, "map[1,0]" the derivative of
map with respect to its first argument. Graph.tables maps names to tables.
"""

from __future__ import annotations

from collections.abc import Sequence

from .store import Kind, Node, Store


def name_of_call(table: str, orders: Sequence[int]) -> str:
    """Return the name of the function that is this derivative of a table."""
    return f"{table}[{','.join(map(str, orders))}]"


def orders_of(function: str) -> tuple[int, ...]:
    """Return the orders of the derivative; () if the function is not a table."""
    return tuple(map(int, function[:-1].partition("[")[2].split(","))) if function.endswith("]") else ()


def table_of(function: str) -> str:
    """Return the name of the table that a function's name contains."""
    return function.partition("[")[0]


def differentiated(graph: Store, node: Node, place: int) -> Node:
    """Return the derivative of a call with respect to the operand at `place`; that of the handle is 0."""
    name, *operands = graph.records[node].operands
    if place == 0:
        return graph.zero
    orders = (order + (k == place - 1) for k, order in enumerate(orders_of(name)))
    return graph.call(name_of_call(table_of(name), list(orders)), *operands)


def is_table_call(graph: Store, node: Node) -> bool:
    """Whether a node is a call of a table."""
    kind, operands = graph.records[node]
    return kind is Kind.CALL and operands[0].endswith("]")
