"""Projection of a state onto the constraints in the mass metric."""

from dataclasses import dataclass
from math import sqrt

import numpy as np

from ..arguments.named_values import Vector
from ..codegen.model import ModelError
from ..runtime import CompiledModel, Prepared

RESOLVED = 1e-6
"""Largest relative change of rows and slopes from one double to the next."""
_ENOUGH = 100
"""Largest number of steps along the constraints; each reduces the rest by a factor of about (distance x curvature)."""


class ConsistentState(tuple[Vector, Vector]):
    """(x, v), each (n,), on the constraints; unpacks as a pair.

    Attributes
    ----------
    x, v : (n,)
    dx, dv : (n,), change of each coordinate [u_k] and each velocity [u_k / s]
    distance : sqrt(dx^T M dx) [sqrt(J) s], with M at the original x0 (the mass metric)
    velocity_distance : sqrt(dv^T M dv) [sqrt(J)], with M at x: half its square is the kinetic energy of dv
    """

    x: Vector
    v: Vector
    dx: Vector
    dv: Vector
    distance: float
    velocity_distance: float

    def __new__(cls, x: Vector, v: Vector, **moved: object) -> "ConsistentState":
        """Make the pair; see the attributes."""
        pair = super().__new__(cls, (x, v))
        pair.__dict__.update(moved, x=x, v=v)
        return pair

    def of_coordinates(self, n: int) -> "ConsistentState":
        """Return the state of the first n numbers: the others are first-order states, which no constraint changes."""
        if len(self.x) == n:
            return self
        parts = {name: getattr(self, name)[:n] for name in ("x", "v", "dx", "dv")}
        return ConsistentState(**self.__dict__ | parts)

    def __repr__(self) -> str:
        return f"ConsistentState(x={self.x}, v={self.v}, distance={self.distance:.3g})"

    def __reduce__(self) -> tuple[object, ...]:
        return _remade, (self.__dict__,)


def _remade(fields: dict[str, Vector]) -> ConsistentState:
    return ConsistentState(**fields)


@dataclass(frozen=True, slots=True)
class Projection:
    """Projection in the mass metric at one time and parameter set.

    least_norm : the treatment of dependent constraint rows
    """

    model: CompiledModel
    prepared: Prepared
    t: float
    least_norm: int

    def __call__(self, x0: Vector, v0: Vector) -> ConsistentState:
        """Return the state with phi(x, t) = 0 and A v + b = 0 nearest to x0, v0.

        Minimises (x - x0)^T M(x0) (x - x0), then (v - v0)^T M(x) (v - v0). Newton's method in the mass metric reaches
        phi = 0. Steps along the constraints, each followed by Newton's method, remove the tangential part of x - x0.

        Raises
        ------
        EvaluationError
            phi = 0 is not reached, constraint rows depend on each other, or M is singular; names the row.
        ModelError
            The nearest state is not finite, or so large that rounding hides whether it is on the constraints.
        """
        with np.errstate(all="ignore"):  # `_checked` reports numbers that are not finite
            return self._checked(self._nearest(x0, v0))

    def _nearest(self, x0: Vector, v0: Vector) -> ConsistentState:
        M = self._mass(x0)
        x, v = self._reached(x0, v0)
        for _ in range(_ENOUGH if self.model.h else 0):
            tangential = self._tangential(M, x, x - x0)
            if length(M, tangential) <= 1e-15 * length(M, x) + 1e-12 * length(M, x - x0):
                break
            nearer, v = self._reached(x - tangential, v0)
            if not length(M, nearer - x0) < length(M, x - x0):
                break
            x = nearer
        x, v = self._reached(*self._reached(x, v0))  # twice: v0 may have been much larger than v, and so its rounding
        dx, dv = x - x0, v - v0
        moved = {"dx": dx, "dv": dv, "distance": length(M, dx), "velocity_distance": length(self._mass(x), dv)}
        return ConsistentState(x, v, **moved)

    def _checked(self, nearest: ConsistentState) -> ConsistentState:
        names = self.model.coordinates
        if not np.isfinite(nearest.distance + nearest.velocity_distance):
            self.model.check_table_arguments(self.t, nearest.x - nearest.dx, nearest.v - nearest.dv, self.prepared)
        if not np.isfinite(nearest).all():
            k = int(np.argmin(np.isfinite(nearest).all(axis=0)))
            raise ModelError(f"{self.model.name}: what is nearest to x0, v0 on the constraints is not finite at "
                             f"{names[k]!r}. Give smaller numbers")  # fmt: skip
        check_resolved(self.model, self.prepared, self.t, nearest.x)
        return nearest

    def _reached(self, x: Vector, v: Vector) -> tuple[Vector, Vector]:
        return self.model.project(self.t, x, v, self.prepared, self.least_norm)

    def _mass(self, x: Vector) -> Vector:
        return self.model.factored_matrix(self.t, x, self.prepared)

    def _tangential(self, M: Vector, x: Vector, d: Vector) -> Vector:
        """Return the part of d along the constraints at x: d - M^-1 A^T (A M^-1 A^T)^+ A d."""
        A = self.model.pfaffian(self.t, x, self.prepared)[0][: self.model.h]
        W = np.linalg.solve(M, A.T)
        lengths = np.sqrt(np.einsum("ij,ji->i", A, W))
        units = 1.0 / np.where(lengths > 0.0, lengths, 1.0)  # unit rows, so that dependence does not depend on units
        A, W = units[:, None] * A, W * units
        return np.asarray(d - W @ np.linalg.lstsq(A @ W, A @ d, rcond=1e-12)[0])


def check_resolved(model: CompiledModel, prepared: Prepared, t: float, x: Vector) -> None:
    """Refuse positions at which the holonomic rows change from one double to the next, as for angles of 1e16.

    There phi vanishes within rounding for any state, so that it says nothing.

    Raises
    ------
    ModelError
        Names the coordinate.
    """
    A = model.pfaffian(t, x, prepared)[0][: model.h]
    for k, name in enumerate(model.coordinates if model.h else ()):
        beside = model.pfaffian(t, next_to(x, k), prepared)[0][: model.h]
        if not np.linalg.norm(beside - A) <= RESOLVED * np.linalg.norm(A):
            raise ModelError(
                f"{model.name}: {name} = {x[k]:.6g} is so large that from it to the next number the constraints are "
                "others: nobody can tell whether they hold. Give an angle nearer to 0, or a length in another unit"
            )


def next_to(x: Vector, k: int) -> Vector:
    """Return x with x_k replaced by the next double."""
    beside = x.copy()
    beside[k] += np.spacing(beside[k])
    return beside


def length(M: Vector, d: Vector) -> float:
    """Return sqrt(d^T M d), in the mass metric."""
    return sqrt(max(float(d @ M @ d), 0.0))


def closure(c: CompiledModel, prepared: Prepared, t: float, x: Vector) -> tuple[Vector, Vector]:
    """Return phi (h,) and the residuals (h,) that are rounding: of its terms, and of steps to x in the mass metric."""
    phi, terms = c.position(t, x, prepared)
    A = c.pfaffian(t, x, prepared)[0][: c.h]
    unit = np.sqrt(np.diag(c.factored_matrix(t, x, prepared)))
    with np.errstate(all="ignore"):
        size = np.linalg.norm(A / unit, axis=1) * np.linalg.norm(x * unit)
    eps = np.finfo(float).eps
    return phi, eps * (terms + eps * np.where(np.isfinite(size), size, 0.0))
