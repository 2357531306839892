"""Examination of one point of a case: all its runs and their outcomes."""

import time
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache, partial
from typing import Any

import numpy as np

from ...building.build import build
from ...building.errors import BuildError
from ...codegen.model import Model, ModelError
from ...comparison.deadline import TooLateError
from ...reference.motion import rows_of
from ...results.solution import Solution
from ...runtime import EvaluationError, StopReason
from ...simulation.simulate import simulate
from ...system.system import System
from ..cases.case import Case, Trial
from ..cases.variants import Variant
from .contact_conditions import largest_violation
from .contact_outputs import with_contact_outputs
from .error_indicators import indicators
from .expected_rows import Expected, expected_of
from .judgement import bound_of, judged
from .outcome import Cell, Outcome


@dataclass(frozen=True, slots=True)
class PointResult:
    """A point of a case and its cells; `how`, `reference_error` and `kappa` are those of `Expected`.

    left_out : runs for which no time was left
    independent : whether the reference shares no code with the runs
    span : of the motion [s]
    """

    case: str
    point: str
    how: str
    reference_error: float
    kappa: float
    periods: float
    cells: tuple[Cell, ...]
    left_out: int = 0
    independent: bool = True
    span: float = 0.0


def examine(
    case: Case, value: float, planted: Mapping[Variant, System] | None = None, seconds: float = np.inf
) -> PointResult:
    """Run every variant and method of a case at one value.

    Parameters
    ----------
    planted
        Systems to use instead of the built ones; tests plant faults in them.
    seconds
        Time for all runs; those that do not end in it, or at the deadline of the trial, are left out. The reference is
        not counted.

    Raises
    ------
    BuildError
        Generated code does not compile.
    """
    known = planted or {}
    model = with_contact_outputs(case.model(value))
    built = {variant: known.get(variant) or program(case, value, variant) for variant in case.variants}
    expected = expected_of(case.trial(value), next((s for s in built.values() if isinstance(s, System)), None))
    chosen = [(variant, method) for method in case.tolerances for variant in case.variants]
    trial = expected.trial
    limited = replace(expected, trial=replace(trial, deadline=trial.deadline.sooner(seconds)))
    tried = (_cell(case, model, limited, built[variant], variant, method) for variant, method in chosen)
    cells = tuple(cell for cell in tried if cell is not None)
    return PointResult(
        case.name, trial.label, expected.how, expected.error, expected.kappa, trial.periods, cells,
        left_out=len(chosen) - len(cells), independent=trial.truth.independent,
        span=abs(float(trial.times[-1]) - trial.start),
    )  # fmt: skip


def program(case: Case, value: float, variant: Variant) -> System | str:
    """Return the compiled system, or the reason why there is none."""
    try:
        return _built(with_contact_outputs(case.model(value)), tuple(variant.build.items()), case.flags)
    except BuildError:  # a failed compilation is not an answer to users
        raise
    except ModelError as error:
        return str(error)


@cache
def _built(model: Model, options: tuple[tuple[str, str], ...], flags: str | None) -> System:
    chosen: dict[str, Any] = dict(options)
    return build(model, flags=flags, **chosen)


def _cell(
    case: Case, model: Model, expected: Expected, system: System | str, variant: Variant, method: str
) -> Cell | None:  # fmt: skip
    """Return the outcome of a run; None if the deadline did not allow it to end."""
    tolerance = expected.trial.tolerance or case.tolerances[method]
    blank = Cell(case.name, expected.trial.label, variant.label, method, tolerance)
    if isinstance(system, str):
        return replace(blank, reason="not offered", message=system)
    begin = time.perf_counter()
    try:
        solution = _run(case, expected.trial, system, variant, method)
    except TooLateError:
        return None
    except (ModelError, EvaluationError) as error:
        return replace(blank, reason="start refused", message=str(error), seconds=time.perf_counter() - begin)
    except Exception as error:  # any other exception is not a named reason
        return replace(blank, outcome=Outcome.WRONG, reason="unnamed", message=f"{type(error).__name__}: {error}")
    done = replace(blank, nsteps=int(solution.nsteps), nfev=int(solution.nfev), seconds=time.perf_counter() - begin)
    if not solution.success:
        return replace(done, reason=str(solution.stop), message=solution.message)
    compared = _compared(done, expected, system, solution)
    if not solution.modes:
        return compared
    try:
        at_every_step = _run(case, expected.trial, system, variant, method, every_step=True)
    except TooLateError:
        return None
    return _with_conditions(compared, largest_violation(at_every_step, system, model, expected.trial.parameters))


def _with_conditions(compared: Cell, by: float) -> Cell:
    """Return the cell, with outcome WRONG if contacts and frictions violate their conditions by too much."""
    if compared.bound is None or by <= compared.bound:
        return compared
    return replace(compared, outcome=Outcome.WRONG, reason="contacts and frictions", message=f"off by {by:.2g}")


def _run(case: Case, trial: Trial, system: System, variant: Variant, method: str, every_step: bool = False) -> Solution:
    tolerance = trial.tolerance or case.tolerances[method]
    options: dict[str, Any] = variant.run
    run = partial(
        simulate,
        system,
        (trial.start, float(trial.times[-1])),
        x0=np.concatenate([trial.x0, trial.z0]),
        v0=trial.v0,
        parameters=trial.parameters,
        inputs=trial.inputs,
        method=method,
        rtol=tolerance,
        atol=tolerance * trial.units,
        t_eval=None if every_step else trial.times,
        **options,
    )
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        return trial.deadline.complete(lambda steps: run(max_steps=steps), case.max_steps)


def _compared(done: Cell, expected: Expected, system: System, solution: Solution) -> Cell:
    trial, bound = expected.trial, bound_of(expected, done.tolerance)
    if solution.stop is not StopReason.FINISHED or len(solution.t) != len(trial.times):
        message = f"{len(solution.t)} of {len(trial.times)} rows"
        return replace(done, outcome=Outcome.WRONG, reason="rows missing", message=message, bound=bound)
    error = expected.error_of(rows_of(solution))
    shown = indicators(trial, system, solution)
    verdict = judged(expected, done.tolerance, error, shown.largest)
    reason = verdict.reason if np.isfinite(error) else verdict.reason or "not finite"
    return replace(
        done, outcome=verdict.outcome, reason=reason, message=verdict.message, error=error, bound=bound, shown=shown
    )
