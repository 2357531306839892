"""Closed forms and equations written by hand: an oscillation, a hanging chain, Euler's equations in quaternions."""

from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from ...arguments.named_values import Vector
from ...reference.elimination import solve_array
from ...reference.extended_precision import Extended, Rhs
from .truth import FINE, Integrated

WEIGHT = 0.3  # m g l [N m]


def oscillation(a: float, b: float, w: float, t: Vector) -> tuple[Vector, Vector]:
    """Return a cos(w t) + b / w sin(w t) and its rate."""
    c, s = np.cos(w * t), np.sin(w * t)
    return a * c + b / w * s, b * c - a * w * s


def chain(masses: Vector, lengths: Vector, g: float) -> Rhs:
    """Return f(t, y) of a hanging chain, written by hand: sums of masses below, differences of angles.

    sum_j mu_ij l_i l_j (cos(a_i - a_j) a_j'' + sin(a_i - a_j) a_j'^2) + mu_ii l_i g sin a_i = 0,
    mu_ij the mass below link max(i, j).
    """
    n = len(masses)
    below, l = np.cumsum(masses[::-1].astype(np.longdouble))[::-1], lengths.astype(np.longdouble)
    shared = below[np.maximum.outer(np.arange(n), np.arange(n))] * np.outer(l, l)
    weight = below * l * np.longdouble(g)

    def rhs(time: Any, y: Extended) -> Extended:  # noqa: ARG001, nothing depends on it
        angle, rate = y[:n], y[n:]
        difference = angle[:, None] - angle[None, :]
        force = -(shared * np.sin(difference)) @ rate**2 - weight * np.sin(angle)
        return np.concatenate([rate, solve_array(shared * np.cos(difference), force)])

    return rhs


def body_start(angles: Vector, omega: Vector) -> Vector:
    """Return (q, omega) (7,): turned by psi about z, phi about x, theta about y; omega in the body's axes."""
    return np.concatenate([np.roll(Rotation.from_euler("ZXY", angles).as_quat(), 1), omega])


def body_rows(inertia: Vector, start: Vector, times: Vector) -> Vector:
    """Return (q, omega) (k, 7) at times (k,), the first of which is the start; the weight acts on the third axis."""
    return euler(inertia).rows(start, times, FINE)


def euler(inertia: Vector) -> Integrated:
    """Return Euler's equations of a body with these principal moments (3,)."""
    J = inertia.astype(np.longdouble)

    def rates(time: Any, z: Extended) -> Extended:  # noqa: ARG001, nothing depends on it
        (a, b, c, d), omega = z[:4], z[4:]
        up = upwards(z)
        torque = WEIGHT * np.array([up[1], -up[0], 0 * a])
        turn = np.array([
            -b * omega[0] - c * omega[1] - d * omega[2], a * omega[0] + c * omega[2] - d * omega[1],
            a * omega[1] - b * omega[2] + d * omega[0], a * omega[2] + b * omega[1] - c * omega[0],
        ]) / 2  # fmt: skip
        return np.concatenate([turn, (np.cross(J * omega, omega) + torque) / J])

    return Integrated(rates, np.ones(7))


def upwards(z: Extended) -> Extended:
    """Return the vertical (3,) in the body's axes."""
    a, b, c, d = z[:4]
    return np.array([2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d])
