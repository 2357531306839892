"""Symmetries of the equations: how they depend on time, on which coordinates nothing depends, stated ones."""

from dataclasses import replace

import numpy as np

from ...arguments.named_values import Vector
from ...arguments.signals import Inputs, Signal
from ...codegen.model.normalise import ModelError
from ...runtime import EvaluationError
from ..state.operating_point import OperatingPoint
from .newton import NEXT_TO, noise, size
from .periodic_problem import Problem
from .returns import NoReturnError, Return, Section, returned
from .segments import chain_of, joined

_TIMES = (0.0, 0.31830988, 0.73205081)
"""Parts of a period, at which equations are compared."""
_MANY = 200
"""Number of times in a period at which its forcing is compared with that of the next period,"""
_ALIKE = 1e-6
"""and the largest difference, relative to the sizes of accelerations."""


def depends_on_time(problem: Problem, q: Vector, period: float) -> bool:
    """Return whether accelerations, constraints or events depend on time beside the state."""
    c = problem.c
    if any(not isinstance(one, int | float) for one in _inputs(problem).signals) or c.prescribed:
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


def event_at_start(problem: Problem, q: Vector, period: float) -> int | None:
    """Return the number of an event that acts within a small part of the period of the start of a motion, or None."""
    try:
        flow = problem.flow(q, problem.t, problem.prepared)
    except EvaluationError:
        return None
    ahead = 1e-6 * period
    now = _events(problem.point(q, problem.t, problem.prepared))
    rates = (_events(problem.point(q + ahead * flow, problem.t + ahead, problem.prepared)) - now) / ahead
    near = (np.abs(now) < NEXT_TO * period * np.abs(rates)) & np.array(problem.c.acting, dtype=bool)
    return int(np.flatnonzero(near)[0]) if near.any() else None


def unrepeated(problem: Problem, section: Section, one: Return, nodes: tuple[Vector, ...] = ()) -> str:
    """Return that the forcing in the period after a motion is another one, or "".

    A motion that closes once repeats only if the equations at t + period are those at t. Accelerations are compared
    along the motion, which growing deviations do not disturb; constraints hold at both ends, so they repeat with these.
    What acts at moments is compared by a run over the next period.
    """
    end = _end_of_samples(problem)
    what = _other_accelerations(problem, one, end)
    if not what and problem.clock and _acts_at_moments(problem) and problem.t + one.period + one.period <= end:
        what = _other_run(problem, section, one, nodes)
    return f"the forcing does not repeat after period {one.period:.6g}: {what}" if what else ""


def _inputs(problem: Problem) -> Inputs:
    return problem.system.bind(problem.system.prepare_both(problem.parameters, problem.inputs)[1])


def is_constant(problem: Problem, name: str) -> bool:
    """Return whether an input is a number."""
    return isinstance(_inputs(problem).signals[problem.c.inputs.index(name)], int | float)


def _end_of_samples(problem: Problem) -> float:
    """Return the time up to which the signals are known: one that covers a single period is taken to repeat."""
    sampled = [one for one in _inputs(problem).signals if isinstance(one, Signal) and one.kind != "hold"]
    return min((float(one.times[-1]) for one in sampled), default=np.inf)


def _acts_at_moments(problem: Problem) -> bool:
    """Return whether events, contacts, frictions or sampled inputs act."""
    c, signals = problem.c, _inputs(problem).signals
    sampled = any(not isinstance(one, int | float | Signal) for one in signals)
    return sampled or bool(c.switches) or any(c.acting)


def _other_accelerations(problem: Problem, one: Return, end: float) -> str:
    """Return by how much accelerations at the same states differ a period later, or ""."""
    if problem.symmetry.stated and problem.c.switches:
        return ""  # contacts and frictions may be in other modes at the image
    n, G, bound = problem.c.n, problem.symmetry.G, _inputs(problem)
    times = problem.t + one.period * (np.arange(_MANY) + _TIMES[1]) / _MANY  # beside the moments at which signals jump
    times = times[times + one.period <= end]
    rows = one.rows[np.searchsorted(one.times, times, side="right") - 1]
    now = np.array([_accelerations(problem, bound, t, q) for t, q in zip(times, rows, strict=True)]).reshape(-1, n)
    then = [_accelerations(problem, bound, t + one.period, problem.symmetry(q))
            for t, q in zip(times, rows, strict=True)]  # fmt: skip
    known = np.isfinite(now) & np.isfinite(np.reshape(then, now.shape))
    sizes = np.maximum(np.abs(np.where(known, now, 0.0)).max(axis=0, initial=0.0),
                       one.scale[n:] * 2.0 * np.pi / one.period)  # fmt: skip
    apart = np.where(known, np.abs(np.reshape(then, now.shape) - now @ G[n:, n:].T), 0.0) / sizes
    worst = float(apart.max(initial=0.0))
    return f"accelerations a period later differ by {worst:.2g} of their sizes" if worst > _ALIKE else ""


def _accelerations(problem: Problem, bound: Inputs, t: float, q: Vector) -> Vector:
    """Return a (n,) at a state; it is not a number beyond the range of a table."""
    n = problem.c.n
    try:
        return np.asarray(problem.c.acceleration(t, q[:n], q[n:], problem.prepared, bound.at(t), 1)[0])
    except EvaluationError:
        return np.full(n, np.nan)


def _other_run(problem: Problem, section: Section, one: Return, nodes: tuple[Vector, ...]) -> str:
    """Return by how much the run over the next period does not close, or ""."""
    later = replace(problem, t=problem.t + one.period, by=())
    problem.count.most += 1 + len(nodes)
    try:
        if nodes:
            again = joined(later, chain_of(later, tuple(map(problem.symmetry, nodes)), one.period))
        else:
            again = returned(later, section, problem.symmetry(one.q), one.period)
    except NoReturnError as error:
        return f"the second period cannot be run: {error}"
    if again.order != one.order:
        return "events in the second period are others"
    gap = size(problem, again)
    return f"the second period does not close, by {gap:.3g} of the motion" if gap > 10.0 * noise(later, again) else ""
