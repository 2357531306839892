"""Measurement of the error, cost and run time of every solver at every tolerance."""

import gc
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from scipy.integrate import trapezoid

from ..arguments.named_values import Vector
from ..progress import Progress
from ..reference.motion import Reference, scaled_error
from ..reference.rotations import in_sets_of
from ..system.system import System
from .solvers import Attempt, Solver, Track

_TURN = 2e-3  # [s] duration of a turn: shorter runs are called several times, each timed separately for the median
SLOW = 0.1  # [s] slower runs are timed three times, the first run included
SLOW_TURNS = 2


@dataclass(frozen=True, slots=True)
class Measurement:
    """One solver at one tolerance. None: the number does not exist, or the run did not reach the end (`message`).

    error_end, error_max : max over coordinates and states of |x - x_ref| / (1 + |x_ref|), at the end and over all rows
    velocity_error_end, velocity_error_max : the same for the velocities
    seconds : median of `repeats` complete calls, each timed separately; seconds_low, seconds_high : quartiles
    constraint_violation, position_violation : largest |A v + b| and |phi| over all rows
    energy_integral : integral of |P(t) - P(t0)| dt over the rows (62) [J s], P = T2 - T0 + V
    factor_residual : largest max|M - C^T S^2 C| / max|M|
    """

    family: str
    formulation: str
    method: str
    label: str
    tolerance: float
    error_end: float | None = None
    error_max: float | None = None
    velocity_error_end: float | None = None
    velocity_error_max: float | None = None
    seconds: float | None = None
    seconds_low: float | None = None
    seconds_high: float | None = None
    repeats: int = 0
    nfev: int | None = None
    nsteps: int | None = None
    nrejected: int | None = None
    constraint_violation: float | None = None
    position_violation: float | None = None
    energy_integral: float | None = None
    factor_residual: float | None = None
    message: str = ""

    @property
    def curve(self) -> tuple[str, str, str]:
        """The key of the solver."""
        return self.family, self.formulation, self.method

    @property
    def ns_per_rhs(self) -> float | None:
        """Nanoseconds of the complete call per evaluation of the right-hand side."""
        return None if self.seconds is None or not self.nfev else 1e9 * self.seconds / self.nfev


@dataclass(frozen=True, slots=True)
class Judge:
    """Comparison of runs with the reference; the system computes residuals and energy from the rows of any solver.

    acts : whether rows change and energy is lost at events: neither is then computed
    """

    reference: Reference
    system: System
    parameters: Mapping[str, float] = field(default_factory=dict)
    acts: bool = False

    def __call__(self, blank: Measurement, track: Track) -> Measurement:
        """Return the measurement with all numbers but the time."""
        counted = replace(
            blank, nfev=track.nfev, nsteps=track.nsteps, nrejected=track.nrejected,
            factor_residual=track.factor_residual, message=track.message,
        )  # fmt: skip
        if track.message or len(track.x) < len(self.reference.t):
            return replace(counted, message=track.message or "did not reach the end")
        x, v = (np.ascontiguousarray(rows, dtype=np.float64) for rows in (track.x, track.v))
        if not (np.isfinite(x).all() and np.isfinite(v).all()):
            return replace(counted, message="the rows are not finite")
        return self._compared(counted, x, v)

    def _compared(self, counted: Measurement, x: Vector, v: Vector) -> Measurement:
        x, v = self._in_sets(x, v)
        errors, rates = scaled_error(x, self.reference.x), scaled_error(v, self.reference.v)
        compared = replace(
            counted,
            error_end=float(errors[-1]), error_max=float(errors.max()),
            velocity_error_end=float(rates[-1]), velocity_error_max=float(rates.max()),
        )  # fmt: skip
        return compared if self.acts else self._checked(compared, x, v)

    def _in_sets(self, x: Vector, v: Vector) -> tuple[Vector, Vector]:
        """Return x (k, n + p), v (k, n) with rotations in the parameters of the reference."""
        n, known, compiled = self.system.n, self.reference, self.system.compiled
        exact, own = (np.concatenate([q[:, :n], w], axis=1) for q, w in ((known.x, known.v), (x, v)))
        rows = in_sets_of(exact, own, n, compiled.rotations)
        return np.concatenate([rows[:, :n], x[:, n:]], axis=1), rows[:, n:]

    def _checked(self, compared: Measurement, x: Vector, v: Vector) -> Measurement:
        """Return the measurement with residuals of constraints and the energy."""
        t, compiled, prepared = self.reference.t, self.system.compiled, self.system.prepare(self.parameters)
        q, w = self._whole(x, v)
        return replace(
            compared,
            constraint_violation=_largest(compiled.constraint_rows(t, q, w, prepared)),
            position_violation=_largest(compiled.position_rows(t, q, prepared)),
            energy_integral=self._energy_integral(q, w),
        )  # fmt: skip

    def _whole(self, x: Vector, v: Vector) -> tuple[Vector, Vector]:
        """Return x, v of compiled functions, where a state is the velocity of a coordinate on which nothing depends."""
        n, states = self.system.n, x[:, self.system.n :]
        return np.concatenate([x[:, :n], np.zeros_like(states)], axis=1), np.concatenate([v, states], axis=1)

    def _energy_integral(self, x: Vector, v: Vector) -> float | None:
        if not self.system.conserves_energy:
            return None
        t = self.reference.t
        prepared = self.system.prepare(self.parameters)
        P = self.system.compiled.energy_rows(t, x, v, prepared) @ (1.0, 0.0, -1.0, 1.0)
        return float(trapezoid(np.abs(P - P[0]), t))


