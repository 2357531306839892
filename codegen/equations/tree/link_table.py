"""Table of the moving bodies of large trees, over which recursions in C loop (include/bodies/em_links.h).

Straight-line code of a recursion runs about twice as fast, but takes a compiler long. Functions that steps call rarely
are therefore loops from LARGE coordinates on. Accelerations are loops where their straight-line code would be longer
than that of LONGEST coordinates without constraint rows: each row adds a pass over the bodies.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ...bodies.frames import matrix, number_of
from ...bodies.links import Moving
from ...bodies.recursion import Dynamics
from ...bodies.scalar import Vector
from ...calculus.evaluation import At
from ...graph.graph import Graph
from ...graph.store import Kind, Node

LARGE = 16
"""Number of coordinates from which energies, mass matrix and bias are computed in loops."""
LARGEST = 64
"""Number of coordinates up to which accelerations are straight-line code, whatever the number of rows."""
LONGEST = 300
"""Number of coordinates, times rows and one, up to which they are, too."""
_UNIT = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


@dataclass(frozen=True, slots=True)
class LinkRow:
    """A moving body.

    parent : its number; -1 for the ground
    joint, coordinates : the kind of the joint, and the numbers of its coordinates in the model
    numbers : nodes of a row of the table: at (3), R (9), ratio, offset, mass, m c (3), J (6), gravity (3)
    """

    parent: int
    joint: str
    coordinates: tuple[int, ...]
    numbers: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class LinkTable:
    """The moving bodies of all trees of a model.

    solves : whether accelerations are computed in loops, too
    yields : whether loops can compute pivots: no bodies have a coordinate in common
    """

    rows: tuple[LinkRow, ...]
    solves: bool
    yields: bool

    @property
    def nodes(self) -> Iterator[Node]:
        """All entries."""
        return (node for row in self.rows for node in row.numbers)


def link_table(trees: Sequence[tuple[Dynamics, Sequence[int], Vector]], rows: int) -> LinkTable | None:
    """Return the table of trees; None if they are small, or have joints that the recursions in C do not know.

    Parameters
    ----------
    trees
        Of each, its recursions, the numbers of its coordinates in the model, and its gravity.
    rows
        Number of constraint rows of the model.
    """
    n = sum(len(numbers) for _, numbers, _ in trees)
    if n < LARGE or any(_is_special(body) for dynamics, _, _ in trees for body in dynamics.links.moving):
        return None
    bodies: list[LinkRow] = []
    for dynamics, numbers, gravity in trees:
        bodies += list(_rows(dynamics, numbers, gravity, len(bodies)))
    yields = not any(dynamics.shared for dynamics, _, _ in trees)
    return LinkTable(tuple(bodies), yields and accelerations_loop(n, rows), yields)


def accelerations_loop(n: int, rows: int) -> bool:
    """Whether accelerations of n coordinates with so many constraint rows are computed in loops."""
    return n > LARGEST and n * (1 + rows) > LONGEST


def _is_special(body: Moving) -> bool:
    """Whether a joint of several coordinates is geared."""
    return len(body.numbers) > 1 and (number_of(body.ratio), number_of(body.offset)) != (1, 0)


def _rows(dynamics: Dynamics, numbers: Sequence[int], gravity: Vector, first: int) -> Iterator[LinkRow]:
    unit = matrix(dynamics.graph, _UNIT)
    for body in dynamics.links.moving:
        at, R = body.frame(unit)
        own = [body.ratio, body.offset, body.inertia.mass, *body.inertia.moment, *body.inertia.J, *gravity]
        entries = [*at, *(entry for row in R for entry in row), *own]
        yield LinkRow(
            body.parent + first if body.parent >= 0 else -1, body.joint, tuple(numbers[k] for k in body.numbers),
            tuple(entry.node for entry in entries),
        )  # fmt: skip


def is_parametric(graph: Graph, *nodes: Node) -> bool:
    """Whether any of these entries of the table depends on parameters."""
    return any(graph.records[one].kind is Kind.SYMBOL for one in graph.reachable(nodes))


def numbers_of(graph: Graph, nodes: Sequence[Node]) -> list[float]:
    """Return the values of entries; 0 of those that depend on parameters."""
    at = At(graph, {})
    return [0.0 if is_parametric(graph, node) else at(node) for node in nodes]
