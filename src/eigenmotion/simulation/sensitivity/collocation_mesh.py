"""Mesh of the variational equations along a run, and their collocation (Radau IIA with eight nodes)."""

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from ...arguments.named_values import Vector
from .run_path import Path

NODES = 8
_BESIDE = 1e-9
"""Distance of spans from an event, relative to the time between two stops (em_variation_events.h)."""


class Mesh(NamedTuple):
    """Spans between the stops of a path, which are its start, its events and its end. No span contains a kink.

    stops : (stops,) nodes of the path; spans_after : (stops,) number of spans after each; start, end : (spans,)
    """

    stops: NDArray[np.int_]
    spans_after: NDArray[np.int_]
    start: Vector
    end: Vector


def mesh_of(path: Path, kinks: Vector) -> Mesh:
    """Return the mesh of a path, with no kink inside a span."""
    t = path.t
    if not (len(path.mark_row) or len(kinks)) and len(t) > 1:  # most runs
        e = _edges(t[0], t[-1], False, False, kinks)
        return Mesh(np.array([0, len(t) - 1]), np.array([len(e) - 1, 0]), e[:-1], e[1:])
    marked = np.zeros(len(t), dtype=bool)
    marked[path.mark_row] = True
    acted = np.append(False, t[1:] == t[:-1])  # nodes after event actions
    stops = marked | acted
    stops[[0, -1]] = True
    stops = np.flatnonzero(stops)
    edges = [_edges(t[a], t[b], marked[a] or acted[a], marked[b], kinks) for a, b in pairwise(stops)]
    after = np.array([*(len(one) - 1 for one in edges), 0], dtype=int)
    nothing = np.empty(0)
    return Mesh(stops, after, np.concatenate([nothing, *(one[:-1] for one in edges)]),
                np.concatenate([nothing, *(one[1:] for one in edges)]))  # fmt: skip


def _edges(a: float, b: float, leaves: bool, meets: bool, kinks: Vector) -> Vector:
    """Return the ends (k,) of the spans between two stops."""
    if a == b:
        return np.array([a])
    first, last = a + _BESIDE * (b - a) if leaves else a, b - _BESIDE * (b - a) if meets else b
    within = kinks[(kinks > min(first, last)) & (kinks < max(first, last))]  # kinks at an event are treated there
    return np.concatenate([[first], within if a < b else within[::-1], [last]])


def _places() -> Vector:
    """Return the Radau nodes in (0, 1]: 1, and the other zeros of P_8 - P_7."""
    difference = np.zeros(NODES + 1)
    difference[-2:] = -1.0, 1.0
    x = np.sort(legendre.legroots(difference))
    x[-1] = 1.0
    for _ in range(3):
        x[:-1] -= legendre.legval(x[:-1], difference) / legendre.legval(x[:-1], legendre.legder(difference))
    return np.asarray((x + 1) / 2)


PLACE = _places()
SERIES = np.linalg.inv(legendre.legvander(2.0 * PLACE - 1.0, NODES - 1))
"""(terms, nodes): the coefficients of the Legendre series on [0, 1] of a function from its values at the nodes."""
A, A2 = (legendre.legval(2.0 * PLACE - 1.0, legendre.legint(SERIES, order, lbnd=-1, scl=0.5)).T for order in (1, 2))
"""(nodes, nodes): weights of the first and the second integral from 0 to each node of values at the nodes."""
