"""Elastic pendulum: a point mass on a swinging spring.

::

    -----o-----
         |\\
         | /  r, natural length L, stiffness k
         | \\
       theta O m          | g
                          v

Coordinates: theta [rad] from the downward vertical, r [m]; their units differ.

Oracles: Lagrange equations; high-precision integration.
"""

from sympy import Rational, cos, pi, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw

theta, r = dynamicsymbols("theta r")
m, k, g, L = symbols("m k g L", positive=True)

position = r * sin(theta), -r * cos(theta)

model = Model(
    name="elastic_pendulum",
    coordinates=[theta, r],
    kinetic_energy=Rational(1, 2) * m * (r.diff() ** 2 + r**2 * theta.diff() ** 2),
    potential_energy=Rational(1, 2) * k * (r - L) ** 2 - m * g * r * cos(theta),
    parameters={m: 1.0, k: 100.0, g: 9.81, L: 1.0},
    initial={theta: pi / 6, r: 1.2},
    drawing=[draw.Trace(position), draw.Ground((0, 0)), draw.Spring((0, 0), position), draw.Disk(position, L / 10)],
)
