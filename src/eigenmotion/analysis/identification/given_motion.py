"""Motions that are given for identification: a run, or arrays."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError, shown
from ...compiled.compiled_system import CompiledSystem
from ...results.solution import Solution
from ..inverse.motion_arguments import Motion, motion_of

Given = Solution | Sequence[Any] | Vector


def given_motion(system: CompiledSystem, motion: Given, inputs: Any, values: Any) -> Motion:
    """Return the rows of a run or of arrays (x, v, a) or (x, v, a, t).

    Raises
    ------
    ModelError
        It is neither, or a run of another model or from another process; else as `motion_of`.
    """
    if isinstance(motion, Solution):
        return _of_run(system, motion, inputs, values)
    parts = list(motion) if isinstance(motion, tuple | list) or (isinstance(motion, np.ndarray) and motion.ndim) else []
    if len(parts) not in (3, 4):
        raise ModelError(f"motion is {shown(motion)}. Give a Solution, or arrays (x, v, a) or (x, v, a, t).")
    x, v, a, *t = parts
    return motion_of(system, x, v, a, t[0] if t else 0.0, values, inputs)


def _of_run(system: CompiledSystem, run: Solution, inputs: Any, values: Any) -> Motion:
    rows, c = run.trajectory, system.compiled
    if rows is None:
        raise ModelError(f"{c.name}: the run came from another process. Give its arrays (x, v, a, t).")
    if rows.model.name != c.name or rows.model.parameters != c.parameters:
        raise ModelError(f"the run is one of {rows.model.name}, and the system is {c.name}")
    if inputs is not None:
        raise ModelError(f"{c.name}: the run has its inputs. Leave out `inputs`, or give arrays (x, v, a, t).")
    a = rows.accelerations
    known = np.isfinite(a).all(axis=1)
    prepared = rows.task.prepared if values is None else system.prepare(values)
    return Motion(c, prepared, rows.t, rows.x, rows.v, a, rows.u, many=True).rows(known)
