"""A heavy body with a fixed point: Euler's equations in quaternions, in extended precision."""

from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from ..arguments.names import Vector
from ..reference.extended import Extended
from .truth import FINE, Integrated

WEIGHT = 0.3  # m g l [N m]


def body_start(angles: Vector, omega: Vector) -> Vector:
    """Return (q, omega) (7,): turned by psi about z, phi about x, theta about y; omega in the body's axes."""
    return np.concatenate([np.roll(Rotation.from_euler("ZXY", angles).as_quat(), 1), omega])


def body_rows(inertia: Vector, start: Vector, times: Vector) -> Vector:
    """Return (q, omega) (k, 7) at times (k,), the first of which is the start; the weight hangs on the third axis."""
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
