"""Newton's method for a motion that closes."""

from dataclasses import dataclass

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from .periodic_problem import Problem
from .quantities import PERIOD, TIME, Quantity
from .returns import NoReturnError, Return, Section, returned

_HALVINGS = 8
"""Number of times that a step is halved before the search ends."""
_UNDECIDED = 0.3
"""Singular values below this part of the distance that is to be closed count less."""
_WORSE = 1.5
"""Growth of the distance in a motion's own units above which a step is halved: it leads to an equilibrium."""
NEXT_TO = 1e-3
"""Part of a period within which a start is next to an event."""
_FREE = 1e-7
"""Singular values below this part of the largest leave a combination of unknowns undetermined."""
_STILL = 1e-6
"""Part of the first motion's extent below which the search has reached an equilibrium."""


@dataclass(frozen=True)
class Unknowns:
    """What is varied: the period or not; kept : places in q that keep their values; all others vary.

    names : of parameters, constant inputs and "t" that vary, too; sizes : by which their changes are measured
    conditions : expressions that are zero at the start
    """

    period: bool
    kept: tuple[int, ...]
    names: tuple[str, ...] = ()
    sizes: tuple[float, ...] = ()
    conditions: tuple[Quantity, ...] = ()


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


def converged(search: Search, first: Return) -> Found:
    """Return the motion that closes near the first one, and meets the conditions."""
    here, extent = first, extent_of(first.problem, first, first.scale)
    with np.errstate(all="ignore"):
        while True:
            problem = here.problem
            if failure := still(problem, here, first, extent):
                return Found(here, failure)
            linear = equations(search, here, first.q)
            ends = linear.distance <= noise(problem, here)
            there, failure = _shorter(search, here, linear)
            if ends:
                better = there is not None and distance(search, there, linear, here.scale) < linear.distance
                last = there if there is not None and better else here
                return Found(last, undetermined(search, last, first.q))
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


@dataclass(frozen=True)
class Changes:
    """What unknowns, in units, change: q (2 n, k) of the start, period (k,), end (2 n, k), values (names, k)."""

    q: Vector
    period: Vector
    end: Vector
    values: Vector


@dataclass(frozen=True)
class Linear:
    """Equations J z = right, in units: the motion closes, places are held, expressions are zero.

    norms : the lengths of the rows of expressions, by which their values are divided
    """

    J: Vector
    right: Vector
    norms: Vector
    changes: Changes

    @property
    def distance(self) -> float:
        """The largest part of what is missing."""
        return float(np.abs(self.right).max(initial=0.0))


def changes_of(search: Search, here: Return, sizes: tuple[float, ...] | None = None) -> Changes:
    """Return what the unknowns change: coordinates of the tangent space, the period, and the names of `by`."""
    given = np.array(search.unknowns.sizes if sizes is None else sizes)
    unit, count = here.scale[list(here.basis.free)], len(given)
    timed = [here.period] * (search.section.event is None and search.unknowns.period)
    k, moved = len(unit) + len(timed), here.shift
    return Changes(
        np.hstack([here.basis.Z * unit, np.zeros((len(here.q), len(timed))), moved.start * given]),
        np.concatenate([here.dt * unit, timed, moved.period * given]),
        np.hstack([here.S * unit + np.outer(here.end_flow, here.dt * unit),
                   np.outer(here.end_flow, timed), moved.end * given]),
        np.hstack([np.zeros((count, k)), np.diag(given)]),
    )  # fmt: skip


def equations(search: Search, here: Return, q0: Vector, sizes: tuple[float, ...] | None = None) -> Linear:
    """Return the equations of a cycle near a motion; q0 has what is kept."""
    problem, scale, changes = here.problem, here.scale, changes_of(search, here, sizes)
    closing = (changes.end - problem.symmetry.G @ changes.q) / scale[:, None]
    kept, rows = held(search, problem), _rows(search, here, changes)
    norms = np.linalg.norm(rows, axis=1)
    if not norms.all():
        names = ", ".join(search.unknowns.names) or "the start"
        raise ModelError(f"{problem.c.name}: {_expressions(search)[int(norms.argmin())].text!r} does not depend on "
                         f"{names}. Leave it out, or name in free what it depends on")  # fmt: skip
    own = problem.own
    J = np.vstack([closing[own], phases(search, here, changes.q), rows / norms[:, None]])
    right = np.zeros(len(J))
    right[: len(own)] = -here.residual[own]
    right[len(own) : len(own) + len(kept)] = [(q0[k] - here.q[k]) / scale[k] for k in kept]
    right[len(J) - len(norms) :] = -_values(search, here) / norms
    return Linear(J, right, norms, changes)


def _expressions(search: Search) -> tuple[Quantity, ...]:
    """Return the expressions that are zero at the start: the section's, conditions."""
    section = search.section.quantity
    return (*([section] if section is not None else []), *search.unknowns.conditions)


def _values(search: Search, here: Return) -> Vector:
    numbers = here.problem.numbers(here.q, here.period)
    return np.array([float(one.value(numbers)) for one in _expressions(search)])


