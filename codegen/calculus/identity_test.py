"""Numbers for nodes: to tell what vanishes identically although its form does not show it.

A few points tell that a function vanishes where it is analytic: (sin q)^2 + (cos q)^2 - 1. They do not where it is
pieced together: sqrt(q^2) - q is zero for positive q only, and Max(0, q - 3) up to 3. So every root is tried on each
of its branches, absolute values with both signs, and what any other function but sin, cos and tan gives counts as an
unknown of its own. What vanishes all the same does so on every piece; what does not, or what has too many branches
to try, is kept.
"""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Mapping
from fractions import Fraction
from itertools import product

from ..graph.coefficients import Number, is_whole
from ..graph.graph import Graph
from ..graph.store import Kind, Node
from .evaluation import Evaluation

NEAR, FAR, TINY = 3, 2, 1
"""Random points at which an expression must vanish to count as zero: with values about 1, of 1e-3 to 1e3, and tiny.

What turns within 1e-6, such as atan(1e6 q), does not vary elsewhere by more than rounding."""
ROUNDING = 1e-13
"""What counts as cancelled, relative to the sum of the absolute values of the terms."""
MOST_BRANCHES = 64
"""What has more combinations of branches than these is kept."""
HIGHEST_ROOT = 6
"""Roots of higher degree are unknowns of their own."""

SIGN = 0
"""Stands for the degree where a branch is a sign: that of an absolute value."""

Branch = tuple[Node, int]
"""A root, by its base and degree."""
Value = float | complex
Sized = tuple[Value, float]


class Point(Evaluation[Sized]):
    """One random point: value and magnitude (the sum of the absolute terms behind it) of every node asked for.

    Both are not a number where the expression is not defined at this point.
    Roots of negative numbers are complex here: an identity holds there too.

    Parameters
    ----------
    sample
        Which point.
    signs
        Names of symbols known to be positive (1) or negative (-1); all others take either sign.
    branches
        Which of its values a root takes, 0 (the principal one, for those not named) to its degree - 1.
    """

    undefined = math.nan, math.nan

    def __init__(
        self, graph: Graph, sample: int, signs: Mapping[str, int], branches: Mapping[Branch, int] | None = None
    ) -> None:
        super().__init__(graph)
        self._sample, self._signs, self._branches = sample, signs, branches or {}

    def _value(self, node: Node) -> Sized:
        kind, operands = self.graph.records[node]
        known = self._known
        if kind is Kind.NUMBER:
            return float(operands[0]), abs(float(operands[0]))
        if kind is Kind.SYMBOL:
            value = self._symbol(operands[0])
            return value, abs(value)
        if kind is Kind.SUM:
            total: Value = sum((float(factor) * known[child][0] for child, factor in operands), 0.0)
            return total, sum(abs(float(factor)) * known[child][1] for child, factor in operands)
        if kind is Kind.PRODUCT:
            powers = [self._power(child, power) for child, power in operands]
            return math.prod(value for value, _ in powers), math.prod(size for _, size in powers)
        return self._call(node, operands[0], operands[1])

    def _symbol(self, name: str) -> float:
        chance = random.Random(f"{name} {self._sample}")
        if self._sample < NEAR:
            size = chance.uniform(0.4, 1.9)
        else:
            size = 10.0 ** chance.uniform(*((-3, 3) if self._sample < NEAR + FAR else (-9, -6)))
        return size * (self._signs.get(name) or chance.choice((-1, 1)))

    def _power(self, base: Node, power: Number) -> Sized:
        value, magnitude = self._known[base]
        if is_whole(power):
            result: Value = value ** int(power)
        elif (degree := degree_of(power)) <= HIGHEST_ROOT:
            branch = self._branches.get((base, degree), 0)
            root = value ** (1 / degree) * (cmath.exp(2j * cmath.pi * branch / degree) if branch else 1)
            result = root ** int(power * degree)
        else:
            result = self._unknown(f"{base} {power}")
        return result, _size(value, magnitude, float(power), result)

    def _call(self, node: Node, name: str, argument: Node) -> Sized:
        value, magnitude = self._known[argument]
        if name in ("abs", "sign"):
            sign = (-1) ** self._branches.get((argument, SIGN), 0)
            return (sign * value, magnitude) if name == "abs" else (sign, 1.0)
        if name in ("sin", "cos", "tan"):
            result = getattr(cmath if isinstance(value, complex) else math, name)(value)
            steepness = 1.0 if name != "tan" else 1 + abs(result) ** 2
            return result, abs(result) + magnitude * steepness
        unknown = self._unknown(str(node))
        return unknown, abs(unknown)

    def _unknown(self, what: str) -> float:
        return random.Random(f"{what} {self._sample}").uniform(0.4, 1.9)


