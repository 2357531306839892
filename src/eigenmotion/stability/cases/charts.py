"""Cases with singular coordinates: regular motions in coordinates that are not."""

from math import asin, cos, pi, sin, sqrt

import numpy as np
from scipy.spatial.transform import Rotation

from ...arguments.named_values import Vector
from ...models import heavy_top
from ..expectation.closed_forms import body_rows, body_start, upwards
from ..expectation.truth import ClosedForm
from ..models.smooth import body_in_cardan_angles, polar_on_cart
from .case import Case, Trial, power, rows

_TOP = {"J": 0.05, "J3": 0.02, "m": 1.0, "l": 0.2, "g": 0.0}
_TURN = 2 * pi


def polar(miss: float) -> Trial:
    """Return a particle that passes the centre at a distance, r = 1 before and after; rows after the passage."""
    along = sqrt(1 - miss**2)
    x0, v0 = np.array([0.2, pi - asin(miss), 1.0]), np.array([0.3, -miss, -along])
    units = np.array([1.0, max(miss, 1e-300), 1.0])
    truth = ClosedForm(_straight_on, "a straight line")
    return Trial(power(miss), {}, x0, v0, units, 0.0, rows(1.5, 2.0), truth, turns=np.array([0.0, _TURN, 0.0]))


def _straight_on(start: Vector, elapsed: Vector) -> Vector:
    X, theta, r, X_dot, theta_dot, r_dot = start
    c, s = cos(theta), sin(theta)
    across, up = r * c + (r_dot * c - r * theta_dot * s) * elapsed, r * s + (r_dot * s + r * theta_dot * c) * elapsed
    v = np.array([r_dot * c - r * theta_dot * s, r_dot * s + r * theta_dot * c])
    distance = np.hypot(across, up)
    return np.stack([
        X + X_dot * elapsed, np.arctan2(up, across), distance, np.full_like(elapsed, X_dot),
        (across * v[1] - up * v[0]) / distance**2, (across * v[0] + up * v[1]) / distance,
    ], axis=1)  # fmt: skip


def gimbal(miss: float) -> Trial:
    """Return a free symmetric top whose axis passes the vertical at an angle; rows after the passage."""
    tilt, rate, spin, half = 0.6, 3.0, 4.0, 0.5
    momentum = np.array([sin(tilt + miss), 0.0, cos(tilt + miss)])
    R = Rotation.from_rotvec(-rate * half * momentum) * Rotation.from_euler("ZXZ", [pi / 2, miss, spin])
    axis = R.apply([0.0, 0.0, 1.0])
    along = _TOP["J"] * rate * cos(tilt)  # component of the angular momentum along the figure axis
    omega = rate * momentum + along * (1 / _TOP["J3"] - 1 / _TOP["J"]) * axis
    start = _euler(R, omega)
    truth = ClosedForm(_free_top, "steady precession of the axis about the angular momentum")
    turns = np.array([_TURN, 0.0, _TURN])
    times = rows(0.75, 1.0)
    return Trial(power(miss), _TOP, start[:3], start[3:], np.ones(3), 0.0, times, truth, turns=turns)


def _free_top(start: Vector, elapsed: Vector) -> Vector:
    """Return R(t): precession about L at the rate |L| / J, after a turn about the axis at L_3 (1 / J3 - 1 / J)."""
    phi, theta, psi = start[:3]
    R = Rotation.from_euler("ZXZ", [phi, theta, psi])
    axis, nodes = R.apply([0.0, 0.0, 1.0]), np.array([cos(phi), sin(phi), 0.0])
    omega = start[3] * np.array([0.0, 0.0, 1.0]) + start[4] * nodes + start[5] * axis
    spin = omega @ axis
    L = _TOP["J"] * (omega - spin * axis) + _TOP["J3"] * spin * axis
    own = spin - _TOP["J3"] * spin / _TOP["J"]
    states = []
    for t in elapsed:
        turned = Rotation.from_rotvec(L / _TOP["J"] * t)
        states.append(_euler(turned * R * Rotation.from_rotvec([0.0, 0.0, own * t]), turned.apply(omega)))
    return np.array(states)


