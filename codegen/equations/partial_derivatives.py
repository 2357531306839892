"""Partial derivatives of the terms of the equations of motion, as nodes of their graph.

The derivatives of a and lambda follow from those, at fixed a and lambda, of

    r = M a + P^T (lambda, rho) - bias,  s = A a + gamma                                                      (11) (39)

because r and s vanish along the motion: M da + P^T dlambda = -dr and A da = -ds. All entries share subexpressions. They
are computed in forward mode, column by column, or in reverse mode, row by row, whichever costs fewer operations.

At a kink the derivative is one-sided: at x = 0, |x| and sign(x) have the derivatives of x > 0; Piecewise has that of
the piece that applies, and Min and Max that of the first of equal arguments.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from ..calculus.derivatives import Tangent, gradient
from ..graph.rewrite import Rewriter
from ..graph.store import Kind, Node
from ..schedule.schedule import weight
from .terms import Rows, Terms

MANY = 500
"""With more nodes than this, only reverse mode is tried: it is then cheaper, and forming both is slow."""


class Partials:
    """Rows of partial derivatives with respect to any choice of symbols."""

    def __init__(self, terms: Terms) -> None:
        self.terms = terms
        mechanics = terms.scene.mechanics
        self.state = (*terms.x, *terms.v)
        self.forcing = (
            *(symbol.name for symbol in mechanics.inputs),
            *(symbol.name for symbol in mechanics.parameters),
            mechanics.time.name,
        )
        self.solved = tuple(symbol.name for symbol in (*mechanics.accelerations, *mechanics.multipliers))
        self._sided = _Sided(terms.graph)

    @cached_property
    def residual(self) -> tuple[Node, ...]:
        """(n + m,) r, followed by s."""
        terms, graph = self.terms, self.terms.graph
        a = list(map(graph.symbol, self.solved[: terms.scene.n]))
        return self._with_reactions([terms.dot(row, a) for row in terms.factored], terms.bias)

    @cached_property
    def equations(self) -> tuple[Node, ...]:
        """(n + m,) r with M itself, also where M + A^T W A is factored, followed by s."""
        return self._with_reactions(self.terms.required, [self.terms.graph.zero] * self.terms.scene.n)

    def _with_reactions(self, inertial: Sequence[Node], bias: Sequence[Node]) -> tuple[Node, ...]:
        """(n + m,) inertial + P^T (lambda, rho) - bias, less the rates that depend on multipliers, followed by s."""
        terms, graph = self.terms, self.terms.graph
        pushing = [*map(graph.symbol, self.solved[terms.scene.n :]), *terms.norms]
        balance = [
            graph.add(inertial[k], terms.dot((row[k] for row in terms.P), pushing), graph.negative(bias[k]))
            for k in range(len(inertial))
        ]
        for (k, _), rate in zip(terms.mechanics.reaction_rates, terms.reaction_rates, strict=True):
            balance[k] = graph.add(balance[k], graph.negative(rate))
        return *balance, *terms.row_accelerations

    @cached_property
    def impact_balance(self) -> tuple[Node, ...]:
        """(n + m,) M a + A^T lambda, followed by A a; at an impact a is the change of velocity, lambda the impulses."""
        terms, graph = self.terms, self.terms.graph
        n, m = terms.scene.n, terms.scene.m
        a, multipliers = (list(map(graph.symbol, names)) for names in (self.solved[:n], self.solved[n:]))
        balance = [
            graph.add(terms.dot(terms.factored[k], a), terms.dot((terms.A[row][k] for row in range(m)), multipliers))
            for k in range(n)
        ]
        return *balance, *(terms.dot(row, a) for row in terms.A)

    @cached_property
    def constraints(self) -> tuple[Node, ...]:
        """(h + m,) phi, followed by A v + b."""
        terms, graph = self.terms, self.terms.graph
        v = list(map(graph.symbol, terms.v))
        return *terms.phi, *(graph.add(terms.dot(row, v), b) for row, b in zip(terms.A, terms.b, strict=True))

    def of(self, roots: Sequence[Node], names: Sequence[str]) -> Rows:
        """Return d root / d symbol, (roots, names)."""
        graph = self.terms.graph
        expanded = [self._sided(self.terms.expanded(root)) for root in roots]
        reverse = tuple(gradient(graph, root, names) for root in expanded)
        if len(graph.reachable(expanded)) > MANY:
            return reverse
        along = [Tangent(graph, {name: graph.one}) for name in names]
        forward = tuple(tuple(rate(root) for rate in along) for root in expanded)
        return min(reverse, forward, key=lambda rows: weight(graph, [entry for row in rows for entry in row]))


class _Sided(Rewriter):
    """Rewrites |a| as a or -a and sign(a) as 1 or -1, so that derivatives at 0 are one-sided, not the mean of both."""

    def replacement(self, node: Node) -> Node | None:
        """Return the replacement of |a| or sign(a)."""
        kind, operands = self.graph.records[node]
        if kind is not Kind.CALL or operands[0] not in ("abs", "sign"):
            return None
        a = self(operands[1])
        one = a if operands[0] == "abs" else self.graph.one
        return self.graph.call("select", self.graph.call(">=", a, self.graph.zero), one, self.graph.negative(one))
