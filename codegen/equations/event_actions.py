"""Event actions: impacts and resets; also the multipliers in forces, and the levels of contacts and frictions."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import chain

import sympy

from ..calculus.derivatives import Tangent, gradient
from ..graph.graph import Graph
from ..graph.rewrite import Substitution
from ..graph.store import Node
from ..model.normalise import ModelError, name_of
from ..model.statement.mechanism import Mechanism
from .plain_symbols import Names


@dataclass(frozen=True, slots=True)
class Impact:
    """An impact at event number `event`: the rate of phi, N v + rate, is multiplied by -restitution.

    N : (n,) dphi/dx; rate : dphi/dt
    """

    event: int
    N: tuple[sympy.Expr, ...]
    rate: sympy.Expr
    restitution: sympy.Expr


@dataclass(frozen=True, slots=True)
class Reset:
    """A reset at event number `event`: after (2 n,) is the new x and v, or x and quasi-velocities (3) if `quasi`."""

    event: int
    after: tuple[sympy.Expr, ...]
    quasi: bool


class EventActions:
    """Derivation of a model's event actions, and of the dependence of its forces on multipliers."""

    def __init__(
        self,
        model: Mechanism,
        graph: Graph,
        names: Names,
        node: Callable[[sympy.Expr], Node],
        to_sympy: Callable[[Node], sympy.Expr],
    ) -> None:
        self.model, self.graph, self.names, self.node, self.to_sympy = model, graph, names, node, to_sympy

    @cached_property
    def reaction_rates(self) -> tuple[tuple[int, Node], ...]:
        """The rates of first-order states that depend on multipliers: index among the forces, and rate.

        No force depends on such a rate, so it is evaluated after the multipliers, and need not be linear in them.
        """
        names, first = [symbol.name for symbol in self.names.multipliers], self.model.n - len(self.model.states)
        rates = [(k, self.node(self.model.forces[k])) for k in range(first, self.model.n)]
        return tuple((k, rate) for k, rate in rates if any(self.graph.depends(rate, name) for name in names))

    def forces(self) -> tuple[list[Node], sympy.ImmutableDenseMatrix]:
        """Return Q (n) at zero multipliers, and the transpose (m + r, n) of dQ/d(multipliers, norms of multipliers)."""
        names = [symbol.name for symbol in (*self.names.multipliers, *self.names.norms.values())]
        apart = {k for k, _ in self.reaction_rates}
        Q = [
            self.graph.zero if k in apart else self.node(force.xreplace(self.names.norms))
            for k, force in enumerate(self.model.forces)
        ]
        by = [gradient(self.graph, force, names) for force in Q]
        for x, row in zip(self.model.coordinates, by, strict=True):
            if any(self.graph.depends(entry, name) for entry in row for name in names):
                raise ModelError(
                    f"model {self.model.name}: forces[{name_of(x)}] is not linear in the multipliers; write it as one "
                    "of them times what does not depend on any"
                )
        without = Substitution(self.graph, dict.fromkeys(names, self.graph.zero))
        entries = list(map(self.to_sympy, chain(*by)))
        return list(map(without, Q)), sympy.ImmutableDenseMatrix(len(Q), len(names), entries).T

    def impacts(self) -> Iterator[Impact]:
        """Yield the impacts, in the order of events."""
        names = [x.name for x in self.names.x]
        at_rest = Tangent(self.graph, {self.names.time.name: self.graph.one})
        for number, (_, event) in enumerate(self.model.events):
            if event.impact:
                phi, restitution = map(self.node, event.impact)
                N = tuple(map(self.to_sympy, gradient(self.graph, phi, names)))
                yield Impact(number, N, self.to_sympy(at_rest(phi)), self.to_sympy(restitution))

    def resets(self) -> Iterator[Reset]:
        """Yield the resets, in the order of events."""
        model = self.model
        for number, (_, event) in enumerate(model.events):
            if event.reset:
                after, ys = dict(event.reset), dict(model.quasi_velocities)
                quasi = any(y in after for y in ys)
                after |= {y: after[rate] for y, rate in ys.items() if rate in after}  # a state is both rate and y
                places = (*model.coordinates, *(ys if quasi else model.rates))
                yield Reset(number, tuple(self.to_sympy(self.node(after.get(q, q))) for q in places), quasi)

    def levels(self) -> Iterator[tuple[sympy.Expr, sympy.Expr]]:
        """Yield `level` and `at_rest` of each contact and friction (see `Switch`)."""
        for switch in self.model.switches:
            level, at_rest = (self.to_sympy(self.node(expression)) for expression in (switch.level, switch.at_rest))
            yield level, at_rest
