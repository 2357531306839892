"""Cases with friction in a plane: a billiard ball that slides and rolls, a tippe top that turns over."""

from dataclasses import replace
from functools import cache

import numpy as np
from sympy import Matrix, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from ...arguments.named_values import Vector
from ...codegen.model import Contact, Friction, Model
from ...reference.extended_precision import Extended
from ..expectation.piecewise_motion import ReducedMotion
from ..expectation.truth import ClosedForm, Integrated, Truth
from ..models.contacts import SLOW
from .case import Case, Trial, rows
from .variants import CONTACTS

m, g, mu = symbols("m g mu", positive=True)
G, BALL, TOP = 9.81, 0.03, 0.02  # [m/s^2], radii [m]
OFF, INERTIA = 0.4 * TOP, 0.4 * 0.006 * TOP**2  # of the top: offset of its centre of mass [m], inertia of a full sphere
TILT, SPIN = 0.3, 100.0  # [rad], [rad/s]


@cache
def billiard_ball() -> Model:
    """Return a ball on cloth; of its rotation only the rates about x and y matter, those of alpha and beta."""
    x, y, z, alpha, beta = dynamicsymbols("x y z alpha beta")
    r = symbols("r", positive=True)
    return Model(
        name="billiard_ball",
        coordinates=[x, y, z, alpha, beta],
        kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2 + z.diff() ** 2) / 2
        + m * r**2 * (alpha.diff() ** 2 + beta.diff() ** 2) / 5,
        potential_energy=m * g * z,
        contacts={
            "cloth": Contact(z - r, rest=SLOW),
            "rub": Friction((x.diff() - r * beta.diff(), y.diff() + r * alpha.diff()), mu, "cloth"),
        },
        parameters={m: 0.17, g: G, mu: 0.2, r: BALL},
        initial={z: BALL},
    )


@cache
def tippe_top() -> Model:
    """Return a sphere whose centre of mass is at a distance a below its centre; Euler angles z, x, z."""
    x, y, z, psi, theta, phi = dynamicsymbols("x y z psi theta phi")
    A, C, R, a = symbols("A C R a", positive=True)
    axis = Matrix([sin(theta) * sin(psi), -sin(theta) * cos(psi), cos(theta)])
    across = Matrix([cos(psi), sin(psi), 0])
    omega = psi.diff() * Matrix([0, 0, 1]) + theta.diff() * across + phi.diff() * axis
    slip = Matrix([x, y, z]).diff() + omega.cross(a * axis - R * Matrix([0, 0, 1]))
    return Model(
        name="tippe_top",
        coordinates=[x, y, z, psi, theta, phi],
        kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2 + z.diff() ** 2) / 2
        + A * (theta.diff() ** 2 + (psi.diff() * sin(theta)) ** 2) / 2
        + C * (phi.diff() + psi.diff() * cos(theta)) ** 2 / 2,
        potential_energy=m * g * z,
        contacts={
            "floor": Contact(z + a * cos(theta) - R, rest=SLOW),
            "rub": Friction((slip[0], slip[1]), mu, "floor"),
        },
        parameters={m: 0.006, g: G, mu: 0.06, A: INERTIA, C: INERTIA, R: TOP, a: OFF},
        initial={theta: TILT, phi.diff(): SPIN, z: TOP - OFF * np.cos(TILT)},
    )


def rolls(friction: float) -> Trial:
    """Return a ball whose slip decreases evenly, by mu g at the centre, 7/2 mu g at the contact, until it rolls."""
    v0 = np.array([1.0, 0.5, 0.0, 30.0, -20.0])

    def struck(start: Vector, elapsed: Vector) -> Vector:
        v, w = start[5:7], start[8:10]
        slip = v + BALL * np.array([-w[1], w[0]])
        size = float(np.hypot(*slip))
        t = np.minimum(elapsed, 2 * size / (7 * friction * G))[:, None]
        a = -friction * G * slip / size
        turn = 2.5 / BALL * np.array([a[1], -a[0]])  # m r^2 2/5 alpha'' = r F_y, and beta'' = -r F_x
        late = elapsed[:, None] - t
        values = np.tile(start, (len(elapsed), 1))
        values[:, 5:7], values[:, 8:10] = v + a * t, w + turn * t
        values[:, :2] += v * t + a * t**2 / 2 + values[:, 5:7] * late
        values[:, 3:5] += w * t + turn * t**2 / 2 + values[:, 8:10] * late
        return values

    x0 = np.array([0.0, 0.0, BALL, 0.0, 0.0])
    return _trial(f"{friction:g}", {"mu": friction}, x0, v0, 1.0, ClosedForm(struck, "a parabola, then a line"))


