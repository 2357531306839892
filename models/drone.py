"""Drone (quadrotor) with a load that hangs on a rope.

::

          f2    f1         four rotors at distance a from the centre, thrusts f1 ... f4 along the drone's upward axis;
            \\  /           1 in front, 2 left, 3 behind, 4 right; 1 and 3 turn in the opposite sense of 2 and 4
        f3---[]---f4
             |\\            | g
           L | \\ swing     v
               o load

Coordinates: x, y, z [m] of the drone; yaw, pitch, roll [rad], in this order about z, y, x; sway and heave [rad], the
angles of the rope in the x-z plane and out of it. Inputs: f1 ... f4 [N]; their defaults balance the weight of drone and
load. The model is valid while the rope is taut, that is, while the output `tension` is positive.

Oracles: Lagrange equations; high-precision integration; free fall of the common centre of mass without thrust.
"""

from sympy import Matrix, Rational, cos, rot_ccw_axis1, rot_ccw_axis2, rot_ccw_axis3, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t

x, y, z, yaw, pitch, roll, sway, heave = coordinates = dynamicsymbols("x y z yaw pitch roll sway heave")
thrusts = dynamicsymbols("f1:5")
m, J, J_up, a, L = symbols("m J J_up a L", positive=True)
load, drag = symbols("load drag", nonnegative=True)
g = symbols("g", real=True)

centre = Matrix([x, y, z])
R = rot_ccw_axis3(yaw) * rot_ccw_axis2(pitch) * rot_ccw_axis1(roll)
rope = L * Matrix([sin(sway) * cos(heave), sin(heave), -cos(sway) * cos(heave)])
hanging = centre + rope

# in the drone's axes
about_x = Matrix([1, 0, 0]) * roll.diff()
omega = about_x + rot_ccw_axis1(roll).T * (
    Matrix([0, 1, 0]) * pitch.diff() + rot_ccw_axis2(pitch).T * Matrix([0, 0, 1]) * yaw.diff()
)
f1, f2, f3, f4 = thrusts
torque = Matrix([a * (f2 - f4), a * (f3 - f1), drag * (f1 - f2 + f3 - f4)])
thrust = R * Matrix([0, 0, sum(thrusts)])
forces = dict(zip((x, y, z), thrust, strict=True))
forces |= {angle: torque.dot(omega.diff(angle.diff())) for angle in (yaw, pitch, roll)}

velocity, swinging = centre.diff(t), hanging.diff(t)
spin = J * (omega[0] ** 2 + omega[1] ** 2) + J_up * omega[2] ** 2
pull = load * (hanging.diff(t, 2) + Matrix([0, 0, g]))
tips = [centre + R * a * Matrix(place) for place in ((1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0))]
weight = (1.2 + 0.4) * 9.81

model = Model(
    name="drone",
    coordinates=coordinates,
    kinetic_energy=Rational(1, 2) * (m * velocity.dot(velocity) + load * swinging.dot(swinging) + spin),
    potential_energy=g * (m * z + load * hanging[2]),
    forces=forces,
    inputs=dict.fromkeys(thrusts, weight / 4),
    parameters={m: 1.2, load: 0.4, J: 0.012, J_up: 0.022, a: 0.2, drag: 0.016, L: 0.8, g: 9.81},
    outputs={"tension": -pull.dot(rope) / L},
    initial={z: 1.0, sway: 0.5, heave: 0.2, x.diff(): 0.5, roll: 0.05},
    drawing=[
        draw.Line(tips[0], tips[2]),
        draw.Line(tips[1], tips[3]),
        *(draw.Disk(tip, a / 2, axis=R[:, 2]) for tip in tips),
        draw.Line(centre, hanging),
        draw.Disk(hanging, a / 4),
        draw.Trace(hanging),
    ],
)
