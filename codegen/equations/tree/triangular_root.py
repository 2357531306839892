"""Triangular root of M of a model whose masses are in trees, without forming M: M = R^T R, eta = R v."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ...bodies.innovations import Innovations
from ...bodies.scalar import HALF, Scalar
from ...calculus.derivatives import Tangent
from ...graph.store import Node
from ...model.normalise import ModelError
from ..derive import Mechanics
from .articulated_bodies import armature
from .separation import Recursion, Trees


def eta_names(mechanics: Mechanics) -> tuple[str, ...]:
    """Return the names (n,) of the quasi-velocities as symbols; no symbol of a user contains a blank."""
    return tuple(f"eta of {symbol.name}" for symbol in mechanics.x)


def has_recursive_root(mechanics: Mechanics) -> bool:
    """Whether the root follows from articulated bodies: trees of independent joints, and M regular."""
    trees = mechanics.trees
    if not (trees and trees.recursions) or mechanics.augmented or any(one.dynamics.shared for one in trees.recursions):
        return False
    try:
        armature(mechanics, trees)
    except ModelError:  # another energy couples coordinates
        return False
    return True


def root_order(mechanics: Mechanics, trees: Trees) -> tuple[int, ...]:
    """Return the coordinates (n,) from the tips of trees inwards, then those outside trees, the last one first.

    The root of M in this order, M = L L^T with L lower triangular, is that of the recursion: L^T = R.
    """
    outwards = [tree.numbers[k] for tree in trees.recursions for body in tree.dynamics.links.moving
                for k in body.numbers]  # fmt: skip
    others = [k for k in range(len(mechanics.x)) if k not in set(outwards)]
    return tuple(reversed([*others, *outwards]))


class RecursiveRoot:
    """The root of M tree by tree; coordinates outside all trees have the masses of `armature`."""

    def __init__(self, mechanics: Mechanics, trees: Trees, along: Tangent) -> None:
        self.graph = trees.graph
        self.armature = [Scalar(self.graph, mass) for mass in armature(mechanics, trees)]
        self.armature_rates = [Scalar(self.graph, along(mass.node)) for mass in self.armature]
        self.eta = [Scalar(self.graph, self.graph.symbol(name)) for name in eta_names(mechanics)]
        self.trees = [(tree, self._innovations(tree)) for tree in trees.recursions]

    def _innovations(self, tree: Recursion) -> Innovations:
        own = ([values[k] for k in tree.numbers] for values in (self.armature, self.armature_rates, self.eta))
        return Innovations(tree.dynamics, *own)

    def _filled(
        self, of_tree: Callable[[Recursion, Innovations], Sequence[Scalar]], other: Callable[[int], Scalar]
    ) -> tuple[Node, ...]:
        """Return (n,): the numbers of each tree, and of the coordinates outside trees."""
        found = {k: one for tree, root in self.trees for k, one in zip(tree.numbers, of_tree(tree, root), strict=True)}
        return tuple((found[k] if k in found else other(k)).node for k in range(len(self.armature)))

    @property
    def pivots(self) -> tuple[Node, ...]:
        """(n,) the inertia that each coordinate feels, positive if M is regular."""
        return self._filled(lambda _, root: root.pivots, lambda k: self.armature[k])

    @property
    def v(self) -> tuple[Node, ...]:
        """(n,) R^-1 eta."""
        return self._filled(lambda _, root: root.v, lambda k: self.eta[k] * self.armature[k] ** -HALF)

    def eta_of(self, v: Sequence[Node]) -> tuple[Node, ...]:
        """Return R v (n,)."""
        given = self._scalars(v)
        return self._filled(lambda tree, root: root.eta_of(_of(tree, given)),
                            lambda k: given[k] * self.armature[k] ** HALF)  # fmt: skip

    def eta_rates(self, forces: Sequence[Node]) -> tuple[Node, ...]:
        """Return the derivative of eta (n,) under forces (n,) besides those of the trees' motion and gravity."""
        given = self._scalars(forces)

        def other(k: int) -> Scalar:
            mass = self.armature[k]
            return given[k] * mass**-HALF + self.eta[k] * self.armature_rates[k] * mass**-1 * HALF

        return self._filled(lambda tree, root: root.eta_rates(_of(tree, given), tree.gravity), other)

    def accelerations(self, forces: Sequence[Node]) -> tuple[Node, ...]:
        """Return the derivative of v (n,) under these forces."""
        given = self._scalars(forces)
        return self._filled(lambda tree, root: root.accelerations(_of(tree, given), tree.gravity),
                            lambda k: given[k] / self.armature[k])  # fmt: skip

    def row(self, forces: Sequence[Node]) -> tuple[Node, ...]:
        """Return R^-T forces (n,)."""
        given = self._scalars(forces)
        return self._filled(lambda tree, root: root.of_forces(_of(tree, given)),
                            lambda k: given[k] * self.armature[k] ** -HALF)  # fmt: skip

    def _scalars(self, nodes: Sequence[Node]) -> list[Scalar]:
        return [Scalar(self.graph, node) for node in nodes]


def _of(tree: Recursion, values: Sequence[Scalar]) -> list[Scalar]:
    return [values[k] for k in tree.numbers]
