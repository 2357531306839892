"""Cases with roots, absolute values, kinks and jumps in M, in forces and in inputs.

All are two oscillators u = x + b(z) and z, in coordinates x, z in which M is coupled and varies. The motion of u and z
is known piece by piece.
"""

from collections.abc import Callable, Iterator
from math import acos, atan2, hypot, pi, sin, sqrt

import numpy as np

from ...arguments.named_values import Vector
from ...arguments.signals import Signal
from ..expectation.closed_forms import oscillation
from ..expectation.truth import ClosedForm
from ..models.smooth import kinked_oscillators, rooted_oscillators
from .case import Case, Trial, power, rows, start_of

BENT, W_1, W_2 = 0.8, 1.0, sqrt(2.0)  # parameters c, w_1, w_2 of the models
END = 5.0  # [s]

Flow = Callable[[float, float, Vector], tuple[Vector, Vector]]
"""u and its rate at elapsed times (k,), from their values at the start."""
Bend = Callable[[Vector], tuple[Vector, Vector]]
"""b and db/dz at z."""


def in_bent_axes(start: Vector, elapsed: Vector, flow: Flow, bend: Bend) -> Vector:
    """Return rows (k, 4) of x = u - b(z), z and their rates."""
    x, z, x_dot, z_dot = start
    b, slope = bend(np.asarray(z))
    u_t, u_t_dot = flow(float(x + b), float(x_dot + slope * z_dot), elapsed)
    z_t, z_t_dot = oscillation(z, z_dot, W_2, elapsed)
    b, slope = bend(z_t)
    return np.stack([u_t - b, z_t, u_t_dot - slope * z_t_dot, z_t_dot], axis=1)


def _parabola(z: Vector) -> tuple[Vector, Vector]:
    return BENT * z**2 / 2, BENT * z


def roots(width: float) -> Trial:
    """Return b = c z sqrt(z^2 + width^2) / 2: dM/dz changes its sign within the width of z = 0; it jumps for 0."""

    def bend(z: Vector) -> tuple[Vector, Vector]:
        root = np.hypot(z, width)
        return BENT * z * root / 2, BENT * (root + z * np.divide(z, root, out=np.zeros_like(root), where=root > 0)) / 2

    model = rooted_oscillators(width > 0)
    truth = ClosedForm(
        lambda start, t: in_bent_axes(start, t, lambda u, v, t: oscillation(u, v, W_1, t), bend), "linear oscillators"
    )
    parameters = {"w": width} if width > 0 else {}
    return Trial(power(width), parameters, *start_of(model), np.ones(2), 0.0, rows(0.0, END), truth)


def contact(k: float) -> Trial:
    """Return a spring of stiffness k that acts only for u > 0: its force has a kink."""
    return _switching(power(k), {"k": k})


def sides(f: float) -> Trial:
    """Return a force of size f towards u = 0, where it jumps."""
    return _switching(power(f), {"f": f})


def _switching(label: str, parameters: dict[str, float]) -> Trial:
    k, f = parameters.get("k", 0.0), parameters.get("f", 0.0)
    truth = ClosedForm(
        lambda start, t: in_bent_axes(start, t, lambda u, v, t: _between_sides(u, v, t, k, f), _parabola),
        "pieces of harmonic motion",
    )
    return Trial(label, parameters, *start_of(kinked_oscillators()), np.ones(2), 0.0, rows(0.0, END), truth)


def _between_sides(u: float, v: float, t: Vector, k: float, f: float) -> tuple[Vector, Vector]:
    """Return u'' = -(w_1^2 + k [u > 0]) u - f sign(u), from one zero of u to the next."""
    values, rates, begin = np.empty_like(t), np.empty_like(t), 0.0
    side = 1.0 if u > 0 or (u == 0 and v > 0) else -1.0
    while begin <= t[-1]:
        w = sqrt(W_1**2 + (k if side > 0 else 0.0))
        centre = -side * f / w**2
        radius, phase = hypot(u - centre, v / w), atan2(v / w, u - centre)
        leaving = side * acos(max(-1.0, min(1.0, -centre / radius)))
        length = ((phase + leaving) % (2 * pi)) / w
        here = (t >= begin) & (t < begin + length)
        offset, rates[here] = oscillation(u - centre, v, w, t[here] - begin)
        values[here] = centre + offset
        begin, u, v, side = begin + length, 0.0, -radius * w * sin(leaving), -side
    return values, rates


