"""Check of a tree of joints: places and velocities of all bodies against SymPy's, with numbers at a random state.

Users may set velocities and positions of SymPy's points and frames after they made joints.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator
from functools import cached_property
from typing import Any

import numpy as np
import sympy
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import Particle, Point, RigidBody, System, Vector

from ..model import ModelError, t
from ..model.tree.forward_kinematics import Arithmetic, ForwardKinematics
from ..model.tree.tree import Body
from .joint_tree import JointTree, Place
from .loads import angular_velocity, velocity
from .speeds import Speeds

_NEAR = 1e-9


def check_motion(made: JointTree, system: System, speeds: Speeds) -> Callable[[Point], bool]:
    """Compare the bodies of a tree with SymPy's; return what says whether a point's velocity is that of its place.

    It need not be: SymPy's contact points may be places that move on over a body, with the velocity of the body there.

    Raises
    ------
    ModelError
        A body has another place, orientation or velocity in SymPy, or depends on more than coordinates; names it.
    """
    check = _Check(made, system, speeds)
    for body in system.bodies:
        try:
            agrees = check(body)
        except ValueError as error:  # SymPy does not know a place or an orientation
            raise ModelError(str(error)) from error
        except TypeError as error:  # what is left is no number
            raise ModelError(f"the motion of the body {body.name} depends on more than coordinates") from error
        if not agrees:
            raise ModelError(f"the body {body.name} does not move as its joint does")
    return check.is_rate_of_place


class _Check:
    def __init__(self, made: JointTree, system: System, speeds: Speeds) -> None:
        self.made, self.system, self.in_rates = made, system, dict(speeds.in_rates)
        self.random = random.Random("a state without symmetry")
        self.values: dict[sympy.Expr, sympy.Float] = {}
        numbers = Arithmetic(self.number, self.number, math.sin, math.cos, lambda one: 1 / one)
        coordinates = made.tree.coordinates
        state = {one: self.value(one) for q in coordinates for one in (q, q.diff(t))}
        self.bodies = ForwardKinematics(numbers, state)

    def __call__(self, body: Particle | RigidBody) -> bool:
        """Whether a body moves as in SymPy: relative to its parent, and in the fixed frame where that is set.

        SymPy takes a velocity that is not set from the nearest point that has one, which users may have set.
        """
        place, N = self.made.places[body], self.system.frame
        pairs = [*self._relative(body, place, place.parent)] if place.parent else []
        if place.body is None or N in body.masscenter._vel_dict or self.has_odd_points:
            pairs.append((self._placed(place.body)[1][1], self.vector(velocity(body.masscenter, N))))
        if place.body and N in place.frame._ang_vel_dict:
            pairs.append((_spin(*self._placed(place.body)[0]), self.vector(angular_velocity(place.frame, N))))
        return all(_near(found, right) for found, right in pairs)

    def is_rate_of_place(self, point: Point) -> bool:
        """Whether the velocity of a point in SymPy is the derivative of its place; False where that is unknown."""
        try:
            place = point.pos_from(self.system.fixed_point)
            v = self.vector(velocity(point, self.system.frame))
            return _near(self._rate(place), v)
        except (ModelError, TypeError, ValueError):
            return False

    @cached_property
    def has_odd_points(self) -> bool:
        """Whether a point that is connected to the fixed point has a velocity that is not the rate of its place."""
        found = pending = [self.system.fixed_point]
        while pending:
            pending = [one for point in pending for one in point._pos_dict if one not in found]
            found = [*found, *dict.fromkeys(pending)]
        N = self.system.frame
        return any(N in point._vel_dict and not self.is_rate_of_place(point) for point in found)

    def _rate(self, vector: Vector) -> np.ndarray:
        """Return the derivative (3,) of a vector of SymPy in the fixed frame."""
        whole = np.zeros(3)
        for entries, frame in vector.args:
            body, axes = self.made.fixed_in(frame)
            (R, Rdot), fixed = self._placed(body)[0], self.matrix(axes)
            rate = entries.diff(t).xreplace(self.in_rates)
            whole += Rdot @ fixed @ self.matrix(entries).ravel() + R @ fixed @ self.matrix(rate).ravel()
        return whole

    def _relative(
        self, body: Particle | RigidBody, place: Place, carrier: Place
    ) -> Iterator[tuple[np.ndarray, np.ndarray]]:
        """Yield rotation, angular velocity, place and velocity relative to the parent's frame, ours and SymPy's."""
        parent, origin = carrier.frame, carrier.origin
        (R, Rdot), (r, rdot) = self._placed(place.body)
        (C, Cdot), (c, cdot) = self._placed(carrier.body)
        yield C.T @ R, self.matrix(parent.dcm(place.frame))
        yield _spin(C.T @ R, C.T @ Rdot + Cdot.T @ R), C.T @ self.vector(angular_velocity(place.frame, parent))
        yield r - c, self.vector(body.masscenter.pos_from(origin))
        moved = C.T @ (rdot - cdot) + Cdot.T @ (r - c)
        yield moved, C.T @ self.vector(velocity(body.masscenter, parent))

    def _placed(self, body: Body | None) -> tuple[tuple[np.ndarray, np.ndarray], tuple[np.ndarray, np.ndarray]]:
        """Return the rotation (3, 3) and the place (3,) of a body of the tree, each with its rate."""
        R, p = self.bodies.placed(body.link if body else None)
        return _numbers(R), _numbers(p)

    def vector(self, vector: Vector) -> np.ndarray:
        """Return a vector of SymPy (3,) in the axes of the ground."""
        whole = np.zeros(3)
        for entries, frame in vector.xreplace(self.in_rates).args:
            body, R = self.made.fixed_in(frame)
            whole += self._placed(body)[0][0] @ self.matrix(R) @ self.matrix(entries).ravel()
        return whole

    def matrix(self, entries: Any) -> np.ndarray:
        """Return the values of expressions, as a matrix."""
        values = [self.number(entry) for entry in entries]
        return np.array(values).reshape(entries.shape)

    def number(self, expression: sympy.Expr) -> float:
        """Return the value of an expression in coordinates, rates and parameters."""
        if expression.atoms(AppliedUndef) - set(self.made.tree.coordinates):
            raise TypeError(expression)
        rates = {one: self.value(one) for one in expression.atoms(sympy.Derivative)}
        rest = expression.xreplace(rates)
        names = {one: self.value(one) for one in (*rest.atoms(AppliedUndef), *rest.free_symbols)}
        value: float = float(rest.xreplace(names))
        return value

    def value(self, symbol: sympy.Expr) -> sympy.Float:
        """Return the random value of a coordinate, rate or parameter."""
        if symbol not in self.values:
            self.values[symbol] = sympy.Float(self.random.uniform(0.3, 1.2))
        return self.values[symbol]


def _near(found: np.ndarray, right: np.ndarray) -> bool:
    return bool(np.abs(found - right).max() < _NEAR * (1 + np.abs(right).max()))


def _spin(R: np.ndarray, Rdot: np.ndarray) -> np.ndarray:
    """Return the angular velocity (3,) of Rdot R^T."""
    W = Rdot @ R.T
    return np.array([W[2, 1], W[0, 2], W[1, 0]])


def _numbers(entries: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return the values and the rates of a vector or matrix of moving numbers."""
    value, rate = (
        np.squeeze(np.array([[float(getattr(one, part) or 0.0) for one in np.ravel(row)] for row in entries]))
        for part in ("value", "rate")
    )
    return value, rate
