"""Three-address operations that compute the nodes of a graph from values computed before."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from ..graph.coefficients import Number, magnitude
from ..graph.graph import Graph
from ..graph.store import Kind, Node

BEYOND_THE_GRAPH = 1 << 40
"""Numbers of values that are not nodes start here."""


class Operation(NamedTuple):
    """One operation on values.

    kind : leaf (a symbol), number, constant (computed once per parameter set), add, mul, inverse, sqrt, call.
    operands : add -> ((value, coefficient), ...); mul -> (value, ...); inverse, sqrt -> (value,);
    call -> (function, value, ...); leaf -> (name,); number -> (value,); constant -> (node,).
    """

    kind: str
    operands: tuple  # type: ignore[type-arg]


def operands_of(operation: Operation) -> Iterator[int]:
    """Yield the operand values of an operation, with repetitions."""
    kind, operands = operation
    if kind == "add":
        yield from (value for value, _ in operands)
    elif kind in ("mul", "inverse", "sqrt"):
        yield from operands
    elif kind == "call":
        yield from operands[1:]


@dataclass(slots=True)
class Cost:
    """Operation counts of a piece of code."""

    add: int = 0
    multiply: int = 0
    divide: int = 0
    root: int = 0
    call: int = 0

    WEIGHTS = (1, 1, 4, 5, 15)

    def counts(self) -> tuple[int, ...]:
        """Return (additions, multiplications, divisions, roots, function calls)."""
        return self.add, self.multiply, self.divide, self.root, self.call

    @property
    def weight(self) -> int:
        """The approximate time, in units of one addition."""
        return sum(count * weight for count, weight in zip(self.counts(), self.WEIGHTS, strict=True))

    def __add__(self, other: Cost) -> Cost:
        return Cost(*(a + b for a, b in zip(self.counts(), other.counts(), strict=True)))


def cost_of(operations: dict[int, Operation], values: Iterable[int]) -> Cost:
    """Return the cost of the operations that compute some values."""
    cost = Cost()
    for value in values:
        kind, operands = operations[value]
        if kind == "add":
            cost.add += len(operands) - 1
            cost.multiply += sum(abs(factor) != 1 and operations[term].kind != "number" for term, factor in operands)
        elif kind == "mul":
            cost.multiply += len(operands) - 1
        elif kind == "inverse":
            cost.divide += 1
        elif kind == "sqrt":
            cost.root += 1
        elif kind == "call":
            cost.call += 1
    return cost


@dataclass(slots=True)
class Table:
    """Operations under construction; values that are not nodes belong to extracted subexpressions."""

    graph: Graph
    hoist: bool
    operations: dict[int, Operation] = field(default_factory=dict)
    shared: dict[Operation, int] = field(default_factory=dict)

    def new(self, operation: Operation) -> int:
        """Return the value of an operation that does not correspond to a node."""
        value = self.shared.get(operation)
        if value is None:
            value = self.shared[operation] = BEYOND_THE_GRAPH + len(self.shared)
            self.operations[value] = operation
        return value


def value_of(table: Table, root: Node) -> int:
    """Return the value of a node, after adding the operations that it needs to the table."""
    graph = table.graph
    for node in _needed(table, root):
        if node not in table.operations:
            table.operations[node] = _operation(table, node)
    assert root in table.operations, graph.records[root]
    return root


def _needed(table: Table, root: Node) -> list[Node]:
    seen: set[Node] = set()
    stack = [root]
    while stack:
        node = stack.pop()
        if node not in seen and node not in table.operations:
            seen.add(node)
            if not _is_constant(table, node):
                stack.extend(table.graph.children(node))
    return sorted(seen)


def _is_constant(table: Table, node: Node) -> bool:
    return table.hoist and not table.graph.varies(node)


def _operation(table: Table, node: Node) -> Operation:
    kind, operands = table.graph.records[node]
    if kind is Kind.NUMBER:
        return Operation("number", (operands[0],))
    if kind is Kind.SYMBOL:
        return Operation("leaf", operands)
    if _is_constant(table, node):
        return Operation("constant", (node,))
    if kind is Kind.SUM:
        return _sum(table, operands)
    if kind is Kind.PRODUCT:
        return _product(table, operands)
    return Operation("call", operands)


def _sum(table: Table, terms: Sequence[tuple[Node, Number]]) -> Operation:
    """Return the operation of a sum; terms in parameters alone become one constant, which absorbs numeric factors."""
    graph = table.graph
    constant = [(node, factor) for node, factor in terms if _is_constant(table, node)]
    if len(constant) > 1 or any(abs(factor) != 1 for _, factor in constant):
        joined = graph.sum(constant)
        terms = [*((n, f) for n, f in terms if not _is_constant(table, n)), (joined, 1)]
        value_of(table, joined)
    return _common_factor(table, terms) or _scaled(table, [_joined_factor(table, *term) for term in terms])


def _common_factor(table: Table, terms: Sequence[tuple[Node, Number]]) -> Operation | None:
    """Factor out a factor of parameters that all terms of a sum have in common: k f + k g = k (f + g)."""
    graph = table.graph
    if len(terms) < 2 or not table.hoist:
        return None
    split = [graph.split(node) for node, _ in terms]
    common = {constant for constant, _ in split}
    if len(common) != 1 or graph.one in common or any(varying == graph.one for _, varying in split):
        return None
    rest = graph.sum((varying, factor) for (_, varying), (_, factor) in zip(split, terms, strict=True))
    return Operation("mul", tuple(sorted((value_of(table, common.pop()), value_of(table, rest)))))


def _scaled(table: Table, terms: list[tuple[int, Number]]) -> Operation:
    if len(terms) == 1 and abs(terms[0][1]) != 1:
        factor = table.new(Operation("number", (terms[0][1],)))
        return Operation("mul", (factor, terms[0][0]))
    return Operation("add", tuple(sorted(terms)))


def _joined_factor(table: Table, node: Node, factor: Number) -> tuple[int, Number]:
    """Return factor x (constant x varying) as (factor x constant) x varying."""
    graph = table.graph
    if abs(factor) != 1 and table.hoist and graph.varies(node):
        constant, varying = graph.split(node)
        if constant != graph.one:
            joined = graph.scale(constant, magnitude(factor))
            parts = [value_of(table, joined), *_powers(table, varying)]
            return table.new(Operation("mul", tuple(sorted(parts)))), 1 if factor > 0 else -1
    value_of(table, node)
    return node, factor


def _powers(table: Table, node: Node) -> list[int]:
    kind, operands = table.graph.records[node]
    if kind is not Kind.PRODUCT:
        return [value_of(table, node)]
    return [part for base, power in operands for part in _power(table, base, power)]


def _product(table: Table, factors: Sequence[tuple[Node, Number]]) -> Operation:
    """Return the operation of a product; its factors in parameters alone become one constant."""
    graph = table.graph
    constant = [(node, power) for node, power in factors if _is_constant(table, node)]
    parts = []
    if constant:
        parts.append(value_of(table, graph.product(constant)))
    for node, power in factors:
        if not _is_constant(table, node):
            parts.extend(_power(table, node, power))
    return Operation("mul", tuple(sorted(parts)))


def _power(table: Table, base: int, power: Number) -> list[int]:
    """Return factors whose product is base^power: multiplications, at most one root and at most one division."""
    value_of(table, base)
    if power < 0:
        parts = _power(table, base, -power)
        inner = parts[0] if len(parts) == 1 else table.new(Operation("mul", tuple(sorted(parts))))
        return [table.new(Operation("inverse", (inner,)))]
    whole, half = divmod(power, 1)
    if half not in (0, 0.5) or whole > 16:
        exponent = table.new(Operation("number", (float(power),)))
        return [table.new(Operation("call", ("pow", base, exponent)))]
    root = [table.new(Operation("sqrt", (base,)))] if half else []
    return _whole_power(table, base, int(whole)) + root


def _whole_power(table: Table, base: int, power: int) -> list[int]:
    if power <= 1:
        return [base] * power
    square = table.new(Operation("mul", (base, base)))
    return _whole_power(table, square, power // 2) + [base] * (power % 2)
