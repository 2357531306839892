"""Margins of the contact and friction forces of a state from their bounds, and states between two modes."""

from collections.abc import Iterator
from functools import cached_property

import numpy as np

from .active_contacts import Surfaces, Switch, holding, switches_of, with_parameters
from .operating_point import OperatingPoint

_AT_BOUND = 1e-9
"""A force counts as zero, or as at its limit, within this part of the acting forces."""


class Bounds:
    """Margins of the forces of active contacts and frictions from their bounds, in units of the acting forces.

    Contact forces push; friction forces are below their limit. If rows depend on each other, the forces are not unique,
    and any possible distribution counts. The conditions are concave in the forces, so each may be met by another one.
    """

    def __init__(self, at: OperatingPoint) -> None:
        self.at = at
        self.surfaces = Surfaces(at)
        self.units = self.surfaces.units
        self.size = self.surfaces.push + float(np.abs(at.motion[1] * self.units).sum())

    def _margins(self, at: OperatingPoint) -> dict[Switch, float]:
        """Return the margins of active contacts and frictions at a state."""
        values = at.prepared.parameters
        watched = at.model.event_rows(np.array([at.t]), at.x[None], at.v[None], at.u[None], at.prepared)[0]
        return {one: float(watched[one.event] * self.units[one.row])
                for one in switches_of(at.model) if values[one.holds] and not values[one.idles]}  # fmt: skip

    @cached_property
    def own(self) -> dict[Switch, float]:
        """The margins with the forces of the state."""
        return self._margins(self.at)

    @cached_property
    def margins(self) -> dict[Switch, float]:
        """The margins of all active contacts and frictions, also idle ones, with the best distribution of forces."""
        values = self.at.prepared.parameters
        own, idle = self.own, [one for one in switches_of(self.at.model) if values[one.idles]]
        if not idle:
            return own
        shared = self._margins(holding(self.at, idle))
        return {one: max(own.get(one, 0.0), shared[one]) for one in shared}

    def at_bound(self) -> Iterator[tuple[Switch, str]]:
        """Yield the contacts and frictions at a bound, where nearby states have other modes, with a description."""
        within = _AT_BOUND * self.size
        for one, margin in self.margins.items():
            if margin <= within:
                texts = "touches without force" if one.is_contact else "is at its limit"
                yield one, f"{one.words(self.at.model)} {texts}"
        yield from self._at_rest_without_row(within)

    def _at_rest_without_row(self, within: float) -> Iterator[tuple[Switch, str]]:
        values, closed = self.at.prepared.parameters, self.surfaces.closed()
        along = self.surfaces.accelerations(self.at.motion[0])
        for one in switches_of(self.at.model):
            if values[one.holds] or values[one.idles] or not self.surfaces.at_rest(one):
                continue
            still = abs(along[one.row]) <= within * max(self.units[one.row], np.finfo(float).tiny)
            if one.is_contact and one in closed and still:
                yield one, f"{one.words(self.at.model)} touches without force"
            elif not one.is_contact and values[one.slides]:
                how = "is at its limit" if still else "has no slip and begins to slide"
                yield one, f"{one.words(self.at.model)} {how}"

    def violations(self) -> list[str]:
        """Return descriptions of the conditions that the mode violates; [] if it is consistent."""
        within, model = _AT_BOUND * self.size, self.at.model
        values, closed = self.at.prepared.parameters, self.surfaces.closed()
        along, rate = self.surfaces.accelerations(self.at.motion[0]), self.surfaces.rates[0]
        texts = []
        for one in switches_of(model):
            if one in self.margins and self.margins[one] < -within:
                texts.append(f"{one.words(model)} would {'pull' if one.is_contact else 'take more than its limit'}")
            side = 1.0 if one.is_contact else float(values[one.slides])
            if values[one.holds] or values[one.idles] or not side or (one.is_contact and one not in closed):
                continue
            moves = side * (along[one.row] if self.surfaces.at_rest(one) else rate[one.row])
            if moves < (-within * self.units[one.row] if self.surfaces.at_rest(one) else 0.0):
                texts.append(f"{one.words(model)} would {self._instead(one)}")
        texts += [f"{one.words(model)} would stick or slide" for one in _off(self.at) if _acts(self.at, one)]
        return texts

    def _instead(self, one: Switch) -> str:
        """Return what a contact does that should be open, or a friction that should slide to the named side."""
        if one.is_contact:
            return "close"
        if self.surfaces.at_rest(one) and Bounds(holding(self.at, [one])).margins[one] > _AT_BOUND * self.size:
            return "stick"
        return "slide the other way"


def _off(at: OperatingPoint) -> list[Switch]:
    """Return the frictions that neither stick nor slide."""
    values = at.prepared.parameters
    return [one for one in switches_of(at.model) if not one.is_contact and not any(values[k] for k in one.modes)]


def _acts(at: OperatingPoint, one: Switch) -> bool:
    """Return whether a friction has a force at the state or beside it, that is, whether its limit is above 0 there."""
    turned = {one.shift: 1.0, one.shift + 1: 0.0} if one.shift >= 0 else {}
    off = with_parameters(at, dict.fromkeys(one.parameters, 0.0))
    on = with_parameters(off, {one.slides: 1.0} | turned)
    varies = slice(2 * at.model.n + at.model.n_inputs)
    without, with_it = (np.column_stack([there.motion[0], there.motion[2][:, varies]]) for there in (off, on))
    return not np.array_equal(with_it, without)


def without_zero_frictions(at: OperatingPoint) -> OperatingPoint:
    """Return the state without the frictions whose limit is 0 there and beside it: they neither stick nor slide."""
    frictions = [one for one in switches_of(at.model) if not one.is_contact and one not in _off(at)]
    zero = [one for one in frictions if not _acts(at, one)]
    return with_parameters(at, {k: 0.0 for one in zero for k in one.parameters}) if zero else at


def with_most_contacts(at: OperatingPoint) -> tuple[OperatingPoint, list[tuple[Switch, str]]]:
    """Return the state in the mode with as many active contacts as possible, and a description of those at a bound.

    For example, a beam on three supports may rest on one of them and touch the others without force, or rest on all
    three with forces.
    """
    if not at.model.switches:
        return at, []
    at = without_zero_frictions(at)
    bounds, values = Bounds(at), at.prepared.parameters
    bounded = list(bounds.at_bound())
    loose = [one for one, _ in bounded if not values[one.holds]]
    if not loose:
        return at, bounded
    all_of_them = Bounds(holding(at, loose))
    moves = np.abs(bounds.surfaces.accelerations(all_of_them.at.motion[0] - at.motion[0]))
    margins = {one: max(bounds.margins.get(one, 0.0), margin) for one, margin in all_of_them.margins.items()}
    within = _AT_BOUND * bounds.size
    if (moves > within * bounds.units).any() or min(margins.values()) <= within:
        return at, bounded
    return all_of_them.at, []


def sticking(at: OperatingPoint) -> OperatingPoint:
    """Return the state with all frictions without slip sticking, also those at their limit."""
    values, surfaces = at.prepared.parameters, Surfaces(at)
    slides = [
        one
        for one in switches_of(at.model)
        if not one.is_contact and values[one.slides] and not values[one.idles] and surfaces.at_rest(one)
    ]
    there = holding(at, slides)
    return there if slides and not Bounds(there).violations() and is_within(there) else at


def is_within(at: OperatingPoint) -> bool:
    """Return whether the forces of a state, as its rows share them, are within all bounds."""
    bounds = Bounds(at)
    return all(margin >= -_AT_BOUND * bounds.size for margin in bounds.own.values())
