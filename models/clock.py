"""Pendulum clock: a pendulum with dry friction in its pivot, driven by an escapement.

::

      ___/o\\___   the anchor releases one tooth of the wheel
          |
          | l      theta, from the vertical
          |
        ( m )       | g
                    v

Coordinate: theta [rad]. The friction of the pivot is a torque of at most tau [N m]. Whenever the pendulum passes the
vertical, a tooth adds the energy E [J], in the direction of the swing.

Oracle: a swing to amplitude A and back to the vertical loses 2 tau A. It starts with W = m g l (1 - cos A) + tau A, and
the next one with W - 2 tau A + E. The motion is periodic if E = 2 tau A.
"""

from sympy import Rational, cos, sign, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Event, Friction, Model, draw

theta = dynamicsymbols("theta")
m, l = symbols("m l", positive=True)
tau, E = symbols("tau E", nonnegative=True)
g = symbols("g", real=True)

bob = l * sin(theta), -l * cos(theta)
turn = theta.diff()
pallets = [(l / 4 * sin(theta + side), -l / 4 * cos(theta + side)) for side in (Rational(6, 5), -Rational(6, 5))]

model = Model(
    name="clock",
    coordinates=[theta],
    kinetic_energy=Rational(1, 2) * m * (l * turn) ** 2,
    potential_energy=-m * g * l * cos(theta),
    contacts={"pivot": Friction(turn, limit=tau)},
    events={"tick": Event(theta, reset={turn: sign(turn) * sqrt(turn**2 + 2 * E / (m * l**2))})},
    parameters={m: 1.0, l: 0.994, g: 9.81, tau: 0.1, E: 0.04},
    initial={theta: -0.1},
    drawing=[
        draw.Ground((0, 0)),
        draw.Trace(bob),
        draw.Line((0, 0), bob),
        *(draw.Line((0, 0), pallet) for pallet in pallets),
        draw.Disk(bob, l / 12),
    ],
)
