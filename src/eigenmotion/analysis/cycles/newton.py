"""Newton's method for a motion that closes."""

from dataclasses import dataclass

import numpy as np

from ...arguments.named_values import Vector
from .periodic_problem import Problem
from .returns import NoReturnError, Return, Section, returned

_HALVINGS = 8
"""Number of times that a step is halved before the search ends."""
_UNDECIDED = 0.3
"""Singular values below this part of the distance that is to be closed count less."""
_WORSE = 1.5
"""Growth of the distance in a motion's own units above which a step is halved: it leads to an equilibrium."""
NEXT_TO = 1e-3
"""Part of a period within which a start is next to an event."""
_STILL = 1e-6
"""Part of the first motion's extent below which the search has reached an equilibrium."""


@dataclass(frozen=True)
class Unknowns:
    """What is varied: the period or not; kept : places in q that keep their values; all others vary."""

    period: bool
    kept: tuple[int, ...]


@dataclass(frozen=True)
class Search:
    """A cycle as a problem: the equations that it solves."""

    problem: Problem
    section: Section
    unknowns: Unknowns


@dataclass(frozen=True)
class Found:
    """The last motion of a search, "" or why it failed, and the states at which its segments start, if it has some."""

    last: Return
    failure: str
    nodes: tuple[Vector, ...] = ()


def converged(problem: Problem, section: Section, unknowns: Unknowns, first: Return) -> Found:
    """Return the motion that closes near the first one."""
    here, q0, extent = first, first.q, extent_of(problem, first, first.scale)
    with np.errstate(all="ignore"):
        while True:
            if failure := still(problem, here, first, extent):
                return Found(here, failure)
            J, right = equations(problem, section, unknowns, here, q0)
            ends = size(problem, here) <= noise(problem, here)
            there, failure = _shorter(problem, section, here, step(problem, here, J, right), J)
            if ends:
                better = there is not None and size(problem, there) < size(problem, here)
                return Found(there if there is not None and better else here, "")
            if there is None:
                return Found(here, failure)
            here = there


def size(problem: Problem, one: Return) -> float:
    """Return the largest distance by which a motion does not close, relative to its sizes."""
    return float(np.abs(one.residual[problem.own]).max())


def growth(one: Return) -> float:
    """Return the largest factor of deviations in the period, at least 1."""
    free = list(one.basis.free)
    return max(1.0, float(np.linalg.norm(one.S / one.scale[:, None] * one.scale[free], 2)))


def noise(problem: Problem, one: Return) -> float:
    """Return the distance that errors of the run alone may cause."""
    return 100.0 * problem.rtol * growth(one)


def step(problem: Problem, here: Return, J: Vector, right: Vector) -> tuple[Vector, float]:
    """Return the changes of q (2 n,), along the constraints, and of the period, that close the linearised motion.

    Where they leave a choice, as within a family of cycles, the change is the smallest.
    """
    z = _solved(problem, here, J, right)
    unit, k = here.scale[list(here.basis.free)], here.basis.Z.shape[1]
    return here.basis.Z @ (z[:k] * unit), float(z[k] * here.period) if len(z) > k else 0.0


def _solved(problem: Problem, here: Return, J: Vector, right: Vector) -> Vector:
    """Return the shortest z with J z = right; singular values within the errors of runs count as 0."""
    U, s, V = np.linalg.svd(J, full_matrices=False)
    large = s > max(100.0 * problem.rtol * s[0], 1e-8)
    near = _UNDECIDED * size(problem, here)  # within a family, singular values are as small as the residual
    z: Vector = V[large].T @ ((U[:, large].T @ right) * s[large] / (s[large] ** 2 + near**2))
    return z


def equations(
    problem: Problem, section: Section, unknowns: Unknowns, here: Return, q0: Vector
) -> tuple[Vector, Vector]:
    """Return J and r of J z = r, in units of the scales: the motion closes, its phase, what is kept."""
    Z, unit, scale = here.basis.Z, here.scale[list(here.basis.free)], here.scale
    closing = here.S - problem.symmetry.G @ Z
    if section.event is not None:
        closing = closing + np.outer(here.end_flow, here.dt)
    columns = [closing / scale[:, None] * unit]
    timed = section.event is None and unknowns.period
    if timed:
        columns.append((here.end_flow * here.period / scale)[:, None])
    J, right = np.hstack(columns)[problem.own], -here.residual[problem.own]
    kept = held(problem, section, unknowns)
    lower = phases(problem, section, unknowns, here, Z * unit)
    values = np.zeros(len(lower))
    values[: len(kept)] = [(q0[k] - here.q[k]) / scale[k] for k in kept]
    lower = np.hstack([lower, np.zeros((len(lower), int(timed)))])
    return np.vstack([J, lower]), np.concatenate([right, values])


