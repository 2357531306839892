"""Values of a compiled model at many points; NaN where it has no value."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...arguments.named_values import Vector
from ...runtime import CompiledModel, EvaluationError, Prepared
from ...system.system import System
from .arithmetic.rounding_bounds import EPS
from .test_points import Points

_STRIDE = 1e-4
"""Step of finite differences along the motion, relative to the time in which a coordinate changes by its own size."""


@dataclass(frozen=True, slots=True)
class CompiledValues:
    """Values at k points, which are the first axis.

    M, factored (k, n, n): M and the factored matrix; factored_rate, rate_off (k, n, n): the rate of `factored` along
    the motion by finite differences, and its error bound;
    A (k, m, n); b (k, m); phi (k, h); energies (k, 4); quasi (k, n or 0);
    events (k, n_events); drawn (k, n_drawn); a (k, n); multipliers (k, m); outputs (k, n_outputs);
    required (k, n): inverse dynamics at a; NaN if friction is proportional to multipliers;
    C (k, n, n); s (k, n); NaN if v is in the state, where they cost much and nothing needs them;
    y, dy (k, n_state); velocity (k, n) of y; root (k, n, n): R of eta = R v, NaN in other formulations than cholesky;
    least_norm (k,) whether rows depend on each other, so that the multipliers are those of least norm
    """

    M: Vector
    factored: Vector
    factored_rate: Vector
    rate_off: Vector
    A: Vector
    b: Vector
    phi: Vector
    energies: Vector
    quasi: Vector
    events: Vector
    drawn: Vector
    a: Vector
    multipliers: Vector
    outputs: Vector
    C: Vector
    s: Vector
    y: Vector
    dy: Vector
    velocity: Vector
    root: Vector
    least_norm: Vector
    required: Vector


def evaluate_compiled(system: System, points: Points) -> CompiledValues:
    """Evaluate all functions of a model at all points."""
    columns = zip(points.t, points.x, points.v, points.u, points.p, strict=True)
    rows = [_evaluate_one(system, *place) for place in columns]
    return CompiledValues(*(np.array(column) for column in zip(*rows, strict=True)))


def _evaluate_one(system: System, t: float, x: Vector, v: Vector, u: Vector, p: Vector) -> tuple[Vector, ...]:
    """Return the fields of CompiledValues at one point."""
    c = system.compiled
    try:
        prepared = c.prepare(p)
    except EvaluationError:
        return tuple(np.full(shape, np.nan) for shape in _shapes(c))
    time, position, moving, inputs = np.array([t]), x[None], v[None], u[None]
    a, multipliers = c.acceleration_rows(time, position, moving, inputs, prepared, False)
    least_norm = bool(np.isnan(a).any())
    if least_norm:
        a, multipliers = c.acceleration_rows(time, position, moving, inputs, prepared, True)
    unknown = np.full((1, c.n, c.n), np.nan), np.full((1, c.n), np.nan)
    C, s = unknown if "v" in system.layout else c.eigenfactor_rows(time, position, prepared)
    y = c.state_rows(time, position, moving, prepared)
    return (
        c.mass_matrix(t, x, prepared), c.factored_matrix(t, x, prepared), *_along(c, t, x, v, prepared),
        *c.pfaffian(t, x, prepared), c.position(t, x, prepared)[0], c.energy_rows(time, position, moving, prepared)[0],
        c.quasi_rows(time, position, moving, prepared)[0],
        c.event_rows(time, position, moving, inputs, _free(c, p, prepared))[0],
        c.drawn_rows(time, position, moving, prepared)[0],
        a[0], multipliers[0], c.observed_rows(time, position, moving, a, multipliers, inputs, prepared)[0],
        C[0], s[0], y[0],
        _rate(c, t, y[0], prepared, u, least_norm), c.velocity_rows(time, y, prepared)[0],
        _root(c, t, x, prepared) if system.formulation == "cholesky" else unknown[0][0], np.array(least_norm),
        unknown[1][0] if c.pushes else c.required_rows(time, position, moving, a, inputs, prepared)[0][0],
    )  # fmt: skip


def _root(c: CompiledModel, t: float, x: Vector, prepared: Prepared) -> Vector:
    """Return R (n, n): its columns are eta of states in which one coordinate moves."""
    n = c.n
    moving = c.state_rows(np.full(n, t), np.tile(x, (n, 1)), np.eye(n), prepared)
    return np.asarray(moving[:, n : 2 * n].T)


def _along(c: CompiledModel, t: float, x: Vector, v: Vector, prepared: Prepared) -> tuple[Vector, Vector]:
    """Return the rate (n, n) of the factored matrix by differences of fourth order, and its error; 0 if that is M."""
    if not c.augmented:
        return np.zeros((c.n, c.n)), np.zeros((c.n, c.n))
    moving = v != 0.0
    h = _STRIDE * float(np.min(np.abs(x[moving] / v[moving]), initial=np.inf))
    h = h if 0.0 < h < np.inf else _STRIDE
    ends = [[c.factored_matrix(t + s, x + s * v, prepared) for s in (span, -span)] for span in (h / 2, h, 2 * h)]
    half, one, two = (there - back for there, back in ends)
    fine, coarse = (8.0 * half - one) / (6.0 * h), (8.0 * one - two) / (12.0 * h)
    return fine, np.abs(fine - coarse) + 16.0 * EPS / h * np.abs(ends).max(axis=(0, 1))


def _free(c: CompiledModel, p: Vector, prepared: Prepared) -> Prepared:
    """Return the constants without closed contacts and stuck frictions, whose events depend on multipliers.

    Those multipliers are checked elsewhere.
    """
    if not c.switches:
        return prepared
    free = p.copy()
    free[[holds for _, holds, *_ in c.switches]] = 0.0
    return c.prepare(free)


def _rate(c: CompiledModel, t: float, y: Vector, prepared: Prepared, u: Vector, least_norm: bool) -> Vector:
    """Return dy; NaN if it has no value, or if rows depend on each other (only rounding can give a value then)."""
    try:
        return np.full(c.n_state, np.nan) if least_norm else c.rhs(t, y, prepared, u)
    except EvaluationError:
        return np.full(c.n_state, np.nan)


def _shapes(c: CompiledModel) -> tuple[tuple[int, ...], ...]:
    """Return the shapes of the fields of CompiledValues at one point."""
    n, m, state = c.n, c.m, (c.n_state,)
    return (*4 * ((n, n),), (m, n), (m,), (c.h,), (4,), (len(c.quasi_velocities),), (c.n_events,),
            (c.n_drawn,), (n,), (m,), (c.n_outputs,), (n, n), (n,), state, state, (n,), (n, n), (), (n,))  # fmt: skip
