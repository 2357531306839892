"""Moving bodies of a tree in the frames of `frames`: the way from the parent, the joint, and the inertia."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import sympy

from ..calculus.derivatives import Tangent
from ..graph.convert import FromSympy
from ..graph.graph import Graph
from ..graph.store import Node
from ..model.tree.body import FREEDOMS, Link, coordinates_of, rate_of
from .frames import Matrix, Shift, Step, Turn, aligned, applied, matrix, product, transposed, turns
from .inertia import RigidInertia, Spatial, spatial_sum, times
from .rotation import MatrixRotation, PlaneRotation
from .scalar import Scalar, Vector, cross, dot, plus, scaled


@dataclass(frozen=True, slots=True)
class Moving:
    """A body that moves on its parent.

    parent : its number among the moving bodies; -1 for the ground
    numbers : those of its coordinates; bodies that move together have some in common
    steps : from the parent's frame to its own, of which the first `fixed` lead to the joint
    joint, ratio, offset : the kind of the joint; of one coordinate q, it is at ratio q + offset
    S : a motion for each of its coordinates, at a rate of 1, in its own frame
    rate : Sdot qdot
    inertia : of itself, and of the bodies that are fixed to it
    """

    parent: int
    numbers: Sequence[int]
    steps: Sequence[Step]
    fixed: int
    joint: str
    ratio: Scalar
    offset: Scalar
    S: Sequence[Spatial]
    rate: Spatial
    inertia: RigidInertia

    def velocity(self, rates: Sequence[Scalar], zero: Spatial) -> Spatial:
        """Return S qdot."""
        return spatial_sum(zero, *(times(S, rates[k]) for S, k in zip(self.S, self.numbers, strict=True)))

    def frame(self, unit: Matrix) -> tuple[Vector, Matrix]:
        """Return the place of the joint on the parent, and its rotation R; `unit` is the unit matrix."""
        place, columns = [entry * 0 for entry in unit[0]], [list(row) for row in unit]
        for step in reversed(self.steps[: self.fixed]):
            place, columns = list(step.point_up(place)), [list(step.vector_up(column)) for column in columns]
        return place, transposed(columns)


Joint = tuple[list[Step], list[Spatial]]
"""Steps of a joint, and its motions"""


@dataclass(frozen=True, slots=True)
class Carried:
    """A user's frame on a moving body: number of that body, -1 for the ground; a = R (user's), x = p + R (user's)."""

    carrier: int
    R: Matrix
    p: Vector


class Links:
    """The moving bodies of a tree, the inertia fixed to the ground, and where the frames of all bodies are on them.

    Parameters
    ----------
    bodies
        Parents before their children.
    nodes
        The nodes of coordinates and rates.
    """

    def __init__(self, graph: Graph, bodies: Sequence[Link], nodes: Mapping[sympy.Expr, Node]) -> None:
        self.graph, self._from_sympy = graph, FromSympy(graph)
        self.zero = Scalar(graph, graph.zero)
        self.still: Spatial = [self.zero] * 3, [self.zero] * 3
        coordinates = coordinates_of(bodies)
        self._numbers = {q: number for number, q in enumerate(coordinates)}
        self.q = [Scalar(graph, nodes[q]) for q in coordinates]
        self.v = [Scalar(graph, nodes[rate_of(q)]) for q in coordinates]
        pairs = zip(self.q, self.v, strict=True)
        self.along = Tangent(graph, {graph.records[q.node].operands[0]: v.node for q, v in pairs})
        self.moving: list[Moving] = []
        self.nothing = RigidInertia(self.zero, [self.zero] * 3, [self.zero] * 6)
        self.fixed = self.nothing
        self.ground = Carried(-1, matrix(graph, ((1, 0, 0), (0, 1, 0), (0, 0, 1))), [self.zero] * 3)
        self.carried: dict[Link | None, Carried] = {None: self.ground}
        for body in bodies:
            self._add(body)

    def scalars(self, expressions: Sequence[sympy.Expr]) -> list[Scalar]:
        """Return expressions in parameters as nodes."""
        return [Scalar(self.graph, self._from_sympy(one)) for one in expressions]

    def _add(self, body: Link) -> None:
        on = self.carried[body.parent]
        turned = self.scalars(body.rotation)
        at = plus(on.p, applied(on.R, self.scalars(body.at)))
        R = product(on.R, [turned[k : k + 3] for k in (0, 3, 6)])
        if body.joint == "fixed":
            self.carried[body] = Carried(on.carrier, R, at)
            self._add_mass(body)
            return
        C = aligned(self.graph, self.scalars(body.axis)) if FREEDOMS[body.joint] == 1 else self.ground.R
        fixed, last = turns(product(R, C))
        steps: list[Step] = [Shift(at), *fixed]
        if FREEDOMS[body.joint] > 1:
            steps.append(Turn(MatrixRotation(last)))
            last = self.ground.R
        T = product(C, transposed(last))
        numbers = [self._numbers[q] for q in body.coordinates]
        moves, S = self._joint(body, [self.q[k] for k in numbers])
        rates = [self.rate(one) for one in S]
        rate = spatial_sum(self.still, *(times(r, self.v[k]) for r, k in zip(rates, numbers, strict=True)))
        self.carried[body] = Carried(len(self.moving), transposed(T), [self.zero] * 3)
        ratio, offset = self.scalars((body.ratio, body.offset))
        self.moving.append(
            Moving(on.carrier, numbers, [*steps, *moves], len(steps), body.joint, ratio, offset, S, rate, self.nothing)
        )
        self._add_mass(body)

    def _joint(self, body: Link, q: Sequence[Scalar]) -> Joint:
        """Return the steps of a joint, and its motions at a rate of 1 of each coordinate."""
        if body.ratio == 1 and body.offset == 0:
            return _JOINTS[body.joint](q)
        ratio, offset = self.scalars((body.ratio, body.offset))
        steps, S = _JOINTS[body.joint]([ratio * one + offset for one in q])
        return steps, [times(one, ratio) for one in S]

    def rate(self, S: Spatial) -> Spatial:
        """Return the derivative of a motion along the motion, entry by entry."""
        return [self._along(entry) for entry in S[0]], [self._along(entry) for entry in S[1]]

    def _along(self, entry: Scalar) -> Scalar:
        return Scalar(self.graph, self.along(entry.node))

    def _add_mass(self, body: Link) -> None:
        """Add a body's mass to that of the moving body that carries it."""
        on = self.carried[body]
        (m,), J = self.scalars([body.mass]), self.scalars(body.inertia)
        own = RigidInertia(m, self.scalars(body.moment), J).turned(MatrixRotation(on.R))
        one = own.shifted(plus(on.p, applied(on.R, self.scalars(body.center))))
        if on.carrier < 0:
            self.fixed = self.fixed + one
            return
        old = self.moving[on.carrier]
        self.moving[on.carrier] = replace(old, inertia=old.inertia + one)


def _unit(like: Scalar, k: int) -> Vector:
    return [Scalar(like.graph, like.graph.number(int(k == place))) for place in range(3)]


def _revolute(q: Sequence[Scalar]) -> Joint:
    (angle,), graph = q, q[0].graph
    cosine, sine = (Scalar(graph, graph.call(name, angle.node)) for name in ("cos", "sin"))
    none = [angle * 0] * 3
    return [Turn(PlaneRotation(2, cosine, sine))], [(_unit(angle, 2), none)]


def _prismatic(q: Sequence[Scalar]) -> Joint:
    (way,) = q
    none = [way * 0] * 3
    return [Shift([way * 0, way * 0, way])], [(none, _unit(way, 2))]


def _spherical(q: Sequence[Scalar]) -> Joint:
    """Return the joint of modified Rodrigues parameters s, for |s| < 1 (Schaub and Junkins 1996).

    With d = 1 + s.s, R = 1 + (4 (2 - d) [s x] + 8 [s x]^2) / d^2, and the rate of the body in its own axes is
    w = 4 ((2 - d) - 2 [s x] + 2 s s^T) sdot / d^2.
    """
    graph, s = q[0].graph, list(q)
    one = Scalar(graph, graph.one)
    square = dot(s, s)
    d = one + square
    inverse = d**-2
    less = (one - square) * inverse * 4
    e = [_unit(one, k) for k in range(3)]
    columns = [plus(scaled(cross(s, e[k]), less), scaled(cross(s, cross(s, e[k])), inverse * 8)) for k in range(3)]
    R = transposed([plus(e[k], columns[k]) for k in range(3)])
    S = [plus(scaled(e[k], less), scaled(cross(s, e[k]), inverse * -8), scaled(s, s[k] * inverse * 8))
         for k in range(3)]  # fmt: skip
    none = [one * 0] * 3
    return [Turn(MatrixRotation(R))], [(column, none) for column in S]


def _free(q: Sequence[Scalar]) -> Joint:
    (turn,), S = _spherical(q[3:])
    none = [q[0] * 0] * 3
    along = [(none, turn.motion_down((none, _unit(q[0], k)))[1]) for k in range(3)]
    return [Shift(list(q[:3])), turn], [*along, *S]


_JOINTS = {"revolute": _revolute, "prismatic": _prismatic, "spherical": _spherical, "free": _free}
