"""Cases with singular positions of the constraints."""

from math import asin, cos, sin

import numpy as np

from ...arguments.named_values import Vector
from ...models import slider_crank
from ..expectation.truth import FINE, ClosedForm, Integrated, Truth, lagrange
from ..models.smooth import blade_and_slave, folding_crank
from .case import Case, Trial, integrated, power, rows, scale_of, start_of
from .variants import DEPENDENT_ROWS, SEVERAL_ROWS

_CRANK = 0.3  # [m]
RANK = 1e-12  # rows that differ by less than this part of their length count as one row with "least_norm"


def alike(part: float) -> Trial:
    """Return two rows that differ by `part`, the reciprocal of the condition number of A."""
    model = blade_and_slave()
    x0, v0 = start_of(model)
    rhs = lagrange(model, {"part": 1.0}) if part > RANK else lagrange(blade_and_slave(1), {})
    return integrated(power(part), rhs, {"part": part}, x0, v0, np.ones(4), rows(0.0, 3.0))


def folding(excess: float) -> Trial:
    """Return a slider-crank whose rod is longer than its crank by a part; a shorter rod could not pass 90 degrees."""
    parameters = {"r": _CRANK, "l": _CRANK * (1 + excess)}
    start = closed_loop(1.0, 6.0, **parameters)
    units = np.ones(3)
    truth: Truth = Integrated(lagrange(slider_crank.model, parameters), scale_of(units, start[:3], start[3:]))
    if excess == 0:
        truth = ClosedForm(_folded, "the motion with phi = theta in extended precision: the smooth one")
    return Trial(power(excess), parameters, start[:3], start[3:], units, 0.0, rows(0.0, 0.8), truth)


def _folded(start: Vector, elapsed: Vector) -> Vector:
    """Return the motion of one coordinate in three: theta, phi = theta, x = 2 r cos theta."""
    one = Integrated(lagrange(folding_crank(), {"r": _CRANK}), np.ones(2))
    theta, rate = one.rows(start[[0, 3]], elapsed, FINE).T
    x, v = 2 * _CRANK * np.cos(theta), -2 * _CRANK * rate * np.sin(theta)
    return np.stack([theta, theta, x, rate, rate, v], axis=1)


def closed_loop(theta: float, rate: float, r: float, l: float) -> Vector:
    """Return theta, phi, x and their rates of a slider-crank."""
    phi = asin(r * sin(theta) / l)
    phi_rate = rate * r * cos(theta) / (l * cos(phi))
    x_rate = -r * rate * sin(theta) - l * phi_rate * sin(phi)
    return np.array([theta, phi, r * cos(theta) + l * cos(phi), rate, phi_rate, x_rate])


CASES = (
    Case(
        "rows", "Constraint rows, from independent to dependent",
        "A sleigh with a blade, and a slide that follows its direction. The rows of A differ by a part, whose "
        "reciprocal is the condition number of A. 0: dependent and consistent. Up to 1e-12 the rows count as one with "
        "least norm, and the motion with one row is right.",
        "part in which the rows differ", (*(10.0**-e for e in range(17)), 0.0), lambda _: blade_and_slave(), alike,
        reduced=(1.0, 1e-9, 0.0), variants=DEPENDENT_ROWS, weight=2.0,
    ),
    Case(
        "dead_centre", "Slider-crank through dead centres",
        "A crank turns through both dead centres of the slider and past 90 degrees. If the rod is as short as the "
        "crank, it folds back onto the crank there, and the rows of the loop become dependent.",
        "rod / crank - 1", (2.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 0.0),
        lambda _: slider_crank.model, folding, variants=SEVERAL_ROWS, weight=2.0,
        reduced=(0.0,),
    ),
)  # fmt: skip
