"""Kepler's problem in polar coordinates: a particle that orbits a centre of attraction.

::

              . - ~ - .
          .               O m
        .           r  /    .
       .            /        .
       .        (*)  theta   .-- theta = 0: pericentre
        .       mu          .
          .               .
              ' - . - '

Coordinates: r [m], theta [rad]. It starts at the pericentre of an ellipse with semi-major axis 1 m, eccentricity 0.9.

Oracle: Kepler's equation.
"""

from sympy import Rational, cos, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw

r, theta = dynamicsymbols("r theta")
m = symbols("m", positive=True)
mu = symbols("mu", nonnegative=True)
eccentricity = Rational(9, 10)
pericentre = 1 - eccentricity

position = r * cos(theta), r * sin(theta)

model = Model(
    name="polar_particle",
    coordinates=[r, theta],
    kinetic_energy=Rational(1, 2) * m * (r.diff() ** 2 + r**2 * theta.diff() ** 2),
    potential_energy=-mu * m / r,
    parameters={m: 1.0, mu: 1.0},
    initial={r: pericentre, theta.diff(): sqrt((1 + eccentricity) / pericentre**3)},
    drawing=[draw.Trace(position), draw.Disk((0, 0), Rational(1, 20)), draw.Disk(position, Rational(1, 40))],
)
