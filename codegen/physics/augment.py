"""What takes the place of a mass matrix that is singular whatever x is, but regular along the constraints.

A quaternion with |q| = 1, a massless coordinate that a constraint holds: M has no inverse, [M A^T; A 0] has one. With
any weights W, as A a + gamma = 0, the same a and lambda solve it with M + A^T W A in place of M and f - A^T W gamma in
place of f (the augmented Lagrangian's matrix). Here it is decided whether that is needed, for which rows and with which
weights.
"""

from __future__ import annotations

import math
import operator
import random
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from ..graph.graph import Graph
from ..graph.rewrite import Substitution
from ..graph.store import Kind, Node

Rows = Sequence[Sequence[Node]]
Numbers = list[list[float]]

POINTS = 12
"""Random states, besides the start, at which ranks are looked at."""
DEPENDENT = 1e-11
"""What is left of a diagonal entry when it is rounding."""
ENOUGH = 0.1
"""Some rows do for all where the least pivot that they leave is this part of the one that all leave."""


FUNCTIONS: Mapping[str, Callable[..., Any]] = {
    "abs": abs, "min": min, "max": max, "sign": lambda a: (a > 0) - (a < 0), "step": lambda a: float(a > 0),
    "select": lambda c, a, b: a if c else b, "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge,
    "==": operator.eq, "!=": operator.ne, "and": lambda a, b: bool(a) and bool(b),
    "or": lambda a, b: bool(a) or bool(b), "not": operator.not_,
}  # fmt: skip
"""What the module math does not have under the same name."""


class At:
    """Values of nodes where symbols have the values given; not a number where they are not defined."""

    def __init__(self, graph: Graph, values: Mapping[str, float]) -> None:
        self.graph, self.values = graph, values
        self._known: dict[Node, float] = {}

    def __call__(self, root: Node) -> float:
        """Return the value of a node."""
        for node in self.graph.reachable([root], self._known):
            self._known[node] = self._guarded(node)
        return self._known[root]

    def _guarded(self, node: Node) -> float:
        try:
            return float(self._evaluate(node))
        except (ArithmeticError, AttributeError, TypeError, ValueError):
            return math.nan

    def _evaluate(self, node: Node) -> Any:
        kind, operands = self.graph.records[node]
        known = self._known
        if kind is Kind.NUMBER:
            return operands[0]
        if kind is Kind.SYMBOL:
            return self.values[operands[0]]
        if kind is Kind.SUM:
            return math.fsum(float(factor) * known[child] for child, factor in operands)
        if kind is Kind.PRODUCT:
            return math.prod(known[child] ** float(power) for child, power in operands)
        name, *arguments = operands
        return (FUNCTIONS.get(name) or getattr(math, name))(*(known[child] for child in arguments))

    def rows(self, rows: Rows) -> Numbers:
        """Return the numbers of a matrix."""
        return [[self(entry) for entry in row] for row in rows]


def weights(graph: Graph, M: Rows, A: Rows, start: Mapping[str, float], constants: Mapping[str, float]) -> list[Node]:
    """Return W (m,): what each row of A is weighed with in M + A^T W A; all zero where M itself is to be factored.

    start : coordinates and time -> their first values; constants : parameters -> their default values
    """
    places = [At(graph, values | dict(constants)) for values in _states(start)]
    masses = [(place, numbers) for place in places if _finite(numbers := place.rows(M))]
    none = [graph.zero] * len(A)
    if not A or not masses or max(_rank(numbers) for _, numbers in masses) == len(M):
        return none
    given = _Weights(graph, M, A, places[0], At(graph, _beside(start) | dict(constants)), start).all()
    augmented = _Augmented([(m, place.rows(A), [place(w) for w in given]) for place, m in masses])
    rows = augmented.enough(sorted(range(len(A)), key=lambda row: sum(entry != graph.zero for entry in A[row])))
    return [given[row] if row in rows else graph.zero for row in range(len(A))]


def _states(start: Mapping[str, float]) -> list[dict[str, float]]:
    """The start, states about it by parts of its own numbers, and states about it by numbers of both signs."""
    states = [dict(start)]
    for seed in range(POINTS):
        draw = {name: random.Random(f"{name} {seed}").uniform(-1.9, 1.9) for name in start}
        unit = {name: value if seed % 2 else 1.0 for name, value in start.items()}
        states.append({name: value + draw[name] * unit[name] for name, value in start.items()})
    return states


def _beside(start: Mapping[str, float]) -> dict[str, float]:
    """A state near the start in which no coordinate is where it was."""
    return {name: value + (5 + k % 3) / 8 for k, (name, value) in enumerate(start.items())}


def _finite(rows: Iterable[Iterable[float]]) -> bool:
    return all(math.isfinite(entry) for row in rows for entry in row)


