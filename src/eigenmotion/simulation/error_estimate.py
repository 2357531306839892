"""Error estimate of a run: the difference to a second, more accurate one.

With errors e and e' of the two runs the difference is between |e| - |e'| and |e| + |e'|. The second run has a hundredth
of the tolerances (if that is above rounding). Since the step size control makes the global error about proportional to
the tolerance, its error is a few hundredths of the error of the first run. The factor of this proportion depends on
the method; it differs by 35 between dop853 and rk34 on a pendulum at 1e-4. So if the second run has another method, it
has a ten thousandth of the tolerances, which is cheap because of its higher order.

The two runs have event actions at slightly different times. At a row between these times one run is after the jump and
the other before it; such rows are left out. The error of the time of an event is included in the states at other rows.
Rotations are compared in the same parameters, which the two runs change at different times.
"""

import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arguments.methods import Method, checker_of
from ..arguments.named_values import Vector
from ..arguments.tasks import Task
from ..codegen.model import ModelError
from ..results.charts import in_charts_of
from ..results.solution import Solution
from ..runtime import CompiledModel
from .method_selection import longest_of

Runner = Callable[[Task, Method], Solution]

TIGHTER, TIGHTER_ACROSS = 1e-2, 1e-4
FINEST = 3e-14  # rtol below which the error estimate of a step is rounding


@dataclass(frozen=True, slots=True)
class ErrorEstimate:
    """The difference to a more accurate run, at the rows of the solution.

    Attributes
    ----------
    x, v : (n,) |error| of x_k [u_k] and v_k [u_k / s] at the last row compared
    x_largest, v_largest : (n,) the largest at any row
    scaled, scaled_largest : max over coordinates of |error of x_k| / (1 + |x_k|), at the last row and at any
    t : the last row compared [s]
    message : "" if all rows were compared and the second run is clearly more accurate; else a warning. Rows at the time
        of an impact are not compared if the two runs are on different sides of its jump
    """

    x: Vector
    v: Vector
    x_largest: Vector
    v_largest: Vector
    scaled: float
    scaled_largest: float
    t: float
    message: str


@dataclass(frozen=True, slots=True)
class ErrorCost:
    """The second run of an error estimate, and its cost.

    Attributes
    ----------
    seconds : of the second run; share : its seconds divided by those of the first run
    """

    formulation: str
    method: str
    rtol: float
    nfev: int
    nsteps: int
    seconds: float
    share: float


def with_error_estimate(task: Task, method: Method, checker: CompiledModel | None, run: Runner) -> Solution:
    """Run a task twice, the second time more accurately; the solution gets `error_estimate` and `error_cost`.

    Parameters
    ----------
    checker
        The same model in another formulation for the second run; None: the same system. Only another formulation can
        show an error of the formulation itself.
    """
    solution, first = _clocked(run, task, method)
    used = longest_of(solution)
    checking = checker_of(used)
    if not len(solution.t) or solution.t[-1] == task.t_start:
        return _blank(solution, task)
    tighter = _tighter(task, solution, TIGHTER if used == checking else TIGHTER_ACROSS)
    if checker is not None:
        tighter = _on(checker, tighter)
    second, seconds = _clocked(run, tighter, checking)
    solution["error_estimate"] = _compared(task, solution, second, tighter.rtol)
    solution["error_cost"] = ErrorCost(
        tighter.model.formulation, checking.name, tighter.rtol, second.nfev, second.nsteps, seconds, seconds / first
    )
    return solution


def _clocked(run: Runner, task: Task, method: Method) -> tuple[Solution, float]:
    start = time.perf_counter()
    solution = run(task, method)
    return solution, time.perf_counter() - start


def _tighter(task: Task, solution: Solution, least: float) -> Task:
    """Return the task of the second run: at the rows of the first, up to the time that the first reached."""
    factor = least if task.rtol == 0 else min(1.0, max(least, FINEST / task.rtol))
    return task._replace(
        rtol=task.rtol * factor, atol=task.atol * factor, dense=False, first_step=0.0,
        t_eval=np.asarray(solution.t), t_end=float(solution.t[-1]), max_steps=10 * task.max_steps,
    )  # fmt: skip


