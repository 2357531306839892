"""Cases with long spans, extreme units, special starts and large size."""

from math import cos, pi, sin, sqrt
from typing import NamedTuple

import numpy as np
from scipy.special import ellipj, ellipk, ellipkinc

from ...arguments.named_values import Vector
from ...models import chain as chain_model
from ...models import slider_crank
from ..expectation.closed_forms import chain, oscillation
from ..expectation.truth import ClosedForm, lagrange
from ..models.smooth import bent_oscillators, cartesian_pendulum, elastic_link, hung_pendulum
from .case import Case, Trial, integrated, power, rows, start_of
from .singular_positions import closed_loop
from .variants import CONSTRAINED, SEVERAL_ROWS, UNSTABILISED, Variant

ROWS = 400


def oscillators(periods: float) -> Trial:
    """Return two linear oscillators in curved coordinates, for many periods of the slower one."""
    x0, v0 = start_of(bent_oscillators())
    truth = ClosedForm(_bent, "linear oscillators", own=1e-9)
    times = rows(0.0, 2 * pi * periods, ROWS)
    return Trial(power(periods), {}, x0, v0, np.ones(2), 0.0, times, truth, periods=periods)


def _bent(start: Vector, elapsed: Vector) -> Vector:
    x, z, x_dot, z_dot = start
    c, w = 0.8, (1.0, sqrt(2.0))
    u, u_dot = oscillation(x + c * z**2 / 2, x_dot + c * z * z_dot, w[0], elapsed)
    z_t, z_t_dot = oscillation(z, z_dot, w[1], elapsed)
    return np.stack([u - c * z_t**2 / 2, z_t, u_dot - c * z_t * z_t_dot, z_t_dot], axis=1)


def pendulum(periods: float) -> Trial:
    """Return a pendulum with amplitude 1 rad and a holonomic constraint."""
    x0, v0 = start_of(cartesian_pendulum())
    period = float(4 * ellipk(sin(0.5) ** 2))
    truth = ClosedForm(_swing, "Jacobi's elliptic functions", own=1e-9)
    times = rows(0.0, period * periods, ROWS)
    return Trial(power(periods), {}, x0, v0, np.ones(2), 0.0, times, truth, periods=periods)


def _swing(start: Vector, elapsed: Vector) -> Vector:
    """Return the rows of sin(theta / 2) = k sn(t + t0), theta' = 2 k cn(t + t0), for g = l."""
    x, y, x_dot, y_dot = start
    theta = np.arctan2(x, -y)
    rate = x_dot * cos(theta) + y_dot * sin(theta)
    k = np.hypot(sin(theta / 2), rate / 2)
    begin = ellipkinc(np.arctan2(sin(theta / 2), rate / 2), k**2)
    whole = 4 * ellipk(k**2)
    sn, cn, dn, _ = ellipj(np.remainder(elapsed + begin, whole), k**2)
    s, c, rates = 2 * k * sn * dn, 1 - 2 * (k * sn) ** 2, 2 * k * cn
    return np.stack([s, -c, rates * c, rates * s], axis=1)


def origin(distance: float) -> Trial:
    """Return the same pendulum, hung so that its mass passes the origin (1), or far away, off both axes."""
    hung = distance * np.array([0.0, 1.0]) if distance == 1.0 else distance * np.array([1.0, -1.0])
    x0, v0 = start_of(hung_pendulum())
    truth = ClosedForm(lambda start, t: _swing_about(hung, start, t), "Jacobi's elliptic functions", own=1e-13)
    parameters = {"x_0": hung[0], "y_0": hung[1]}
    return Trial(power(distance), parameters, x0 + hung, v0, np.ones(2), 0.0, rows(0.0, 20.0), truth)


def _swing_about(hung: Vector, start: Vector, elapsed: Vector) -> Vector:
    shift = np.concatenate([hung, np.zeros(2)])
    return np.asarray(_swing(start - shift, elapsed) + shift)


def lengths_of_link(u: float) -> Trial:
    """Return the elastic link with lengths in a unit of u metres; angles and times do not change."""
    return _elastic(u, 1.0, power(u))


def masses_of_link(w: float) -> Trial:
    """Return the elastic link with masses in a unit of w kilograms."""
    return _elastic(1.0, w, power(w))


def _elastic(u: float, w: float, label: str) -> Trial:
    parameters = {"m_1": w, "m_2": w, "l": u, "L": u, "k": 50 * w, "d": 0.0, "K_1": 20 * w * u**2, "K_2": 10 * w * u**2}
    x0, v0 = start_of(elastic_link())
    x0[2] = 0.1 * u
    units = np.array([1.0, 1.0, u])
    return integrated(label, lagrange(elastic_link(), parameters), parameters, x0, v0, units, rows(0.0, 2.0))


def lengths_of_crank(u: float) -> Trial:
    """Return the slider-crank with lengths in a unit of u metres."""
    return _crank(u, 1.0, power(u))


def masses_of_crank(w: float) -> Trial:
    """Return the slider-crank with masses in a unit of w kilograms."""
    return _crank(1.0, w, power(w))


def _crank(u: float, w: float, label: str, start: float = 0.0, end: float = 1.0, rate: float = 5.0) -> Trial:
    parameters = {"r": 0.3 * u, "l": u, "m_c": w, "m_r": w, "m_s": 2 * w, "g": 9.81 * u}
    state = closed_loop(1.0, rate, parameters["r"], parameters["l"])
    rhs, units = lagrange(slider_crank.model, parameters), np.array([1.0, 1.0, u])
    return integrated(label, rhs, parameters, state[:3], state[3:], units, rows(start, end), start)


