"""Two masses whose eigenvalues veer: they come close at x = 0, miss each other by the gap, and change roles.

::

    eigenvalues of M
      \\         /
       \\       /        M = | 2 + x/2   gap     |
        `-----'             | gap       2 - x/2 |
        .-----.   2 gap
       /       \\
      /         \\
    --------0---------> x

Coordinates: x, z [m]. `gap` may be 0: the eigenvalues then cross.

No drawing: an M that varies so is a case, not a body.

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
