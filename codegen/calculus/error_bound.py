"""Running error bound of an expression, as another expression of the same graph.

Every computed value, and every coordinate, has a relative error of eps. To first order, the error of the result follows
from the derivatives with respect to all of them (Higham, Accuracy and Stability of Numerical Algorithms, 3.3):

    sum       sum_i |c_i| s(a_i), which is at least the sum of the absolute values of its terms
    product   sum_i |d p / d a_i| s(a_i), over the operands that vary
    call      |f| + sum_i |d f / d a_i| s(a_i)

and s = |a| for a symbol or number, so that s >= |a| throughout. eps s also accounts for cancellation inside an
expression: for (x - 1000)^2 it includes the rounding error of x, but not that of a term 1000^2.
"""

from __future__ import annotations

from ..graph.coefficients import is_whole, magnitude
from ..graph.fold import Fold
from ..graph.store import Kind, Node
from .derivatives import STEPS, partial


class Rounding(Fold[Node]):
    """Function node -> s, the size of its terms; eps s bounds its rounding error to first order."""

    def _result(self, node: Node) -> Node:
        graph = self.graph
        kind, operands = graph.records[node]
        if kind is Kind.SUM:
            return graph.sum((self._known[child], magnitude(factor)) for child, factor in operands)
        if kind is Kind.PRODUCT:
            return graph.add(*self._parts(node))
        if kind is Kind.CALL:
            return self._size_of_call(node, operands[0], operands[1:])
        return self._absolute(node)

    def _size_of_call(self, node: Node, name: str, operands: tuple[Node, ...]) -> Node:
        sizes = [self._known[operand] for operand in operands]
        if name == "select":
            return self.graph.call("select", operands[0], *sizes[1:])
        if name in ("min", "max"):
            return self.graph.call("max", *sizes)
        if name == "abs":
            return sizes[0]
        if name in STEPS:
            return self._absolute(node)
        return self.graph.add(self._absolute(node), *self._parts(node))

    def _parts(self, node: Node) -> list[Node]:
        """Return |d node / d a_i| s(a_i) for each operand; |(d node / d a_i) a_i| if s = |a_i|, to avoid division."""
        graph, parts = self.graph, []
        for child in self._rounded(node):
            rate, size = partial(graph, node, child), self._known[child]
            plain = size == self._absolute(child)
            parts.append(self._absolute(graph.mul(rate, child)) if plain else graph.mul(self._absolute(rate), size))
        return parts

    def _rounded(self, node: Node) -> list[Node]:
        """Return the operands that vary, or all if none does; parameters count as exact."""
        children = list(dict.fromkeys(self.graph.children(node)))
        return [child for child in children if self.graph.varies(child)] or children

    def _absolute(self, node: Node) -> Node:
        """Return |node|, without a call of abs where the sign is evident from its form."""
        graph = self.graph
        kind, operands = graph.records[node]
        if kind is Kind.NUMBER:
            return graph.number(magnitude(operands[0]))
        if kind is Kind.SUM and len(operands) == 1:
            inner, factor = operands[0]
            return graph.scale(self._absolute(inner), magnitude(factor))
        if kind is Kind.PRODUCT and all(is_whole(power) and power % 2 == 0 for _, power in operands):
            return node
        if kind is Kind.CALL and operands[0] == "abs":
            return node
        return graph.call("abs", node)
