"""Eigenvalue veering: two eigenvalues of M approach each other at x = 0 up to the gap, and exchange their eigenvectors.

::

    eigenvalues of M
      \\         /
       \\       /        M = | 2 + x/2   gap     |
        `-----'             | gap       2 - x/2 |
        .-----.   2 gap
       /       \\
      /         \\
    --------0---------> x

Coordinates: x, z [m]. If `gap` is 0, the eigenvalues cross.

No drawing: this M is a test case without a mechanical counterpart.

Oracles: Lagrange equations; high-precision integration.
"""

from sympy import Rational, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model

x, z = dynamicsymbols("x z")
gap, k_x, k_z = symbols("gap k_x k_z", real=True)

half = Rational(1, 2)

model = Model(
    name="veering",
    coordinates=[x, z],
    kinetic_energy=half * ((2 + x / 2) * x.diff() ** 2 + 2 * gap * x.diff() * z.diff() + (2 - x / 2) * z.diff() ** 2),
    potential_energy=half * (k_x * x**2 + k_z * z**2),
    parameters={gap: 1e-3, k_x: 4.0, k_z: 1.0},
    initial={x: 1.0, z: 0.5, z.diff(): 0.3},
)
