"""Identities between values of a compiled model and the user's expressions: sums of terms that vanish."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model.normalise import name_of
from ...codegen.model.statement.mechanism import Mechanism
from .arithmetic.rounding_bounds import EPS, Rounded, applied, geometric, rounded
from .compiled_values import CompiledValues
from .solve_errors import Errors
from .symbolic_values import SymbolicValues


@dataclass(frozen=True, slots=True)
class Identity:
    """Terms, each (k, r), whose sum is zero to their rounding.

    names : (r,) the subject of each sum
    more : (k, r) the additional error bound of linear solves behind the values
    scale : (k, r) the size relative to which the bound decides whether the identity means anything
    always : whether the compiled model must have a value wherever the expression has one
    """

    names: Sequence[str]
    terms: Sequence[Rounded]
    more: Vector | float = 0.0
    scale: Vector | float = 0.0
    always: bool = False


def expressions(model: Mechanism, v: Vector, found: CompiledValues, stated: SymbolicValues) -> Iterator[Identity]:
    """Identities of single expressions and their derivatives; v (k, n)."""
    rates = [f"{name_of(x)}'" for x in model.coordinates]
    rows = row_names(model)
    second = [f"d2T / d{one} d{two} of kinetic_energy" for one in rates for two in rates]
    size, pace = geometric(found.factored), rounded(v)
    yield _equal(second, found.M, stated.M, size)
    heavy_ones = model.n - len(model.states)  # states are velocities without energy
    squares, products = 0.5 * pace[:, :, None] * stated.M * pace[:, None, :], stated.G * pace
    squares = squares[:, :heavy_ones, :heavy_ones]
    T2, T1, T0, V = found.energies.T[:, :, None]
    yield Identity(["T2 of kinetic_energy"], [rounded(T2), -_summed(flat(squares))], always=True)
    yield Identity(["T1 of kinetic_energy"], [rounded(T1), -_summed(products)], scale=np.abs(T2), always=True)
    yield _equal(["T0 of kinetic_energy"], T0, stated.T0[:, None])
    yield _equal(["potential_energy"], V, stated.V[:, None])
    unit = np.sqrt(np.abs(np.einsum("kii->ki", found.factored)))[:, None, :]
    heavy = unit * np.abs(found.A / unit).max(axis=2, keepdims=True, initial=0.0)
    yield _equal([f"the factor of {rate} in {row}" for row in rows for rate in rates], found.A, stated.A, heavy)
    moving = _summed(rounded(found.A) * pace[:, None, :])
    yield Identity(rows, [rounded(found.b), -stated.row, moving], always=True)
    yield _equal(rows[: model.h], found.phi, stated.phi)
    yield _equal([f"quasi_velocities[{name_of(y)}]" for y, _ in model.quasi_velocities], found.quasi, stated.quasi)
    yield _equal([f"events[{name}]" for name, _ in model.events], found.events, stated.events)
    shapes = enumerate(model.drawing)
    yield _equal([f"drawing[{k}]" for k, shape in shapes for _ in shape.numbers], found.drawn, stated.drawn)


def motion(
    model: Mechanism, v: Vector, found: CompiledValues, stated: SymbolicValues, errors: Errors
) -> Iterator[Identity]:
    """Lagrange's equations (7), the differentiated constraints, and the outputs, which use their solution; v (k, n)."""
    names = [f"the equation of motion of {name_of(x)}" for x in model.coordinates]
    yield Identity(names, equations(found, stated), errors.solved, errors.solved / EPS)
    size = np.einsum("kri,ki->kr", np.abs(stated.A.value), np.abs(found.a))
    size += np.einsum("kri,ki->kr", np.abs(stated.A_rate.value), np.abs(v))
    yield Identity([f"{row}, differentiated," for row in row_names(model)], [stated.row_rate], errors.rows, size)
    yield Identity([f"outputs[{name}]" for name, _ in model.outputs], [rounded(found.outputs), -stated.outputs])


def equations(found: CompiledValues, stated: SymbolicValues) -> list[Rounded]:
    """The terms of d/dt dT/dxdot - dT/dx + dV/dx - Q + A^T lambda, (k, n) each."""
    push = applied(stated.A.turned, rounded(found.multipliers))
    return [stated.momentum_rate, -stated.T_x, stated.V_x, -stated.Q, push]


def row_names(model: Mechanism) -> list[str]:
    """Names of the constraint rows, as in error messages of a Model."""
    kinds = {"holonomic_constraints": model.h, "nonholonomic_constraints": model.m - model.h}
    return [f"{kind}[{k}]" for kind, count in kinds.items() for k in range(count)]


def flat(values: Rounded) -> Rounded:
    """Return an array (k, ...) as (k, r)."""
    return Rounded(*(part.reshape(len(part), -1) for part in (values.value, values.bound)))


def _equal(names: Sequence[str], found: Vector, stated: Rounded, scale: Vector | float = 0.0) -> Identity:
    wide = np.broadcast_to(scale, found.shape).reshape(len(found), -1)
    return Identity(names, [flat(rounded(found)), -flat(stated)], scale=wide, always=True)


def _summed(terms: Rounded) -> Rounded:
    """Sums over the last axis; (k, 1) of (k, r)."""
    value, bound = (part.sum(axis=-1, keepdims=terms.value.ndim == 2) for part in (terms.value, terms.bound))
    return Rounded(value, bound)
