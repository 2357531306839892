"""Lagrange's top in unit quaternions: M is singular everywhere, but regular on the constraint.

::

       z |    / 3: figure axis
         |   /
         |  C  q: the rotation from the axes of the
         |  /     ground to those of the top
         | /  l
         |/               | g
     ----o----            v

Coordinates: q_0 [1], q_1, q_2, q_3 [1], the quaternion q. omega = 2 G(q) qdot [rad/s] is the angular velocity in the
axes of the top, with G (3, 4), so that M = 4 G^T J G has rank three for every q: no inertia resists a change of |q|.
Holonomic constraint: |q|^2 = 1, which makes the system regular. The top is that of heavy_top.py with less spin, so that
it falls far; quaternions have no singular attitude. Two eigenvalues of the factored matrix are always equal, because
two moments of inertia are.

Oracle: the closed form of heavy_top.py in Euler angles, from which q follows.
"""

from math import cos, sin

from sympy import Matrix, Rational, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t

q = dynamicsymbols("q_0:4")
m, l, J, J3 = symbols("m l J J3", positive=True)
g = symbols("g", real=True)

real, vector = q[0], Matrix(q[1:])
omega = 2 * (real * vector.diff(t) - real.diff(t) * vector - vector.cross(vector.diff(t)))
height = l * (q[0] ** 2 - q[1] ** 2 - q[2] ** 2 + q[3] ** 2)

axis = Matrix([2 * (q[1] * q[3] + q[0] * q[2]), 2 * (q[2] * q[3] - q[0] * q[1]), height / l])
across = Matrix(
    [q[0] ** 2 + q[1] ** 2 - q[2] ** 2 - q[3] ** 2, 2 * (q[1] * q[2] + q[0] * q[3]), 2 * (q[1] * q[3] - q[0] * q[2])]
)
radius = l * Rational(3, 5)

tilt, spin = 0.6, 10.0
half_cos, half_sin = cos(tilt / 2), sin(tilt / 2)

model = Model(
    name="quaternion_top",
    coordinates=q,
    kinetic_energy=Rational(1, 2) * (J * (omega[0] ** 2 + omega[1] ** 2) + J3 * omega[2] ** 2),
    potential_energy=m * g * height,
    holonomic_constraints=[sum(entry**2 for entry in q) - 1],
    parameters={m: 1.0, l: 0.2, g: 9.81, J: 0.05, J3: 0.02},
    initial={q[0]: half_cos, q[1]: half_sin, q[2].diff(): -spin * half_sin / 2, q[3].diff(): spin * half_cos / 2},
    drawing=[
        draw.Ground((0, 0, 0)),
        draw.Line((0, 0, 0), l * Rational(5, 4) * axis),
        draw.Disk(l * axis, radius, axis=axis),
        draw.Line(l * axis, l * axis + radius * across),
        draw.Trace(l * Rational(5, 4) * axis),
    ],
)
