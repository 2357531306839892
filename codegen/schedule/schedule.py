"""Schedules: the operations that compute given expressions, in order, with their cost.

A function of the generated code is a sequence of kernels. Each assigns expressions to variables and array entries; a
value that is used twice gets a name in the first kernel that needs it. Before that

- functions of the parameters alone are hoisted: they are computed once per parameter set;
- products and sums that several expressions have in common are extracted (`common_operands`).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from ..graph.graph import Graph
from ..graph.store import Node
from .common_operands import share
from .operations import Cost, Operation, Table, cost_of, operands_of, value_of


@dataclass(frozen=True, slots=True)
class Schedule:
    """The operations needed for some expressions; `uses` counts the occurrences of each value."""

    operations: dict[int, Operation]
    uses: Counter[int]
    roots: dict[Node, int]
    cost: Cost


class Constants:
    """The constants that are computed once per parameter set, shared by all functions of a program."""

    def __init__(self, graph: Graph) -> None:
        self.graph = graph
        self.nodes: list[Node] = []
        self._index: dict[Node, int] = {}

    def index(self, node: Node) -> int:
        """Return the index among the constants of a node that depends on parameters alone; add it if it is new."""
        if node not in self._index:
            self._index[node] = len(self.nodes)
            self.nodes.append(node)
        return self._index[node]


def schedule(graph: Graph, roots: Sequence[Node], *, hoist: bool = True) -> Schedule:
    """Choose the operations for some expressions.

    Parameters
    ----------
    hoist
        True: functions of the parameters are constants, computed before. False: they are computed here, as in the
        function that prepares the constants.
    """
    table = Table(graph, hoist)
    values = {root: value_of(table, root) for root in roots}
    share(table, "mul")
    share(table, "add")
    live = _live(table.operations, values.values())
    uses = Counter(operand for value in live for operand in operands_of(table.operations[value]))
    uses.update(values.values())
    return Schedule({value: table.operations[value] for value in live}, uses, values, cost_of(table.operations, live))


def weight(graph: Graph, roots: Sequence[Node]) -> int:
    """Return the approximate time of some expressions, in additions, before common operands are extracted."""
    table = Table(graph, True)
    values = [value_of(table, root) for root in roots]
    return cost_of(table.operations, _live(table.operations, values)).weight


def cost_behind(plan: Schedule, roots: Iterable[Node]) -> Cost:
    """Return the cost of computing only some of the expressions of a schedule."""
    return cost_of(plan.operations, _live(plan.operations, (plan.roots[root] for root in roots)))


def _live(operations: dict[int, Operation], values: Iterable[int]) -> list[int]:
    """Return all values needed for some values, in order of evaluation."""
    order: dict[int, None] = {}
    stack = [(value, False) for value in sorted(set(values), reverse=True)]
    while stack:
        value, ready = stack.pop()
        if value in order:
            continue
        if ready:
            order[value] = None
            continue
        stack.append((value, True))
        stack.extend((operand, False) for operand in operands_of(operations[value]) if operand not in order)
    return list(order)
