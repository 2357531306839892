"""PUMA 560 robot: six revolute joints, with the inertia of geared motors.

::

             q2      q3
              o======o                 z (q1)
             /        \\ d4, q4         |       joints about z0; then z1, z2 along the shoulder's axis,
      q1 |  /          \\ q5 o--q6      |___ x  z3 along the forearm, z4 across, z5 along the hand
         o                                     | g, along -z
     ____|____                                 v

Coordinates: q1 ... q6 [rad], in the Denavit-Hartenberg convention. Inputs: tau1 ... tau6 [N m], joint torques.
Parameters: g, and the load [kg] in the hand. All other data are numbers: masses, centres of mass, inertias, and the
inertia of each motor at its joint, Jm gear^2.

Source: P. I. Corke and B. Armstrong-Helouvry, A search for consensus among model parameters reported for the PUMA 560
robot, IEEE Int. Conf. Robotics and Automation (1994); in the form of P. I. Corke's Robotics Toolbox.
Oracles: the torques at rest in the nominal pose q_n = (0, 45, 180, 0, 45, 0) degrees, (0, 31.6399, 6.0351, 0, 0.0283,
0) N m, and the mass matrix there, as printed in the Toolbox's manual; Lagrange equations.
"""

from sympy import Expr, Integer, Matrix, Rational, cos, diag, pi, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw

joints, torques = dynamicsymbols("q1:7"), dynamicsymbols("tau1:7")
g, load = symbols("g load")

TWIST = (1, 0, -1, 1, -1, 0)  # quarter turns
ALONG = ("0", "0.4318", "0.0203", "0", "0", "0")
OFFSET = ("0", "0", "0.15005", "0.4318", "0", "0")
MASS = ("0", "17.4", "4.8", "0.82", "0.34", "0.09")
CENTRE = (
    ("0", "0", "0"),
    ("-0.3638", "0.006", "0.2275"),
    ("-0.0203", "-0.0141", "0.070"),
    ("0", "0.019", "0"),
    ("0", "0", "0"),
    ("0", "0", "0.032"),
)
INERTIA = (
    ("0", "0.35", "0"),
    ("0.13", "0.524", "0.539"),
    ("0.066", "0.086", "0.0125"),
    ("0.0018", "0.0013", "0.0018"),
    ("0.0003", "0.0004", "0.0003"),
    ("0.00015", "0.00015", "0.00004"),
)
MOTOR = ("2e-4", "2e-4", "2e-4", "3.3e-5", "3.3e-5", "3.3e-5")
GEAR = ("62.6111", "107.815", "53.7063", "76.0364", "71.923", "76.686")


def numbers(texts: tuple[str, ...]) -> Matrix:
    """Return decimal numbers exactly, as a column."""
    return Matrix([Rational(text) for text in texts])


def turn(q: Expr, quarters: int) -> Matrix:
    """Return Rot_z(q) Rot_x(quarters 90 degrees), which maps the axes of a link to those of the previous link."""
    c, s = Integer(1 - abs(quarters)), Integer(quarters)
    about_x = Matrix([[1, 0, 0], [0, c, -s], [0, s, c]])
    return Matrix([[cos(q), -sin(q), 0], [sin(q), cos(q), 0], [0, 0, 1]]) * about_x


# in the axes of each link: its angular velocity, the velocity of its origin, the upward direction; and the height of
# its origin
z = Matrix([0, 0, 1])
velocity, omega, up, height = Matrix([0, 0, 0]), Matrix([0, 0, 0]), z, Integer(0)
T = V = Integer(0)
axes, place = Matrix.eye(3), Matrix([0, 0, 0])
drawing: list[object] = [draw.Ground((0, 0, Rational(-1, 2))), draw.Line((0, 0, Rational(-1, 2)), (0, 0, 0))]
for k, q in enumerate(joints):
    R, d, a = turn(q, TWIST[k]), Rational(OFFSET[k]), Rational(ALONG[k])
    omega, up = R.T * (omega + q.diff() * z), R.T * up
    step = R.T * (d * z) + a * Matrix([1, 0, 0])
    velocity, height = R.T * velocity + omega.cross(step), height + step.dot(up)
    mass, centre = Rational(MASS[k]), numbers(CENTRE[k])
    moving = velocity + omega.cross(centre)
    T += Rational(1, 2) * (mass * moving.dot(moving) + omega.dot(diag(*numbers(INERTIA[k])) * omega))
    T += Rational(1, 2) * Rational(MOTOR[k]) * Rational(GEAR[k]) ** 2 * q.diff() ** 2
    V += g * mass * (height + centre.dot(up))
    before, elbow = place, place + axes * d * z
    axes = axes * R
    place = elbow + axes * a * Matrix([1, 0, 0])
    drawing += [draw.Line(before, place)] if k in (1, 2, 3) else []
    drawing += [draw.Disk(before, Rational(1, 20), angle=q, axis=axes[:, 1] if k in (0, 3) else axes[:, 2])] * (k < 3)

tip = Rational(1, 5) * Matrix([0, 0, 1])
hand = velocity + omega.cross(tip)
T += Rational(1, 2) * load * hand.dot(hand)
V += g * load * (height + tip.dot(up))
grip = place + axes * tip

model = Model(
    name="puma",
    coordinates=joints,
    kinetic_energy=T,
    potential_energy=V,
    forces=dict(zip(joints, torques, strict=True)),
    inputs=dict.fromkeys(torques, 0.0),
    parameters={g: 9.81, load: 0.0},
    initial=dict(zip(joints, (0, pi / 4, pi, 0, pi / 4, 0), strict=True)),
    drawing=[*drawing, draw.Line(place, grip), draw.Disk(grip, Rational(1, 30)), draw.Trace(grip)],
)
