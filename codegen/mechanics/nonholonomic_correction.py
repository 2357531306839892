"""Corrections to Lagrange's equations where velocities are no rates of coordinates: a disk that rolls, say.

SymPy's velocities may take constraints for granted: the centre of a rolling disk is given the velocity omega x r, and
no coordinates of the place it rolls to. Lagrange's equations of such a T(q, qdot) are not those of the motion. With
velocities v = sum_r beta_r qdot_r + beta_0 of a particle, Kane's inertia forces are

    m vdot . beta_r = d/dt dT/dqdot_r - dT/dq_r - E_r,    E_r = m v . dbeta_r/dt - dT/dq_r,

and for the rotation of a body likewise with its angular momentum h = I omega and omega = sum_r w_r qdot_r + w_0. E is
zero where v is the derivative of a position, and omega that of an orientation; else it is a force of second degree in
the velocities, which does no work where time does not enter (Chaplygin; Neimark and Fufaev, Dynamics of Nonholonomic
Systems).
"""

from __future__ import annotations

import sympy
from sympy.physics.mechanics import Particle, RigidBody, System, Vector

from ..model import t
from .loads import angular_velocity, velocity
from .speeds import Speeds
from .zero_test import vanish


def missing_forces(body: Particle | RigidBody, system: System, speeds: Speeds) -> tuple[sympy.Expr, ...]:
    """(n) E of a body, in coordinates and rates; zeros where its velocities are those of its place."""
    frame, in_rates = system.frame, dict(speeds.in_rates)
    missing = [sympy.S.Zero] * len(speeds.coordinates)
    v = velocity(body.masscenter, frame).xreplace(in_rates)
    if not _is_rate_of_place(v, body, system, speeds):
        missing = _added(missing, v, body.mass * v, system, speeds)
    if isinstance(body, RigidBody):
        omega = angular_velocity(body.frame, frame).xreplace(in_rates)
        if not _is_rate_of_orientation(omega, body, system):
            missing = _added(missing, omega, body.central_inertia.dot(omega), system, speeds)
    return tuple(missing)


def _added(given: list[sympy.Expr], v: Vector, momentum: Vector, system: System, speeds: Speeds) -> list[sympy.Expr]:
    frame, energy = system.frame, v.dot(momentum) / 2
    along = [v.diff(rate, frame, var_in_dcm=False) for rate in speeds.rates]
    turned = [beta.dt(frame).xreplace(dict(speeds.in_rates)) for beta in along]
    return [before + momentum.dot(rate) - energy.diff(q)
            for before, rate, q in zip(given, turned, speeds.coordinates, strict=True)]  # fmt: skip


def _is_rate_of_place(v: Vector, body: Particle | RigidBody, system: System, speeds: Speeds) -> bool:
    try:
        place = body.masscenter.pos_from(system.fixed_point)
        rate = place.dt(system.frame).xreplace(dict(speeds.in_rates))
        return vanish((rate - v).to_matrix(system.frame))
    except ValueError:  # nothing says where it is
        return False


def _is_rate_of_orientation(omega: Vector, body: RigidBody, system: System) -> bool:
    """Whether R^T Rdot is the matrix of omega, with R from the body's axes to the fixed ones."""
    try:
        R = system.frame.dcm(body.frame)
    except ValueError:  # nothing says how it lies
        return False
    turning = R.T * R.diff(t)
    found = sympy.Matrix([turning[2, 1], turning[0, 2], turning[1, 0]])
    return vanish(found - omega.to_matrix(body.frame))
