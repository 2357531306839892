"""Pendulum: a point mass on a massless rod.

::

    -----o-----
         |\\
         | \\  l
         |  \\
         theta O m        | g
                          v

Coordinate: theta [rad], from the downward vertical.

Oracle: Jacobi's elliptic functions.
"""

from sympy import Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw

theta = dynamicsymbols("theta")
m, l = symbols("m l", positive=True)
g = symbols("g", real=True)

position = l * sin(theta), -l * cos(theta)

model = Model(
    name="pendulum",
    coordinates=[theta],
    kinetic_energy=Rational(1, 2) * m * (l * theta.diff()) ** 2,
    potential_energy=-m * g * l * cos(theta),
    parameters={m: 1.0, l: 1.0, g: 9.81},
    initial={theta: 2.0},
    drawing=[draw.Trace(position), draw.Ground((0, 0)), draw.Line((0, 0), position), draw.Disk(position, l / 10)],
)
