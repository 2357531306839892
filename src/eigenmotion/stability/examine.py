"""One point of a case: every run, and what becomes of it."""

import time
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import numpy as np

from ..building.build import build
from ..building.errors import BuildError
from ..codegen.model import Model, ModelError
from ..results.solution import Solution
from ..running.simulate import simulate
from ..runtime import EvaluationError, StopReason
from ..system.system import System
from .case import EXPLICIT, Case, Point
from .indicators import indicators
from .outcome import MARGIN, MEANINGLESS, Cell, Outcome, judged
from .reference import Reference, reference_of
from .variants import IMPLICIT, Variant


@dataclass(frozen=True, slots=True)
class Examined:
    """A point and its cells; `how`, `reference_error` and `kappa` are those of its Reference."""

    case: str
    point: str
    how: str
    reference_error: float
    kappa: float
    periods: float
    cells: tuple[Cell, ...]


def examine(case: Case, value: float, planted: Mapping[Variant, System] | None = None) -> Examined:
    """Run every variant and method of a case at one value.

    Parameters
    ----------
    planted
        Programs to use in place of those of the case's model: a test plants faults in them.

    Raises
    ------
    BuildError
        Generated code does not compile.
    """
    known = planted or {}
    built = {variant: known.get(variant) or program(case, value, variant) for variant in case.variants}
    point = case.point(value)
    reference = reference_of(point, next((s for s in built.values() if isinstance(s, System)), None))
    chosen = [
        (variant, method)
        for method in case.tolerances
        for variant in case.variants
        if method in EXPLICIT or variant in IMPLICIT
    ]
    cells = tuple(_cell(case, reference, built[variant], variant, method) for variant, method in chosen)
    return Examined(case.name, point.label, reference.how, reference.error, reference.kappa, point.periods, cells)


def program(case: Case, value: float, variant: Variant) -> System | str:
    """Return the compiled program, or why there is none."""
    try:
        return _built(case.model(value), tuple(variant.build.items()), case.flags)
    except BuildError:  # code that does not compile is no answer to a user
        raise
    except ModelError as error:
        return str(error)


@cache
def _built(model: Model, options: tuple[tuple[str, str], ...], flags: str | None) -> System:
    chosen: dict[str, Any] = dict(options)
    return build(model, flags=flags, **chosen)


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
    options: dict[str, Any] = variant.run
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        return simulate(
            system,
            (point.start, float(point.times[-1])),
            x0=point.x0,
            v0=point.v0,
            parameters=point.parameters,
            inputs=point.inputs,
            method=method,
            rtol=tolerance,
            atol=tolerance * point.units,
            t_eval=point.times,
            max_steps=case.max_steps if method in EXPLICIT else case.max_steps_stiff,
            **options,
        )


def _compared(done: Cell, reference: Reference, system: System, solution: Solution) -> Cell:
    point, bound = reference.point, min(MARGIN * done.tolerance * (1 + reference.kappa), MEANINGLESS)
    if solution.stop is not StopReason.FINISHED or len(solution.t) != len(point.times):
        message = f"{len(solution.t)} of {len(point.times)} rows"
        return replace(done, outcome=Outcome.WRONG, reason="rows missing", message=message, bound=bound)
    error = reference.error_of(np.concatenate([solution.x, solution.v]).T)
    shown = indicators(point, system, solution)
    outcome = judged(error, bound, shown.largest, point.periods)
    reason = "" if np.isfinite(error) else "not finite"
    return replace(done, outcome=outcome, reason=reason, error=error, bound=bound, shown=shown)
