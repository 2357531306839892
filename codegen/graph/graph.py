"""Expression graph (DAG) with sums and products in canonical form.

A node is a number, the index of its record. Operands have smaller indices than the nodes built from them, so the order
of indices is an order of evaluation. In canonical form, equal expressions that were built in different ways are one
node:

    sum      ((node, coefficient), ...)   sorted, no node twice, content 1, first coefficient positive, none scaled
    scaled   the sum of one term, which is no number, with a coefficient other than 1
    product  ((node, exponent), ...)      sorted, no node twice, no numeric factor, no factor that can be split further
    call     (function, operands)

The canonical form is idempotent: rebuilding a node from its own operands gives the same node. Sums are simplified by
two rules that are useful for energies of mechanisms: terms that differ only in their parameters are collected,
m1 f + m2 f = (m1 + m2) f, and f sin^2 a + f cos^2 a = f.

Powers have their principal values, and rewrites hold for arguments of either sign: b^p b^q = b^(p + q) always, but
(b^p)^q = b^(p q) only for whole q or -1 < p < 1. (x^2)^(1/2) is |x|, and (x^3)^(1/3) is not x.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import floor

from .coefficients import Number, content, is_whole, ratio, whole_power
from .store import Kind, Node, Store


def _merge(pairs: Iterable[tuple[Node, Number]]) -> dict[Node, Number]:
    merged: dict[Node, Number] = {}
    for node, number in pairs:
        merged[node] = merged.get(node, 0) + number
    return {node: number for node, number in sorted(merged.items()) if number != 0}


class Graph(Store):
    """Expressions in canonical form."""

    def sum(self, terms: Iterable[tuple[Node, Number]]) -> Node:
        """Return sum of coefficient x node."""
        terms = tuple(terms)
        if len(terms) == 1 and terms[0][1] == 1:
            return terms[0][0]
        return self._canonical_sum(self._collected(_merge(self._flat_terms(terms))))

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
        factors = tuple(factor for factor in factors if factor[0] != self.one)
        if len(factors) == 1 and factors[0][1] == 1:
            return factors[0][0]
        coefficient, merged = self._merged_factors(factors)
        return self._scaled(self._canonical_product(merged), coefficient) if coefficient else self.zero

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

    # -- canonical forms ---------------------------------------------------------------------------------------

    def _flat_terms(self, terms: Iterable[tuple[Node, Number]]) -> Iterable[tuple[Node, Number]]:
        """Split numbers and scaled nodes into (node, coefficient); sums of several terms are not flattened."""
        for node, coefficient in terms:
            kind, operands = self.records[node]
            if kind is Kind.NUMBER:
                yield self.one, coefficient * operands[0]
            elif kind is Kind.SUM and len(operands) == 1:
                inner, factor = operands[0]
                yield inner, coefficient * factor
            else:
                yield node, coefficient

    def _collected(self, terms: dict[Node, Number]) -> dict[Node, Number]:
        """Collect terms with equal varying parts, and f sin^2 a + f cos^2 a, until none are left."""
        if len(terms) < 2:
            return terms
        collected = self._collect_parameters(self._collect_pythagoras(terms))
        return terms if collected is terms else self._collected(collected)

    def _collect_pythagoras(self, terms: dict[Node, Number]) -> dict[Node, Number]:
        squares: dict[tuple[str, Node, Node, Number], Node] = {}
        for term, coefficient in terms.items():
            for name, angle, rest in self._squared_sines(term):
                other = squares.get(("cos" if name == "sin" else "sin", angle, rest, coefficient))
                if other is not None:
                    others = [pair for pair in terms.items() if pair[0] not in (term, other)]
                    return self._collect_pythagoras(_merge([*others, *self._flat_terms([(rest, coefficient)])]))
                squares[name, angle, rest, coefficient] = term
        return terms

    def _squared_sines(self, term: Node) -> list[tuple[str, Node, Node]]:
        """Return (sin or cos, angle, rest) for each factor sin(angle)^2 or cos(angle)^2 of a product."""
        kind, factors = self.records[term]
        if kind is not Kind.PRODUCT:
            return []
        squares = []
        for node, exponent in factors:
            inner, operands = self.records[node]
            if exponent == 2 and inner is Kind.CALL and operands[0] in ("sin", "cos"):
                rest = self._canonical_product({other: power for other, power in factors if other != node})
                squares.append((operands[0], operands[1], rest))
        return squares

    def _collect_parameters(self, terms: dict[Node, Number]) -> dict[Node, Number]:
        groups: dict[Node, list[tuple[Node, Node]]] = {}
        for term in terms:
            constant, varying = self.split(term)
            groups.setdefault(varying, []).append((term, constant))
        collected: list[tuple[Node, Number]] = []
        for varying, parts in groups.items():
            if len(parts) == 1 or varying == self.one:
                collected.extend((term, terms[term]) for term, _ in parts)
            else:
                common = self.sum((constant, terms[term]) for term, constant in parts)
                collected.extend(self._flat_terms([(self.mul(common, varying), 1)]))
        return terms if len(collected) == len(terms) else _merge(collected)

    def _canonical_sum(self, terms: dict[Node, Number]) -> Node:
        if not terms:
            return self.zero
        if len(terms) == 1:
            ((node, coefficient),) = terms.items()
            return self._scaled(node, coefficient)
        common = content(tuple(terms.values()))
        primitive = tuple((node, ratio(coefficient, common)) for node, coefficient in terms.items())
        return self._scaled(self._intern(Kind.SUM, primitive, self._union(terms)), common)

    def _scaled(self, node: Node, factor: Number) -> Node:
        """Return factor x node, for a node that is not scaled itself."""
        if factor == 1:
            return node
        if node == self.one:
            return self.number(factor)
        return self._intern(Kind.SUM, ((node, factor),), self._depends[node])

    def _merged_factors(self, factors: Iterable[tuple[Node, Number]]) -> tuple[Number, dict[Node, Number]]:
        """Split factors and merge those with equal bases, until none can be split further.

        Merging may allow a new split: sqrt(S) sqrt(S) is S, which has factors and a coefficient of its own.
        """
        coefficient: Number = 1
        merged: dict[Node, Number] = {}
        pending = list(factors)
        while pending:
            parts = list(merged.items())
            for node, exponent in pending:
                factor, inner = self._factors(node, exponent)
                coefficient = coefficient * factor
                parts.extend(inner)
            merged = _merge(parts)
            pending = [(node, exponent) for node, exponent in merged.items() if self._can_be_split(node, exponent)]
            for node, _ in pending:
                del merged[node]
        return coefficient, merged

    def _can_be_split(self, node: Node, exponent: Number) -> bool:
        kind, operands = self.records[node]
        if kind is Kind.NUMBER or kind is Kind.PRODUCT or kind is Kind.SUM and len(operands) == 1:
            return self._factors(node, exponent) != (1, ((node, exponent),))
        return False

    def _factors(self, node: Node, exponent: Number) -> tuple[Number, tuple[tuple[Node, Number], ...]]:
        """Return node^exponent as a number times ((node, exponent), ...)."""
        kind, operands = self.records[node]
        if is_whole(exponent):
            exponent = int(exponent)
            if kind is Kind.NUMBER:
                return whole_power(operands[0], exponent), ()
            if kind is Kind.SUM and len(operands) == 1:
                ((inner, factor),) = operands
                return whole_power(factor, exponent), self._factors(inner, exponent)[1]
            if kind is Kind.PRODUCT:
                return 1, tuple((inner, power * exponent) for inner, power in operands)
        elif kind is Kind.NUMBER:
            return self._root_of_number(node, operands[0], exponent)
        elif kind is Kind.PRODUCT and len(operands) == 1 and -1 < operands[0][1] < 1:
            ((inner, power),) = operands
            return 1, ((inner, power * exponent),)
        return 1, ((node, exponent),)

    def _root_of_number(
        self, node: Node, value: Number, exponent: Number
    ) -> tuple[Number, tuple[tuple[Node, Number], ...]]:
        """Split the whole part off a fractional power of a number: 2^(3/2) = 2 2^(1/2)."""
        if value == 0 and exponent < 0:
            raise ZeroDivisionError(f"0 to the power {exponent}")
        if value in (0, 1):
            return value, ()
        whole = 0 if isinstance(value, float) else floor(exponent)
        return whole_power(value, whole), ((node, exponent - whole),)

    def _canonical_product(self, factors: dict[Node, Number]) -> Node:
        if not factors:
            return self.one
        if len(factors) == 1:
            ((node, exponent),) = factors.items()
            if exponent == 1:
                return node
        return self._intern(Kind.PRODUCT, tuple(factors.items()), self._union(factors))
