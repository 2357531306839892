"""Newton's cradle: balls in a row that touch at rest; the first one strikes the others.

::

    ----o--o--o--o---
       /   |  |  |
      /    |  |  |  l
     O     O  O  O      | g
                        v

Coordinates: theta_k [rad] of each thread. The coefficient of restitution is e. Simultaneous impacts act one after the
other, in the order of the events.

Oracle: with e = 1 each impact of equal balls exchanges their velocities, and the last ball rises as the first fell.
"""

import itertools

from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Event, Model, draw

m, l, r = symbols("m l r", positive=True)
e = symbols("e", nonnegative=True)
g = symbols("g", real=True)


def model(n: int = 4) -> Model:
    """Return the cradle of n balls."""
    theta = dynamicsymbols(f"theta1:{n + 1}")
    hung = [2 * r * k for k in range(n)]
    balls = [(x + l * sin(angle), -l * cos(angle)) for x, angle in zip(hung, theta, strict=True)]
    gaps = [l * (right - left) for left, right in itertools.pairwise(theta)]
    return Model(
        name=f"newtons_cradle_{n}",
        coordinates=list(theta),
        kinetic_energy=sum(m * (l * angle.diff()) ** 2 for angle in theta) / 2,
        potential_energy=-sum(m * g * l * cos(angle) for angle in theta),
        parameters={m: 0.1, l: 0.2, g: 9.81, e: 1.0, r: 0.02},
        events={f"{k + 1} on {k + 2}": Event(gap, direction=-1, impact=(gap, e)) for k, gap in enumerate(gaps)},
        initial={theta[0]: -0.5},
        drawing=[
            *(draw.Line((x, 0), ball) for x, ball in zip(hung, balls, strict=True)),
            *(draw.Disk(ball, r) for ball in balls),
        ],
    )
