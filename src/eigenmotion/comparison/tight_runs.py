"""Tight runs: rows of one run at a tolerance close to rounding, from a given row."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from ..arguments.named_values import Vector
from ..codegen.model import ModelError
from ..reference.integration import NotReachedError
from ..reference.motion import rows_of
from ..runtime import EvaluationError
from ..simulation.simulate import simulate
from ..system.system import System


def tight_rows(
    system: System, methods: tuple[str, ...], start: Vector, times: Vector, tolerance: float, **given: Any
) -> tuple[Vector, str]:
    """Return rows (k, 2n + p) of (x, v, z) at times (k,), the first of which is the start, and the method.

    Parameters
    ----------
    methods
        In order of preference: the first that reaches the end counts.
    given
        Further arguments of `simulate`.

    Raises
    ------
    NotReachedError
        No method reaches the end.
    """
    said = ""
    for method in methods:
        try:
            done = _run(system, method, start, times, {"rtol": tolerance, "atol": tolerance} | given)
        except (ModelError, EvaluationError) as error:
            said = str(error)
            continue
        if done.success and len(done.t) == len(times) - 1:
            return np.vstack([start, rows_of(done)]), method
        said = done.message
    raise NotReachedError(said)


def _run(system: System, method: str, start: Vector, times: Vector, given: Mapping[str, Any]) -> Any:
    n, span = system.n, (float(times[0]), float(times[-1]))
    x0, v0 = np.delete(start, np.s_[n : 2 * n]), start[n : 2 * n]
    return simulate(system, span, x0=x0, v0=v0, method=method, t_eval=times[1:], **given)
