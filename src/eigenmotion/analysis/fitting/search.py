"""Search for the values of unknowns that fit best: scaled variables, and runs that fail."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import scipy

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from ...runtime import EvaluationError
from .experiment import Evaluation, Experiment
from .noise import weighted
from .unknowns import Unknowns

_SMALL = {"ftol": 1e-14, "xtol": 1e-10, "gtol": 1e-13}
"""Relative changes of squares, of scaled variables, and size of the scaled gradient at which a search ends."""


Report = Callable[[int, int], None]
"""Called with the number of runs, and the largest."""


class Runs:
    """Runs of an experiment, which are counted; the last few are kept, and a run that fails is remembered."""

    def __init__(self, experiment: Experiment, most: int, report: Report) -> None:
        self.experiment, self.most, self.report = experiment, most, report
        self.count, self.failure = 0, ""
        self._kept: dict[bytes, Evaluation | None] = {}

    def first(self) -> Evaluation:
        """Return the run at the guesses; what is wrong there is raised."""
        guesses = self.experiment.unknowns.guesses
        try:
            found = self._run(guesses)
        except EvaluationError as error:
            raise ModelError(f"the run at the guesses fails: {error}") from error
        except ModelError as error:
            raise type(error)(f"the run at the guesses fails: {error}") from error
        self._kept[guesses.tobytes()] = found
        return found

    def at(self, values: Vector) -> Evaluation | None:
        """Return the run at values (k,); None if it fails."""
        key = values.tobytes()
        if key not in self._kept:
            try:
                found = self._run(values)
            except (ModelError, EvaluationError) as error:
                found, self.failure = None, str(error)
            self._kept = dict([*self._kept.items()][-7:]) | {key: found}
        return self._kept[key]

    def _run(self, values: Vector) -> Evaluation:
        self.count += 1
        self.report(self.count, self.most)
        return self.experiment.at(values)


@dataclass(frozen=True)
class Found:
    """The end of a search. ended : whether by itself, and not by the number of runs; on_bound : numbers of unknowns"""

    best: Evaluation
    ended: bool
    on_bound: tuple[int, ...]


def search(runs: Runs, begin: Evaluation, deviations: Vector) -> Found:
    """Return the least squares near an evaluation, of samples with standard deviations (quantities,).

    Variables are in units in which each changes the predictions by their own size, so that units of users do not
    matter; values are clipped to bounds that scaling misses by rounding. Where a run fails, residuals are NaN, and the
    trust region shrinks.
    """
    unknowns = runs.experiment.unknowns
    scale, size = _scales(runs.experiment, begin, deviations)
    count = sum(map(len, begin.residuals))

    first = begin.values / scale

    def at(u: Vector) -> Evaluation | None:
        return begin if np.array_equal(u, first) else runs.at(np.clip(scale * u, unknowns.lower, unknowns.upper))

    def residual(u: Vector) -> Vector:
        found = at(u)
        return np.full(count, np.nan) if found is None else -weighted(found, deviations)[0] / size

    def slopes(u: Vector) -> Vector:
        found = at(u)
        if found is None:
            raise RuntimeError("derivatives are asked for where a run has succeeded")
        return weighted(found, deviations)[1] * scale / size

    ends = scipy.optimize.least_squares(
        residual, first, slopes, bounds=(unknowns.lower / scale, unknowns.upper / scale), method="trf",
        x_scale="jac", max_nfev=max(runs.most - runs.count + 1, 1), **_SMALL,
    )  # fmt: skip
    best = at(ends.x)
    if best is None:
        raise RuntimeError("the search ends where a run has succeeded")
    return Found(best, ends.status > 0, _on_bound(unknowns, best, deviations))


def _scales(experiment: Experiment, begin: Evaluation, deviations: Vector) -> tuple[Vector, float]:
    """Return units of unknowns (k,), and the size of the samples, all in standard deviations."""
    parts = zip(experiment.quantities, deviations, strict=True)
    size = float(np.linalg.norm(np.concatenate([q.samples[q.seen] / s for q, s in parts]))) or 1.0
    length = np.linalg.norm(weighted(begin, deviations)[1], axis=0)
    own = np.where(begin.values == 0.0, 1.0, np.abs(begin.values))
    with np.errstate(divide="ignore"):
        return np.where(length > 0.0, size / length, own), size


def _on_bound(unknowns: Unknowns, best: Evaluation, deviations: Vector) -> tuple[int, ...]:
    """Return the unknowns, by number, that bounds keep from a better fit: within a hundredth of a deviation."""
    residual, slopes = weighted(best, deviations)
    outward = slopes.T @ residual
    freedoms = max(len(residual) - len(outward), 1)
    with np.errstate(all="ignore"):
        near = 0.01 * np.linalg.norm(residual) / np.sqrt(freedoms) / np.linalg.norm(slopes, axis=0)
    low = (outward < 0.0) & (best.values - unknowns.lower <= near)
    high = (outward > 0.0) & (unknowns.upper - best.values <= near)
    return tuple(np.flatnonzero(low | high).tolist())
