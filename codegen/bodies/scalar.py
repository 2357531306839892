"""Arithmetic on the nodes of a graph, and vectors of three of them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction

from ..graph.coefficients import Number
from ..graph.graph import Graph
from ..graph.store import Node


class Scalar:
    """A node of a graph with operators; other operands may be numbers."""

    __slots__ = ("graph", "node")

    def __init__(self, graph: Graph, node: Node) -> None:
        self.graph, self.node = graph, node

    def __add__(self, other: Scalar) -> Scalar:
        return total(self.graph, (self, other))

    def __sub__(self, other: Scalar) -> Scalar:
        return Scalar(self.graph, self.graph.sum(((self.node, 1), (other.node, -1))))

    def __neg__(self) -> Scalar:
        return Scalar(self.graph, self.graph.scale(self.node, -1))

    def __mul__(self, other: Scalar | Number) -> Scalar:
        if isinstance(other, Scalar):
            return Scalar(self.graph, self.graph.mul(self.node, other.node))
        return Scalar(self.graph, self.graph.scale(self.node, other))

    __rmul__ = __mul__

    def __pow__(self, exponent: Number) -> Scalar:
        return Scalar(self.graph, self.graph.power(self.node, exponent))

    def __truediv__(self, other: Scalar) -> Scalar:
        return self * other**-1

    @property
    def is_zero(self) -> bool:
        """Whether this is the number 0."""
        return self.node == self.graph.zero


Vector = Sequence[Scalar]
"""(3,)"""
HALF = Fraction(1, 2)


def total(graph: Graph, terms: Iterable[Scalar]) -> Scalar:
    """Return the sum of terms as one node."""
    return Scalar(graph, graph.sum([(term.node, 1) for term in terms]))


def dot(a: Vector, b: Vector) -> Scalar:
    """Return a . b of two vectors of one length."""
    return total(a[0].graph, [x * y for x, y in zip(a, b, strict=True)])


def cross(a: Vector, b: Vector) -> Vector:
    """Return a x b."""
    return [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]


def plus(*vectors: Vector) -> Vector:
    """Return the sum of vectors."""
    return [total(parts[0].graph, parts) for parts in zip(*vectors, strict=True)]


def minus(a: Vector, b: Vector) -> Vector:
    """Return a - b."""
    return [x - y for x, y in zip(a, b, strict=True)]


def scaled(a: Vector, factor: Scalar) -> Vector:
    """Return factor a."""
    return [x * factor for x in a]
