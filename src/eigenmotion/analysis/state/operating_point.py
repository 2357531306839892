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
    def time(self) -> float:
        """The shortest time constant of deviations [s]; 1 if no force acts on them."""
        n, unit = self.model.n, self.inertia
        by_x, by_v = (unit[:, None] * part / unit for part in np.split(self.motion[2][:, : 2 * n], 2, axis=1))
        rate = max(float(np.sqrt(np.linalg.norm(by_x))), float(np.linalg.norm(by_v)))
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
        """(2 n,) factors that make x and v comparable: inertia, and the time constant of deviations."""
        return np.concatenate([self.inertia / self.time, self.inertia])


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
