"""Inverse dynamics: the forces that make a mechanism move as prescribed, through its constraints."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from ...compiled import at_state
from ...compiled.at_state import InverseDynamics
from ...compiled.compiled_system import CompiledSystem
from ...runtime import Actuators
from .actuators import actuators_of
from .contact_forces import with_pushing_contacts
from .contact_modes import by_mode
from .feasibility import check_feasible
from .motion_arguments import Motion, motion_of


def inverse_dynamics(
    system: CompiledSystem,
    x: Mapping[Any, Any] | ArrayLike,
    v: Mapping[Any, Any] | ArrayLike,
    a: Mapping[Any, Any] | ArrayLike,
    t: ArrayLike = 0.0,
    parameters: Any = None,
    inputs: Mapping[Any, Any] | ArrayLike | None = None,
    *,
    actuators: Any = None,
) -> InverseDynamics:
    """Return the forces that must act so that accelerations a result, through the constraints (11).

    Without constraints, forces = M a - f, by recursions for trees of bodies. With constraints forces are not unique
    where there are more actuators than degrees of freedom: these are the forces with the least weighted sum of squares.
    All such forces differ by reactions, A^T mu, and have the same motion.

    Parameters
    ----------
    x, v, a
        (n,), (n, k) for k states, or mappings coordinate -> number or (k,): x over `initial`, v and a over 0.
    t, inputs
        A number, or (k,) of each state; inputs as in `rhs`. Inputs that are actuators are not read.
    actuators
        Names of coordinates and inputs, or a mapping name -> weight of the squared force; None: all coordinates.

    Raises
    ------
    ModelError
        Constraints do not allow the motion; no actuator drives it (names the motion); a contact is closed and no
        actuators are named; or it would have to pull.
    EvaluationError
        M is singular, or friction jams.

    Examples
    --------
    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> em.build(model).inverse_dynamics([0.5], [0.0], [2.0]).forces.round(6)
    array([6.703165])
    """
    quick = at_state.inverse_dynamics(system, x, v, a, t, parameters, inputs, actuators)
    if quick is not None:
        return quick
    c = system.compiled
    of = actuators_of(c, actuators)
    motion = motion_of(system, x, v, a, t, parameters, inputs)
    forces, multipliers, residual = required(motion, of)
    return InverseDynamics(motion.out(forces), motion.out(multipliers), motion.out(residual[:, : c.n_coordinates]))


def required(motion: Motion, of: Actuators) -> tuple[Vector, Vector, Vector]:
    """Return forces (k, count), multipliers (k, m) and residuals (k, n) of the rows of a motion."""
    c = motion.model
    if not c.inverts:
        raise ModelError(f"{c.name} was written by hand and has no inverse dynamics")
    if not c.switches or not len(motion.t):
        return _of_rows(motion, of)
    parts = [(rows, _of_contacts(part, of)) for rows, part in by_mode(motion, of)]
    made = tuple(np.empty((len(motion.t), part.shape[1])) for part in parts[0][1])
    for rows, values in parts:
        for whole, part in zip(made, values, strict=True):
            whole[rows] = part
    return made[0], made[1], made[2]


def _of_contacts(motion: Motion, of: Actuators) -> tuple[Vector, Vector, Vector]:
    """Return what `_of_rows` does for rows in one mode; contacts push, and frictions are within their limits."""
    forces, multipliers, residual = _of_rows(motion, of)
    return *with_pushing_contacts(motion, forces, multipliers, of), residual


def _of_rows(motion: Motion, of: Actuators) -> tuple[Vector, Vector, Vector]:
    forces, multipliers, residual, checks = motion.model.actuated_rows(*motion.arguments, of)
    if not np.isfinite(forces).all():
        row = int(np.flatnonzero(~np.isfinite(forces).all(axis=1))[0])
        _refuse(motion, row, of)
    if (checks[:, :2] > 0.0).any():
        residual = check_feasible(motion, of, residual, checks)
    return forces, multipliers, residual


def _refuse(motion: Motion, row: int, of: Actuators) -> None:
    t, x, v, a, u, c = motion.arguments
    motion.model.refuse_actuated(float(t[row]), x[row], v[row], a[row], u[row], c, of)