class _Augmented:
    """M + A^T W A in numbers at several states, with the rows of A that are asked for."""

    def __init__(self, states: Iterable[tuple[Numbers, Numbers, list[float]]]) -> None:
        self.states = [state for state in states if _finite([*state[1], state[2]])]
        self.wholes = [_sum(*state, range(len(state[1]))) for state in self.states]

    def enough(self, rows: Sequence[int]) -> list[int]:
        """Return rows, early ones first, that make up for what M lacks as well as all do; none if all do not."""
        if max(self.soundness(rows), default=0.0) <= DEPENDENT:
            return []
        taken: list[int] = []
        for row in rows:
            if self.do(taken, rows):
                break
            if self.rank([*taken, row]) > self.rank(taken):
                taken.append(row)
        for row in rows:
            if row not in taken and not self.do(taken, rows):
                taken.append(row)
        for row in rows[::-1]:
            if row in taken and self.do(rest := [other for other in taken if other != row], rows):
                taken = rest
        return taken

    def do(self, some: Sequence[int], rows: Sequence[int]) -> bool:
        """Whether some rows do for all, state by state: at another state others may be those that do not."""
        pairs = zip(self.soundness(some), self.soundness(rows), strict=True)
        return all(part >= ENOUGH * whole for part, whole in pairs if whole > DEPENDENT)

    def rank(self, rows: Iterable[int]) -> int:
        return max((_rank(_sum(*state, rows)) for state in self.states), default=0)

    def soundness(self, rows: Iterable[int]) -> list[float]:
        """Return the least pivot of each state, beside what the diagonal is with all rows.

        Beside its own, a row that alone holds a coordinate without inertia looks sound wherever its entry is not 0.
        """
        return [min(_pivots(_sum(*state, rows), whole)) for state, whole in zip(self.states, self.wholes, strict=True)]


def _sum(M: Numbers, A: Numbers, W: Sequence[float], rows: Iterable[int]) -> Numbers:
    made = [list(row) for row in M]
    for row in rows:
        for i, a in enumerate(A[row]):
            for j, b in enumerate(A[row]):
                made[i][j] += W[row] * a * b
    return made


def _rank(M: Numbers) -> int:
    return sum(pivot > DEPENDENT for pivot in _pivots(M))


def _pivots(M: Numbers, whole: Numbers | None = None) -> list[float]:
    """Pivots of a Cholesky factor with the largest first, of M where the diagonal of the whole (or M's own) is of ones."""
    size = [1 / math.sqrt(row[k]) if row[k] > 0 else 0.0 for k, row in enumerate(whole or M)]
    rest = [[a * size[i] * size[j] for j, a in enumerate(row)] for i, row in enumerate(M)]
    left, pivots = set(range(len(M))), []
    while left:
        best = max(sorted(left), key=lambda k: rest[k][k])
        pivots.append(max(rest[best][best], 0.0))
        left.remove(best)
        for i in left:
            for j in left if pivots[-1] > DEPENDENT else ():
                rest[i][j] -= rest[i][best] * rest[best][j] / rest[best][best]
    return pivots


class _Weights:
    """W of each row alone, in parameters: 1 / sum_k A_rk^2 / M_kk at the start and beside it.

    So a row weighs as much as the inertia it acts on, in any units; a coordinate without inertia gets that of the rows
    that hold it.
    """

    def __init__(self, graph: Graph, M: Rows, A: Rows, first: At, second: At, start: Mapping[str, float]) -> None:
        self.graph, self.A = graph, A
        beside = _beside(start)
        self.places = [(first, self._at(start)), (second, self._at(beside))]
        self.inertia = {k: M[k][k] for k in range(len(M)) if M[k][k] != graph.zero}

    def _at(self, values: Mapping[str, float]) -> Substitution:
        return Substitution(self.graph, {name: self.graph.number(value) for name, value in values.items()})

    def all(self) -> list[Node]:
        found: dict[int, Node] = {}
        while len(found) < len(self.A):
            new = {row: w for row in range(len(self.A)) if row not in found and (w := self.weight(row)) is not None}
            if not new:
                self.inertia = {k: self.inertia.get(k, self.graph.one) for k in range(len(self.A[0]))}
                new = {row: self.graph.one for row in range(len(self.A))
                       if row not in found and self.weight(row) is None}  # fmt: skip
            found |= new
            for row, w in new.items():
                self.lend(row, w)
        return [found[row] for row in range(len(self.A))]

    def weight(self, row: int) -> Node | None:
        terms = [(term, 1) for k in self.inertia for term in self._terms(row, k)]
        return self.graph.power(self.graph.sum(terms), -1) if terms else None

    def _terms(self, row: int, k: int) -> Iterable[Node]:
        for at, there in self.places:
            square, inertia = self.graph.power(self.A[row][k], 2), self.inertia[k]
            if at(square) > 0 and 0 < at(inertia) < math.inf:
                yield self.graph.mul(there(square), self.graph.power(there(inertia), -1))

    def lend(self, row: int, w: Node) -> None:
        """Coordinates without inertia in a row get the row's."""
        for k, entry in enumerate(self.A[row]):
            if k not in self.inertia and entry != self.graph.zero:
                self.inertia[k] = self.graph.mul(w, self.graph.power(entry, 2))
