"""From expressions of the graph to statements: what is computed once, in which order, and at what cost.

A function of the generated code is a sequence of sections. Each section assigns expressions to places; a value
that is used twice gets a name in the first section that needs it. Before that

- everything made of parameters only leaves the function: it is computed once per parameter set;
- products and sums that several expressions have in common are taken out, the most frequent pair first
  (Hosangadi, Fallah & Kastner 2006, the greedy form of common-subexpression elimination for polynomials).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from heapq import heapify, heappop, heappush
from itertools import combinations
from typing import NamedTuple

from .graph import Graph, Kind, Node, Number, magnitude, ratio

BEYOND_THE_GRAPH = 1 << 40
"""Values that are no nodes are numbered from here."""


Pair = tuple[int, int, Number]
"""Two operands of a product, or of a sum with the ratio of their coefficients."""


class Operation(NamedTuple):
    """One operation on values.

    kind : leaf (a symbol), number, constant (computed once per parameter set), add, mul, inverse, sqrt, call.
    operands : add -> ((value, coefficient), ...); mul -> (value, ...); else what the kind needs.
    """

    kind: str
    operands: tuple  # type: ignore[type-arg]


@dataclass(slots=True)
class Cost:
    """Operations of a piece of code."""

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
        """Roughly the time in additions."""
        return sum(count * weight for count, weight in zip(self.counts(), self.WEIGHTS, strict=True))

    def __add__(self, other: Cost) -> Cost:
        return Cost(*(a + b for a, b in zip(self.counts(), other.counts(), strict=True)))


@dataclass(frozen=True, slots=True)
class Schedule:
    """The operations that some expressions need; `uses` counts in how many places a value stands."""

    operations: dict[int, Operation]
    uses: Counter[int]
    roots: dict[Node, int]
    cost: Cost


class Constants:
    """What is computed once per parameter set, shared by all functions of a program."""

    def __init__(self, graph: Graph) -> None:
        self.graph = graph
        self.nodes: list[Node] = []
        self._index: dict[Node, int] = {}

    def index(self, node: Node) -> int:
        """Return the place of a node of parameters among the constants."""
        if node not in self._index:
            self._index[node] = len(self.nodes)
            self.nodes.append(node)
        return self._index[node]


@dataclass(slots=True)
class _Table:
    """Operations under construction; values beyond the graph's nodes are those taken out of several expressions."""

    graph: Graph
    hoist: bool
    operations: dict[int, Operation] = field(default_factory=dict)
    shared: dict[Operation, int] = field(default_factory=dict)

    def new(self, operation: Operation) -> int:
        value = self.shared.get(operation)
        if value is None:
            value = self.shared[operation] = BEYOND_THE_GRAPH + len(self.shared)
            self.operations[value] = operation
        return value


def schedule(graph: Graph, roots: Sequence[Node], *, hoist: bool = True) -> Schedule:
    """Choose the operations for some expressions.

    Parameters
    ----------
    hoist
        Whether what is made of parameters only counts as given (in a function of the motion) or is computed here
        (in the function that prepares the parameters).
    """
    table = _Table(graph, hoist)
    values = {root: _value(table, root) for root in roots}
    _share(table, "mul")
    _share(table, "add")
    live = _live(table, values.values())
    uses = Counter(operand for value in live for operand in operands_of(table.operations[value]))
    uses.update(values.values())
    return Schedule({value: table.operations[value] for value in live}, uses, values, _cost(table.operations, live))


def weight(graph: Graph, roots: Sequence[Node]) -> int:
    """Return roughly the time of computing some expressions, in additions, before anything is taken out of several."""
    table = _Table(graph, True)
    values = [_value(table, root) for root in roots]
    return _cost(table.operations, _live(table, values)).weight


def operands_of(operation: Operation) -> Iterator[int]:
    """Return the values an operation uses, as often as it uses them."""
    kind, operands = operation
    if kind == "add":
        yield from (value for value, _ in operands)
    elif kind in ("mul", "inverse", "sqrt"):
        yield from operands
    elif kind == "call":
        yield from operands[1:]


# -- one node ------------------------------------------------------------------------------------------------------


