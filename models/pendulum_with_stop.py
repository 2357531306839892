"""Pendulum with a stop: it strikes a wall, and finally leans on it.

::

    -----o-----
      wall\\
          |\\  l
          | \\
          |  O m        | g
                        v

Coordinate: theta [rad], from the downward vertical. The wall is at theta = stop; the coefficient of restitution is e.

Oracle: Jacobi's elliptic functions between impacts; each impact multiplies the kinetic energy by e^2.
"""

from sympy import Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Contact, Model, draw

theta = dynamicsymbols("theta")
m, l = symbols("m l", positive=True)
e = symbols("e", nonnegative=True)
g, stop = symbols("g stop", real=True)

position = l * sin(theta), -l * cos(theta)
wall = l * sin(stop), -l * cos(stop)

model = Model(
    name="pendulum_with_stop",
    coordinates=[theta],
    kinetic_energy=Rational(1, 2) * m * (l * theta.diff()) ** 2,
    potential_energy=-m * g * l * cos(theta),
    contacts={"wall": Contact(l * (theta - stop), restitution=e, rest=Rational(1, 1000))},
    parameters={m: 1.0, l: 1.0, g: 9.81, e: 0.8, stop: 0.1},
    initial={theta: 1.2},
    drawing=[draw.Ground((0, 0)), draw.Line((0, 0), wall), draw.Line((0, 0), position), draw.Disk(position, l / 10)],
)
