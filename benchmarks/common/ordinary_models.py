"""Mechanisms as a user writes them first, in Cartesian coordinates or from energies: cases for times of builds."""

import math

from sympy import Expr, Matrix, Rational, cos, eye, pi, sin, symbols, zeros
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Friction, Model, t

g, m, J, L, w, F, k = symbols("g m J L w F k", positive=True)


def scissor_lift() -> Model:
    """Return a lift of two pairs of crossed bars and a platform: 15 coordinates, 14 rows.

    Bar i has its centre at (x_i, y_i) and the direction theta_i; bars 0 and 2 rise to the right, 1 and 3 to the left.
    The left foot is pinned and the right foot rolls; so do the corners of the platform.
    """
    bodies = [Matrix(dynamicsymbols(f"x{i} y{i} theta{i}")) for i in range(5)]

    def end(i: int, side: int) -> Matrix:
        x, y, theta = bodies[i]
        return Matrix([x + side * L / 2 * cos(theta), y + side * L / 2 * sin(theta)])

    def centre(i: int) -> Matrix:
        return bodies[i][:2, 0]

    x, y, theta = bodies[4]
    corner = Matrix([x - w * cos(theta), y - w * sin(theta)])
    below = end(2, 1) - Matrix([x, y])
    pins = [end(0, -1), centre(0) - centre(1), end(0, 1) - end(3, -1), end(1, 1) - end(2, -1), centre(2) - centre(3),
            corner - end(3, 1)]  # fmt: skip
    rollers = [end(1, -1)[1], cos(theta) * below[1] - sin(theta) * below[0]]
    return Model(
        name="scissor_lift",
        coordinates=[q for body in bodies for q in body],
        kinetic_energy=sum((m * (b[0].diff() ** 2 + b[1].diff() ** 2) + J * b[2].diff() ** 2) / 2 for b in bodies),
        potential_energy=sum(m * g * b[1] for b in bodies),
        forces={bodies[1][0]: -F},
        holonomic_constraints=[*Matrix.vstack(*pins), *rollers],
        parameters={m: 2.0, J: 0.2, L: 1.0, w: 0.4, g: 9.81, F: 50.0},
        initial={
            q: float(v)
            for body, start in zip(bodies, lifted(0.5), strict=True)
            for q, v in zip(body, start, strict=True)
        },
    )


def lifted(rise: float) -> list[tuple[float, ...]]:
    """Return positions (x, y, theta) of the bars of length 1, at an angle to the ground, and of the platform."""
    width, height = math.cos(rise), math.sin(rise)
    bars = [(width / 2, height * (level + 0.5), angle) for level in (0, 1) for angle in (rise, math.pi - rise)]
    return [*bars, (0.4, 2 * height, 0.0)]