def _value(table: _Table, root: Node) -> int:
    """Return the value of a node, adding to the table what it needs."""
    graph = table.graph
    for node in _needed(table, root):
        if node not in table.operations:
            table.operations[node] = _operation(table, node)
    assert root in table.operations, graph.records[root]
    return root


def _needed(table: _Table, root: Node) -> list[Node]:
    seen: set[Node] = set()
    stack = [root]
    while stack:
        node = stack.pop()
        if node not in seen and node not in table.operations:
            seen.add(node)
            if not _is_constant(table, node):
                stack.extend(table.graph.children(node))
    return sorted(seen)


def _is_constant(table: _Table, node: Node) -> bool:
    return table.hoist and not table.graph.varies(node)


def _operation(table: _Table, node: Node) -> Operation:
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


def _sum(table: _Table, terms: Sequence[tuple[Node, Number]]) -> Operation:
    """A sum, its terms of parameters only made one constant, numeric factors joined to constants."""
    graph = table.graph
    constant = [(node, factor) for node, factor in terms if _is_constant(table, node)]
    if len(constant) > 1 or any(abs(factor) != 1 for _, factor in constant):
        joined = graph.sum(constant)
        terms = [*((n, f) for n, f in terms if not _is_constant(table, n)), (joined, 1)]
        _value(table, joined)
    return _common_factor(table, terms) or _scaled(table, [_joined_factor(table, *term) for term in terms])


def _common_factor(table: _Table, terms: Sequence[tuple[Node, Number]]) -> Operation | None:
    """A sum whose terms have one factor of parameters in common: k f + k g = k (f + g)."""
    graph = table.graph
    if len(terms) < 2 or not table.hoist:
        return None
    split = [graph.split(node) for node, _ in terms]
    common = {constant for constant, _ in split}
    if len(common) != 1 or graph.one in common or any(varying == graph.one for _, varying in split):
        return None
    rest = graph.sum((varying, factor) for (_, varying), (_, factor) in zip(split, terms, strict=True))
    return Operation("mul", tuple(sorted((_value(table, common.pop()), _value(table, rest)))))


def _scaled(table: _Table, terms: list[tuple[int, Number]]) -> Operation:
    if len(terms) == 1 and abs(terms[0][1]) != 1:
        factor = table.new(Operation("number", (terms[0][1],)))
        return Operation("mul", (factor, terms[0][0]))
    return Operation("add", tuple(sorted(terms)))


def _joined_factor(table: _Table, node: Node, factor: Number) -> tuple[int, Number]:
    """Turn factor x (constant x varying) into (factor x constant) x varying."""
    graph = table.graph
    if abs(factor) != 1 and table.hoist and graph.varies(node):
        constant, varying = graph.split(node)
        if constant != graph.one:
            joined = graph.scale(constant, magnitude(factor))
            parts = [_value(table, joined), *_powers(table, varying)]
            return table.new(Operation("mul", tuple(sorted(parts)))), 1 if factor > 0 else -1
    _value(table, node)
    return node, factor


def _powers(table: _Table, node: Node) -> list[int]:
    kind, operands = table.graph.records[node]
    if kind is not Kind.PRODUCT:
        return [_value(table, node)]
    return [part for base, power in operands for part in _power(table, base, power)]


def _product(table: _Table, factors: Sequence[tuple[Node, Number]]) -> Operation:
    """A product, its factors of parameters only made one constant."""
    graph = table.graph
    constant = [(node, power) for node, power in factors if _is_constant(table, node)]
    parts = []
    if constant:
        parts.append(_value(table, graph.product(constant)))
    for node, power in factors:
        if not _is_constant(table, node):
            parts.extend(_power(table, node, power))
    return Operation("mul", tuple(sorted(parts)))


def _power(table: _Table, base: int, power: Number) -> list[int]:
    """Return the factors that make base^power: products, one root and one division at the most."""
    _value(table, base)
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


