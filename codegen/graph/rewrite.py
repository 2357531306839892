"""Rewriting of expressions: some nodes are replaced, and the nodes above them rebuilt."""

from __future__ import annotations

from collections.abc import Mapping

from .fold import Fold
from .graph import Graph
from .store import Kind, Node


class Rewriter(Fold[Node]):
    """Applies `replacement` to each node and rebuilds the others from their rewritten operands.

    values : node -> its replacement
    """

    def __init__(self, graph: Graph, values: Mapping[Node, Node] | None = None) -> None:
        super().__init__(graph)
        self._replacements = values or {}

    def replacement(self, node: Node) -> Node | None:
        """Return the replacement of a node, or None to rebuild it from its operands."""
        return self._replacements.get(node)

    def _result(self, node: Node) -> Node:
        replaced = self.replacement(node)
        return self._rebuilt(node) if replaced is None else replaced

    def _rebuilt(self, node: Node) -> Node:
        graph, known = self.graph, self._known
        kind, operands = graph.records[node]
        if kind in (Kind.NUMBER, Kind.SYMBOL) or all(known[child] == child for child in graph.children(node)):
            return node
        if kind is Kind.SUM:
            return graph.sum((known[child], factor) for child, factor in operands)
        if kind is Kind.PRODUCT:
            return graph.product((known[child], power) for child, power in operands)
        return _folded(graph, operands[0], tuple(known[child] for child in operands[1:]))


def _folded(graph: Graph, name: str, operands: tuple[Node, ...]) -> Node:
    if operands == (graph.zero,):
        if name in ("sin", "tan", "sinh", "tanh", "asin", "atan", "asinh", "atanh", "erf", "abs", "sign"):
            return graph.zero
        if name in ("cos", "cosh", "exp"):
            return graph.number(1)
    return graph.call(name, *operands)


class Substitution(Rewriter):
    """Replaces symbols by nodes."""

    def __init__(self, graph: Graph, values: Mapping[str, Node]) -> None:
        super().__init__(graph)
        self._values = values

    def replacement(self, node: Node) -> Node | None:
        """Return the value of a symbol that has one."""
        kind, operands = self.graph.records[node]
        return self._values.get(operands[0]) if kind is Kind.SYMBOL else None