def turned(axis: int, angle: Expr) -> Matrix:
    """Return the rotation by an angle about the axis x, y or z."""
    c, s = cos(angle), sin(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    R = eye(3)
    R[i, i], R[j, j], R[i, j], R[j, i] = c, c, -s, s
    return R


def angular_velocity(R: Matrix) -> Matrix:
    """Return the angular velocity in the body's frame."""
    W = R.T * R.diff(t)
    return Matrix([W[2, 1], W[0, 2], W[1, 0]])


def body_energy(centre: Matrix, R: Matrix, mass: Expr, inertia: tuple[Expr, ...]) -> Expr:
    """Return the kinetic energy of a rigid body of these principal moments of inertia."""
    v, omega = centre.diff(t), angular_velocity(R)
    return mass * v.dot(v) / 2 + sum(I * rate**2 for I, rate in zip(inertia, omega, strict=True)) / 2


def on_circle(i: int, radius: float, apart: float) -> list[float]:
    """Return joint i of six in three pairs, whose members are `apart` [rad] from the middle of their pair."""
    angle = 2 * math.pi / 3 * (i // 2) + (-1) ** i * apart
    return [radius * math.cos(angle), radius * math.sin(angle)]


def stewart_platform() -> Model:
    """Return a platform on six legs with mass: 24 coordinates, 18 rows.

    The platform has a position and three Cardan angles. Each leg has two angles of its universal joint and a length;
    its lower part turns only, its upper part also slides.
    """
    x, y, z, a, b, c = dynamicsymbols("x y z a b c")
    M, I1, I3, ml, mu, d = symbols("M I1 I3 m_l m_u d", positive=True)
    R = turned(0, a) * turned(1, b) * turned(2, c)
    p = Matrix([x, y, z])
    kinetic, potential, rows = body_energy(p, R, M, (I1, I1, I3)), M * g * z, []
    coordinates, initial = [x, y, z, a, b, c], {z: 1.0}
    for i in range(6):
        u, v, s = dynamicsymbols(f"u{i} v{i} s{i}")
        base, top = on_circle(i, 1.0, 0.2), on_circle(i, 0.5, 0.8)
        B, P = Matrix([*base, 0.0]), Matrix([*top, 0.0])
        along = turned(0, u) * turned(1, v) * Matrix([0, 0, 1])
        rate = along.diff(t)
        upper = B + (s - d) * along
        kinetic += ml * d**2 * rate.dot(rate) / 2 + mu * upper.diff(t).dot(upper.diff(t)) / 2
        potential += ml * g * d * along[2] + mu * g * upper[2]
        rows += [*(p + R * P - B - s * along)]
        way = [top[0] - base[0], top[1] - base[1], 1.0]
        length = math.hypot(*way)
        coordinates += [u, v, s]
        tilt = math.acos(math.hypot(way[1], way[2]) / length) * (1 if way[0] > 0 else -1)
        initial |= {u: math.atan2(-way[1], way[2]), v: tilt, s: length}
    return Model(
        name="stewart_platform", coordinates=coordinates, kinetic_energy=kinetic, potential_energy=potential,
        holonomic_constraints=rows, parameters={M: 20.0, I1: 1.0, I3: 2.0, ml: 2.0, mu: 1.0, d: 0.3, g: 9.81},
        initial=initial,
    )  # fmt: skip


def six_axis_arm() -> Model:
    """Return an arm of the six axes and lengths of a UR5, from energies: six angles, no tree."""
    angles = dynamicsymbols("q1:7")
    masses, steps = symbols("m1:7", positive=True), symbols("d1 a2 a3 d4 d5 d6", positive=True)
    d1, a2, a3, d4, d5, d6 = steps
    twists, offsets, lengths = (pi / 2, 0, 0, pi / 2, -pi / 2, 0), (d1, 0, 0, d4, d5, d6), (0, -a2, -a3, 0, 0, 0)
    R, p, kinetic, potential = eye(3), zeros(3, 1), Rational(0), Rational(0)
    for i, (q, twist, offset, length) in enumerate(zip(angles, twists, offsets, lengths, strict=True)):
        before = p
        R = R * turned(2, q)
        p = p + R * Matrix([length, 0, offset])
        R = R * turned(0, twist)
        centre = (before + p) / 2
        inertia = symbols(f"I{i + 1}x I{i + 1}y I{i + 1}z", positive=True)
        kinetic += body_energy(centre, R, masses[i], inertia)
        potential += masses[i] * g * centre[2]
    numbers = dict(zip(steps, (0.089, 0.425, 0.392, 0.109, 0.095, 0.082), strict=True))
    weights = dict(zip(masses, (3.7, 8.4, 2.3, 1.2, 1.2, 0.19), strict=True))
    moments = {I: 0.01 * (i + 1) / (j + 1) for i in range(6) for j, I in
               enumerate(symbols(f"I{i + 1}x I{i + 1}y I{i + 1}z", positive=True))}  # fmt: skip
    return Model(
        name="six_axis_arm", coordinates=[*angles], kinetic_energy=kinetic, potential_energy=potential,
        parameters=numbers | weights | moments | {g: 9.81}, initial={angles[1]: -1.0, angles[2]: 0.5},
    )  # fmt: skip


def two_frictions() -> Model:
    """Return two blocks in a row on rough ground, joined by a spring and pulled: two coordinates, two frictions."""
    x, y = dynamicsymbols("x y")
    mu = symbols("mu", nonnegative=True)
    return Model(
        name="two_frictions", coordinates=[x, y], kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2) / 2,
        potential_energy=k * (y - x - L) ** 2 / 2, forces={y: F},
        contacts={f"friction_{q.func.__name__}": Friction(slip=q.diff(), limit=mu * m * g) for q in (x, y)},
        parameters={m: 1.0, k: 100.0, L: 0.2, F: 8.0, mu: 0.3, g: 9.81}, initial={y: 0.2},
    )  # fmt: skip


ORDINARY = (scissor_lift, stewart_platform, six_axis_arm, two_frictions)
