"""Chaplygin's sleigh: a body on ice, supported by two smooth feet and a blade that cannot slip sideways.

::

                    . - - - - .
                  .             .
      blade   ===(x, y)---a---C  .   --> theta, direction of the blade
                  .             .        C: centre of mass, m, J
                    ' - - - - '

Coordinates: x, y [m] of the blade, theta [rad] its direction.
Nonholonomic constraint: no velocity across the blade. It starts with the blade in front, and turns round.

Oracle: closed form, speed and turning rate in hyperbolic functions.
"""

from sympy import Matrix, Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t

x, y, theta = dynamicsymbols("x y theta")
m, J, a = symbols("m J a", positive=True)

centre = Matrix([x, y]) + a * Matrix([cos(theta), sin(theta)])
velocity = centre.diff(t)
blade = a / 2 * Matrix([cos(theta), sin(theta)])

model = Model(
    name="chaplygin_sleigh",
    coordinates=[x, y, theta],
    kinetic_energy=Rational(1, 2) * (m * velocity.dot(velocity) + J * theta.diff() ** 2),
    nonholonomic_constraints=[-sin(theta) * x.diff() + cos(theta) * y.diff()],
    parameters={m: 1.0, J: 0.5, a: 0.4},
    initial={x.diff(): -1.0, theta.diff(): 0.8},
    drawing=[
        draw.Trace((x, y)),
        draw.Disk(centre, a * Rational(4, 5)),
        draw.Disk(centre, a / 12),
        draw.Line(Matrix([x, y]) - blade, Matrix([x, y]) + blade),
    ],
)
