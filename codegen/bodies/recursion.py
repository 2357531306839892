"""Recursive dynamics of a tree: Newton-Euler, composite bodies, articulated bodies (Featherstone 2008, ch. 5-7)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from ..graph.store import Node
from .branch_factor import BranchFactor
from .inertia import ArticulatedInertia, RigidInertia, Spatial, crossed, crossed_force, spatial_dot, spatial_sum, times
from .links import Links, Moving
from .scalar import HALF, Scalar, Vector, dot, total


@dataclass(frozen=True, slots=True)
class Articulated:
    """A joint of articulated bodies: U = I S, D = S^T U.

    pivots : (d,) diagonal of D; inverse : (d, d) D^-1; gains : (d) rows of D^-1 U^T
    passed : I - U D^-1 U^T, the inertia that the parent feels
    """

    pivots: list[Scalar]
    inverse: list[list[Scalar]]
    gains: list[Spatial]
    passed: ArticulatedInertia


class Dynamics:
    """Dynamics of a tree of n coordinates. Gravity is its acceleration (3,) in the ground's axes [m / s^2]."""

    def __init__(self, links: Links) -> None:
        self.links, self.graph, self.zero, self.still = links, links.graph, links.zero, links.still
        self.n = len(links.q)
        self._articulated: dict[tuple[Node, ...], list[Articulated]] = {}

    # -- motions ---------------------------------------------------------------------------------------------------

    @cached_property
    def motions(self) -> tuple[list[Spatial], list[Spatial]]:
        """Velocity of each body, and its acceleration at qddot = 0 less that of its parent: v x S qdot + Sdot qdot."""
        velocities: list[Spatial] = []
        biases: list[Spatial] = []
        for body in self.links.moving:
            own = body.velocity(self.links.v, self.still)
            passed = self.down(body, velocities[body.parent] if body.parent >= 0 else self.still)
            velocities.append(spatial_sum(passed, own))
            biases.append(spatial_sum(crossed(passed, own), body.rate))
        return velocities, biases

    def down(self, body: Moving, motion: Spatial) -> Spatial:
        """Return a motion of the parent's frame in the body's frame."""
        for step in body.steps:
            motion = step.motion_down(motion)
        return motion

    def up(self, body: Moving, force: Spatial) -> Spatial:
        """Return a force on the body in the parent's frame."""
        for step in reversed(body.steps):
            force = step.force_up(force)
        return force

    def ground(self, gravity: Vector) -> Spatial:
        """Return the acceleration of the ground that has the effect of gravity."""
        return self.still[0], [-g for g in gravity]

    # -- energies --------------------------------------------------------------------------------------------------

    @cached_property
    def kinetic_energy(self) -> Scalar:
        """Kinetic energy [J], the sum of v . I v / 2."""
        pairs = zip(self.links.moving, self.motions[0], strict=True)
        return total(self.graph, [spatial_dot(v, body.inertia * v) for body, v in pairs]) * HALF

    def potential_energy(self, gravity: Vector) -> Scalar:
        """Return the potential energy of gravity [J], -g . sum of m c in the ground's axes."""
        terms = [dot(self.links.fixed.moment, gravity)]
        for number, body in enumerate(self.links.moving):
            terms.append(dot(self.vector_up(number, body.inertia.moment), gravity))
            terms.append(dot(self.point_up(number, [self.zero] * 3), gravity) * body.inertia.mass)
        return -total(self.graph, [self.zero, *terms])

    def vector_up(self, number: int, a: Vector) -> Vector:
        """Return a vector of a moving body in the ground's axes."""
        while number >= 0:
            for step in reversed(self.links.moving[number].steps):
                a = step.vector_up(a)
            number = self.links.moving[number].parent
        return a

    def point_up(self, number: int, x: Vector) -> Vector:
        """Return the place of a point of a moving body in the ground's frame."""
        while number >= 0:
            for step in reversed(self.links.moving[number].steps):
                x = step.point_up(x)
            number = self.links.moving[number].parent
        return x

    # -- recursions ------------------------------------------------------------------------------------------------

    def inverse_dynamics(self, accelerations: Sequence[Scalar] | None, gravity: Vector) -> list[Scalar]:
        """Return the forces (n,) of the joints at accelerations (n,), None for zero: recursive Newton-Euler."""
        velocities, biases = self.motions
        moving, ground = self.links.moving, self.ground(gravity)
        a: list[Spatial] = []
        forces: list[Spatial] = []
        for number, body in enumerate(moving):
            own = body.velocity(accelerations, self.still) if accelerations is not None else self.still
            a.append(spatial_sum(self.down(body, a[body.parent] if body.parent >= 0 else ground),
                                 biases[number], own))  # fmt: skip
            v = velocities[number]
            forces.append(spatial_sum(body.inertia * a[-1], crossed_force(v, body.inertia * v)))
        return self._projected(forces)

    def _projected(self, forces: list[Spatial]) -> list[Scalar]:
        """Return S . (force of a body and all bodies that it carries)."""
        result = [self.zero] * self.n
        for number in reversed(range(len(forces))):
            body = self.links.moving[number]
            for S, k in zip(body.S, body.numbers, strict=True):
                result[k] = result[k] + spatial_dot(S, forces[number])
            if body.parent >= 0:
                forces[body.parent] = spatial_sum(forces[body.parent], self.up(body, forces[number]))
        return result

    @cached_property
    def composite(self) -> list[RigidInertia]:
        """Inertia of each body with all that it carries."""
        moving = self.links.moving
        composite = [body.inertia for body in moving]
        for number in reversed(range(len(moving))):
            body, inertia = moving[number], composite[number]
            if body.parent >= 0:
                for step in reversed(body.steps):
                    inertia = step.rigid_up(inertia)
                composite[body.parent] = composite[body.parent] + inertia
        return composite

    @cached_property
    def mass_matrix(self) -> list[list[Scalar]]:
        """M (n, n) by composite rigid bodies."""
        M = [[self.zero] * self.n for _ in range(self.n)]
        for number in reversed(range(len(self.links.moving))):
            self._column(M, number, [self.composite[number] * S for S in self.links.moving[number].S])
        return M

    @cached_property
    def carried(self) -> list[Scalar]:
        """(n,) bounds of the diagonal of M: w.w tr(J) + v.v m of what a coordinate moves, but for moments."""
        sizes: list[list[Scalar]] = [[self.zero] for _ in range(self.n)]
        for body, inertia in zip(self.links.moving, self.composite, strict=True):
            trace = inertia.J[0] + inertia.J[3] + inertia.J[5]
            for (w, v), k in zip(body.S, body.numbers, strict=True):
                sizes[k] += [dot(w, w) * trace, dot(v, v) * inertia.mass]
        return [total(self.graph, terms) for terms in sizes]

    def _column(self, M: list[list[Scalar]], number: int, forces: list[Spatial]) -> None:
        """Add the columns of a body: the forces that its accelerations take, on itself and on all that carry it."""
        moving, columns = self.links.moving, self.links.moving[number].numbers
        at = number
        while at >= 0:
            for place, (force, column) in enumerate(zip(forces, columns, strict=True)):
                own = place + 1 if at == number else None  # of the body's own block the upper half
                for S, row in list(zip(moving[at].S, moving[at].numbers, strict=True))[:own]:
                    entry = spatial_dot(S, force)
                    M[row][column] = M[row][column] + entry
                    if at != number or row != column:
                        M[column][row] = M[column][row] + entry
            forces = [self.up(moving[at], force) for force in forces]
            at = moving[at].parent

    def accelerations(self, forces: Sequence[Scalar], gravity: Vector, armature: Sequence[Scalar] = ()) -> list[Scalar]:
        """Return qddot (n,) under the forces (n,) of the joints: articulated bodies.

        Parameters
        ----------
        armature
            (n,) inertia of each coordinate besides that of the bodies; () for none.
        """
        if self.shared:
            bias = self.inverse_dynamics(None, gravity)
            return self.solved([force - one for force, one in zip(forces, bias, strict=True)], armature)
        velocities, biases = self.motions
        bodies = zip(self.links.moving, velocities, strict=True)
        passed = [crossed_force(v, body.inertia * v) for body, v in bodies]
        return self._solved(forces, passed, biases, self.ground(gravity), armature)

    def solved(self, forces: Sequence[Scalar], armature: Sequence[Scalar] = ()) -> list[Scalar]:
        """Return M^-1 forces (n,)."""
        if self.shared:
            return self._factor(armature).solve(forces)
        none = [self.still] * len(self.links.moving)
        return self._solved(forces, [*none], none, self.still, armature)

    def _solved(
        self, forces: Sequence[Scalar], bias: list[Spatial], biases: Sequence[Spatial], ground: Spatial,
        armature: Sequence[Scalar],
    ) -> list[Scalar]:  # fmt: skip
        """Return qddot (n,) under forces of the joints and bias forces (changed) of the bodies.

        Inwards, each body passes on the force that its joint does not yield to; outwards, each joint accelerates.
        """
        moving, joints = self.links.moving, self.articulated(tuple(one.node for one in armature))
        rests: list[list[Scalar]] = [[] for _ in moving]
        for number in reversed(range(len(moving))):
            body, joint = moving[number], joints[number]
            rest = [forces[k] - spatial_dot(S, bias[number]) for S, k in zip(body.S, body.numbers, strict=True)]
            rests[number] = rest
            if body.parent >= 0:
                pull = [times(gain, u) for gain, u in zip(joint.gains, rest, strict=True)]
                force = spatial_sum(bias[number], joint.passed * biases[number], *pull)
                bias[body.parent] = spatial_sum(bias[body.parent], self.up(body, force))
        a: list[Spatial] = []
        result = [self.zero] * self.n
        for number, body in enumerate(moving):
            joint = joints[number]
            before = spatial_sum(self.down(body, a[body.parent] if body.parent >= 0 else ground), biases[number])
            for k, gain, row in zip(body.numbers, joint.gains, joint.inverse, strict=True):
                result[k] = dot(row, rests[number]) - spatial_dot(gain, before)
            a.append(spatial_sum(before, body.velocity(result, self.still)))
        return result

    @property
    def shared(self) -> bool:
        """Whether bodies have a coordinate in common. They are no tree of independent joints then: M is factored."""
        return sum(len(body.numbers) for body in self.links.moving) > self.n

    def _factor(self, armature: Sequence[Scalar]) -> BranchFactor:
        M = [list(row) for row in self.mass_matrix]
        for k, more in enumerate(armature):
            M[k][k] = M[k][k] + more
        return BranchFactor(M)

    def pivots(self, armature: Sequence[Scalar] = ()) -> list[Scalar]:
        """Return the inertia (n,) that each coordinate feels, with the joints further out free."""
        if self.shared:
            return self._factor(armature).pivots
        return [pivot for joint in self.articulated(tuple(one.node for one in armature)) for pivot in joint.pivots]

    def articulated(self, armature: tuple[Node, ...]) -> list[Articulated]:
        """Return what each joint yields and passes on."""
        if armature not in self._articulated:
            self._articulated[armature] = self._joints([Scalar(self.graph, node) for node in armature])
        return self._articulated[armature]

    def _joints(self, armature: Sequence[Scalar]) -> list[Articulated]:
        moving = self.links.moving
        inertias = [body.inertia.articulated() for body in moving]
        joints: list[Articulated] = []
        for number in reversed(range(len(moving))):
            body = moving[number]
            U = [inertias[number] * S for S in body.S]
            D = [[spatial_dot(S, u) for u in U] for S in body.S]
            for place, k in enumerate(body.numbers if armature else ()):
                D[place][place] = D[place][place] + armature[k]
            inverse = inverse_of(D)
            gains = [spatial_sum(*(times(u, entry) for u, entry in zip(U, row, strict=True))) for row in inverse]
            passed = inertias[number].without(U, gains)
            joints.append(Articulated([D[k][k] for k in range(len(D))], inverse, gains, passed))
            if body.parent >= 0:
                for step in reversed(body.steps):
                    passed = step.articulated_up(passed)
                inertias[body.parent] = inertias[body.parent] + passed
        return joints[::-1]


def inverse_of(D: Sequence[Sequence[Scalar]]) -> list[list[Scalar]]:
    """Return the inverse of a symmetric matrix, by elimination: pivots come in order, for it is positive definite."""
    n, zero = len(D), D[0][0] * 0
    one = Scalar(zero.graph, zero.graph.one)
    rows = [[*row, *(one if k == number else zero for k in range(n))] for number, row in enumerate(D)]
    for k in range(n):
        pivot = rows[k][k] ** -1
        rows[k] = [entry * pivot for entry in rows[k]]
        for other in range(n):
            if other != k and not rows[other][k].is_zero:
                factor = rows[other][k]
                rows[other] = [a - factor * b for a, b in zip(rows[other], rows[k], strict=True)]
    return [row[n:] for row in rows]
