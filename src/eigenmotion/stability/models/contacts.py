"""Mechanisms with contacts and friction."""

from functools import cache

from sympy import Matrix, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from ...codegen.model import Contact, Friction, Model, t

SLOW = 1e-6  # [m/s] `rest` of the contacts
x, y, p = dynamicsymbols("x y p")
m, g, J, b, h, mu = symbols("m g J b h mu", positive=True)


@cache
def box_on_slope() -> Model:
    """Return a box on two rough feet on a slope.

    ::

            ____
           |    |  2 h         x down the slope, y off it, p turns it downhill
           |_  _|
        ----^--^----  slope al
            2 b
    """
    al = symbols("al", nonnegative=True)
    low, high = (_foot(side) for side in (1, -1))
    return Model(
        name="box_on_slope",
        coordinates=[x, y, p],
        kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2) / 2 + J * p.diff() ** 2 / 2,
        potential_energy=m * g * (y * cos(al) - x * sin(al)),
        contacts={
            "low": Contact(low[1], rest=SLOW), "high": Contact(high[1], rest=SLOW),
            "rub_low": Friction(low[0].diff(t), mu, "low"), "rub_high": Friction(high[0].diff(t), mu, "high"),
        },
        parameters={m: 1.0, g: 9.81, mu: 2.0, b: 0.2, h: 1.0, J: 0.4, al: 0.5},
        initial={y: 1.0},
    )  # fmt: skip


def _foot(side: int) -> Matrix:
    """Return the position of a foot of a box turned clockwise by p: the lower one (1), or the upper one (-1)."""
    return Matrix([x + side * b * cos(p) - h * sin(p), y - side * b * sin(p) - h * cos(p)])


@cache
def drawer() -> Model:
    """Return a drawer between two rough guides, pushed by F beside its middle: opposite corners touch and rub.

    It jams if 2 mu e > l, for any F; else x'' = F (1 - 2 mu e / l) / m.
    """
    F, e, l, w = symbols("F e l w", positive=True)
    front = Matrix([x + l / 2 * cos(p) - w / 2 * sin(p), y + l / 2 * sin(p) + w / 2 * cos(p)])
    back = Matrix([x - l / 2 * cos(p) + w / 2 * sin(p), y - l / 2 * sin(p) - w / 2 * cos(p)])
    return Model(
        name="drawer",
        coordinates=[x, y, p],
        kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2) / 2 + J * p.diff() ** 2 / 2,
        forces={x: F, p: F * e},
        contacts={
            "front": Contact(w / 2 - front[1], rest=SLOW), "back": Contact(back[1] + w / 2, rest=SLOW),
            "rub_front": Friction(front[0].diff(t), mu, "front"), "rub_back": Friction(back[0].diff(t), mu, "back"),
        },
        parameters={m: 2.0, J: 0.3, F: 3.0, e: 0.2, l: 0.4, w: 0.5, mu: 0.5},
    )  # fmt: skip


@cache
def two_brakes() -> Model:
    """Return a mass driven by A sin(w t) with two brakes. They act as one brake with the sum of the limits."""
    A, w, total, share = symbols("A w total share", positive=True)
    return Model(
        name="two_brakes",
        coordinates=[x],
        kinetic_energy=m * x.diff() ** 2 / 2,
        forces={x: A * sin(w * t)},
        contacts={"one": Friction(x.diff(), share * total), "two": Friction(x.diff(), (1 - share) * total)},
        parameters={m: 1.0, A: 2.0, w: 2.0, total: 1.2, share: 0.5},
    )


@cache
def jaws() -> Model:
    """Return a block between two jaws with a force P - k t; it sticks while (mu_1 + mu_2) (P - k t) > m g."""
    left, right = dynamicsymbols("left right")
    M, P, k, mu_1, mu_2 = symbols("M P k mu_1 mu_2", positive=True)
    return Model(
        name="jaws",
        coordinates=[left, x, right, y],
        kinetic_energy=M * (left.diff() ** 2 + right.diff() ** 2) / 2 + m * (x.diff() ** 2 + y.diff() ** 2) / 2,
        potential_energy=m * g * y,
        forces={left: P - k * t, right: k * t - P},
        contacts={
            "from_left": Contact(x - left, rest=SLOW), "from_right": Contact(right - x, rest=SLOW),
            "rub_left": Friction(y.diff(), mu_1, "from_left"), "rub_right": Friction(y.diff(), mu_2, "from_right"),
        },
        parameters={m: 1.0, M: 5.0, g: 9.81, P: 30.0, k: 20.0, mu_1: 0.4, mu_2: 0.4},
    )  # fmt: skip


