"""Time events: the times at which a condition on time alone changes, or at which a function of time has a kink.

They come from Piecewise((F, t < c), (0, True)), Max(0, t - c), Abs, sign, Heaviside and floor (and so Mod). Steps end
at them, because the right-hand side is smooth on either side but not across. A condition changes where the difference
of its two sides vanishes. This is solved for t if it is affine or quadratic in t, a product of such factors, or one
sine, cosine, tangent or exponential of such an argument. Expressions with kinks are solved on all their branches. A
floor is replaced by an integer k, so its times recur: at + k period. Some of the times may not change anything; each
of them costs a step. Conditions that cannot be solved are reported.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import product

from ..calculus.derivatives import STEPS, Tangent
from ..calculus.error_bound import Rounding
from ..graph.fold import Fold
from ..graph.graph import Graph
from ..graph.rewrite import Rewriter, Substitution, rebuilt
from ..graph.store import Kind, Node

COMPARED = frozenset({"<", "<=", ">", ">=", "==", "!=", "min", "max"})
KINKED = frozenset({"abs", "sign", "step"})
WHOLE = frozenset({"floor", "ceil"})
MOST_BRANCHES = 64
"""Conditions with more combinations of branches are not solved."""


@dataclass(frozen=True, slots=True)
class TimeEvent:
    """Times at + k period for integers k; period 0: a single time. The rounding error of `at` is eps times `terms`."""

    at: Node
    period: Node
    terms: Node


class UnsolvedError(Exception):
    """The times of a condition cannot be found."""


class TimeEvents:
    """The time events of expressions.

    times : without duplicates, in the order of the graph's nodes
    unsolved : conditions on time, parameters and inputs alone that cannot be solved for time
    """

    def __init__(self, graph: Graph, time: str, inputs: Sequence[str], roots: Iterable[Node]) -> None:
        self.graph, self.time, self._signals = graph, time, (time, *inputs)
        self._rate = Tangent(graph, {time: graph.one})
        self._terms = Rounding(graph)
        solutions: dict[tuple[Node, Node], None] = {}
        self.unsolved: list[Node] = []
        for node in [node for node in graph.reachable(roots) if self._is_condition(node)]:
            try:
                solutions.update(dict.fromkeys(self._of(node)))
            except (UnsolvedError, ZeroDivisionError):
                self.unsolved.append(node)
        self.times = tuple(TimeEvent(at, period, self._rounding(at)) for at, period in solutions)

    def _rounding(self, at: Node) -> Node:
        """Return `terms` of a time; zero where its derivative is infinite, as for asin(1) and log(0)."""
        try:
            return self._terms(at)
        except ZeroDivisionError:
            return self.graph.zero

    def _is_condition(self, node: Node) -> bool:
        kind, operands = self.graph.records[node]
        if kind is not Kind.CALL or operands[0] not in COMPARED | KINKED | WHOLE:
            return False
        return self.graph.depends(node, self.time) and self.graph.varies_with(node, *self._signals)

    def _of(self, condition: Node) -> list[tuple[Node, Node]]:
        if not self.graph.varies_with(condition, self.time):
            raise UnsolvedError  # an input may change at any time
        graph, (name, *operands) = self.graph, self.graph.records[condition].operands
        changing = operands[0]
        if name in COMPARED:
            changing = graph.add(operands[0], graph.negative(operands[1]))
        if name in WHOLE:
            changing = graph.add(changing, graph.negative(self._whole(condition)))
        ways = _Branches(graph, self.time, self._whole)(changing)
        return [time for way in ways for time in self._zeros(way)]

    def _whole(self, node: Node) -> Node:
        """Return a symbol for the integer value of a floor, or for the number of periods of a periodic function."""
        return self.graph.symbol(f"whole {node}")

    # -- zeros of an expression without kinks: (at, period) --------------------------------------------------------

    def _zeros(self, node: Node) -> list[tuple[Node, Node]]:
        graph = self.graph
        if not graph.depends(node, self.time):
            return []  # floors in it are conditions of their own
        rate = self._rate(node)
        if not graph.depends(rate, self.time):
            return [self._affine(node, rate)]
        kind, operands = graph.records[node]
        if kind is Kind.PRODUCT:
            return [time for base, _ in operands for time in self._zeros(base)]
        second = self._rate(rate)
        if not graph.varies(second):
            return self._quadratic(node, rate, second)
        return self._inverted(node)

    def _at(self, node: Node, **values: Node) -> Node:
        try:
            return Substitution(self.graph, values)(node)
        except ZeroDivisionError as error:
            raise UnsolvedError from error

    def _affine(self, node: Node, rate: Node) -> tuple[Node, Node]:
        """Solve rate t + rest = 0, where rest may be affine in one integer symbol."""
        graph = self.graph
        rest = self._at(node, **{self.time: graph.zero})
        whole = sorted(name for name in self._names(rest) if name.startswith("whole "))
        if graph.varies(rate) or len(whole) > 1:
            raise UnsolvedError
        if not whole:
            return self._ratio(rest, rate), graph.zero
        slope = Tangent(graph, {whole[0]: graph.one})(rest)
        if graph.varies(slope):
            raise UnsolvedError
        return self._ratio(self._at(rest, **{whole[0]: graph.zero}), rate), self._ratio(slope, rate)

    def _ratio(self, rest: Node, rate: Node) -> Node:
        return self.graph.negative(self.graph.mul(rest, self.graph.power(rate, -1)))

    def _names(self, node: Node) -> set[str]:
        records = (self.graph.records[part] for part in self.graph.reachable([node]))
        return {operands[0] for kind, operands in records if kind is Kind.SYMBOL}

    def _quadratic(self, node: Node, rate: Node, second: Node) -> list[tuple[Node, Node]]:
        """Solve second t^2 / 2 + slope t + rest = 0 without cancellation; parameters may make `second` small or 0."""
        graph = self.graph
        slope, rest = (self._at(part, **{self.time: graph.zero}) for part in (rate, node))
        if graph.varies(slope) or graph.varies(rest):
            raise UnsolvedError
        inside = graph.add(graph.power(slope, 2), graph.scale(graph.mul(second, rest), -2))
        root = graph.power(inside, Fraction(1, 2))
        away = graph.call("select", graph.call("<", slope, graph.zero), graph.negative(root), root)
        larger = graph.add(slope, away)
        return [(self._ratio(larger, second), graph.zero), (self._ratio(graph.scale(rest, 2), larger), graph.zero)]

    def _inverted(self, node: Node) -> list[tuple[Node, Node]]:
        """Solve factor f(argument) + rest = 0 for the argument, and then for t."""
        graph, inner = self.graph, self._one_call(node)
        name, argument = graph.records[inner].operands
        place = f"value {inner}"
        outer = Rewriter(graph, {inner: graph.symbol(place)})(node)
        factor = Tangent(graph, {place: graph.one})(outer)
        rest = self._at(outer, **{place: graph.zero})
        if graph.varies(factor) or graph.varies(rest):
            raise UnsolvedError
        value = self._ratio(rest, factor)
        return [time for at in self._arguments(name, value, inner)
                for time in self._zeros(graph.add(argument, graph.negative(at)))]  # fmt: skip

    def _one_call(self, node: Node) -> Node:
        """Return the only outermost call in a sum or product that depends on time."""
        calls, stack = set(), [node]
        while stack:
            part = stack.pop()
            kind = self.graph.records[part].kind
            if kind is Kind.CALL:
                calls.add(part)
            elif kind in (Kind.SUM, Kind.PRODUCT):
                stack.extend(child for child in self.graph.children(part) if self.graph.depends(child, self.time))
            else:
                raise UnsolvedError  # the time itself occurs outside of the call
        if len(calls) != 1:
            raise UnsolvedError
        return calls.pop()

    def _arguments(self, name: str, value: Node, call: Node) -> list[Node]:
        """Return the arguments at which a function has a value; an integer symbol counts the periods."""
        graph = self.graph
        turns = graph.scale(self._whole(call), 2.0 * math.pi)
        if name == "sin":
            once = graph.call("asin", value)
            return [graph.add(once, turns), graph.add(graph.number(math.pi), graph.negative(once), turns)]
        if name == "cos":
            once = graph.call("acos", value)
            return [graph.add(once, turns), graph.add(graph.negative(once), turns)]
        if name == "tan":
            return [graph.add(graph.call("atan", value), graph.scale(turns, Fraction(1, 2)))]
        if name == "exp":
            return [graph.call("log", value)]
        raise UnsolvedError


class _Branches(Fold[tuple[Node, ...]]):
    """The smooth branches of a function of time; raises if there are too many."""

    def __init__(self, graph: Graph, time: str, whole: Callable[[Node], Node]) -> None:
        super().__init__(graph)
        self.time, self.whole = time, whole

    def _result(self, node: Node) -> tuple[Node, ...]:
        ways = tuple(dict.fromkeys(self._ways(node)))
        if len(ways) > MOST_BRANCHES:
            raise UnsolvedError
        return ways

    def _ways(self, node: Node) -> Sequence[Node]:
        graph = self.graph
        kind, operands = graph.records[node]
        if not graph.depends(node, self.time) or kind is Kind.SYMBOL:
            return (node,)
        parts = [self._known[child] for child in graph.children(node)]
        if kind is Kind.CALL and (branches := self._branches(node, operands[0], parts)) is not None:
            return branches
        if math.prod(map(len, parts)) > MOST_BRANCHES:
            raise UnsolvedError
        return [rebuilt(graph, node, way) for way in product(*parts)]

    def _branches(self, node: Node, name: str, parts: list[tuple[Node, ...]]) -> Sequence[Node] | None:
        """Return the branches of a function with kinks or jumps; None for a smooth function."""
        graph = self.graph
        if name == "abs":
            return [way for part in parts[0] for way in (part, graph.negative(part))]
        if name in ("min", "max"):
            return (*parts[0], *parts[1])
        if name == "select":
            return (*parts[1], *parts[2])
        if name in WHOLE:
            return (self.whole(node),)
        if name == "sign":
            return (graph.number(-1), graph.zero, graph.one)
        if name in STEPS:
            return (graph.zero, graph.one, graph.number(Fraction(1, 2)))
        return None
