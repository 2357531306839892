"""Derivatives on the graph, forward (along one direction) and reverse (of one scalar).

Griewank & Walther, Evaluating Derivatives, 2nd ed., chapters 3.1 and 3.2. Both give expressions of the same graph,
so that values and derivatives share what they have in common.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from .graph import Graph, Kind, Node, Number

STEPS = frozenset({"sign", "floor", "ceil", "step", "<", "<=", ">", ">=", "==", "!=", "and", "or", "not"})
ONE = 1


class Tangent:
    """Forward mode: the derivative along symbol -> rate, all other symbols held.

    With rate(x_k) = v_k and rate(t) = 1 this is d/dt along the motion: M -> Mdot, A -> Adot, G -> Gdot.
    """

    def __init__(self, graph: Graph, rates: Mapping[str, Node]) -> None:
        self.graph = graph
        self._rates = rates
        self._known: dict[Node, Node] = {}

    def __call__(self, root: Node) -> Node:
        """Return the node of the derivative of root."""
        for node in self.graph.reachable([root]):
            if node not in self._known:
                self._known[node] = self._tangent(node)
        return self._known[root]

    def _tangent(self, node: Node) -> Node:
        graph, known = self.graph, self._known
        kind, operands = graph.records[node]
        if kind is Kind.NUMBER:
            return graph.zero
        if kind is Kind.SYMBOL:
            return self._rates.get(operands[0], graph.zero)
        if kind is Kind.SUM:
            return graph.sum((known[child], factor) for child, factor in operands)
        moving = [child for child in graph.children(node) if known[child] != graph.zero]
        return graph.sum((graph.mul(partial(graph, node, child), known[child]), ONE) for child in dict.fromkeys(moving))


def gradient(graph: Graph, root: Node, names: Sequence[str]) -> tuple[Node, ...]:
    """Return d root / d symbol for each name by one reverse sweep.

    The cost is a small multiple of that of root itself, however many symbols there are.
    """
    sources = {graph.symbol(name) for name in names}
    moving = _above(graph, graph.reachable([root]), sources)
    adjoints: dict[Node, list[tuple[Node, Number]]] = {root: [(graph.one, ONE)]}
    result = dict.fromkeys(sources, graph.zero)
    for node in sorted(moving, reverse=True):
        adjoint = graph.sum(adjoints.pop(node, ()))
        if node in sources:
            result[node] = adjoint
        elif adjoint != graph.zero:
            _push(graph, node, adjoint, moving, adjoints)
    return tuple(result[graph.symbol(name)] for name in names)


def _above(graph: Graph, nodes: Sequence[Node], sources: set[Node]) -> set[Node]:
    """Return those of the nodes, in order of evaluation, that depend on a source."""
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
    """Return d node / d child for a product or a call, over all places where child stands."""
    kind, operands = graph.records[node]
    if kind is Kind.PRODUCT:
        power = dict(operands)[child]
        return graph.scale(graph.product([*operands, (child, -1)]), power)
    places = [place for place, operand in enumerate(operands[1:]) if operand == child]
    return graph.add(*(_partial_of_call(graph, node, operands[0], operands[1:], place) for place in places))


def _partial_of_call(graph: Graph, node: Node, name: str, operands: tuple[Node, ...], place: int) -> Node:
    if name in STEPS:
        return graph.zero
    if name in ("select", "min", "max"):
        return _partial_of_choice(graph, name, operands, place)
    if name in ("pow", "atan2"):
        return _partial_of_two(graph, node, name, operands, place)
    return _partial_of_one(graph, node, name, operands[0])


def _partial_of_choice(graph: Graph, name: str, operands: tuple[Node, ...], place: int) -> Node:
    if name == "select":
        condition = operands[0]
        ways = {1: (graph.one, graph.zero), 2: (graph.zero, graph.one)}
        return graph.call("select", condition, *ways[place]) if place else graph.zero
    first = graph.call("<=" if name == "min" else ">=", *operands)
    return graph.call("select", first, graph.one, graph.zero) if place == 0 else graph.call(
        "select", first, graph.zero, graph.one
    )  # fmt: skip


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
    """The derivative f'(a) of the functions of one variable, in terms of f(a) where that saves work."""
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