@cache
def stopped() -> Model:
    """Return a mass driven by A sin(w t) on a rough floor, with a stop at x = 1; both have the same row."""
    A, w, limit = symbols("A w limit", positive=True)
    e, rest = symbols("e rest", nonnegative=True)
    return Model(
        name="stopped",
        coordinates=[x],
        kinetic_energy=m * x.diff() ** 2 / 2,
        forces={x: A * sin(w * t)},
        contacts={"stop": Contact(1 - x, e, rest), "rough": Friction(x.diff(), limit)},
        parameters={m: 1.0, A: 10.0, w: 1.0, limit: 3.0, e: 0.0, rest: 1e-3},
    )


@cache
def painleves_rod() -> Model:
    """Return a slender rod of length 2 l that slides on its tip, which it pushes ahead; p from upright.

    No motion is consistent beyond mu = (1 + 3 sin^2 p) / (3 sin p cos p), 1.40 at 0.6.
    """
    l = symbols("l", positive=True)
    tip = Matrix([x + l * sin(p), y - l * cos(p)])
    return Model(
        name="painleves_rod",
        coordinates=[x, y, p],
        kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2 + (l * p.diff()) ** 2 / 3) / 2,
        potential_energy=m * g * y,
        contacts={"tip": Contact(tip[1], rest=SLOW), "rub": Friction(tip[0].diff(t), mu, "tip")},
        parameters={m: 1.0, g: 9.81, l: 1.0, mu: 0.3},
        initial={p: 0.6, y: cos(0.6), x.diff(): 3.0},
    )


@cache
def rocking_block() -> Model:
    """Return Housner's homogeneous block, which rocks on its corners without sliding; p turns it left."""
    left, right = (Matrix([x + s * b * cos(p) + h * sin(p), y + s * b * sin(p) - h * cos(p)]) for s in (-1, 1))
    return Model(
        name="rocking_block",
        coordinates=[x, y, p],
        kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2 + (b**2 + h**2) / 3 * p.diff() ** 2) / 2,
        potential_energy=m * g * y,
        contacts={
            "left": Contact(left[1], rest=SLOW), "right": Contact(right[1], rest=SLOW),
            "rub_left": Friction(left[0].diff(t), mu, "left"), "rub_right": Friction(right[0].diff(t), mu, "right"),
        },
        parameters={m: 1.0, g: 9.81, b: 0.2, h: 1.0, mu: 5.0},
    )  # fmt: skip


@cache
def woodpecker() -> Model:
    """Return Glocker's woodpecker: a sleeve on a pole, and a bird on a spring that pecks at the pole.

    ::

        M (y, phi_M, phi_S)'' linear, as published; the sleeve has clearance: its lower or upper edge touches the pole

    Leine, Glocker, van Campen, Nonlinear dynamics of the woodpecker toy, DETC2001/VIB-21608, (6)-(10) and their data:
    period 0.1452 s, phi_S down to -0.53; of its eight events the last is the jamming of the sleeve.
    """
    y, phi_M, phi_S = dynamicsymbols("y phi_M phi_S")
    m_M, m_S, J_M, J_S, c = symbols("m_M m_S J_M J_S c", positive=True)
    r_0, r_M, h_M, l_M, l_G, h_S, l_S = symbols("r_0 r_M h_M l_M l_G h_S l_S", positive=True)
    e = symbols("e", nonnegative=True)
    bird = (y + l_M * phi_M + l_G * phi_S).diff(t)
    edge = (y + r_M * phi_M).diff(t)
    spun = J_M * phi_M.diff() ** 2 + J_S * phi_S.diff() ** 2
    return Model(
        name="woodpecker",
        coordinates=[y, phi_M, phi_S],
        kinetic_energy=(m_M * y.diff() ** 2 + m_S * bird**2 + spun) / 2,
        potential_energy=c * (phi_M - phi_S) ** 2 / 2 + g * ((m_M + m_S) * y + m_S * (l_M * phi_M + l_G * phi_S)),
        contacts={
            "beak": Contact(l_M + l_G - l_S - r_0 - h_S * phi_S, e, rest=SLOW),
            "lower": Contact(r_M - r_0 + h_M * phi_M, rest=SLOW), "upper": Contact(r_M - r_0 - h_M * phi_M, rest=SLOW),
            "rub_beak": Friction((y + l_M * phi_M + (l_G - l_S) * phi_S).diff(t), mu, "beak"),
            "rub_lower": Friction(edge, mu, "lower"), "rub_upper": Friction(edge, mu, "upper"),
        },
        parameters={
            m_M: 3e-4, J_M: 5e-9, m_S: 4.5e-3, J_S: 7e-7, g: 9.81, c: 5.6e-3, r_0: 2.5e-3, r_M: 3.1e-3, h_M: 5.8e-3,
            l_M: 0.01, l_G: 0.015, h_S: 0.02, l_S: 0.0201, mu: 0.3, e: 0.5,
        },
        initial={phi_M: -0.6 / 5.8, phi_S: -0.53},
    )  # fmt: skip
