"""Terms of the equations of motion of trees of bodies, by recursions."""

from __future__ import annotations

from functools import cached_property

from ..calculus.derivatives import gradient
from ..graph.graph import Graph
from ..graph.store import Node
from .specialise import Scene
from .terms import Terms
from .trees import Trees


def terms_of(scene: Scene) -> Terms:
    """Return the terms of a scene."""
    return TreeTerms(scene, scene.mechanics.trees) if scene.mechanics.trees else Terms(scene)


class TreeTerms(Terms):
    """Terms of a model with trees: the bias of these by recursive Newton-Euler, that of the other energies by Lagrange.

    No derivatives of M are written, since their number grows as n^3.
    """

    def __init__(self, scene: Scene, trees: Trees) -> None:
        self.trees = trees
        super().__init__(scene)

    def _own_graph(self) -> Graph:
        return self.trees.graph

    @cached_property
    def T2(self) -> Node:
        """Kinetic energy of the trees, and of what else is quadratic in the velocities."""
        rest = self.graph.sum([(self.trees.T, 1), (self.T1, -1), (self.T0, -1)])
        return self.graph.add(self.trees.kinetic_energy(), rest)

    @cached_property
    def bias(self) -> tuple[Node, ...]:
        """(n,) force - Mdot v (11): Q, less the trees' forces at zero accelerations, and what follows from T', V'.

        Where A^T W A is added to M, -A^T W gamma is added to the bias.
        """
        graph, trees = self.graph, self.trees
        slopes = gradient(graph, self._difference(trees.T, trees.V), self.x)
        momenta = gradient(graph, trees.T, self.v)
        forces = tuple(
            graph.sum([(q, 1), (slope, 1), (self.along(p), -1), (tree, -1)])
            for q, slope, p, tree in zip(self.Q, slopes, momenta, trees.bias(len(self.x)), strict=True)
        )
        return self._plus_rows(forces, self.W, self.A, map(graph.negative, self.gamma))

    def _gradients_of_L(self) -> list[tuple[Node, ...]]:
        """Return dL/dx at fixed velocities (10) from T as written, by one reverse sweep."""
        return [gradient(self.graph, self._difference(self.T, self.V), self.x)]
