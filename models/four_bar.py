"""Four-bar linkage: crank, coupler and rocker between two fixed pins.

::

               b    ____----o
           q2 ___---       /
          o---            /  c
       a /               /  q3           | g
        / q1            /                v
       o---------------o
               d

Coordinates: q1, q2, q3 [rad], directions of the three bars. Bars: slender, of lengths a, b, c and `density` [kg/m].
Holonomic constraints: closure of the loop a + b = d + c, horizontally and vertically.

Oracles: Lagrange equations; high-precision integration; reduction to one coordinate by the loop in closed form.
"""

from math import acos, atan2, hypot
from math import cos as c_
from math import sin as s_

from sympy import Expr, Matrix, Rational, cos, pi, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t

q1, q2, q3 = dynamicsymbols("q1:4")
a, b, c, d, density = symbols("a b c d density", positive=True)
g = symbols("g", real=True)


def bar(length: Expr, angle: Expr) -> Matrix:
    """Return the vector along a bar."""
    return length * Matrix([cos(angle), sin(angle)])


def kinetic_energy(length: Expr, angle: Expr, foot: Matrix) -> Expr:
    """Return the kinetic energy of a slender bar that begins at `foot`."""
    velocity = (foot + bar(length / 2, angle)).diff(t)
    return Rational(1, 2) * density * length * (velocity.dot(velocity) + length**2 / 12 * angle.diff() ** 2)


crank, coupler, rocker = bar(a, q1), bar(b, q2), bar(c, q3)
middle = crank + coupler / 2
start, ground = Matrix([0, 0]), Matrix([d, 0])
loop = crank + coupler - rocker - ground
moment = a * (crank / 2)[1] + b * (crank + coupler / 2)[1] + c * (rocker / 2)[1]

# closed loop with a vertical crank and the coupler above
sizes = {a: 0.4, b: 1.0, c: 0.8, d: 1.0}
crank_rate = 4.0
across, along, diagonal = sizes[d], -sizes[a], hypot(sizes[a], sizes[d])
above = acos((sizes[b] ** 2 + diagonal**2 - sizes[c] ** 2) / (2 * sizes[b] * diagonal))
angle1 = float(pi / 2)
angle2 = atan2(along, across) + above
angle3 = atan2(sizes[a] + sizes[b] * s_(angle2), sizes[b] * c_(angle2) - sizes[d])

model = Model(
    name="four_bar",
    coordinates=[q1, q2, q3],
    kinetic_energy=kinetic_energy(a, q1, start) + kinetic_energy(b, q2, crank) + kinetic_energy(c, q3, ground),
    potential_energy=density * g * moment,
    holonomic_constraints=list(loop),
    parameters=sizes | {density: 1.0, g: 9.81},
    initial={
        q1: angle1,
        q2: angle2,
        q3: angle3,
        q1.diff(): crank_rate,
        q2.diff(): crank_rate * sizes[a] * s_(angle1 - angle3) / (sizes[b] * s_(angle3 - angle2)),
        q3.diff(): crank_rate * sizes[a] * s_(angle1 - angle2) / (sizes[c] * s_(angle3 - angle2)),
    },
    drawing=[
        draw.Trace(middle),
        draw.Ground(start),
        draw.Ground(ground),
        draw.Line(start, crank),
        draw.Line(crank, crank + coupler),
        draw.Line(ground, ground + rocker),
        draw.Disk(middle, a / 20),
    ],
)
