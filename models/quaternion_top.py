"""Lagrange's top by the four numbers of a unit quaternion: M is singular everywhere, the mechanism is not.

::

       z |    / 3: figure axis
         |   /
         |  C  q: the rotation from the axes of the
         |  /     ground to those of the top
         | /  l
         |/               | g
     ----o----            v

Coordinates: q_0 [1], q_1, q_2, q_3 [1], the quaternion q. omega = 2 G(q) qdot [rad/s] is the angular velocity in the
axes of the top, G (3, 4), so that M = 4 G^T J G has rank three whatever q is: no inertia resists a change of |q|.
Holonomic constraint: |q|^2 = 1, which makes up for it. The top is that of heavy_top.py, with less spin: it falls deep,
and no attitude is singular here. Two eigenvalues of what is factored are equal for ever, as two moments of inertia are.

Oracle: heavy_top.py's closed form in Euler angles, of which q follows.
"""

from math import cos, sin

from sympy import Matrix, Rational, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, t

q = dynamicsymbols("q_0:4")
m, l, g, J, J3 = symbols("m l g J J3", positive=True)

real, vector = q[0], Matrix(q[1:])
omega = 2 * (real * vector.diff(t) - real.diff(t) * vector - vector.cross(vector.diff(t)))
height = l * (q[0] ** 2 - q[1] ** 2 - q[2] ** 2 + q[3] ** 2)

tilt, spin = 0.6, 10.0
up, across = cos(tilt / 2), sin(tilt / 2)

model = Model(
    name="quaternion_top",
    coordinates=q,
    kinetic_energy=Rational(1, 2) * (J * (omega[0] ** 2 + omega[1] ** 2) + J3 * omega[2] ** 2),
    potential_energy=m * g * height,
    holonomic_constraints=[sum(entry**2 for entry in q) - 1],
    parameters={m: 1.0, l: 0.2, g: 9.81, J: 0.05, J3: 0.02},
    initial={q[0]: up, q[1]: across, q[2].diff(): -spin * across / 2, q[3].diff(): spin * up / 2},
)