def held(period: float) -> Trial:
    """Return an acceleration of u that jumps at every sample."""
    return _sampled(period, "hold")


def ramped(period: float) -> Trial:
    """Return an acceleration of u with a kink at every sample."""
    return _sampled(period, "linear")


def _sampled(period: float, kind: str) -> Trial:
    times = period * np.arange(int(np.ceil(END / period)) + 1)
    values = np.random.default_rng(0).uniform(-2.0, 2.0, len(times))
    signal = Signal(times, values, "hold" if kind == "hold" else "linear")
    truth = ClosedForm(
        lambda start, t: in_bent_axes(start, t, lambda u, v, t: _driven(u, v, t, signal), _parabola),
        "pieces of harmonic motion about a uniformly moving centre",
    )
    model = kinked_oscillators()
    return Trial(
        power(period), {}, *start_of(model), np.ones(2), 0.0, rows(0.0, END), truth, conserves=False,
        inputs={"a": signal},
    )  # fmt: skip


def _driven(u: float, v: float, t: Vector, signal: Signal) -> tuple[Vector, Vector]:
    """Return u'' = -w_1^2 u + a(t), from one sample to the next."""
    values, rates = np.empty_like(t), np.empty_like(t)
    for begin, end, a, slope in _pieces(signal):
        here = (t >= begin) & (t <= end)
        both = np.append(t[here], end) - begin
        offset, rate = oscillation(u - a / W_1**2, v - slope / W_1**2, W_1, both)
        position, rate = offset + (a + slope * both) / W_1**2, rate + slope / W_1**2
        values[here], rates[here] = position[:-1], rate[:-1]
        u, v = float(position[-1]), float(rate[-1])
    return values, rates


def _pieces(signal: Signal) -> Iterator[tuple[float, float, float, float]]:
    """Yield start, end, value at the start and slope."""
    times, values = np.asarray(signal.times), np.asarray(signal.values)
    slopes = np.diff(values) / np.diff(times) * (signal.kind == "linear")
    yield from zip(times[:-1].tolist(), times[1:].tolist(), values[:-1].tolist(), slopes.tolist(), strict=True)


_PERIODS = (1.0, 0.3, 1e-1, 3e-2, 1e-2)

CASES = (
    Case(
        "roots", "Roots and absolute values in M",
        "Two oscillators in coordinates that are bent by z sqrt(z^2 + w^2): derivatives of M change their sign within "
        "a width w of z = 0; with w = 0 they jump there (z |z|).",
        "width w [m]", (1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 0.0),
        lambda width: rooted_oscillators(width > 0), roots, reduced=(1e-3, 0.0),
    ),
    Case(
        "contact", "Forces with kinks",
        "Two oscillators in bent coordinates; a spring acts only on one side of u = 0.",
        "stiffness k [1/s^2]", (1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6), lambda _: kinked_oscillators(), contact,
        reduced=(1e2,),
    ),
    Case(
        "sides", "Forces that jump",
        "The same with a force of constant size towards u = 0.",
        "force f [m/s^2]", (1e-3, 1e-2, 1e-1, 1.0, 1e1, 1e2), lambda _: kinked_oscillators(), sides,
        reduced=(1.0,),
    ),
    Case(
        "held", "Inputs that jump",
        "The same under an acceleration that is held between random samples.",
        "sampling period [s]", _PERIODS, lambda _: kinked_oscillators(), held, reduced=(0.3,),
    ),
    Case(
        "ramped", "Inputs with kinks",
        "The same under an acceleration that is interpolated linearly between random samples.",
        "sampling period [s]", _PERIODS, lambda _: kinked_oscillators(), ramped,
    ),
)  # fmt: skip
