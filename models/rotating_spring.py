"""Mass on two springs in a plate that turns at a constant rate: T has parts T1 and T0.

::

        y |   Omega
          |  <-.
      k_y z     )
          z    /
    ------O-zzzzzz---- x
          m   k_x

Coordinates: x, y [m], displacements along the turning axes.

Oracle: linear equations with constant coefficients, solved by the matrix exponential.
"""

from sympy import Matrix, Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t

x, y = dynamicsymbols("x y")
m = symbols("m", positive=True)
k_x, k_y = symbols("k_x k_y", nonnegative=True)
Omega = symbols("Omega", real=True)

inertial_x, inertial_y = x.diff() - Omega * y, y.diff() + Omega * x

along = Matrix([cos(Omega * t), sin(Omega * t)])
across = Matrix([-sin(Omega * t), cos(Omega * t)])
mass, side = x * along + y * across, Rational(3, 2)

model = Model(
    name="rotating_spring",
    coordinates=[x, y],
    kinetic_energy=Rational(1, 2) * m * (inertial_x**2 + inertial_y**2),
    potential_energy=Rational(1, 2) * (k_x * x**2 + k_y * y**2),
    parameters={m: 1.0, k_x: 9.0, k_y: 14.0, Omega: 2.0},
    initial={x: 1.0, y.diff(): 0.5},
    drawing=[
        draw.Body([side * corner for corner in (along + across, across - along, -along - across, along - across)]),
        draw.Spring(-side * along, mass),
        draw.Spring(side * across, mass),
        draw.Disk(mass, side / 15),
        draw.Trace(mass),
    ],
)
