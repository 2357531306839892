"""Memoised bottom-up traversal of expressions (a fold, or catamorphism)."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Generic, TypeVar

from .graph import Graph
from .store import Node

Value = TypeVar("Value")


class Fold(ABC, Generic[Value]):
    """Function of a node, computed from the results for its operands. Each result is computed once and stored."""

    def __init__(self, graph: Graph) -> None:
        self.graph = graph
        self._known: dict[Node, Value] = {}

    def __call__(self, root: Node) -> Value:
        """Return the result for a node, without recursion, so that any depth of nesting works."""
        for node in self.graph.reachable([root], self._known):
            self._known[node] = self._result(node)
        return self._known[root]

    @abstractmethod
    def _result(self, node: Node) -> Value:
        """Return the result for a node; those of its operands are in `_known`."""
