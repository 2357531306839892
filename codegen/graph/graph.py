"""Expressions as a graph in which every subexpression stands once.

A node is a number, the index of its record; operands always have smaller indices than what is made of them, so
that the order of the indices is an order of evaluation. Sums and products are kept in a canonical form, so that
equal expressions built in different ways are one node:

    sum      ((node, coefficient), ...)   sorted, no node twice, content 1, first coefficient positive, none scaled
    scaled   the sum of one term, which is no number, with a coefficient other than 1
    product  ((node, exponent), ...)      sorted, no node twice, no numeric factor, none that comes apart further
    call     (function, operands)

Sums and products are closed: made anew of its own operands, a node is itself. Two rewrites that energies of
mechanisms ask for happen as sums are formed: terms that differ in their parameters only are collected,
m1 f + m2 f = (m1 + m2) f, and sin^2 f + cos^2 f = f.

Powers are the principal ones, so that a rewrite holds for arguments of either sign: b^p b^q = b^(p + q) always,
(b^p)^q = b^(p q) for whole q or -1 < p < 1 only. (x^2)^(1/2) is |x|, and (x^3)^(1/3) is not x.
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

    def _collected(self, terms: dict[Node, Number]) -> dict[Node, Number]:
        """Collect terms with equal varying parts, and sin^2 f + cos^2 f, until there are no more."""
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
                    kept = [pair for pair in terms.items() if pair[0] not in (term, other)]
                    return self._collect_pythagoras(_merge([*kept, *self._flat_terms([(rest, coefficient)])]))
                squares[name, angle, rest, coefficient] = term
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
                rest = self._canonical_product({other: power for other, power in factors if other != node})
                found.append((operands[0], operands[1], rest))
        return found

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
        """Return factor x node for a node that carries no factor of its own."""
        if factor == 1:
            return node
        if node == self.one:
            return self.number(factor)
        return self._intern(Kind.SUM, ((node, factor),), self._depends[node])

    def _merged_factors(self, factors: Iterable[tuple[Node, Number]]) -> tuple[Number, dict[Node, Number]]:
        """Take factors apart and merge equal ones, until none comes apart further.

        A merged exponent may open what was closed: sqrt(S) sqrt(S) is S, with factors and a coefficient of its own.
        """
        coefficient: Number = 1
        merged: dict[Node, Number] = {}
        opened = list(factors)
        while opened:
            parts = list(merged.items())
            for node, exponent in opened:
                factor, inner = self._factors(node, exponent)
                coefficient = coefficient * factor
                parts.extend(inner)
            merged = _merge(parts)
            opened = [(node, exponent) for node, exponent in merged.items() if self._comes_apart(node, exponent)]
            for node, _ in opened:
                del merged[node]
        return coefficient, merged

    def _comes_apart(self, node: Node, exponent: Number) -> bool:
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
        """Take the whole part out of a fractional power: 2^(3/2) = 2 2^(1/2)."""
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
