"""Calls of tables in a graph: the handle of the table first, then its arguments.

The function's name says which table, and which derivative: "load[0]" is load, "map[1,0]" the derivative of map by its
first argument. Graph.tables has their numbers.
"""

from __future__ import annotations

from collections.abc import Sequence

from .store import Kind, Node, Store


def name_of_call(table: str, orders: Sequence[int]) -> str:
    """Return the function's name."""
    return f"{table}[{','.join(map(str, orders))}]"


def orders_of(function: str) -> tuple[int, ...]:
    """Return the orders of the derivative; () of what is no table."""
    return tuple(map(int, function[:-1].partition("[")[2].split(","))) if function.endswith("]") else ()


def table_of(function: str) -> str:
    """Return the name of the table."""
    return function.partition("[")[0]


def differentiated(graph: Store, node: Node, place: int) -> Node:
    """Return the derivative of a call by the operand at a place; nothing hangs on the handle."""
    name, *operands = graph.records[node].operands
    if place == 0:
        return graph.zero
    orders = (order + (k == place - 1) for k, order in enumerate(orders_of(name)))
    return graph.call(name_of_call(table_of(name), list(orders)), *operands)


def is_table_call(graph: Store, node: Node) -> bool:
    """Whether a node is one."""
    kind, operands = graph.records[node]
    return kind is Kind.CALL and operands[0].endswith("]")
