"""Expected rows of the runs of a point, their error, and kappa."""

from dataclasses import dataclass, replace

import numpy as np

from ...arguments.named_values import Vector
from ...reference.integration import NotReachedError
from ...reference.rotations import in_sets_of
from ...runtime import EvaluationError
from ...system.system import System
from ..cases.case import Trial
from ..expectation.truth import CHECK, FINE, FINE_RUN, ROUGH, ROUGH_RUN
from .outcome import MARGIN

DIRECTIONS = 3  # number of random directions in which the initial data are perturbed
_DELTA, _SMALL = 1e-6, 1e-10  # size of the perturbations
_LINEAR = 1e-2  # size up to which they grow as small ones do


@dataclass(frozen=True)
class Expected:
    """The expected rows of the runs of a point, and their error.

    Attributes
    ----------
    exact : (k, 2n + p) rows of x, v, z
    scale : (2n + p,) divisor of errors
    error : scaled error of the rows themselves
    kappa : growth of a perturbation of the initial data
    """

    trial: Trial
    how: str
    exact: Vector
    scale: Vector
    error: float
    kappa: float

    def error_of(self, rows: Vector) -> float:
        """Return the largest scaled error of rows (k, 2n + p); angles that wind are compared modulo a turn."""
        difference = in_sets_of(self.exact, rows, len(self.trial.x0), self.trial.rotations) - self.exact
        if self.trial.turns is not None:
            winding = np.flatnonzero(self.trial.turns)
            turns = self.trial.turns[winding]
            difference[:, winding] -= turns * np.round(difference[:, winding] / turns)
        return float(np.max(np.abs(difference) / self.scale))


def expected_of(trial: Trial, system: System | None) -> Expected:
    """Return the expected rows of a trial; the system, if any, projects perturbed starts onto its constraints."""
    try:
        return _expected(trial, system)
    except NotReachedError as reason:
        if trial.otherwise is None:
            return _none(trial, str(reason))
        return expected_of(replace(trial, truth=trial.otherwise(str(reason)), otherwise=None), system)


def _expected(trial: Trial, system: System | None) -> Expected:
    start = trial.row
    times = np.concatenate([[trial.start], trial.times])
    with np.errstate(all="ignore"):
        exact = trial.truth.rows(start, times, FINE)
        scale = trial.sizes + np.max(np.abs(exact), axis=0)
        raw = Expected(trial, trial.truth.how, exact, scale, 0.0, 0.0)
        own = raw.error_of(trial.truth.rows(start, times, CHECK)) + trial.truth.own
        kappa = max((_growth(raw, other, times) for other in _perturbed(trial, system)), default=0.0)
        if trial.may_lose_digits and kappa * _DELTA > _LINEAR:
            kappa = _steep_growth(raw, times, system)
        if trial.may_lose_digits and not trial.nearby:
            kappa = _growth_of_errors(raw, start, times, own)
    return replace(raw, exact=exact[1:], error=own, kappa=kappa)


def _none(trial: Trial, why: str) -> Expected:
    """Return that no motion is expected, for example if M is singular: a run that succeeds is wrong."""
    shape = len(trial.times), len(trial.row)
    return Expected(trial, f"none: {why}", np.full(shape, np.nan), np.ones(shape[1]), np.nan, 0.0)


def _growth(expected: Expected, start: Vector, times: Vector, level: int = ROUGH) -> float:
    """Return the largest growth factor of a perturbation of the start."""
    before = float(np.max(np.abs(start - expected.exact[0]) / expected.scale))
    if before == 0.0:
        return 0.0
    return expected.error_of(expected.trial.truth.rows(start, times, level)) / before


def _steep_growth(expected: Expected, times: Vector, system: System | None) -> float:
    """Return the growth of a smaller perturbation, where others grow to the motion's own size, as in chaotic motions.

    Infinite if this one does, too, or if there is no time for it.
    """
    starts = _perturbed(expected.trial, system, _SMALL)[:1]
    try:
        kappa = max((_growth(expected, start, times, FINE) for start in starts), default=np.inf)
    except NotReachedError:
        return np.inf
    return kappa if kappa * _SMALL < _LINEAR else np.inf


def _growth_of_errors(expected: Expected, start: Vector, times: Vector, own: float) -> float:
    """Return kappa where no start is near: how far the check is apart, in tolerances.

    At most MARGIN times the error of a rougher run of the same equations, in its tolerances: so a fault of the check
    alone, or of the rougher run alone, is not taken for growth.
    """
    error = expected.error_of(expected.trial.truth.rows(start, times, ROUGH))
    apart = own / FINE_RUN if own < _LINEAR else np.inf
    return min(apart, MARGIN * error / ROUGH_RUN if error < _LINEAR else np.inf)


def _perturbed(trial: Trial, system: System | None, size: float = _DELTA) -> list[Vector]:
    """Return starts near that of the trial, perturbed in random directions and projected onto the constraints."""
    if not trial.nearby:
        return []
    random, start = np.random.default_rng(0), trial.row
    change = size * (trial.sizes + np.abs(start))
    starts = [start + change * random.choice((-1.0, 1.0), len(start)) for _ in range(DIRECTIONS)]
    if system is None or system.m == 0:
        return starts
    return [projected for s in starts if (projected := _projected(trial, system, s)) is not None]


def _projected(trial: Trial, system: System, start: Vector) -> Vector | None:
    n = system.n
    try:
        x, v = system.project_initial_state(
            start[:n], start[n : 2 * n], trial.start, trial.parameters, dependent_constraints="least_norm"
        )
    except EvaluationError:
        return None
    return np.concatenate([x, v, start[2 * n :]])
