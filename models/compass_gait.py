"""Compass-gait walker: a passive biped with two straight legs on a slope; mass M at the hip, m at the feet.

::

          (M)
         / | \\
     l  /phi\\  \\
       /   |  \\        gamma, downwards to the right     | g
    __m____|___m___                                      v

Coordinates: theta [rad], angle of the stance leg, backwards from the normal of the slope; phi [rad], from the stance
leg to the swing leg. The swing foot is on the slope where phi = 2 theta. It dips below the slope as the legs pass each
other, which is ignored. Heel strike is where phi - 2 theta increases through 0.
The impulse acts on the foot that strikes. The angular momentum of the walker about this foot is conserved, and that of
the trailing leg about the hip. Then the legs exchange their roles.

Oracle: the gait for gamma = 0.009, m / M = 1/1000 in P. A. Bhounsule's passivewalker (2009), after M. Garcia,
A. Chatterjee, A. Ruina and M. Coleman, "The Simplest Walking Model", J. Biomech. Eng. 120 (1998) 281.
"""

from sympy import Matrix, Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Event, Model, draw, t

theta, phi = dynamicsymbols("theta phi")
M, m, l = symbols("M m l", positive=True)
g, gamma = symbols("g gamma", real=True)
rates = Matrix([theta.diff(), phi.diff()])

hip = Matrix([-l * sin(theta), l * cos(theta)])
foot = hip - l * Matrix([sin(phi - theta), cos(phi - theta)])
down = Matrix([sin(gamma), -cos(gamma)])
hip_rate, foot_rate = hip.diff(t), foot.diff(t)


def moment(arm: Matrix, rate: Matrix) -> object:
    """Return the angular momentum of a unit mass."""
    return arm[0] * rate[1] - arm[1] * rate[0]


# angular momenta: of the walker about the foot that strikes; of the trailing foot, at rest before, about the hip;
# `after` is written in the coordinates after the exchange
before = Matrix([M * moment(hip - foot, hip_rate), 0])
after = Matrix([M * moment(hip, hip_rate) + m * moment(foot, foot_rate), m * moment(foot - hip, foot_rate)])
renamed = {theta: theta - phi, phi: -phi}
struck = after.jacobian(rates).xreplace(renamed).LUsolve(before)

model = Model(
    name="compass_gait",
    coordinates=[theta, phi],
    kinetic_energy=Rational(1, 2) * (M * hip_rate.dot(hip_rate) + m * foot_rate.dot(foot_rate)),
    potential_energy=-g * down.dot(M * hip + m * foot),
    parameters={M: 1000.0, m: 1.0, l: 1.0, g: 1.0, gamma: 0.009},
    events={
        "heel strike": Event(phi - 2 * theta, direction=1, reset=renamed | dict(zip(rates, struck, strict=True))),
    },
    initial={theta: 0.2, phi: 0.4, theta.diff(): -0.2, phi.diff(): -0.0158},
    drawing=[
        draw.Line((0, 0), tuple(hip)),
        draw.Line(tuple(hip), tuple(foot)),
        draw.Disk(tuple(hip), l / 20),
        draw.Disk(tuple(foot), l / 40),
    ],
)
