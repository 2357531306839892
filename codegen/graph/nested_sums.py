"""Nested sums: sums that begin with the same terms share a node for these terms.

SymPy writes the place of the k-th body of a chain as one sum of k terms, so that n bodies need n^2 / 2 of them. Nested,
each place is that of the body before plus one term. Derivatives keep this form: the momenta dT/dv of a chain take a
number of operations proportional to n, and M takes one proportional to n^2, as in recursions from body to body.

The terms of each sum are ordered by the number of sums that contain them, the most frequent one first. Then the sums
form a tree of prefixes (a trie), and each prefix at which sums end or part becomes a node.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from .coefficients import Number, ratio
from .graph import Graph
from .rewrite import Rewriter
from .store import Kind, Node

Term = tuple[Node, Number]


class NestedSums(Rewriter):
    """Rewrites the sums in some nodes as nested sums; other sums are kept.

    Parameters
    ----------
    roots
        The nodes whose sums form the tree of prefixes.
    """

    def __init__(self, graph: Graph, roots: Sequence[Node]) -> None:
        super().__init__(graph)
        self._prefixes = _Prefixes()
        self._paths: dict[Node, list[tuple[int, Term]]] = {}
        self._nodes: dict[int, Node] = {}
        sums = [node for node in graph.reachable(roots) if self._is_sum(node)]
        frequency = Counter(term for node in sums for term, _ in graph.records[node].operands)
        for node in sums:
            terms = sorted(graph.records[node].operands, key=lambda term: (-frequency[term[0]], term[0]))
            self._paths[node] = self._prefixes.add([(term, ratio(factor, terms[0][1])) for term, factor in terms])

    def _is_sum(self, node: Node) -> bool:
        kind, operands = self.graph.records[node]
        return kind is Kind.SUM and len(operands) > 1 and self.graph.varies(node)

    @property
    def are_shared(self) -> bool:
        """Whether sums have terms in common with which they begin."""
        return self._prefixes.are_shared

    def replacement(self, node: Node) -> Node | None:
        """Return a sum as the sum of its longest shared prefix and the other terms."""
        path = self._paths.get(node)
        if path is None:
            return None
        nested, pending = None, []
        for prefix, (term, factor) in path:
            pending.append((self._known[term], factor))
            if self._prefixes.is_node(prefix):
                nested = self._of_prefix(prefix, [*pending, *([(nested, 1)] if nested is not None else ())])
                pending = []
        assert nested is not None, "a sum ends where a prefix does"
        first = path[0][1][0]
        return self.graph.scale(nested, dict(self.graph.records[node].operands)[first])

    def _of_prefix(self, prefix: int, terms: list[Term]) -> Node:
        if prefix not in self._nodes:
            self._nodes[prefix] = self.graph.sum(terms)
        return self._nodes[prefix]


class _Prefixes:
    """A tree of prefixes, which are numbered."""

    def __init__(self) -> None:
        self._next: dict[tuple[int, Term], int] = {}
        self._ways: Counter[int] = Counter()
        self._long: set[int] = set()
        self._ends: set[int] = set()

    def add(self, terms: Sequence[Term]) -> list[tuple[int, Term]]:
        """Add a sequence of terms; return it with the number of the prefix that ends with each."""
        path, prefix = [], 0
        for place, term in enumerate(terms):
            step = (prefix, term)
            if step not in self._next:
                self._next[step] = len(self._next) + 1
                self._ways[prefix] += 1
            prefix = self._next[step]
            if place:
                self._long.add(prefix)
            path.append((prefix, term))
        self._ends.add(prefix)
        return path

    def is_node(self, prefix: int) -> bool:
        """Whether a sum ends with a prefix, or sums part there."""
        return prefix in self._ends or prefix in self._long and self._ways[prefix] > 1

    @property
    def are_shared(self) -> bool:
        """Whether a prefix of two terms or more is a part of two sums."""
        return any(self._ways[prefix] > (prefix not in self._ends) for prefix in self._long)
