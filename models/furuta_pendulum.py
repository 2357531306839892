"""Rotary inverted pendulum: a pendulum at the end of an arm that a motor turns (Furuta et al., 1992).

::

              o  rod: m, l to its centre of mass, J about it; phi from upright
             /
            /  phi
           o-----------|  arm of length r, inertia J0 with the motor; theta
                       |
                      u(t), torque of the motor

Coordinates: theta, angle of the arm about the vertical [rad]; phi, angle of the rod from upright, in the plane
perpendicular to the arm [rad]. The rod is slender. Viscous friction b0, b1 in the joints. Input: u [N m].

Oracles: Lagrange equations; high-precision integration.
"""

from sympy import Rational, cos, pi, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw

theta, phi, u = dynamicsymbols("theta phi u")
J0, J, m, r, l = symbols("J0 J m r l", positive=True)
b0, b1 = symbols("b0 b1", nonnegative=True)
g = symbols("g", real=True)

half = Rational(1, 2)
arm = r * cos(theta), r * sin(theta), 0
across = -sin(theta), cos(theta)
tip = tuple(a + 2 * l * d for a, d in zip(arm, (sin(phi) * across[0], sin(phi) * across[1], cos(phi)), strict=True))

omega, turn = theta.diff(), phi.diff()

kinetic_energy = (
    half * (J0 + m * r**2) * omega**2
    + half * (J + m * l**2) * (turn**2 + sin(phi) ** 2 * omega**2)
    + m * r * l * cos(phi) * omega * turn
)

model = Model(
    name="furuta_pendulum",
    coordinates=[theta, phi],
    kinetic_energy=kinetic_energy,
    potential_energy=m * g * l * cos(phi),
    forces={theta: u - b0 * omega, phi: -b1 * turn},
    inputs={u: 0.0},
    outputs={"height of the tip": 2 * l * cos(phi)},
    parameters={J0: 2e-3, J: 3.3e-4, m: 0.1, r: 0.2, l: 0.1, g: 9.81, b0: 1e-3, b1: 1e-4},
    initial={phi: pi / 30},
    drawing=[
        draw.Trace(tip),
        draw.Ground((0, 0, 0)),
        draw.Line((0, 0, 0), arm),
        draw.Line(arm, tip),
        draw.Disk(tip, l / 8),
    ],
)
