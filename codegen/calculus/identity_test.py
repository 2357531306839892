"""Randomised identity test: detects expressions that are identically zero although their form does not show it.

For an analytic function such as (sin q)^2 + (cos q)^2 - 1, values at a few random points suffice. They do not for a
function that is defined piecewise: sqrt(q^2) - q is zero for positive q only, and Max(0, q - 3) up to 3. Therefore
every root is tested on each of its branches, absolute values with both signs, and the value of any other function
except sin, cos and tan is treated as an independent unknown. An expression that vanishes in all these cases is zero
everywhere. Otherwise, or if there are too many branches to try, it counts as nonzero.
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
"""Numbers of random points at which an expression must vanish: values about 1, from 1e-3 to 1e3, and tiny.

The tiny ones are for functions such as atan(1e6 q), which vary only within 1e-6 of 0."""
ROUNDING = 1e-13
"""A value counts as zero if its ratio to the sum of the absolute values of its terms is at most this."""
MOST_BRANCHES = 64
"""An expression with more combinations of branches counts as nonzero."""
HIGHEST_ROOT = 6
"""Roots of higher degree are treated as independent unknowns."""

SIGN = 0
"""In place of the degree in a Branch: an absolute value or sign, whose branches are the two signs."""

Branch = tuple[Node, int]
"""A root by its base and degree, or an absolute value by its argument and SIGN."""
Value = float | complex
Sized = tuple[Value, float]


class Point(Evaluation[Sized]):
    """Evaluation at a random point: the value of each node, and its size (the sum of the absolute values of its terms).

    Both are NaN where the expression is undefined at this point. Roots of negative numbers are complex, since
    identities hold there too.

    Parameters
    ----------
    sample
        Number of the point, from which its random values follow.
    signs
        Names of symbols known to be positive (1) or negative (-1); all others take either sign.
    branches
        The branch of each root, from 0 (the principal one, and the default) to its degree - 1.
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
    """Return the size of value^power for a value with an error of magnitude x ROUNDING; NaN where it is unknown."""
    if power >= 1:
        return float(magnitude**power)
    if abs(value) > ROUNDING * magnitude:
        return abs(result) * max(1.0, magnitude / abs(value))
    return float((ROUNDING * magnitude) ** power) / ROUNDING if power > 0 else math.nan


def degree_of(power: Number) -> int:
    """Return n for a power k/n; more than HIGHEST_ROOT for a floating-point power."""
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
        """Whether a node is zero wherever it is defined, on all branches; False where that cannot be decided."""
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
        next(ways)  # the principal branches, which self._points have tested already
        points = (Point(self.graph, sample, self._signs, dict(zip(branches, way, strict=True)))
                  for way in ways for sample in (0, NEAR))  # fmt: skip
        return all(_vanishes(point, node) for point in points)

    def _branches(self, root: Node) -> list[Branch]:
        branches: dict[Branch, None] = {}
        for node in self.graph.reachable([root]):
            kind, operands = self.graph.records[node]
            if kind is Kind.CALL and operands[0] in ("abs", "sign"):
                branches[operands[1], SIGN] = None
            elif kind is Kind.PRODUCT:
                roots = ((base, degree_of(power)) for base, power in operands if not self._is_positive(base))
                branches.update(dict.fromkeys(root for root in roots if 1 < root[1] <= HIGHEST_ROOT))
        return list(branches)

    def _is_positive(self, node: Node) -> bool:
        """Whether the form of a node shows that it is positive; only the principal root of such a base is tested."""
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
