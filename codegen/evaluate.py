"""Numbers for nodes: to tell what vanishes identically although its form does not show it."""

from __future__ import annotations

import math
import operator
import random
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from .graph import Graph, Kind, Node

POINTS = 3
"""Random points at which an expression must vanish to count as zero."""
ROUNDING = 1e-11
"""What counts as cancelled, relative to the sum of the absolute values of the terms."""

FUNCTIONS: Mapping[str, Callable[..., Any]] = {
    "sin": math.sin, "cos": math.cos, "tan": math.tan, "asin": math.asin, "acos": math.acos, "atan": math.atan,
    "atan2": math.atan2, "sinh": math.sinh, "cosh": math.cosh, "tanh": math.tanh, "asinh": math.asinh,
    "acosh": math.acosh, "atanh": math.atanh, "exp": math.exp, "log": math.log, "abs": abs, "min": min, "max": max,
    "erf": math.erf, "floor": math.floor, "ceil": math.ceil, "pow": math.pow,
    "sign": lambda a: (a > 0) - (a < 0), "step": lambda a: float(a > 0), "select": lambda c, a, b: a if c else b,
    "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge, "==": operator.eq, "!=": operator.ne,
    "and": lambda a, b: bool(a) and bool(b), "or": lambda a, b: bool(a) or bool(b), "not": operator.not_,
}  # fmt: skip


EVEN = frozenset({"sin", "cos", "tan", "asin", "acos", "atan", "atan2", "asinh", "acosh", "log"})
"""Functions without steps, and without stretches where they are constant to rounding."""


class Point:
    """One random point: value and magnitude (the sum of the absolute terms behind it) of every node asked for."""

    def __init__(self, graph: Graph, seed: int) -> None:
        self.graph = graph
        self._seed = seed
        self._known: dict[Node, tuple[float, float]] = {}

    def __call__(self, root: Node) -> tuple[float, float]:
        """Return (value, magnitude); not a number where the expression is not defined at this point."""
        if root not in self._known:
            for node in self.graph.reachable([root]):
                if node not in self._known:
                    self._known[node] = self._guarded(node)
        return self._known[root]

    def _guarded(self, node: Node) -> tuple[float, float]:
        try:
            return self._evaluate(node)
        except (ValueError, ZeroDivisionError, OverflowError, TypeError):
            return math.nan, math.nan

    def _evaluate(self, node: Node) -> tuple[float, float]:
        kind, operands = self.graph.records[node]
        known = self._known
        if kind is Kind.NUMBER:
            return float(operands[0]), abs(float(operands[0]))
        if kind is Kind.SYMBOL:
            value = random.Random(f"{operands[0]} {self._seed}").uniform(0.4, 1.9)
            return value, value
        if kind is Kind.SUM:
            value = math.fsum(float(factor) * known[child][0] for child, factor in operands)
            return value, math.fsum(abs(float(factor)) * known[child][1] for child, factor in operands)
        if kind is Kind.PRODUCT:
            value = math.prod(known[child][0] ** float(power) for child, power in operands)
            return value, math.prod(_size(*known[child], float(power)) for child, power in operands)
        result = float(FUNCTIONS[operands[0]](*(known[child][0] for child in operands[1:])))
        return result, abs(result)


def _size(value: float, magnitude: float, power: float) -> float:
    """How large value^power may be for a value known to magnitude x rounding."""
    return float(magnitude**power) if power > 0 else float(abs(value) ** power) * max(1.0, magnitude / abs(value))


class Zeros:
    """Decides which nodes are identically zero, by their form or at random points (Schwartz 1980, Zippel 1979)."""

    def __init__(self, graph: Graph) -> None:
        self.graph = graph
        self._points = [Point(graph, seed) for seed in range(POINTS)]

    def __call__(self, node: Node) -> bool:
        """Whether a node is zero wherever it is defined; what a few points do not tell counts as not zero."""
        if node == self.graph.zero:
            return True
        return all(abs(value) <= ROUNDING * size for value, size in self._values(node)) and self.telling(node)

    def telling(self, node: Node) -> bool:
        """Whether a few points speak for all: not with steps and choices, nor with what falls below rounding."""
        records = self.graph.records
        return all(records[part].operands[0] in EVEN for part in self.graph.reachable([node])
                   if records[part].kind is Kind.CALL)  # fmt: skip

    def all(self, nodes: Iterable[Node]) -> bool:
        """Whether all nodes are zero."""
        return all(map(self, nodes))

    def equal(self, first: Node, second: Node) -> bool:
        """Whether two nodes have the same finite values."""
        pairs = zip(self._values(first), self._values(second), strict=True)
        return all(abs(a - b) <= ROUNDING * (size_a + size_b) for (a, size_a), (b, size_b) in pairs)

    def _values(self, node: Node) -> list[tuple[float, float]]:
        return [point(node) for point in self._points]
