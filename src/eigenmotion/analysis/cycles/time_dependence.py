"""Symmetries of the equations: whether they depend on time, on which coordinates nothing depends, stated ones."""

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from ...runtime import EvaluationError
from ..state.operating_point import OperatingPoint
from .periodic_problem import Problem

_TIMES = (0.0, 0.31830988, 0.73205081)
"""Parts of a period, at which equations are compared."""


def depends_on_time(problem: Problem, q: Vector, period: float) -> bool:
    """Return whether accelerations, constraints or events depend on time beside the state."""
    c = problem.c
    signals = problem.system.bind(problem.system.prepare_both(problem.parameters, problem.inputs)[1]).signals
    if any(not isinstance(one, int | float) for one in signals) or c.prescribed:
        return True
    points = _points(problem, q, period)
    if any(at.motion[2][:, -1].any() or at.constraints[:, -1].any() for at in points):
        return True
    events = [_events(at) for at in points]
    return any((one != events[0]).any() for one in events)


def _events(at: OperatingPoint) -> Vector:
    return np.nan_to_num(at.model.event_rows(np.array([at.t]), at.x[None], at.v[None], at.u[None], at.prepared))


def _points(problem: Problem, q: Vector, period: float) -> list[OperatingPoint]:
    """Return states beside the start, at several times; only the time differs."""
    n = problem.c.n
    v = q[n:] + np.where(q[n:] == 0.0, 1.0, 0.0)  # terms may vanish at rest
    beside = np.concatenate([q[:n], v])
    return [problem.point(beside, problem.t + part * period, problem.prepared) for part in _TIMES]


def advancing(problem: Problem, q: Vector, period: float) -> tuple[int, ...]:
    """Return the places of coordinates by which accelerations, constraints and events have no derivative here.

    Runs decide later whether nothing depends on them along the whole motion.
    """
    found = []
    at = _points(problem, q, period)[0]
    try:
        slopes = np.vstack([at.motion[2], at.constraints])
    except EvaluationError:
        return ()
    for k in range(problem.c.n_coordinates):
        there = at.at(at.t, at.x + np.eye(len(at.x))[k] * 0.73205081 * max(1.0, abs(at.x[k])), at.v)
        if not slopes[:, k].any() and (_events(there) == _events(at)).all():
            found.append(k)
    return tuple(found)


def check_symmetry(problem: Problem, q: Vector, period: float) -> None:
    """Raise ModelError if accelerations at the image of a state are not the images of accelerations.

    Contacts and frictions may be in other modes there, so models with these are not checked.
    """
    if not problem.symmetry.stated or problem.c.switches:
        return
    n, G, later = problem.c.n, problem.symmetry.G, period if problem.clock else 0.0
    for part in _TIMES[1:]:
        beside = q + part * np.concatenate([q[n:] * period / 10.0, q[n:] / 10.0])
        image = problem.flow(problem.symmetry(beside), problem.t + later, problem.prepared)
        there = problem.flow(beside, problem.t, problem.prepared)
        if not np.abs((image - G @ there)[n:]).max() <= 1e-9 * max(np.abs(image[n:]).max(), np.abs(there[n:]).max()):
            raise ModelError(
                f"{problem.c.name}: symmetry is none of the equations: accelerations at the image of a state are not "
                "the images of accelerations. State another"
            )
