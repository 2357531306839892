"""Terms of the equations of motion of trees of bodies, by recursions."""

from __future__ import annotations

from functools import cached_property

from ...calculus.derivatives import Tangent, gradient
from ...graph.store import Node
from ..nested_terms import NestedTerms
from ..specialise import Scene
from ..terms import HALF, Terms
from .articulated_bodies import ArticulatedBodies, articulated_bodies
from .separation import Trees
from .triangular_root import RecursiveRoot


def terms_of(scene: Scene) -> Terms:
    """Return the terms of a scene."""
    mechanics = scene.mechanics
    if mechanics.trees:
        return TreeTerms(scene, mechanics.trees)
    return NestedTerms(scene) if mechanics.graph else Terms(scene)


class TreeTerms(NestedTerms):
    """Terms of a model with trees: the bias of these by recursive Newton-Euler, that of the other energies by Lagrange.

    No derivatives of M are written, since their number grows as n^3.
    """

    def __init__(self, scene: Scene, trees: Trees) -> None:
        self.trees = trees
        super().__init__(scene)

    @cached_property
    def T2(self) -> Node:
        """1/2 v^T M v (4), without first-order states, whose unit masses are auxiliary: T_trees + T' - T1 - T0."""
        states = [self.graph.power(z, 2) for z in self._velocities[len(self.v) - self.mechanics.n_states :]]
        rest = self.graph.sum([(self.trees.T, 1), (self.T1, -1), (self.T0, -1), *((one, -HALF) for one in states)])
        return self.graph.add(self.trees.kinetic_energy(), rest)

    @cached_property
    def loads(self) -> tuple[Node, ...]:
        """(n,) force - Mdot v (11): Q, less the trees' forces at zero accelerations, and what follows from T', V'."""
        of_trees = self.trees.forces(len(self.x))
        return tuple(self._difference(one, tree) for one, tree in zip(self.forces, of_trees, strict=True))

    @cached_property
    def required(self) -> tuple[Node, ...]:
        """(n,) the forces that must act besides, for accelerations a: recursive Newton-Euler, without M."""
        accelerations = self._accelerations
        of_trees = self.trees.forces(len(self.x), accelerations)
        rates = dict(zip(self.v, accelerations, strict=True)) | dict(zip(self.x, self._velocities, strict=True))
        forces = self._forces(Tangent(self.graph, rates | {self.mechanics.time.name: self.graph.one}))
        return tuple(self._difference(tree, one) for one, tree in zip(forces, of_trees, strict=True))

    @cached_property
    def forces(self) -> tuple[Node, ...]:
        """(n,) Q + d(T' - V')/dx - d/dt dT'/dv at zero accelerations: all forces but those of the trees."""
        return self._forces(self.along)

    def _forces(self, along: Tangent) -> tuple[Node, ...]:
        """Return `forces` with d/dt along the direction given."""
        graph, trees = self.graph, self.trees
        slopes = gradient(graph, self._difference(trees.T, trees.V), self.x)
        momenta = gradient(graph, trees.T, self.v)
        return tuple(
            graph.sum([(q, 1), (slope, 1), (along(p), -1)]) for q, slope, p in zip(self.Q, slopes, momenta, strict=True)
        )

    @property
    def _energies(self) -> tuple[Node, ...]:
        """T' and V': those of the trees contain no input."""
        return self.trees.T, self.trees.V

    @cached_property
    def yielded(self) -> ArticulatedBodies:
        """Accelerations and M^-1 P^T by articulated bodies."""
        return articulated_bodies(self.mechanics, self.trees, self.forces, self.P)

    @cached_property
    def root(self) -> RecursiveRoot:
        """The triangular root of M by articulated bodies, at eta."""
        return RecursiveRoot(self.mechanics, self.trees, self.along)

    @cached_property
    def root_loads(self) -> tuple[Node, ...]:
        """(m,) A v' + gamma at zero multipliers (39), with v' by the root."""
        a = self.root.accelerations(self.forces) if self.A else ()
        return tuple(self.graph.add(self.dot(row, a), gamma) for row, gamma in zip(self.A, self.gamma, strict=True))