def turns_over(friction: float) -> Trial:
    """Return the slipping top in x, y and three angles; the force of the floor follows from z = R - a cos theta."""
    p = {"m": 0.006, "A": INERTIA, "C": INERTIA, "a": OFF}

    def shown(values: Vector) -> Vector:
        x, theta, v, w = values[:, :2], values[:, 3:4], values[:, 5:7], values[:, 8:9]
        z, fall = TOP - p["a"] * np.cos(theta), p["a"] * np.sin(theta) * w
        return np.hstack([x, z, values[:, 2:5], v, fall, values[:, 7:]])

    keep = [0, 1, 3, 4, 5, 6, 7, 9, 10, 11]
    scale = np.array([0.01, 0.01, 1, 1, 1, 0.1, 0.1, 10, 10, 100.0])
    inner = Integrated(lambda _, z: top_rates(z, friction, **p), scale)
    x0 = np.array([0.0, 0.0, TOP - OFF * np.cos(TILT), 0.0, TILT, 0.0])
    v0 = np.array([0.0, 0.0, 0.0, 0.0, 0.0, SPIN])
    truth = ReducedMotion(inner, lambda start: start[keep], shown)
    # perturbed starts are on the floor, too
    return replace(_trial(f"{friction:g}", {"mu": friction}, x0, v0, 2.5, truth), nearby=True)


def top_rates(state: Extended, friction: float, m: float, A: float, C: float, a: float) -> Extended:
    """Return the rates of x, y, psi, theta, phi and of their rates, by Euler's equations in axes of the nodal line."""
    _, _, psi, theta, _, vx, vy, turn, nod, spin = state
    s, c, sp, cp = np.sin(theta), np.cos(theta), np.sin(psi), np.cos(psi)
    e1, e3, up = np.array([cp, sp, 0 * s]), np.array([s * sp, -s * cp, c]), np.array([0 * s, 0 * s, 1 + 0 * s])
    e2, arm = np.cross(e3, e1), a * e3 - np.longdouble(TOP) * up
    w3 = spin + turn * c
    omega = nod * e1 + turn * s * e2 + w3 * e3
    slip = np.array([vx, vy, a * s * nod]) + np.cross(omega, arm)
    way = slip[:2] / np.sqrt(slip[0] ** 2 + slip[1] ** 2)
    push = np.array([-friction * way[0], -friction * way[1], 1 + 0 * s])  # of the floor, over N
    torque = np.cross(arm, push)
    t1, t2, t3 = torque @ e1, torque @ e2, torque @ e3
    rest = turn * s * C * w3 - turn * c * A * turn * s
    nods = (m * (np.longdouble(G) + a * c * nod**2) * t1 - rest) / (A - m * a * s * t1)
    N = m * (np.longdouble(G) + a * c * nod**2 + a * s * nods)
    turns = ((N * t2 - turn * c * A * nod + nod * C * w3) / A - turn * c * nod) / s
    spins = N * t3 / C - turns * c + turn * s * nod
    return np.array([vx, vy, turn, nod, spin, N * push[0] / m, N * push[1] / m, turns, nods, spins])


def _trial(label: str, parameters: dict[str, float], x0: Vector, v0: Vector, end: float, truth: Truth) -> Trial:
    times = rows(0.0, end)
    return Trial(label, parameters, x0, v0, np.ones(len(x0)), 0.0, times, truth, conserves=False, nearby=False)


CASES = (
    Case(
        "billiard", "A billiard ball",
        "Struck with side and draw, it slides along a parabola and then rolls straight on.",
        "friction coefficient", (0.05, 0.2, 0.5), lambda _: billiard_ball(), rolls, variants=CONTACTS, reduced=(0.2,),
    ),
    Case(
        "tippe_top", "A tippe top",
        "Spun on its round side, it rises and turns over, here by up to 1.4 rad; it slips all the time.",
        "friction coefficient", (0.04, 0.06, 0.08), lambda _: tippe_top(), turns_over, variants=CONTACTS,
        reduced=(0.06,),
    ),
)  # fmt: skip
