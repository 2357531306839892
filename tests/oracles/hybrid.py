"""Motions of linear mechanisms through contacts and frictions, event by event.

M q'' = f - K q + forces, gaps N q + g, slips T q'; all constant. In a mode q'' is affine in q, and the motion a matrix
exponential. Which mode follows is what `contact_cones.solutions` finds, what a blow leaves, `contact_impacts.struck`.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

import numpy as np
from scipy.linalg import expm
from scipy.optimize import brentq

from .contact_cones import solutions
from .contact_impacts import Strike, struck
from .contact_modes import HOLDS, Mode, Problem, Rub, limit, linear, modes, of_mode

CLOSED = 1e-10


@dataclass(frozen=True)
class Mechanism:
    """rows N (c, n), T (c, n): a friction of coefficient mu on every contact; e (c,), law as in `contact_impacts`."""

    M: np.ndarray
    K: np.ndarray
    f: np.ndarray
    N: np.ndarray
    g: np.ndarray
    T: np.ndarray
    mu: float
    e: np.ndarray
    law: str = "newton"

    def rubs(self, closed: list[int], v: np.ndarray | None) -> tuple[Rub, ...]:
        slips = [None if v is None or abs(self.T[k] @ v) < CLOSED else self.T[k : k + 1] @ v for k in closed]
        return tuple(
            Rub(self.T[k : k + 1], np.zeros(1), (0.0, self.mu), (0.0, self.mu), j, slip)
            for j, (k, slip) in enumerate(zip(closed, slips, strict=True))
        )

    def at(self, q: np.ndarray, v: np.ndarray | None, closed: list[int]) -> Problem:
        return Problem(self.M, self.f - self.K @ q, self.N[closed], np.zeros(len(closed)), self.rubs(closed, v))

    def touching(self, q: np.ndarray, v: np.ndarray) -> list[int]:
        """Contacts that are closed and do not part."""
        return [k for k in range(len(self.g)) if self.N[k] @ q + self.g[k] < CLOSED and self.N[k] @ v < CLOSED]


@dataclass(frozen=True)
class Leg:
    """A mode from a time on: z' = A z of z = (q, v, 1); it ends as one of the `watched` of z falls below zero."""

    t: float
    z: np.ndarray
    A: np.ndarray
    closed: tuple[int, ...]
    mode: Mode
    watched: tuple[Callable[[np.ndarray], float], ...] = field(default=(), repr=False)

    def at(self, t: float) -> np.ndarray:
        return expm(self.A * (t - self.t)) @ self.z


def legs(one: Mechanism, q: np.ndarray, v: np.ndarray, end: float, step: float) -> Iterator[Leg]:
    """Yield the modes of a motion that is unique; events are looked for at every step.

    Raises
    ------
    ValueError
        It is not: no motion, or several.
    """
    t = 0.0
    while t < end:
        v = after(one, q, v)
        leg = opened(one, t, q, v, step)
        yield leg
        t = ended(leg, end, step)
        z = leg.at(t)
        q, v = z[: len(q)], z[len(q) : -1]


def after(one: Mechanism, q: np.ndarray, v: np.ndarray) -> np.ndarray:
    closed = one.touching(q, v)
    n = len(closed)
    found = struck(
        Strike(one.M, one.N[closed], np.zeros(n), one.rubs(closed, None), one.e[closed], np.zeros(n), one.law), v
    )
    return the_one(found.found)


def the_one(found: tuple[np.ndarray, ...]) -> np.ndarray:
    if len(found) != 1:
        raise ValueError(f"{len(found)} motions")
    return found[0]


def opened(one: Mechanism, t: float, q: np.ndarray, v: np.ndarray, step: float) -> Leg:
    """Return the mode that begins in a state in which nothing strikes: of those that agree there, that which lasts."""
    closed = one.touching(q, v)
    problem = one.at(q, v, closed)
    the_one(tuple(each.a for each in solutions(problem).found))
    found = [each.mode for mode in modes(problem) for each in of_mode(problem, mode) if each.margin >= -HOLDS]
    begun = [leg_of(one, t, q, v, closed, mode) for mode in found]
    return max(begun, key=lambda leg: min(0.0, *(value(leg.at(t + step / 50)) for value in leg.watched)))


def leg_of(one: Mechanism, t: float, q: np.ndarray, v: np.ndarray, closed: list[int], mode: Mode) -> Leg:
    n, problem = len(q), lambda q: one.at(q, v, closed)
    solved = lambda q: linear(problem(q), mode)  # noqa: E731
    values = lambda q: np.append((s := solved(q)).a0 + s.B @ s.z0, s.z0)  # noqa: E731
    still = values(np.zeros(n))
    slopes = np.array([values(row) - still for row in np.eye(n)]).T.reshape(len(still), n)
    A = np.zeros((2 * n + 1, 2 * n + 1))
    A[:n, n : 2 * n], A[n : 2 * n, :n], A[n : 2 * n, -1] = np.eye(n), slopes[:n], still[:n]
    forces = lambda z: slopes[n:] @ z[:n] + still[n:]  # noqa: E731
    return Leg(
        t, np.concatenate([q, v, [1.0]]), A, tuple(closed), mode, tuple(watched(one, problem(q), closed, mode, forces))
    )


def watched(
    one: Mechanism, problem: Problem, closed: list[int], mode: Mode, forces: Callable[[np.ndarray], np.ndarray]
) -> Iterator[Callable[[np.ndarray], float]]:
    """Yield gaps of the open, forces of the held, what is left to the limit of what sticks, speeds of what slides."""
    n, held = len(problem.h), [closed[j] for j in mode.held]
    for k in range(len(one.g)):
        if k not in held:
            yield lambda z, k=k: one.N[k] @ z[:n] + one.g[k]
    for j in range(len(held)):
        yield lambda z, j=j: forces(z)[j]
    place = len(held)
    for rub, way in zip(problem.rubs, mode.ways, strict=True):
        if isinstance(way, str) and way == "stick":
            for side in (1.0, -1.0):
                mu = limit(rub, rub.grip, mode.held, 0, place + 1)[1][: len(held)]
                yield lambda z, mu=mu, i=place, side=side: mu @ forces(z)[: len(held)] - side * forces(z)[i]
            place += 1
        elif not isinstance(way, str):
            yield lambda z, rub=rub, way=way: way[0] * (rub.rows[0] @ z[n : 2 * n])


def ended(leg: Leg, end: float, step: float) -> float:
    """Return when something watched falls below zero, for what is not above it from where it has risen above on."""
    forth, z, t = expm(leg.A * step), leg.z, leg.t
    before = [value(z) for value in leg.watched]
    while t < end:
        z = forth @ z
        now = [value(z) for value in leg.watched]
        crossed = [
            k for k, (a, b) in enumerate(zip(before, now, strict=True)) if a > 0 > b and (a > CLOSED or t > leg.t)
        ]
        if crossed:
            return min(
                float(brentq(lambda s, k=k: leg.watched[k](leg.at(s)), t, t + step, xtol=1e-15)) for k in crossed
            )
        before, t = now, t + step
    return end


def rows(found: list[Leg], times: np.ndarray) -> np.ndarray:
    """Return q, v (k, 2n) at times."""
    which = np.searchsorted([leg.t for leg in found], times, "right") - 1
    return np.array([found[k].at(t)[:-1] for k, t in zip(which, times, strict=True)])
