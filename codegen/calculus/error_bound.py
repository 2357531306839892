"""Running error bound of an expression, as another expression of the same graph.

Every value that is computed is off by eps of itself, and so is every coordinate; what that makes of the whole follows
to first order from the derivatives on the way (Higham, Accuracy and Stability of Numerical Algorithms, 3.3):

    sum       sum_i |c_i| s(a_i), which is at least the sum of the absolute values of its terms
    product   sum_i |d p / d a_i| s(a_i), over what varies
    call      |f| + sum_i |d f / d a_i| s(a_i)

and s = |a| of a symbol or number, so that s >= |a| throughout. eps s is right where terms cancel, also inside: of
(x - 1000)^2 it counts the rounding of x, but not 1000^2.
"""

from __future__ import annotations

from ..graph.coefficients import is_whole, magnitude
from ..graph.fold import Fold
from ..graph.store import Kind, Node
from .derivatives import STEPS, partial


class Rounding(Fold[Node]):
    """node -> s, the size of the terms that make it: eps s is its rounding."""

    def _made(self, node: Node) -> Node:
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
        """|d node / d a_i| s(a_i) of each operand; no derivative is divided out of it where s(a_i) = |a_i|."""
        graph, parts = self.graph, []
        for child in self._rounded(node):
            rate, size = partial(graph, node, child), self._known[child]
            plain = size == self._absolute(child)
            parts.append(self._absolute(graph.mul(rate, child)) if plain else graph.mul(self._absolute(rate), size))
        return parts

    def _rounded(self, node: Node) -> list[Node]:
        """The operands that vary: factors of parameters are what they are."""
        children = list(dict.fromkeys(self.graph.children(node)))
        return [child for child in children if self.graph.varies(child)] or children

    def _absolute(self, node: Node) -> Node:
        """|node|, without a call where the form shows its sign."""
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
