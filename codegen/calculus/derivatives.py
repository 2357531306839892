"""Automatic differentiation on the graph: forward mode (along one direction) and reverse mode (of one scalar).

Griewank & Walther, Evaluating Derivatives, 2nd ed., chapters 3.1 and 3.2. Both give expressions of the same graph, so
values and derivatives share common subexpressions.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction

from ..graph.coefficients import Number
from ..graph.fold import Fold
from ..graph.graph import Graph
from ..graph.store import Kind, Node
from ..graph.table_calls import differentiated, orders_of

CHOICES = frozenset({"select", "min", "max"})
STEPS = frozenset({"sign", "floor", "ceil", "step", "<", "<=", ">", ">=", "==", "!=", "and", "or", "not"})
ONE = 1


class Tangent(Fold[Node]):
    """Forward mode: the derivative along the direction symbol -> rate, with all other symbols constant.

    With rate(x_k) = v_k and rate(t) = 1 this is d/dt along the motion: M -> Mdot, A -> Adot, G -> Gdot.
    """

    def __init__(self, graph: Graph, rates: Mapping[str, Node]) -> None:
        super().__init__(graph)
        self._rates = rates

    def _result(self, node: Node) -> Node:
        graph, known = self.graph, self._known
        kind, operands = graph.records[node]
        if kind is Kind.NUMBER:
            return graph.zero
        if kind is Kind.SYMBOL:
            return self._rates.get(operands[0], graph.zero)
        if kind is Kind.SUM:
            return graph.sum((known[child], factor) for child, factor in operands)
        if operands[0] in CHOICES:
            return _chosen(graph, node, known.__getitem__)
        moving = [child for child in graph.children(node) if known[child] != graph.zero]
        return graph.sum((graph.mul(partial(graph, node, child), known[child]), ONE) for child in dict.fromkeys(moving))


def gradient(graph: Graph, root: Node, names: Sequence[str]) -> tuple[Node, ...]:
    """Return d root / d symbol for each name by one reverse sweep.

    The cost is a small multiple of that of root, whatever the number of symbols.
    """
    return _Reverse(graph, names)(root)


class _Reverse:
    """Gradients of nodes: one sweep for the root, and one for each alternative of a select, min or max below it.

    The alternatives need separate sweeps: multiplying the derivative of an alternative that is not chosen by 0 would
    fail where it is undefined, since 0 x NaN is NaN.
    """

    def __init__(self, graph: Graph, names: Sequence[str]) -> None:
        self.graph = graph
        self._sources = tuple(map(graph.symbol, names))
        self._known: dict[Node, tuple[Node, ...]] = {}

    def __call__(self, root: Node) -> tuple[Node, ...]:
        """Return the derivatives of root with respect to the sources."""
        pieces = {piece for node in self.graph.reachable([root], self._known) for piece in self._pieces(node)}
        for node in sorted({*pieces, root} - {*self._known}):  # innermost first
            self._known[node] = self._swept(node)
        return self._known[root]

    def _pieces(self, node: Node) -> tuple[Node, ...]:
        kind, operands = self.graph.records[node]
        return operands[-2:] if kind is Kind.CALL and operands[0] in CHOICES else ()

    def _swept(self, root: Node) -> tuple[Node, ...]:
        if self._pieces(root):
            return tuple(self._of_choice(root))
        graph = self.graph
        moving = _above(graph, graph.reachable([root]), set(self._sources))
        adjoints: dict[Node, list[tuple[Node, Number]]] = {root: [(graph.one, ONE)]}
        result = dict.fromkeys(self._sources, graph.zero)
        for node in sorted(moving, reverse=True):
            adjoint = graph.sum(adjoints.pop(node, ()))
            if node in result:
                result[node] = adjoint
            elif graph.records[node].operands[0] in CHOICES and adjoint != graph.zero:
                for source, slope in zip(self._sources, self._of_choice(node), strict=True):
                    adjoints.setdefault(source, []).append((graph.mul(adjoint, slope), ONE))
            elif adjoint != graph.zero:
                _push(graph, node, adjoint, moving, adjoints)
        return tuple(result[source] for source in self._sources)

    def _of_choice(self, node: Node) -> list[Node]:
        def along(source: int) -> Node:
            return _chosen(self.graph, node, lambda piece: self._known[piece][source])

        return list(map(along, range(len(self._sources))))


def _above(graph: Graph, nodes: Sequence[Node], sources: set[Node]) -> set[Node]:
    """Return the nodes that depend on a source, from nodes in order of evaluation."""
    moving: set[Node] = set()
    for node in nodes:
        if node in sources or any(child in moving for child in graph.children(node)):
            moving.add(node)
    return moving


def _push(graph: Graph, node: Node, adjoint: Node, moving: set[Node], adjoints: dict[Node, list]) -> None:  # type: ignore[type-arg]
    kind, operands = graph.records[node]
    if kind is Kind.SUM:
        for child, factor in operands:
            if child in moving:
                adjoints.setdefault(child, []).append((adjoint, factor))
        return
    for child in dict.fromkeys(graph.children(node)):
        if child in moving:
            adjoints.setdefault(child, []).append((graph.mul(adjoint, partial(graph, node, child)), ONE))


def partial(graph: Graph, node: Node, child: Node) -> Node:
    """Return d node / d child for a product or a call, over all occurrences of child."""
    kind, operands = graph.records[node]
    if kind is Kind.PRODUCT:
        power = dict(operands)[child]
        return graph.scale(graph.product([*operands, (child, -1)]), power)
    places = [place for place, operand in enumerate(operands[1:]) if operand == child]
    return graph.add(*(_partial_of_call(graph, node, operands[0], operands[1:], place) for place in places))


def _partial_of_call(graph: Graph, node: Node, name: str, operands: tuple[Node, ...], place: int) -> Node:
    if name in STEPS:
        return graph.zero
    if orders_of(name):
        return differentiated(graph, node, place)
    if name in ("pow", "atan2"):
        return _partial_of_two(graph, node, name, operands, place)
    return _partial_of_one(graph, node, name, operands[0])


def _chosen(graph: Graph, node: Node, derivative: Callable[[Node], Node]) -> Node:
    """Return the derivative of select, min or max: that of the chosen alternative, or NaN where that is undefined."""
    name, *operands = graph.records[node].operands
    if name == "select":
        condition, yes, no = operands
    else:
        yes, no = operands
        condition = graph.call("<=" if name == "min" else ">=", yes, no)
    ways = [piece if is_undefined(graph, piece) else derivative(piece) for piece in (yes, no)]
    return ways[0] if ways[0] == ways[1] else graph.call("select", condition, *ways)


def is_undefined(graph: Graph, node: Node) -> bool:
    """Whether a node is the number NaN, the value of a Piecewise where no condition holds."""
    kind, operands = graph.records[node]
    return kind is Kind.NUMBER and operands[0] != operands[0]


def _partial_of_two(graph: Graph, node: Node, name: str, operands: tuple[Node, ...], place: int) -> Node:
    first, second = operands
    if name == "pow":
        if place:
            return graph.mul(node, graph.call("log", first))
        return graph.mul(second, graph.call("pow", first, graph.sum([(second, ONE), (graph.one, -ONE)])))
    square = graph.add(graph.power(first, 2), graph.power(second, 2))
    other = graph.negative(first) if place else second
    return graph.mul(other, graph.power(square, -ONE))


def _partial_of_one(graph: Graph, node: Node, name: str, a: Node) -> Node:
    """Return f'(a) for a function of one variable, in terms of f(a) where that saves operations."""
    power, call, number = graph.power, graph.call, graph.number

    def one_and(sign: int, base: Node) -> Node:
        return graph.sum([(graph.one, ONE), (power(base, 2), sign)])

    half = Fraction(-1, 2)
    rules = {
        "sin": lambda: call("cos", a),
        "cos": lambda: graph.negative(call("sin", a)),
        "tan": lambda: one_and(1, node),
        "asin": lambda: power(one_and(-1, a), half),
        "acos": lambda: graph.negative(power(one_and(-1, a), half)),
        "atan": lambda: power(one_and(1, a), -ONE),
        "sinh": lambda: call("cosh", a),
        "cosh": lambda: call("sinh", a),
        "tanh": lambda: one_and(-1, node),
        "asinh": lambda: power(one_and(1, a), half),
        "acosh": lambda: power(graph.sum([(power(a, 2), ONE), (graph.one, -ONE)]), half),
        "atanh": lambda: power(one_and(-1, a), -ONE),
        "exp": lambda: node,
        "log": lambda: power(a, -ONE),
        "abs": lambda: call("sign", a),
        "erf": lambda: graph.mul(number(1.1283791670955126), call("exp", graph.negative(power(a, 2)))),
    }
    return rules[name]()