def _whole_power(table: _Table, base: int, power: int) -> list[int]:
    if power <= 1:
        return [base] * power
    square = table.new(Operation("mul", (base, base)))
    return _whole_power(table, square, power // 2) + [base] * (power % 2)


# -- sharing -------------------------------------------------------------------------------------------------------


def _share(table: _Table, kind: str) -> None:
    """Take out the pair of operands that most products (sums) have in common, until none is left."""
    pairs = _Pairs(table, kind)
    while (pair := pairs.most_frequent()) is not None:
        pairs.take_out(pair)


class _Pairs:
    """Which operations of one kind hold which pairs of operands; the most frequent pair by a lazily cleaned heap."""

    def __init__(self, table: _Table, kind: str) -> None:
        self.table, self.kind = table, kind
        self.holders: dict[Pair, set[int]] = {}
        for value, operation in sorted(table.operations.items()):
            if operation.kind == kind:
                for key in self._keys(operation):
                    self.holders.setdefault(key, set()).add(value)
        self.heap = [(-len(holders), key) for key, holders in self.holders.items() if len(holders) > 1]
        heapify(self.heap)

    def _keys(self, operation: Operation) -> set[Pair]:
        operands = operation.operands
        pairs = combinations(operands, 2)
        if self.kind == "mul":
            return {(a, b, 1) for a, b in pairs}
        return {(a[0], b[0], ratio(b[1], a[1])) for a, b in pairs}

    def most_frequent(self) -> Pair | None:
        """Return the pair that most operations hold, the smallest of several; None if no two share one."""
        while self.heap:
            size, key = self.heap[0]
            held = len(self.holders[key])
            if held == -size:
                return key
            heappop(self.heap)
            if held > 1:
                heappush(self.heap, (-held, key))
        return None

    def take_out(self, key: Pair) -> None:
        """Make a pair one value and put it in place of the two operands wherever they stand together."""
        holders = sorted(self.holders[key])
        pair = self._pair(key)
        value = next((v for v in holders if self.table.operations[v] == pair), None)
        if value is None:
            value = self.table.new(pair)
        for holder in holders:
            if holder != value:
                self._replace(holder, key, value)
        self.holders[key] = set()

    def _replace(self, holder: int, key: Pair, value: int) -> None:
        """Renew what the table and the heap know of one operation."""
        operation = self.table.operations[holder]
        self.table.operations[holder] = smaller = self._replaced(operation, key, value)
        before, after = self._keys(operation), self._keys(smaller)
        for gone in before - after:
            self.holders[gone].discard(holder)
        for new in after - before:
            holders = self.holders.setdefault(new, set())
            holders.add(holder)
            if len(holders) > 1:
                heappush(self.heap, (-len(holders), new))

    def _pair(self, key: Pair) -> Operation:
        if self.kind == "mul":
            return Operation("mul", key[:2])
        return Operation("add", ((key[0], 1), (key[1], key[2])))

    def _replaced(self, operation: Operation, key: Pair, value: int) -> Operation:
        operands = list(operation.operands)
        if self.kind == "mul":
            operands.remove(key[0])
            operands.remove(key[1])
            return Operation("mul", tuple(sorted([*operands, value])))
        factor = dict(operands)[key[0]]
        rest = [(v, f) for v, f in operands if v not in key[:2]]
        return Operation("add", tuple(sorted([*rest, (value, factor)])))


# -- what remains --------------------------------------------------------------------------------------------------


def _live(table: _Table, values: Iterable[int]) -> list[int]:
    """Return what values need, in order of evaluation."""
    order: dict[int, None] = {}
    stack = [(value, False) for value in sorted(set(values), reverse=True)]
    while stack:
        value, ready = stack.pop()
        if value in order:
            continue
        if ready:
            order[value] = None
            continue
        stack.append((value, True))
        stack.extend((operand, False) for operand in operands_of(table.operations[value]) if operand not in order)
    return list(order)


def _cost(operations: dict[int, Operation], values: Iterable[int]) -> Cost:
    cost = Cost()
    for value in values:
        kind, operands = operations[value]
        if kind == "add":
            cost.add += len(operands) - 1
            cost.multiply += sum(abs(factor) != 1 for _, factor in operands)
        elif kind == "mul":
            cost.multiply += len(operands) - 1
        elif kind == "inverse":
            cost.divide += 1
        elif kind == "sqrt":
            cost.root += 1
        elif kind == "call":
            cost.call += 1
    return cost
