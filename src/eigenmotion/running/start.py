"""Whether a mechanism can start where it is told to."""

from dataclasses import dataclass
from itertools import combinations

import numpy as np

from ..arguments.names import Vector
from ..codegen.model import ModelError
from ..runtime import CompiledModel, EvaluationError, Prepared, forgiven
from .consistent import Projection

_CLOSE = 1e-6  # EM_EPSILON: gaps of eigenvalues, relative to the larger, at which Omega is continued
_SINGULAR_PIVOT = 1e-13  # EM_SINGULAR_PIVOT
_LAST_PLACES = 8 * np.finfo(float).eps  # EM_LAST_PLACES_OF_ALL
_STILL = 1e-9  # and the part of dM/dx, relative to all of it, below which equal eigenvalues stay so


def start_state(
    model: CompiledModel, prepared: Prepared, t: float, x: Vector, v: Vector, rtol: float, atol: Vector
) -> Vector:
    """Return y (n_state,) at x, v (n,), having checked M > 0, phi = 0, A v + b = 0 and that Omega is known.

    Left to the projection are residuals up to ten times rtol of the terms that cancel in a row, and what a change of
    every x_k and v_k by ten times atol_k would make.

    Raises
    ------
    ModelError
        One of them does not hold; says which coordinate or row, by how much, and which start would do. Or x is inside
        a contact.
    EvaluationError
        A coordinate is declared to have other values.
    """
    y = model.start(t, x, v, prepared, rtol, atol)
    if y is None:
        model.check_start(x)
        y = _Start(model, prepared, t, x, v).examined(*forgiven(rtol, atol))
        _check_contacts(model, prepared, t, x, v, rtol, atol)
    if model.extrapolates:
        _check_turning(model, prepared, t, x)
    return y


def _check_contacts(
    model: CompiledModel, prepared: Prepared, t: float, x: Vector, v: Vector, rtol: float, atol: Vector
) -> None:
    """Refuse a start within what a contact or an impact keeps apart: it would never come to strike."""
    if found := model.inside(t, x, v, prepared, rtol, atol):
        name, gap = found
        if model.events.index(name) not in {switch[0] for switch in model.switches}:
            raise ModelError(
                f"{model.name}: x0 is where the impact of event {name!r} lets nothing come: its phi is {gap:.6g}, "
                "and never negative. Start where it is at least 0, or turn the signs of phi and of the event."
            )
        raise ModelError(
            f"{model.name}: x0 is inside contact {name!r}: its gap is {gap:.6g} there, and never negative. Start where "
            "it is at least 0, or turn the sign of the gap."
        )


def check_direction(model: CompiledModel, start: float, end: float) -> None:
    """Refuse to run events backwards that act: what was before an impact or a reset does not follow from what is after.

    Raises
    ------
    ModelError
        The model has such events, and `end` is before `start`.
    """
    if model.acts and end < start:
        acting = [name for name, acts in zip(model.events, model.acting, strict=True) if acts]
        raise ModelError(
            f"{model.name}: t_span runs backwards, but events that act ({', '.join(map(repr, acting))}) do so forwards "
            "only: what was before an impact or a reset does not follow from what is after it. Run forwards."
        )


def check_consistent(model: CompiledModel, prepared: Prepared, t: float, x: Vector, v: Vector) -> None:
    """Refuse a state that is off the constraints by more than rounding in what the user computed, as `start_state`."""
    exact = np.zeros(model.n)
    if model.start(t, x, v, prepared, 0.0, exact) is None:
        _Start(model, prepared, t, x, v).examined(*forgiven(0.0, exact))


def _check_turning(model: CompiledModel, prepared: Prepared, t: float, x: Vector) -> None:
    """Refuse to extrapolate Omega (32) from where eigenvalues that part coincide: nothing says how axes turn."""
    C, s = (part[0] for part in model.eigenfactor_rows(np.array([t]), x[None], prepared))
    close = [
        (i, j)
        for i, j in combinations(range(model.n), 2)
        if model.block[i] == model.block[j] and abs(s[i] ** 2 - s[j] ** 2) < _CLOSE * max(s[i], s[j]) ** 2
    ]
    if not close:
        return
    mu = C @ (model.scales[:, None] * model.factored_gradient(t, x, prepared) * model.scales) @ C.T
    size = np.abs(mu).max(initial=0.0)
    for i, j in close:
        if max(np.abs(mu[:, i, j]).max(), np.abs(mu[:, i, i] - mu[:, j, j]).max()) > _STILL * size:
            names = ", ".join(repr(name) for name, block in zip(model.coordinates, model.block, strict=True)
                              if block == model.block[i])  # fmt: skip
            raise ModelError(
                f"{model.name}: eigenvalues of the mass matrix coincide at x0, among {names}, and "
                'close_eigenvalues="extrapolate" has nothing yet to extrapolate from. Start elsewhere, or build with '
                'close_eigenvalues="bounded", which runs through.'
            )


