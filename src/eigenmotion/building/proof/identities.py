"""What must hold between a compiled model's answers and the user's expressions: sums of terms that vanish."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ...arguments.names import Vector
from ...codegen.model import Model
from ...codegen.model.normalise import name_of
from .found import Found
from .stated import Stated


@dataclass(frozen=True, slots=True)
class Identity:
    """Terms, each (k, r), whose sum is zero.

    names : (r,) what each sum is about
    size : (k, r) what rounding of the answers is relative to, beside the terms themselves
    always : whether the compiled model has to have an answer wherever the expression has a value
    """

    names: Sequence[str]
    terms: Sequence[Vector]
    size: Vector | float = 0.0
    always: bool = False


def expressions(model: Model, v: Vector, found: Found, stated: Stated) -> Iterator[Identity]:
    """What is the value or a derivative of one expression; v (k, n)."""
    rates = [f"{name_of(x)}'" for x in model.coordinates]
    rows = row_names(model)
    second = [f"d2T / d{one} d{two} of kinetic_energy" for one in rates for two in rates]
    yield _equal(second, found.M, stated.M, geometric(stated.M))
    squares, products = 0.5 * v[:, :, None] * stated.M * v[:, None, :], stated.G * v
    T2, T1, T0, V = found.energies.T[:, :, None]
    yield Identity(["T2 of kinetic_energy"], [T2, *_split(-flat(squares))], always=True)
    yield Identity(["T1 of kinetic_energy"], [T1, *_split(-products)], always=True)
    yield _equal(["T0 of kinetic_energy"], T0, stated.T0)
    yield _equal(["potential_energy"], V, stated.V)
    yield _equal([f"the factor of {rate} in {row}" for row in rows for rate in rates], found.A, stated.A)
    yield Identity(rows, [found.b, -stated.row, *_slices(found.A * v[:, None, :], 2)], always=True)
    yield _equal(rows[: model.h], found.phi, stated.phi)
    yield _equal([f"quasi_velocities[{name_of(y)}]" for y, _ in model.quasi_velocities], found.quasi, stated.quasi)
    yield _equal([f"events[{name}]" for name, _ in model.events], found.events, stated.events)
    shapes = enumerate(model.drawing)
    yield _equal([f"drawing[{k}]" for k, shape in shapes for _ in shape.numbers], found.drawn, stated.drawn)


def motion(model: Model, v: Vector, found: Found, stated: Stated) -> Iterator[Identity]:
    """Lagrange's equations (7), the constraints differentiated, and the outputs, which are made of their solution."""
    push = stated.A * found.multipliers[:, :, None]
    size = np.einsum("kij,kj->ki", geometric(found.factored), np.abs(found.a))  # of what gave the multipliers
    names = [f"the equation of motion of {name_of(x)}" for x in model.coordinates]
    yield Identity(names, [stated.momentum_rate, -stated.T_x, stated.V_x, -stated.Q, *_slices(push, 1)], size)
    yield Identity([f"{row}, differentiated," for row in row_names(model)], [stated.row_rate],
                   _row_sizes(v, found, stated))  # fmt: skip
    yield Identity([f"outputs[{name}]" for name, _ in model.outputs], [found.outputs, -stated.outputs])


def row_names(model: Model) -> list[str]:
    """Names of the constraint rows, as errors of a Model call them."""
    kinds = {"holonomic_constraints": model.h, "nonholonomic_constraints": model.m - model.h}
    return [f"{kind}[{k}]" for kind, count in kinds.items() for k in range(count)]


def geometric(M: Vector) -> Vector:
    """sqrt(M_ii M_jj), (k, n, n): the size of an entry that no choice of units changes."""
    root = np.sqrt(np.abs(np.einsum("kii->ki", M)))
    return np.asarray(root[:, :, None] * root[:, None, :])


def flat(values: Vector) -> Vector:
    """(k, ...) as (k, r)."""
    return values.reshape(len(values), -1)


def inverse(M: Vector) -> Vector:
    """M^-1 (k, n, n), of least norm where M is singular; NaN where it is not finite."""
    size = geometric(M)
    size = np.where(size > 0.0, size, 1.0)
    fine = np.asarray(np.isfinite(M).all(axis=(1, 2)))[:, None, None]
    inverted = np.linalg.pinv(np.where(fine, M / size, 0.0), hermitian=True)
    return np.asarray(np.where(fine, inverted / size, np.nan))


def _row_sizes(v: Vector, found: Found, stated: Stated) -> Vector:
    """What Adot v + A a is rounded relative to: its terms, and those of A M^-1 A^T lambda."""
    terms = np.einsum("kri,ki->kr", np.abs(stated.A), np.abs(found.a))
    terms += np.einsum("kri,ki->kr", np.abs(stated.A_rate), np.abs(v))
    delta = stated.A @ inverse(stated.M) @ stated.A.transpose(0, 2, 1)
    terms[found.least_norm != 0.0] = np.nan  # dependent rows may contradict each other off the constraints
    return np.asarray(terms + np.einsum("krs,ks->kr", geometric(delta), np.abs(found.multipliers)))


def _equal(names: Sequence[str], found: Vector, stated: Vector, size: Vector | float = 0.0) -> Identity:
    wide = flat(size) if isinstance(size, np.ndarray) else size
    return Identity(names, [flat(found), -flat(stated)], wide, always=True)


def _slices(values: Vector, axis: int) -> list[Vector]:
    """The terms of a sum over one of the axes 1, 2."""
    return [part.squeeze(axis) for part in np.split(values, values.shape[axis], axis)] if values.shape[axis] else []


def _split(values: Vector) -> list[Vector]:
    return np.split(values, values.shape[1], axis=1)
