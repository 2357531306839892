"""Limits of the contact mode of an equilibrium: forces, gaps and slips that keep their signs along a branch."""

from collections.abc import Callable
from typing import NamedTuple

from ...arguments.named_values import Vector
from ..state.active_contacts import Surfaces, Switch, switches_of
from ..state.contact_bounds import Bounds
from ..state.operating_point import OperatingPoint
from .curve import MODE, Meeting

_WHY = "so the equilibria beyond are in another contact mode. Find one there, and follow it"


class Limit(NamedTuple):
    """What ends the mode of a contact or a friction."""

    switch: Switch
    words: str


def limits_of(at: OperatingPoint) -> dict[Limit, float]:
    """Return what a mode rests on, with values that are positive in it."""
    if not at.model.switches:
        return {}
    surfaces, values = Surfaces(at), at.prepared.parameters
    found = {Limit(one, "opens: its force is zero" if one.is_contact else "begins to slide: it is at its limit"):
             margin for one, margin in Bounds(at).margins.items()}  # fmt: skip
    gaps, rates = surfaces.gaps[0], surfaces.rates[0]
    for one in switches_of(at.model):
        if values[one.holds] or values[one.idles]:
            continue
        if one.is_contact:
            found[Limit(one, "closes: its gap is zero")] = float(gaps[one.row])
        elif values[one.slides]:
            found[Limit(one, "ceases to slide: its slip is zero")] = float(values[one.slides] * rates[one.row])
    return found


def reached_limit(before: OperatingPoint, after: OperatingPoint) -> Limit | None:
    """Return the limit that is passed between two equilibria, the nearest if there are several; or None."""
    first, second = limits_of(before), limits_of(after)
    passed = {one: first.get(one, 0.0) / (first.get(one, 0.0) - value) for one, value in second.items() if value < 0.0}
    return min(passed, key=lambda one: passed[one]) if passed else None


def meeting_at(limit: Limit, at: OperatingPoint, point: Callable[[Vector], OperatingPoint]) -> Meeting:
    """Return the change of the contact mode at a limit; `point` returns the state at a place of the curve."""

    def value(w: Vector) -> float:
        return limits_of(point(w)).get(limit, 0.0)

    words = f"{limit.switch.words(at.model)} {limit.words}"
    return Meeting(MODE, (at.model.events[limit.switch.event],), words, _WHY, lambda w: value(w) > 0.0, value)
