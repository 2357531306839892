"""Cam and roller follower: a spring presses the follower on the cam, which it leaves at high speed and strikes again.

::

          |  spring, preload F0
         [_]
          |   m             ^ y
         ( )  roller        |
        .-"-.              _|_
       /  o  \\___    cam, turns by phi, inertia J
       \\_______/     motor: torque c (w - phi')

Coordinates: phi [rad] of the camshaft, y [m] of the follower above the base circle.
The profile is a table: the lift [mm] every 5 degrees in `cam_follower.csv` (a rise of 90 degrees, a dwell of 30, a
return of 120, a dwell of 120), interpolated by a periodic spline of degree 5. The contact's gap is y - lift(phi).

Oracles: at constant speed the cam presses with N = m lift'' phi'^2 + k lift + F0 + m g, and lift-off begins at the
speed at which the least N is zero; one coordinate while they touch, two while they do not, integrated by SciPy.
"""

from pathlib import Path

import numpy as np
from scipy.interpolate import make_interp_spline
from sympy import Matrix, Rational, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Contact, Model, Table, draw, multiplier

phi, y = dynamicsymbols("phi y")
m, k, J, c, base, roller = symbols("m k J c base roller", positive=True)
e, F0 = symbols("e F0", nonnegative=True)
g, w = symbols("g w", real=True)

degrees, millimetres = np.loadtxt(Path(__file__).with_suffix(".csv"), delimiter=",", skiprows=1, unpack=True)
angles, lifts = np.radians(degrees), millimetres / 1000
profile = make_interp_spline(angles, lifts, k=5, bc_type="periodic")
lift = Table(profile, outside="periodic", name="lift")
torque = c * (w - phi.diff())

BASE, ROLLER = 0.03, 0.01
"""Radii [m] of the base circle and of the roller; of use to the drawing alone."""


def outline() -> list[tuple[float, float]]:
    """Return points of the cam at phi = 0: the path of the roller's centre, moved inwards by the roller's radius."""
    distance, slope = BASE + ROLLER + lifts[:-1], profile(angles[:-1], 1)
    radial = np.array([np.sin(angles[:-1]), np.cos(angles[:-1])])
    tangent = np.array([radial[1], -radial[0]])
    normal = (distance * radial - slope * tangent) / np.hypot(distance, slope)
    return [(round(float(a), 5), round(float(b), 5)) for a, b in (distance * radial - ROLLER * normal).T]


turned = Matrix([[cos(phi), -sin(phi)], [sin(phi), cos(phi)]])
cam = [tuple(turned * Matrix(point)) for point in outline()]
centre = base + roller + y
seat, wall = centre + Rational(3, 100), Rational(3, 20)

model = Model(
    name="cam_follower",
    coordinates=[phi, y],
    kinetic_energy=Rational(1, 2) * (J * phi.diff() ** 2 + m * y.diff() ** 2),
    potential_energy=Rational(1, 2) * k * (y + F0 / k) ** 2 + m * g * y,
    forces={phi: torque},
    contacts={"cam": Contact(y - lift(phi), restitution=e, rest=Rational(1, 1000))},
    outputs={
        "gap": y - lift(phi),
        "pressing": -multiplier("cam"),
        "torque": torque,
        "motor_power": torque * phi.diff(),
        "load_torque": -multiplier("cam") * lift(phi).diff(phi),
    },
    parameters={m: 0.3, k: 5000.0, F0: 40.0, g: 9.81, J: 0.02, c: 0.5, w: 140.0, e: 0.3, base: BASE, roller: ROLLER},
    initial={phi.diff(): 140.0},
    drawing=[
        draw.Body(cam),
        draw.Ground((0, 0)),
        draw.Disk((0, centre), roller),
        draw.Line((0, centre), (0, seat)),
        draw.Line((-roller, seat), (roller, seat)),
        draw.Spring((0, seat), (0, wall)),
        draw.Line((-2 * roller, wall), (2 * roller, wall)),
    ],
)
