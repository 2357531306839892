"""Greedy common-subexpression elimination for products and sums (Hosangadi, Fallah & Kastner 2006).

Pairs of operands are extracted, the most frequent pair first.
"""

from __future__ import annotations

from collections.abc import Iterable
from heapq import heapify, heappop, heappush
from itertools import chain, combinations

from ..graph.coefficients import Number, ratio
from .operations import Operation, Table

Pair = tuple[int, int, Number]
"""Two operands of a product, or of a sum with the ratio of their coefficients."""


def share(table: Table, kind: str) -> None:
    """Extract the pair of operands that occurs in most products (sums), repeatedly until no pair occurs twice."""
    pairs = _Pairs(table, kind)
    while (pair := pairs.most_frequent()) is not None:
        pairs.extract(pair)


class _Pairs:
    """The operations of one kind that contain each pair of operands; a heap, updated lazily, orders pairs by number."""

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
        operands = operation.operands
        if self.kind == "mul":
            return {(a, b, 1) for a, b in combinations(operands, 2)}
        return {(a, b, _quotient(g, f)) for (a, f), (b, g) in combinations(operands, 2)}

    def _keys_with(self, operation: Operation, value: int) -> list[Pair]:
        """Return the pairs of an operation that contain the operand `value`, which occurs once."""
        operands = operation.operands
        if self.kind == "mul":
            return [(a, value, 1) if a < value else (value, a, 1) for a in operands if a != value]
        factor = next(f for a, f in operands if a == value)
        return [
            (a, value, _quotient(factor, f)) if a < value else (value, a, _quotient(f, factor))
            for a, f in operands
            if a != value
        ]

    def _occur_once(self, operation: Operation, first: int, second: int, value: int) -> bool:
        """Whether both operands occur once, and their replacement does not occur yet."""
        values = operation.operands if self.kind == "mul" else [a for a, _ in operation.operands]
        return value not in values and values.count(first) == values.count(second) == 1

    def most_frequent(self) -> Pair | None:
        """Return the pair that occurs in most operations, the smallest if several do; None if no pair occurs twice."""
        while self.heap:
            size, key = self.heap[0]
            count = len(self.holders[key])
            if count == -size:
                return key
            heappop(self.heap)
            if count > 1:
                heappush(self.heap, (-count, key))
        return None

    def extract(self, key: Pair) -> None:
        """Make a pair a separate value, and replace both operands by it wherever they occur together."""
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
        """Replace a pair in one operation, and update the table and the heap."""
        operation, (first, second, _) = self.table.operations[holder], key
        self.table.operations[holder] = smaller = self._replaced(operation, key, value)
        gone: Iterable[Pair]
        new: Iterable[Pair]
        if self._occur_once(operation, first, second, value):
            gone = chain(self._keys_with(operation, first), self._keys_with(operation, second))
            new = self._keys_with(smaller, value)
        else:
            before, after = self._keys(operation), self._keys(smaller)
            gone, new = before - after, after - before
        self._update(holder, gone, new)

    def _update(self, holder: int, gone: Iterable[Pair], new: Iterable[Pair]) -> None:
        known = self.holders
        for pair in gone:
            known[pair].discard(holder)
        for pair in new:
            holders = known.get(pair)
            if holders is None:
                known[pair] = {holder}
                continue
            holders.add(holder)
            if len(holders) > 1:
                heappush(self.heap, (-len(holders), pair))

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
        factors = dict(operands)
        factor = factors.pop(key[0])
        del factors[key[1]]
        both = factors.pop(value, 0) + factor  # it may be an operand already
        if both or not factors:
            factors[value] = both
        return Operation("add", tuple(sorted(factors.items())))


def _quotient(first: Number, second: Number) -> Number:
    return 1 if first == second else ratio(first, second)
