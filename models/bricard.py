"""Bricard's mechanism: an overconstrained loop of five bars on the edges of a cube and six revolute joints.

::

           D-----C                 the bars O-A-B-C-D-E, each along an edge; joints at O, A, B, C, D, E
          /|    /                  about the axes of y, z, x, y, z and x
         / |   B---                joints at O and E in the ground, E above O
        E  |   |       z
           |   |     | / x
        O--|---A     |/___         | g, along -y
                                   v

Coordinates: q1 ... q5 [rad], angles of the joints, starting at O.
Holonomic constraints: the end of the fifth bar and the axis of its joint are fixed. Of these five rows, four are
independent on the constraint manifold. Gruebler's count gives no degree of freedom, but the symmetry of the cube gives
one. The dependent row is left out.

Source: the benchmark "Bricard mechanism" of the IFToMM Technical Committee for Multibody Dynamics (M. Gonzalez, D.
Dopico, U. Lugris and J. Cuadrado, A benchmarking system for MBS simulation software, Multibody System Dynamics 16,
2006).
Oracles: the energy, and the row that was left out.
"""

from itertools import pairwise

from sympy import Expr, Matrix, Rational, cos, eye, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t

m, l = symbols("m l", positive=True)
g = symbols("g", real=True)
angles = dynamicsymbols("q1:6")
AXES = (1, 2, 0, 1, 2)
EDGES = (Matrix([1, 0, 0]), Matrix([0, 1, 0]), Matrix([0, 0, 1]), Matrix([-1, 0, 0]), Matrix([0, -1, 0]))


def rotation(axis: int, angle: Expr) -> Matrix:
    """Return the rotation matrix about a coordinate axis."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    R = eye(3)
    R[i, i] = R[j, j] = cos(angle)
    R[i, j], R[j, i] = -sin(angle), sin(angle)
    return R


R, joints = eye(3), [Matrix([0, 0, 0])]
for angle, axis, edge in zip(angles, AXES, EDGES, strict=True):
    R = R * rotation(axis, angle)
    joints.append(joints[-1] + l * R * edge)
bars = list(pairwise(joints))
speeds = [(a.diff(t), b.diff(t)) for a, b in bars]
closing = [*(joints[-1] - l * Matrix([0, 0, 1])), R[1, 0], R[2, 0]]


def upright(p: Matrix) -> tuple[Expr, Expr, Expr]:
    """Return a position in the axes of the drawing, whose last component is the height."""
    return p[0], -p[2], p[1]


model = Model(
    name="bricard",
    coordinates=angles,
    kinetic_energy=Rational(1, 6) * m * sum(a.dot(a) + a.dot(b) + b.dot(b) for a, b in speeds),
    potential_energy=m * g * sum((a + b)[1] for a, b in bars) / 2,
    holonomic_constraints=[closing[k] for k in (0, 1, 2, 4)],
    parameters={m: 1.0, l: 1.0, g: 9.81},
    drawing=[
        draw.Ground(upright(joints[0])),
        draw.Ground(upright(l * Matrix([0, 0, 1]))),
        *(draw.Line(upright(a), upright(b)) for a, b in bars),
        *(draw.Disk(upright(joint), l / 20) for joint in joints),
        draw.Trace(upright(joints[3])),
    ],
)
