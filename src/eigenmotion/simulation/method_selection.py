"""Selection of a method for a run with method="auto".

The limits were measured over all models (benchmarks/nodes.py, benchmarks/stiff.py, benchmarks/ensemble.py,
docs/theory.md).
"""

from math import inf, sqrt

import numpy as np

from ..arguments.methods import METHODS, Method
from ..arguments.named_values import Vector
from ..arguments.tasks import Task
from ..runtime import CompiledModel, EvaluationError

_LEAST_LANES = 4
_TIGHT = {"eigenfactor": 1e-6}
_TIGHT_OTHERWISE = 1e-5
_TIGHT_WITH_MANY = {4: ((150, 1e-11),), 8: ((150, 1e-10), (100, 1e-8), (60, 1e-7))}
"""Vector width -> (numbers of eigenfactors in the state, tolerance): with more numbers, nodes pay only at tighter
tolerances, since products of eigenfactors already fill the vectors. Measured on chains of 8 to 16 coordinates."""
_PLACED = ((6, 1e-7), (1, 3e-11))
"""For ensembles: (constraints on positions, tolerance): with at least so many constraints, longer steps pay up to this
tolerance."""
_STIFF = METHODS["radau9"]
_APART = 100.0
"""A scene is stiff if decaying modes are at least so many times as fast as lasting ones;"""
_SPANS = 50.0
"""if they decay over the span by a factor of at least exp(-50);"""
_DAMPED = 0.1
"""if the real part is at least this part of their eigenvalue (long oscillations must be resolved);"""
_STEPS = 2000.0
"""and if stability would require at least about so many explicit steps."""
_ABOUT = 2.0
"""Error factor of finite differences, which avoid a compilation of the derivatives for scenes that are not stiff: the
derivatives decide only where all limits are met within this factor."""
_NONE = np.empty(0)


def automatic_of_run(task: Task) -> tuple[Method, str]:
    """Return a stiff method and the reason as text if the motion is stiff at its start; else `automatic` and "".

    Stiffness that begins later, for example in a contact, is found by the run itself, which then changes its method
    (em_method_change.h). So is that of runs with controllers, whose first values are not known yet.
    """
    fast = 0.0 if task.inputs.sampled else _dying_rate(task)
    if not fast:
        return automatic(task.model, task.rtol, _may_depend(task)), ""
    return _STIFF, (
        f" method='auto' took {_STIFF.name}, since the scene is stiff: at its start something dies out at a rate of "
        f"{fast:.2g} / s, {_APART:g} times as fast as what lasts, or more."
    )


def _may_depend(task: Task) -> bool:
    """Return whether constraint rows may depend on each other in the run; without rows, the option means nothing."""
    return task.model.m > 0 and task.least_norm != 0


def other_than(method: Method) -> Method:
    """Return the method to which a run by `method` may change: the stiff one, or from it to dop853."""
    return METHODS["dop853"] if method.implicit else _STIFF


def _dying_rate(task: Task) -> float:
    """Return the rate [1/s] of the fastest decaying mode if stability, not accuracy, limits explicit steps; else 0.

    It is an eigenvalue of the Jacobian of the motion at the start, which does not depend on units or coordinates.
    """
    span, model, prepared = task.t_end - task.t_start, task.model, task.prepared
    u = task.inputs.at(task.t_start) if model.n_inputs else _NONE
    about, slopes = model.approximate_slopes(task.t_start, task.y, prepared, u, task.least_norm, task.atol)
    if _ABOUT * (sqrt(about) + about) * abs(span) <= 4 * _STEPS:
        return 0.0
    if about < inf and not _dying(_motion_of(slopes), span, _ABOUT):
        return 0.0
    v = model.velocity_rows(np.array([task.t_start]), task.y[None], prepared)
    z = np.concatenate([task.y[: model.n], v[0]])
    try:
        J = model.motion_jacobian(task.t_start, z, prepared, u, task.least_norm)
    except EvaluationError:
        return 0.0
    size = float(np.linalg.norm(J[model.n :]))
    if not 4 * _STEPS < (sqrt(size) + size) * abs(span) < inf:  # no eigenvalue is larger
        return 0.0
    return _dying(J, span)


def _motion_of(slopes: Vector) -> Vector:
    """Return the Jacobian (2 n, 2 n) of the motion (v, a), from that of a (n, 2 n)."""
    n = len(slopes)
    return np.block([[np.zeros((n, n)), np.eye(n)], [slopes]])


def _dying(J: Vector, span: float, about: float = 1.0) -> float:
    """Return the rate [1/s] of the fastest mode that decays, if it is so fast that it is stiff; else 0.

    about : all limits may be missed by this factor
    """
    roots = np.linalg.eigvals(J)
    sizes, dies = np.abs(roots), -roots.real * span
    dying = (about * dies > _SPANS) & (about * dies > _DAMPED * sizes * abs(span))
    fast, lasting = sizes[dying].max(initial=0.0), sizes[~dying].max(initial=1 / abs(span))
    is_stiff = about * fast > _APART * lasting and about * fast * abs(span) > 4 * _STEPS
    return float(fast) if is_stiff else 0.0


def automatic(model: CompiledModel, rtol: float, least_norm: bool) -> Method:
    """Return ra15 if its longer steps pay, else dop853.

    They pay at tight tolerances, if the processor evaluates four nodes or more in one vector.
    """
    side_by_side = model.lanes >= _LEAST_LANES and not least_norm
    return METHODS["ra15" if side_by_side and rtol <= _nodes_pay(model) else "dop853"]


def _nodes_pay(model: CompiledModel) -> float:
    """Return the tolerance below which steps of ra15 pay."""
    factors = model.n_state - 2 * model.n
    otherwise = _TIGHT.get(model.formulation, _TIGHT_OTHERWISE)
    return next((rtol for many, rtol in _TIGHT_WITH_MANY.get(model.lanes, ()) if factors > many), otherwise)


def automatic_of_many(model: CompiledModel, rtol: float, least_norm: bool) -> Method:
    """Return dop853 if each lane can hold a run, which is faster than the nodes of one run; else `automatic`."""
    in_lanes = model.lane_groups and not least_norm and rtol > _longer_steps_pay(model.h)
    return METHODS["dop853"] if in_lanes else automatic(model, rtol, least_norm)


def _longer_steps_pay(positions: int) -> float:
    """Return the tolerance up to which longer steps pay: the projection of positions does not run in lanes."""
    return next((rtol for least, rtol in _PLACED if positions >= least), 0.0)