def _rows(search: Search, here: Return, changes: Changes) -> Vector:
    """Return what the unknowns change of each expression."""
    problem, rows = here.problem, []
    numbers = problem.numbers(here.q, here.period)
    known = dict(zip(problem.names, changes.q[problem.places], strict=True)) | {PERIOD: changes.period}
    known |= dict(zip(problem.by, changes.values, strict=True))
    for one in _expressions(search):
        row = np.zeros(changes.q.shape[1])
        for name, slope in one.slopes(numbers).items():
            row += slope * known.get(name, 0.0)
        rows.append(row)
    return np.array(rows).reshape(-1, changes.q.shape[1])


def distance(search: Search, there: Return, linear: Linear, scale: Vector) -> float:
    """Return the largest part of what is missing in a motion, in the units of another one."""
    return float(np.abs(_missing(search, there, linear, scale)).max(initial=0.0))


def _missing(search: Search, there: Return, linear: Linear, scale: Vector) -> Vector:
    """Return the right-hand side of the equations for a motion, in the units of another one."""
    right, own = np.zeros(len(linear.right)), there.problem.own
    right[: len(own)] = -(there.gap / scale)[own]
    right[len(right) - len(linear.norms) :] = -_values(search, there) / linear.norms
    return right


def _solved(problem: Problem, here: Return, J: Vector, right: Vector) -> Vector:
    """Return the shortest z with J z = right; singular values within the errors of runs count as 0."""
    U, s, V = np.linalg.svd(J, full_matrices=False)
    large = s > max(100.0 * problem.rtol * s[0], 1e-8)
    near = _UNDECIDED * size(problem, here)  # within a family, singular values are as small as the residual
    z: Vector = V[large].T @ ((U[:, large].T @ right) * s[large] / (s[large] ** 2 + near**2))
    return z


def undetermined(search: Search, here: Return, q0: Vector) -> str:
    """Return which change of parameters, inputs and the time of the start leaves the equations solved, or ""."""
    names = search.unknowns.names
    if not names:
        return ""
    J = equations(search, here, q0).J
    s, V = np.linalg.svd(J, full_matrices=True)[1:]
    s = np.concatenate([s, np.zeros(len(V) - len(s))])
    for z in V[s <= _FREE * s[0]][:, len(V) - len(names) :]:
        if np.abs(z).max() > _FREE**0.5:
            parts = z * search.unknowns.sizes
            parts = parts / parts[np.abs(parts).argmax()]
            how = [f"{name} by {part:+.4g}" for name, part in zip(names, parts, strict=True) if abs(part) > 1e-6]
            return (f"{', '.join(names)} not determined: to first order the motion still closes, and the conditions "
                    f"hold, after changes in the ratio of {', '.join(how)}. Free one name less, or state another "
                    "condition")  # fmt: skip
    return ""


def held(search: Search, problem: Problem) -> list[int]:
    """Return the places in q that keep their values."""
    section, unknowns = search.section, search.unknowns
    timed = (section.event is None and unknowns.period) or TIME in unknowns.names
    at_section = [section.place] if timed and section.place is not None else []
    return [*unknowns.kept, *problem.free_advance, *at_section]


def phases(search: Search, here: Return, changes: Vector) -> Vector:
    """Return what changes (2 n, k) of the start do to the places that are held, and along the motion."""
    section, unknowns = search.section, search.unknowns
    rows = [changes[k] / here.scale[k] for k in held(search, here.problem)]
    stated = section.place is not None or section.quantity is not None
    if section.event is None and unknowns.period and not stated and not unknowns.kept:
        rows.append(_normal(here.problem, here) @ (changes / here.scale[:, None]))
    return np.array(rows).reshape(-1, changes.shape[1])


def _normal(problem: Problem, here: Return) -> Vector:
    """Return the direction of the motion at the start (2 n,), in units of the scales."""
    normal = np.zeros_like(here.q)
    normal[problem.own] = (here.flow / here.scale)[problem.own]
    return normal / np.linalg.norm(normal)


def _shorter(search: Search, here: Return, linear: Linear) -> tuple[Return | None, str]:
    """Return the motion after the largest step, of those halved, that closes better; or None and why not.

    Where equations leave a choice, as within a family of cycles, the step is the shortest.
    """
    problem, unknowns, section = here.problem, search.unknowns, search.section
    z = _solved(problem, here, linear.J, linear.right)
    timed = section.event is None and unknowns.period
    dT, values = float(linear.changes.period @ z) if timed else 0.0, linear.changes.values @ z
    part = min(1.0, 0.5 * here.period / abs(dT)) if dT else 1.0
    part = min([part, *(0.5 * unit / abs(one) for unit, one in zip(unknowns.sizes, values, strict=True) if one)])
    failure = far = "no step, however short, closes the motion better"
    before = float(np.linalg.norm(z))
    now = np.array([problem.value(name) for name in unknowns.names])
    for _ in range(_HALVINGS):
        try:
            other = problem.with_values(unknowns.names, now + part * values)
            period = other.period(here.period + part * dT)
            q = other.projected(here.q + part * linear.changes.q @ z, other.prepared)
            there = returned(other, section, on_section(other, section, q, period), period)
        except NoReturnError as error:
            failure = str(error)
        else:
            missing = _missing(search, there, linear, here.scale)
            nearer = float(np.linalg.norm(_solved(problem, here, linear.J, missing))) < (1.0 - 0.25 * part) * before
            if nearer and distance(search, there, linear, there.scale) <= _WORSE * linear.distance:
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
