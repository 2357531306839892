"""Weights W of the constraint rows in the regularised mass matrix M + A^T W A."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from ..calculus.evaluation import At
from ..graph.rewrite import Substitution
from ..graph.store import Node
from .sample_states import Samples


class Weights:
    """The weight of each row r: 1 / sum_k A_rk^2 / M_kk, summed over the start and a state near it.

    In any units, A^T W A is then as large as the inertia that the row acts on. A coordinate without inertia is assigned
    the inertia of its rows. Parameters, and coordinates that are not angles, stay symbols, so that W varies with
    lengths along the motion. Angles are replaced by numbers, because any single entry vanishes at some angles.
    """

    def __init__(self, samples: Samples) -> None:
        self.samples, self.graph, self.A = samples, samples.graph, samples.A
        M, graph = samples.M, samples.graph
        self.inertia = {k: M[k][k] for k in range(len(M)) if M[k][k] != graph.zero}
        self.places = [(samples.at(values), values) for values in (samples.start, samples.beside)]
        lengths = [name for name in samples.unbounded if name in list(samples.start)[: len(M)]]
        self.edges = list(_edges(lengths, samples))

    def all(self) -> list[Node]:
        """Return W (m,)."""
        weights: dict[int, Node] = {}
        while len(weights) < len(self.A):
            new = {row: w for row in range(len(self.A)) if row not in weights and (w := self.weight(row)) is not None}
            if not new:
                self.inertia = {k: self.inertia.get(k, self.graph.one) for k in range(len(self.A[0]))}
                new = {row: self.graph.one for row in range(len(self.A))
                       if row not in weights and self.weight(row) is None}  # fmt: skip
            weights |= new
            for row, w in new.items():
                self.assign_inertia(row, w)
        return [weights[row] for row in range(len(self.A))]

    def weight(self, row: int) -> Node | None:
        """Return W of a row that acts on inertia; a constant number if the symbolic W is zero or infinite somewhere."""
        terms = list(self._terms(row, self.samples.unbounded))
        if not terms:
            return None
        whole = self.graph.sum((term, 1) for term in terms)
        if not all(0 < at(whole) < math.inf for at in self.edges):
            whole = self.graph.sum((term, 1) for term in self._terms(row, ()))
        return self.graph.power(whole, -1)

    def _terms(self, row: int, symbols: tuple[str, ...]) -> Iterator[Node]:
        """Yield A_rk^2 / M_kk at both states, as functions of parameters and these symbols; time is always a number."""
        for at, values in self.places:
            there = self._put(values, symbols)
            for k, inertia in self.inertia.items():
                square = self.graph.power(self.A[row][k], 2)
                if at(square) > 0 and 0 < at(inertia) < math.inf:
                    yield self.graph.mul(there(square), self.graph.power(there(inertia), -1))

    def _put(self, values: Mapping[str, float], symbols: tuple[str, ...]) -> Substitution:
        time = list(values)[-1]
        numbers = {name: value for name, value in values.items() if name not in symbols or name == time}
        return Substitution(self.graph, {name: self.graph.number(value) for name, value in numbers.items()})

    def assign_inertia(self, row: int, w: Node) -> None:
        """Assign the inertia of a row to its coordinates without inertia."""
        for k, entry in enumerate(self.A[row]):
            if k not in self.inertia and entry != self.graph.zero:
                self.inertia[k] = self.graph.mul(w, self.graph.power(entry, 2))


def _edges(lengths: list[str], samples: Samples) -> Iterator[At]:
    """Yield states in which lengths vanish: all of them, each one alone, and all but one."""
    beside = dict(samples.beside)
    groups = [lengths, *([name] for name in lengths), *([o for o in lengths if o != name] for name in lengths)]
    for group in groups:
        yield samples.at({**beside, **dict.fromkeys(group, 0.0)})
