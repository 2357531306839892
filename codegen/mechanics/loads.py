"""Loads of a system: those with a potential contribute to V, the others to the generalised forces Q."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import sympy
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import (
    ActuatorBase,
    DuffingSpring,
    Force,
    LinearSpring,
    Point,
    ReferenceFrame,
    System,
    Torque,
    Vector,
)

from ..model import ModelError, t
from .speeds import Speeds
from .zero_test import vanish


@dataclass(frozen=True, slots=True)
class Acting:
    """The effect of one load, or of all loads of one actuator.

    Q : (n) generalised forces, sum_k F_k . dv_k / dqdot [J / u_i]
    V : their potential, Q = -dV/dq; None if none is known
    place : the point or frame on which a single load acts; None for an actuator with several loads
    """

    Q: tuple[sympy.Expr, ...]
    V: sympy.Expr | None
    place: Point | ReferenceFrame | None


def acting_on(system: System, speeds: Speeds) -> list[Acting]:
    """Return the effects of the loads and actuators of a system."""
    single = [_acting(system, speeds, [load], _potential_of(load, system)) for load in system.loads]
    return single + [
        _acting(system, speeds, actuator.to_loads(), stored_energy(actuator)) for actuator in system.actuators
    ]


def velocity(point: Point, frame: ReferenceFrame) -> Vector:
    """Return the velocity of a point in a frame.

    Raises
    ------
    ModelError
        SymPy does not know it; names the point.
    """
    try:
        return point.vel(frame)
    except ValueError as error:
        raise ModelError(
            f"The velocity of the point {point.name} in the frame {frame.name} is not known: {error} "
            "Connect it by a joint, place it with locatenew from a point that has one, or use set_vel."
        ) from error


def angular_velocity(frame: ReferenceFrame, fixed: ReferenceFrame) -> Vector:
    """Return the angular velocity of a frame in the fixed frame.

    Raises
    ------
    ModelError
        SymPy does not know it; names the frame.
    """
    try:
        return frame.ang_vel_in(fixed)
    except ValueError as error:
        raise ModelError(
            f"The angular velocity of the frame {frame.name} in {fixed.name} is not known: {error} "
            "Connect its body by a joint, orient the frame, or use set_ang_vel."
        ) from error


def _acting(system: System, speeds: Speeds, loads: Sequence[Force | Torque], V: sympy.Expr | None) -> Acting:
    Q = tuple(sum(column) for column in zip(*(_generalised(load, system.frame, speeds) for load in loads), strict=True))
    place = loads[0].location if len(loads) == 1 else None
    if V is not None and not V.atoms(AppliedUndef) - {*speeds.coordinates}:  # inputs are no part of an energy
        power = (entry + V.diff(q) for entry, q in zip(Q, speeds.coordinates, strict=True))
        if vanish(power):
            return Acting(Q, V, place)
    return Acting(Q, None, place)


def _generalised(load: Force | Torque, frame: ReferenceFrame, speeds: Speeds) -> sympy.ImmutableDenseMatrix:
    """Return (n) generalised forces P^T (F . dv/dw), where w are the velocities in which the model is written."""
    v = velocity(load.point, frame) if isinstance(load, Force) else angular_velocity(load.frame, frame)
    v, vector = (part.xreplace(dict(speeds.written)) for part in (v, load.vector))
    try:
        parts = [vector.dot(v.diff(w, frame, var_in_dcm=False)) for w in speeds.velocities]
    except ValueError as error:
        raise ModelError(f"The load {load} is in a frame that nothing orients in {frame.name}: {error}") from error
    return speeds.P.T * sympy.ImmutableDenseMatrix(parts)


def _potential_of(load: Force | Torque, system: System) -> sympy.Expr | None:
    """Return the potential -F . r of a constant force, such as a weight; None for other loads."""
    if not isinstance(load, Force):
        return None
    try:
        F = load.vector.to_matrix(system.frame)
        V = -load.vector.dot(load.point.pos_from(system.fixed_point))
    except ValueError:  # the position of the point, or a frame in it, is undefined
        return None
    return None if F.atoms(AppliedUndef) or t in F.free_symbols else V


def stored_energy(actuator: ActuatorBase, length: sympy.Expr | None = None) -> sympy.Expr | None:
    """Return the energy of a spring of this length, by default that of its pathway.

    None for other actuators, and for springs whose stiffness or rest length varies with coordinates, velocities or
    inputs.
    """
    if isinstance(actuator, LinearSpring):
        stiffness: tuple[sympy.Expr, ...] = (actuator.stiffness, sympy.S.Zero)
    elif isinstance(actuator, DuffingSpring):
        stiffness = actuator.linear_stiffness, actuator.nonlinear_stiffness
    else:
        return None
    if sympy.Tuple(*stiffness, actuator.equilibrium_length).atoms(AppliedUndef):
        return None
    d = (actuator.pathway.length if length is None else length) - actuator.equilibrium_length
    return stiffness[0] * d**2 / 2 + stiffness[1] * d**4 / 4


def check_weights(system: System, acting: Iterable[Acting]) -> None:
    """Check that no force on a body's mass centre is contained in the body's potential energy as well.

    Raises
    ------
    ModelError
        One is; names the body.
    """
    by_place = {load.place: load.V for load in acting if load.V is not None and load.place is not None}
    for body in system.bodies:
        V = by_place.get(body.masscenter)
        if V is not None and body.potential_energy and vanish(
            (V - body.potential_energy).diff(q) for q in system.q
        ):  # fmt: skip
            raise ModelError(
                f"The body {body.name} has a potential energy and a load that has the same one: it would count twice. "
                "Keep one of them."
            )
