"""Agreement of two tight runs of this tool: the reference of a report where there is no independent one."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ..arguments.named_values import Vector
from ..codegen.model import ModelError
from ..comparison.tight_runs import tight_rows
from ..reference.integration import NotReachedError
from ..reference.motion import ROWS, Reference, positions, scaled_error
from ..reference.rotations import in_sets_of
from ..system.system import System
from .solvers import MOST_STEPS, Problem

_FINE, _CHECK = 1e-13, 1e-12
_METHODS = ("dop853", "radau9", "ra15", "radau5")  # in order of preference; the two runs are by different ones
_AGREE = 1e-3  # a larger difference is none


def agreement(systems: Sequence[System], problem: Problem, start: Vector, why: str) -> Reference:
    """Return the rows of a tight run, whose error is the difference from another formulation and method.

    Raises
    ------
    ModelError
        The runs do not reach the end, or they differ; says from when.
    """
    first, second = systems[0], systems[-1]
    times = np.linspace(0.0, problem.t_end, ROWS)
    given: dict[str, Any] = {name: problem.settings.get(name) for name in ("parameters", "inputs")}
    given["max_steps"] = MOST_STEPS
    try:
        fine, method = tight_rows(first, _METHODS, start, times, _FINE, **given)
        others = tuple(name for name in _METHODS if name != method)[:2]
        check, other = tight_rows(second, others, start, times, _CHECK, **given)
    except NotReachedError as error:
        raise ModelError(
            f"{first.name}: there is no independent reference ({why}), and tight runs do not reach the end: {error} "
            "Shorten the span with --t-end."
        ) from error
    n = first.n
    check = in_sets_of(fine, check, n, first.compiled.rotations)
    errors = scaled_error(positions(check, n), positions(fine, n))
    how = (
        f"No independent reference ({why}): a run by {first.formulation} with {method} at {_FINE:g}, whose error is "
        f"taken to be its difference from one by {second.formulation} with {other} at {_CHECK:g}. A fault that both "
        "share stays hidden."
    )
    _check(first.name, times, errors)
    return Reference(times, positions(fine, n), fine[:, n : 2 * n], errors, how, why)


def _check(name: str, times: Vector, errors: Vector) -> None:
    apart = np.flatnonzero(~(errors <= _AGREE))
    if len(apart):
        raise ModelError(
            f"{name}: two tight runs by two formulations and methods differ by {errors[apart[0]]:.1g} at "
            f"t = {times[apart[0]]:.6g} already, as the motion magnifies small differences: from there no run can be "
            f"judged. Shorten the span with --t-end {times[max(int(apart[0]) - 1, 1)] / 2:.2g}."
        )
