"""Guess of a period: the time at which a motion first comes back to where it started."""

from dataclasses import replace

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from ...results.solution import Solution
from ...runtime import StopReason
from .periodic_problem import Problem
from .returns import NoReturnError, Section, firings, run

_ROWS = 400
_DOUBLINGS = 12
_MOST_DOUBLINGS, _CHEAP = 40, 1000
"""Where a motion is much slower than its fastest time constant, the search goes on while runs take few steps."""
_NEAR = 0.1
"""Distance of a return, relative to the extent of the motion, that ends the search."""


def first_motion(problem: Problem, section: Section, q: Vector) -> tuple[Vector, float, Section]:
    """Return a start and a period to begin with; an event that does not act begins the motion where it happens.

    Raises
    ------
    ModelError
        The motion does not return.
    """
    ahead = 10.0 * problem.point(q, problem.t, problem.prepared).time
    best: tuple[float, float] | None = None
    for k in range(_MOST_DOUBLINGS):
        times = {} if section.event is not None else {"t_eval": np.linspace(problem.t, problem.t + ahead, _ROWS)}
        try:
            solution = run(problem, q, problem.t + ahead, **times)
            if section.event is not None:
                found = _of_event(problem, section, q, solution)
                if found is not None:
                    return *found, section
            else:
                one = _nearest(problem, section, q, solution)
                if one is not None and (best is None or one[0] < 0.5 * best[0]):
                    best = one
                if best is not None and best[0] <= _NEAR:
                    return q, best[1], section
        except NoReturnError as error:
            raise ModelError(f"{problem.c.name}: the motion from x0, v0 does not return: {error}") from error
        if k >= _DOUBLINGS - 1 and (best is not None or solution.nsteps > _CHEAP):
            break
        ahead *= 2.0
    if best is not None:
        return q, best[1], section
    name = problem.c.events[section.event] if section.event is not None else None
    what = f"event {name!r} does not happen" if name else "the motion does not return"
    raise ModelError(f"{problem.c.name}: {what} within {ahead:.3g} s of the start. Give the period, or another start")


def at_section(problem: Problem, section: Section, q: Vector, guess: float | None) -> tuple[Vector, float, Section]:
    """Return the state and the time where a motion first crosses the section, and the section with its direction.

    Raises
    ------
    ModelError
        It does not.
    """
    quantity = section.quantity
    assert quantity is not None
    ahead = guess or 10.0 * problem.point(q, problem.t, problem.prepared).time
    for _ in range(_DOUBLINGS):
        times = np.linspace(problem.t, problem.t + ahead, _ROWS)
        try:
            solution = run(problem, q, times[-1], t_eval=times)
        except NoReturnError as error:
            raise ModelError(f"{problem.c.name}: the motion from x0, v0 does not reach the section: {error}") from error
        rows = problem.rows(solution)
        side = quantity.value(problem.numbers(rows.T, ahead, solution.t)) * np.ones(len(rows))
        side = np.where(np.abs(side) <= 1e-12 * np.abs(side).max(), 0.0, side)
        rising = np.diff(np.sign(side)) * _smooth(problem, solution)
        found = np.flatnonzero(rising * section.direction > 0.0 if section.direction else rising)
        if len(found):
            k = int(found[0])
            part = side[k] / (side[k] - side[k + 1])
            direction = section.direction or int(np.sign(side[k + 1] - side[k]))
            time = float(solution.t[k] + part * (solution.t[k + 1] - solution.t[k]))
            return rows[k] + part * (rows[k + 1] - rows[k]), time, replace(section, direction=direction)
        ahead *= 2.0
    way = {1: " upwards", -1: " downwards", 0: ""}[section.direction]
    raise ModelError(f"{problem.c.name}: the motion from x0, v0 does not cross {quantity.text} = 0{way} within "
                     f"{ahead / 2:.3g} s. Give another section, direction or start")  # fmt: skip


def at_event(problem: Problem, event: int, q: Vector, guess: float) -> tuple[Vector, float]:
    """Return the state and the time where an event that does not act first happens."""
    name = problem.c.events[event]
    try:
        times = firings(problem, run(problem, q, problem.t + 2.0 * guess), event, guess)
        if len(times):
            return problem.rows(run(problem, q, float(times[0])))[-1], float(times[0])
    except NoReturnError as error:
        raise ModelError(f"{problem.c.name}: the motion from x0, v0 does not reach {name!r}: {error}") from error
    raise ModelError(f"{problem.c.name}: event {name!r} does not happen within two periods. Begin elsewhere")


def _smooth(problem: Problem, solution: Solution) -> Vector:
    """Return 1 for each step between rows, and 0 where an event acts within it."""
    smooth = np.ones(len(solution.t) - 1)
    for times, acts in zip(solution.t_events or (), problem.c.acting, strict=True):
        if acts:
            smooth[np.clip(np.searchsorted(solution.t, times) - 1, 0, len(smooth) - 1)] = 0.0
    return smooth


def _of_event(problem: Problem, section: Section, q: Vector, solution: Solution) -> tuple[Vector, float] | None:
    """Return a start and a period, or None if the event does not happen often enough."""
    assert section.event is not None
    times, acts = firings(problem, solution, section.event, 0.0), problem.c.acting[section.event]
    if len(times) < section.times + (not acts):
        if solution.stop is StopReason.TERMINAL_EVENT:
            raise NoReturnError(solution.message)
        return None
    if acts:
        return q, float(times[section.times - 1]) - problem.t
    there = problem.rows(run(problem, q, float(times[0])))[-1]
    return there, float(times[section.times] - times[0])


def _nearest(problem: Problem, section: Section, q: Vector, solution: Solution) -> tuple[float, float] | None:
    """Return the relative distance and the period of the nearest return, the first of equals, or None."""
    rows, own = problem.rows(solution), problem.own
    if (np.ptp(rows, axis=0)[own] <= 1e-9 * np.abs(rows).max(axis=0)[own]).all():
        raise NoReturnError("nothing moves, it is an equilibrium")
    scale = problem.scales(rows, problem.t, float(solution.t[-1]) - problem.t)
    scale[: problem.c.n] = np.maximum(np.ptp(rows, axis=0), 1e-300)[: problem.c.n]
    there = ((rows - problem.symmetry(q)) / scale)[:, own]
    flow = (problem.symmetry.G @ problem.flow(q, problem.t, problem.in_mode(solution, problem.t)) / scale)[own]
    if section.place is not None:
        flow = flow * (np.array(own) == section.place)
    side = there @ flow
    if section.quantity is not None:
        side = section.direction * section.quantity.value(problem.numbers(rows.T, 0.0)) * np.ones(len(rows))
    crossings = np.flatnonzero((side[1:-1] < 0.0) & (side[2:] >= 0.0)) + 1
    if not len(crossings):
        return None
    part = side[crossings] / (side[crossings] - side[crossings + 1])
    at = there[crossings] + part[:, None] * (there[crossings + 1] - there[crossings])
    distances = np.linalg.norm(at, axis=1) / np.linalg.norm(there, axis=1).max()
    near = np.flatnonzero(distances <= max(_NEAR, 1.5 * float(distances.min())))
    first = near[0]
    k, step = crossings[first], float(solution.t[1] - solution.t[0])
    return float(distances[first]), float(solution.t[k]) + float(part[first]) * step - problem.t
