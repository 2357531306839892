"""The rows that the runs of a point are compared with, how far they can be trusted, and kappa."""

from dataclasses import dataclass, replace

import numpy as np

from ..arguments.names import Vector
from ..reference.extended import NotReachedError
from ..runtime import EvaluationError
from ..system.system import System
from .case import Point
from .truth import CHECK, FINE, ROUGH

DIRECTIONS = 3  # random ones, in which the initial data are perturbed
_DELTA = 1e-6  # size of the perturbations


@dataclass(frozen=True)
class Reference:
    """What the runs of a point are compared with, and its worth.

    Attributes
    ----------
    exact : (k, 2n) rows of x, v
    scale : (2n,) by which errors are divided
    error : of the rows themselves, so scaled
    kappa : growth of a perturbation of the initial data
    """

    point: Point
    how: str
    exact: Vector
    scale: Vector
    error: float
    kappa: float

    def error_of(self, rows: Vector) -> float:
        """Return the largest scaled error of rows (k, 2n); angles that wind are compared modulo a turn."""
        difference = rows - self.exact
        if self.point.turns is not None:
            winding = np.flatnonzero(self.point.turns)
            turns = self.point.turns[winding]
            difference[:, winding] -= turns * np.round(difference[:, winding] / turns)
        return float(np.max(np.abs(difference) / self.scale))


def reference_of(point: Point, system: System | None) -> Reference:
    """Compute all of it; the system, if there is one, puts perturbed starts back onto its constraints."""
    start = np.concatenate([point.x0, point.v0])
    times = np.concatenate([[point.start], point.times])
    with np.errstate(all="ignore"):
        try:
            exact = point.truth.rows(start, times, FINE)
        except NotReachedError as reason:
            return _none(point, str(reason))
        scale = np.tile(point.units, 2) + np.max(np.abs(exact), axis=0)
        raw = Reference(point, point.truth.how, exact, scale, 0.0, 0.0)
        own = raw.error_of(point.truth.rows(start, times, CHECK)) + point.truth.own
        kappa = max((_growth(raw, other, times) for other in _perturbed(point, system)), default=0.0)
    return replace(raw, exact=exact[1:], error=own, kappa=kappa)


def _none(point: Point, why: str) -> Reference:
    """No motion to compare with, as where M is singular: whoever finds one is wrong."""
    shape = len(point.times), 2 * len(point.x0)
    return Reference(point, f"none: {why}", np.full(shape, np.nan), np.ones(shape[1]), np.nan, 0.0)


def _growth(reference: Reference, start: Vector, times: Vector) -> float:
    """Return by how much a perturbation of the start has grown at the most."""
    before = float(np.max(np.abs(start - reference.exact[0]) / reference.scale))
    if before == 0.0:
        return 0.0
    return reference.error_of(reference.point.truth.rows(start, times, ROUGH)) / before


def _perturbed(point: Point, system: System | None) -> list[Vector]:
    """Return starts (2n,) near the point's, each moved in a random direction, back onto the constraints."""
    random, n = np.random.default_rng(0), len(point.x0)
    start, sizes = np.concatenate([point.x0, point.v0]), np.tile(point.units, 2)
    starts = [start + _DELTA * (sizes + np.abs(start)) * random.choice((-1.0, 1.0), 2 * n) for _ in range(DIRECTIONS)]
    if system is None or system.m == 0:
        return starts
    return [projected for s in starts if (projected := _projected(point, system, s)) is not None]


def _projected(point: Point, system: System, start: Vector) -> Vector | None:
    n = system.n
    try:
        x, v = system.project_initial_state(
            start[:n], start[n:], point.start, point.parameters, dependent_constraints="least_norm"
        )
    except EvaluationError:
        return None
    return np.concatenate([x, v])
