"""Sample states about the initial state, at which ranks of matrices are determined numerically."""

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
"""Number of random states, besides the start."""
FAR = 1.9
"""Largest distance from the start, in units of each coordinate's length scale."""


@dataclass(frozen=True)
class Samples:
    """States about the start of a mechanism, at random distances in proportion to each coordinate's length scale.

    Coordinates that occur only in sines and cosines are treated as angles, which may have any value. The others may be
    lengths in any unit: their scales follow from the terms that cancel in the constraints.

    start : coordinates and time -> their initial values; constants : parameters -> their default values
    """

    graph: Graph
    M: Rows
    A: Rows
    phi: Sequence[Node]
    start: Mapping[str, float]
    constants: Mapping[str, float]

    @cached_property
    def unbounded(self) -> tuple[str, ...]:
        """The coordinates (and time) that occur outside of sines and cosines."""
        roots = [entry for rows in (self.M, self.A) for row in rows for entry in row]
        outside, seen = set[str](), set[Node]()
        while roots:
            node = roots.pop()
            if node in seen:
                continue
            seen.add(node)
            kind, operands = self.graph.records[node]
            if kind is Kind.SYMBOL:
                outside.add(operands[0])
            elif not (kind is Kind.CALL and operands[0] in ("sin", "cos")):
                roots += self.graph.children(node)
        return tuple(name for name in self.start if name in outside)

    def at(self, values: Mapping[str, float]) -> At:
        """Return the evaluation of nodes at a state."""
        return At(self.graph, {**values, **self.constants})

    @cached_property
    def beside(self) -> dict[str, float]:
        """A state near the start, at which every coordinate differs from its initial value."""
        return {name: value + self.units[name] * (5 + k % 3) / 8 for k, (name, value) in enumerate(self.start.items())}

    @cached_property
    def units(self) -> dict[str, float]:
        """coordinates and time -> their scales: 1 for angles; a length from the terms of the constraints otherwise."""
        scales = dict.fromkeys(self.start, 1.0)
        for column, name in enumerate(self.start):
            if name in self.unbounded and column < len(self.A[0] if self.A else ()):
                sizes = [abs(self.start[name]), min(self._lengths(column), default=0.0)]
                scales[name] = max(sizes) or 1.0
        return scales

    def _lengths(self, column: int) -> Iterator[float]:
        """Yield the change of a coordinate that changes phi by the size of its terms, for each phi."""
        along = Tangent(self.graph, {list(self.start)[column]: self.graph.one})
        for phi, row in zip(self.phi, self.A, strict=False):
            terms = self._sum_over_angles(self._rounding(phi))
            first, second = self._sum_over_angles(row[column]), self._sum_over_angles(along(row[column]))
            if 0 < terms < math.inf and 0 < first < math.inf:
                yield terms / first
            elif 0 < terms < math.inf and 0 < second < math.inf:
                yield math.sqrt(terms / second)

    def _sum_over_angles(self, node: Node) -> float:
        """Return the sum of |node| at the start with random angles."""
        return math.fsum(abs(place(node)) for place in self._turned)

    @cached_property
    def _rounding(self) -> Rounding:
        return Rounding(self.graph)

    @cached_property
    def _turned(self) -> list[At]:
        """The start with random angles."""
        angles = [name for name in self.start if name not in self.unbounded]
        return [self.at({**self.start, **{name: _random(name, seed, math.pi) for name in angles}}) for seed in range(4)]

    def states(self) -> Iterator[dict[str, float]]:
        """Yield the start and random states, whose lengths differ in proportion to their start, or to their scale."""
        yield dict(self.start)
        for seed in range(POINTS):
            yield {name: value + self._change(name, value, seed) for name, value in self.start.items()}

    def _change(self, name: str, value: float, seed: int) -> float:
        if name not in self.unbounded:
            return _random(name, seed, math.pi)
        return _random(name, seed, FAR) * (value if seed % 2 else self.units[name])


def _random(name: str, seed: int, most: float) -> float:
    return random.Random(f"{name} {seed}").uniform(-most, most)
