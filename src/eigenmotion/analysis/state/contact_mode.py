"""Contact mode of a state; if modes meet there, the user selects one."""

from collections.abc import Mapping
from typing import Any

from ...arguments.named_values import by_name
from ...codegen.model import ModelError
from ...codegen.model.normalise import real
from ...compiled.projection import Projection
from ...simulation.initial_state.consistency import check_consistent
from .active_contacts import Surfaces, Switch, all_open, holding, in_consistent_mode, switches_of, with_parameters
from .contact_bounds import Bounds, with_most_contacts
from .operating_point import OperatingPoint

_INSIDE = 1e-10
"""Tolerance of gaps, as at the start of a run."""


def in_mode(at: OperatingPoint, mode: Mapping[Any, float] | None) -> OperatingPoint:
    """Return the state in its mode, on the surfaces that it touches.

    Raises
    ------
    ModelError
        The state is inside a contact; modes meet and none is selected; or the selected mode is not consistent.
    EvaluationError
        No mode is consistent.
    """
    named = _named(at, mode)
    check_not_inside(at)
    if not at.model.switches:
        return at
    free = all_open(at)
    check_consistent(free.model, free.prepared, free.t, free.x, free.v)
    chosen, bounds = with_most_contacts(in_consistent_mode(_on_surfaces(at)))
    if named:
        return _consistent(_with_mode(chosen, named))
    if bounds:
        raise ModelError(_meeting(chosen, bounds))
    return chosen


def check_not_inside(at: OperatingPoint) -> None:
    """Raise ModelError for a state inside a contact, or beyond the surface of an impact."""
    if not at.model.acts:
        return
    free = all_open(at)
    if penetrated := at.model.inside(at.t, at.x, at.v, free.prepared, _INSIDE, 0.0 * at.x):
        name, gap = penetrated
        raise ModelError(f"{at.model.name}: x is inside {name!r}, whose gap is {gap:.6g} there and never negative. "
                         "Give a state where it is at least 0")  # fmt: skip


def _on_surfaces(at: OperatingPoint) -> OperatingPoint:
    """Return the state projected onto the surfaces on which it rests, which are closed; removes rounding errors."""
    surfaces = Surfaces(at)
    touching = [*surfaces.closed(), *(one for one in switches_of(at.model) if not one.is_contact)]
    near = [one for one in touching if surfaces.at_rest(one)]
    if not near:
        return at
    there = holding(all_open(at), near)
    x, v = Projection(there.model, there.prepared, there.t, least_norm=True)(at.x, at.v)
    return there.at(at.t, x, v)


def _named(at: OperatingPoint, mode: Mapping[Any, float] | None) -> dict[int, float]:
    """Return the selected values of the mode: index of the parameter -> value."""
    if mode is None:
        return {}
    if not isinstance(mode, Mapping):
        raise ModelError(f"mode is {mode!r}: give a mapping as in Solution.modes")
    names = at.model.parameters
    known = tuple(names[k] for one in switches_of(at.model) for k in (one.holds, one.slides) if k >= 0)
    given = {name: real(value, f"mode {name!r}") for name, value in by_name(mode, known, "name in mode").items()}
    slides = {names[one.slides] for one in switches_of(at.model) if not one.is_contact}
    if wrong := [name for name, value in given.items() if value not in ((-1, 0, 1) if name in slides else (0, 1))]:
        choices = "-1, 0 or 1" if wrong[0] in slides else "0 or 1"
        raise ModelError(f"mode {wrong[0]!r} is {given[wrong[0]]:g}: give {choices}")
    return {names.index(name): value for name, value in given.items()}


def _with_mode(at: OperatingPoint, named: dict[int, float]) -> OperatingPoint:
    """Return the state in the selected mode; contacts and frictions that are not named are unchanged."""
    changes: dict[int, float] = {}
    for one in switches_of(at.model):
        if one.holds not in named and one.slides not in named:
            continue
        changes |= {one.idles: 0.0} | _of_contact(one, named) if one.is_contact else _of_friction(at, one, named)
    there = with_parameters(at, changes)
    loose = [one for one in switches_of(at.model) if one.holds not in named and _is_unloaded(there, one)]
    return with_parameters(there, {one.holds: 0.0 for one in loose})


def _of_contact(one: Switch, named: dict[int, float]) -> dict[int, float]:
    return {one.holds: named[one.holds]}


def _of_friction(at: OperatingPoint, one: Switch, named: dict[int, float]) -> dict[int, float]:
    side = named.get(one.slides, at.prepared.parameters[one.slides])
    holds = named.get(one.holds, 0.0 if side else at.prepared.parameters[one.holds])
    if holds and named.get(one.slides):
        raise ModelError(f"{at.model.name}: mode has {one.words(at.model)} stick and slide. Give one of both")
    return {one.idles: 0.0, one.holds: holds, one.slides: 0.0 if holds else side}


def _is_unloaded(at: OperatingPoint, one: Switch) -> bool:
    """Return whether a holding friction can have no force, because the contact that presses it is open."""
    values = at.prepared.parameters
    if one.is_contact or not values[one.holds]:
        return False
    bounds = Bounds(at)
    force = abs(at.motion[1][one.row]) * bounds.units[one.row]
    return bool(bounds.margins[one] + force <= 1e-9 * bounds.size)


def _consistent(at: OperatingPoint) -> OperatingPoint:
    """Return the state; raise ModelError if its mode is not consistent there."""
    check_consistent(at.model, at.prepared, at.t, at.x, at.v)
    if violations := Bounds(at).violations():
        raise ModelError(
            f"{at.model.name}: the mode that is named does not hold at this state: {'; '.join(violations)}"
        )
    return at


def _meeting(at: OperatingPoint, bounds: list[tuple[Switch, str]]) -> str:
    """Return a message with the possible modes, and how to select one."""
    one, names = bounds[0][0], at.model.parameters
    ways = (
        [{one.holds: 1.0}, {one.holds: 0.0}]
        if one.is_contact
        else [{one.holds: 1.0}, {one.slides: 1.0}, {one.slides: -1.0}]
    )
    possible = [way for way in ways if not Bounds(_with_mode(at, way)).violations()]
    eigenvalue_text = " or ".join(f"{{{names[k]!r}: {value:g}}}" for way in possible for k, value in way.items())
    texts = "; ".join(words for _, words in bounds)
    return (f"{at.model.name}: modes meet at this state: {texts}. On each side of it the equations are others. "
            f"Name the side: mode={eigenvalue_text}")  # fmt: skip
