"""Rimless wheel: spokes with a mass at the hub, rolling down a slope from spoke to spoke.

::

      \\ | /
     --(m)--      2 alpha between spokes, each l
      / | \\____
     /__--      gamma, downwards to the right     | g
      --                                          v

Coordinate: theta [rad], angle of the spoke on the ground, forwards from the vertical. When the next spoke strikes, the
impulse acts on its foot, so the angular momentum about this foot is conserved.

Oracle: after each impact of the limit cycle theta' = cot(2 alpha) sqrt(4 g sin(alpha) sin(gamma) / l).
"""

from sympy import Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Event, Model, draw

theta = dynamicsymbols("theta")
m, l = symbols("m l", positive=True)
g, alpha, gamma = symbols("g alpha gamma", real=True)

hub = l * sin(theta), l * cos(theta)
spokes = [tuple(h - l * f(theta + 2 * k * alpha) for h, f in zip(hub, (sin, cos), strict=True)) for k in range(-3, 5)]

model = Model(
    name="rimless_wheel",
    coordinates=[theta],
    kinetic_energy=Rational(1, 2) * m * (l * theta.diff()) ** 2,
    potential_energy=m * g * l * cos(theta),
    parameters={m: 1.0, l: 1.0, g: 9.81, alpha: 0.392699081698724, gamma: 0.08},
    events={
        "step": Event(
            theta - alpha - gamma,
            direction=1,
            reset={theta: theta - 2 * alpha, theta.diff(): cos(2 * alpha) * theta.diff()},
        ),
    },
    initial={theta: -0.2, theta.diff(): 1.5},
    drawing=[*(draw.Line(hub, foot) for foot in spokes), draw.Disk(hub, l / 10)],
)