def held(problem: Problem, section: Section, unknowns: Unknowns) -> list[int]:
    """Return the places in q that keep their values."""
    timed = section.event is None and unknowns.period
    at_section = [section.place] if timed and section.place is not None else []
    return [*unknowns.kept, *problem.free_advance, *at_section]


def phases(problem: Problem, section: Section, unknowns: Unknowns, here: Return, changes: Vector) -> Vector:
    """Return what changes (2 n, k) of the start do to the places that are held, and along the motion."""
    rows = [changes[k] / here.scale[k] for k in held(problem, section, unknowns)]
    if section.event is None and unknowns.period and section.place is None and not unknowns.kept:
        rows.append(_normal(problem, here) @ (changes / here.scale[:, None]))
    return np.array(rows).reshape(-1, changes.shape[1])


def _normal(problem: Problem, here: Return) -> Vector:
    """Return the direction of the motion at the start (2 n,), in units of the scales."""
    normal = np.zeros_like(here.q)
    normal[problem.own] = (here.flow / here.scale)[problem.own]
    return normal / np.linalg.norm(normal)


def _shorter(
    problem: Problem, section: Section, here: Return, change: tuple[Vector, float], J: Vector
) -> tuple[Return | None, str]:
    """Return the motion after the largest step, of those halved, that closes better; or None and why not."""
    dq, dT = change
    part = min(1.0, 0.5 * here.period / abs(dT)) if dT else 1.0
    failure = far = "no step, however short, closes the motion better"
    before = _correction(problem, here, here, J)
    for _ in range(_HALVINGS):
        try:
            q = on_section(problem, section, problem.projected(here.q + part * dq, problem.prepared), here.period)
            there = returned(problem, section, q, here.period + part * dT)
        except NoReturnError as error:
            failure = str(error)
        else:
            nearer = _correction(problem, there, here, J) < (1.0 - 0.25 * part) * before
            if nearer and size(problem, there) <= _WORSE * size(problem, here):
                return there, ""
            failure = far
        if problem.count.spent:
            return None, f"{problem.count.most} runs were not enough; begin nearer, or give max_runs"
        part *= 0.5
    return None, failure


def on_section(problem: Problem, section: Section, q: Vector, period: float) -> Vector:
    """Return a start next to an event moved along the motion to it, so that it does not happen again at once."""
    if section.event is None:
        return q
    ahead = 1e-6 * period
    for _ in range(2):
        flow = problem.flow(q, problem.t, problem.prepared)
        now, then = (problem.event(one, section.event) for one in (q, q + ahead * flow))
        after = -now * ahead / (then - now)
        if not abs(after) < NEXT_TO * period:
            return q
        q = q + after * flow
    return q


def _correction(problem: Problem, there: Return, here: Return, J: Vector) -> float:
    """Return the length of the next step with the derivatives of another motion: a distance in all units alike."""
    right = np.zeros(len(J))
    gap = (there.gap / here.scale)[problem.own]
    right[: len(gap)] = -gap
    return float(np.linalg.norm(_solved(problem, here, J, right)))


def extent_of(problem: Problem, one: Return, scale: Vector) -> float:
    return float(np.abs((one.rows - one.rows[0]) / scale)[:, problem.own].max())


def still(problem: Problem, here: Return, first: Return, extent: float) -> str:
    """Return that there is no motion, or ""."""
    n = problem.c.n
    moved = np.ptp(here.rows, axis=0)[problem.own]
    if (moved <= 1e-9 * np.abs(here.rows).max(axis=0)[problem.own]).all():
        steady = f"; {', '.join(problem.c.coordinates[k % n] for k in problem.free_advance)} advances steadily"
        return f"no cycle: nothing moves, this is an equilibrium{steady if problem.free_advance else ''}"
    if extent_of(problem, here, first.scale) < _STILL * extent:
        return "no cycle: the search ends at an equilibrium. Begin farther from it"
    if here.period < _STILL * first.period:
        return "no cycle: the period shrinks to zero. Begin elsewhere, or give a section"
    return ""
