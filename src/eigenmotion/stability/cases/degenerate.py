"""Cases with rank-deficient matrices: M that is regular only with the constraints, and dependent constraint rows."""

from math import cos, sin

import numpy as np

from ...arguments.named_values import Vector
from ..expectation.closed_forms import body_rows, body_start
from ..expectation.truth import FINE, ClosedForm, Integrated, lagrange
from ..models.degenerate import height_of_pendulum, pendulum_with_bead, quaternion_body, three_cranks
from .case import Case, Trial, power, rows, scale_of
from .variants import CONSTRAINED, DEPENDENT_ROWS


def massless(m_z: float) -> Trial:
    """Return an elastic pendulum whose height is a coordinate of its own, with a small mass or none."""
    parameters = {"m_z": m_z} if m_z > 0 else {}
    one = Integrated(lagrange(pendulum_with_bead(), {"m_z": m_z}), scale_of(np.ones(2), np.ones(2), np.ones(2)))
    theta, r, theta_dot, r_dot = 0.8, 1.2, 0.5, -0.3
    x0 = np.array([theta, r, r * cos(theta)])
    v0 = np.array([theta_dot, r_dot, r_dot * cos(theta) - r * theta_dot * sin(theta)])

    def with_height(start: Vector, elapsed: Vector) -> Vector:
        theta, r, theta_dot, r_dot = one.rows(start[[0, 1, 3, 4]], elapsed, FINE).T
        c, s = np.cos(theta), np.sin(theta)
        return np.stack([theta, r, r * c, theta_dot, r_dot, r_dot * c - r * theta_dot * s], axis=1)

    return Trial(power(m_z), parameters, x0, v0, np.ones(3), 0.0, rows(0.0, 2.0), ClosedForm(with_height, one.how))


def slender(ratio: float) -> Trial:
    """Return a heavy body in quaternions; without inertia about its axis it has no motion."""
    inertia = np.array([0.05, 0.05, 0.05 * ratio])
    start = body_start(np.array([0.3, 0.9, 0.2]), np.array([1.0, -2.0, 4.0]))
    rate = _quaternion_rate(start)
    parameters = {"J_3": inertia[2]}
    truth = ClosedForm(lambda s, t: _in_quaternions(inertia, s, t), "Euler's equations in extended precision")
    return Trial(power(ratio), parameters, start[:4], rate, np.ones(4), 0.0, rows(0.0, 1.0), truth)


def _in_quaternions(inertia: Vector, start: Vector, elapsed: Vector) -> Vector:
    values = body_rows(inertia, np.concatenate([start[:4], 2 * _turning(start[:4]) @ start[4:]]), elapsed)
    return np.array([[*row[:4], *_quaternion_rate(row)] for row in values])


def _quaternion_rate(row: Vector) -> Vector:
    return np.asarray(_turning(row[:4]).T @ row[4:] / 2)


def _turning(q: Vector) -> Vector:
    """Return G (3, 4) of omega = 2 G q'."""
    a, b, c, d = q
    return np.array([[-b, a, d, -c], [-c, -d, a, b], [-d, c, -b, a]])


def cranks(offset: float) -> Trial:
    """Return three parallel cranks with one coupler: two redundant rows, three if all are in line."""
    rate = 4.0
    x0, v0 = np.array([offset, offset, offset, 0.0]), np.array([rate, rate, rate, 0.0])
    one = Integrated(lambda _, y: np.array([y[1], -_CRANK_PULL * np.cos(y[0])]), np.ones(2))

    def together(start: Vector, elapsed: Vector) -> Vector:
        angle, rate = one.rows(start[[0, 4]], elapsed, FINE).T
        return np.stack([angle, angle, angle, 0 * angle, rate, rate, rate, 0 * angle], axis=1)

    return Trial(power(offset), {}, x0, v0, np.ones(4), 0.0, rows(0.0, 0.6), ClosedForm(together, one.how))


_CRANK_PULL = 9.81 * (3 * 0.5 + 2.0) / (3 * 1 / 3 + 2.0)  # g (sum of m r / 2 + m_c r) / (sum of m r^2 / 3 + m_c r^2)
_LEAST_NORM = tuple(variant for variant in DEPENDENT_ROWS if variant.dependent_constraints == "least_norm")


CASES = (
    Case(
        "massless", "Singular M: a coordinate without mass",
        "An elastic pendulum whose height is a coordinate of its own, tied by a constraint, with a small mass or, at "
        "0, none: then M is singular, and regular only together with the constraint.",
        "mass m_z [kg]", (1.0, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 0.0), lambda m_z: height_of_pendulum(m_z > 0), massless,
        variants=CONSTRAINED, reduced=(0.0,),
    ),
    Case(
        "quaternions", "Singular M: four quaternions of a body",
        "A heavy body in quaternions, ever more slender. M has rank 3; without inertia about its axis, at 0, the "
        "mechanism has no motion.",
        "J_3 / J_1", (1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 0.0), lambda _: quaternion_body(), slender,
        variants=CONSTRAINED, reduced=(1e-1,),
    ),
    Case(
        "cranks", "Redundant rows, from a start in line",
        "Three parallel cranks with one coupler: of four rows three are independent, and only two if cranks and "
        "coupler are in line. The motion starts at an angle from this position, with least norm.",
        "angle [rad]", (1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 0.0), lambda _: three_cranks(), cranks,
        variants=_LEAST_NORM, reduced=(1.0, 0.0),
    ),
)  # fmt: skip
