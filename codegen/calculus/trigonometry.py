"""Addition theorems: sines and cosines of sums of angles from those of the summands, where that is cheaper."""

from __future__ import annotations

from collections.abc import Sequence

from ..graph.coefficients import Number, magnitude
from ..graph.graph import Graph
from ..graph.rewrite import Rewriter
from ..graph.store import Kind, Node

SINE_AND_COSINE = 20
"""Cost of sin and cos of one angle, in multiplications."""
ADDITION_THEOREM = 6
"""Cost of sin(a + b) and cos(a + b) from those of a and b: four multiplications, two additions."""

Parts = tuple[tuple[Node, Number], ...]


def expansion(graph: Graph, roots: Sequence[Node]) -> Rewriter:
    """Return the rewriter that applies the addition theorems to sums of angles where that makes the roots cheaper.

    The decision is made for groups of angles with common parts. n link angles and their n (n - 1) / 2 differences need
    only n pairs of sin and cos; a single difference needs one pair, and its expansion would need two.
    """
    angles = _angles(graph, roots)
    sums = {angle: parts for angle in angles if len(parts := _parts(graph, angle)) > 1}
    single = {_parts(graph, angle)[0][0] for angle in angles if angle not in sums}
    chosen: set[Node] = set()
    for group in _groups(sums):
        if _parts_are_cheaper({angle: sums[angle] for angle in group}, single):
            chosen.update(group)
    return _Expansion(graph, {angle: sums[angle] for angle in chosen})


def _angles(graph: Graph, roots: Sequence[Node]) -> list[Node]:
    calls = (graph.records[node] for node in graph.reachable(roots) if graph.varies(node))
    return sorted({call.operands[1] for call in calls if call.kind is Kind.CALL and call.operands[0] in ("sin", "cos")})


def _parts(graph: Graph, angle: Node) -> Parts:
    """Return an angle as ((part, sign), ...); numeric factors belong to the parts."""
    terms = _terms(graph, angle, 1)
    return tuple((graph.scale(node, magnitude(factor)), 1 if factor > 0 else -1) for node, factor in terms)


def _terms(graph: Graph, node: Node, factor: Number) -> list[tuple[Node, Number]]:
    kind, operands = graph.records[node]
    if kind is not Kind.SUM:
        return [(node, factor)]
    return [term for child, inner in operands for term in _terms(graph, child, factor * inner)]


def _groups(sums: dict[Node, Parts]) -> list[list[Node]]:
    """Return the angles in groups that are connected by common parts."""
    groups: list[tuple[set[Node], list[Node]]] = []
    for angle, parts in sums.items():
        summands, members = {part for part, _ in parts}, [angle]
        for other in [group for group in groups if group[0] & summands]:
            groups.remove(other)
            summands, members = summands | other[0], other[1] + members
        groups.append((summands, members))
    return [members for _, members in groups]


def _parts_are_cheaper(sums: dict[Node, Parts], single: set[Node]) -> bool:
    new = {part for parts in sums.values() for part, _ in parts} - single
    theorems = sum(len(parts) - 1 for parts in sums.values())
    return len(new) * SINE_AND_COSINE + theorems * ADDITION_THEOREM < len(sums) * SINE_AND_COSINE


class _Expansion(Rewriter):
    """Replaces sin and cos of the chosen sums."""

    def __init__(self, graph: Graph, chosen: dict[Node, Parts]) -> None:
        super().__init__(graph)
        self._chosen = chosen
        self._expanded: dict[Parts, tuple[Node, Node]] = {}

    def replacement(self, node: Node) -> Node | None:
        """Return the expansion of sin or cos of a chosen angle."""
        kind, operands = self.graph.records[node]
        if kind is not Kind.CALL or operands[0] not in ("sin", "cos") or operands[1] not in self._chosen:
            return None
        return self._sine_and_cosine(self._chosen[operands[1]])[operands[0] == "cos"]

    def _sine_and_cosine(self, parts: Parts) -> tuple[Node, Node]:
        """Return (sin, cos) of a sum, built from the left so that sums with a common prefix share its nodes."""
        if parts not in self._expanded:
            self._expanded[parts] = self._of_one(*parts[0]) if len(parts) == 1 else self._of_two(parts)
        return self._expanded[parts]

    def _of_one(self, part: Node, sign: Number) -> tuple[Node, Node]:
        graph = self.graph
        return graph.scale(graph.call("sin", part), sign), graph.call("cos", part)

    def _of_two(self, parts: Parts) -> tuple[Node, Node]:
        graph = self.graph
        (sin_a, cos_a), (sin_b, cos_b) = self._sine_and_cosine(parts[:-1]), self._of_one(*parts[-1])
        sine = graph.add(graph.mul(sin_a, cos_b), graph.mul(cos_a, sin_b))
        cosine = graph.add(graph.mul(cos_a, cos_b), graph.negative(graph.mul(sin_a, sin_b)))
        return sine, cosine
