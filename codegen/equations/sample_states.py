"""States at which terms are looked at in numbers, and their values there."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from ..calculus.derivatives import Tangent
from ..calculus.error_bound import Rounding
from ..calculus.evaluation import At
from ..graph.graph import Graph
from ..graph.store import Kind, Node

Rows = Sequence[Sequence[Node]]
Numbers = list[list[float]]

POINTS = 24
"""Random states, besides the start, at which ranks are looked at."""
FAR = 1.9
"""How far from the start they are, in parts of what a coordinate is measured by."""


@dataclass(frozen=True)
class Samples:
    """States about the start of a mechanism, each coordinate moved by parts of what it is measured by.

    Coordinates that stand in sines and cosines alone are angles, as far as matters here: any turn of them is a state.
    The others may be lengths in any unit: what they are measured by, follows from what cancels in the constraints.

    start : coordinates and time -> their first values; constants : parameters -> their default values
    """

    graph: Graph
    M: Rows
    A: Rows
    phi: Sequence[Node]
    start: Mapping[str, float]
    constants: Mapping[str, float]

    @cached_property
    def unbounded(self) -> tuple[str, ...]:
        """Coordinates and time, where they stand outside of sines and cosines."""
        roots = [entry for rows in (self.M, self.A) for row in rows for entry in row]
        found, seen = set[str](), set[Node]()
        while roots:
            node = roots.pop()
            if node in seen:
                continue
            seen.add(node)
            kind, operands = self.graph.records[node]
            if kind is Kind.SYMBOL:
                found.add(operands[0])
            elif not (kind is Kind.CALL and operands[0] in ("sin", "cos")):
                roots += self.graph.children(node)
        return tuple(name for name in self.start if name in found)

    def at(self, values: Mapping[str, float]) -> At:
        """Return values of nodes in a state."""
        return At(self.graph, {**values, **self.constants})

    @cached_property
    def beside(self) -> dict[str, float]:
        """A state near the start in which no coordinate is where it was."""
        return {name: value + self.units[name] * (5 + k % 3) / 8 for k, (name, value) in enumerate(self.start.items())}

    @cached_property
    def units(self) -> dict[str, float]:
        """coordinates and time -> what they are measured by: 1 for angles, for lengths what makes up for a row."""
        found = dict.fromkeys(self.start, 1.0)
        for column, name in enumerate(self.start):
            if name in self.unbounded and column < len(self.A[0] if self.A else ()):
                sizes = [abs(self.start[name]), min(self._sizes(column), default=0.0)]
                found[name] = max(sizes) or 1.0
        return found

    def _sizes(self, column: int) -> Iterator[float]:
        """How far a coordinate may go before it alone makes up for the terms of a row, at any turn of the angles."""
        along = Tangent(self.graph, {list(self.start)[column]: self.graph.one})
        for phi, row in zip(self.phi, self.A, strict=False):
            terms = self._turned_sum(self._rounding(phi))
            rates, bends = self._turned_sum(row[column]), self._turned_sum(along(row[column]))
            if 0 < terms < math.inf and 0 < rates < math.inf:
                yield terms / rates
            elif 0 < terms < math.inf and 0 < bends < math.inf:
                yield math.sqrt(terms / bends)

    def _turned_sum(self, node: Node) -> float:
        """The magnitudes of a term at any turn of the angles, added."""
        return math.fsum(abs(place(node)) for place in self._turned)

    @cached_property
    def _rounding(self) -> Rounding:
        return Rounding(self.graph)

    @cached_property
    def _turned(self) -> list[At]:
        """The start with its angles turned anyhow."""
        angles = [name for name in self.start if name not in self.unbounded]
        return [self.at({**self.start, **{name: _drawn(name, seed, math.pi) for name in angles}}) for seed in range(4)]

    def states(self) -> Iterator[dict[str, float]]:
        """The start, states about it by parts of its own numbers, and states about it by numbers of both signs."""
        yield dict(self.start)
        for seed in range(POINTS):
            yield {name: value + self._moved(name, value, seed) for name, value in self.start.items()}

    def _moved(self, name: str, value: float, seed: int) -> float:
        if name not in self.unbounded:
            return _drawn(name, seed, math.pi)
        return _drawn(name, seed, FAR) * (value if seed % 2 else self.units[name])


def _drawn(name: str, seed: int, most: float) -> float:
    return random.Random(f"{name} {seed}").uniform(-most, most)
