"""Tight runs: rows of one run at a tolerance close to rounding, from a given row."""

from collections.abc import Callable
from typing import Any

import numpy as np

from ..arguments.named_values import Vector
from ..codegen.model import ModelError
from ..reference.integration import NotReachedError
from ..reference.motion import rows_of
from ..results.solution import Solution
from ..runtime import EvaluationError
from ..simulation.simulate import simulate
from ..system.system import System
from .interrupts import uninterrupted


def tight_rows(
    system: System, methods: tuple[str, ...], start: Vector, times: Vector, tolerance: float,
    run: Callable[..., Solution] = simulate, **given: Any,
) -> tuple[Vector, str]:  # fmt: skip
    """Return rows (k, 2n + p) of (x, v, z) at times (k,), the first of which is the start, and the method.

    Parameters
    ----------
    methods
        In order of preference: the first that reaches the end counts.
    run
        `simulate`, or what limits it.
    given
        Further arguments of `simulate`.

    Raises
    ------
    NotReachedError
        No method reaches the end.
    """
    said, n = "", system.n
    options = {"rtol": tolerance, "atol": tolerance, "t_eval": times[1:]} | given
    x0, v0, span = np.delete(start, np.s_[n : 2 * n]), start[n : 2 * n], (float(times[0]), float(times[-1]))
    for method in methods:
        try:
            done = uninterrupted(run(system=system, t_span=span, x0=x0, v0=v0, method=method, **options))
        except (ModelError, EvaluationError) as error:
            said = str(error)
            continue
        if done.success and len(done.t) == len(times) - 1:
            return np.vstack([start, rows_of(done)]), method
        said = done.message
    raise NotReachedError(said)