@dataclass(frozen=True, slots=True)
class Budget:
    """Limits of the measurement.

    grain : [s] after a run that took k times this, a solver skips k tolerances; after a run that took longer and did
        not reach the end, all tighter tolerances
    rounds : number of turns of each run; fewer for slow runs
    """

    grain: float = 0.1
    rounds: int = 9


@dataclass(slots=True)
class _Pending:
    """An unfinished measurement."""

    measurement: Measurement
    attempt: Attempt
    first: float
    samples: list[float]


def measure(solvers: Sequence[Solver], judge: Judge, budget: Budget, progress: Progress) -> tuple[Measurement, ...]:
    """Measure the errors first, for each solver from loose to tight; then the times, in rounds over all runs."""
    pending: list[_Pending] = []
    for k, solver in enumerate(solvers):
        progress(0.6 * k / len(solvers), f"error of {solver.label}")
        pending += _errors(solver, judge, budget)
    for turn in range(budget.rounds):
        progress(0.6 + 0.4 * turn / budget.rounds, f"time, round {turn + 1} of {budget.rounds}")
        _time(pending, turn)
    return tuple(_timed(one) for one in pending)


def skipped(solvers: Sequence[Solver], measured: Sequence[Measurement], budget: Budget) -> tuple[tuple[str, str], ...]:
    """Return the solvers with skipped tolerances, and why these were skipped."""
    skips = []
    for solver in solvers:
        own = [m for m in measured if m.curve == (solver.family, solver.formulation, solver.method)]
        untried = set(solver.tolerances) - {m.tolerance for m in own}
        if untried:
            why = " and ".join(_reasons(own[-1], untried, budget))
            words = f"{len(untried)} of {len(solver.tolerances)} tolerances left out, as {why}"
            skips.append((solver.label, words))
    return tuple(skips)


def _reasons(last: Measurement, untried: set[float], budget: Budget) -> list[str]:
    """Return the reasons: before the last run tolerances are skipped for slowness, after it because it ended early."""
    reached = last.error_end is not None
    reasons = [f"runs took more than {budget.grain:g} s"] if reached or max(untried) > last.tolerance else []
    if not reached and min(untried) < last.tolerance:
        reasons.append(f"the run at {last.tolerance:.0e} ended early: {last.message}")
    return reasons


def _errors(solver: Solver, judge: Judge, budget: Budget) -> list[_Pending]:
    pending: list[_Pending] = []
    k = 0
    while k < len(solver.tolerances):
        blank = Measurement(solver.family, solver.formulation, solver.method, solver.label, solver.tolerances[k])
        one = _first(blank, solver, judge)
        pending.append(one)
        if one.measurement.error_end is None and one.first > budget.grain:
            break
        k += 1 + int(one.first / budget.grain)
    return pending


def _first(blank: Measurement, solver: Solver, judge: Judge) -> _Pending:
    """Run once for the time and once for the rows. An exception of a solver is its result."""
    start = time.perf_counter()
    try:
        attempt = solver.attempt(blank.tolerance)
        start = time.perf_counter()
        done = attempt.run()
        first = time.perf_counter() - start
        return _Pending(judge(blank, attempt.track(judge.reference.t, done)), attempt, first, [])
    except Exception as error:
        message = f"{type(error).__name__}: {error}".splitlines()[0]
        return _Pending(
            replace(blank, message=message), Attempt(lambda: None, _nothing), time.perf_counter() - start, []
        )


def _nothing(times: Vector, done: object) -> Track:
    raise NotImplementedError


def _time(pending: list[_Pending], turn: int) -> None:
    """Time one turn of each complete run, with the garbage collector off."""
    gc.collect()
    gc.disable()
    try:
        for one in pending:
            if one.measurement.error_end is not None and (turn < SLOW_TURNS or one.first < SLOW):
                _add_samples(one)
    finally:
        gc.enable()


def _add_samples(one: _Pending) -> None:
    """Add the times of one turn. A run that raises now, as when it passes its limit of time, has no time."""
    try:
        one.samples += _samples(one.attempt.run, one.first)
    except Exception as error:
        message = f"{type(error).__name__} as it was timed: {error}".splitlines()[0]
        one.measurement, one.samples = replace(one.measurement, error_end=None, error_max=None, message=message), []


def _samples(run: Callable[[], object], expected: float) -> list[float]:
    """Return the seconds of each of a few consecutive calls; for short runs after a call that warms the caches."""
    count = max(1, min(10, round(_TURN / expected)))
    if count > 1:
        run()
    samples = []
    for _ in range(count):
        start = time.perf_counter()
        run()
        samples.append(time.perf_counter() - start)
    return samples


def _timed(one: _Pending) -> Measurement:
    if not one.samples:
        return one.measurement
    samples = one.samples if one.first < SLOW else [one.first, *one.samples]
    low, median, high = np.quantile(samples, [0.25, 0.5, 0.75]).tolist()
    return replace(one.measurement, seconds=median, seconds_low=low, seconds_high=high, repeats=len(samples))


def _largest(rows: Vector) -> float | None:
    return float(np.abs(rows).max()) if rows.size else None
