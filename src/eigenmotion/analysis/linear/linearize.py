"""Linearised equations of motion at a state."""

from collections.abc import Mapping
from itertools import combinations, islice
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...arguments.named_values import Vector
from ...codegen.model import ModelError
from ...compiled.compiled_system import CompiledSystem
from ...runtime import EvaluationError
from ...simulation.initial_state.consistency import check_consistent
from ..state.active_contacts import mode_of
from ..state.contact_mode import in_mode
from ..state.operating_point import OperatingPoint, operating_point
from ..state.output_derivatives import output_derivatives
from ..state.tangent_space import Tangent, tangent
from .linearization import Linearization, StateSpace
from .modes import Reduced, reduced

_STEADY = 1e-6
"""Largest relative change of the linearised equations over their time constant in a steady motion,"""
_STILL = 1e-9
"""and of the numbers on which they depend."""
_ROUNDING = 1e-13
"""Rounding of an entry, relative to the largest entry of its row."""
_CHOICES = 200
"""Most sets of independent velocities that are tried."""


def linearize(
    self: CompiledSystem,
    x: Mapping[Any, float] | ArrayLike | None = None,
    v: Mapping[Any, float] | ArrayLike | None = None,
    t: float = 0.0,
    parameters: Any = None,
    inputs: Mapping[Any, Any] | ArrayLike | None = None,
    *,
    mode: Mapping[Any, float] | None = None,
) -> Linearization:
    """Return the linearised equations of motion at a state, with exact derivatives, on the constraints.

    x, v are arrays or mappings over the model's `initial`. Constraint rows may depend on each other. If the motion
    through the state is not steady, `Linearization.steady` is False and `message` says so.

    Closed contacts and sticking frictions of the state are constraints of the deviations. If modes meet at the state,
    `mode` selects one, with names as in `Solution.modes`: {"floor_held": 0}.

    Raises
    ------
    ModelError
        The state violates the constraints (names the residuals and the nearest consistent state), or is inside a
        contact; the equations have no derivative (names the coordinate); modes meet and `mode` selects none, or an
        inconsistent one.
    EvaluationError
        M is singular, constraint rows contradict each other, or no mode of contacts and frictions is consistent.
    """
    at = operating_point(self, x, v, t, parameters, inputs)
    with np.errstate(all="ignore"):  # numbers that are not finite are reported by name
        at = in_mode(at, mode)
        check_consistent(at.model, at.prepared, at.t, at.x, at.v)
        return linearized(at)


def linearized(at: OperatingPoint) -> Linearization:
    """Return the linearised equations at a consistent state in its mode."""
    _check_differentiable(at)
    return _linearized(at)


def _linearized(at: OperatingPoint) -> Linearization:
    basis, steady = _chosen(at)
    n, every, full = at.coordinates, at.model.n, _full(at)
    Z = np.linalg.qr(basis.Z)[0]
    own = [*range(n), *range(every, 2 * every)]  # x, v, states
    shown = [*range(n), *range(every + n, 2 * every)]  # x, states
    return Linearization(
        model=at.model, t=at.t, x=at.x[:n], v=at.v[:n], z=at.v[n:], u=at.u, acceleration=at.motion[0][:n],
        A=Z.T @ full.A @ Z, B=Z.T @ full.B, C=full.C @ Z, D=full.D, Z=Z[own],
        full=StateSpace(full.A[np.ix_(own, own)], full.B[own], full.C[:, own], full.D),
        steady=steady, independent=_reduced(at, basis), basis=basis.Z[shown], inertia=at.inertia,
        mode=mode_of(at.model, at.prepared),
    )  # fmt: skip


def _check_differentiable(at: OperatingPoint) -> None:
    n, names = at.model.n, at.model.coordinates
    derivatives = at.motion[2][:, : 2 * n + at.model.n_inputs]
    if np.isfinite(derivatives).all():
        return
    by = (*names, *(f"{name}'" for name in names), *at.model.inputs)
    wrong = [repr(by[k]) for k in np.flatnonzero(~np.isfinite(derivatives).all(axis=0))]
    raise ModelError(f"{at.model.name}: accelerations have no derivative by {', '.join(wrong)} at this state. "
                     "Linearise beside it, or write what is not smooth there another way")  # fmt: skip


