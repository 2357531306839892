"""Triangular root of M from articulated bodies, without M: the innovations factorisation of Jain and Rodriguez.

M = R^T R, eta = R v. Coordinate k of a body moves it by h, and feels the inertia P of the body with all coordinates
further out free. With U = P h, D = h . U and g = U / D, R is triangular from the ground outwards:

    eta_k = sqrt(D) (v_k + g . (velocity of the body without v_k and the coordinates of its joint that follow k))

so that v follows from eta by one recursion outwards, and R^-T of forces by one inwards. The coordinates of a joint are
treated one after the other, the last one first.

After A. Jain and G. Rodriguez, "Diagonalized Lagrangian robot dynamics", IEEE Trans. Robotics and Automation 11 (1995)
571-584. The rates of D and U follow from the derivative of the recursion for P along the motion (docs/theory.md).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from .inertia import ArticulatedInertia, Spatial, crossed, crossed_force, spatial_dot, spatial_sum, times
from .links import Moving
from .recursion import Dynamics
from .scalar import HALF, Scalar, Vector, minus, total


@dataclass(frozen=True, slots=True)
class Factor:
    """What one coordinate k contributes to R.

    k : its number
    h, h_rate : the motion of the body at a rate of 1, and its derivative along the motion
    inertia, force, pivot, gain : P, U, D (with the armature), g
    """

    k: int
    h: Spatial
    h_rate: Spatial
    inertia: ArticulatedInertia
    force: Spatial
    pivot: Scalar
    gain: Spatial


@dataclass(frozen=True, slots=True)
class FactorRate:
    """Derivatives of D and U along the motion."""

    pivot: Scalar
    force: Spatial


@dataclass(frozen=True, slots=True)
class Joint:
    """factors : of its coordinates in order; passed : the inertia that the parent feels, in the body's frame."""

    factors: Sequence[Factor]
    passed: ArticulatedInertia


@dataclass(frozen=True, slots=True)
class Motion:
    """Velocities of a body in its own frame.

    passed : of a point of its parent; before : (d) for each coordinate, that without this one and those that follow
    own : of the joint; whole : of the body
    """

    passed: Spatial
    before: Sequence[Spatial]
    own: Spatial
    whole: Spatial


