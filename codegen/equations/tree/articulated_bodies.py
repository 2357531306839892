"""Accelerations of a model whose masses are in trees, by articulated bodies, without forming M."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from ...bodies.scalar import Scalar
from ...calculus.derivatives import Tangent, gradient
from ...graph.graph import Graph
from ...graph.store import Node
from ...model.normalise import ModelError
from ..derive import Mechanics
from .separation import Recursion, Trees

_NAME = "formulation 'articulated_body'"


@dataclass(frozen=True, slots=True)
class ArticulatedBodies:
    """accelerations : (n,) at zero multipliers; rows : (m + r, n) M^-1 P^T, transposed; pivots : (n,), positive."""

    accelerations: tuple[Node, ...]
    rows: tuple[tuple[Node, ...], ...]
    pivots: tuple[Node, ...]


def articulated_bodies(
    mechanics: Mechanics, trees: Trees, forces: Sequence[Node], P: Sequence[Sequence[Node]]
) -> ArticulatedBodies:
    """Return what articulated bodies give under forces (n,) besides those of the trees' own motion and gravity.

    Raises
    ------
    ModelError
        M is singular but for constraints, or another energy couples coordinates; names them.
    """
    if mechanics.augmented:
        raise ModelError(f"model {mechanics.name}: {_NAME} needs a regular M. Choose another formulation.")
    solver = _Solver(mechanics, trees, [Scalar(trees.graph, mass) for mass in armature(mechanics, trees)])
    moving = solver.solved(forces, lambda tree, own, more: tree.dynamics.accelerations(own, tree.gravity, more))
    rows = [solver.solved(row, lambda tree, own, more: tree.dynamics.solved(own, more)) for row in P]
    return ArticulatedBodies(moving, tuple(rows), solver.pivots())


def armature(mechanics: Mechanics, trees: Trees) -> list[Node]:
    """Return the diagonal (n,) of the mass matrix of T', which must have no other entries."""
    graph: Graph = trees.graph
    names = mechanics.coordinate_names
    v = [symbol.name for symbol in mechanics.v]
    momenta = gradient(graph, trees.T, v)
    diagonal = []
    for column, name in enumerate(v):
        along = Tangent(graph, {name: graph.one})
        entries = list(map(along, momenta))
        coupled = [names[row] for row, entry in enumerate(entries) if row != column and entry != graph.zero]
        if coupled:
            raise ModelError(
                f"model {mechanics.name}: {_NAME}: a kinetic energy besides that of the trees couples "
                f"{names[column]} and {coupled[0]}. State that mass as a body of a tree, or choose another formulation."
            )
        diagonal.append(entries[column])
    return diagonal


class _Solver:
    """Solves M a = forces tree by tree; coordinates outside all trees have the masses of `armature`."""

    def __init__(self, mechanics: Mechanics, trees: Trees, armature: Sequence[Scalar]) -> None:
        self.graph, self.trees, self.armature = trees.graph, trees, armature
        self.n = len(mechanics.x)

    def solved(
        self, forces: Sequence[Node], solve: Callable[[Recursion, list[Scalar], list[Scalar]], list[Scalar]]
    ) -> tuple[Node, ...]:
        """Return accelerations (n,)."""
        given = [Scalar(self.graph, force) for force in forces]
        result: list[Node | None] = [None] * self.n
        for tree in self.trees.recursions:
            own, more = ([values[k] for k in tree.numbers] for values in (given, self.armature))
            for k, one in zip(tree.numbers, solve(tree, own, more), strict=True):
                result[k] = one.node
        return tuple((given[k] / self.armature[k]).node if one is None else one for k, one in enumerate(result))

    def pivots(self) -> tuple[Node, ...]:
        """Return the inertia (n,) that each coordinate feels, with the joints further out free."""
        result = [mass.node for mass in self.armature]
        for tree in self.trees.recursions:
            pivots = tree.dynamics.pivots([self.armature[k] for k in tree.numbers])
            for k, pivot in zip(tree.numbers, pivots, strict=True):
                result[k] = pivot.node
        return tuple(result)
