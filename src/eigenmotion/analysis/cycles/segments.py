"""Multiple shooting: a period in segments, for motions from which deviations grow too fast for one run."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from ...arguments.named_values import Vector
from .newton import Found, Search, extent_of, growth, phases, still
from .periodic_problem import Problem
from .returns import NoReturnError, Return, Section, returned, run

_ITERATIONS = 30
_HALVINGS = 6
_GROWTH = 30.0
"""Growth of deviations in a segment, where their number is chosen."""
_MOST, _PROBES = 100, 10


@dataclass(frozen=True)
class Chain:
    """Motions over the segments of a period, as one.

    parts : a motion from each node; scale : (2 n,) sizes of the whole motion
    gaps : (segments, 2 n) from the end of each to the next node, the last to the image of the first
    """

    parts: tuple[Return, ...]
    scale: Vector
    gaps: Vector

    @property
    def nodes(self) -> tuple[Vector, ...]:
        """The states at which segments start."""
        return tuple(one.q for one in self.parts)

    @property
    def period(self) -> float:
        """The sum of the segments [s]."""
        return sum(one.period for one in self.parts)


def number_of_segments(problem: Problem, one: Return) -> int:
    """Return the number of segments that a motion needs: 1 if one run is enough.

    With forcing, a run that goes astray says little on the motion that is looked for, so its start counts, too.
    """
    largest = growth(one)
    if problem.clock:
        try:
            parts = chain_of(problem, (one.q,) * _PROBES, one.period).parts
            largest = max(largest, float(np.prod([growth(part) for part in parts])))
        except NoReturnError:  # the start alone says nothing
            pass
    return int(min(_MOST, max(1, np.ceil(np.log(largest) / np.log(_GROWTH)))))


def chain_of(problem: Problem, nodes: tuple[Vector, ...], period: float) -> Chain:
    """Return the motions from nodes at equal distances in time.

    Raises
    ------
    NoReturnError
        A run fails.
    """
    length = period / len(nodes)
    parts = []
    for k, node in enumerate(nodes):
        there = replace(problem, t=problem.t + k * length)
        parts.append(returned(there, Section(), there.projected(node, there.prepared), length))
    ends = [*(one.q for one in parts[1:]), problem.symmetry(parts[0].q)]
    gaps = np.array([one.end - end for one, end in zip(parts, ends, strict=True)])
    scale = problem.scales(np.vstack([one.rows for one in parts]), problem.t, period)
    return Chain(tuple(parts), scale, gaps)


def joined(problem: Problem, chain: Chain) -> Return:
    """Return a chain as one motion; its gap is the largest between segments."""
    first, last = chain.parts[0], chain.parts[-1]
    S = first.S
    for one in chain.parts[1:]:
        S = one.S @ S[list(one.basis.free)]
    worst = int(np.abs(chain.gaps / chain.scale)[:, problem.own].max(axis=1).argmax())
    return replace(
        last, problem=first.problem, q=first.q, period=chain.period, scale=chain.scale,
        rows=np.vstack([one.rows for one in chain.parts]), basis=first.basis, S=S, flow=first.flow,
        order=tuple(k for one in chain.parts for k in one.order),
        moments=tuple(one.problem.t - first.problem.t + t for one in chain.parts for t in one.moments),
        drift=np.max([one.drift for one in chain.parts], axis=0), gap=chain.gaps[worst],
        times=np.concatenate([one.times for one in chain.parts]),
    )  # fmt: skip


def found_in_segments(search: Search, first: Return, count: int) -> Found:
    """Return the motion that closes near the first one, by Newton's method for all nodes at once."""
    found = Found(first, "the run cannot be divided")
    for begin in _begins(search.problem, first, count):
        found = _converged(search, begin, first)
        if not found.failure:
            break
    return found


