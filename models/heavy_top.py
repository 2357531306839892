"""Lagrange's top: a symmetric top with a fixed point, under gravity.

::

       z |    / 3: figure axis
         |theta    spin psi
         |  C  O m
         |    /
         |   /  l
         |  /           | g
         | /            v
     ----o----   precession phi about z

Coordinates: phi, theta, psi [rad], Euler angles 3-1-3. J: moment of inertia about axes through the fixed point,
perpendicular to the figure axis; J3: about it. The axis is released at rest: it falls, precesses, and comes to rest
again.

Oracle: u = cos theta satisfies udot^2 = cubic(u), solved by Weierstrass' elliptic function; phi and psi by quadrature;
steady precession in closed form.
"""

from sympy import Matrix, Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw

phi, theta, psi = dynamicsymbols("phi theta psi")
m, l, J, J3 = symbols("m l J J3", positive=True)
g = symbols("g", real=True)

across = theta.diff() ** 2 + (phi.diff() * sin(theta)) ** 2
along = psi.diff() + phi.diff() * cos(theta)

axis = Matrix([sin(theta) * sin(phi), -sin(theta) * cos(phi), cos(theta)])

model = Model(
    name="heavy_top",
    coordinates=[phi, theta, psi],
    kinetic_energy=Rational(1, 2) * (J * across + J3 * along**2),
    potential_energy=m * g * l * cos(theta),
    parameters={m: 1.0, l: 0.2, g: 9.81, J: 0.05, J3: 0.02},
    initial={theta: 0.6, psi.diff(): 40.0},
    drawing=[
        draw.Ground((0, 0, 0)),
        draw.Line((0, 0, 0), l * Rational(5, 4) * axis),
        draw.Disk(l * axis, l * Rational(3, 5), angle=psi, axis=axis),
        draw.Trace(l * Rational(5, 4) * axis),
    ],
)
