"""Parameters and initial values from measured motions, by nonlinear least squares with exact derivatives."""

from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager, nullcontext
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...arguments.named_values import Vector, vector
from ...arguments.options import is_system, no_system
from ...codegen.model.normalise import ModelError, number, truth
from ...compiled.compiled_system import CompiledSystem
from ...progress import bar
from ..identification.identifiable import base_of
from ..identification.intervals import intervals_of, level_of
from .experiment import Evaluation, Experiment, parameters_at
from .measurements import quantities_of
from .motion_fit import MotionFit
from .noise import (
    Linearised,
    check_freedoms,
    first_deviations,
    floors,
    freedoms_of_estimates,
    linearised,
    weighted,
)
from .search import Found, Report, Runs, search
from .starts import start_of
from .unknowns import Given, unknowns_of

_ROUNDS = 40
"""Largest number of searches, each with the noise that the last one tells."""
_TOLD = 0.5
"""Freedoms from which residuals tell their noise."""
_SETTLED = 1e-4
"""Relative change of the noise at which it is known."""
_DEPENDENT = 30.0
"""A singular value of the derivatives that counts as zero, in rtol."""
_UNRESOLVED = 1e-2
"""Effect of an unknown as a whole, in rtol relative to the samples, that counts as none."""
_EXPLAINED, _OF_RUNS = 1e-3, 100.0
"""Part of the residual that another step would still remove at a minimum; and in rtol, relative to the samples."""


def fit(
    system: CompiledSystem,
    unknowns: Mapping[Any, float] | Iterable[Any],
    times: ArrayLike,
    measured: Mapping[Any, ArrayLike] | ArrayLike,
    *,
    x0: Any = None,
    v0: Any = None,
    t_start: float = 0.0,
    parameters: Any = None,
    inputs: Mapping[Any, Any] | None = None,
    deviations: Mapping[Any, float] | float | None = None,
    bounds: Mapping[Any, tuple[float, float]] | None = None,
    level: float = 0.95,
    rtol: float = 1e-9,
    atol: float | Mapping[Any, float] | ArrayLike = 1e-9,
    method: str = "dop853",
    max_runs: int = 200,
    progress: bool = False,
) -> MotionFit:
    """Return parameters and initial values that fit a measured motion best, by nonlinear least squares.

    Derivatives are the exact sensitivities of the runs, through constraints, impacts, contacts and friction. Errors of
    samples are independent, of one standard deviation for each measured quantity. Units of unknowns and samples do not
    matter. The result is the minimum to which the guesses lead; it need not be the only one.

    Parameters
    ----------
    unknowns
        Mapping name -> guess, or names, whose guesses are the values that a run without unknowns has. Named as in
        `sensitivities`: parameters ("k"), constant inputs, initial positions ("theta"), rates ("theta'") and states.
    times
        (nt,) of the samples, increasing.
    measured
        Mapping of coordinates ("theta"), rates ("theta'"), states and outputs -> (nt,), NaN for a missing sample; or an
        array (n, nt) of all coordinates.
    x0, v0, parameters, inputs
        As in `simulate`, for what is not unknown. With constraints, unknown initial values are kept, and those that x0
        and v0 name in a mapping; the others follow, as by `assemble`. Arrays are guesses.
    t_start
        Time of the start [s].
    deviations
        Known standard deviations of samples: a mapping quantity -> number, or one number for all. They weigh the
        samples, and errors of estimates follow from them. Others are estimated from the residuals of each quantity:
        sensors have noise of their own, and quantities may differ in their units.
    bounds
        Mapping name -> (low, high), infinite ends included.
    level
        Confidence of the intervals.
    rtol, atol, method
        As in `simulate`.
    max_runs
        Number of runs after which the fit ends without success.
    progress
        Write the number of runs to standard error.

    Returns
    -------
    MotionFit
        Also without success: see `success` and `message`. A run that fails during the search shortens the step.

    Raises
    ------
    ModelError
        Unknown names, wrong shapes; the run at the guesses fails; the motion does not tell an unknown, or tells only
        combinations of some (names them); samples are too few to tell their noise.

    Examples
    --------
    Restitution and height of a ball from its heights:

    >>> import numpy as np
    >>> import eigenmotion as em
    >>> system, times = em.build("models/bouncing_ball.py"), np.linspace(0.05, 1.5, 30)
    >>> z = system.coordinates.index("z")
    >>> measured = system.simulate((0, 1.5), parameters={"e": 0.7}, t_eval=times, rtol=1e-9).x[z]
    >>> fit = em.fit(system, {"e": 0.8}, times, {"z": measured})
    >>> round(fit.parameters["e"], 6)
    0.7
    """
    if not is_system(system):
        raise no_system("fit", system, ", unknowns, times, measured")
    confidence, most = level_of(level), int(number(max_runs, "max_runs"))
    if most < 1:
        raise ModelError(f"max_runs is {most}, but the guesses need one run")
    given = Given(system, x0, v0, parameters, inputs, number(t_start, "t_start"))
    chosen = unknowns_of(given, unknowns, bounds)
    rows = _times(system.name, times, given.t)
    quantities = quantities_of(system.compiled, measured, rows, deviations)
    guesses = dict(zip(chosen.names, chosen.guesses.tolist(), strict=True))
    prepared = system.prepare_both(*parameters_at(given, chosen, guesses))[0]
    options = {"rtol": rtol, "atol": atol, "method": method}
    experiment = Experiment(given, chosen, start_of(given, chosen, prepared), rows, quantities, options)
    with _reporting() if truth(progress, "progress") else nullcontext(_silent) as report:
        return _Fit(Runs(experiment, most, report), number(rtol, "rtol")).made(confidence)


