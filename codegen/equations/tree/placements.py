"""Table of the bodies of a model: their joints, and the numbers that place them on their parents."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import sympy

from ...graph.store import Node
from ...model.recursion_depth import expressions_in
from ...model.statement.mechanism import Mechanism
from ...model.tree.body import Link
from ...model.tree.functions import BodyFunction


@dataclass(frozen=True, slots=True)
class Placement:
    """A body on its parent.

    name : "" for a part of a joint made of several
    parent : its number, less than the body's own; -1 for the ground
    joint, coordinates : the kind of the joint, and the numbers of its coordinates
    frame : the nodes of at, rotation, axis, ratio, offset of `Link`
    """

    name: str
    parent: int
    joint: str
    coordinates: tuple[int, ...]
    frame: tuple[Node, ...]


def placements(model: Mechanism, node: Callable[[sympy.Expr], Node]) -> tuple[Placement, ...]:
    """Return the bodies of which a model contains functions, parents before their children."""
    bodies = tuple(bodies_of(model))
    places = {body: place for place, body in enumerate(bodies)}
    numbers = {q: number for number, q in enumerate(model.coordinates)}
    return tuple(
        Placement("" if body.is_part else body.name, places[body.parent] if body.parent else -1, body.joint,
                  tuple(numbers[q] for q in body.coordinates), tuple(map(node, body.geometry)))
        for body in bodies
    )  # fmt: skip


def bodies_of(model: Mechanism) -> Iterator[Link]:
    """Yield bodies whose joints have coordinates of the model: those of the largest trees first."""
    calls = {call for one in expressions_in(model) for call in one.atoms(BodyFunction)}
    chains = {call.quantity.bodies for call in calls if call.args == call.quantity.variables}
    found, own = set[Link](), frozenset(model.coordinates)
    for chain in sorted(chains, key=lambda chain: (-len(chain), [body.name for body in chain], chain[-1].text)):
        if all(q in own for body in chain for q in body.coordinates):
            yield from (body for body in chain if body not in found)
            found.update(chain)