def _on(other: CompiledModel, task: Task) -> Task:
    model = task.model
    for what in ("name", "coordinates", "parameters", "inputs", "m"):
        if getattr(model, what) != getattr(other, what):
            raise ModelError(
                f"estimate_error: {other.name} ({other.formulation}) differs from {model.name} in its {what}; "
                "give the same model, built in another formulation"
            )
    prepared = other.prepare(task.prepared.parameters)
    x = np.ascontiguousarray(task.y[: model.n])
    v = model.velocity_rows(np.array([task.t_start]), task.y[None], task.prepared)[0]
    return task._replace(model=other, prepared=prepared, y=other.state(task.t_start, x, v, prepared))


def _compared(task: Task, solution: Solution, second: Solution, rtol: float) -> ErrorEstimate:
    rows = min(len(solution.t), len(second.t))
    same = np.flatnonzero(_on_one_side(task, solution, second, rows))
    caution = _caution(task.rtol, rtol, len(solution.t) - rows, second, rows - len(same))
    if len(same) == 0:
        return _nothing(task, float(solution.t[-1]), caution)
    here, there = ((run.x[:, same], run.v[:, same]) for run in (solution, second))
    there = in_charts_of(task.model, here[0], *there)
    x, v = (np.abs(one - other) for one, other in zip(here, there, strict=True))
    scaled = np.max(x / (1 + np.abs(there[0])), axis=0)
    return ErrorEstimate(
        x[:, -1], v[:, -1], x.max(axis=1), v.max(axis=1), float(scaled[-1]), float(scaled.max()),
        float(solution.t[same[-1]]), caution,
    )  # fmt: skip


def _on_one_side(task: Task, solution: Solution, second: Solution, rows: int) -> NDArray[np.bool_]:
    """Return (rows,) booleans: whether both runs are on the same side of every event action."""
    same = np.ones(rows, dtype=bool)
    if not task.model.acts:
        return same
    t = np.asarray(solution.t[:rows])
    after = np.append(False, np.diff(t) == 0) & (task.t_eval is None)  # the second run has the state before, twice
    same &= ~(after & np.append(after[1:], False))  # rows between two event actions at one time
    both = zip(solution.t_events, second.t_events, task.model.acting, strict=True)
    for here, there in (times for mine, others, acts in both if acts for times in zip(mine, others, strict=False)):
        near = (t >= min(here, there)) & (t <= max(here, there))
        past = (t > here) | (after & (t == here))
        same &= ~near | (past == (t > there))
    return same


def _caution(rtol: float, tighter: float, missing: int, second: Solution, left_out: int) -> str:
    words = []
    if missing and not second.success:
        words.append(f"The second run ended early, so that {missing} rows could not be compared: {second.message}")
    elif missing:
        words.append(f"The second run met a terminal event first, so that {missing} rows could not be compared.")
    if left_out:
        words.append(
            f"{left_out} rows at the very moment of an event that acts were not compared: there one run is past the "
            "jump and the other before it."
        )
    if rtol > 0 and tighter > 0.1 * rtol:
        words.append("rtol leaves no room for a much tighter run: the estimate is good to a factor of about 3.")
    return " ".join(words)


def _nothing(task: Task, at: float, words: str) -> ErrorEstimate:
    unknown = np.full(task.model.n, np.nan)
    return ErrorEstimate(unknown, unknown, unknown, unknown, np.nan, np.nan, at, words)


def _blank(solution: Solution, task: Task) -> Solution:
    """Return the estimate of a run without rows after its start: nothing can be compared."""
    at = float(solution.t[-1]) if len(solution.t) else task.t_start
    solution["error_estimate"] = _nothing(task, at, "There are no rows to compare.")
    solution["error_cost"] = ErrorCost(task.model.formulation, "none", task.rtol, 0, 0, 0.0, 0.0)
    return solution