def _times(model: str, times: ArrayLike, start: float) -> Vector:
    made = vector(times, "times")
    if made.ndim != 1 or not len(made) or not np.isfinite(made).all() or (np.diff(made) <= 0.0).any():
        raise ModelError(f"{model}: times is not a list of increasing numbers")
    if made[0] < start:
        raise ModelError(f"{model}: the first sample, at t = {made[0]:g}, is before t_start = {start:g}")
    return made


@contextmanager
def _reporting() -> Iterator[Report]:
    with bar(every=1.0) as show:
        yield lambda count, most: show(0.0, f"run {count} of at most {most}")


def _silent(_: int, __: int) -> None:
    """Report nothing."""


class _Fit:
    """A fit: searches, each with the noise that the last one tells."""

    def __init__(self, runs: Runs, rtol: float) -> None:
        self.runs, self.rtol, self.experiment = runs, rtol, runs.experiment
        self.model, self.quantities = self.experiment.given.system.name, self.experiment.quantities
        self.names = self.experiment.unknowns.names

    def made(self, level: float) -> MotionFit:
        at = self.runs.first()
        self._check_any(at)
        known = np.array([q.deviation is not None for q in self.quantities])
        deviations, least = first_deviations(self.quantities), floors(self.quantities, self.rtol)
        for _ in range(_ROUNDS):
            found = search(self.runs, at, deviations)
            at, here = found.best, self._linearised(found, deviations)
            check_freedoms(self.model, self.quantities, here.freedoms, len(self.names))
            noise = here.estimated(deviations)
            new = np.where(known, deviations, np.maximum(noise, least))
            change, deviations = np.abs(new / deviations - 1.0).max(), new
            if len(known) == 1 or change <= _SETTLED or not found.ended:
                noise = np.where(here.freedoms >= _TOLD, noise, np.nan)
                return self._result(found, deviations, noise, known, level)
        raise ModelError(
            f"{self.model}: the noise of {', '.join(q.name for q in self.quantities if q.deviation is None)} does not "
            "settle, because the samples do not tell it apart from the unknowns. Give deviations."
        )

    def _check_any(self, at: Evaluation) -> None:
        if not any(D.any() for D in at.slopes):
            raise ModelError(
                f"{self.model}: at the guesses nothing that is measured depends on {', '.join(self.names)}"
            )

    def _free(self, found: Found) -> list[int]:
        return [k for k in range(len(self.names)) if k not in found.on_bound]

    def _resolved(self, found: Found, deviations: Vector) -> Vector:
        """Return derivatives (samples, k), with zeros for unknowns whose whole effect is less than runs resolve."""
        slopes = weighted(found.best, deviations)[1]
        sizes = np.maximum(np.abs(found.best.values), np.abs(self.experiment.unknowns.guesses))
        effects = np.linalg.norm(slopes, axis=0) * sizes
        nothing = (sizes > 0.0) & (effects <= _UNRESOLVED * self.rtol * self._size(deviations))
        return np.where(nothing, 0.0, slopes)

    def _size(self, deviations: Vector) -> float:
        """Return the length of all samples in standard deviations."""
        samples = [q.samples[q.seen] / s for q, s in zip(self.quantities, deviations, strict=True)]
        return float(np.linalg.norm(np.concatenate(samples)))

    def _linearised(self, found: Found, deviations: Vector) -> Linearised:
        """Return the fit by unknowns that are not on a bound.

        Raises
        ------
        ModelError
            The motion does not tell some of them.
        """
        free = self._free(found)
        names = tuple(self.names[k] for k in free)
        slopes = self._resolved(found, deviations)[:, free]
        if not free:
            raise ModelError(f"{self.model}: all unknowns are on their bounds. Give wider ones.")
        if not slopes.any():
            raise ModelError(f"{self.model}: nothing that is measured depends on {', '.join(names)}")
        base = base_of(self.model, names, slopes, found.best.values[free], max(1e-8, _DEPENDENT * self.rtol))
        if base.rank < len(names):
            unseen = f" It tells nothing about {', '.join(base.unseen)}." if base.unseen else ""
            rest = ", ".join((*base.unseen, *base.dependent))
            raise ModelError(
                f"{self.model}: of {', '.join(names)} the measured motion tells only {', '.join(base.texts)}.{unseen} "
                f"Give {rest} as known, or measure more."
            )
        return linearised(found.best, deviations, free)

    def _result(self, found: Found, deviations: Vector, noise: Vector, known: Vector, level: float) -> MotionFit:
        best, k, c = found.best, len(self.names), self.experiment.given.system.compiled
        here = self._linearised(found, deviations)
        reason = self._failure(found, here, deviations)
        free = self._free(found)
        covariance, intervals = np.full((k, k), np.nan), np.full((k, 2), np.nan)
        if not reason:
            gain = here.gain
            covariance[np.ix_(free, free)] = gain @ gain.T
            freedoms = freedoms_of_estimates(gain, here.parts, np.where(known, np.inf, here.freedoms))
            intervals[free] = intervals_of(best.values[free], gain @ gain.T, freedoms, level)
        n, (x, v) = c.n_coordinates, best.begin
        return MotionFit(
            self.names, best.values, covariance, intervals, level, best.parameters,
            dict(zip(c.coordinates, [*x[:n].tolist(), *v[n:].tolist()], strict=True)),
            dict(zip(c.coordinates[:n], v[:n].tolist(), strict=True)),
            {q.name: float(size) for q, size in zip(self.quantities, noise, strict=True)},
            sum(map(len, best.residuals)) - len(free), self._residual(best, deviations), self.experiment.start.held,
            tuple(self.names[j] for j in found.on_bound), best.solution,
            self.runs.count, not reason, reason or f"converged in {self.runs.count} runs",
        )  # fmt: skip

    def _failure(self, found: Found, here: Linearised, deviations: Vector) -> str:
        """Return why the search did not reach a minimum, or ""."""
        failed = f" The last run that failed: {self.runs.failure}" if self.runs.failure else ""
        if not found.ended:
            return f"not converged: {self.runs.count} runs were not enough; begin nearer, or give max_runs.{failed}"
        size = self._size(deviations)
        if here.explained <= max(_EXPLAINED * float(np.linalg.norm(here.residual)), _OF_RUNS * self.rtol * size):
            return ""
        return f"not converged: it is no minimum, but no step from there, however short, fits better.{failed}"

    def _residual(self, best: Evaluation, deviations: Vector) -> dict[str, Vector]:
        made = {}
        for q, part, size in zip(self.quantities, best.residuals, deviations, strict=True):
            made[q.name] = np.full(len(q.samples), np.nan)
            made[q.name][q.seen] = part / size
        return made
