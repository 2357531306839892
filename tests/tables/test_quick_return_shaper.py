"""models/quick_return_shaper.py: power balance, one coordinate without friction, Newton's equations with friction."""

from bisect import bisect_right
from functools import cache

import numpy as np
import pytest
import sympy
from scipy.integrate import solve_ivp
from scipy.interpolate import PchipInterpolator
from sympy.utilities.lambdify import implemented_function

from ..oracles.bearings import Bearings, Rubs
from ..support.by_day import PAGE
from ..support.generation import FORMULATIONS, system_of
from ..support.shown import check_page, check_picture, integrals

r, h, L, l, H, D, DEPTH, RP, MU, G = 100.0, 300.0, 650.0, 250.0, 620.0, 150.0, 120.0, 20.0, 0.1, 9810.0
FRONT, BACK = -250.0, 50.0
CRANK, BLOCK, LEVER, ROD, RAM = 0.04, 0.003, 0.02, 0.005, 0.06
MASSES = np.array([CRANK, CRANK, 2e4, BLOCK, BLOCK, LEVER, LEVER, 800.0, ROD, ROD, 30.0, RAM, RAM, 3000.0])
HEIGHTS = [1, 4, 6, 9, 12]
THETA, PSI, CHI, PLACE, PHI = 2, 7, 10, 11, 13
SPEED = 0.97 * 2 * np.pi

slips = np.array([1.2, 1.0, 0.8, 0.6, 0.5, 0.4, 0.3, 0.25, 0.2, 0.15, 0.1, 0.05, 0.0, -0.05, -0.1])
motor = PchipInterpolator(2 * np.pi * (1 - slips), 2 * 6e5 * 0.2 * slips / (slips**2 + 0.2**2))
chip = PchipInterpolator(
    [-290.0, -275.0, -250.0, -200.0, -150.0, -100.0, -50.0, 0.0, 40.0, 55.0, 70.0],
    [0.0, 1850.0, 2010.0, 2090.0, 1980.0, 2150.0, 2060.0, 1940.0, 2120.0, 1900.0, 0.0],
)


def pieces(spline: PchipInterpolator):
    """x -> its value at a number inside: the cubic of the piece, without NumPy, which takes ten times as long."""
    breaks, cubics = spline.x.tolist(), spline.c.T.tolist()

    def value(x: float) -> float:
        k = min(bisect_right(breaks, x), len(cubics)) - 1
        a, b, c, d = cubics[k]
        x -= breaks[k]
        return ((a * x + b) * x + c) * x + d

    return value


motor_at, chip_at = pieces(motor), pieces(chip)


def cutting(place: float, rate: float) -> float:
    """The force [N] of the work on the tool, to the right."""
    return chip_at(place) if rate < 0 and -290 < place < 70 else 0.0


# --- the loops in closed form ---


@cache
def linkage():
    """theta -> all coordinates and their first two derivatives with theta, (3, 14)."""
    angle = sympy.Symbol("angle")
    swing = sympy.pi / 2 - sympy.atan(r * sympy.cos(angle) / (h + r * sympy.sin(angle)))
    B = [L * sympy.cos(swing), L * sympy.sin(swing)]
    tilt = sympy.pi - sympy.asin((H - B[1]) / l)
    C = [B[0] + l * sympy.cos(tilt), H]
    pose = [0, h, angle, r * sympy.cos(angle), h + r * sympy.sin(angle), B[0] / 2, B[1] / 2, swing,
            (B[0] + C[0]) / 2, (B[1] + H) / 2, tilt, C[0] + D, H, 0]  # fmt: skip
    orders = [[sympy.sympify(q).diff(angle, order) if order else q for q in pose] for order in range(3)]
    function = sympy.lambdify(angle, orders, "math", cse=True)
    return lambda value: np.array(function(value), dtype=float)


def start() -> np.ndarray:
    q, slope, _ = linkage()(0.0)
    return np.concatenate([q, SPEED * slope])


def one_coordinate(t: float, z: np.ndarray) -> list[float]:
    """I theta'' + I' theta'^2 / 2 + V' = torque + force x', without friction."""
    q, slope, bend = linkage()(z[0])
    inertia, half = MASSES @ slope**2, MASSES @ (slope * bend)
    gravity = G * MASSES[HEIGHTS] @ slope[HEIGHTS]
    work = cutting(q[PLACE], slope[PLACE] * z[1]) * slope[PLACE]
    return [z[1], (motor_at(z[1]) + work - gravity - half * z[1] ** 2) / inertia]


TIMES = np.linspace(0.0, 1.0, 11)


