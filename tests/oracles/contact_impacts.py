"""Velocities after an impact, by the law of `contact_modes`: all that it allows, round by round.

The energy that may not rise is what impulses add: each times the mean of the rates of its point before and after,
beside its ground. On ground at rest that is the kinetic energy.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import brentq

from .contact_cones import solutions
from .contact_modes import NEAR, Found, Problem, Rub, same

STILL = 1e-9
"""A rate of a gap up to this is zero."""
ROUNDS = 40


@dataclass(frozen=True)
class Strike:
    """A state with closed contacts: w = N v + b their rates; frictions as `Rub`, their slips v-rows @ v + offset.

    e : (nc,) restitutions; rest : (nc,) rates up to which a rebound stays; law : "newton" or "poisson"
    """

    M: np.ndarray
    N: np.ndarray
    b: np.ndarray
    rubs: tuple[Rub, ...]
    e: np.ndarray
    rest: np.ndarray
    law: str = "newton"

    @property
    def moves(self) -> bool:
        """Whether the ground does."""
        return bool(np.abs(np.concatenate([self.b, *(rub.offset for rub in self.rubs)])).max(initial=0.0) > STILL)

    def rates(self, v: np.ndarray) -> np.ndarray:
        return self.N @ v + self.b


@dataclass(frozen=True)
class After:
    """All velocities (n,) after the last round; `clear` is False where they may not be all."""

    found: tuple[np.ndarray, ...]
    clear: bool


def struck(strike: Strike, v: np.ndarray, rounds: int = ROUNDS) -> After:
    """Return all velocities after the rounds that begin with v (n,)."""
    w = strike.rates(v)
    if not (w < -STILL).any():
        return After((v,), True)
    if rounds == 0:
        return After((), False)
    once = one_round(strike, v)
    found, clear = [], once.clear
    for after in once.found:
        rest = struck(strike, after, rounds - 1)
        clear &= rest.clear
        found += [one for one in rest.found if not any(same(one, other) for other in found)]
    return After(tuple(found), clear)


def one_round(strike: Strike, v: np.ndarray) -> After:
    """Return all velocities after one round."""
    w = strike.rates(v)
    acting = np.flatnonzero(w <= STILL)
    part = taking_part(strike, acting)
    e = np.where(w[acting] < -STILL, strike.e[acting], 0.0)
    first, clear = with_restitutions(part, v, e)
    found: list[np.ndarray] = []
    for after in first:
        stays = (part.rates(after) <= part.rest) & (e > 0)
        if not stays.any():
            found.append(after)
            continue
        again, sure = with_restitutions(part, v, np.where(stays, 0.0, e))
        clear &= sure
        found += again
    return After(tuple(distinct(found)), clear)


def distinct(found: Sequence[np.ndarray]) -> list[np.ndarray]:
    kept: list[np.ndarray] = []
    for one in found:
        if not any(same(one, other) for other in kept):
            kept.append(one)
    return kept


def taking_part(strike: Strike, acting: np.ndarray) -> Strike:
    """Return the contacts that strike or are held, and the frictions on them."""
    place = {int(k): i for i, k in enumerate(acting)}
    rubs = tuple(
        replace(rub, normal=place[rub.normal], grip=(0.0, rub.drag[1]), drag=(0.0, rub.drag[1]), slip=None)
        for rub in strike.rubs
        if rub.normal in place
    )
    return replace(
        strike, N=strike.N[acting], b=strike.b[acting], e=strike.e[acting], rest=strike.rest[acting], rubs=rubs
    )


def with_restitutions(part: Strike, v: np.ndarray, e: np.ndarray) -> tuple[list[np.ndarray], bool]:
    """Return the velocities with restitutions e, or with as much less of them as keeps energy from rising."""
    whole, clear = by_law(part, v, e)
    clear &= all(one.unique_forces for one in whole) or not part.moves
    if all(gained(part, v, one) <= NEAR * NEAR for one in whole):
        return [one.a for one in whole], clear
    grid = np.linspace(0.0, 1.0, 9)
    each = [by_law(part, v, s * e)[0] for s in grid]
    rises = [any(gained(part, v, one) > NEAR * NEAR for one in found) for found in each]
    least = int(np.argmax(rises))
    if least == 0 or not all(rises[least:]) or any(len(found) != 1 for found in each):
        return [], False
    clear &= all(found[0].unique_forces for found in each) or not part.moves
    gain = lambda s: max(gained(part, v, one) for one in by_law(part, v, s * e)[0])  # noqa: E731
    low, high = grid[least - 1], grid[least]
    share = low if gain(low) >= 0 else brentq(gain, low, high, xtol=1e-13)
    found, sure = by_law(part, v, share * e)
    return [one.a for one in found], clear and sure and len(found) == 1


def gained(part: Strike, v: np.ndarray, found: Found) -> float:
    """Return the work of the impulses beside what moves the ground: sum of impulse times mean rate of its point."""
    kinetic = (found.a + v) @ part.M @ (found.a - v) / 2
    impulses = part.M @ (found.a - v)
    if not part.moves:
        return float(kinetic)
    ground = np.concatenate([part.b, *(rub.offset for rub in part.rubs)])
    share = np.concatenate([found.p, found.f])
    if not np.isfinite(share).all():
        rows = np.vstack([part.N, *(rub.rows for rub in part.rubs)])
        share = np.linalg.lstsq(rows.T, impulses, rcond=None)[0]
    return float(kinetic + share @ ground)


def by_law(part: Strike, v: np.ndarray, e: np.ndarray) -> tuple[list[Found], bool]:
    if part.law == "newton":
        return newton(part, v, e)
    return poisson(part, v, e)


def newton(part: Strike, v: np.ndarray, e: np.ndarray) -> tuple[list[Found], bool]:
    problem = Problem(part.M, part.M @ v, part.N, part.b + e * part.rates(v), part.rubs)
    done = solutions(problem)
    return list(done.found), done.clear


def poisson(part: Strike, v: np.ndarray, e: np.ndarray) -> tuple[list[Found], bool]:
    compressed, clear = newton(part, v, 0 * e)
    found: list[Found] = []
    for one in compressed:
        clear &= one.unique_forces or not e.any()
        given = e * one.p
        limits = [(rub.drag[1] * given[rub.normal], rub.drag[1]) for rub in part.rubs]
        rubs = tuple(replace(rub, grip=both, drag=both) for rub, both in zip(part.rubs, limits, strict=True))
        problem = Problem(part.M, part.M @ one.a + part.N.T @ given, part.N, part.b, rubs)
        done = solutions(problem)
        clear &= done.clear
        found += [replace(after, p=one.p + after.p + given, f=one.f + after.f) for after in done.found]
    return found, clear
