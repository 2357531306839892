"""Products and sums that several operations have in common, taken out: the most frequent pair of operands first.

The greedy form of common-subexpression elimination for polynomials (Hosangadi, Fallah & Kastner 2006).
"""

from __future__ import annotations

from heapq import heapify, heappop, heappush
from itertools import combinations
from typing import Any

from .numbers import Number, ratio
from .operations import Operation, Table

Pair = tuple[int, int, Number]
"""Two operands of a product, or of a sum with the ratio of their coefficients."""


def share(table: Table, kind: str) -> None:
    """Take out the pair of operands that most products (sums) have in common, until none is left."""
    pairs = _Pairs(table, kind)
    while (pair := pairs.most_frequent()) is not None:
        pairs.take_out(pair)


class _Pairs:
    """Which operations of one kind hold which pairs of operands; the most frequent pair by a lazily cleaned heap."""

    def __init__(self, table: Table, kind: str) -> None:
        self.table, self.kind = table, kind
        self.holders: dict[Pair, set[int]] = {}
        for value, operation in sorted(table.operations.items()):
            if operation.kind == kind:
                for key in self._keys(operation):
                    self.holders.setdefault(key, set()).add(value)
        self.heap = [(-len(holders), key) for key, holders in self.holders.items() if len(holders) > 1]
        heapify(self.heap)

    def _keys(self, operation: Operation) -> set[Pair]:
        return {self._key(a, b) for a, b in combinations(operation.operands, 2)}

    def _key(self, a: Any, b: Any) -> Pair:
        return (a, b, 1) if self.kind == "mul" else (a[0], b[0], ratio(b[1], a[1]))

    def _keys_with(self, operation: Operation, values: set[int]) -> set[Pair]:
        """Return the pairs of which at least one operand is among some values."""
        operands = operation.operands
        places = [k for k, a in enumerate(operands) if (a if self.kind == "mul" else a[0]) in values]
        return {
            self._key(*(operands[j] for j in sorted((i, k)))) for k in places for i in range(len(operands)) if i != k
        }

    def most_frequent(self) -> Pair | None:
        """Return the pair that most operations hold, the smallest of several; None if no two share one."""
        while self.heap:
            size, key = self.heap[0]
            held = len(self.holders[key])
            if held == -size:
                return key
            heappop(self.heap)
            if held > 1:
                heappush(self.heap, (-held, key))
        return None

    def take_out(self, key: Pair) -> None:
        """Make a pair one value and put it in place of the two operands wherever they stand together."""
        holders = sorted(self.holders[key])
        pair = self._pair(key)
        value = next((v for v in holders if self.table.operations[v] == pair), None)
        if value is None:
            value = self.table.new(pair)
        for holder in holders:
            if holder != value:
                self._replace(holder, key, value)
        self.holders[key] = set()

    def _replace(self, holder: int, key: Pair, value: int) -> None:
        """Renew what the table and the heap know of one operation."""
        operation = self.table.operations[holder]
        self.table.operations[holder] = smaller = self._replaced(operation, key, value)
        before, after = (self._keys_with(one, {*key[:2], value}) for one in (operation, smaller))
        for gone in before - after:
            self.holders[gone].discard(holder)
        for new in after - before:
            holders = self.holders.setdefault(new, set())
            holders.add(holder)
            if len(holders) > 1:
                heappush(self.heap, (-len(holders), new))

    def _pair(self, key: Pair) -> Operation:
        if self.kind == "mul":
            return Operation("mul", key[:2])
        return Operation("add", ((key[0], 1), (key[1], key[2])))

    def _replaced(self, operation: Operation, key: Pair, value: int) -> Operation:
        operands = list(operation.operands)
        if self.kind == "mul":
            operands.remove(key[0])
            operands.remove(key[1])
            return Operation("mul", tuple(sorted([*operands, value])))
        factor = dict(operands)[key[0]]
        rest = [(v, f) for v, f in operands if v not in key[:2]]
        return Operation("add", tuple(sorted([*rest, (value, factor)])))
