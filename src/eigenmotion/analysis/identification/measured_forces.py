"""Measured forces of actuators, along the motions that constraints allow, and their covariance."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...arguments.named_values import Vector, by_spelling, is_named, unknown, vector
from ...codegen.model.normalise import ModelError
from ...runtime import CompiledModel
from ..inverse.actuators import actuators_of
from ..inverse.motion_arguments import Motion
from .slopes import input_slopes

_NO_NOISE = 1e-12
"""A variance, relative to the largest of its state, that counts as zero."""


@dataclass(frozen=True)
class Along:
    """Measured forces along free motions, one state below the other.

    forces : (rows,) of those on coordinates; those of inputs are in the model's own
    whiteners : T of each state, with which its rows have the covariance diag(noisy)
    noisy : (rows,) 1, or 0 for rows without errors
    """

    forces: Vector
    whiteners: tuple[Vector, ...]
    noisy: Vector

    def whitened(self, rows: Vector) -> Vector:
        """Return rows (rows, ...) times the whitener of each state."""
        made, first = np.empty_like(rows), 0
        for T in self.whiteners:
            made[first : first + len(T)] = T @ rows[first : first + len(T)]
            first += len(T)
        return made


@dataclass(frozen=True)
class Measured:
    """Forces of actuators.

    values : (k, actuators); variances : (actuators,) relative; coordinates, inputs : the number of each, or -1
    """

    values: Vector
    variances: Vector
    coordinates: tuple[int, ...]
    inputs: tuple[int, ...]

    def as_inputs(self, u: Vector) -> Vector:
        """Return inputs (k, n_inputs) with those that are actuators."""
        u = u.copy()
        for j, k in enumerate(self.inputs):
            if k >= 0:
                u[:, k] = self.values[:, j]
        return u

    def along(self, motion: Motion, freedoms: Sequence[Vector]) -> Along:
        """Return them along free motions N (n, freedoms) of each state, with their covariance."""
        on_coordinates = self.values * [k >= 0 for k in self.coordinates]
        parts = [N.T @ B for N, B in zip(freedoms, self._columns(motion), strict=True)]
        forces = [part @ row for part, row in zip(parts, on_coordinates, strict=True)]
        spectra = [np.linalg.eigh(part * self.variances @ part.T) for part in parts]
        noisy = [sizes > max(_NO_NOISE * sizes.max(initial=0.0), 1e-300) for sizes, _ in spectra]
        known = np.concatenate([sizes[own] for (sizes, _), own in zip(spectra, noisy, strict=True)])
        mean = float(known.mean()) if known.size else 1.0
        whiteners = tuple(
            (axes / np.sqrt(np.where(own, sizes, mean))).T for (sizes, axes), own in zip(spectra, noisy, strict=True)
        )
        return Along(np.concatenate(forces), whiteners, np.concatenate(noisy).astype(float))

    def _columns(self, motion: Motion) -> Vector:
        """Return B (k, n, actuators)."""
        B = np.zeros((len(motion.t), motion.model.n_coordinates, len(self.coordinates)))
        by_input = -input_slopes(motion, [max(k, 0) for k in self.inputs]) if max(self.inputs) >= 0 else B
        for j, (coordinate, given) in enumerate(zip(self.coordinates, self.inputs, strict=True)):
            if coordinate >= 0:
                B[:, coordinate, j] = 1.0
            elif given >= 0:
                B[..., j] = by_input[..., j]
        return B


def measured_forces(
    c: CompiledModel, count: int, forces: Any, actuators: Iterable[Any] | None, weights: Any
) -> Measured:
    """Return forces of `count` states given by users.

    Raises
    ------
    ModelError
        A name is unknown, a shape is another, a number is not finite, or a weight is not positive.
    """
    own = c.coordinates[: c.n_coordinates]
    names = (
        own
        if actuators is None
        else actuators_of(c, actuators if isinstance(actuators, str) else tuple(actuators)).names
    )
    values = _table(c, forces, names, count)
    if not np.isfinite(values).all():
        raise ModelError(f"{c.name}: forces have a number that is not finite. Leave out these states.")
    if weights is None:
        variances = np.ones(len(names))
    else:
        given = _table(c, weights, names, 1)[0]
        if not (np.isfinite(given).all() and given.min() > 0.0):
            raise ModelError(f"{c.name}: weights are positive, and {given.tolist()} are given")
        variances = 1.0 / given
    coordinates = tuple(own.index(name) if name in own else -1 for name in names)
    inputs = tuple(-1 if name in own else c.inputs.index(name) for name in names)
    return Measured(values, variances, coordinates, inputs)


def _table(c: CompiledModel, given: Mapping[Any, Any] | ArrayLike, names: Sequence[str], count: int) -> Vector:
    """Return (count, actuators) of an array (actuators, count), or of a mapping name -> (count,)."""
    if is_named(given):
        named = by_spelling(given, "forces")
        if set(named) != set(names):
            raise ModelError(f"{c.name}: {unknown('actuator', set(named) ^ set(names), names)}")
        rows = [np.atleast_1d(vector(named[name], f"force {name!r}")) for name in names]
    else:
        array = vector(given, "forces")
        rows = list(array.reshape(len(array), -1)) if array.ndim else [array.reshape(1)]
    if len(rows) != len(names) or {len(row) for row in rows} != {count}:
        shape = (len(rows), *sorted({len(row) for row in rows}))
        raise ModelError(
            f"{c.name}: forces or weights have shape {shape}. Give {(len(names), count)}: {', '.join(names)}."
        )
    return np.ascontiguousarray(np.array(rows).T)
