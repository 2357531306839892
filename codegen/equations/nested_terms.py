"""Terms of the equations of motion as derivatives of energies whose sums are nested."""

from __future__ import annotations

from functools import cached_property

from ..calculus.derivatives import gradient
from ..graph.store import Node
from .terms import HALF, MINUS, ONE, Terms


class NestedTerms(Terms):
    """Terms that follow from T and V by sweeps of automatic differentiation: none is formed from the entries of M.

    A sweep takes a small multiple of the operations of T. M v and dM/dx take n^2 and n^3.
    """

    @cached_property
    def T2(self) -> Node:
        """1/2 v^T M v (4), without first-order states, whose unit masses are auxiliary: T - T1 - T0."""
        states = [self.graph.power(z, 2) for z in self._velocities[len(self.v) - self.mechanics.n_states :]]
        return self.graph.sum([(self.T, ONE), (self.T1, MINUS), (self.T0, MINUS), *((one, -HALF) for one in states)])

    def _rates_of_momentum(self) -> list[list[Node]]:
        """Return Mdot v from dT/dv."""
        return [self._rates_from_T()]

    def _gradients_of_L(self) -> list[tuple[Node, ...]]:
        """Return dL/dx at fixed velocities (10) from T as written, by one reverse sweep."""
        return [gradient(self.graph, self._difference(self.T, self.V), self.x)]