def _euler(R: Rotation, omega: Vector) -> Vector:
    """Return phi, theta, psi and their rates from an attitude and its angular velocity in fixed axes."""
    axis = R.apply([0.0, 0.0, 1.0])
    theta, phi = np.arctan2(np.hypot(axis[0], axis[1]), axis[2]), np.arctan2(axis[0], -axis[1])
    nodes = np.array([cos(phi), sin(phi), 0.0])
    body = R.inv().apply(nodes)
    rates = np.linalg.solve(np.stack([[0.0, 0.0, 1.0], nodes, axis], axis=1), omega)
    return np.array([phi, theta, -np.arctan2(body[1], body[0]), *rates])


def cardan(miss: float) -> Trial:
    """Return a heavy body with three different inertias that passes gimbal lock; rows after the passage."""
    angles = np.array([0.3, pi / 2 - miss, 0.2])
    at_passage = body_start(angles, _cardan_axes(angles[2]).T @ [0.0, 1.0, 3.0])
    begin = body_rows(_INERTIA, at_passage, np.array([0.5, 0.0]))[-1]
    start = _cardan(begin)
    truth = ClosedForm(_heavy_body, "Euler's equations in quaternions, in extended precision")
    turns = np.array([_TURN, 0.0, _TURN])
    return Trial(power(miss), {}, start[:3], start[3:], np.ones(3), 0.0, rows(0.75, 1.0), truth, turns=turns)


def _heavy_body(start: Vector, elapsed: Vector) -> Vector:
    _, phi, theta, psi_dot, phi_dot, theta_dot = start
    omega = _cardan_axes(theta).T @ [phi_dot, sin(phi) * psi_dot + theta_dot, cos(phi) * psi_dot]
    return np.array([_cardan(row) for row in body_rows(_INERTIA, body_start(start[:3], omega), elapsed)])


def _cardan_axes(theta: float) -> Vector:
    """Return the rotation to the axes in which omega = (phi', sin phi psi' + theta', cos phi psi')."""
    c, s = cos(theta), sin(theta)
    return np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])


def _cardan(z: Vector) -> Vector:
    """Return psi, phi, theta and their rates from (q, omega)."""
    (a, b, c, d), omega = z[:4], z[4:]
    up = upwards(z.astype(np.longdouble)).astype(np.float64)
    psi = np.arctan2(-2 * (b * c - a * d), a * a - b * b + c * c - d * d)
    phi, theta = np.arctan2(up[1], np.hypot(up[0], up[2])), np.arctan2(-up[0], up[2])
    phi_dot, along, across = _cardan_axes(theta) @ omega
    psi_dot = across / np.hypot(up[0], up[2])
    return np.array([psi, phi, theta, psi_dot, phi_dot, along - up[1] * psi_dot])


_INERTIA = np.array([0.05, 0.06, 0.02])  # as in the model
_MISSES = tuple(10.0**-e for e in range(1, 10))

CASES = (
    Case(
        "polar", "Polar coordinates near the centre",
        "A particle on a cart, without forces, passes the centre of its polar coordinates at a distance; an "
        "eigenvalue of M falls to the square of this distance and grows again. Compared after the passage.",
        "least distance r [m]", _MISSES, lambda _: polar_on_cart(), polar,
    ),
    Case(
        "gimbal", "Euler angles near gimbal lock",
        "The axis of a free symmetric top passes the vertical, where two Euler angles are about the same axis. "
        "Compared after the passage.",
        "least angle theta [rad]", _MISSES, lambda _: heavy_top.model, gimbal,
        reduced=(1e-3, 1e-8),
    ),
    Case(
        "cardan", "Cardan angles near gimbal lock",
        "A heavy body with three different inertias turns about a point and passes the attitude where two of its "
        "angles are about the same axis. Compared after the passage.",
        "least angle [rad]", _MISSES, lambda _: body_in_cardan_angles(), cardan, reduced=(1e-2, 1e-7),
    ),
)  # fmt: skip
