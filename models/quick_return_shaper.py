"""Quick-return shaper, in millimetres: a slotted lever swings the ram, with dry friction in every joint.

::

        tool            ram, m5          C
         |==============================[o]=====   y = H
         |        back  front pad          \\  rod l
        work                            B   \\
                                          o--o
                                         /   chi
                          crank r       /
                              .--o-----/---.  A: block in the slot
                             (   bull /wheel)
                              `-- O2 /-----'   theta: of the crank
                                 /  /  psi: of the lever
                                O4                              | g
                                                                v

Units: t, mm, s; hence N, N mm, mJ and MPa. Coordinates: of crank, lever, rod and ram the centre of mass [mm] and the
angle [rad] from the x axis, of the block its centre; none is eliminated, so that every joint has its reactions.
Constraints, with the forces [N] of the joints as multipliers: bearing O2, crank_pin A, slot, pivot O4, lever_pin B,
ram_pin C, and the pads `front` and `back` of the ram's guide. In each of them friction acts: mu times the reaction, and
in pins times the radius of the pin.

The crank turns to the left while the block is above O2, so that the slow stroke is to the left, and cuts. Tables: the
cutting force [N] over the ram's position, measured, and the motor's torque [N mm] over the speed of the crank.

Oracles: power of the motor = power of the tool + friction + rate of the energy; without friction one coordinate,
eliminated by hand; with friction Newton's equations with the implicit reactions by SciPy's fsolve.
"""

import numpy as np
from scipy.interpolate import PchipInterpolator
from sympy import Abs, Expr, Matrix, Piecewise, Rational, Symbol, asin, atan2, cos, pi, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Friction, Model, Table, draw, multiplier, t

x1, y1, theta, x2, y2, x3, y3, psi, x4, y4, chi, x5, y5, phi = coordinates = dynamicsymbols(
    "x1 y1 theta x2 y2 x3 y3 psi x4 y4 chi x5 y5 phi"
)
r, h, L, l, H, d, depth = symbols("r h L l H d depth", positive=True)
a, b = symbols("a b", real=True)
masses = m1, m2, m3, m4, m5 = symbols("m1:6", positive=True)
J1, J3, J4, J5, rp = symbols("J1 J3 J4 J5 rp", positive=True)
mu = symbols("mu", nonnegative=True)
g = symbols("g", real=True)

# --- tables ---

SYNCHRONOUS, BREAKDOWN = 2 * np.pi, 6e5
"""Speed of the crank [rad/s] at which the motor has no torque, and the greatest torque [N mm], at a slip of 0.2."""
slips = np.array([1.2, 1.0, 0.8, 0.6, 0.5, 0.4, 0.3, 0.25, 0.2, 0.15, 0.1, 0.05, 0.0, -0.05, -0.1])
torques = 2 * BREAKDOWN * slips * 0.2 / (slips**2 + 0.2**2)
motor = Table(PchipInterpolator(SYNCHRONOUS * (1 - slips), torques), outside="hold", name="motor")

places = np.array([-290.0, -275.0, -250.0, -200.0, -150.0, -100.0, -50.0, 0.0, 40.0, 55.0, 70.0])
forces = np.array([0.0, 1850.0, 2010.0, 2090.0, 1980.0, 2150.0, 2060.0, 1940.0, 2120.0, 1900.0, 0.0])
cutting = Table(PchipInterpolator(places, forces), outside="hold", name="cutting")

# --- joints ---

along_crank, along_lever, along_rod, along_ram = [Matrix([cos(q), sin(q)]) for q in (theta, psi, chi, phi)]
crank, block, lever, rod, ram = [Matrix(pair) for pair in ((x1, y1), (x2, y2), (x3, y3), (x4, y4), (x5, y5))]
across_lever, across_ram = Matrix([-sin(psi), cos(psi)]), Matrix([-sin(phi), cos(phi)])
pin_a, pin_b, pin_c = crank + r * along_crank, lever + L / 2 * along_lever, ram - d * along_ram


def pad(place: Expr) -> Expr:
    """Return the distance [mm] of the ram's axis from a pad of the guide."""
    return (ram - Matrix([place, H])).dot(across_ram)


joints = {
    "bearing": list(crank - Matrix([0, h])),
    "crank_pin": list(block - pin_a),
    "slot": (block - lever).dot(across_lever),
    "pivot": list(lever - L / 2 * along_lever),
    "lever_pin": list(rod - l / 2 * along_rod - pin_b),
    "ram_pin": list(pin_c - rod - l / 2 * along_rod),
    "front": pad(a),
    "back": pad(b),
}
slides = ram.diff(t).dot(along_ram)
slip = {
    "bearing": theta.diff(),
    "crank_pin": theta.diff() - psi.diff(),
    "slot": (block - lever).dot(along_lever).diff(t),
    "pivot": psi.diff(),
    "lever_pin": psi.diff() - chi.diff(),
    "ram_pin": chi.diff() - phi.diff(),
    "front": slides,
    "back": slides,
}
pins = ("bearing", "crank_pin", "pivot", "lever_pin", "ram_pin")
rubs = {f"rub_{name}": Friction(slip[name], mu * rp if name in pins else mu, name) for name in joints}
tool = Piecewise((cutting(x5), x5.diff() < 0), (0, True))
"""[N] On the ram, to the right."""


