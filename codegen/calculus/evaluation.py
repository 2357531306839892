"""Floating-point evaluation of expressions."""

from __future__ import annotations

import math
import operator
from abc import abstractmethod
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from ..graph.fold import Fold, Value
from ..graph.graph import Graph
from ..graph.store import Kind, Node
from ..graph.table_calls import orders_of, table_of

FUNCTIONS: Mapping[str, Callable[..., Any]] = {
    "abs": abs, "min": min, "max": max, "sign": lambda a: (a > 0) - (a < 0), "step": lambda a: float(a > 0),
    "select": lambda c, a, b: a if c else b, "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge,
    "==": operator.eq, "!=": operator.ne, "and": lambda a, b: bool(a) and bool(b),
    "or": lambda a, b: bool(a) or bool(b), "not": operator.not_,
}  # fmt: skip
"""Functions that the module math does not have under the same name."""


class Evaluation(Fold[Value]):
    """Function node -> value, which is `undefined` where evaluation fails."""

    undefined: Value

    def _result(self, node: Node) -> Value:
        try:
            return self._value(node)
        except (ArithmeticError, AttributeError, TypeError, ValueError):
            return self.undefined

    @abstractmethod
    def _value(self, node: Node) -> Value:
        """Return the value of a node whose operands are known, or raise."""


class At(Evaluation[float]):
    """Real values of nodes at given values of the symbols; NaN where a node is undefined."""

    undefined = math.nan

    def __init__(self, graph: Graph, values: Mapping[str, float]) -> None:
        super().__init__(graph)
        self.values = values

    def _value(self, node: Node) -> float:
        kind, operands = self.graph.records[node]
        known = self._known
        if kind is Kind.NUMBER:
            return float(operands[0])
        if kind is Kind.SYMBOL:
            return float(self.values[operands[0]])
        if kind is Kind.SUM:
            return math.fsum(float(factor) * known[child] for child, factor in operands)
        if kind is Kind.PRODUCT:
            return float(math.prod(known[child] ** float(power) for child, power in operands))
        name, *arguments = operands
        if orders := orders_of(name):
            return self.graph.tables[table_of(name)].pieces.value(orders, [known[child] for child in arguments[1:]])
        return float((FUNCTIONS.get(name) or getattr(math, name))(*(known[child] for child in arguments)))

    def rows(self, rows: Sequence[Sequence[Node]]) -> list[list[float]]:
        """Return the values of a matrix of nodes."""
        return [[self(entry) for entry in row] for row in rows]
