"""Hash-consed store of expression nodes: every subexpression is stored once."""

from __future__ import annotations

from collections.abc import Container, Iterable
from enum import Enum
from fractions import Fraction
from typing import NamedTuple

from ..model.table import Table
from .coefficients import Number, exact

Node = int


class Kind(Enum):
    """The kinds of records."""

    NUMBER = "number"
    SYMBOL = "symbol"
    SUM = "sum"
    PRODUCT = "product"
    CALL = "call"


class Record(NamedTuple):
    """One node: its kind and its operands.

    operands : number -> (value,); symbol -> (name,); sum and product -> ((node, number), ...);
    call -> (function, node, ...).
    """

    kind: Kind
    operands: tuple  # type: ignore[type-arg]


class Store:
    """The nodes of a graph: creates numbers, symbols and calls, and answers queries about any node.

    Parameters
    ----------
    parameters
        Names of the symbols that are constant during a run; all other symbols count as varying.
    """

    def __init__(self, parameters: Iterable[str] = ()) -> None:
        self.records: list[Record] = []
        self._index: dict[Record, Node] = {}
        self._depends: list[int] = []
        self._children: list[tuple[Node, ...]] = []
        self._bits: dict[str, int] = {}
        self._parameters = frozenset(parameters)
        self.tables: dict[str, Table] = {}
        self.zero = self.number(0)
        self.one = self.number(1)

    def _intern(self, kind: Kind, operands: tuple, depends: int) -> Node:  # type: ignore[type-arg]
        record = Record(kind, operands)
        node = self._index.get(record)
        if node is None:
            node = self._index[record] = len(self.records)
            self.records.append(record)
            self._depends.append(depends)
            self._children.append(_children(record))
        return node

    def number(self, value: Number) -> Node:
        """Return the node of a number; a whole floating-point number has the node of the integer."""
        if isinstance(value, float) and value.is_integer() and abs(value) < 2**53:
            value = int(value)
        elif isinstance(value, Fraction):
            value = exact(value.numerator, value.denominator)
        return self._intern(Kind.NUMBER, (value, isinstance(value, float)), 0)

    def symbol(self, name: str) -> Node:
        """Return the node of a symbol."""
        bit = 0
        if name not in self._parameters:
            bit = self._bits.setdefault(name, 1 << len(self._bits))
        return self._intern(Kind.SYMBOL, (name,), bit)

    def call(self, function: str, *operands: Node) -> Node:
        """Return function(operands)."""
        return self._intern(Kind.CALL, (function, *operands), self._union(operands))

    # -- queries -----------------------------------------------------------------------------------------------

    def _union(self, nodes: Iterable[Node]) -> int:
        mask = 0
        for node in nodes:
            mask |= self._depends[node]
        return mask

    def varies(self, node: Node) -> bool:
        """Whether node contains any symbol that is not a parameter."""
        return self._depends[node] != 0

    def depends(self, node: Node, name: str) -> bool:
        """Whether node contains this symbol, which must not be a parameter."""
        return bool(self._depends[node] & self._bits.get(name, 0))

    def varies_with(self, node: Node, *names: str) -> bool:
        """Whether node varies, and contains no varying symbols other than these."""
        mask = 0
        for name in names:
            mask |= self._bits.get(name, 0)
        return self.varies(node) and not self._depends[node] & ~mask

    def children(self, node: Node) -> tuple[Node, ...]:
        """Return the operand nodes of node."""
        return self._children[node]

    def reachable(self, roots: Iterable[Node], known: Container[Node] = ()) -> list[Node]:
        """Return all nodes needed for roots in order of evaluation, without known nodes and those only these need."""
        seen: set[Node] = set()
        stack = list(roots)
        while stack:
            node = stack.pop()
            if node not in seen and node not in known:
                seen.add(node)
                stack.extend(self._children[node])
        return sorted(seen)


def _children(record: Record) -> tuple[Node, ...]:
    kind, operands = record
    if kind in (Kind.NUMBER, Kind.SYMBOL):
        return ()
    if kind is Kind.CALL:
        return tuple(operands[1:])
    return tuple(child for child, _ in operands)