class Innovations:
    """The root of a tree of n coordinates, and its use at the quasi-velocities eta.

    Parameters
    ----------
    armature, armature_rates
        (n,) inertia of each coordinate besides that of the bodies, and its derivative along the motion.
    """

    def __init__(
        self, dynamics: Dynamics, armature: Sequence[Scalar], armature_rates: Sequence[Scalar], eta: Sequence[Scalar]
    ) -> None:
        self.dynamics, self.links, self.moving = dynamics, dynamics.links, dynamics.links.moving
        self.armature, self.armature_rates = armature, armature_rates
        self.zero, self.still = dynamics.zero, dynamics.still
        self.joints = self._joints()
        self.inverse_roots = [pivot**-HALF for pivot in self.pivots]
        self.free = [one * factor for one, factor in zip(eta, self.inverse_roots, strict=True)]
        self.v, self.motions = self._motions()

    @property
    def pivots(self) -> list[Scalar]:
        """D (n,): the inertia that each coordinate feels, with the coordinates further out free."""
        return self._by_coordinate((one.k, one.pivot) for joint in self.joints for one in joint.factors)

    def _by_coordinate(self, pairs: Iterator[tuple[int, Scalar]]) -> list[Scalar]:
        found = dict(pairs)
        return [found[k] for k in range(self.dynamics.n)]

    # -- the root --------------------------------------------------------------------------------------------------

    def _joints(self) -> list[Joint]:
        inertias = [body.inertia.articulated() for body in self.moving]
        joints: list[Joint] = []
        for number in reversed(range(len(self.moving))):
            body = self.moving[number]
            joints.append(self._joint(body, inertias[number]))
            if body.parent >= 0:
                inertias[body.parent] = inertias[body.parent] + _up(body, joints[-1].passed)
        return joints[::-1]

    def _joint(self, body: Moving, P: ArticulatedInertia) -> Joint:
        factors: list[Factor] = []
        for h, k in reversed(list(zip(body.S, body.numbers, strict=True))):
            force = P * h
            pivot = spatial_dot(h, force) + self.armature[k]
            gain = times(force, pivot**-1)
            factors.append(Factor(k, h, self.links.rate(h), P, force, pivot, gain))
            P = P.without([force], [gain])
        return Joint(factors[::-1], P)

    def _motions(self) -> tuple[list[Scalar], list[Motion]]:
        """Return v (n,) = R^-1 eta, and the velocities of the bodies."""
        v, motions = [self.zero] * self.dynamics.n, list[Motion]()
        for body, joint in zip(self.moving, self.joints, strict=True):
            passed = self.dynamics.down(body, motions[body.parent].whole if body.parent >= 0 else self.still)
            before = [passed]
            for one in joint.factors:
                v[one.k] = self.free[one.k] - spatial_dot(one.gain, before[-1])
                before.append(spatial_sum(before[-1], times(one.h, v[one.k])))
            own = spatial_sum(self.still, *(times(one.h, v[one.k]) for one in joint.factors))
            motions.append(Motion(passed, before[:-1], own, before[-1]))
        return v, motions

    def eta_of(self, v: Sequence[Scalar]) -> list[Scalar]:
        """Return R v (n,)."""
        result, wholes = [self.zero] * self.dynamics.n, list[Spatial]()
        for body, joint in zip(self.moving, self.joints, strict=True):
            before = self.dynamics.down(body, wholes[body.parent] if body.parent >= 0 else self.still)
            for one in joint.factors:
                result[one.k] = (v[one.k] + spatial_dot(one.gain, before)) * one.pivot**HALF
                before = spatial_sum(before, times(one.h, v[one.k]))
            wholes.append(before)
        return result

    @cached_property
    def rates(self) -> list[list[FactorRate]]:
        """The derivatives of the factors of each body along the motion."""
        nothing = ArticulatedInertia([self.zero] * 6, [self.zero] * 9, [self.zero] * 6)
        changes = [nothing for _ in self.moving]
        rates: list[list[FactorRate]] = []
        for number in reversed(range(len(self.moving))):
            body, joint = self.moving[number], self.joints[number]
            own, change = self._factor_rates(joint, changes[number])
            rates.append(own)
            if body.parent >= 0:
                turned = change + joint.passed.rate(self.motions[number].own)
                changes[body.parent] = changes[body.parent] + _up(body, turned)
        return rates[::-1]

    def _factor_rates(self, joint: Joint, change: ArticulatedInertia) -> tuple[list[FactorRate], ArticulatedInertia]:
        """Return the derivatives of the factors of a joint, and that of the inertia it passes on."""
        rates: list[FactorRate] = []
        for one in reversed(joint.factors):
            moved = change * one.h
            pivot = spatial_dot(one.h, moved) + spatial_dot(one.h_rate, one.force) * 2 + self.armature_rates[one.k]
            force = spatial_sum(moved, one.inertia * one.h_rate)
            rates.append(FactorRate(pivot, force))
            part = spatial_sum(force, times(one.gain, -pivot * HALF))
            change = change.without([part, one.gain], [one.gain, part])
        return rates[::-1], change

    # -- its use ---------------------------------------------------------------------------------------------------

    def of_forces(self, forces: Sequence[Scalar]) -> list[Scalar]:
        """Return R^-T forces (n,)."""
        none = [self.still] * len(self.moving)
        yielded = self._inwards(forces, [*none], none)
        return [one * factor for one, factor in zip(yielded, self.inverse_roots, strict=True)]

    def _inwards(self, forces: Sequence[Scalar], bias: list[Spatial], biases: Sequence[Spatial]) -> list[Scalar]:
        """Return the innovations (n,): the forces that the coordinates yield to.

        bias : (changed) the bias forces of the bodies; biases : their accelerations at zero rates of v
        """
        result = [self.zero] * self.dynamics.n
        for number in reversed(range(len(self.moving))):
            body, joint, force = self.moving[number], self.joints[number], bias[number]
            for one in reversed(joint.factors):
                result[one.k] = forces[one.k] - spatial_dot(one.h, force)
                force = spatial_sum(force, times(one.gain, result[one.k]))
            if body.parent >= 0:
                force = spatial_sum(force, joint.passed * biases[number])
                bias[body.parent] = spatial_sum(bias[body.parent], self.dynamics.up(body, force))
        return result

    @cached_property
    def biases(self) -> list[Spatial]:
        """The acceleration of each body at zero rates of v, less that of its parent."""
        biases = []
        for motion, joint in zip(self.motions, self.joints, strict=True):
            turned = [times(one.h_rate, self.v[one.k]) for one in joint.factors]
            biases.append(spatial_sum(crossed(motion.passed, motion.own), *turned))
        return biases

    def innovations(self, forces: Sequence[Scalar]) -> list[Scalar]:
        """Return those under forces (n,) of the joints, without gravity."""
        wholes = zip(self.moving, self.motions, strict=True)
        bias = [crossed_force(motion.whole, body.inertia * motion.whole) for body, motion in wholes]
        return self._inwards(forces, bias, self.biases)

    def eta_rates(self, forces: Sequence[Scalar], gravity: Vector) -> list[Scalar]:
        """Return the derivative of eta (n,) under forces (n,) of the joints: R' v + R v'."""
        yielded, falls = self.innovations(forces), self._falls(gravity)
        result = [self.zero] * self.dynamics.n
        for joint, rates, motion, fall in zip(self.joints, self.rates, self.motions, falls, strict=True):
            late = self.still  # of the coordinates that follow, and the own one
            for place in reversed(range(len(rates))):
                one, rate = joint.factors[place], rates[place]
                late = spatial_sum(late, times(one.h_rate, self.v[one.k]))
                turned = spatial_dot(rate.force, motion.before[place])
                stretched = rate.pivot * (self.v[one.k] - self.free[one.k] * HALF)
                felt = minus(fall[0], late[0]), minus(fall[1], late[1])
                rest = total(self.dynamics.graph, [yielded[one.k], turned, stretched, spatial_dot(one.force, felt)])
                result[one.k] = rest * self.inverse_roots[one.k]
        return result

    def _falls(self, gravity: Vector) -> list[Spatial]:
        """Return gravity as an acceleration in the frame of each body."""
        falls: list[Spatial] = []
        for body in self.moving:
            falls.append(self.dynamics.down(body, falls[body.parent] if body.parent >= 0 else (self.still[0], gravity)))
        return falls

    def accelerations(self, forces: Sequence[Scalar], gravity: Vector) -> list[Scalar]:
        """Return the derivative of v (n,) under forces (n,) of the joints."""
        yielded, result, a = self.innovations(forces), [self.zero] * self.dynamics.n, list[Spatial]()
        for number, (body, joint) in enumerate(zip(self.moving, self.joints, strict=True)):
            passed = a[body.parent] if body.parent >= 0 else self.dynamics.ground(gravity)
            before = spatial_sum(self.dynamics.down(body, passed), self.biases[number])
            for one in joint.factors:
                result[one.k] = yielded[one.k] / one.pivot - spatial_dot(one.gain, before)
                before = spatial_sum(before, times(one.h, result[one.k]))
            a.append(before)
        return result


def _up(body: Moving, inertia: ArticulatedInertia) -> ArticulatedInertia:
    """Return an inertia in the parent's frame."""
    for step in reversed(body.steps):
        inertia = step.articulated_up(inertia)
    return inertia
