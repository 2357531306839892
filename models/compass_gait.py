"""A walker without a motor: two straight legs on a slope, one on the ground, one swinging; M at the hip, m at the feet.

::

          (M)
         / | \\
     l  /phi\\  \\
       /   |  \\        gamma, downwards to the right     | g
    __m____|___m___                                      v

Coordinates: theta [rad], of the leg on the ground, backwards from the normal of the slope; phi [rad], from it to the
other. Its foot is on the slope where phi = 2 theta: it dips below as the legs pass each other, which does not count,
and comes up again at heel strike.
The impulse goes through the foot that strikes: angular momentum is kept about it, and of the leg behind about the hip.
Then the legs change their names.

Oracle: the gait of gamma = 0.009, m / M = 1/1000 in P. A. Bhounsule's passivewalker (2009), after M. Garcia,
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


# about the foot that strikes, and of the foot behind, at rest, about the hip; afterwards by the new names
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
