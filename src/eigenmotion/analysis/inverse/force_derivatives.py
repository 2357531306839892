"""Exact derivatives of inverse dynamics.

Forces tau and multipliers lambda of a motion are the solution of

    B tau - P^T lambda = r = M a - f,   W tau = B^T mu,   P mu = 0

where tau has the least tau^T W tau, and mu are the multipliers of that choice (Karush-Kuhn-Tucker). P is A, unless
friction is proportional to reactions: then P^T are the derivatives of reactions and friction by lambda. Derivatives
solve the equations differentiated, whose right sides follow from the partial derivatives of M a - f + P^T lambda at
fixed a, lambda and inputs (equation_partials). Reactions are eliminated by the null space N of P: N^T B dtau = N^T dr.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...arguments.named_values import Vector, spelled, unknown
from ...codegen.model.normalise import ModelError
from ...compiled.compiled_system import CompiledSystem
from ...runtime import Actuators, CompiledModel
from ...runtime.variations import equation_partials, reaction_rows
from .actuators import actuators_of, columns_of
from .contact_forces import check_inside_bounds
from .contact_modes import by_mode
from .inverse_dynamics import required
from .motion_arguments import Motion, motion_of

_DEPENDENT = 1e-8
"""Least singular value of rows, or of columns, of length one that counts."""
_VANISHES = 1e-12
"""Of the forces of inertia and of actuators: reactions that are smaller have no direction."""


@dataclass(frozen=True)
class ForceDerivatives:
    """Derivatives of the forces of a motion; with k states, the last axis of each array is theirs.

    forces : (count,), in the order of the actuators
    dx, dv, da : (count, n)
    by : name -> (count,), of parameters, inputs and first-order states
    """

    forces: Vector
    dx: Vector
    dv: Vector
    da: Vector
    by: dict[str, Vector]


def inverse_dynamics_derivatives(
    system: CompiledSystem,
    x: Mapping[Any, Any] | ArrayLike,
    v: Mapping[Any, Any] | ArrayLike,
    a: Mapping[Any, Any] | ArrayLike,
    t: ArrayLike = 0.0,
    parameters: Any = None,
    inputs: Mapping[Any, Any] | ArrayLike | None = None,
    *,
    actuators: Any = None,
    by: Iterable[Any] = (),
) -> ForceDerivatives:
    """Return the derivatives of the forces of `inverse_dynamics` by x, v, a and names, exact.

    With constraints, a change of the forces is dx dot(x) + dv dot(v) + da dot(a) for changes that the constraints allow
    together. Frictions keep the direction in which they slide.

    Parameters
    ----------
    x, v, a, t, parameters, inputs, actuators
        As in `inverse_dynamics`.
    by
        Names of parameters, inputs (that are no actuators) and first-order states.

    Raises
    ------
    ModelError
        As `inverse_dynamics`; a name is unknown; actuators drive this motion, but not all motions beside it; there is
        a choice of actuators, and friction of a bearing with two reactions or more; reactions with friction vanish;
        or a contact or friction is at its bound.

    Examples
    --------
    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> found = em.build(model).inverse_dynamics_derivatives([0.5], [0.0], [2.0], by=["g"])
    >>> found.dx.round(6), found.da.round(6), found.by["g"].round(6)
    (array([[8.609085]]), array([[1.]]), array([0.479426]))
    """
    c = system.compiled
    of = actuators_of(c, actuators)
    motion = motion_of(system, x, v, a, t, parameters, inputs)
    forces, multipliers, _ = required(motion, of)
    places = _places(c, by, of)
    n, columns = c.n_coordinates, list(places.values())
    made = np.empty((len(motion.t), forces.shape[1], 3 * n + len(columns)))
    for rows, part in by_mode(motion, of) if c.switches else [(np.arange(len(motion.t)), motion)]:
        check_inside_bounds(part, multipliers[rows])
        for row, k in enumerate(rows):
            made[k] = _AtState(part, row, of, forces[k], multipliers[k]).derivatives(columns)
    dx, dv, da, rest = (motion.out(one) for one in np.split(made, [n, 2 * n, 3 * n], axis=2))
    return ForceDerivatives(motion.out(forces), dx, dv, da, {name: rest[:, k] for k, name in enumerate(places)})


def _places(c: CompiledModel, by: Iterable[Any], of: Actuators) -> dict[str, int]:
    """Return name -> column of the partial derivatives."""
    known = {name: c.n + k for k, name in enumerate(c.coordinates) if k >= c.n_coordinates}
    known |= {name: 2 * c.n + k for k, name in enumerate(c.inputs) if name not in of.names}
    known |= {name: 2 * c.n + c.n_inputs + k for k, name in enumerate(c.parameters) if name not in c.tables}
    names = [by] if isinstance(by, str) else list(map(spelled, by))
    if prescribed := [name for name in names if name in c.prescribed]:
        raise ModelError(
            f"{c.name}: input {prescribed[0]!r} prescribes a motion by its value and two derivatives, which x, v and a "
            "have. Take the derivatives by these."
        )
    if wrong := set(names) - set(known):
        raise ModelError(f"{c.name}: {unknown('parameter, input or state', wrong, tuple(known))}")
    return {name: known[name] for name in names}


class _AtState:
    """The equations of forces at one row of a motion, in units in which M has a unit diagonal."""

    def __init__(self, motion: Motion, row: int, of: Actuators, forces: Vector, multipliers: Vector) -> None:
        c, n = motion.model, motion.model.n_coordinates
        self.motion, self.row, self.of = motion, row, of
        self.t, self.x = float(motion.t[row]), motion.x[row]
        self.u = motion.u[row].copy()
        self.inputs = [k for k, name in enumerate(of.names) if name in c.inputs]
        for k in self.inputs:
            self.u[c.inputs.index(of.names[k])] = forces[k]
        self.multipliers, self.forces = multipliers, forces
        self.M = c.mass_matrix(self.t, self.x, motion.prepared)[:n, :n]
        factored = c.factored_matrix(self.t, self.x, motion.prepared)
        self.unit = 1.0 / np.sqrt(np.diag(factored)[:n])
        self.whole = self.partials(multipliers, self.u)
        self.roots = np.sqrt(np.ones(len(forces)) if of.weights is None else np.array(of.weights))
        self.B = self._columns() * self.unit[:, None] / self.roots
        P = self._reaction_rows()[:, :n] * self.unit
        self.lengths = np.linalg.norm(P, axis=1)
        self.lengths[self.lengths == 0.0] = 1.0
        self.P = P / self.lengths[:, None]

    def partials(self, multipliers: Vector, u: Vector) -> Vector:
        """Return the derivatives (n, n_arguments) of M a - f + P^T lambda at fixed a, lambda."""
        c, motion = self.motion.model, self.motion
        D: Vector = equation_partials(
            c, self.t, self.x, motion.v[self.row], motion.a[self.row], multipliers, motion.prepared, u
        )
        return D[: c.n_coordinates]

    def _reaction_rows(self) -> Vector:
        """Return P (m, n): the derivatives of reactions, with the friction that is proportional to them, by lambda."""
        c, motion = self.motion.model, self.motion
        rows, among = reaction_rows(c, self.t, self.x, motion.v[self.row], motion.prepared, self.u)
        self.bends = bool((among.sum(axis=1) > 1.0).any())
        P = rows[: c.m].copy()
        inertia = self.unit * (self.M @ motion.a[self.row, : len(self.M)])
        size = np.linalg.norm(inertia) + np.linalg.norm(self.B @ (self.roots * self.forces))
        for one, row in zip(among, rows[c.m :], strict=True):
            rho = np.linalg.norm(one * self.multipliers)
            reaction = np.linalg.norm((one * self.multipliers) @ rows[: c.m, : len(self.unit)] * self.unit)
            if not reaction > _VANISHES * size:
                raise ModelError(
                    f"{c.name}: reactions to which friction is proportional are zero at t = {self.t:g}, where forces "
                    "have no derivatives"
                )
            P += np.outer(one * self.multipliers / rho, row)
        return P

    def _columns(self) -> Vector:
        """Return B (n, count)."""
        c = self.motion.model
        by_inputs = -self.whole[:, 2 * c.n : 2 * c.n + c.n_inputs]
        return columns_of(c, self.of, by_inputs) if self.of.names else np.eye(c.n_coordinates)

    def derivatives(self, columns: list[int]) -> Vector:
        """Return the derivatives (count, 3 n + columns) by x, v, a and the arguments in these columns."""
        c, n = self.motion.model, self.motion.model.n_coordinates
        chosen = [*range(n), *range(c.n, c.n + n), *columns]
        right = np.hstack([self.whole[:, chosen[: 2 * n]], self.M, self.whole[:, columns]])
        if not self.of.names and not c.m:
            return right
        C = self._free_columns()
        free = self.N.T @ (right * self.unit[:, None]) / self.sizes[:, None]
        f = self._choice(C, chosen) if len(C) < C.shape[1] else np.zeros((len(self.forces), right.shape[1]))
        return np.asarray((f + _least(C, free - C @ f)) / self.roots[:, None])

    def _choice(self, C: Vector, chosen: list[int]) -> Vector:
        """Return the derivatives (count, ...) of the forces that only follow from the choice of the least of them."""
        if self.bends:
            raise ModelError(
                f"{self.motion.model.name}: friction is proportional to norms of two reactions or more, and there are "
                "more actuators than degrees of freedom; derivatives of the least forces are not available. Give as "
                "many actuators as there are degrees of freedom."
            )
        nu = _least(C.T, self.roots * self.forces)
        mu = self.N @ (nu / self.sizes)
        turning_P, turning_B = self._turning(mu * self.unit, chosen)
        particular = np.linalg.lstsq(self.P, -turning_P / self.lengths[:, None], rcond=_DEPENDENT)[0]
        return np.asarray(turning_B / self.roots[:, None] + self.B.T @ particular)

    def _free_columns(self) -> Vector:
        """Return C = N^T B (freedoms, count) with rows of length one; N: an orthonormal basis of P N = 0.

        Raises
        ------
        ModelError
            Actuators do not drive all motions that the constraints allow.
        """
        c = self.motion.model
        _, values, V = np.linalg.svd(self.P) if c.m else (None, np.zeros(0), np.eye(len(self.unit)))
        self.N = V[int((values > _DEPENDENT).sum()) :].T
        C = self.N.T @ self.B
        columns = np.linalg.norm(C, axis=0)
        self.sizes = np.linalg.norm(C, axis=1)
        driven = np.linalg.svd(C[:, columns > 0.0] / columns[columns > 0.0], compute_uv=False)
        if len(driven) < len(C) or not (len(C) == 0 or driven[-1] > _DEPENDENT):
            raise ModelError(
                f"{c.name}: {' and '.join(self.of.names)} drive this motion, but not every motion beside it, so that "
                "its forces have no derivatives. Give as many actuators as there are degrees of freedom."
            )
        return np.asarray(C / self.sizes[:, None])

    def _turning(self, mu: Vector, chosen: list[int]) -> tuple[Vector, Vector]:
        """Return dP mu (m, 3 n + ...) and dB^T mu (count, 3 n + ...)."""
        c, n = self.motion.model, self.motion.model.n_coordinates
        none, width = np.zeros(c.m), len(chosen) + n
        of_P, of_B = np.zeros((c.m, width)), np.zeros((len(self.forces), width))
        places = [*range(2 * n), *range(3 * n, width)]
        bare = self.partials(none, self.u)[:, chosen]
        for row, one in enumerate(np.eye(c.m)):
            of_P[row, places] = mu @ (self.partials(one, self.u)[:, chosen] - bare)
        for k in self.inputs:
            more = self.u.copy()
            more[c.inputs.index(self.of.names[k])] += 1.0
            of_B[k, places] = mu @ (bare - self.partials(none, more)[:, chosen])
        return of_P, of_B


def _least(K: Vector, g: Vector) -> Vector:
    """Return y of least norm with K y = g, which has solutions. Columns of a square K, of full rank, have any size."""
    if K.shape[0] == K.shape[1] and K.size:
        try:
            return np.asarray(np.linalg.solve(K, g))
        except np.linalg.LinAlgError:
            pass
    return np.asarray(np.linalg.lstsq(K, g, rcond=_DEPENDENT)[0])
