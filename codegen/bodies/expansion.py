"""Functions of bodies in expressions, written out as nodes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import sympy

from ..calculus.derivatives import Tangent
from ..graph.graph import Graph
from ..graph.rewrite import Substitution
from ..graph.store import Kind, Node
from ..model.tree.body import Link, coordinates_of, rate_of
from ..model.tree.functions import BodyFunction
from ..model.tree.quantity import Quantity
from .frames import applied, transposed
from .links import Links
from .recursion import Dynamics
from .scalar import Scalar, Vector, cross, plus

Nodes = Mapping[sympy.Expr, Node]


class Expansion:
    """Writes quantities of bodies as nodes of one graph; those of a tree and of chains in it share their recursions."""

    def __init__(self, graph: Graph) -> None:
        self.graph = graph
        self._known: dict[tuple[tuple[Link, ...], tuple[Node, ...]], tuple[Nodes, Dynamics]] = {}
        self._derivatives: dict[tuple[Node, str], Node] = {}

    def __call__(self, call: BodyFunction, operands: Sequence[Node]) -> Node:
        """Return the node of a call from those of its arguments."""
        quantity = call.quantity
        named = [self.graph.records[node].kind is Kind.SYMBOL for node in operands]
        own = all(node == self.graph.symbol(one.name) for one, node in zip(quantity.variables, operands, strict=True)
                  if isinstance(one, sympy.Symbol))  # fmt: skip
        if own and all(named) and len(set(operands)) == len(operands):
            return self._derived(call, operands)
        names = [one.name if isinstance(one, sympy.Symbol) else f"{quantity.label}.{k}"
                 for k, one in enumerate(quantity.variables)]  # fmt: skip
        node = self._derived(call, [self.graph.symbol(name) for name in names])
        return Substitution(self.graph, dict(zip(names, operands, strict=True)))(node)

    def _derived(self, call: BodyFunction, operands: Sequence[Node]) -> Node:
        node = self.quantity(call.quantity, operands)
        for operand, order in zip(operands, call.orders, strict=True):
            for _ in range(order):
                node = self._derivative(node, self.graph.records[operand].operands[0])
        return node

    def _derivative(self, node: Node, name: str) -> Node:
        known = self._derivatives.get((node, name))
        if known is None:
            known = self._derivatives[node, name] = Tangent(self.graph, {name: self.graph.one})(node)
        return known

    def quantity(self, quantity: Quantity, operands: Sequence[Node]) -> Node:
        """Return the node of a quantity at these values of its variables."""
        nodes = dict(zip(quantity.variables, operands, strict=True))
        if quantity.kind in _KINDS:
            dynamics, body = self._with_bodies(quantity.bodies, nodes), quantity.bodies[-1]
            return _KINDS[quantity.kind](dynamics, body, dynamics.links.scalars(quantity.vector), *quantity.place).node
        dynamics = self.dynamics(quantity.bodies, nodes)
        if quantity.kind == "kinetic_energy":
            return dynamics.kinetic_energy.node
        return dynamics.potential_energy(dynamics.links.scalars(quantity.vector)).node

    def dynamics(self, bodies: tuple[Link, ...], nodes: Nodes) -> Dynamics:
        """Return the recursions of bodies; a rate that has no node is a symbol of its own, on which nothing depends."""
        coordinates = [(q, rate_of(q)) for q in coordinates_of(bodies)]
        every = {rate: self.graph.symbol(f"rate of {q}") for q, rate in coordinates} | dict(nodes)
        key = bodies, tuple(every[one] for pair in coordinates for one in pair)
        if key not in self._known:
            self._known[key] = every, Dynamics(Links(self.graph, bodies, every))
        return self._known[key][1]

    def _with_bodies(self, bodies: tuple[Link, ...], nodes: Nodes) -> Dynamics:
        """Return recursions of bodies, or of a tree that has them: the motion of a body depends on its chain alone."""
        for known, dynamics in self._known.values():
            if bodies[-1] in dynamics.links.carried and all(known.get(one) == node for one, node in nodes.items()):
                return dynamics
        return self.dynamics(bodies, nodes)


def _position(dynamics: Dynamics, body: Link, point: Vector, place: int) -> Scalar:
    on = dynamics.links.carried[body]
    return dynamics.point_up(on.carrier, plus(on.p, applied(on.R, point)))[place]


def _rotation(dynamics: Dynamics, body: Link, _: Vector, row: int, column: int) -> Scalar:
    on = dynamics.links.carried[body]
    return dynamics.vector_up(on.carrier, transposed(on.R)[column])[row]


def _velocity(dynamics: Dynamics, body: Link, point: Vector, place: int) -> Scalar:
    on = dynamics.links.carried[body]
    if on.carrier < 0:
        return dynamics.zero
    w, v = dynamics.motions[0][on.carrier]
    return dynamics.vector_up(on.carrier, plus(v, cross(w, plus(on.p, applied(on.R, point)))))[place]


def _angular_velocity(dynamics: Dynamics, body: Link, _: Vector, place: int) -> Scalar:
    on = dynamics.links.carried[body]
    if on.carrier < 0:
        return dynamics.zero
    return dynamics.vector_up(on.carrier, dynamics.motions[0][on.carrier][0])[place]


_KINDS: Mapping[str, Callable[..., Scalar]] = {
    "position": _position,
    "rotation": _rotation,
    "velocity": _velocity,
    "angular_velocity": _angular_velocity,
}
