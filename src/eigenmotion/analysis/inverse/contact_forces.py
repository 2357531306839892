"""Forces of closed contacts along prescribed motions: contacts push, and frictions stay within their limits."""

from collections.abc import Iterator
from functools import cached_property

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from ...runtime import Actuators
from ...runtime.variations import input_columns, levels, reaction_rows
from ..state.active_contacts import Surfaces, Switch, switches_of
from ..state.operating_point import OperatingPoint
from .actuators import columns_of
from .least_forces import least_forces
from .motion_arguments import Motion

_PLANES = 60
"""Largest number of approximations of cones by planes."""
_WITHIN = 1e-9
"""Part of all reactions by which one may be beyond its bound."""


def with_pushing_contacts(motion: Motion, forces: Vector, multipliers: Vector, of: Actuators) -> tuple[Vector, Vector]:
    """Return forces (k, count) and multipliers (k, m) of rows in one mode, for which all reactions are within bounds.

    Where the given forces, the least without bounds, have a contact pull or a friction take more than its limit, they
    are replaced by the least forces that do not.

    Raises
    ------
    ModelError
        No forces of the actuators give the motion so; names the contact or friction.
    """
    forces, multipliers = forces.copy(), multipliers.copy()
    for row, bounds in _bounds_of(motion):
        if beyond := bounds.beyond(multipliers[row]):
            forces[row], multipliers[row] = _bounded(bounds, motion.a[row], of, beyond[0])
    return forces, multipliers


def check_inside_bounds(motion: Motion, multipliers: Vector) -> None:
    """Raise ModelError if a reaction is at its bound, where the forces of rows in one mode have no derivatives."""
    for row, bounds in _bounds_of(motion):
        if reached := bounds.beyond(multipliers[row], -_WITHIN):
            c = motion.model
            how = "touches without force" if reached[0].is_contact else "is at its limit"
            raise ModelError(f"{c.name}: at t = {bounds.at.t:g} {reached[0].words(c)} {how}, where forces have no "
                             "derivatives")  # fmt: skip


def _bounds_of(motion: Motion) -> Iterator[tuple[int, "Bounds"]]:
    """Yield the bounds of each row in a mode in which contacts or frictions hold."""
    held = [one for one in switches_of(motion.model) if motion.prepared.parameters[one.holds]]
    for row in range(len(motion.t) if held else 0):
        t, x, v, _, u, prepared = motion.arguments
        yield row, Bounds(OperatingPoint(motion.model, prepared, float(t[row]), x[row], v[row], u[row]), held)


def _bounded(bounds: "Bounds", a: Vector, of: Actuators, beyond: Switch) -> tuple[Vector, Vector]:
    """Return the least forces within the bounds. Cones are approximated from outside, by planes where they are left."""
    c, at = bounds.at.model, bounds.at
    equations, weights = _equations(at, a, of), np.array(of.weights or np.ones(len(of.names)))
    G = bounds.linear
    for _ in range(_PLANES):
        found = least_forces(*equations, G, weights)
        if found is None:  # nor are there any within the cones, which lie inside of the planes
            what = "pull" if beyond.is_contact else "take more than its limit"
            raise ModelError(f"{c.name}: at t = {at.t:g} {beyond.words(c)} would have to {what}: no forces of "
                             f"{' and '.join(of.names)} give this motion otherwise.")  # fmt: skip
        left = bounds.beyond(found[1])
        if not left:
            return found
        G = np.vstack([G, *(bounds.plane(one, found[1]) for one in left)])
    raise ModelError(
        f"{c.name}: at t = {at.t:g} the least forces within the cone of {beyond.words(c)} were not found with "
        f"{_PLANES} planes. Name other actuators, or state the contact as a constraint."
    )


def _equations(at: OperatingPoint, a: Vector, of: Actuators) -> tuple[Vector, Vector, Vector]:
    """Return B (n, count), P (m, n) and r (n,) of B tau - P^T lambda = r, in units in which M has a unit diagonal."""
    c, n, u = at.model, at.model.n_coordinates, at.u.copy()
    u[[c.inputs.index(name) for name in of.names if name in c.inputs]] = 0.0
    unit = 1.0 / np.sqrt(np.diag(c.factored_matrix(at.t, at.x, at.prepared))[:n])
    B = columns_of(c, of, input_columns(c, at.t, at.x, at.v, a, at.prepared, u)[:n])
    rows = (np.array([at.t]), at.x[None], at.v[None], a[None], u[None])
    r = c.required_rows(*rows, at.prepared)[0][0, :n]
    P = reaction_rows(c, at.t, at.x, at.v, at.prepared, at.u)[0][: c.m, :n]
    return B * unit[:, None], P * unit, r * unit


class Bounds:
    """The bounds of the reactions of contacts and frictions that hold, at one state."""

    def __init__(self, at: OperatingPoint, held: list[Switch]) -> None:
        self.at, self.held, self.surfaces = at, held, Surfaces(at)

    @cached_property
    def limits(self) -> dict[Switch, Vector]:
        """Friction that sticks, pressed by a contact -> l (m,): its limit is l.lambda."""
        at, every = self.at, switches_of(self.at.model)
        level = levels(at.model, at.t, at.x, at.v, at.prepared, at.u).max(axis=1)
        unit = np.eye(at.model.m)
        return {one: -level[every.index(one)] * unit[every[one.over].row] for one in self.held if not one.is_contact}

    @cached_property
    def linear(self) -> Vector:
        """G (bounds, m) of G lambda >= 0, of all but cones."""
        rows = []
        for one in self.held:
            own = np.eye(self.at.model.m)[one.row]
            if one.is_contact:
                rows.append(-own)
            elif one.shift < 0:
                rows += [self.limits[one] + own, self.limits[one] - own]
        return np.array(rows)

    def plane(self, one: Switch, multipliers: Vector) -> Vector:
        """Return G (m,) of the plane that touches the cone of a friction in the direction of its force."""
        own, row = multipliers[one.row : one.row + 2], self.limits[one].copy()
        row[one.row : one.row + 2] -= own / np.linalg.norm(own)
        return row

    def beyond(self, multipliers: Vector, within: float = _WITHIN) -> list[Switch]:
        """Return the contacts and frictions whose reactions are beyond their bounds by more than a part of all."""
        units = self.surfaces.units
        size = float(np.abs(multipliers * units).max(initial=0.0)) + self.surfaces.push
        return [one for one in self.held if units[one.row] * self._margin(one, multipliers) < -within * size]

    def _margin(self, one: Switch, multipliers: Vector) -> float:
        if one.is_contact:
            return -float(multipliers[one.row])
        own = multipliers[one.row : one.row + (2 if one.shift >= 0 else 1)]
        return float(self.limits[one] @ multipliers - np.linalg.norm(own))
