"""Double pendulum: two point masses on massless rods.

::

    -----o-----
         |\\  l1
         | \\
      theta1 O m1
             |\\  l2
             | \\
          theta2 O m2     | g
                          v

Coordinates: theta1, theta2 [rad], both from the downward vertical.

Oracles: Lagrange equations; high-precision integration.
"""

from sympy import Matrix, Rational, cos, pi, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t

theta1, theta2 = dynamicsymbols("theta1 theta2")
m1, m2, l1, l2 = symbols("m1 m2 l1 l2", positive=True)
g = symbols("g", real=True)

position1 = l1 * Matrix([sin(theta1), -cos(theta1)])
position2 = position1 + l2 * Matrix([sin(theta2), -cos(theta2)])
velocity1, velocity2 = position1.diff(t), position2.diff(t)

model = Model(
    name="double_pendulum",
    coordinates=[theta1, theta2],
    kinetic_energy=Rational(1, 2) * (m1 * velocity1.dot(velocity1) + m2 * velocity2.dot(velocity2)),
    potential_energy=g * (m1 * position1[1] + m2 * position2[1]),
    parameters={m1: 1.0, m2: 1.0, l1: 1.0, l2: 1.0, g: 9.81},
    initial={theta1: pi / 2, theta2: pi / 3},
    drawing=[
        draw.Trace(position2),
        draw.Ground((0, 0)),
        draw.Line((0, 0), position1),
        draw.Line(position1, position2),
        draw.Disk(position1, l1 / 12),
        draw.Disk(position2, l2 / 12),
    ],
)
