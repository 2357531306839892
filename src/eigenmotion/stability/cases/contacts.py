"""Cases with contacts and friction: boxes that tip, skid and jam, brakes, jaws, stops, rods, rocking blocks."""

from math import cos, sin, tan

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model import Model
from ...reference.extended_precision import Extended
from ...reference.integration import NotReachedError
from ..expectation.piecewise_motion import DrivenFrictionMass, ReducedMotion, RockingBlock, TabulatedMotion
from ..expectation.truth import ClosedForm, Integrated, Truth
from ..expectation.woodpecker import ROWS
from ..models.contacts import box_on_slope, drawer, jaws, painleves_rod, rocking_block, stopped, two_brakes, woodpecker
from .case import Case, Trial, rows, start_of
from .variants import CONTACTS

G = 9.81


def _trial(
    model: Model, label: str, parameters: dict[str, float], end: float, truth: Truth, x0: Vector | None = None,
    v0: Vector | None = None,
) -> Trial:  # fmt: skip
    """Return a trial that starts in contact; a perturbed start would not, so that kappa is 0."""
    there, moves = start_of(model)
    x0, v0 = there if x0 is None else x0, moves if v0 is None else v0
    times = rows(0.0, end)
    return Trial(label, parameters, x0, v0, np.ones(len(x0)), 0.0, times, truth, conserves=False, nearby=False)


# --- boxes ------------------------------------------------------------------------------------------------------------


def tips(slope: float) -> Trial:
    """Return a tall box that turns about its lower foot: (J + m r^2) p'' = m g times the lever of its weight."""
    b, h, J = 0.2, 1.0, 0.4

    def rates(_: Extended, z: Extended) -> Extended:
        s, c = np.sin(z[0]), np.cos(z[0])
        pull = (b * s + h * c) * np.sin(np.longdouble(slope)) - (b * c - h * s) * np.cos(np.longdouble(slope))
        return np.stack([z[1], np.longdouble(G) * pull / (np.longdouble(J) + b * b + h * h)])

    def shown(values: Vector) -> Vector:
        p, w = values.T
        s, c = np.sin(p), np.cos(p)
        lever, height = b * s + h * c, b * c - h * s
        return np.stack([b - height, lever, p, lever * w, height * w, w], axis=1)

    truth = ReducedMotion(Integrated(rates, np.ones(2)), lambda start: start[[2, 5]], shown)
    return _trial(box_on_slope(), f"{slope:g}", {"al": slope}, 0.4, truth)


def skids(friction: float) -> Trial:
    """Return a low box that slides on both feet and stops after v / (mu g)."""

    def slid(start: Vector, elapsed: Vector) -> Vector:
        t = np.minimum(elapsed, start[3] / (friction * G))
        values = np.tile(start, (len(elapsed), 1))
        values[:, 0] += start[3] * t - friction * G * t**2 / 2
        values[:, 3] = start[3] - friction * G * t
        return values

    truth = ClosedForm(slid, "even deceleration, and rest")
    parameters = {"al": 0.0, "b": 2.0, "mu": friction}
    v0 = np.array([1.0, 0.0, 0.0])
    return _trial(box_on_slope(), f"{friction:g}", parameters, 1.5 / (friction * G), truth, v0=v0)


def jams(friction: float) -> Trial:
    """Return a drawer of length 0.4 that is pushed 0.2 beside its middle; it jams if mu is more than 1."""
    a = max(0.0, 3.0 * (1 - 2 * friction * 0.2 / 0.4) / 2.0)

    def pushed(start: Vector, elapsed: Vector) -> Vector:  # noqa: ARG001, it rests
        values = np.zeros((len(elapsed), 6))
        values[:, 0], values[:, 3] = a * elapsed**2 / 2, a * elapsed
        return values

    return _trial(drawer(), f"{friction:g}", {"mu": friction}, 1.0, ClosedForm(pushed, "even acceleration, or rest"))


# --- equal rows -------------------------------------------------------------------------------------------------------


def brakes(share: float) -> Trial:
    """Return two brakes of 1.2 N in total."""
    truth = ClosedForm(DrivenFrictionMass(1.0, 2.0, 2.0, 1.2), "one brake of both limits, piece by piece", own=1e-11)
    return _trial(two_brakes(), f"{share:g}", {"share": share}, 6.0, truth)


def slips(share: float) -> Trial:
    """Return a block between jaws: m y'' = (mu_1 + mu_2) (P - k t) - m g, after that has become negative."""
    both, P, k = 0.8, 30.0, 20.0

    def fell(start: Vector, elapsed: Vector) -> Vector:  # noqa: ARG001, it rests
        t = np.maximum(elapsed - (P - G / both) / k, 0.0)
        values = np.zeros((len(elapsed), 8))
        values[:, 3], values[:, 7] = -both * k * t**3 / 6, -both * k * t**2 / 2
        return values

    parameters = {"mu_1": share * both, "mu_2": (1 - share) * both}
    return _trial(jaws(), f"{share:g}", parameters, 1.4, ClosedForm(fell, "rest, and a cubic"))


def stops(e: float) -> Trial:
    """Return a mass with friction at its stop, against which it is pressed until the force changes its sign."""
    truth = ClosedForm(
        DrivenFrictionMass(1.0, 10.0, 1.0, 3.0, e, 1e-3), "pieces between slides, blows and rests", own=1e-10
    )
    return _trial(stopped(), f"{e:g}", {"e": e}, 5.0, truth)


