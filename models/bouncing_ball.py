"""Bouncing ball: it bounces with decreasing height, comes to rest on the floor, and then slides without friction.

::

      z ^    O m        | g
        |   /  \\  ..    v
        +--/----\\/--\\/\\_____> x

Coordinates: x, z [m] of its lowest point. The coefficient of restitution is e.

Oracle: parabolas. After the fall, t_0 = sqrt(2 h / g), bounce k takes 2 e^k t_0.
"""

from sympy import Rational, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Contact, Model, draw

x, z = dynamicsymbols("x z")
m, r = symbols("m r", positive=True)
e = symbols("e", nonnegative=True)
g = symbols("g", real=True)

model = Model(
    name="bouncing_ball",
    coordinates=[x, z],
    kinetic_energy=Rational(1, 2) * m * (x.diff() ** 2 + z.diff() ** 2),
    potential_energy=m * g * z,
    contacts={"floor": Contact(z, restitution=e, rest=Rational(1, 1000))},
    parameters={m: 1.0, g: 9.81, e: 0.9, r: 0.05},
    initial={z: 1.0, x.diff(): 0.2},
    drawing=[draw.Trace((x, z + r)), draw.Line((-1, 0), (3, 0)), draw.Disk((x, z + r), r)],
)
