"""Sensitivities of the members of a chunk, each along a run with dense output."""

import numpy as np

from ..arguments.methods import METHODS
from ..arguments.named_values import Vector
from ..arguments.tasks import TO_DERIVE, EnsembleTask, Members, Task
from ..codegen.model.normalise import ModelError
from ..results.batch_arrays import REASONS, BatchArrays
from ..results.sensitivity import Sensitivity
from ..results.solution import Solution
from ..runtime import EvaluationError, StopReason, explain
from ..runtime.ensemble import Stop
from ..simulation.sensitivity.sensitivities import directions, sensitivity
from ..simulation.simulate import run_task
from .member_start import task_of

Shifts = dict[int, Vector]
"""Member -> derivatives of its event times, (events, names)."""


def in_one_run(common: EnsembleTask) -> bool:
    """Return whether a run with dense output computes the rows of a chunk bit for bit, so that one run is enough.

    It does not if dense output takes right-hand sides of its own, which are counted. Runs of dop853 in lanes also
    differ from single ones by rounding.
    """
    return common.differentiated is not None and not METHODS[common.name].dense_calls


def vary_members(common: EnsembleTask, members: Members, results: BatchArrays, stop: Stop) -> Shifts:
    """Run members again with dense output, and compute their sensitivities as `vary` does."""
    shifts: Shifts = {}
    for k in range(members.count):
        if stop or REASONS[results.status[k]] is StopReason.START_REFUSED:
            continue
        try:
            task = task_of(common, members, k)._replace(dense=TO_DERIVE)
            solution = run_task(task, METHODS[common.name])
        except (ModelError, EvaluationError) as error:
            _none(common, k, results, error)
            continue
        vary(common, k, task, solution, results, shifts)
    return shifts


def vary(common: EnsembleTask, k: int, task: Task, solution: Solution, results: BatchArrays, shifts: Shifts) -> None:
    """Store `S` and `shifts` of a member; if a successful run has no sensitivities, store the reason in `messages`."""
    by = common.differentiated
    if by is None:
        return
    try:
        rows = list(sensitivity(task, solution, directions(by, task), METHODS[common.name]).values())
    except (ModelError, EvaluationError) as error:
        _none(common, k, results, error)
        return
    if rows:
        S = np.array([_whole(one).T for one in rows]).transpose(1, 2, 0)
        S = S[-1:] if common.end_only else S
        results.S[k, : len(S)] = S
        shifts[k] = np.array([np.concatenate([*(one.dt_events or ()), np.empty(0)]) for one in rows]).T


def _whole(one: Sensitivity) -> Vector:
    """Return derivatives (2 n, k) of x, v of compiled functions, without those of integrals of states."""
    return np.vstack([one.dx, np.zeros_like(one.dz), one.dv, one.dz])


def _none(common: EnsembleTask, k: int, results: BatchArrays, error: Exception) -> None:
    message = results.messages.get(k, explain(REASONS[results.status[k]], common.model.coordinates))
    results.messages[k] = f"{message} It has no sensitivities: {error}"


def together(results: BatchArrays, shifts: Shifts, names: int) -> Vector:
    """Return the derivatives of all event times of a chunk, (events, names); NaN for members without sensitivities."""
    joined = np.full((len(results.event_times), names), np.nan)
    ends = np.cumsum(results.event_counts.sum(axis=1))
    for k, shift in shifts.items():
        joined[ends[k] - len(shift) : ends[k]] = shift
    return joined
