"""Bead on a hoop that turns about its vertical diameter at a constant rate: T has a part T0.

::

          | Omega
        . + .
      .   |   .
     .    |    .
     .    +---R.
      .   |\\  .       | g
        . |.O m        v
        theta

Coordinate: theta [rad], from the lowest point.

Oracle: u = cos theta satisfies udot^2 = quartic(u), solved by Weierstrass' elliptic function.
"""

from sympy import Matrix, Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t

theta = dynamicsymbols("theta")
m, R = symbols("m R", positive=True)
Omega, g = symbols("Omega g", real=True)

across = Matrix([cos(Omega * t), sin(Omega * t), 0])
bead = R * (sin(theta) * across - cos(theta) * Matrix([0, 0, 1]))

model = Model(
    name="rotating_hoop",
    coordinates=[theta],
    kinetic_energy=Rational(1, 2) * m * R**2 * (theta.diff() ** 2 + (Omega * sin(theta)) ** 2),
    potential_energy=-m * g * R * cos(theta),
    parameters={m: 1.0, R: 0.5, Omega: 6.0, g: 9.81},
    initial={theta: 0.5},
    drawing=[
        draw.Line((0, 0, -R * Rational(5, 4)), (0, 0, R * Rational(5, 4))),
        draw.Disk((0, 0, 0), R, axis=(-across[1], across[0], 0)),
        draw.Disk(bead, R / 12),
        draw.Trace(bead),
    ],
)
