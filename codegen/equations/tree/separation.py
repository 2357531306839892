"""Trees of bodies in a model's energies: T = T_trees + T', whose parts are derived in different ways."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import sympy

from ...bodies.expansion import Expansion
from ...bodies.recursion import Dynamics
from ...bodies.scalar import Scalar, dot, total
from ...graph.graph import Graph
from ...graph.store import Node
from ...model.recursion_depth import expressions_in
from ...model.statement.mechanism import Mechanism
from ...model.tree.body import coordinates_of
from ...model.tree.functions import BodyFunction
from .link_table import LinkTable, link_table
from .placements import Placement, placements
from .shadow_parameters import rotations


@dataclass(frozen=True, slots=True)
class Recursion:
    """A tree: its recursions, the numbers of its coordinates among those of the model, and gravity (3,) [m / s^2]."""

    dynamics: Dynamics
    numbers: tuple[int, ...]
    gravity: Sequence[Scalar]


@dataclass(frozen=True, slots=True)
class Trees:
    """The trees in the energies of a model.

    graph : that of all terms
    recursions : one for each tree
    placements : all bodies, those that only outputs or drawings contain too
    rotations : modified Rodrigues parameters, three coordinates each, whose shadow set has the same motion
    T, V : the other terms of the energies [J]
    table : if it is there, C adds what the trees contribute to energies, M and bias, and nodes leave it out
    """

    graph: Graph
    recursions: tuple[Recursion, ...]
    placements: tuple[Placement, ...]
    rotations: tuple[tuple[int, ...], ...]
    T: Node
    V: Node
    table: LinkTable | None

    def with_masses(self, M: list[list[Node]]) -> list[list[Node]]:
        """Return M (n, n) with the mass matrices of the trees added, unless C adds them."""
        for tree in () if self.table else self.recursions:
            for row, entries in zip(tree.numbers, tree.dynamics.mass_matrix, strict=True):
                for column, entry in zip(tree.numbers, entries, strict=True):
                    M[row][column] = self.graph.add(M[row][column], entry.node)
        return M

    def forces(self, n: int, accelerations: Sequence[Node] | None = None) -> list[Node]:
        """Return (n,) the forces that the trees take, gravity included, unless C adds them.

        `accelerations` (n,): None for zero.
        """
        forces: list[list[Scalar]] = [[] for _ in range(n)]
        for tree in () if self.table else self.recursions:
            a = None if accelerations is None else [Scalar(self.graph, accelerations[k]) for k in tree.numbers]
            result = tree.dynamics.inverse_dynamics(a, tree.gravity)
            for number, force in zip(tree.numbers, result, strict=True):
                forces[number].append(force)
        return [total(self.graph, terms).node for terms in forces]

    def kinetic_energy(self) -> Node:
        """Return the kinetic energy of the trees [J], unless C adds it."""
        recursions = () if self.table else self.recursions
        return total(self.graph, [tree.dynamics.kinetic_energy for tree in recursions]).node


def separated(
    model: Mechanism, expansion: Expansion, node: Callable[[sympy.Expr], Node], may_loop: bool
) -> Trees | None:
    """Return the trees of a model; None if none of its expressions contains a function of bodies.

    A tree whose kinetic energy is a term of T is derived by recursions, and its gravity too where its potential energy
    is a term of V. All other functions of bodies are written out. `may_loop`: C may compute large trees in loops.
    """
    if not any(one.has(BodyFunction) for one in expressions_in(model)):
        return None
    T, V = _terms(model.kinetic_energy, "kinetic_energy"), _terms(model.potential_energy, "potential_energy")
    falling = {call.quantity.bodies: call for call in V}
    numbers = {q: number for number, q in enumerate(model.coordinates)}
    recursions, used = [], []
    for call in T:
        quantity = call.quantity
        operands = map(node, call.args)
        dynamics = expansion.dynamics(quantity.bodies, dict(zip(quantity.variables, operands, strict=True)))
        gravity = falling.get(quantity.bodies)
        vector = gravity.quantity.vector if gravity else (sympy.S.Zero,) * 3
        used += [gravity] if gravity else []
        own = tuple(numbers[q] for q in coordinates_of(quantity.bodies))
        recursions.append(Recursion(dynamics, own, dynamics.links.scalars(vector)))
    places = placements(model, node)
    kinetic, potential = map(node, (model.kinetic_energy - sympy.Add(*T), model.potential_energy - sympy.Add(*used)))
    rows = len(model.holonomic_constraints) + len(model.nonholonomic_constraints)
    moving = [(tree.dynamics, tree.numbers, tree.gravity) for tree in recursions]
    table = link_table(moving, rows) if may_loop else None
    if table:  # what is fixed to the ground has no row
        grounded = [-dot(tree.dynamics.links.fixed.moment, tree.gravity) for tree in recursions]
        potential = total(expansion.graph, [Scalar(expansion.graph, potential), *grounded]).node
    return Trees(expansion.graph, tuple(recursions), places, rotations(model), kinetic, potential, table)


def masses_in_trees(model: Mechanism) -> bool:
    """Whether the masses are those of trees, and others couple no two coordinates, as articulated bodies need it."""
    trees = _terms(model.kinetic_energy, "kinetic_energy")
    if not trees:
        return False  # every build asks, and to expand an energy in many angles takes long
    rates = {q.diff() for q in model.coordinates}
    others = sympy.Add.make_args(sympy.expand(model.kinetic_energy - sympy.Add(*trees)))
    return all(len(rates & term.atoms(sympy.Derivative)) <= 1 for term in others)


def _terms(energy: sympy.Expr, kind: str) -> list[BodyFunction]:
    """Return the energies of trees that are terms of an energy, with the factor 1 and in their own coordinates."""
    return [
        term
        for term in sympy.Add.make_args(energy)
        if isinstance(term, BodyFunction) and term.quantity.kind == kind and term.args == term.quantity.variables
    ]
