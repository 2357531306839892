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
        if replaced is not None:
            return replaced
        return rebuilt(self.graph, node, tuple(self._known[child] for child in self.graph.children(node)))


def rebuilt(graph: Graph, node: Node, children: tuple[Node, ...]) -> Node:
    """Return a node with other children."""
    kind, operands = graph.records[node]
    if children == graph.children(node):
        return node
    if kind is Kind.CALL:
        return _folded(graph, operands[0], children)
    pairs = [(child, number) for child, (_, number) in zip(children, operands, strict=True)]
    return graph.sum(pairs) if kind is Kind.SUM else graph.product(pairs)


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