_OF_CONSTRAINTS = (
    ", not even along the constraints",
    " The weights of the constraints are those of the model's own initial values: give it others where x0 is far away.",
)


@dataclass(frozen=True, slots=True)
class _Start:
    """A start that the compiled checks (em_start.h) did not pass: the same ones, with what is wrong in words."""

    model: CompiledModel
    prepared: Prepared
    t: float
    x: Vector
    v: Vector

    def examined(self, tolerance: float, least: Vector) -> Vector:
        """Return y, or raise as `start_state`; least (n,): changes of x and v that are forgiven."""
        self._check_mass_matrix()
        self._check_position(tolerance, least)
        self._check_velocity(tolerance, least)
        try:
            y = self.model.state(self.t, self.x, self.v, self.prepared)
        except EvaluationError as error:
            raise ModelError(str(error)) from error
        if not np.isfinite(y).all():
            raise ModelError(f"{self.model.name}: the state at x0, v0 is not finite; look for a division by zero there")
        return y

    def _check_mass_matrix(self) -> None:
        names, M = self.model.coordinates, self.model.factored_matrix(self.t, self.x, self.prepared)
        if (k := _first_bad_pivot(M)) is None:
            return
        if not np.isfinite(M).all():
            i, j = (names[k] for k in np.argwhere(~np.isfinite(M))[0])
            raise ModelError(f"{self.model.name}: the mass matrix at x0 is not finite in row {i!r}, column {j!r}")
        alone, weights = _OF_CONSTRAINTS if self.model.augmented else ("", "")
        raise ModelError(
            f"{self.model.name}: the mass matrix at x0 is not positive definite at coordinate {names[k]!r}{alone}. "
            "Give it inertia (check x0 and the parameters in the kinetic energy), or leave the coordinate out."
            f"{weights}"
        )

    def _check_position(self, tolerance: float, least: Vector) -> None:
        if self.model.h == 0:
            return
        phi, terms = self.model.position(self.t, self.x, self.prepared)
        A = self.model.pfaffian(self.t, self.x, self.prepared)[0][: self.model.h]
        allowed = tolerance * terms + np.abs(A) @ least + self._last_places(A, self.x)
        self._refuse("x0 is off holonomic constraint", phi, allowed)

    def _check_velocity(self, tolerance: float, least: Vector) -> None:
        if self.model.m == 0:
            return
        A, b = self.model.pfaffian(self.t, self.x, self.prepared)
        terms = np.abs(A) @ np.abs(self.v) + np.abs(b)
        allowed = tolerance * terms + np.abs(A) @ least + self._last_places(A, self.v)
        self._refuse("v0 does not satisfy A v + b = 0 in constraint", A @ self.v + b, allowed)

    def _last_places(self, A: Vector, q: Vector) -> Vector:
        """What a change in the last places of x or v as a whole, in the mass metric, makes of rows."""
        M = self.model.factored_matrix(self.t, self.x, self.prepared)
        lengths = np.sqrt(np.abs(np.einsum("ri,ir->r", A, np.linalg.solve(M, A.T))))
        return np.asarray(_LAST_PLACES * np.sqrt(abs(q @ M @ q)) * lengths)

    def _refuse(self, what: str, residual: Vector, allowed: Vector) -> None:
        pairs = enumerate(zip(residual.tolist(), allowed.tolist(), strict=True))
        wrong = [(k, r) for k, (r, limit) in pairs if not abs(r) <= limit]  # NaN is wrong too
        if wrong:
            rows = ", ".join(f"{self.model.row_names[k]} by {r:.6g}" for k, r in wrong)
            raise ModelError(f"{self.model.name}: {what} {rows}. {self._offer()}")

    def _offer(self) -> str:
        remedy = "system.project_initial_state(x0, v0, t, parameters) returns the nearest consistent start"
        try:
            x, v = Projection(self.model, self.prepared, self.t, least_norm=True)(self.x, self.v)
        except (EvaluationError, ModelError):
            return f"em.assemble(system, x0) closes loops from guesses as rough as this; {remedy} from a closer one."
        return f"{remedy}: x0 = {_listed(x)}, v0 = {_listed(v)}."


def _first_bad_pivot(M: Vector) -> int | None:
    """Return the first k at which the pivot M_kk - M_k: M_::^-1 M_:k is not above rounding."""
    rest = M.copy()
    for k in range(len(M)):
        if not rest[k, k] > _SINGULAR_PIVOT * abs(M[k, k]):
            return k
        with np.errstate(all="ignore"):  # what is not finite makes a later pivot so
            rest -= np.outer(rest[:, k], rest[k]) / rest[k, k]
    return None


def _listed(values: Vector) -> str:
    return "[" + ", ".join(f"{value:.9g}" for value in values) + "]"
