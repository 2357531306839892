"""Free rigid body with three different moments of inertia, in body rates.

::

          3  J3
          |   .-----------.
          |  /           /|        psi:   about the fixed z axis, the direction
          . /-----------. |               of the angular momentum at the start
           |           |  .-- 2 J2 theta: tilt of body axis 3 from z
           |           | /         phi:   about body axis 3
           '-----------'
          /
         1  J1

Coordinates: psi, theta, phi [rad], Euler angles 3-1-3.
Quasi-velocities: omega_1, omega_2, omega_3 [rad/s], the angular velocity in body axes.

Oracle: Euler's equations solved by Jacobi's elliptic functions; the angles follow from the constant angular momentum.
"""

from itertools import product

from sympy import Matrix, Rational, cos, rot_ccw_axis1, rot_ccw_axis3, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw

psi, theta, phi = dynamicsymbols("psi theta phi")
omega_1, omega_2, omega_3 = dynamicsymbols("omega_1:4")
J1, J2, J3 = symbols("J1:4", positive=True)

attitude = rot_ccw_axis3(psi) * rot_ccw_axis1(theta) * rot_ccw_axis3(phi)
# half the sides of a plate with these moments of inertia, up to scale; its thickness is for the picture only
sides = sqrt(J2 + J3 - J1) / 2, sqrt(J1 + J3 - J2) / 2, sqrt(J3) / 20
corners = [
    attitude * Matrix([s * half for s, half in zip(signs, sides, strict=True)]) for signs in product((-1, 1), repeat=3)
]

J = {J1: 1.0, J2: 2.0, J3: 3.0}
tilt, turn, momentum = 1.2, 1.4, 2.0

model = Model(
    name="rigid_body",
    coordinates=[psi, theta, phi],
    quasi_velocities={
        omega_1: psi.diff() * sin(theta) * sin(phi) + theta.diff() * cos(phi),
        omega_2: psi.diff() * sin(theta) * cos(phi) - theta.diff() * sin(phi),
        omega_3: psi.diff() * cos(theta) + phi.diff(),
    },
    kinetic_energy=Rational(1, 2) * (J1 * omega_1**2 + J2 * omega_2**2 + J3 * omega_3**2),
    parameters=J,
    initial={
        theta: tilt,
        phi: turn,
        omega_1: momentum * sin(tilt) * sin(turn) / J[J1],
        omega_2: momentum * sin(tilt) * cos(turn) / J[J2],
        omega_3: momentum * cos(tilt) / J[J3],
    },
    drawing=[draw.Body(corners), draw.Trace(attitude * Matrix([sides[0], 0, 0]))],
)
