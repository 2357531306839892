"""Orientation without singularities: events at which modified Rodrigues parameters become their shadow set.

Parameters s and -s / |s|^2 are the same rotation (Schaub and Junkins 1996). Those of a spherical or free joint are
replaced by their shadow as |s| passes 1, so that they stay within the unit ball.
"""

from __future__ import annotations

from typing import Any

import sympy

from .recursion_depth import expressions_in
from .statement.event import Event
from .tree.body import ROTATED, Link
from .tree.functions import BodyFunction


def with_shadow_events(fields: dict[str, Any]) -> dict[str, Any]:
    """Add an event for each spherical and free joint of the bodies in a model's expressions."""
    known = [name for name, _ in fields["events"]]  # not yet checked: any objects
    made = tuple((name, event) for name, event in map(_event, _rotated(fields)) if name not in known)
    return fields | {"events": (*fields["events"], *made)} if made else fields


def _rotated(fields: dict[str, Any]) -> list[Link]:
    """Return the bodies with such a joint in the kinetic energy, in the order of the tree."""
    calls = [part for one in expressions_in(fields["kinetic_energy"]) for part in one.atoms(BodyFunction)]
    bodies = dict.fromkeys(body for call in calls for body in call.quantity.bodies)
    own = frozenset(fields["coordinates"])
    return [body for body in bodies if body.joint in ROTATED and own.issuperset(body.coordinates)]


def _event(body: Link) -> tuple[str, Event]:
    s = sympy.Matrix(body.coordinates[-3:])
    rate = sympy.Matrix([one.diff() for one in s])
    square = s.dot(s)
    after = dict(zip(s, -s / square, strict=True))
    after |= dict(zip(rate, -rate / square + 2 * s * s.dot(rate) / square**2, strict=True))
    return f"{body.name} turns to its shadow", Event(square - 1, direction=1, reset=after)
