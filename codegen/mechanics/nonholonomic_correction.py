"""Nonholonomic corrections to Lagrange's equations, for velocities that are not rates of coordinates.

Velocities in SymPy may already contain constraints: the centre of a rolling disk may have the velocity omega x r, with
no coordinates for its position. Lagrange's equations are then wrong for T(q, qdot). For a particle with the velocity
v = sum_r beta_r qdot_r + beta_0, Kane's inertia forces are

    m vdot . beta_r = d/dt dT/dqdot_r - dT/dq_r - E_r,    E_r = m v . dbeta_r/dt - dT/dq_r,

and likewise for the rotation of a body, with angular momentum h = I omega and omega = sum_r w_r qdot_r + w_0. E is zero
if v is the derivative of a position, and omega that of an orientation. Otherwise it is a force that is quadratic in the
velocities, and does no work if time does not occur (Chaplygin; Neimark and Fufaev, Dynamics of Nonholonomic Systems).
"""

from __future__ import annotations

import sympy
from sympy.physics.mechanics import Particle, RigidBody, System, Vector

from ..model import t
from .loads import angular_velocity, velocity
from .speeds import Speeds
from .zero_test import vanish


def missing_forces(body: Particle | RigidBody, system: System, speeds: Speeds) -> tuple[sympy.Expr, ...]:
    """Return (n) E of a body in coordinates and rates; zero where its velocities are derivatives of its position."""
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


def _added(forces: list[sympy.Expr], v: Vector, momentum: Vector, system: System, speeds: Speeds) -> list[sympy.Expr]:
    frame, energy = system.frame, v.dot(momentum) / 2
    betas = [v.diff(rate, frame, var_in_dcm=False) for rate in speeds.rates]
    rates = [beta.dt(frame).xreplace(dict(speeds.in_rates)) for beta in betas]
    return [before + momentum.dot(rate) - energy.diff(q)
            for before, rate, q in zip(forces, rates, speeds.coordinates, strict=True)]  # fmt: skip


def _is_rate_of_place(v: Vector, body: Particle | RigidBody, system: System, speeds: Speeds) -> bool:
    try:
        place = body.masscenter.pos_from(system.fixed_point)
        rate = place.dt(system.frame).xreplace(dict(speeds.in_rates))
        return vanish((rate - v).to_matrix(system.frame))
    except ValueError:  # its position is undefined
        return False


def _is_rate_of_orientation(omega: Vector, body: RigidBody, system: System) -> bool:
    """Whether R^T Rdot is the cross-product matrix of omega, where R maps the body's axes to the fixed axes."""
    try:
        R = system.frame.dcm(body.frame)
    except ValueError:  # its orientation is undefined
        return False
    matrix = R.T * R.diff(t)
    rate = sympy.Matrix([matrix[2, 1], matrix[0, 2], matrix[1, 0]])
    return vanish(rate - omega.to_matrix(body.frame))
