"""Snakeboard: a board on two pairs of wheels that steer in opposite directions, and a rotor in place of the rider.

::

                     phi
            //  . - - - -.  \\\\
      -----//---( C, psi )---\\\\-----> theta, direction of the board
          //    ' - - - -'    \\\\
      |<------ l ----->|<----- l ----->|       from above; wheels at theta + phi in front, theta - phi behind

Coordinates: x, y [m] of the centre C, theta [rad] the board's direction; psi of the rotor and phi of the front wheels,
relative to the board. Inputs: a torque on the rotor and one on the steering of both pairs [N m].
Nonholonomic constraints: no pair of wheels moves along its axle. They are dependent where phi is a right angle.

Source: J. Ostrowski, A. Lewis, R. Murray and J. Burdick, Nonholonomic mechanics and locomotion: the snakeboard example,
IEEE Int. Conf. Robotics and Automation (1994).
Oracle: the equation of the momentum along the motion that the wheels allow.
"""

from sympy import Expr, Matrix, Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw

x, y, theta, psi, phi = dynamicsymbols("x y theta psi phi")
swing, steer = dynamicsymbols("swing steer")
m, l, J, J_rotor, J_wheels = symbols("m l J J_rotor J_wheels", positive=True)

rates = [coordinate.diff() for coordinate in (theta, psi, phi)]
turn, spin, steering = rates
along = l * Matrix([cos(theta), sin(theta)])
centre = Matrix([x, y])


def across(sign: int) -> Expr:
    """Return the velocity of a pair of wheels along its axle; 1 in front, -1 behind."""
    angle = theta + sign * phi
    return -sin(angle) * x.diff() + cos(angle) * y.diff() + sign * l * cos(phi) * turn


def direction(angle: Expr, length: Expr) -> Matrix:
    """Return the vector of a direction and length."""
    return length * Matrix([cos(angle), sin(angle)])


wheels = [
    draw.Line(centre + sign * along - direction(theta + sign * phi, l / 5),
              centre + sign * along + direction(theta + sign * phi, l / 5))
    for sign in (1, -1)
]  # fmt: skip

model = Model(
    name="snakeboard",
    coordinates=[x, y, theta, psi, phi],
    kinetic_energy=Rational(1, 2)
    * (
        m * (x.diff() ** 2 + y.diff() ** 2)
        + J * turn**2
        + J_rotor * (turn + spin) ** 2
        + J_wheels * ((turn + steering) ** 2 + (turn - steering) ** 2)
    ),
    forces={psi: swing, phi: steer},
    nonholonomic_constraints=[across(1), across(-1)],
    inputs={swing: 0.0, steer: 0.0},
    parameters={m: 6.0, l: 0.2, J: 0.016, J_rotor: 0.072, J_wheels: 0.0013},
    initial={x.diff(): 0.5, theta.diff(): 0.5 * 0.2027100355086725 / 0.2, psi.diff(): 3.0, phi: 0.2, phi.diff(): -0.1},
    drawing=[
        draw.Trace(centre),
        draw.Line(centre - along, centre + along),
        *wheels,
        draw.Line(centre - direction(theta + psi, l / 2), centre + direction(theta + psi, l / 2)),
        draw.Disk(centre, l / 4, angle=theta + psi),
    ],
)