def reaction(name: str) -> Expr:
    """Return the size of the force [N] that a joint transmits."""
    return sqrt(multiplier(name, 0) ** 2 + multiplier(name, 1) ** 2) if name in pins else Abs(multiplier(name))


# --- the start: the loops in closed form, with the crank at `angle` ---

LENGTHS = {r: 100.0, h: 300.0, L: 650.0, l: 250.0, H: 620.0, d: 150.0}
angle, speed, start = Symbol("angle"), Rational(97, 100) * 2 * pi, 0.0


def closed_loops() -> list[Expr]:
    """Return all coordinates as functions of the crank's angle."""
    A = Matrix([r * cos(angle), h + r * sin(angle)])
    swing = atan2(A[1], A[0])
    B = L * Matrix([cos(swing), sin(swing)])
    reach = pi - asin((H - B[1]) / l)
    C = B + l * Matrix([cos(reach), sin(reach)])
    return [0, h, angle, *A, *(B / 2), swing, *((B + C) / 2), reach, C[0] + d, H, 0]


pose = Matrix(closed_loops()).subs(LENGTHS)
at_start = dict(zip(coordinates, pose.subs(angle, start), strict=True))
rates_at_start = dict(zip((q.diff() for q in coordinates), (speed * pose.diff(angle)).subs(angle, start), strict=True))

bodies = ((m1, crank), (m2, block), (m3, lever), (m4, rod), (m5, ram))
turning = ((J1, theta), (J3, psi), (J4, chi), (J5, phi))
friction_power = sum(mu * (rp if name in pins else 1) * reaction(name) * Abs(slip[name]) for name in joints)
torque = motor(theta.diff())

nose, tail = ram - (d + 100) * along_ram, ram + 400 * along_ram
tip = nose - depth * across_ram

model = Model(
    name="quick_return_shaper",
    coordinates=coordinates,
    kinetic_energy=sum(m * at.diff(t).dot(at.diff(t)) for m, at in bodies) / 2
    + sum(J * q.diff() ** 2 for J, q in turning) / 2,
    potential_energy=g * sum(m * at[1] for m, at in bodies),
    forces={theta: torque, x5: tool, phi: tool * depth * cos(phi)},
    holonomic_constraints=joints,
    contacts=rubs,
    outputs={
        "torque": torque,
        "cutting": tool,
        "motor_power": torque * theta.diff(),
        "tool_power": -tool * x5.diff(),
        "friction_power": friction_power,
        **{f"force_{name}": reaction(name) for name in joints},
    },
    parameters={
        **LENGTHS, a: -250.0, b: 50.0, depth: 120.0, rp: 20.0, mu: 0.1, g: 9810.0,
        m1: 0.04, m2: 0.003, m3: 0.02, m4: 0.005, m5: 0.06, J1: 2e4, J3: 800.0, J4: 30.0, J5: 3000.0,
    },
    initial=at_start | rates_at_start,
    units={
        **dict.fromkeys((x1, y1, x2, y2, x3, y3, x4, y4, x5, y5, *LENGTHS, a, b, depth, rp), "mm"),
        **dict.fromkeys((theta, psi, chi, phi), "rad"),
        **dict.fromkeys((m1, m2, m3, m4, m5), "t"),
        **dict.fromkeys((J1, J3, J4, J5), "t mm^2"),
        g: "mm/s^2",
        **dict.fromkeys(("cutting", *(f"force_{name}" for name in joints)), "N"),
        **dict.fromkeys(("motor_power", "tool_power", "friction_power"), "mW"),
        "torque": "N mm", "length": "mm", "energy": "mJ", "time": "s",
    },
    drawing=[
        draw.Ground((0, 0)),
        draw.Ground((0, h)),
        draw.Body([(-540, H - depth - 60), (-180, H - depth - 60), (-180, H - depth), (-540, H - depth)]),
        *(draw.Line((place - 30, H - 25), (place + 30, H - 25)) for place in (a, b)),
        draw.Disk(tuple(crank), r + 30, angle=theta),
        draw.Line((0, 0), tuple(pin_b)),
        draw.Disk(tuple(block), 20),
        draw.Line(tuple(pin_b), tuple(pin_c)),
        draw.Body([tuple(end + side * across_ram) for end, side in ((nose, 20), (nose, -20), (tail, -20), (tail, 20))]),
        draw.Line(tuple(nose), tuple(tip)),
        draw.Trace(tuple(pin_b)),
    ],
)  # fmt: skip
