"""References from SymPy expressions to nodes: terms of equations that were written as nodes, and stay so."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import ClassVar

import sympy

from .coefficients import Number
from .graph import Graph
from .store import Kind, Node


class NodeReference(sympy.Function):  # type: ignore[misc]
    """A node of a graph, as a SymPy function of the symbols on which it depends."""

    node: ClassVar[Node]

    def _eval_is_extended_real(self) -> bool:
        return True


class References:
    """Turns nodes into references; numbers and symbols into those of SymPy.

    Parameters
    ----------
    symbols
        All symbols of the graph by name.
    """

    def __init__(self, graph: Graph, symbols: Mapping[str, sympy.Symbol]) -> None:
        self.graph, self._symbols = graph, symbols
        self._within: dict[Node, frozenset[str]] = {}

    def __call__(self, node: Node) -> sympy.Expr:
        """Return the expression of a node."""
        kind, operands = self.graph.records[node]
        if kind is Kind.NUMBER:
            return from_number(operands[0])
        if kind is Kind.SYMBOL:
            return self._symbols[operands[0]]
        arguments = [self._symbols[name] for name in sorted(self.names(node))]
        return _reference(node)(*arguments)

    def names(self, root: Node) -> frozenset[str]:
        """Return the names of the symbols in a node."""
        for node in self.graph.reachable([root], self._within):
            kind, operands = self.graph.records[node]
            own = frozenset(operands) if kind is Kind.SYMBOL else frozenset[str]()
            self._within[node] = own.union(*(self._within[child] for child in self.graph.children(node)))
        return self._within[root]


@cache
def _reference(node: Node) -> type[NodeReference]:
    return type(f"node_{node}", (NodeReference,), {"node": node})


def from_number(value: Number) -> sympy.Number:
    """Return a coefficient as a SymPy number."""
    if isinstance(value, float):
        return sympy.Float(value)
    return sympy.Rational(value.numerator, value.denominator)
