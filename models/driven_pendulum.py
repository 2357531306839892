"""Pendulum with a vertically driven pivot, in Cartesian coordinates: a constraint that depends on time.

::

          ^  a cos(w t)
       ---o---
          v\\
            \\  l
             \\
              O m  (x, y)       | g
                                v

Coordinates: x, y [m]; y upwards from the middle of the pivot's motion.
Holonomic constraint: x^2 + (y - a cos(w t))^2 = l^2, so that b(t) is not 0 (8).

Oracle: the equation of Mathieu's type for the angle, by high-precision integration.
"""

from sympy import Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t

x, y = dynamicsymbols("x y")
m, l = symbols("m l", positive=True)
g, a, w = symbols("g a w", real=True)

pivot = a * cos(w * t)
values = {m: 1.0, l: 1.0, g: 9.81, a: 0.25, w: 5.0}
swing = 0.8

model = Model(
    name="driven_pendulum",
    coordinates=[x, y],
    kinetic_energy=Rational(1, 2) * m * (x.diff() ** 2 + y.diff() ** 2),
    potential_energy=m * g * y,
    holonomic_constraints=[x**2 + (y - pivot) ** 2 - l**2],
    parameters=values,
    initial={x: values[l] * sin(swing), y: values[a] - values[l] * cos(swing)},
    drawing=[
        draw.Trace((x, y)),
        draw.Ground((-l / 20, -a), (-l / 20, a)),
        draw.Line((0, pivot), (x, y)),
        draw.Disk((0, pivot), l / 20),
        draw.Disk((x, y), l / 12),
    ],
)
