"""Block with Coulomb friction on an incline: it slides up, stops, and then sticks or slides back.

::

              __--|
          __[m]   |     | g
      __--   s ^  |     v
    --__alpha_____|

Coordinate: s [m], up the slope; friction mu.

Oracle: constant accelerations. It stops after s'(0) / (g (sin alpha + mu cos alpha)), and sticks if mu > tan alpha.
"""

from sympy import Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Friction, Model, draw

s = dynamicsymbols("s")
m = symbols("m", positive=True)
mu = symbols("mu", nonnegative=True)
g, alpha = symbols("g alpha", real=True)
length = Rational(3, 2)
along, across = (cos(alpha), sin(alpha)), (-sin(alpha), cos(alpha))

corners = [(a, b) for a, b in ((-1, 0), (1, 0), (1, 1), (-1, 1))]
block = [tuple(s * u + (a * u + b * w) / 10 for u, w in zip(along, across, strict=True)) for a, b in corners]

model = Model(
    name="block_on_incline",
    coordinates=[s],
    kinetic_energy=Rational(1, 2) * m * s.diff() ** 2,
    potential_energy=m * g * s * sin(alpha),
    contacts={"friction": Friction(slip=s.diff(), limit=mu * m * g * cos(alpha))},
    parameters={m: 1.0, g: 9.81, alpha: 0.4, mu: 0.5},
    initial={s.diff(): 3.0},
    drawing=[draw.Line((0, 0), tuple(length * u for u in along)), draw.Body(block)],
)
