"""Conditions of contacts and friction, checked at every accepted step of a run.

No closed contact pulls; no gap is negative or accelerates inwards; no sticking friction exceeds its limit, slips, or
slides the wrong way. The check uses the modes and multipliers of the run and the outputs of `with_contact_outputs`. If
forces are not unique, some forces of the same sum must satisfy the conditions.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.optimize import linprog

from ...arguments.named_values import Vector
from ...codegen.model import Model
from ...codegen.model.statement.contacts import Switch
from ...results.solution import Solution
from ...system.system import System

_UNMOVED = 1e-6
"""Least size of the coordinates to which gaps are compared, for a mechanism at rest at x = 0."""


def largest_violation(solution: Solution, system: System, model: Model, parameters: Mapping[str, float]) -> float:
    """Return the largest violation of a condition, relative to the largest force, gap or slip of the run.

    The system is that of the model `with_contact_outputs`.
    """
    return max(_ContactRun(solution, system, model, parameters).violations(), default=0.0)


@dataclass(frozen=True)
class _ContactRun:
    """A run by rows (k): arrays (c, k) of contacts, (r, k) of frictions; modes are NaN before the first decision."""

    solution: Solution
    system: System
    model: Model
    parameters: Mapping[str, float]

    @cached_property
    def contacts(self) -> list[Switch]:
        return [one for one in self.model.switches if one.slides is None]

    @cached_property
    def frictions(self) -> list[Switch]:
        return [one for one in self.model.switches if one.slides is not None]

    @cached_property
    def closed(self) -> Vector:
        return self.mode(self.contacts, "_held")

    @cached_property
    def stuck(self) -> Vector:
        return self.mode(self.frictions, "_stuck")

    @cached_property
    def ways(self) -> Vector:
        """1 or -1: the direction of slip; 1 for a cone."""
        return self.mode(self.frictions, "_slides")

    def mode(self, of: list[Switch], end: str) -> Vector:
        return self.rows(_along(self.solution, one.name + end) for one in of)

    def outputs(self, of: list[Switch], end: str) -> Vector:
        """Return the outputs (j, k) with this ending of the name."""
        return self.rows(self.solution.outputs[one.name + end] for one in of)

    def rows(self, values: Iterable[Vector]) -> Vector:
        return np.array(list(values)).reshape(-1, len(self.solution.t))

    def violations(self) -> Iterator[float]:
        """Yield the violation of each condition."""
        gaps, opens = (self.outputs(self.contacts, end) for end in ("_gap", "_opens"))
        slips, closed, stuck = self.slips(), self.closed == 1, self.stuck == 1
        size = max(_size(self.solution.x), _UNMOVED)
        yield _largest(-gaps) / size
        yield _largest(np.abs(gaps[closed])) / size
        yield _largest(np.abs(opens[closed])) / max(_size(opens), 1.0)
        yield _largest(-np.nan_to_num(self.ways) * slips) / _size(slips)
        yield _largest(np.abs(slips[stuck])) / max(_size(slips), 1.0)
        yield self.forces()

    def slips(self) -> Vector:
        """Return the slips (r, k); for a cone the magnitude, since its force opposes the slip by construction."""
        slips, outputs = self.outputs(self.frictions, "_slip"), self.solution.outputs
        aside = self.rows(outputs.get(f"{one.name}_aside", np.zeros(len(self.solution.t))) for one in self.frictions)
        cones = np.array([one.cone for one in self.frictions], dtype=bool).reshape(-1, 1)
        return np.where(cones, np.hypot(slips, aside), slips)

    def forces(self) -> float:
        """Return the largest violation by forces, if no other forces of the same sum violate less."""
        multipliers = self.solution.multipliers
        press = -multipliers[[one.row for one in self.contacts]]
        rub, size = self.rubs(), max(_size(multipliers), 1e-300)
        beyond = np.maximum(
            -press.min(axis=0, initial=0.0),
            ((rub - self.limits_of("_sticks")) * (self.stuck == 1)).max(axis=0, initial=0.0),
        )
        wrong = np.flatnonzero(beyond > 1e-9 * size)
        return max((min(beyond[k] / size, self.others(int(k)) / size) for k in wrong), default=0.0)

    def rubs(self) -> Vector:
        """Return the magnitudes (r, k) of the multipliers of frictions."""
        rows = [self.model.h + one.row for one in self.frictions]
        lambdas = self.solution.multipliers
        return self.rows(
            np.hypot(lambdas[j], lambdas[j + one.cone] * one.cone) for j, one in zip(rows, self.frictions, strict=True)
        )

    def limits_of(self, end: str) -> Vector:
        """Return the forces (r, k) up to which frictions stick ("_sticks"), or with which they slide ("_limit")."""
        return np.asarray(self.outputs(self.frictions, end) * self.rows(map(self.pressing, self.frictions)))

    def pressing(self, friction: Switch) -> Vector:
        """Return the normal force (k,) to which the limit of a friction is relative; 1 for an absolute limit."""
        multipliers = self.solution.multipliers
        if friction.over is not None:
            return np.asarray(-multipliers[next(one.row for one in self.contacts if one.name == friction.over)])
        pressed = multipliers[list(friction.presses)]
        return np.asarray(np.linalg.norm(pressed, axis=0)) if len(pressed) else np.ones(len(self.solution.t))

    def others(self, k: int) -> float:
        """Return the violation [N] by the best forces of the same sum in row k.

        Not implemented, and infinite, for cones and for friction in joints.
        """
        if any(one.cone or one.presses for one in self.frictions):
            return np.inf
        t, x = self.solution.t[k], self.solution.x[:, k]
        modes = {f"{one.name}_held": 1.0 for one in self.contacts} | {
            f"{one.name}_stuck": 1.0 for one in self.frictions
        }
        order = [one.row for one in self.contacts] + [self.model.h + one.row for one in self.frictions]
        order += [row for row in range(self.model.m) if row not in order]
        A = self.system.pfaffian(x, t, dict(self.parameters) | modes)[0][order]
        closed, stuck, way = self.closed[:, k] == 1, self.stuck[:, k] == 1, np.nan_to_num(self.ways[:, k])
        limit = np.where(stuck, *(self.outputs(self.frictions, end)[:, k] for end in ("_sticks", "_limit")))
        names, c = [one.name for one in self.contacts], len(self.contacts)
        on = np.array([names.index(one.over) if one.over else -1 for one in self.frictions], dtype=int)
        shown = -self.solution.multipliers[order, k]
        for j in np.flatnonzero(way):
            shown[c + j] = -way[j] * limit[j] * (shown[on[j]] if on[j] >= 0 else 1.0)
        return _least(A, A.T @ shown, c, limit, on, way, closed, stuck)


def _least(
    A: Vector, total: Vector, c: int, limit: Vector, on: Vector, way: Vector, closed: Vector, stuck: Vector
) -> float:
    """Return the least s with A^T f = total, f >= -s for contacts, |f| <= limit + s for sticking frictions."""
    m = len(A)
    equal, right, bounded, bounds = [np.append(row, 0.0) for row in A.T], list(total), [], []
    for j, (L, way_j) in enumerate(zip(limit, way, strict=True)):
        own, most = np.eye(m + 1)[c + j], np.zeros(m + 1)
        if on[j] >= 0:
            most[on[j]] = L
        fixed = 0.0 if on[j] >= 0 else L
        if stuck[j]:
            bounded += [sign * own - most - np.eye(m + 1)[m] for sign in (1.0, -1.0)]
            bounds += [fixed, fixed]
        else:
            equal.append(own + way_j * most)
            right.append(-way_j * fixed)
    limits = [(None if one else 0.0, None if one else 0.0) for one in closed] + [(None, None)] * (m - c) + [(0.0, None)]
    bounded += [-np.eye(m + 1)[i] - np.eye(m + 1)[m] for i in range(c)]
    done = linprog(np.eye(m + 1)[m], np.array(bounded), bounds + [0.0] * c, np.array(equal), np.array(right), limits)
    return float(done.x[m]) if done.status == 0 else np.inf


def _along(solution: Solution, name: str) -> Vector:
    """Return the value of a mode's parameter in each row (k,); of two rows at one time, the first has the mode before.

    NaN: before the first decision.
    """
    since = np.array([t for t, _ in solution.modes])
    values = np.array([mode[name] for _, mode in solution.modes])
    last = np.append(np.diff(solution.t) > 0, True)
    before = np.searchsorted(since, solution.t, "left") - 1
    number = np.where(last, np.searchsorted(since, solution.t, "right") - 1, before)
    return np.where(number < 0, np.nan, values[np.maximum(number, 0)])


def _largest(values: Vector) -> float:
    return float(np.max(values, initial=0.0))


def _size(values: Vector) -> float:
    return max(float(np.max(np.abs(values), initial=0.0)), 1e-300)
