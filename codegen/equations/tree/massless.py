"""Joints of trees that move no mass, whatever the state: their accelerations are undetermined."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ...bodies.numeric_pivots import pivots
from ...calculus.evaluation import At
from ...graph.store import Node
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
            found = _zero_in_trees(trees, at, [at(size) for size in sizes])
        else:
            found = _zero_pivot(at.rows(M), [at(size) for size in sizes])
        if found is None:
            break
    return found


def _zero_in_trees(trees: Trees, at: At, armature: Sequence[float]) -> int | None:
    """Return a coordinate whose pivot of articulated bodies is zero."""
    for tree in trees.recursions:
        try:
            for k, pivot, size in pivots(tree.dynamics.links, at, [armature[k] for k in tree.numbers]):
                if abs(pivot) <= LEAST * size:
                    return tree.numbers[k]
        except ZeroDivisionError:
            return tree.numbers[0]
    moved = {k for tree in trees.recursions for k in tree.numbers}
    return next((k for k, mass in enumerate(armature) if k not in moved and abs(mass) <= LEAST * mass), None)


def _zero_pivot(M: list[list[float]], sizes: Sequence[float]) -> int | None:
    """Return the first zero pivot of M from the last coordinate on, as from the tips of a tree inwards."""
    for k in reversed(range(len(M))):
        if abs(M[k][k]) <= LEAST * sizes[k]:  # false for a pivot without a value; parameters that are 0 may make it < 0
            return k
        for i in range(k):
            factor = M[i][k] / M[k][k]
            M[i] = [entry - factor * other for entry, other in zip(M[i], M[k], strict=True)]
    return None