@cache
def frictionless() -> np.ndarray:
    given = {"method": "DOP853", "t_eval": TIMES, "rtol": 1e-12, "atol": 1e-12, "max_step": 2.5e-3}
    return solve_ivp(one_coordinate, (0.0, 1.0), [0.0, SPEED], **given).y


@pytest.mark.parametrize("method", ["dop853", "ra15", "radau9"])
@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_without_friction_it_has_one_coordinate(formulation, method):
    found = system_of("quick_return_shaper", formulation).simulate(
        (0, 1), t_eval=TIMES, method=method, parameters={"mu": 0.0}, rtol=1e-10, atol=1e-10
    )
    assert found.success
    right = frictionless()
    np.testing.assert_allclose(found.x[THETA], right[0], rtol=0, atol=1e-8)
    np.testing.assert_allclose(found.v[THETA], right[1], rtol=0, atol=1e-7)
    poses = np.array([linkage()(angle)[0] for angle in right[0]]).T
    np.testing.assert_allclose(found.x, poses, rtol=1e-8, atol=1e-6)


# --- friction ---

PINS = ("bearing", "crank_pin", "pivot", "lever_pin", "ram_pin")
ROWS = {"bearing": (0, 1), "crank_pin": (2, 3), "slot": (4,), "pivot": (5, 6), "lever_pin": (7, 8), "ram_pin": (9, 10),
        "front": (11,), "back": (12,)}  # fmt: skip
TURN_WITH = {"slot": ("slot", "ram_pin"), "pivot": ("pivot", "lever_pin", "ram_pin", "front", "back")}
"""Slips that pass through zero together: at the lever's middle position, and at its extreme ones."""


@cache
def newton() -> tuple[Bearings, tuple[str, ...]]:
    """Newton's equations of all bodies with what rubs, written out anew; and the names of what rubs."""
    x, v = sympy.symbols("x:14"), sympy.symbols("v:14")
    x1, y1, th, x2, y2, x3, y3, ps, x4, y4, ch, x5, y5, ph = x
    c, s = sympy.cos, sympy.sin
    phi = [
        x1, y1 - h, x2 - x1 - r * c(th), y2 - y1 - r * s(th), (y2 - y3) * c(ps) - (x2 - x3) * s(ps),
        x3 - L / 2 * c(ps), y3 - L / 2 * s(ps),
        x4 - l / 2 * c(ch) - x3 - L / 2 * c(ps), y4 - l / 2 * s(ch) - y3 - L / 2 * s(ps),
        x5 - D * c(ph) - x4 - l / 2 * c(ch), y5 - D * s(ph) - y4 - l / 2 * s(ch),
        *((y5 - H) * c(ph) - (x5 - place) * s(ph) for place in (FRONT, BACK)),
    ]  # fmt: skip
    along = c(ps) * (v[3] - v[5]) + s(ps) * (v[4] - v[6]) + (c(ps) * (y2 - y3) - s(ps) * (x2 - x3)) * v[PSI]
    guide = c(ph) * v[11] + s(ph) * v[12]
    slip = {"bearing": v[THETA], "crank_pin": v[THETA] - v[PSI], "slot": along, "pivot": v[PSI],
            "lever_pin": v[PSI] - v[CHI], "ram_pin": v[CHI] - v[PHI], "front": guide, "back": guide}  # fmt: skip
    torque = implemented_function("torque", motor_at)
    chips = implemented_function("chips", cutting)
    force = chips(x5, v[PLACE])
    forces = [sympy.Integer(0)] * 14
    for place in HEIGHTS:
        forces[place] = sympy.Float(-G * MASSES[place])
    forces[THETA], forces[PLACE], forces[PHI] = torque(v[THETA]), force, force * DEPTH * c(ph)
    rubs = [Rubs(MU * (RP if name in PINS else 1.0), slip[name], ROWS[name]) for name in ROWS]
    return Bearings(x, v, MASSES, forces, phi, rubs), tuple(ROWS)


@cache
def rubbing(end: float) -> np.ndarray:
    """The state (28,) at the end, by SciPy, restarted where slips turn."""
    bearings, names = newton()
    y, t = start(), 0.0
    signs = dict(zip(names, np.sign(bearings.slips(0.0, y)), strict=True))
    signs["ram_pin"] = signs["ram_pin"] or 1.0

    def rates(t: float, y: np.ndarray) -> np.ndarray:
        return np.concatenate([y[14:], bearings.solved(t, y, list(signs.values()))[0]])

    watched = [lambda t, y, k=k: bearings.slips(t, y)[k] for k in map(names.index, TURN_WITH)]
    for one in watched:
        one.terminal = True  # type: ignore[attr-defined]
    while True:
        run = solve_ivp(rates, (t, end), y, "DOP853", rtol=1e-10, atol=1e-10, events=watched, max_step=0.02)
        assert run.status >= 0, run.message
        t, y = run.t[-1], run.y[:, -1]
        if run.status == 0:
            return y
        (name,) = (name for name, found in zip(TURN_WITH, run.t_events, strict=True) if len(found))
        for one in TURN_WITH[name]:
            signs[one] = -signs[one]
        t, y = t + 1e-9, y + 1e-9 * rates(t, y)


