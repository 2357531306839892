"""One point of a case: its reference, the growth of perturbations, and every run."""

import time
import warnings
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import numpy as np

from ..build import build
from ..codegen.model import ModelError
from ..names import Vector
from ..report.extended import NotReachedError
from ..runtime import EvaluationError, StopReason
from ..simulate import simulate
from ..solution import Solution
from ..system import System
from ..toolchain import BuildError, CompilerNotFoundError
from .case import EXPLICIT, Case, Point
from .outcome import IMPLICIT, MARGIN, Cell, Outcome, Variant, judged
from .truth import CHECK, FINE, ROUGH

_DELTA = 1e-6  # size of the perturbations that kappa is measured with
DIRECTIONS = 3


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
            turns, n = self.point.turns, len(self.point.turns)
            part = difference[:, :n]
            difference[:, :n] = part - np.where(turns > 0, turns * np.round(part / np.where(turns > 0, turns, 1.0)), 0.0)
        return float(np.max(np.abs(difference) / self.scale))


@dataclass(frozen=True)
class Examined:
    """A point and its cells."""

    case: str
    point: str
    how: str
    reference_error: float
    kappa: float
    cells: tuple[Cell, ...]


def examine(case: Case, value: float, systems: dict[Variant, System] | None = None) -> Examined:
    """Run every variant and method of a case at one value.

    Parameters
    ----------
    systems
        Programs to use in place of those of the case's model: a test plants faults in them.
    """
    built = {variant: program(case, value, variant) for variant in case.variants}
    built |= systems or {}
    reference = reference_of(case.point(value), next((s for s in built.values() if isinstance(s, System)), None))
    chosen = [(variant, method) for method in case.tolerances for variant in case.variants
              if method in EXPLICIT or variant in IMPLICIT]  # fmt: skip
    cells = tuple(_cell(case, reference, built[variant], variant, method) for variant, method in chosen)
    return Examined(case.name, reference.point.label, reference.how, reference.error, reference.kappa, cells)


def program(case: Case, value: float, variant: Variant) -> System | str:
    """Return a program, or why there is none."""
    try:
        return _built(case.model(value), variant.build["formulation"], variant.close_eigenvalues, variant.schur, case.flags)
    except CompilerNotFoundError:
        raise
    except (ModelError, BuildError) as error:
        return str(error)


@cache
def _built(model: Any, formulation: str, close_eigenvalues: str, schur: str, flags: str | None) -> System:
    return build(model, formulation=formulation, close_eigenvalues=close_eigenvalues, schur=schur, flags=flags)


def reference_of(point: Point, system: System | None) -> Reference:
    """Compute the rows to compare with, their own error, and kappa."""
    start = np.concatenate([point.x0, point.v0])
    times = np.concatenate([[point.start], point.times])
    with np.errstate(all="ignore"):
        try:
            exact = point.truth.rows(start, times, FINE)
        except NotReachedError as error:
            return _none(point, str(error))
        units = np.tile(point.units, 2)
        raw = Reference(point, point.truth.how, exact, units + np.max(np.abs(exact), axis=0), 0.0, 0.0)
        error = raw.error_of(point.truth.rows(start, times, CHECK)) + point.truth.own
        kappa = max((_growth(raw, other, times) for other in _perturbed(point, system)), default=0.0)
    return replace(raw, exact=exact[1:], error=error, kappa=kappa)


def _none(point: Point, why: str) -> Reference:
    """No motion to compare with, as where M is singular: whoever finds one is wrong."""
    shape = len(point.times), 2 * len(point.x0)
    return Reference(point, f"none: {why}", np.full(shape, np.nan), np.ones(shape[1]), np.nan, 0.0)


def _growth(reference: Reference, start: Vector, times: Vector) -> float:
    """Return by how much a perturbation of the start has grown at the most."""
    moved = reference.point.truth.rows(start, times, ROUGH)
    before = reference.error_of(np.tile(start, (len(times), 1)) * 0 + start - moved[0] + reference.exact)
    first = float(np.max(np.abs(start - reference.exact[0]) / reference.scale))
    return reference.error_of(moved) / first if first > 0 and np.isfinite(before) else 0.0


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


