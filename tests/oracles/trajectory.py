"""Motion to many digits: extrapolated midpoint steps (Gragg, Bulirsch and Stoer) on Lagrange's equations.

Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, II.9. With nine columns the order is 18; in
extended precision a run is good to about 1e-17 times the growth of its perturbations.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from eigenmotion import Model

from .arithmetic import array
from .lagrange import Lagrange
from .state import State, initial_state

COLUMNS = 9
SUBSTEPS = [2 * (k + 1) for k in range(COLUMNS)]
SMALLEST = 1e-9


def trajectory(
    model: Model,
    t_end: float,
    *,
    start: State | None = None,
    parameters: Mapping[str, float] | None = None,
    precision: str = "extended",
    tolerance: float = 3e-17,
) -> State:
    """Return the state at t_end, in numbers of the precision asked for, from the model's own start at t = 0."""
    lagrange, n = Lagrange(model, precision), len(model.coordinates)
    start = start or initial_state(model)

    def rhs(time: Any, y: np.ndarray) -> np.ndarray:
        acceleration, _ = lagrange(y[:n], y[n:], time, parameters)
        return np.concatenate([y[n:], acceleration])

    y = integrate(rhs, array([*start.x, *start.v], precision), t_end, tolerance, precision)
    return State(y[:n], y[n:])


def integrate(
    rhs: Callable[[Any, np.ndarray], np.ndarray], y: np.ndarray, t_end: float, tolerance: float, precision: str
) -> np.ndarray:
    """Return y(t_end) of y' = rhs(t, y) from t = 0; each step errs by at most tolerance * max(1, |y|)."""
    (time, end, h) = array([0, t_end, t_end / 64], precision)
    order = 2 * COLUMNS - 1
    while time < end:
        h = min(h, end - time)
        candidate, error = _step(rhs, time, y, h)
        ratio = float(error) / tolerance
        if ratio <= 1:
            time, y = time + h, candidate
        h = h * array([min(2.0, max(0.2, 0.8 * max(ratio, 1e-30) ** (-1 / order)))], precision)[0]
        if abs(h) < SMALLEST:
            raise RuntimeError(f"step of {float(h)} at t = {float(time)}: the tolerance is below rounding")
    return y


def _step(rhs: Callable[[Any, np.ndarray], np.ndarray], time: Any, y: np.ndarray, h: Any) -> tuple[np.ndarray, Any]:
    """One step, and the difference of its last two columns, relative to max(1, |y|)."""
    slope = rhs(time, y)
    row: list[np.ndarray] = []
    for j, count in enumerate(SUBSTEPS):
        above, row = row, [_midpoint(rhs, time, y, slope, h, count)]
        for k in range(j):
            factor = (SUBSTEPS[j] ** 2) / (h * 0 + SUBSTEPS[j - k - 1] ** 2) - 1
            row.append(row[k] + (row[k] - above[k]) / factor)
    difference = [abs(d) / max(1, abs(s)) for d, s in zip(row[-1] - row[-2], y, strict=True)]
    return row[-1], max(difference)


def _midpoint(
    rhs: Callable[[Any, np.ndarray], np.ndarray], time: Any, y: np.ndarray, slope: np.ndarray, h: Any, count: int
) -> np.ndarray:
    """`count` midpoint steps over h."""
    step = h / count
    before, here = y, y + step * slope
    for k in range(1, count):
        before, here = here, before + 2 * step * rhs(time + k * step, here)
    return here