class _Start(NamedTuple):
    """Start and end of a run [s], the angle of a pendulum's links, and whether the mechanism moves at the start."""

    label: str
    start: float = 0.0
    end: float = 2.0
    angle: float = 1.0
    moves: bool = True


_STARTS = (
    _Start("forwards"), _Start("at rest", moves=False), _Start("stable\nequilibrium", angle=0.0, moves=False),
    _Start("unstable\nequilibrium", angle=pi, moves=False), _Start("zero length", 1.0, 1.0),
    _Start("backwards", 2.0, 0.0), _Start("not from 0", 1e6, 1e6 + 2.0),
)  # fmt: skip


def starts_of_pendulum(which: float) -> Trial:
    """Return a double pendulum with a start of `_STARTS`."""
    chosen, units = _STARTS[int(which)], np.ones(2)
    x0, v0 = chosen.angle * units, np.array([0.5, -0.5]) if chosen.moves else np.zeros(2)
    times = rows(chosen.start, chosen.end)
    return integrated(chosen.label, chain(units, units, 9.81), {}, x0, v0, units, times, chosen.start)


def starts_of_crank(which: float) -> Trial:
    """Return a slider-crank with a start of `_STARTS`."""
    chosen = _STARTS[int(which)]
    return _crank(1.0, 1.0, chosen.label, chosen.start, chosen.end, rate=5.0 * chosen.moves)


def links(n: float) -> Trial:
    """Return a chain of n links, released at 45 degrees."""
    ones, x0 = np.ones(int(n)), np.full(int(n), pi / 4)
    return integrated(str(int(n)), chain(ones, ones, 9.81), {}, x0, 0 * x0, ones, rows(0.0, 1.0, 20))


_UNITS = tuple(10.0**e for e in range(-12, 13, 3))
_PERIODS = (1e2, 1e3, 1e4, 1e5)
_LONG = {"rk34": 1e-6, "dopri5": 1e-7, "dop853": 1e-8}
_LONG_VARIANTS = (Variant("eigenfactor"), Variant("cholesky"), Variant("lagrange"), UNSTABILISED)

CASES = (
    Case(
        "long_free", "Many periods, no constraint",
        "Two linear oscillators in curved coordinates, in which M is coupled and varies.",
        "periods", _PERIODS, lambda _: bent_oscillators(), oscillators,
        variants=_LONG_VARIANTS, tolerances=_LONG, max_steps=100_000_000, weight=20.0,
    ),
    Case(
        "long_constrained", "Many periods, holonomic constraint",
        "A pendulum in x and y.",
        "periods", _PERIODS, lambda _: cartesian_pendulum(), pendulum,
        variants=(Variant("eigenfactor"), Variant("lagrange"), Variant("lagrange", stabilisation="none")),
        tolerances=_LONG, max_steps=100_000_000, weight=15.0,
    ),
    Case(
        "origin", "Origin",
        "A pendulum in x and y that hangs at a distance from the origin; 1: its mass passes the origin. Errors are "
        "relative to the size of the coordinates.",
        "distance [m]", (0.0, 1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6), lambda _: hung_pendulum(), origin,
        variants=CONSTRAINED, reduced=(1.0, 1e3),
    ),
    Case(
        "lengths", "Unit of length, mixed coordinates",
        "The elastic link, two angles and a length, with lengths in ever larger units. atol is scaled with the unit.",
        "unit [m]", _UNITS, lambda _: elastic_link(), lengths_of_link,
        reduced=(1e-12,),
    ),
    Case(
        "masses", "Unit of mass",
        "The same with masses in ever larger units.",
        "unit [kg]", _UNITS, lambda _: elastic_link(), masses_of_link,
    ),
    Case(
        "lengths_constrained", "Unit of length, holonomic constraints",
        "The slider-crank, two angles and a length, with lengths in ever larger units.",
        "unit [m]", _UNITS, lambda _: slider_crank.model, lengths_of_crank, variants=SEVERAL_ROWS,
    ),
    Case(
        "masses_constrained", "Unit of mass, holonomic constraints",
        "The same with masses in ever larger units.",
        "unit [kg]", _UNITS, lambda _: slider_crank.model, masses_of_crank, variants=SEVERAL_ROWS,
    ),
    Case(
        "starts", "Starts and spans",
        "A double pendulum that starts at rest or at an equilibrium, and runs over no time or backwards.",
        "", tuple(map(float, range(len(_STARTS)))), lambda _: chain_model.model(2), starts_of_pendulum,
    ),
    Case(
        "starts_constrained", "Starts and spans, holonomic constraints",
        "The slider-crank likewise.",
        "", (0.0, 1.0, 4.0, 5.0, 6.0), lambda _: slider_crank.model, starts_of_crank, variants=SEVERAL_ROWS,
    ),
    Case(
        "chain", "Chains",
        "Chains of n links, released at 45 degrees, for 1 s, over which their motion can be predicted.",
        "links n", (2.0, 4.0, 8.0, 16.0, 32.0), lambda n: chain_model.model(int(n)), links,
        flags="-O1", weight=30.0, growth=1.0,
    ),
)  # fmt: skip
