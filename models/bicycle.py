"""Uncontrolled bicycle: the Carvallo-Whipple model with the data of the benchmark.

::

                    \\ s: steering axis, lambda from the vertical
                  H  \\                   B rear frame with rider, H handlebar and fork, R and F wheels, thin disks
            B         \\                                                                            | g
        .-R-.       .--\\F.                                                                         v
       (     )---------(  \\ )
        `-.-'       c  |`-.\\'
      (x, y)<----- w ------->  \\ trail c

Coordinates: x, y [m] of the rear contact; psi [rad] direction of travel, phi lean to the right, theta pitch, delta
steer to the left; spin_r, spin_f of the wheels.
Holonomic constraint: the front wheel touches the ground. Nonholonomic: neither wheel slips, along or across its plane.
It starts at 4.6 m/s, where it is self-stable, with a lean rate as after a push.

Source: J. P. Meijaard, J. M. Papadopoulos, A. Ruina and A. L. Schwab, Linearized dynamics equations for the balance
and steer of a bicycle: a benchmark and review, Proceedings of the Royal Society A 463 (2007), doi
10.1098/rspa.2007.1857.
Oracles: the eigenvalues published there; the energy; SymPy's own bicycle by Kane's equations (tests).
"""

from sympy import Expr, Matrix, Rational, cos, pi, rot_ccw_axis1, rot_ccw_axis2, rot_ccw_axis3, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, draw, t

x, y, psi, phi, theta, delta, spin_r, spin_f = coordinates = dynamicsymbols("x y psi phi theta delta spin_r spin_f")
w, c = symbols("w c", positive=True)
tilt, g = symbols("tilt g", real=True)
r_R, r_F, m_R, m_B, m_H, m_F = symbols("r_R r_F m_R m_B m_H m_F", positive=True)
x_B, z_B, x_H, z_H = symbols("x_B z_B x_H z_H", positive=True)
R_xx, R_yy, B_xx, B_yy, B_zz, B_xz = symbols("R_xx R_yy B_xx B_yy B_zz B_xz")
H_xx, H_yy, H_zz, H_xz, F_xx, F_yy = symbols("H_xx H_yy H_zz H_xz F_xx F_yy")
X, Y, Z = Matrix([1, 0, 0]), Matrix([0, 1, 0]), Matrix([0, 0, 1])


def plane(xx: Expr, yy: Expr, zz: Expr, xz: Expr = 0) -> Matrix:
    """Return the inertia tensor of a body that is symmetric with respect to the x-z plane."""
    return Matrix([[xx, 0, xz], [0, yy, 0], [xz, 0, zz]])


# all in axes that turn with psi about the rear contact: x forward, y to the left, z up; r_R, x_B, ... describe the
# upright bicycle
lean = rot_ccw_axis1(phi)
frame = lean * rot_ccw_axis2(theta)
steer = rot_ccw_axis2(-tilt) * rot_ccw_axis3(delta) * rot_ccw_axis2(tilt)
fork = frame * steer
foot = w * X + c * X  # where the steering axis meets the ground
centre = lean * (r_R * Z)
places = {"R": centre, "B": centre + frame * (x_B * X + (z_B - r_R) * Z)}
head = centre + frame * (foot - r_R * Z)
places |= {"H": head + fork * (x_H * X + z_H * Z - foot), "F": head + fork * (w * X + r_F * Z - foot)}

yaw = psi.diff() * Z
forward = Matrix([x.diff() * cos(psi) + y.diff() * sin(psi), y.diff() * cos(psi) - x.diff() * sin(psi), 0])
# angular velocities in the axes of each body; wheels are symmetric, so the axes of frame and fork serve for them
of_frame = frame.T * yaw + rot_ccw_axis2(theta).T * (phi.diff() * X) + theta.diff() * Y
of_fork = steer.T * of_frame + rot_ccw_axis2(-tilt) * (delta.diff() * Z)
turning = {"R": of_frame + spin_r.diff() * Y, "B": of_frame, "H": of_fork, "F": of_fork + spin_f.diff() * Y}
inertia = {
    "R": plane(R_xx, R_yy, R_xx),
    "B": plane(B_xx, B_yy, B_zz, -B_xz),  # the benchmark has z downwards
    "H": plane(H_xx, H_yy, H_zz, -H_xz),
    "F": plane(F_xx, F_yy, F_xx),
}
mass = {"R": m_R, "B": m_B, "H": m_H, "F": m_F}
velocity = {body: forward + place.diff(t) + yaw.cross(place) for body, place in places.items()}
kinetic_energy = Rational(1, 2) * sum(
    mass[body] * velocity[body].dot(velocity[body]) + turning[body].dot(inertia[body] * turning[body]) for body in mass
)

# from the front wheel's centre to its lowest point; the axle is the fork's y axis
axle = fork * Y
to_ground = -r_F * (Z - axle[2] * axle) / sqrt(1 - axle[2] ** 2)
rear_slip = velocity["R"] + (frame * turning["R"]).cross(-centre)
front_slip = velocity["F"] + (fork * turning["F"]).cross(to_ground)

speed = 4.6
turn = rot_ccw_axis3(psi)


def at(place: Matrix) -> Matrix:
    """Return a position in fixed axes, for the drawing."""
    return Matrix([x, y, 0]) + turn * place


seat, bars = centre + frame * Matrix([x_B, 0, z_B / 2]), head + fork * (x_H * X + Rational(5, 4) * z_H * Z - foot)

model = Model(
    name="bicycle",
    coordinates=coordinates,
    kinetic_energy=kinetic_energy,
    potential_energy=g * sum(mass[body] * place[2] for body, place in places.items()),
    holonomic_constraints=[(places["F"] + to_ground)[2]],
    nonholonomic_constraints=[rear_slip[0], rear_slip[1], front_slip[0], front_slip[1]],
    parameters={w: 1.02, c: 0.08, tilt: pi / 10, g: 9.81, r_R: 0.3, r_F: 0.35, m_R: 2.0, m_B: 85.0, m_H: 4.0, m_F: 3.0}
    | {x_B: 0.3, z_B: 0.9, x_H: 0.9, z_H: 0.7, R_xx: 0.0603, R_yy: 0.12, F_xx: 0.1405, F_yy: 0.28}
    | {B_xx: 9.2, B_yy: 11.0, B_zz: 2.8, B_xz: 2.4, H_xx: 0.05892, H_yy: 0.06, H_zz: 0.00708, H_xz: -0.00756},
    initial={x.diff(): speed, spin_r.diff(): speed / 0.3, spin_f.diff(): speed / 0.35, phi.diff(): 0.5},
    drawing=[
        draw.Trace((x, y, 0)),
        draw.Trace(at(places["F"] + to_ground)),
        draw.Disk(at(places["R"]), r_R, angle=spin_r + theta, axis=turn * lean * Y),
        draw.Disk(at(places["F"]), r_F, angle=spin_f, axis=turn * axle),
        draw.Line(at(places["R"]), at(seat)),
        draw.Line(at(seat), at(bars)),
        draw.Line(at(bars), at(places["F"])),
        draw.Disk(at(places["B"]), r_R / 3),
    ],
)