# --- rods and blocks --------------------------------------------------------------------------------------------------


def slides(friction: float) -> Trial:
    """Return Painleve's rod, pushed along; there is no motion beyond mu = (1 + 3 sin^2 p) / (3 sin p cos p)."""
    mu, g = np.longdouble(friction), np.longdouble(G)

    def rates(_: Extended, z: Extended) -> Extended:
        p, v, w = z[1], z[2], z[3]
        s, c = np.sin(p), np.cos(p)
        factor = 1 + 3 * s * (s - mu * c)
        N = (g - c * w**2) / factor
        if not (factor > 0 and N > 0 and v + c * w > 0):
            raise NotReachedError("no acceleration satisfies contact and friction")
        return np.stack([v, w, -mu * N, 3 * N * (s - mu * c)])

    def shown(values: Vector) -> Vector:
        x, p, v, w = values.T
        return np.stack([x, np.cos(p), p, v, -np.sin(p) * w, w], axis=1)

    truth = ReducedMotion(Integrated(rates, np.ones(4)), lambda start: start[[0, 2, 3, 5]], shown)
    return _trial(painleves_rod(), f"{friction:g}", {"mu": friction}, 0.03, truth)


def rocks(slenderness: float) -> Trial:
    """Return Housner's block, released at 0.4 of the angle at which it would fall over, for about five impacts."""
    h = 1.0
    b = h * tan(slenderness)
    block, p = RockingBlock(b, h, G), 0.4 * slenderness
    truth = ClosedForm(block, "turning about either corner, 1 - 3/2 sin^2 alpha left by each blow", own=1e-10)
    x0 = np.array([-b + b * cos(p) - h * sin(p), b * sin(p) + h * cos(p), p])
    end = 5.03 * block.until_the_first(p)
    return _trial(rocking_block(), f"{slenderness:g}", {"b": b, "h": h}, end, truth, x0, np.zeros(3))


def pecks(friction: float) -> Trial:
    """Return Glocker's woodpecker, which moves down its pole."""
    model = woodpecker()
    x0, v0 = start_of(model)
    truth = TabulatedMotion(ROWS, "matrix exponentials between published events")
    units = np.array([0.01, 1.0, 1.0])
    return Trial(
        f"{friction:g}", {"mu": friction}, x0, v0, units, 0.0, ROWS[:, 0], truth, conserves=False, nearby=False
    )


_SHARES = (0.01, 0.1, 0.3, 0.5, 0.9)

CASES = (
    Case(
        "tips", "Boxes that tip",
        "A tall box on a slope turns about its lower foot, which sticks, while the upper one opens.",
        "slope [rad]", (0.22, 0.3, 0.5, 0.7), lambda _: box_on_slope(), tips, variants=CONTACTS, reduced=(0.5,),
    ),
    Case(
        "skids", "Boxes that skid",
        "A low box slides on two rough feet until it stops; then the forces are not unique, but the motion is.",
        "friction coefficient", (0.01, 0.1, 0.5, 1.0), lambda _: box_on_slope(), skids, variants=CONTACTS,
        reduced=(0.5,),
    ),
    Case(
        "jams", "Boxes that jam",
        "A drawer between two rough guides, pushed beside its middle: opposite corners touch; it jams beyond mu = 1.",
        "friction coefficient", (0.1, 0.5, 0.7, 1.01, 2.0), lambda _: drawer(), jams, variants=CONTACTS,
        reduced=(2.0,),
    ),
    Case(
        "brakes", "Two brakes on one mass",
        "A mass driven by a sine, with two brakes: their forces are not unique, but the motion is, as with one brake.",
        "share of one", _SHARES, lambda _: two_brakes(), brakes, variants=CONTACTS, reduced=(0.3,),
    ),
    Case(
        "jaws", "A block between jaws",
        "The pressure decreases until the friction of both jaws together no longer carries the block.",
        "share of one", _SHARES, lambda _: jaws(), slips, variants=CONTACTS, reduced=(0.3,),
    ),
    Case(
        "stop", "A mass with friction at its stop",
        "Driven by a sine against its stop: it bounces, is pressed, rests as the force fades, and is pulled back.",
        "restitution", (0.0, 0.2, 0.5), lambda _: stopped(), stops, variants=CONTACTS, reduced=(0.0,),
    ),
    Case(
        "painleve", "Painleve's rod",
        "A rod that pushes its tip ahead; beyond a friction coefficient of 1.40 no motion is consistent.",
        "friction coefficient", (0.1, 0.5, 1.0, 1.2, 1.5, 3.0), lambda _: painleves_rod(), slides, variants=CONTACTS,
        reduced=(1.0, 3.0),
    ),
    Case(
        "housner", "Housner's block",
        "A homogeneous block that rocks on two corners without sliding; friction takes part in the impacts.",
        "atan(width / height) [rad]", (0.05, 0.1, 0.2, 0.4), lambda _: rocking_block(), rocks, variants=CONTACTS,
        reduced=(0.2,),
    ),
    Case(
        "woodpecker", "Glocker's woodpecker",
        "A sleeve on a pole and a bird on its spring: it jams, slides, lets go, strikes above, pecks, strikes again. "
        "Impacts with friction, in the published order.",
        "friction coefficient", (0.3,), lambda _: woodpecker(), pecks, variants=CONTACTS, reduced=(0.3,),
    ),
)  # fmt: skip