def _full(at: OperatingPoint) -> StateSpace:
    """Return A, B, C, D of all 2 n numbers (x, v)."""
    n, k = at.model.n, at.model.n_inputs
    B = np.vstack([np.zeros((n, k)), at.motion[2][:, 2 * n : 2 * n + k]])
    whole = output_derivatives(at)
    return StateSpace(at.jacobian, B, whole[:, : 2 * n], whole[:, 2 * n : 2 * n + k])


def _reduced(at: OperatingPoint, basis: Tangent) -> Reduced:
    """Return the system of independent coordinates and velocities, without those that no equation depends on."""
    return reduced(_of_independent(at, basis))


def _of_independent(at: OperatingPoint, basis: Tangent) -> Vector:
    """Return J Z in the rows of the independent numbers, with entries that are rounding errors set to zero."""
    numbers = list(basis.free)
    matrix, unit = at.jacobian[numbers] @ basis.Z, at.units[numbers]
    sizes = np.abs(unit[:, None] * matrix / unit)
    return np.where(sizes > _ROUNDING * sizes.max(axis=1, keepdims=True, initial=0.0), matrix, 0.0)


def _chosen(at: OperatingPoint) -> tuple[Tangent, bool]:
    """Return a basis of the tangent space, in constant independent numbers if possible, and whether they are constant.

    For example, x' and y' of a wheel that rolls on a circle change, but its spin and its lean do not. The choice of the
    independent velocities is free.
    """
    best = tangent(at)
    if _is_steady(at, best):
        return best, True
    n, rank = at.model.n, 2 * at.model.n - len([k for k in best.free if k >= at.model.n]) - at.model.n
    if rank and not at.rests:
        for dependent in islice(combinations(range(n), rank), _CHOICES):
            other = tangent(at, dependent)
            if _is_steady(at, other):
                return other, True
    return best, False


def _is_steady(at: OperatingPoint, basis: Tangent) -> bool:
    """Return whether the independent numbers, and the equations of their deviations, are constant along the motion.

    Coordinates that no equation depends on may change: cyclic angles, or the position of a wheel on the ground.
    """
    here = _reduced(at, basis)
    kept = list(here.kept)
    numbers = [basis.free[k] for k in kept]
    unit = at.units[numbers]
    rates = (np.concatenate([at.v, at.motion[0]]) * at.units * at.time)[numbers]
    size = np.linalg.norm(at.comparable * at.v) + np.linalg.norm(at.comparable * at.x) / at.time
    if not np.linalg.norm(rates) <= _STILL * size or (rates.any() and at.unresolved):
        return False
    scale = np.linalg.norm(unit[:, None] * here.core / unit)
    for ahead in (0.3 * at.time, at.time):
        moved = _moved(at, basis, ahead)
        if moved is None:
            return False
        change = moved[np.ix_(kept, kept)] - here.core
        if not np.linalg.norm(unit[:, None] * change / unit) <= _STEADY * scale:
            return False
    return True


def _moved(at: OperatingPoint, basis: Tangent, ahead: float) -> Vector | None:
    """Return the system in the same numbers a little later, or None if it does not exist there."""
    a = at.motion[0]
    there = at.at(at.t + ahead, at.x + ahead * at.v + ahead**2 / 2 * a, at.v + ahead * a)
    try:
        moved = _same_numbers(there, basis)
    except (EvaluationError, ValueError, np.linalg.LinAlgError):
        return None
    return moved if moved is not None and np.isfinite(moved).all() else None


def _same_numbers(there: OperatingPoint, basis: Tangent) -> Vector | None:
    """Return the system in the same independent numbers at another state, or None if they are dependent there."""
    n = there.model.n
    dependent = [k for k in range(n) if n + k not in basis.free]
    other = tangent(there, dependent)
    return _of_independent(there, other) if other.free == basis.free else None
