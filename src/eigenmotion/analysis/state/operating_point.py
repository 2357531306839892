"""Operating point of a system: a state, its acceleration and multipliers, and their derivatives."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...arguments.named_values import Vector
from ...codegen.model.normalise import number
from ...compiled.compiled_system import CompiledSystem
from ...compiled.projection import RESOLVED, next_to
from ...runtime import CompiledModel, Prepared, variations

_ROUNDED = 256 * np.finfo(float).eps
"""Rounding error of a sum, relative to terms that cancel."""
_ROUNDS = 60
"""Most rounds in which units of states are balanced: within a factor of e is enough."""


@dataclass(frozen=True)
class OperatingPoint:
    """A state with its time, inputs and parameters. x, v : (n,), states among v; u : (n_inputs,)"""

    model: CompiledModel
    prepared: Prepared
    t: float
    x: Vector
    v: Vector
    u: Vector

    def at(self, t: float, x: Vector, v: Vector) -> "OperatingPoint":
        """Return another state of the same system."""
        return OperatingPoint(self.model, self.prepared, t, x, v, self.u)

    @property
    def coordinates(self) -> int:
        """The number of coordinates; the other entries of x are integrals of first-order states."""
        return self.model.n_coordinates

    @property
    def rests(self) -> bool:
        """Whether no coordinate moves."""
        return not self.v[: self.coordinates].any()

    @cached_property
    def motion(self) -> tuple[Vector, Vector, Vector, Vector]:
        """a (n,), lambda (m,) and their derivatives (n, n_arguments), (m, n_arguments).

        Raises
        ------
        EvaluationError
            M is singular, or constraint rows contradict each other.
        """
        return variations.motion_derivatives(self.model, self.t, self.x, self.v, self.prepared, self.u, True)

    @cached_property
    def constraints(self) -> Vector:
        """(h + m, n_arguments) derivatives of phi and A v + b."""
        return variations.constraint_partials(self.model, self.t, self.x, self.v, self.prepared)

    @cached_property
    def jacobian(self) -> Vector:
        """(2 n, 2 n) derivatives of (x, v) -> (v, a)."""
        n = self.model.n
        return np.block([[np.zeros((n, n)), np.eye(n)], [self.motion[2][:, : 2 * n]]])

    @cached_property
    def inertia(self) -> Vector:
        """(n,) square roots of the diagonal of M: units in which coordinates can be compared."""
        diagonal = np.diag(self.model.factored_matrix(self.t, self.x, self.prepared))
        return np.asarray(np.sqrt(diagonal))

    @cached_property
    def mobility(self) -> Vector:
        """(n, n) absolute values of M^-1: the effect of forces on accelerations."""
        return np.asarray(np.abs(np.linalg.inv(self.model.factored_matrix(self.t, self.x, self.prepared))))

    @cached_property
    def reaction_terms(self) -> Vector:
        """(n,) sum of the sizes of accelerations by reactions; at rest these cancel the accelerations by forces."""
        A = self.model.pfaffian(self.t, self.x, self.prepared)[0]
        return np.asarray(self.mobility @ np.abs(A).T @ np.abs(self.motion[1]))

    @cached_property
    def slope_terms(self) -> Vector:
        """(n, n_arguments) sizes of the terms of derivatives of a that are due to reactions."""
        (_, multipliers, _, dm), n, h = self.motion, self.model.n, self.model.h
        if not self.model.m:
            return np.zeros((n, dm.shape[1]))
        A = self.model.pfaffian(self.t, self.x, self.prepared)[0]
        forces = np.abs(A).T @ np.abs(dm)
        for j, unit in enumerate(np.eye(n)):
            turning = variations.constraint_partials(self.model, self.t, self.x, unit, self.prepared)[h:, :n]
            forces[j, :n] += np.abs(multipliers) @ np.abs(turning)
        M = self.model.factored_matrix(self.t, self.x, self.prepared)
        shared = (
            np.abs(np.linalg.pinv(A @ np.linalg.solve(M, A.T), hermitian=True)) @ np.abs(A) @ self.mobility @ forces
        )
        return np.asarray(self.mobility @ (forces + np.abs(A).T @ shared))

    @cached_property
    def slopes(self) -> Vector:
        """(n, n_arguments) derivatives of a, with rounding errors of terms that cancel set to zero."""
        da = self.motion[2]
        return np.where(np.abs(da) > _ROUNDED * self.slope_terms, da, 0.0)

    @cached_property
    def comparable(self) -> Vector:
        """(n,) units in which coordinates and states can be compared: of coordinates their inertia."""
        own = slice(None, self.coordinates)
        rate = self._rate(self.inertia, own) or self._rate(np.ones(self.model.n), slice(self.coordinates, None)) or 1.0
        by_x, by_v = np.abs(np.split(self.motion[2][:, : 2 * self.model.n], 2, axis=1))
        return _balanced(by_v + by_x / rate, self.inertia, self.coordinates, rate)

    def _rate(self, unit: Vector, own: slice) -> float:
        """Return the largest rate of deviations of some numbers in these units."""
        parts = np.split(self.motion[2][:, : 2 * self.model.n], 2, axis=1)
        by_x, by_v = (np.linalg.norm((unit[:, None] * part / unit)[own, own]) for part in parts)
        return max(float(np.sqrt(by_x)), float(by_v))

    @cached_property
    def time(self) -> float:
        """The shortest time constant of deviations [s]; 1 if no force acts on them."""
        rate = self._rate(self.comparable, slice(None))
        return 1.0 / rate if rate > 0.0 else 1.0

    @cached_property
    def unresolved(self) -> list[str]:
        """Coordinates at which the slopes change from one double to the next, as for angles of 1e16.

        Residuals of the equations mean nothing then, even if they are small compared with |slope| |x|.
        """
        n = self.model.n
        slope = self.motion[2][:, :n]
        most = RESOLVED * (np.linalg.norm(slope) + np.linalg.norm(self.slope_terms[:, :n]))
        return [name for k, name in enumerate(self.model.coordinates) if self._change(k, slope) > most]

    def _change(self, k: int, slope: Vector) -> float:
        """Return the change of the slopes if x_k changes to the next double."""
        return float(np.linalg.norm(self.at(self.t, next_to(self.x, k), self.v).motion[2][:, : self.model.n] - slope))

    @cached_property
    def units(self) -> Vector:
        """(2 n,) factors that make x and v comparable: those of `comparable`, and the time constant of deviations."""
        return np.concatenate([self.comparable / self.time, self.comparable])


def _balanced(sizes: Vector, unit: Vector, first: int, rate: float) -> Vector:
    """Return units of n numbers; from `first` on those in which a number depends on others as much as they on it.

    sizes : (n, n) |derivatives| of rates. Where there is no dependence either way, `rate` takes its place. The method
    is E. E. Osborne's, J. ACM 7 (1960) 338.
    """
    unit, sizes = unit.copy(), sizes * (1.0 - np.eye(len(unit)))
    for _ in range(_ROUNDS if first < len(unit) else 0):
        before = unit.copy()
        for k in range(first, len(unit)):
            on, by = (sizes[k] / unit).max() * unit[k], (sizes[:, k] * unit).max() / unit[k]
            if on > 0.0 or by > 0.0:
                unit[k] *= np.sqrt((by or rate) / (on or rate))
        if (np.abs(np.log(unit / before)) < 1.0).all():
            break
    return unit


def operating_point(
    system: CompiledSystem,
    x: Mapping[Any, float] | ArrayLike | None,
    v: Mapping[Any, float] | ArrayLike | None,
    t: float,
    parameters: Any,
    inputs: Mapping[Any, Any] | ArrayLike | None,
) -> OperatingPoint:
    """Return the operating point for the user's arguments."""
    (prepared, inputs), t = system.prepare_both(parameters, inputs), number(t, "t")
    return OperatingPoint(system.compiled, prepared, t, *system.begin(x, v, t, prepared), system.signals(inputs, t))
