"""Expressions as a graph in which every subexpression stands once.

A node is a number, the index of its record; operands always have smaller indices than what is made of them, so
that the order of the indices is an order of evaluation. Sums and products are kept in a canonical form, so that
equal expressions built in different ways are one node:

    sum      ((node, coefficient), ...)   sorted, no node twice, content 1, first coefficient positive
    scaled   the sum of one term with a coefficient other than 1
    product  ((node, exponent), ...)      sorted, no node twice, no numeric factor
    call     (function, operands)

Two rewrites that energies of mechanisms ask for happen as sums are formed: terms that differ in their parameters
only are collected, m1 f + m2 f = (m1 + m2) f, and sin^2 f + cos^2 f = f.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from enum import Enum
from fractions import Fraction
from math import gcd, lcm
from typing import NamedTuple

Number = int | Fraction | float
Node = int
Terms = tuple[tuple[Node, Number], ...]


class Kind(Enum):
    """What a record is."""

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


def _merge(pairs: Iterable[tuple[Node, Number]]) -> dict[Node, Number]:
    merged: dict[Node, Number] = {}
    for node, number in pairs:
        merged[node] = merged.get(node, 0) + number
    return {node: number for node, number in sorted(merged.items()) if number != 0}


def exact(numerator: int, denominator: int = 1) -> Number:
    """Return a quotient of integers, as an integer where it is one: they are quicker."""
    return numerator // denominator if numerator % denominator == 0 else Fraction(numerator, denominator)


def ratio(first: Number, second: Number) -> Number:
    """Return first / second, exactly unless one of them is a floating-point number."""
    if second == 1:
        return first
    if second == -1:
        return -first
    if isinstance(first, float) or isinstance(second, float):
        return float(first) / float(second)
    quotient = Fraction(first) / Fraction(second)
    return exact(quotient.numerator, quotient.denominator)


def magnitude(number: Number) -> Number:
    """Return |number|."""
    return -number if number < 0 else number


def is_whole(number: Number) -> bool:
    """Whether a number is an integer."""
    return isinstance(number, int) or number == int(number)


def _power_of(base: Number, exponent: Number) -> Number:
    if isinstance(base, float) or not is_whole(exponent):
        return float(base) ** float(exponent) if base not in (0, 1) else base
    power = Fraction(base) ** int(exponent)
    return exact(power.numerator, power.denominator)


def _content(numbers: Sequence[Number]) -> Number:
    """Return the factor that leaves coprime integers, or coefficients of 1, with a positive first one."""
    first = numbers[0]
    sign = -1 if first < 0 else 1
    if all(abs(number) == abs(first) for number in numbers):
        return first
    if any(isinstance(number, float) for number in numbers):
        return sign
    fractions = [Fraction(number) for number in numbers]
    return exact(sign * gcd(*(f.numerator for f in fractions)), lcm(*(f.denominator for f in fractions)))


class Graph:
    """A growing store of shared expressions.

    Parameters
    ----------
    parameters
        Names of the symbols that are constant during a run; all other symbols count as varying.
    """

    def __init__(self, parameters: Iterable[str] = ()) -> None:
        self.records: list[Record] = []
        self._index: dict[Record, Node] = {}
        self._depends: list[int] = []
        self._bits: dict[str, int] = {}
        self._parameters = frozenset(parameters)
        self.zero = self.number(0)
        self.one = self.number(1)

    # -- making nodes ------------------------------------------------------------------------------------------

    def _intern(self, kind: Kind, operands: tuple, depends: int) -> Node:  # type: ignore[type-arg]
        record = Record(kind, operands)
        node = self._index.get(record)
        if node is None:
            node = self._index[record] = len(self.records)
            self.records.append(record)
            self._depends.append(depends)
        return node

    def number(self, value: Number) -> Node:
        """Return the node of a number; exact and floating numbers of one value are one node."""
        if isinstance(value, float) and value.is_integer() and abs(value) < 2**53:
            value = int(value)
        elif isinstance(value, Fraction):
            value = exact(value.numerator, value.denominator)
        return self._intern(Kind.NUMBER, (value, isinstance(value, float)), 0)

    def symbol(self, name: str) -> Node:
        """Return the node of a named quantity."""
        bit = 0
        if name not in self._parameters:
            bit = self._bits.setdefault(name, 1 << len(self._bits))
        return self._intern(Kind.SYMBOL, (name,), bit)

    def call(self, function: str, *operands: Node) -> Node:
        """Return function(operands)."""
        return self._intern(Kind.CALL, (function, *operands), self._union(operands))

    def sum(self, terms: Iterable[tuple[Node, Number]]) -> Node:
        """Return sum of coefficient x node."""
        return self._canonical_sum(_merge(self._collected(self._flat_terms(terms))))

    def add(self, *nodes: Node) -> Node:
        """Return the sum of nodes."""
        return self.sum((node, 1) for node in nodes)

    def scale(self, node: Node, factor: Number) -> Node:
        """Return factor x node."""
        return self.sum(((node, factor),))

    def negative(self, node: Node) -> Node:
        """Return -node."""
        return self.scale(node, -1)

    def mul(self, *nodes: Node) -> Node:
        """Return the product of nodes."""
        return self.product((node, 1) for node in nodes)

    def power(self, base: Node, exponent: Number) -> Node:
        """Return base^exponent."""
        return self.product(((base, exponent),))

    def product(self, factors: Iterable[tuple[Node, Number]]) -> Node:
        """Return the product of node^exponent."""
        coefficient: Number = 1
        flat: list[tuple[Node, Number]] = []
        for node, exponent in factors:
            scale, parts = self._factors(node, exponent)
            coefficient = coefficient * scale
            flat.extend(parts)
        if coefficient == 0:
            return self.zero
        return self._scaled(self._canonical_product(_merge(flat)), coefficient)

    # -- canonical forms ---------------------------------------------------------------------------------------

    def _flat_terms(self, terms: Iterable[tuple[Node, Number]]) -> Iterable[tuple[Node, Number]]:
        """Take numbers and scaled nodes apart; sums of several terms stay whole."""
        for node, coefficient in terms:
            kind, operands = self.records[node]
            if kind is Kind.NUMBER:
                yield self.one, coefficient * operands[0]
            elif kind is Kind.SUM and len(operands) == 1:
                inner, factor = operands[0]
                yield inner, coefficient * factor
            else:
                yield node, coefficient

    def _collected(self, terms: Iterable[tuple[Node, Number]]) -> Terms:
        """Collect terms with equal varying parts, and sin^2 f + cos^2 f."""
        merged = _merge(terms)
        if len(merged) < 2:
            return tuple(merged.items())
        return self._collect_parameters(self._collect_pythagoras(merged))

    def _collect_pythagoras(self, terms: dict[Node, Number]) -> dict[Node, Number]:
        squares: dict[tuple[str, Node, Node, Number], Node] = {}
        for term, coefficient in list(terms.items()):
            for name, angle, rest in self._squared_sines(term):
                other = squares.get(("cos" if name == "sin" else "sin", angle, rest, coefficient))
                if other is None or other not in terms or term not in terms:
                    squares[name, angle, rest, coefficient] = term
                    continue
                del terms[term], terms[other]
                return self._collect_pythagoras(_merge([*terms.items(), *self._flat_terms([(rest, coefficient)])]))
        return terms

    def _squared_sines(self, term: Node) -> list[tuple[str, Node, Node]]:
        """Return (sin or cos, angle, rest) for each factor sin(angle)^2 or cos(angle)^2 of a product."""
        kind, factors = self.records[term]
        if kind is not Kind.PRODUCT:
            return []
        found = []
        for node, exponent in factors:
            inner, operands = self.records[node]
            if exponent == 2 and inner is Kind.CALL and operands[0] in ("sin", "cos"):
                rest = self._canonical_product(_merge([*factors, (node, -2)]))
                found.append((operands[0], operands[1], rest))
        return found

    def _collect_parameters(self, terms: dict[Node, Number]) -> Terms:
        groups: dict[Node, list[tuple[Node, Number]]] = {}
        for term, coefficient in terms.items():
            constant, varying = self.split(term)
            groups.setdefault(varying, []).append((constant, coefficient))
        collected: list[tuple[Node, Number]] = []
        for varying, parts in groups.items():
            if len(parts) == 1 or varying == self.one:
                collected.extend((self._join(constant, varying), coefficient) for constant, coefficient in parts)
            else:
                collected.extend(self._flat_terms([(self.mul(self.sum(parts), varying), 1)]))
        return tuple(collected)

    def _join(self, constant: Node, varying: Node) -> Node:
        return self._canonical_product(_merge([*self._factors(constant)[1], *self._factors(varying)[1]]))

    def _canonical_sum(self, terms: dict[Node, Number]) -> Node:
        if not terms:
            return self.zero
        if len(terms) == 1:
            ((node, coefficient),) = terms.items()
            return self._scaled(node, coefficient)
        content = _content(tuple(terms.values()))
        primitive = tuple((node, ratio(coefficient, content)) for node, coefficient in terms.items())
        return self._scaled(self._intern(Kind.SUM, primitive, self._union(terms)), content)

    def _scaled(self, node: Node, factor: Number) -> Node:
        """Return factor x node for a node that carries no factor of its own."""
        if factor == 1:
            return node
        if node == self.one:
            return self.number(factor)
        return self._intern(Kind.SUM, ((node, factor),), self._depends[node])

    def _factors(self, node: Node, exponent: Number = 1) -> tuple[Number, Iterable[tuple[Node, Number]]]:
        """Return node^exponent as a number times ((node, exponent), ...)."""
        kind, operands = self.records[node]
        integral = is_whole(exponent)
        if kind is Kind.NUMBER and (integral or operands[0] in (0, 1)):
            return _power_of(operands[0], exponent), ()
        if kind is Kind.SUM and len(operands) == 1 and (integral or operands[0][1] > 0):
            inner, factor = operands[0]
            if integral:
                return _power_of(factor, exponent), self._factors(inner, exponent)[1]
        if kind is Kind.PRODUCT and (integral or len(operands) == 1 and not is_whole(operands[0][1])):
            return 1, tuple((inner, power * exponent) for inner, power in operands)
        return 1, ((node, exponent),)

    def _canonical_product(self, factors: dict[Node, Number]) -> Node:
        if not factors:
            return self.one
        if len(factors) == 1:
            ((node, exponent),) = factors.items()
            if exponent == 1:
                return node
        return self._intern(Kind.PRODUCT, tuple(factors.items()), self._union(factors))

    # -- asking about nodes ------------------------------------------------------------------------------------

    def _union(self, nodes: Iterable[Node]) -> int:
        mask = 0
        for node in nodes:
            mask |= self._depends[node]
        return mask

    def varies(self, node: Node) -> bool:
        """Whether node holds any symbol that is not a parameter."""
        return self._depends[node] != 0

    def depends(self, node: Node, name: str) -> bool:
        """Whether node holds the symbol, which is not a parameter."""
        return bool(self._depends[node] & self._bits.get(name, 0))

    def split(self, node: Node) -> tuple[Node, Node]:
        """Return (constant, varying) with node = constant x varying."""
        if not self._depends[node]:
            return node, self.one
        kind, operands = self.records[node]
        if kind is not Kind.PRODUCT:
            return self.one, node
        constant = {factor: power for factor, power in operands if not self._depends[factor]}
        if not constant:
            return self.one, node
        varying = {factor: power for factor, power in operands if self._depends[factor]}
        return self._canonical_product(constant), self._canonical_product(varying)

    def children(self, node: Node) -> tuple[Node, ...]:
        """Return the operands of node that are nodes."""
        kind, operands = self.records[node]
        if kind in (Kind.NUMBER, Kind.SYMBOL):
            return ()
        if kind is Kind.CALL:
            return tuple(operands[1:])
        return tuple(child for child, _ in operands)

    def reachable(self, roots: Iterable[Node]) -> list[Node]:
        """Return every node that roots need, in order of evaluation."""
        seen: set[Node] = set()
        stack = list(roots)
        while stack:
            node = stack.pop()
            if node not in seen:
                seen.add(node)
                stack.extend(self.children(node))
        return sorted(seen)