def _cell(case: Case, reference: Reference, system: System | str, variant: Variant, method: str) -> Cell:
    tolerance = case.tolerances[method]
    blank = Cell(case.name, reference.point.label, variant.label, method, tolerance)
    if isinstance(system, str):
        return replace(blank, reason="not offered", message=system)
    begin = time.perf_counter()
    try:
        solution = _run(case, reference.point, system, variant, method)
    except (ModelError, EvaluationError) as error:
        return replace(blank, reason="start refused", message=str(error), seconds=time.perf_counter() - begin)
    except Exception as error:  # whatever else: it has no name
        return replace(blank, outcome=Outcome.WRONG, reason="unnamed", message=f"{type(error).__name__}: {error}")
    done = replace(blank, nsteps=int(solution.nsteps), nfev=int(solution.nfev), seconds=time.perf_counter() - begin)
    if not solution.success:
        return replace(done, reason=str(solution.stop), message=solution.message)
    return _compared(done, reference, system, solution)


def _run(case: Case, point: Point, system: System, variant: Variant, method: str) -> Solution:
    tolerance = case.tolerances[method]
    steps = case.max_steps if method in EXPLICIT else case.max_steps_stiff
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        return simulate(
            system, (point.start, float(point.times[-1])), x0=point.x0, v0=point.v0, parameters=point.parameters,
            method=method, rtol=tolerance, atol=tolerance * point.units, t_eval=point.times, max_steps=steps,
            **variant.run,
        )  # fmt: skip


def _compared(done: Cell, reference: Reference, system: System, solution: Solution) -> Cell:
    bound = MARGIN * done.tolerance * (1 + reference.kappa)
    if solution.stop is not StopReason.FINISHED or len(solution.t) != len(reference.point.times):
        message = f"{len(solution.t)} of {len(reference.point.times)} rows"
        return replace(done, outcome=Outcome.WRONG, reason="rows missing", message=message, bound=bound)
    rows = np.concatenate([solution.x, solution.v]).T
    error = reference.error_of(rows)
    shown = replace(done, error=error, bound=bound, **_indicators(reference.point, system, solution))
    outcome = judged(error, bound, shown.indicator, done.tolerance)
    return replace(shown, outcome=outcome, reason="" if np.isfinite(error) else "not finite")


def _indicators(point: Point, system: System, solution: Solution) -> dict[str, float | None]:
    """What the run itself shows, each relative to the terms that cancel in it."""
    c, prepared = system.compiled, system.prepare(point.parameters)
    t, x, v = (np.ascontiguousarray(rows) for rows in (solution.t, solution.x.T, solution.v.T))
    found: dict[str, float | None] = {"factor": _largest(solution.factor_residual)}
    periods = (t - point.start) / point.period
    if point.conserves and len(t) > 1:
        drift = _energy_drift(c.energy_rows(t, x, v, prepared), system, point)
        found |= {"energy": _largest(drift), "energy_slope": _slope(periods, drift)}
    if system.m:
        found["constraint"] = _largest(_relative(system, point, t, x, v))
    if system.h:
        size = np.abs(x).max(axis=0) @ np.ones(system.n)
        phi = np.abs(solution.position_residual).max(axis=0) / size
        found |= {"position": _largest(phi), "position_slope": _slope(periods, phi)}
    return found


def _energy_drift(energies: Vector, system: System, point: Point) -> Vector:
    """Return P(t) - P(t0) over the sum of the largest kinetic energy and the range of the others."""
    first = system.compiled.energy_rows(
        np.array([point.start]), point.x0[None].copy(), point.v0[None].copy(), system.prepare(point.parameters)
    )
    P = np.concatenate([first, energies]) @ (1.0, 0.0, -1.0, 1.0)
    T2, others = energies[:, 0], (energies @ (0.0, 0.0, -1.0, 1.0))
    exchanged = float(T2.max() + np.ptp(np.append(others, first @ (0.0, 0.0, -1.0, 1.0))))
    return np.asarray((P[1:] - P[0]) / max(exchanged, 1e-300))


def _relative(system: System, point: Point, t: Vector, x: Vector, v: Vector) -> Vector:
    rows = []
    for time_, x_, v_ in zip(t, x, v, strict=True):
        A, b = system.pfaffian(x_, float(time_), point.parameters)
        terms = np.abs(A) @ np.abs(v_) + np.abs(b)
        rows.append(np.max(np.abs(A @ v_ + b) / np.maximum(terms, 1e-300)))
    return np.array(rows)


def _largest(values: Vector) -> float:
    return float(np.max(np.abs(values)))


def _slope(periods: Vector, values: Vector) -> float:
    return float(np.polyfit(periods, values, 1)[0]) if len(periods) > 2 else 0.0