def _size(value: Value, magnitude: float, power: float, result: Value) -> float:
    """How large value^power may be for a value known to magnitude x rounding; not a number where nobody knows."""
    if power >= 1:
        return float(magnitude**power)
    if abs(value) > ROUNDING * magnitude:
        return abs(result) * max(1.0, magnitude / abs(value))
    return float((ROUNDING * magnitude) ** power) / ROUNDING if power > 0 else math.nan


def degree_of(power: Number) -> int:
    """Return n for a power k/n; what is given in floating point is as good as no root."""
    return HIGHEST_ROOT + 1 if isinstance(power, float) else Fraction(power).denominator


class Zeros:
    """Decides which nodes are identically zero, by their form or at random points (Schwartz 1980, Zippel 1979).

    Parameters
    ----------
    signs
        Names of symbols known to be positive (1) or negative (-1).
    """

    def __init__(self, graph: Graph, signs: Mapping[str, int] | None = None) -> None:
        self.graph = graph
        self._signs = signs or {}
        self._points = [Point(graph, sample, self._signs) for sample in range(NEAR + FAR + TINY)]

    def __call__(self, node: Node) -> bool:
        """Whether a node is zero wherever it is defined, on all its branches; what can not be told counts as not."""
        if node == self.graph.zero:
            return True
        return all(_vanishes(point, node) for point in self._points) and self._on_every_branch(node)

    def equal(self, first: Node, second: Node) -> bool:
        """Whether two nodes have the same values wherever they are defined, on all their branches."""
        return self(self.graph.sum([(first, 1), (second, -1)]))

    def _on_every_branch(self, node: Node) -> bool:
        branches = self._branches(node)
        if math.prod(map(_count, branches)) > MOST_BRANCHES:
            return False
        ways = product(*(range(_count(branch)) for branch in branches))
        next(ways)  # the principal branches are those of the points already tried
        tried = (Point(self.graph, sample, self._signs, dict(zip(branches, way, strict=True)))
                 for way in ways for sample in (0, NEAR))  # fmt: skip
        return all(_vanishes(point, node) for point in tried)

    def _branches(self, root: Node) -> list[Branch]:
        found: dict[Branch, None] = {}
        for node in self.graph.reachable([root]):
            kind, operands = self.graph.records[node]
            if kind is Kind.CALL and operands[0] in ("abs", "sign"):
                found[operands[1], SIGN] = None
            elif kind is Kind.PRODUCT:
                roots = ((base, degree_of(power)) for base, power in operands if not self._is_positive(base))
                found.update(dict.fromkeys(root for root in roots if 1 < root[1] <= HIGHEST_ROOT))
        return list(found)

    def _is_positive(self, node: Node) -> bool:
        """Whether a node is positive by its form: such a base has but its principal root."""
        kind, operands = self.graph.records[node]
        if kind is Kind.NUMBER:
            return bool(operands[0] > 0)
        if kind is Kind.SYMBOL:
            return self._signs.get(operands[0]) == 1
        if kind is Kind.CALL:
            return operands[0] in ("exp", "cosh")
        return all(self._is_positive(child) for child, _ in operands) and (
            kind is Kind.PRODUCT or all(factor > 0 for _, factor in operands))  # fmt: skip


def _count(branch: Branch) -> int:
    return branch[1] or 2


def _vanishes(point: Point, node: Node) -> bool:
    value, size = point(node)
    return abs(value) <= ROUNDING * size