@pytest.mark.parametrize("method", ["dop853", "ra15", "radau9"])
@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_with_friction_it_moves_as_newton_says(formulation, method):
    """Over a slot's turn and an extreme position of the lever, where five slips are zero at once."""
    right = rubbing(0.62)
    found = system_of("quick_return_shaper", formulation).simulate((0, 0.62), method=method, rtol=1e-10, atol=1e-10)
    assert found.success
    assert [len(times) for times in found.t_events] == [0, 0, 1, 1, 1, 2, 1, 1]
    np.testing.assert_allclose(found.x[:, -1], right[:14], rtol=1e-8, atol=1e-5)
    assert found.x[THETA, -1] == pytest.approx(right[THETA], abs=1e-7)


def lost(run, k: int) -> float:
    """Power of friction [mJ/s] in row k of a run, of its multipliers and rates."""
    bearings, names = newton()
    rates = bearings.slips(0.0, np.concatenate([run.x[:, k], run.v[:, k]]))
    presses = [np.linalg.norm(run.multipliers[list(ROWS[name]), k]) * (RP if name in PINS else 1.0) for name in names]
    return float(MU * np.abs(rates) @ presses)


def test_powers_balance_at_every_row():
    """Motor = tool + friction + d/dt (T + V), with accelerations from the multipliers: M a = Q - A^T lambda."""
    system = system_of("quick_return_shaper", "lagrange")
    found = system.simulate((0, 2), rtol=1e-10, atol=1e-10)
    powers = found.outputs
    largest = powers["motor_power"].max()
    assert powers["friction_power"].max() > 0.1 * largest
    inside = [k for k in range(1, len(found.t) - 1) if not np.isclose(found.t[k], np.concatenate(found.t_events)).any()]
    assert len(inside) > 100
    modes = iter([*found.modes[1:], (np.inf, None)])
    mode, (until, following) = found.modes[0][1], next(modes)
    for k in inside:
        while found.t[k] > until:
            mode, (until, following) = following, next(modes)
        a = system.acceleration(found.x[:, k], found.v[:, k], found.t[k], parameters=mode)[0]
        stored = MASSES @ (found.v[:, k] * a) + G * MASSES[HEIGHTS] @ found.v[HEIGHTS, k]
        fed = float(motor(found.v[THETA, k])) * found.v[THETA, k]
        taken = -cutting(found.x[PLACE, k], found.v[PLACE, k]) * found.v[PLACE, k]
        friction = lost(found, k)
        assert [powers[name][k] for name in ("motor_power", "tool_power", "friction_power")] == pytest.approx(
            [fed, taken, friction], abs=1e-8 * largest
        )
        assert abs(fed - taken - friction - stored) < 1e-8 * largest


def test_works_balance_over_a_stroke():
    names = ("motor_power", "tool_power", "friction_power")
    run, (fed, taken, friction) = integrals(
        system_of("quick_return_shaper", "lagrange"), (0.0, 1.0), names, rtol=1e-12, atol=1e-11, max_step=5e-3
    )
    assert taken == pytest.approx(chip.integrate(-290, 70), rel=1e-6)
    assert run.energy[-1] - run.energy[0] == pytest.approx(fed - taken - friction, abs=1e-8 * fed)


def test_the_return_is_quicker_than_the_cut():
    """At a constant speed of the crank the ratio is (pi + 2 asin(r / h)) / (pi - 2 asin(r / h))."""
    found = system_of("quick_return_shaper").simulate((0, 4), parameters={"J1": 1e9}, rtol=1e-9, atol=1e-9)
    turns = found.t_events[3][:3]
    forward, back = turns[2] - turns[1], turns[1] - turns[0]
    swing = 2 * np.arcsin(r / h)
    assert forward / back == pytest.approx((np.pi + swing) / (np.pi - swing), rel=1e-4)


@pytest.mark.nightly(PAGE)
def test_page_and_picture(scene, hurried):
    check_picture("quick_return_shaper", scene.parent, "--t-end", "1")
    check_page("quick_return_shaper", scene.parent)
