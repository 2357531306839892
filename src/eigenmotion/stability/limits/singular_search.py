"""Search for singular positions near a start: of M, and of the constraints.

Unknowns are x and a unit vector w: M(x) w = 0 (or A(x)^T w = 0), w.w = 1, phi(x) = 0, by least squares from the start,
from rows of the motion and from random positions. M and A are scaled by their sizes at the start.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import pi

import numpy as np
from scipy.optimize import least_squares

from ...arguments.named_values import Vector
from ...comparison.deadline import Deadline, TooLateError
from .subject import Subject

_BOX = pi  # largest change of a coordinate, at least this many of its units
_RANDOM = 16
_SINGULAR = 1e-6  # smallest singular value relative to that at the start
_CLOSED = 1e-8  # residual of phi


@dataclass(frozen=True)
class SingularPosition:
    """A position x (n,) where M or the constraints are singular; `towards` (n,) points to the start, in units."""

    what: str
    x: Vector
    towards: Vector

    def near(self, distance: float, units: Vector) -> Vector:
        """Return the position (n,) at a distance, in units."""
        return self.x + distance * units * self.towards


@dataclass(frozen=True)
class Search:
    """The result: a position, or the words why there is none."""

    found: SingularPosition | None
    words: str


def searches(own: Subject, deadline: Deadline) -> tuple[Search, ...]:
    """Return the results for M and, if there are constraints, for them."""
    rows = own.system.m and not own.model.contacts  # whether a contact is closed changes within a run
    kinds = [("mass matrix", _mass(own))] + ([("constraints", _rows(own))] if rows else [])
    return tuple(
        _search(own, what, scaled, deadline.sooner(deadline.left / (len(kinds) - k)))
        for k, (what, scaled) in enumerate(kinds)
    )


def _mass(own: Subject) -> Callable[[Vector], Vector]:
    system, parameters = own.system, own.parameters
    size = np.sqrt(np.maximum(np.diag(system.mass_matrix(own.x0, 0.0, parameters)), 0.0))
    inverse = 1 / np.where(size > 0, size, 1.0)
    return lambda x: np.asarray(system.mass_matrix(x, 0.0, parameters) * np.outer(inverse, inverse))


def _rows(own: Subject) -> Callable[[Vector], Vector]:
    system, parameters = own.system, own.parameters

    def columns(x: Vector) -> Vector:
        return np.asarray((system.pfaffian(x, 0.0, parameters)[0] * own.lengths).T)

    size = np.linalg.norm(columns(own.x0), axis=0)
    return lambda x: columns(x) / np.where(size > 0, size, 1.0)


def _search(own: Subject, what: str, scaled: Callable[[Vector], Vector], deadline: Deadline) -> Search:
    first = _least(scaled(own.x0))
    if first < 1e-10:
        return Search(None, f"{what}: singular at the start itself, and so in every run")
    solved = list(_solutions(own, scaled, deadline))
    hits = [x for x in solved if _least(scaled(x)) < _SINGULAR * first and _open(own, x) < _CLOSED]
    if not hits:
        return Search(None, f"{what}: no singular position found from {len(solved)} places near the start")
    distance = [float(np.linalg.norm((own.x0 - x) / own.lengths)) for x in hits]
    x = hits[int(np.argmin(distance))]
    towards = (own.x0 - x) / own.lengths / max(min(distance), 1e-300)
    place = ", ".join(f"{name} = {value:.4g}" for name, value in zip(own.system.coordinates, x, strict=True))
    return Search(SingularPosition(what, x, towards), f"{what}: singular at {place}")


def _solutions(own: Subject, scaled: Callable[[Vector], Vector], deadline: Deadline) -> Iterator[Vector]:
    n = len(own.x0)
    box = _BOX * np.maximum(own.lengths, 1.0)
    low, high = own.x0 - box, own.x0 + box

    def residual(z: Vector) -> Vector:
        if deadline.left < 0:
            raise TooLateError
        w = z[n:]
        with np.errstate(all="ignore"):
            values = np.concatenate([scaled(z[:n]) @ w, [w @ w - 1], _phi(own, z[:n])])
        return np.asarray(np.nan_to_num(values, nan=1e6, posinf=1e6, neginf=-1e6))

    for x in _places(own, low, high):
        _, _, right = np.linalg.svd(np.nan_to_num(scaled(x)))
        z, free = np.concatenate([x, right[-1]]), np.full(len(right), 2.0)
        limits = np.concatenate([low, -free]), np.concatenate([high, free])
        try:
            found = least_squares(residual, z, bounds=limits, xtol=1e-15, ftol=1e-15, gtol=1e-15, max_nfev=80)
        except TooLateError:
            return
        yield found.x[:n]


def _places(own: Subject, low: Vector, high: Vector) -> Iterator[Vector]:
    random, n = np.random.default_rng(0), len(own.x0)
    inside = 1e-9 * (high - low)
    motion = [np.clip(row[:n], low + inside, high - inside) for row in own.motion]
    yield from (own.x0, *motion)
    for _ in range(_RANDOM):
        yield random.uniform(low, high)


def _phi(own: Subject, x: Vector) -> Vector:
    """Return phi (h,), without the rows of contacts, which need not be closed."""
    system = own.system
    if system.h == 0 or own.model.contacts:
        return np.zeros(0)
    place = np.ascontiguousarray(x[None])
    return np.array(system.compiled.position_rows(np.zeros(1), place, system.prepare(own.parameters))).ravel()


def _open(own: Subject, x: Vector) -> float:
    return float(np.max(np.abs(_phi(own, x)), initial=0.0)) / max(float(np.abs(x).max()), 1.0)


def _least(K: Vector) -> float:
    return float(np.linalg.svd(K, compute_uv=False)[-1]) if np.isfinite(K).all() else 0.0
