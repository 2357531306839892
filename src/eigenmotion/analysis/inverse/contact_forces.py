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
from .least_forces import least_forces
from .motion_arguments import Motion

_PLANES = 60
"""Approximations of cones by planes before a search ends: each has a tenth of the error of the last, or less."""
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
    G, g = bounds.linear
    for _ in range(_PLANES):
        found = least_forces(*equations, (G, g), weights)
        if found is None:
            break
        left = bounds.beyond(found[1])
        if not left:
            return found
        planes = [bounds.plane(one, found[1]) for one in left]
        G, g = np.vstack([G, *(row for row, _ in planes)]), np.append(g, [least for _, least in planes])
    what = "pull" if beyond.is_contact else "take more than its limit"
    raise ModelError(f"{c.name}: at t = {at.t:g} {beyond.words(c)} would have to {what}: no forces of "
                     f"{' and '.join(of.names)} give this motion otherwise.")  # fmt: skip


def _equations(at: OperatingPoint, a: Vector, of: Actuators) -> tuple[Vector, Vector, Vector]:
    """Return B (n, count), P (m, n) and r (n,) of B tau - P^T lambda = r, in units in which M has a unit diagonal."""
    c, n, u = at.model, at.model.n_coordinates, at.u.copy()
    inputs = [c.inputs.index(name) if name in c.inputs else -1 for name in of.names]
    u[[k for k in inputs if k >= 0]] = 0.0
    unit = 1.0 / np.sqrt(np.diag(c.factored_matrix(at.t, at.x, at.prepared))[:n])
    columns = input_columns(c, at.t, at.x, at.v, a, at.prepared, u)
    B = np.zeros((n, len(inputs)))
    for k, name in enumerate(of.names):
        B[:, k] = columns[:n, inputs[k]] if inputs[k] >= 0 else np.eye(n)[c.coordinates.index(name)]
    rows = (np.array([at.t]), at.x[None], at.v[None], a[None], u[None])
    r = c.required_rows(*rows, at.prepared)[0][0, :n]
    return B * unit[:, None], _rows(at)[0][: c.m, :n] * unit, r * unit


def _rows(at: OperatingPoint) -> tuple[Vector, Vector]:
    """Return P (m + norms, n), and (norms, m) the multipliers of each norm."""
    return reaction_rows(at.model, at.t, at.x, at.v, at.prepared, at.u)


class Bounds:
    """The bounds of the reactions of contacts and frictions that hold, at one state."""

    def __init__(self, at: OperatingPoint, held: list[Switch]) -> None:
        self.at, self.held, self.surfaces = at, held, Surfaces(at)

    @cached_property
    def limits(self) -> dict[Switch, tuple[float, Vector]]:
        """Friction -> (l_0, l (m,)): its limit is l_0 + l.lambda."""
        return {one: self._limit(one) for one in self.held if not one.is_contact}

    @cached_property
    def linear(self) -> tuple[Vector, Vector]:
        """G (bounds, m), g (bounds,) of G lambda + g >= 0, of all but cones; G has rows of length one."""
        rows = []
        for one in self.held:
            own = np.eye(self.at.model.m)[one.row]
            if one.is_contact:
                rows.append((-own, 0.0))
            elif one.shift < 0:
                rows += [(self.limits[one][1] + side * own, self.limits[one][0]) for side in (1.0, -1.0)]
        G, g = np.array([row for row, _ in rows]).reshape(-1, self.at.model.m), np.array([least for _, least in rows])
        length = np.linalg.norm(G, axis=1)
        return G / length[:, None], g / length

    def plane(self, one: Switch, multipliers: Vector) -> tuple[Vector, float]:
        """Return G (m,), g of the plane that touches the cone of a friction in the direction of its force."""
        own = multipliers[one.row : one.row + 2]
        least, row = self.limits[one][0], self.limits[one][1].copy()
        row[one.row : one.row + 2] -= own / np.linalg.norm(own)
        length = float(np.linalg.norm(row))
        return row / length, least / length

    def beyond(self, multipliers: Vector, within: float = _WITHIN) -> list[Switch]:
        """Return the contacts and frictions whose reactions are beyond their bounds by more than a part of all."""
        units = self.surfaces.units
        size = float(np.abs(multipliers * units).max(initial=0.0)) + self.surfaces.push
        return [one for one in self.held if units[one.row] * self._margin(one, multipliers) < -within * size]

    def _margin(self, one: Switch, multipliers: Vector) -> float:
        if one.is_contact:
            return -float(multipliers[one.row])
        least, slope = self.limits[one]
        own = multipliers[one.row : one.row + (2 if one.shift >= 0 else 1)]
        return float(least + slope @ multipliers - np.linalg.norm(own))

    def _limit(self, one: Switch) -> tuple[float, Vector]:
        """Return the limit of a friction that sticks, over the force of its contact if one presses it."""
        at, every = self.at, switches_of(self.at.model)
        level = float(levels(at.model, at.t, at.x, at.v, at.prepared, at.u)[every.index(one)].max())
        slope = np.zeros(at.model.m)
        if one.over < 0:
            return level, slope
        slope[every[one.over].row] = -level
        return 0.0, slope
