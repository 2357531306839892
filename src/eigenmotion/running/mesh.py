"""Steps along what a run went through, for linear equations beside it: collocation at eight nodes, Radau IIA."""

from collections.abc import Callable
from itertools import pairwise
from math import ceil
from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from ..arguments.names import Vector
from .path import Path

NODES = 8
_BESIDE = 1e-9
"""Of the time between two stops: how far from an event steps begin and end (em_variation_events.h)."""


class Mesh(NamedTuple):
    """Steps between the stops of a path: its start, its events and its end.

    stops : (stops,) nodes of the path; steps_after : (stops,) how many steps follow each; start, end : (steps,)
    """

    stops: NDArray[np.int_]
    steps_after: NDArray[np.int_]
    start: Vector
    end: Vector

    def at_nodes(self, state: Callable[[Vector], Vector]) -> Vector:
        """Return a motion's z (2 n,) at the nodes, (steps, nodes, 2 n)."""
        t = self.start[:, None] + PLACE * (self.end - self.start)[:, None]
        t[:, -1] = self.end
        return state(t.ravel()).reshape(len(t), NODES, -1)

    def halved(self, which: NDArray[np.bool_]) -> "Mesh":
        """Return it with some steps as two."""
        middle = (self.start + self.end) / 2
        at = np.flatnonzero(which)
        owner = np.repeat(np.arange(len(self.stops)), self.steps_after)
        after = self.steps_after + np.bincount(owner[at], minlength=len(self.stops))
        return Mesh(self.stops, after, np.insert(self.start, at + 1, middle[at]), np.insert(self.end, at, middle[at]))


def mesh_of(path: Path, steps: Vector, kinks: Vector, together: float) -> Mesh:
    """Return one step for so many `together` of the run's, which end at times `steps`; none goes across a kink."""
    t = path.t
    steps = steps[::-1] if len(steps) and steps[-1] < steps[0] else steps
    if not (len(path.mark_row) or len(kinks)) and len(t) > 1:  # as most runs are
        e = _edges(t[0], t[-1], False, False, steps, kinks, together)
        return Mesh(np.array([0, len(t) - 1]), np.array([len(e) - 1, 0]), e[:-1], e[1:])
    marked = np.zeros(len(t), dtype=bool)
    marked[path.mark_row] = True
    made = np.append(False, t[1:] == t[:-1])  # by events that act
    stops = marked | made
    stops[[0, -1]] = True
    stops = np.flatnonzero(stops)
    edges = [_edges(t[a], t[b], marked[a] or made[a], marked[b], steps, kinks, together)
             for a, b in pairwise(stops)]  # fmt: skip
    after = np.array([*(len(one) - 1 for one in edges), 0], dtype=int)
    nothing = np.empty(0)
    return Mesh(stops, after, np.concatenate([nothing, *(one[:-1] for one in edges)]),
                np.concatenate([nothing, *(one[1:] for one in edges)]))  # fmt: skip


def _edges(a: float, b: float, leaves: bool, meets: bool, steps: Vector, kinks: Vector, together: float) -> Vector:
    """Return where steps between two stops begin and end, (k,): as many of the run's in each as in the others."""
    if a == b:
        return np.array([a])
    low, high = min(a, b), max(a, b)
    least = 1e-6 * (high - low)
    ends = np.concatenate([[low], steps[slice(*steps.searchsorted((low + least, high - least)))], [high]])
    within = ends[1:-1] if together == 1.0 else _spaced(ends, ceil((len(ends) - 1) / together))
    first, last = a + _BESIDE * (b - a) if leaves else a, b - _BESIDE * (b - a) if meets else b
    if len(kinks):  # those beside an event are seen there
        within = np.unique(np.concatenate([within, kinks[(kinks > min(first, last)) & (kinks < max(first, last))]]))
    return np.concatenate([[first], within if a < b else within[::-1], [last]])


def _spaced(ends: Vector, made: int) -> Vector:
    """Return where so many steps meet, (made - 1,), that are as many of those between `ends` each, or part of one."""
    place = np.arange(1, made) * ((len(ends) - 1) / made)
    before = place.astype(int)
    return np.asarray(ends[before] + (place - before) * (ends[before + 1] - ends[before]))


def _lagrange(x: Vector) -> Vector:
    """Return the polynomials (..., nodes) that are 1 at one node and 0 at the others."""
    apart = PLACE[:, None] - PLACE + np.eye(NODES)
    factors = (x[..., None, None] - PLACE) / apart
    factors[..., np.eye(NODES, dtype=bool)] = 1.0
    return np.asarray(factors.prod(axis=-1))


def weights(x: Vector) -> tuple[Vector, Vector]:
    """Return b, b2 (k, nodes): integrals from 0 to x (k,) of what has such values at the nodes, once and twice."""
    values = _lagrange(x[:, None] * _POINTS)  # (k, points, nodes)
    once = x[:, None] * np.einsum("q,kqj->kj", _GAUSS, values)
    twice = x[:, None] ** 2 * np.einsum("q,kqj->kj", _GAUSS * (1 - _POINTS), values)
    return once, twice


def _places() -> Vector:
    """Return the nodes: 1 and where P_8 - P_7 vanishes else."""
    difference = np.zeros(NODES + 1)
    difference[-2:] = -1.0, 1.0
    x = np.sort(legendre.legroots(difference))
    x[-1] = 1.0
    for _ in range(3):
        x[:-1] -= legendre.legval(x[:-1], difference) / legendre.legval(x[:-1], legendre.legder(difference))
    return np.asarray((x + 1) / 2)


_POINTS, _GAUSS = ((points + 1 - k) / 2 for k, points in enumerate(legendre.leggauss(NODES)))
PLACE = _places()
A, A2 = weights(PLACE)
