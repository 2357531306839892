"""A walk over expressions that comes to each node once."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Generic, TypeVar

from .graph import Graph
from .store import Node

Value = TypeVar("Value")


class Fold(ABC, Generic[Value]):
    """node -> what is made of the node, from what has been made of its operands; each is made once and kept."""

    def __init__(self, graph: Graph) -> None:
        self.graph = graph
        self._known: dict[Node, Value] = {}

    def __call__(self, root: Node) -> Value:
        """Return what is made of a node, however deep it is nested."""
        for node in self.graph.reachable([root], self._known):
            self._known[node] = self._made(node)
        return self._known[root]

    @abstractmethod
    def _made(self, node: Node) -> Value:
        """Return what is made of a node whose operands are known."""
