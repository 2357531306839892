"""Rolling disk: a thin disk, such as a coin, that rolls upright or leaning on a rough plane.

::

       z  b: axle
       |   \\    .--.                phi:   direction of travel, from x
       |    \\ /  n \\   theta: lean   theta: lean of the disk from the vertical
       |     /\\  |  |   to the left  psi:   rolled angle
       |    |  O |  /
       |     \\ r |/                  | g
       o------\\._o (x, y) ---> travel v

Coordinates: x, y [m] of the point of contact; phi, theta, psi [rad].
Nonholonomic constraints: no slip, xdot = r psidot cos phi, ydot = r psidot sin phi.
It starts on the steady circle for its lean and rate of turn.

Oracle: steady motion, m g r sin(theta) = W cos(theta) ((J3 + m r^2) w + J W sin(theta)), with the rate of turn W, the
angular velocity w about the axle, J = m r^2 / 4 and J3 = 2 J.
"""

from sympy import Matrix, Rational, cos, sin, symbols, tan
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t

x, y, phi, theta, psi = dynamicsymbols("x y phi theta psi")
m, r = symbols("m r", positive=True)
g = symbols("g", real=True)

left = Matrix([-sin(phi), cos(phi), 0])
centre = Matrix([x, y, 0]) + r * (cos(theta) * Matrix([0, 0, 1]) + sin(theta) * left)
velocity = centre.diff(t)
axle = cos(theta) * left - sin(theta) * Matrix([0, 0, 1])

J = m * r**2 / 4
across = theta.diff() ** 2 + (phi.diff() * cos(theta)) ** 2
about_axle = psi.diff() - phi.diff() * sin(theta)

mass, radius, gravity, lean, turn = 1.0, 0.5, 9.81, 0.3, 1.0
J_value = mass * radius**2 / 4
spin = (mass * gravity * radius * tan(lean) / turn - J_value * turn * sin(lean)) / (2 * J_value + mass * radius**2)
roll = spin + turn * sin(lean)

model = Model(
    name="rolling_disk",
    coordinates=[x, y, phi, theta, psi],
    kinetic_energy=Rational(1, 2) * (m * velocity.dot(velocity) + J * across + 2 * J * about_axle**2),
    potential_energy=m * g * centre[2],
    nonholonomic_constraints=[
        x.diff() - r * psi.diff() * cos(phi),
        y.diff() - r * psi.diff() * sin(phi),
    ],
    parameters={m: mass, r: radius, g: gravity},
    initial={theta: lean, x.diff(): radius * roll, phi.diff(): turn, psi.diff(): roll},
    drawing=[
        draw.Trace((x, y, 0)),
        draw.Ground((-4 * r, -2 * r, 0), (6 * r, -2 * r, 0), (6 * r, 8 * r, 0), (-4 * r, 8 * r, 0)),
        draw.Disk(centre, r, angle=psi, axis=axle),
    ],
)
