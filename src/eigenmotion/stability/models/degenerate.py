"""Mechanisms with rank-deficient M or A."""

from functools import cache

from sympy import Expr, Integer, Matrix, Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from ...codegen.model import Model
from ..expectation.closed_forms import WEIGHT

_HALF = Rational(1, 2)


@cache
def height_of_pendulum(heavy: bool = True) -> Model:
    """Return an elastic pendulum in theta, r, whose depth z = r cos(theta) is a coordinate, with a mass or without."""
    theta, r, z = dynamicsymbols("theta r z")
    m_z = symbols("m_z", positive=True)
    T, V, parameters = _elastic_pendulum(theta, r, z)
    return Model(
        name="height_of_pendulum" if heavy else "massless_height",
        coordinates=[theta, r, z],
        kinetic_energy=T + (_HALF * m_z * z.diff() ** 2 if heavy else 0),
        potential_energy=V,
        holonomic_constraints=[z - r * cos(theta)],
        parameters=parameters | ({m_z: 1.0} if heavy else {}),
        initial={r: 1.0, z: 1.0},
    )


@cache
def pendulum_with_bead() -> Model:
    """Return the same pendulum in theta and r only."""
    theta, r = dynamicsymbols("theta r")
    m_z = symbols("m_z", nonnegative=True)
    T, V, parameters = _elastic_pendulum(theta, r, r * cos(theta))
    height_rate = r.diff() * cos(theta) - r * theta.diff() * sin(theta)
    return Model(
        name="pendulum_with_bead",
        coordinates=[theta, r],
        kinetic_energy=T + _HALF * m_z * height_rate**2,
        potential_energy=V,
        parameters=parameters | {m_z: 0.0},
        initial={r: 1.0},
    )


def _elastic_pendulum(theta: Expr, r: Expr, depth: Expr) -> tuple[Expr, Expr, dict[Expr, float]]:
    m, k, g, L = symbols("m k g L", positive=True)
    T = _HALF * m * (r.diff() ** 2 + r**2 * theta.diff() ** 2)
    return T, _HALF * k * (r - L) ** 2 - m * g * depth, {m: 1.0, k: 50.0, g: 9.81, L: 1.0}


@cache
def quaternion_body() -> Model:
    """Return a heavy body with a fixed point in quaternions of unit length: omega = 2 G(q) q', M = 4 G^T J G."""
    a, b, c, d = q = dynamicsymbols("q_0:4")
    J = symbols("J_1:4", nonnegative=True)
    weight = symbols("mgl", real=True)
    omega = 2 * Matrix([[-b, a, d, -c], [-c, -d, a, b], [-d, c, -b, a]]) * Matrix(q).diff()
    return Model(
        name="quaternion_body",
        coordinates=q,
        kinetic_energy=sum((_HALF * j * w**2 for j, w in zip(J, omega, strict=True)), Integer(0)),
        potential_energy=weight * (a**2 - b**2 - c**2 + d**2),
        holonomic_constraints=[(a**2 + b**2 + c**2 + d**2 - 1) / 2],
        parameters=dict(zip(J, (0.05, 0.05, 0.05), strict=True)) | {weight: WEIGHT},
        initial={a: 1.0},
    )


@cache
def three_cranks() -> Model:
    """Return three parallel cranks that carry a coupler, turned by beta.

    ::

            .-------.-----.   coupler
           /       /     /
          o       o     o     theta_1, theta_2, theta_3
          0       1     1.7 [m]
    """
    angles, beta = dynamicsymbols("theta_1:4"), dynamicsymbols("beta")
    m, m_c, J_c, r, g = symbols("m m_c J_c r g", positive=True)
    feet = (Integer(0), Integer(1), Rational(17, 10))
    ends = [Matrix([foot + r * cos(angle), r * sin(angle)]) for foot, angle in zip(feet, angles, strict=True)]
    along = Matrix([cos(beta), sin(beta)])
    gaps = [ends[0] + (foot - feet[0]) * along - end for foot, end in zip(feet[1:], ends[1:], strict=True)]
    velocity = Matrix([-r * sin(angles[0]), r * cos(angles[0])]) * angles[0].diff()
    cranks = sum((m * r**2 * angle.diff() ** 2 / 3 for angle in angles), Integer(0))
    return Model(
        name="three_cranks",
        coordinates=[*angles, beta],
        kinetic_energy=_HALF * (cranks + m_c * velocity.dot(velocity) + J_c * beta.diff() ** 2),
        potential_energy=g * r * (sum((m * sin(angle) / 2 for angle in angles), Integer(0)) + m_c * sin(angles[0])),
        holonomic_constraints=[entry for gap in gaps for entry in gap],
        parameters={m: 1.0, m_c: 2.0, J_c: 0.5, r: 1.0, g: 9.81},
    )
