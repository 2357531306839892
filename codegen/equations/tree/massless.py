"""Joints of trees that move no mass, whatever the state: their accelerations are undetermined."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ...bodies.numeric_pivots import NumericLink, pivots
from ...calculus.evaluation import At
from ...graph.store import Node
from .link_table import LinkTable
from .separation import Trees

LEAST = 1e-12
"""A pivot smaller than this part of what the joint carries is zero."""
_STEP = 0.6180339887498949
"""Coordinates are multiples of this, so that no position is special."""
_PLACES = 3
"""Positions at which M has a zero pivot before it counts as singular everywhere."""


def massless(trees: Trees, M: Sequence[Sequence[Node]], x: Sequence[str], constants: Mapping[str, float]) -> int | None:
    """Return the number of a coordinate that moves no mass; None if there is none.

    Parameters
    ----------
    M : (n, n) mass matrix, of the coordinates x (n) and of constants
    constants : parameters -> their default values, 0 for those that are given later
    """
    sizes = [M[k][k] for k in range(len(M))]
    for tree in () if trees.table else trees.recursions:
        for k, size in zip(tree.numbers, tree.dynamics.carried, strict=True):
            sizes[k] = size.node
    given, found = {name: value or 1.0 for name, value in constants.items()} | {"t": 0.0}, None
    for place in range(_PLACES):
        values = [(k + 1 + place * len(x)) * _STEP % 1.0 for k in range(len(x))]
        at = At(trees.graph, given | dict(zip(x, values, strict=True)))
        if trees.table:
            found = _zero_in_table(trees.table, at, values, [at(size) for size in sizes])
        else:
            found = _zero_pivot(at.rows(M), [at(size) for size in sizes])
        if found is None:
            break
    return found


def _zero_in_table(table: LinkTable, at: At, x: Sequence[float], armature: Sequence[float]) -> int | None:
    """Return the last coordinate whose pivot of articulated bodies is zero."""
    rows = [NumericLink(row.parent, row.joint, row.coordinates, [at(one) for one in row.numbers]) for row in table.rows]
    moved = {k for row in rows for k in row.coordinates}
    found = pivots(rows, x, armature)
    judged = [found[k] if k in moved else (mass, mass) for k, mass in enumerate(armature)]
    return next((k for k in reversed(range(len(x))) if abs(judged[k][0]) <= LEAST * judged[k][1]), None)


def _zero_pivot(M: list[list[float]], sizes: Sequence[float]) -> int | None:
    """Return the first zero pivot of M from the last coordinate on, as from the tips of a tree inwards."""
    for k in reversed(range(len(M))):
        if abs(M[k][k]) <= LEAST * sizes[k]:  # false for a pivot without a value; parameters that are 0 may make it < 0
            return k
        for i in range(k):
            factor = M[i][k] / M[k][k]
            M[i] = [entry - factor * other for entry, other in zip(M[i], M[k], strict=True)]
    return None
