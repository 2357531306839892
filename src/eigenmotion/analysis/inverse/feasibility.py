"""Feasibility of prescribed motions: whether constraints allow them, and whether actuators can drive them."""

from collections.abc import Callable

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from ...runtime import Actuators
from .motion_arguments import Motion

WITHIN = 1e-6
"""Largest residual of a constraint, relative to its terms, that counts as satisfied: EM_ALLOWED of C."""
_DRIVEN = 1e-8
"""Part of the required forces, in the mass metric, that counts as driven by actuators: EM_DRIVEN of C."""
_LEAST = (64 * np.finfo(float).eps, 1e-12, 1e-12)
"""Residual of each equation that is rounding, relative to the lengths of the row and of x, v or a."""
_OF_ACCELERATIONS = 2
"""The number of their equation."""
_ROUNDED = 1e3
"""A residual is rounding if changes of x, v and a by a few units in the last place change it by this part of it."""
_SHOWN = 3
"""Coordinates that a message names."""
_EQUATIONS = (
    ("x", "phi(x) = 0", "em.assemble finds positions that do"),
    ("v", "A v + b = 0", "System.project_initial_state finds velocities that do"),
    ("a", "A a + gamma = 0", "accelerations that do are those of System.acceleration, and of prescribed inputs"),
)


def check_feasible(motion: Motion, of: Actuators, residual: Vector, checks: Vector) -> Vector:
    """Return the residuals (k, n), with those that are rounding set to zero.

    Raises
    ------
    ModelError
        Constraints do not allow a motion, or no actuator drives it; names the row, or the motion.
    """
    for row in np.flatnonzero(checks[:, 1] > WITHIN):
        _check_allowed(motion.rows([row]), checks[row], _at(motion, int(row)))
    for row in np.flatnonzero((checks[:, 0] > 0.0) & (checks[:, 0] <= _DRIVEN)):
        residual[row] = 0.0
    for row in np.flatnonzero(checks[:, 0] > _DRIVEN):
        one = motion.rows([row])
        if not _is_rounding(one, residual[row], lambda near: near.model.actuated_rows(*near.arguments, of)[2][0]):
            raise ModelError(_undriven(one, of, residual[row], _at(motion, int(row))))
        residual[row] = 0.0
    return residual


def _at(motion: Motion, row: int) -> str:
    return f" (state {row} of {len(motion.t)})" if motion.many else ""


def _check_allowed(one: Motion, check: Vector, where: str) -> None:
    """Raise ModelError if a constraint does not allow the motion of one row."""
    equation, row, c = int(check[2]), int(check[3]), one.model
    found = _residual(one, equation)[row : row + 1]
    w = np.abs((one.x, one.v, one.a)[equation])
    if equation == _OF_ACCELERATIONS:
        w = w + np.abs(_without_reactions(one))
    if abs(float(found[0])) <= _LEAST[equation] * _size(one, row, w):
        return
    if _is_rounding(one, found, lambda near: _residual(near, equation)[row : row + 1]):
        return
    what, text, remedy = _EQUATIONS[equation]
    name = f"{c.row_names[row]!r}" if row < len(c.row_names) and c.row_names[row] else f"number {row}"
    raise ModelError(
        f"{c.name}: {what}{where} does not satisfy constraint {name}: {text} is left by "
        f"{found[0]:.3g}, {check[1]:.1g} of its terms. {remedy}."
    )


def _size(one: Motion, row: int, w: Vector) -> float:
    """Return the length of a row of A times that of x, v or a, in the mass metric: what the row could be."""
    c, t = one.model, float(one.t[0])
    root = np.linalg.cholesky(c.factored_matrix(t, one.x[0], one.prepared))
    A = c.pfaffian(t, one.x[0], one.prepared)[0]
    return float(np.linalg.norm(np.linalg.solve(root, A[row])) * np.linalg.norm(w[0] @ root))


def _without_reactions(one: Motion) -> Vector:
    """Return the sizes (1, n) of accelerations that the acting forces cause, coordinate by coordinate."""
    c = one.model
    f = c.required_rows(one.t, one.x, one.v, 0.0 * one.a, one.u, one.prepared)[0]
    return np.asarray(f / np.diag(c.factored_matrix(float(one.t[0]), one.x[0], one.prepared)))


def _residual(one: Motion, equation: int) -> Vector:
    """Return phi (h,), A v + b (m,) or A a + gamma (m,)."""
    c = one.model
    if equation == 0:
        rows = c.position_rows(one.t, one.x, one.prepared)
    elif equation == 1:
        rows = c.constraint_rows(one.t, one.x, one.v, one.prepared)
    else:
        _, rows = c.required_rows(*one.arguments)
    return np.asarray(rows[0])


def _is_rounding(one: Motion, value: Vector, function: Callable[[Motion], Vector]) -> bool:
    """Return whether a value is of the size of its changes if x, v and a change by a few units in the last place."""
    draws = np.random.default_rng(0)
    largest = 0.0
    for _ in range(4):
        near = one.moved(lambda w: w * (1.0 + draws.integers(-4, 5, w.shape) * np.finfo(float).eps))
        largest = max(largest, float(np.abs(function(near) - value).max()))
    return bool(np.abs(value).max() <= _ROUNDED * largest)


def _without_force(one: Motion, of: Actuators) -> list[str]:
    """Return the actuators that are inputs on which no force depends, as of one that acts on first-order states."""
    c, n = one.model, one.model.n_coordinates
    names = [name for name in of.names if name not in c.coordinates[:n]]
    forces = c.required_rows(*one.arguments)[0][:, :n]

    def changed(name: str) -> Vector:
        u = one.u + np.eye(c.n_inputs)[c.inputs.index(name)]
        return np.asarray(c.required_rows(one.t, one.x, one.v, one.a, u, one.prepared)[0][:, :n])

    return [name for name in names if np.array_equal(changed(name), forces)]


def _undriven(one: Motion, of: Actuators, residual: Vector, where: str) -> str:
    """Return the message for a motion that no actuator drives."""
    c, n = one.model, one.model.n_coordinates
    M = c.factored_matrix(float(one.t[0]), one.x[0], one.prepared)[:n, :n]
    A = c.pfaffian(float(one.t[0]), one.x[0], one.prepared)[0][:, :n]
    moves = np.linalg.solve(M, residual[:n])
    moves /= moves[np.argmax(np.abs(moves) * np.sqrt(np.diag(M)))]
    order = sorted(range(n), key=lambda k: -abs(moves[k]) * np.sqrt(M[k, k]))[:_SHOWN]
    together = ", ".join(f"{c.coordinates[k]} by {moves[k]:.3g}" for k in order if abs(moves[k]) > _DRIVEN)
    root = np.linalg.cholesky(M)
    freedoms = n - (np.linalg.matrix_rank(np.linalg.solve(root, A.T)) if c.m else 0)
    names, count = " and ".join(of.names), len(of.names)
    idle = [f"input {name!r} changes no force on a coordinate" for name in _without_force(one, of)]
    why = (
        idle[0]
        if idle
        else f"it has {freedoms} degrees of freedom, and {count} actuator{'s' * (count > 1)}"
        if count < freedoms
        else "this position is singular for them"
    )
    return (
        f"{c.name}: {names} cannot drive this motion{where}: {why}. The motion in which {together} move together "
        f"lacks a force; on {c.coordinates[order[0]]} it is {residual[order[0]]:.6g}."
    )