def _begins(problem: Problem, first: Return, count: int) -> Iterator[Chain]:
    """Yield the chain along the motion; with forcing, before it that of the start alone."""
    if problem.clock:
        yield chain_of(problem, (first.q,) * count, first.period)
    times = problem.t + first.period * np.arange(count) / count
    try:
        rows = problem.rows(run(problem, first.q, problem.t + first.period, t_eval=times))
        yield chain_of(problem, tuple(rows), first.period)
    except NoReturnError:  # it leads to where nothing can be evaluated
        return


def _converged(search: Search, here: Chain, first: Return) -> Found:
    problem, count = search.problem, len(here.parts)
    extent = extent_of(problem, first, first.scale)
    failure = f"{_ITERATIONS} steps in {count} segments were not enough"
    for _ in range(_ITERATIONS):
        if words := still(problem, joined(problem, here), first, extent):
            return Found(joined(problem, here), words)
        before = _size(problem, here)
        ends = before <= 100.0 * problem.rtol * max(growth(one) for one in here.parts)
        there = _shorter(search, here)
        if ends:
            there = there if there is not None and _size(problem, there) < before else here
            return Found(joined(problem, there), "", there.nodes)
        if there is None:
            failure = f"no step, however short, closes the motion in {count} segments better"
            break
        here = there
    return Found(joined(problem, here), failure)


def _size(problem: Problem, chain: Chain) -> float:
    return float(np.abs(chain.gaps / chain.scale)[:, problem.own].max())


def _shorter(search: Search, here: Chain) -> Chain | None:
    """Return the chain after the largest step, of those halved, that closes better; or None."""
    changes, dT = _step(search, here)
    before, part = _norm(search.problem, here, here.scale), 1.0
    for _ in range(_HALVINGS):
        try:
            nodes = tuple(one.q + part * change for one, change in zip(here.parts, changes, strict=True))
            there = chain_of(search.problem, nodes, here.period + part * dT)
        except NoReturnError:
            pass
        else:
            if _norm(search.problem, there, here.scale) < (1.0 - 0.25 * part) * before:
                return there
        part *= 0.5
    return None


def _norm(problem: Problem, chain: Chain, scale: Vector) -> float:
    return float(np.linalg.norm((chain.gaps / scale)[:, problem.own]))


def _step(search: Search, here: Chain) -> tuple[list[Vector], float]:
    """Return the changes of all nodes (2 n,), and of the period, that close the linearised motion."""
    problem, m = search.problem, len(here.parts)
    starts = [one.basis.Z * here.scale[list(one.basis.free)] for one in here.parts]
    ends = [one.S * here.scale[list(one.basis.free)] for one in here.parts]
    first = np.cumsum([0, *(len(one.T) for one in starts)])
    timed = search.unknowns.period
    every = [*range(problem.c.n_coordinates), *range(problem.c.n, 2 * problem.c.n)]
    rows, right = [], []
    for k, one in enumerate(here.parts):
        kept = every if k < m - 1 else problem.own
        row = np.zeros((2 * problem.c.n, first[-1] + timed))
        row[:, first[k] : first[k + 1]] += ends[k]
        after, image = (k + 1, starts[(k + 1) % m]) if k < m - 1 else (0, problem.symmetry.G @ starts[0])
        row[:, first[after] : first[after + 1]] -= image
        if timed:
            row[:, -1] = one.end_flow * one.period
        rows.append((row / here.scale[:, None])[kept])
        right.append(-(here.gaps[k] / here.scale)[kept])
    held = phases(search, here.parts[0], starts[0])
    rows.append(np.hstack([held, np.zeros((len(held), first[-1] + timed - len(held.T)))]))
    z = np.linalg.lstsq(np.vstack(rows), np.concatenate([*right, np.zeros(len(held))]), rcond=1e-10)[0]
    changes = [start @ z[a:b] for start, a, b in zip(starts, first[:-1], first[1:], strict=True)]
    return changes, float(z[-1] * here.period) if timed else 0.0
