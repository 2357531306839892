"""Assembly: a consistent state from a rough guess."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import least_squares

from ...arguments.named_values import Vector, is_named, rate_name, spelled, unknown
from ...arguments.options import is_system, no_system
from ...codegen.model import ModelError
from ...codegen.model.normalise import number
from ...compiled.compiled_system import CompiledSystem
from ...compiled.projection import ConsistentState, Projection, check_resolved, closure, length
from ...runtime import CompiledModel, EvaluationError, Prepared
from ..state.active_contacts import Surfaces, Switch, holding
from ..state.operating_point import OperatingPoint
from ..state.tangent_space import null_space

_STARTS = 30
"""Number of random starts of the search before it fails."""
_CLOSED = 1e4
"""Largest residual phi, in roundings of its terms."""
_CONTRADICTS = 1e-8
"""Relative residual of a row above which given rates contradict the constraints."""


class Assembly(ConsistentState):
    """A state on the constraints; unpacks as (x, v), each (n,).

    Attributes
    ----------
    those of `ConsistentState`, and
    branch : 1 or -1, the sign of a determinant that distinguishes the ways of closing the loops; 0: no loops, or a
        position where these ways meet
    same_branch : whether the model's own start is on this branch
    message : description of the result
    """

    branch: int
    same_branch: bool
    message: str


def assemble(
    system: CompiledSystem,
    x0: Mapping[Any, float] | ArrayLike | None = None,
    v0: Mapping[Any, float] | ArrayLike | None = None,
    *,
    t: float = 0.0,
    parameters: Any = None,
    keep: Sequence[Any] = (),
) -> Assembly:
    """Return a consistent state near a rough guess, with its distance from the guess and its branch.

    A guess inside a contact is moved to its surface.

    Parameters
    ----------
    x0
        A guess, over the model's `initial`.
    v0
        Rates. The rates in a mapping are kept, and the others follow. An array is a guess: the result is near it.
    keep
        Coordinates that keep the values of x0 exactly.

    Raises
    ------
    ModelError
        Unknown names; no closed configuration was found, or given rates contradict the constraints (names the rows).

    Examples
    --------
    >>> import eigenmotion as em
    >>> system = em.build("models/four_bar.py", formulation="lagrange")
    >>> em.assemble(system, {"q1": 1.0, "q2": 0.5, "q3": 1.5}, keep=["q1"]).message
    "q3 moved most, by -0.062; closed on the branch of the model's start"
    """
    if not is_system(system):
        raise no_system("assemble", system)
    c, prepared, t = system.compiled, system.prepare(parameters), number(t, "t")
    x, v = system.begin(x0, v0, t, prepared)
    fixed = _indices(keep, system.coordinates, "keep")
    with np.errstate(all="ignore"):  # numbers that are not finite are reported by name
        closed = _closed_outside_contacts(c, prepared, t, x, v, fixed)
        check_resolved(c, prepared, t, closed)
        rates = [*_given_rates(v0, system.coordinates), *range(system.n, c.n)]
        moving = _moving(c, prepared, t, closed, v, rates)
        return _assembly(c, prepared, t, (x, v), (closed, moving))


def _indices(names: object, known: tuple[str, ...], what: str) -> list[int]:
    if isinstance(names, str) or not isinstance(names, Sequence):
        raise ModelError(f"{what} is {names!r}: give a list of coordinates")
    spelt = [spelled(name) for name in names]
    if wrong := set(spelt) - set(known):
        raise ModelError(unknown(f"coordinate in {what}", wrong, known))
    return sorted({known.index(name) for name in spelt})


def _given_rates(v0: object, coordinates: tuple[str, ...]) -> list[int]:
    """Return the indices of coordinates whose rates are kept: those in a mapping (not quasi-velocities)."""
    if not is_named(v0):
        return []
    names = {rate_name(key) for key in v0.keys()}  # noqa: SIM118  (pandas' Series)
    return [k for k, name in enumerate(coordinates) if name in names]


# --- positions ----------------------------------------------------------------------------------------------------


def _closed(c: CompiledModel, prepared: Prepared, t: float, x: Vector, v: Vector, fixed: list[int]) -> Vector:
    if c.h == 0:
        return x
    if not fixed:
        try:
            return Projection(c, prepared, t, least_norm=True)(x, v).x
        except EvaluationError:
            pass
    loop = _Loop(c, prepared, t, x, v, [k for k in range(c.n) if k not in fixed])
    return loop.closed()


def _closed_outside_contacts(
    c: CompiledModel, prepared: Prepared, t: float, x: Vector, v: Vector, fixed: list[int]
) -> Vector:
    """Return a nearby closed position outside all contacts; contacts that would be penetrated touch."""
    touching: list[Switch] = []
    there = OperatingPoint(c, prepared, t, x, v, c.input_defaults)
    for _ in range(len(c.switches) + 1):
        at = holding(there, touching) if touching else there
        try:
            closed = _closed(c, at.prepared, t, x, v, fixed)
        except ModelError as error:
            raise (_named(c, touching, fixed, error) if touching else error) from None
        if not c.switches or not (inside := [one for one, _ in Surfaces(there.at(t, closed, v)).inside()]):
            return closed
        touching += inside
    raise ModelError(f"{c.name}: no place near x0 is outside of all contacts. Begin elsewhere")


def _named(c: CompiledModel, touching: list[Switch], fixed: list[int], error: ModelError) -> ModelError:
    names = ", ".join(one.words(c) for one in touching)
    kept = f" with {', '.join(c.coordinates[k] for k in fixed)} kept" if fixed else ""
    why = str(error).removeprefix(f"{c.name}: ")
    return ModelError(f"{c.name}: x0 is inside {names}, and{kept} it cannot be put on the surface: {why}")


class _Loop:
    """Solution of phi(x, t) = 0 for some coordinates, with the others fixed."""

    def __init__(self, c: CompiledModel, prepared: Prepared, t: float, x: Vector, v: Vector, free: list[int]) -> None:
        self.c, self.prepared, self.t, self.x, self.v, self.free = c, prepared, t, x, v, free

    def closed(self) -> Vector:
        """Return the solution near x, or the nearest of those from random starts."""
        best = self._from(self.x[self.free])
        if self._is_closed(best):
            return best
        random, candidates = np.random.default_rng(1), [best]
        size = np.maximum(np.abs(self.x), np.abs(self.c.initial_x))[self.free]
        spans = np.where(size > 0.0, size, np.pi), np.full(len(self.free), np.pi)  # lengths, and angles
        away = (random.normal(size=len(self.free)) * spans[k % 2] for k in range(_STARTS))
        candidates.extend(self._from(self.x[self.free] + step) for step in away)
        closed = [x for x in candidates if self._is_closed(x)]
        if not closed:
            self._refuse(min(candidates, key=lambda x: float(np.linalg.norm(self._phi(x)[0]))))
        return min(closed, key=lambda x: float(np.linalg.norm((x - self.x) * self._inertia())))

    def _inertia(self) -> Vector:
        return OperatingPoint(self.c, self.prepared, self.t, self.x, self.v, self.c.input_defaults).inertia

    def _whole(self, q: Vector) -> Vector:
        x = self.x.copy()
        x[self.free] = q
        return x

    def _phi(self, x: Vector) -> tuple[Vector, Vector]:
        return self.c.position(self.t, x, self.prepared)

    def _from(self, q: Vector) -> Vector:
        def phi(q: Vector) -> Vector:
            return self._phi(self._whole(q))[0]

        def slope(q: Vector) -> Vector:
            return self.c.pfaffian(self.t, self._whole(q), self.prepared)[0][: self.c.h, self.free]

        if not self.free:
            return self.x
        if not (np.isfinite(phi(q)).all() and np.isfinite(slope(q)).all()):
            return self._whole(q)
        q = np.asarray(least_squares(phi, q, slope, x_scale="jac", xtol=1e-15, ftol=1e-15, gtol=1e-15).x)
        for _ in range(3):
            if np.isfinite(slope(q)).all() and np.isfinite(phi(q)).all():
                q = q - np.linalg.lstsq(slope(q), phi(q), rcond=1e-9)[0]
        return self._whole(q)

    def _is_closed(self, x: Vector) -> bool:
        phi, rounding = closure(self.c, self.prepared, self.t, x)
        return bool((np.abs(phi) <= _CLOSED * rounding).all())

    def _refuse(self, x: Vector) -> None:
        phi, rounding = closure(self.c, self.prepared, self.t, x)
        left = np.flatnonzero(~(np.abs(phi) <= _CLOSED * rounding)).tolist()
        rows = ", ".join(f"{self.c.row_names[k]} by {phi[k]:.3g}" for k in left)
        names = [name for k, name in enumerate(self.c.coordinates) if k not in self.free]
        kept = f" with {', '.join(names)} kept" if names else ""
        raise ModelError(
            f"{self.c.name}: the constraints cannot be closed{kept}: tried from x0 and {_STARTS} random "
            f"places, and at the best they are off, {rows}. Look at the lengths{', or keep less' * bool(names)}"
        )


# --- rates --------------------------------------------------------------------------------------------------------


def _moving(c: CompiledModel, prepared: Prepared, t: float, x: Vector, v: Vector, given: list[int]) -> Vector:
    """Return v with A v + b = 0: given rates unchanged, the others nearest in the mass metric."""
    if c.m == 0:
        return v
    A, b = c.pfaffian(t, x, prepared)
    M = c.factored_matrix(t, x, prepared)
    free = [k for k in range(c.n) if k not in given]
    v = v.copy()
    if free:
        L = np.linalg.cholesky(M[np.ix_(free, free)])
        B = np.linalg.solve(L, A[:, free].T).T
        row = np.sqrt((B**2).sum(axis=1))
        whole = np.sqrt(((A / np.sqrt(np.diag(M))) ** 2).sum(axis=1))
        unit = 1.0 / np.where(row > 1e-12 * whole, row, np.inf)
        change = np.linalg.lstsq(B * unit[:, None], -(A @ v + b) * unit, rcond=1e-9)[0]
        v[free] += np.linalg.solve(L.T, change)
    left, terms = np.abs(A @ v + b), np.abs(A) @ np.abs(v) + np.abs(b)
    inertia = np.sqrt(np.diag(M))
    rounding = _CLOSED * np.finfo(float).eps * np.linalg.norm(A / inertia, axis=1) * np.linalg.norm(v * inertia)
    if (wrong := ~(left <= _CONTRADICTS * terms + rounding)).any():
        rows = ", ".join(f"{c.row_names[k]} by {left[k]:.3g}" for k in np.flatnonzero(wrong))
        names = ", ".join(c.coordinates[k] for k in given) or "none"
        raise ModelError(f"{c.name}: the rates that v0 gives ({names}) contradict the constraints, {rows}. Give fewer")
    return v


# --- result -------------------------------------------------------------------------------------------------------


def _assembly(c: CompiledModel, prepared: Prepared, t: float, guess: tuple[Vector, Vector],
              found: tuple[Vector, Vector]) -> Assembly:  # fmt: skip
    (x0, v0), (x, v) = guess, found
    dx, dv = x - x0, v - v0
    distance = length(c.factored_matrix(t, x0, prepared), dx)
    velocity_distance = length(c.factored_matrix(t, x, prepared), dv)
    branch, own = _branches(c, prepared, t, x)
    message = _words(c, dx, branch, own)
    n = c.n_coordinates
    return Assembly(x[:n], v[:n], dx=dx[:n], dv=dv[:n], distance=distance, velocity_distance=velocity_distance,
                    branch=branch, same_branch=branch == own, message=message)  # fmt: skip


def _branches(c: CompiledModel, prepared: Prepared, t: float, x: Vector) -> tuple[int, int]:
    """Return the signs of det(dphi/dx) for dependent coordinates and independent rows, at x and the model's start."""
    A = c.pfaffian(t, x, prepared)[0][: c.h]
    if not len(A):
        return 0, 0
    unit = 1.0 / np.sqrt(np.diag(c.factored_matrix(t, x, prepared)))
    dependent = [k for k in range(c.n) if k not in null_space(A, unit)[0]]
    rows = [k for k in range(c.h) if k not in null_space(A[:, dependent].T, np.ones(c.h))[0]]
    at_start = c.pfaffian(t, c.initial_x, prepared)[0][: c.h]
    here, own = (int(np.sign(np.linalg.det(a[np.ix_(rows, dependent)]))) for a in (A, at_start))
    return here, own


def _words(c: CompiledModel, dx: Vector, branch: int, own: int) -> str:
    k = int(np.abs(dx).argmax())
    moved = f"{c.coordinates[k]} moved most, by {dx[k]:.3g}" if dx.any() else "nothing moved"
    if not branch:
        return moved
    return f"{moved}; closed on the branch of the model's start" if branch == own else f"{moved}; closed the other way"
