"""Slider-crank: crank, connecting rod and a slider on a horizontal guide.

::

          o
     r  /   ` - .  l
       / theta    ` - . phi
      o - - - - - - - - [o] m_s ----> x
                       =======           | g
                                         v

Coordinates: theta, phi [rad], angles of crank and rod with the guide, phi positive downwards; x [m] of the slider.
Crank and rod: slender, of masses m_c and m_r.
Holonomic constraints: the rod ends at the slider, along the guide and perpendicular to it.

Oracles: Newton's second law of the slider for the multiplier; Lagrange equations; high-precision integration; reduction
to one coordinate by the loop in closed form.
"""

from math import asin
from math import cos as c_
from math import sin as s_

from sympy import Matrix, Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t

theta, phi, x = dynamicsymbols("theta phi x")
r, l, m_r = symbols("r l m_r", positive=True)
m_c, m_s = symbols("m_c m_s", nonnegative=True)
g = symbols("g", real=True)

pin = r * Matrix([cos(theta), sin(theta)])
rod = l * Matrix([cos(phi), -sin(phi)])
velocity = (pin + rod / 2).diff(t)
half = r / 3

crank_energy = Rational(1, 6) * m_c * r**2 * theta.diff() ** 2
rod_energy = Rational(1, 2) * m_r * (velocity.dot(velocity) + l**2 / 12 * phi.diff() ** 2)
slider_energy = Rational(1, 2) * m_s * x.diff() ** 2

# closed loop at a crank angle of 1 rad
crank_angle, crank_rate, crank_length, rod_length = 1.0, 5.0, 0.3, 1.0
rod_angle = asin(crank_length * s_(crank_angle) / rod_length)
rod_rate = crank_rate * crank_length * c_(crank_angle) / (rod_length * c_(rod_angle))

model = Model(
    name="slider_crank",
    coordinates=[theta, phi, x],
    kinetic_energy=crank_energy + rod_energy + slider_energy,
    potential_energy=g * (m_c * (pin / 2)[1] + m_r * (pin + rod / 2)[1]),
    holonomic_constraints=[x - (pin + rod)[0], (pin + rod)[1]],
    parameters={r: crank_length, l: rod_length, m_c: 1.0, m_r: 1.0, m_s: 2.0, g: 9.81},
    initial={
        theta: crank_angle,
        phi: rod_angle,
        x: crank_length * c_(crank_angle) + rod_length * c_(rod_angle),
        theta.diff(): crank_rate,
        phi.diff(): rod_rate,
        x.diff(): -crank_length * crank_rate * s_(crank_angle) - rod_length * rod_rate * s_(rod_angle),
    },
    drawing=[
        draw.Ground((0, 0)),
        draw.Ground((l - r - half, -half), (l + r + half, -half)),
        draw.Body([(x - half, -half), (x + half, -half), (x + half, half), (x - half, half)]),
        draw.Line((0, 0), pin),
        draw.Line(pin, pin + rod),
        draw.Trace(pin + rod / 2),
    ],
)
