"""Active contacts and frictions of a state: its contact mode, and the surfaces that it touches."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from math import sqrt
from typing import Any, NamedTuple

import numpy as np

from ...arguments.named_values import Vector
from ...runtime import CompiledModel, Prepared
from ...runtime.variations import act_along, constraint_partials
from .operating_point import OperatingPoint

TOUCHES = 1e-9
"""Tolerance of a zero gap or slip, relative to its terms; the same as for constraints at the start of a run."""
_ROUNDED = 64 * np.finfo(float).eps
"""Rounding error of a gap, relative to the size of the state."""
_STILL = 1e-12
"""Rounding error of a rate, relative to all speeds, including those that the acting forces cause."""


class Switch(NamedTuple):
    """A contact or a friction (slides < 0: contact): indices of its event, its row and its parameters.

    shift : the first of the two parameters that turn the direction of a friction cone, which has a second row; else -1
    over : the index of the contact whose force presses a friction; else -1
    """

    event: int
    holds: int
    slides: int
    row: int
    idles: int
    shift: int
    over: int

    @property
    def is_contact(self) -> bool:
        return self.slides < 0

    @property
    def parameters(self) -> tuple[int, ...]:
        """Indices of the parameters that say its mode."""
        turns = (self.shift, self.shift + 1) if self.shift >= 0 else ()
        return (*self.modes, *turns)

    @property
    def modes(self) -> tuple[int, ...]:
        """Indices of the parameters that say whether it holds, slides or is idle; all 0 where it does none of these."""
        return tuple(k for k in (self.holds, self.slides, self.idles) if k >= 0)

    @property
    def rows(self) -> tuple[int, ...]:
        """Its rows: one, or the two of a friction cone."""
        return (self.row, self.row + 1) if self.shift >= 0 else (self.row,)

    def words(self, model: CompiledModel) -> str:
        return f"{'contact' if self.is_contact else 'friction'} {model.events[self.event]!r}"


def switches_of(model: CompiledModel) -> list[Switch]:
    """Return the contacts and frictions of a model."""
    return [Switch._make(one) for one in model.switches]


def with_parameters(at: OperatingPoint, values: Mapping[int, float]) -> OperatingPoint:
    """Return the state with other values of some parameters, by index: in another mode."""
    parameters = np.array(at.prepared.parameters)
    parameters[list(values)] = list(values.values())
    return replace(at, prepared=at.model.prepare(parameters))


def absent_rows(at: OperatingPoint) -> set[int]:
    """Return the rows of open contacts and of frictions that do not stick: they are no constraints there."""
    values = at.prepared.parameters
    return {row for one in switches_of(at.model) if not values[one.holds] and not values[one.idles] for row in one.rows}


def all_open(at: OperatingPoint) -> OperatingPoint:
    """Return the state in the mode in which no contact holds and no friction acts."""
    return with_parameters(at, {k: 0.0 for one in switches_of(at.model) for k in (one.holds, one.slides, one.idles)
                                if k >= 0})  # fmt: skip


def holding(at: OperatingPoint, held: list[Switch]) -> OperatingPoint:
    """Return the state in its mode with these contacts and frictions held in addition."""
    changes = {one.holds: 1.0 for one in held} | {one.idles: 0.0 for one in held}
    return with_parameters(at, changes | {one.slides: 0.0 for one in held if not one.is_contact})


def in_consistent_mode(at: OperatingPoint) -> OperatingPoint:
    """Return the state in its consistent mode, as at the start of a run: on the surfaces that it touches.

    If several modes are consistent, the one with the fewest changes from the mode of `at` is chosen.

    Raises
    ------
    EvaluationError
        No mode is consistent; names the contacts and frictions that contradict each other.
    """
    c, n = at.model, at.model.n
    none, nowhere = np.zeros(c.n_events), np.zeros((c.n_arguments, 1))
    x, v, prepared, _ = act_along(c, at.t, at.x, at.v, at.prepared, at.u, True, none, nowhere[: 2 * n],
                                  nowhere[2 * n :])  # fmt: skip
    return OperatingPoint(c, prepared, at.t, x, v, at.u)


def mode_of(model: CompiledModel, prepared: Prepared) -> dict[str, float]:
    """Return the mode, by the names of `Solution.modes`; redundant rows that stay at rest count as held."""
    values, mode = prepared.parameters, dict[str, float]()
    for one in switches_of(model):
        idle = values[one.idles] != 0.0
        mode[model.parameters[one.holds]] = 1.0 if idle else values[one.holds]
        if not one.is_contact:
            mode[model.parameters[one.slides]] = 0.0 if idle else values[one.slides]
    return mode


def named_modes(model: CompiledModel, values: Mapping[str, float]) -> dict[str, float]:
    """Return the mode from given values by name, with the names of `Solution.modes`."""
    names = [model.parameters[k] for one in switches_of(model) for k in (one.holds, one.slides) if k >= 0]
    return {name: values[name] for name in names if name in values}


@dataclass(frozen=True)
class Surfaces:
    """The rows of all contacts and frictions at a state, whether they hold or not."""

    at: OperatingPoint

    @cached_property
    def all(self) -> OperatingPoint:
        return holding(self.at, switches_of(self.at.model))

    @cached_property
    def A(self) -> Vector:
        return self.at.model.pfaffian(self.at.t, self.at.x, self.all.prepared)[0]

    @cached_property
    def M(self) -> Vector:
        return self.at.model.factored_matrix(self.at.t, self.at.x, self.all.prepared)

    @cached_property
    def units(self) -> Vector:
        """(m,) norms of the rows in the mass metric."""
        return np.asarray(np.linalg.norm(np.linalg.solve(np.linalg.cholesky(self.M), self.A.T), axis=0))

    @cached_property
    def push(self) -> float:
        """The norm of the acceleration without any contact or friction, in the mass metric: the size of forces."""
        at, free = self.at, all_open(self.at)
        return self._length(at.model.acceleration(at.t, at.x, at.v, free.prepared, at.u, True)[0])

    def _length(self, d: Vector) -> float:
        return sqrt(max(float(d @ self.M @ d), 0.0))

    @cached_property
    def gaps(self) -> tuple[Vector, Vector]:
        """(h,) gaps, and the tolerances within which they count as closed."""
        at, model = self.at, self.at.model
        gap, terms = model.position(at.t, at.x, self.all.prepared)
        rounded = _ROUNDED * self.units[: model.h] * self._length(at.x)
        return gap, TOUCHES * (terms + np.abs(self.A[: model.h]) @ np.abs(at.x)) + rounded

    @cached_property
    def rates(self) -> tuple[Vector, Vector]:
        """(m,) rates of gaps and slips, and the tolerances within which they count as at rest."""
        at = self.at
        b = at.model.pfaffian(at.t, at.x, self.all.prepared)[1]
        speed = self._length(at.v) + sqrt(self.push * self._length(at.x))
        return self.A @ at.v + b, TOUCHES * (np.abs(self.A) @ np.abs(at.v) + np.abs(b)) + _STILL * self.units * speed

    def accelerations(self, a: Vector) -> Vector:
        """Return the accelerations (m,) along the rows, A a + gamma, for accelerations a (n,) of the coordinates."""
        at, n = self.at, self.at.model.n
        partial = constraint_partials(at.model, at.t, at.x, at.v, self.all.prepared)[at.model.h :]
        return self.A @ a + partial[:, :n] @ at.v + partial[:, -1]

    def closed(self) -> list[Switch]:
        """Return the contacts whose gap is at most zero."""
        gap, within = self.gaps
        return [one for one in switches_of(self.at.model) if one.is_contact and gap[one.row] <= within[one.row]]

    def inside(self) -> list[tuple[Switch, float]]:
        """Return the contacts that the state penetrates, with their gaps."""
        gap, within = self.gaps
        return [(one, float(gap[one.row])) for one in switches_of(self.at.model)
                if one.is_contact and gap[one.row] < -within[one.row]]  # fmt: skip

    def at_rest(self, one: Switch) -> bool:
        rate, within = self.rates
        return bool(abs(rate[one.row]) <= within[one.row])


def mode_text(at: OperatingPoint) -> str:
    """Return a description of the mode: which contacts hold, and which frictions stick or slide."""
    mode: dict[str, Any] = mode_of(at.model, at.prepared)
    names, texts = at.model.parameters, []
    for one in switches_of(at.model):
        name = at.model.events[one.event]
        if mode[names[one.holds]]:
            texts.append(f"{name} {'held' if one.is_contact else 'stuck'}")
        elif not one.is_contact and mode[names[one.slides]]:
            texts.append(f"{name} slides {'forward' if mode[names[one.slides]] > 0 else 'back'}")
    return ", ".join(texts)
