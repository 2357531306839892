"""Error indicators of a run, each relative to the terms that cancel in it."""

from dataclasses import dataclass

import numpy as np

from ...arguments.named_values import Vector
from ...results.solution import Solution
from ...system.system import System
from ..cases.case import Trial

_TINY = 1e-300


@dataclass(frozen=True, slots=True)
class Indicators:
    """Error indicators of one run. None: the model does not have the quantity.

    energy : largest |P(t) - P(t0)| relative to the exchanged energy, P = T2 - T0 + V, if P is conserved
    constraint, position : largest |A v + b| and |phi| relative to the terms that cancel in them
    factor : largest max|M - C^T S^2 C| / max|M|
    energy_slope, position_slope : least-squares slopes of energy and position, per period if there are many, else per
    span
    """

    energy: float | None = None
    constraint: float | None = None
    position: float | None = None
    factor: float | None = None
    energy_slope: float | None = None
    position_slope: float | None = None

    @property
    def largest(self) -> float:
        """The largest indicator."""
        shown = (self.energy, self.constraint, self.position, self.factor)
        return max((i for i in shown if i is not None), default=0.0)


NOTHING_SHOWN = Indicators()


def indicators(trial: Trial, system: System, solution: Solution) -> Indicators:
    """Return the indicators of the rows of a run."""
    t, x, v = (np.ascontiguousarray(rows) for rows in (solution.t, solution.x.T, solution.v.T))
    periods = (t - trial.start) * (trial.periods or 1.0) / (abs(float(trial.times[-1]) - trial.start) or 1.0)
    drift = _energy_drift(trial, system, t, x, v) if trial.conserves else None
    size = max(float(np.abs(x).max(axis=0).sum()), float(_least(trial).sum()), _TINY)
    phi = np.abs(solution.position_residual).max(axis=0) / size if system.h else None
    return Indicators(
        energy=_largest(drift),
        constraint=_largest(_constraint(trial, system, t, x, v)) if system.m else None,
        position=_largest(phi),
        factor=_largest(solution.factor_residual),
        energy_slope=_slope(periods, drift),
        position_slope=_slope(periods, phi),
    )


def _energy_drift(trial: Trial, system: System, t: Vector, x: Vector, v: Vector) -> Vector:
    """Return P(t) - P(t0) divided by the sum of the largest kinetic energy and the range of the others.

    States have no energy, and if P is constant nothing in it depends on them: compiled functions get zeros for them.
    """
    t, x, v = (np.concatenate([[first], rows]) for first, rows in ((trial.start, t), (trial.x0, x), (trial.v0, v)))
    x, v = (np.pad(rows, ((0, 0), (0, len(trial.z0)))) for rows in (x, v))
    energies = system.compiled.energy_rows(t, x, v, system.prepare(trial.parameters))
    T2, others = energies[:, 0], energies @ (0.0, 0.0, -1.0, 1.0)
    P = T2 + others
    return np.asarray((P[1:] - P[0]) / max(float(T2.max() + np.ptp(others)), _TINY))


def _constraint(trial: Trial, system: System, t: Vector, x: Vector, v: Vector) -> Vector:
    return np.array([_row_residual(trial, system, *row) for row in zip(t.tolist(), x, v, strict=True)])


def _row_residual(trial: Trial, system: System, t: float, x: Vector, v: Vector) -> float:
    A, b = system.pfaffian(x, t, trial.parameters)
    terms = np.abs(A) @ np.maximum(np.abs(v), _least(trial)) + np.abs(b)
    return float(np.max(np.abs(A @ v + b) / np.maximum(terms, _TINY)))


def _least(trial: Trial) -> Vector:
    """Return the least sizes (n,) of terms: units for a user's model, in which rounding may be all that moves."""
    n = len(trial.x0)
    return trial.units[:n] if trial.may_lose_digits else np.zeros(n)


def _largest(values: Vector | None) -> float | None:
    return None if values is None else float(np.max(np.abs(values)))


def _slope(periods: Vector, values: Vector | None) -> float | None:
    return None if values is None or len(values) < 3 else float(np.polyfit(periods, values, 1)[0])
