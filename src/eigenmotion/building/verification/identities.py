"""Identities between values of a compiled model and the user's expressions: sums of terms that vanish."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model.normalise import name_of
from ...codegen.model.statement.mechanism import Mechanism
from ...codegen.model.tree.functions import BodyFunction
from .arithmetic.rounding_bounds import EPS, Rounded, applied, geometric, rounded
from .compiled_values import CompiledValues
from .solve_errors import Errors
from .symbolic_values import SymbolicValues


@dataclass(frozen=True, slots=True)
class Identity:
    """Terms, each (k, r), whose sum is zero up to rounding.

    names : (r,) what each sum checks
    more : (k, r) additional error bound, of the linear solves for the values
    scale : (k, r) size to which the bound is compared, to decide whether the identity proves anything
    always : whether the compiled model must have a value wherever the expression has one
    """

    names: Sequence[str]
    terms: Sequence[Rounded]
    more: Vector | float = 0.0
    scale: Vector | float = 0.0
    always: bool = False


def expressions(
    model: Mechanism, v: Vector, compiled: CompiledValues, symbolic: SymbolicValues, trusted: bool = False
) -> Iterator[Identity]:
    """Yield the identities of single expressions and their derivatives; v (k, n). `trusted`: see `evaluate`."""
    rates = [f"{name_of(x)}'" for x in model.coordinates]
    rows = row_names(model)
    second = [f"d2T / d{one} d{two} of kinetic_energy" for one in rates for two in rates]
    size, pace = geometric(compiled.factored), rounded(v)
    yield _momenta(rates, compiled, symbolic, pace) if trusted else _equal(second, compiled.M, symbolic.M, size)
    heavy_ones = model.n - len(model.states)  # states are velocities without energy
    squares, products = 0.5 * pace[:, :, None] * symbolic.M * pace[:, None, :], symbolic.G * pace
    squares = squares[:, :heavy_ones, :heavy_ones]
    T2, T1, T0, V = compiled.energies.T[:, :, None]
    yield Identity(["T2 of kinetic_energy"], [rounded(T2), -_summed(flat(squares))], always=True)
    yield Identity(["T1 of kinetic_energy"], [rounded(T1), -_summed(products)], scale=np.abs(T2), always=True)
    yield _equal(["T0 of kinetic_energy"], T0, symbolic.T0[:, None])
    yield _equal(["potential_energy"], V, symbolic.V[:, None])
    unit = np.sqrt(np.abs(np.einsum("kii->ki", compiled.factored)))[:, None, :]
    heavy = unit * np.abs(compiled.A / unit).max(axis=2, keepdims=True, initial=0.0)
    names = [f"the factor of {rate} in {row}" for row in rows for rate in rates]
    yield replace(_equal(names, compiled.A, symbolic.A, heavy), more=_turned(model) * flat(rounded(heavy)).bound)
    moving = _summed(rounded(compiled.A) * pace[:, None, :])
    yield Identity(rows, [rounded(compiled.b), -symbolic.row, moving], always=True)
    yield _equal(rows[: model.h], compiled.phi, symbolic.phi)
    yield _equal([f"quasi_velocities[{name_of(y)}]" for y, _ in model.quasi_velocities], compiled.quasi, symbolic.quasi)
    yield _equal([f"events[{name}]" for name, _ in model.events], compiled.events, symbolic.events)
    shapes = enumerate(model.drawing)
    yield _equal([f"drawing[{k}]" for k, shape in shapes for _ in shape.numbers], compiled.drawn, symbolic.drawn)


def _momenta(rates: Sequence[str], compiled: CompiledValues, symbolic: SymbolicValues, pace: Rounded) -> Identity:
    """Return M v = dT/dv - G, with the compiled M. At random v no error of M goes unnoticed."""
    names = [f"dT / d{one} of kinetic_energy" for one in rates]
    products = rounded(compiled.M) * pace[:, None, :]
    sizes = EPS * np.einsum("kij,kj->ki", geometric(compiled.M), np.abs(pace.value))
    moving = Rounded(products.value.sum(axis=2), products.bound.sum(axis=2))
    return Identity(names, [moving, -symbolic.momentum, symbolic.G], sizes, sizes / EPS, always=True)


def motion(
    model: Mechanism, v: Vector, compiled: CompiledValues, symbolic: SymbolicValues, errors: Errors
) -> Iterator[Identity]:
    """Yield Lagrange's equations (7), the differentiated constraints, and the outputs, which use their solution."""
    names = [f"the equation of motion of {name_of(x)}" for x in model.coordinates]
    yield Identity(names, equations(compiled, symbolic), errors.solved, errors.solved / EPS)
    own = model.n - len(model.states)  # no force acts on states, whose rates may depend on multipliers
    required = [term[:, :own] for term in (*equations(compiled, symbolic)[:-1], -rounded(compiled.required))]
    yield Identity([f"inverse dynamics of {name_of(x)}" for x in model.coordinates[:own]], required,
                   errors.solved[:, :own], errors.solved[:, :own] / EPS)  # fmt: skip
    size = np.einsum("kri,ki->kr", np.abs(symbolic.A.value), np.abs(compiled.a))
    size += np.einsum("kri,ki->kr", np.abs(symbolic.A_rate.value), np.abs(v))
    yield Identity([f"{row}, differentiated," for row in row_names(model)], [symbolic.row_rate], errors.rows, size)
    yield Identity([f"outputs[{name}]" for name, _ in model.outputs], [rounded(compiled.outputs), -symbolic.outputs])


def equations(compiled: CompiledValues, symbolic: SymbolicValues) -> list[Rounded]:
    """Return the terms of d/dt dT/dxdot - dT/dx + dV/dx - Q + A^T lambda, (k, n) each."""
    push = applied(symbolic.A.turned, rounded(compiled.multipliers))
    return [symbolic.momentum_rate, -symbolic.T_x, symbolic.V_x, -symbolic.Q, push]


def _turned(model: Mechanism) -> bool:
    """Whether rows contain functions of bodies. Recursions turn vectors to other axes, which rounds zeros, too."""
    return any(one.has(BodyFunction) for one in (*model.holonomic_constraints, *model.nonholonomic_constraints))


def row_names(model: Mechanism) -> list[str]:
    """Return the names of the constraint rows, as in error messages of a Model."""
    kinds = {"holonomic_constraints": model.h, "nonholonomic_constraints": model.m - model.h}
    return [f"{kind}[{k}]" for kind, count in kinds.items() for k in range(count)]


def flat(values: Rounded) -> Rounded:
    """Return an array (k, ...) as (k, r)."""
    return Rounded(*(part.reshape(len(part), -1) for part in (values.value, values.bound)))


def _equal(names: Sequence[str], compiled: Vector, symbolic: Rounded, scale: Vector | float = 0.0) -> Identity:
    wide = np.broadcast_to(scale, compiled.shape).reshape(len(compiled), -1)
    return Identity(names, [flat(rounded(compiled)), -flat(symbolic)], scale=wide, always=True)


def _summed(terms: Rounded) -> Rounded:
    """Return sums over the last axis; (k, 1) of (k, r)."""
    value, bound = (part.sum(axis=-1, keepdims=terms.value.ndim == 2) for part in (terms.value, terms.bound))
    return Rounded(value, bound)
