"""The same answers where frictions are cones: the ways they slide are solved for from many starts, mode by mode."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product

import numpy as np

from .contact_check import off
from .contact_modes import HOLDS, NEAR, Answer, Found, Mode, Problem, answer, enumerated, modes, same, subsets, ways_of

STARTS = {1: 64, 2: 16, 3: 7, 4: 5}
"""Directions tried along each of so many unknown angles."""
ROUNDS = 25


class BlurredError(Exception):
    """Normal forces that are not unique press what slides: there may be a continuum of motions."""


@dataclass(frozen=True)
class Sliding:
    """A mode's equations as functions of the angles of its k sliding cones.

    rows : (m, n) independent; K : (n, m) their forces; h : (n,) the others
    turned : per cone T (2, n), offset (2,), L and the row (m,) of mu
    """

    problem: Problem
    rows: np.ndarray
    offsets: np.ndarray
    K: np.ndarray
    h: np.ndarray
    turned: tuple[tuple[np.ndarray, np.ndarray, float, np.ndarray], ...]

    def accelerations(self, angles: np.ndarray) -> np.ndarray:
        """Return (B, n) at angles (B, k)."""
        K, h = np.repeat(self.K[None], len(angles), 0), np.repeat(self.h[None], len(angles), 0)
        for (T, _, L, mu), u in zip(self.turned, np.moveaxis(unit(angles), 1, 0), strict=True):
            along = u @ T
            h -= L * along
            K -= along[:, :, None] * mu
        inverse = self.problem.inverse
        r = -(h @ inverse @ self.rows.T + self.offsets)
        z = divided(self.rows @ inverse @ K, r)
        return (h + np.einsum("bij,bj->bi", K, z)) @ inverse

    def slips(self, angles: np.ndarray) -> np.ndarray:
        """Return slip accelerations (B, k, 2)."""
        a = self.accelerations(angles)
        return np.stack([a @ T.T + offset for T, offset, _, _ in self.turned], axis=1)

    def across(self, angles: np.ndarray) -> np.ndarray:
        """Return (B, k): what of a slip acceleration is not along its angle, times its sign: zero in a solution."""
        u, slips = unit(angles), self.slips(angles)
        return u[..., 0] * slips[..., 1] - u[..., 1] * slips[..., 0]


def unit(angles: np.ndarray) -> np.ndarray:
    return np.stack([np.cos(angles), np.sin(angles)], axis=-1)


def divided(G: np.ndarray, r: np.ndarray) -> np.ndarray:
    """Return (B, m), NaN where G is singular."""
    if not G.shape[-1]:
        return np.zeros_like(r)
    with np.errstate(all="ignore"):
        try:
            return np.linalg.solve(G, r[..., None])[..., 0]
        except np.linalg.LinAlgError:
            return np.full_like(r, np.nan)


def all_modes(problem: Problem) -> Iterator[tuple[Mode, tuple[int, ...]]]:
    """Yield modes in which some cones slide, and which: their ways are None."""
    for held in subsets(len(problem.c)):
        choices = [tuple(ways_of(rub, held)) for rub in problem.rubs]
        choices = [
            (*ways, None) if len(rub.rows) == 2 and isinstance(ways[0], str) and ways[0] == "stick" else ways
            for rub, ways in zip(problem.rubs, choices, strict=True)
        ]
        for ways in product(*choices):
            if any(way is None for way in ways):
                yield Mode(held, ways), tuple(k for k, way in enumerate(ways) if way is None)


def equations(problem: Problem, mode: Mode, sliding: tuple[int, ...]) -> Sliding | None:
    """Return a mode's equations; None: its rows contradict one another.

    Raises
    ------
    BlurredError
        Its normal forces are not unique.
    """
    A0, g0 = problem.permanent
    held = list(mode.held)
    sure, offsets = np.vstack([A0, problem.N[held]]), np.concatenate([g0, problem.c[held]])
    if len(sure) and np.linalg.matrix_rank(sure, 1e-9) < len(sure):
        if contradicts(sure, offsets):
            return None
        raise BlurredError
    kept = independent(problem, mode, sure, offsets)
    if kept is None:
        return None
    rows, offsets = kept
    K, h, turned = rows.T.copy(), problem.h.copy(), []
    for k, (rub, way) in enumerate(zip(problem.rubs, mode.ways, strict=True)):
        mu = np.zeros(len(rows))
        if rub.normal in held:
            mu[len(A0) + held.index(rub.normal)] = rub.drag[1]
        if k in sliding:
            turned.append((rub.rows, rub.offset, rub.drag[0], mu))
        elif not isinstance(way, str):
            h -= rub.drag[0] * (rub.rows.T @ way)
            K -= np.outer(rub.rows.T @ way, mu)
    return Sliding(problem, rows, offsets, K, h, tuple(turned))


def contradicts(rows: np.ndarray, offsets: np.ndarray) -> bool:
    a = np.linalg.lstsq(rows, -offsets, rcond=1e-10)[0]
    return bool(np.abs(rows @ a + offsets).max() > NEAR * (1 + np.abs(offsets).max()))


def independent(
    problem: Problem, mode: Mode, sure: np.ndarray, offsets: np.ndarray
) -> tuple[np.ndarray, np.ndarray] | None:
    """Add what sticks, but for rows that follow from those before; None: one contradicts them."""
    rows, count = sure, len(sure)
    for rub, way in zip(problem.rubs, mode.ways, strict=True):
        if not (isinstance(way, str) and way == "stick"):
            continue
        for row, offset in zip(rub.rows, rub.offset, strict=True):
            follows = np.linalg.lstsq(rows.T, row, rcond=1e-10)[0] if len(rows) else np.zeros(0)
            if np.abs(row - follows @ rows).max() > 1e-9:
                rows, offsets = np.vstack([rows, row]), np.append(offsets, offset)
            elif abs(offset - follows @ offsets) > HOLDS * (1 + abs(offset)):
                return None
            elif np.abs(follows[:count]).max(initial=0.0) > 1e-9:
                raise BlurredError
    return rows, offsets


def slopes(equations: Sliding, angles: np.ndarray) -> np.ndarray:
    """Return d across / d angles (B, k, k)."""
    residual = equations.across(angles)
    return np.stack([(equations.across(angles + 1e-7 * row) - residual) / 1e-7 for row in np.eye(angles.shape[1])], -1)


def unstable(equations: Sliding, angles: np.ndarray) -> np.ndarray:
    """Return (B,) whether motions near the one that begins so leave it, by any power of the time since.

    A slip s = |w| tau d that is off by an angle turns by d angle / d log tau = across / (w . d): where that grows, the
    solution is one of a continuum that all begin at rest, and rounding chooses.
    """
    along = np.einsum("bkd,bkd->bk", unit(angles), equations.slips(angles))
    return np.linalg.eigvals(slopes(equations, angles) / along[..., None]).real.max(axis=1, initial=-1.0) > 0.0


def roots(equations: Sliding) -> tuple[np.ndarray, bool]:
    """Return accelerations (r, n) of all solutions that Newton's method finds from a grid; whether all are stable."""
    k = len(equations.turned)
    grid = 2 * np.pi * (np.arange(STARTS[k]) + 0.3) / STARTS[k]
    angles = np.stack(np.meshgrid(*[grid] * k, indexing="ij"), axis=-1).reshape(-1, k)
    for _ in range(ROUNDS):
        angles = angles[np.isfinite(angles).all(axis=1)]
        residual = equations.across(angles)
        step = divided(slopes(equations, angles), residual)
        angles = angles - step * np.minimum(1.0, 0.5 / np.maximum(np.abs(step).max(axis=1, keepdims=True), 1e-300))
    angles = angles[np.isfinite(angles).all(axis=1)]
    slips = equations.slips(angles)
    size = 1 + np.abs(slips).max(axis=(1, 2), initial=0.0)
    good = (np.abs(equations.across(angles)).max(axis=1) < HOLDS * size) & (
        np.einsum("bkd,bkd->bk", unit(angles), slips) > 0
    ).all(axis=1)
    return equations.accelerations(angles[good]), not unstable(equations, angles[good]).any()


def all_of(problem: Problem) -> Answer:
    """Return all accelerations that a problem with cones allows.

    Where forces are not unique a polygon stands for a disc, and what that leaves open is not clear.
    """
    found, clear, stable = list(enumerated(problem).found), enumerated(problem).clear, True
    for mode, sliding in all_modes(problem):
        try:
            one = equations(problem, mode, sliding)
        except BlurredError:
            clear = False
            continue
        accelerations, alone = ((), True) if one is None else roots(one)
        stable &= alone
        for a in accelerations:
            if not any(same(a, other.a) for other in found):
                unknown = np.full(len(problem.c), np.nan), np.full(sum(len(rub.rows) for rub in problem.rubs), np.nan)
                found.append(Found(a, *unknown, mode, -off(problem, a), unique_forces=False))
    inner = [off(problem, one.a, within=True) for one in found if one.margin >= -HOLDS]
    verdict = answer([one for one in found if one.margin >= -NEAR])
    return Answer(verdict.found, clear and verdict.clear and max(inner, default=0.0) <= NEAR, stable)


def solutions(problem: Problem) -> Answer:
    """Return all accelerations that a problem allows."""
    cones = any(len(rub.rows) == 2 and rub.way is None for rub in problem.rubs)
    return all_of(problem) if cones else enumerated(problem)


__all__ = ["all_of", "modes", "solutions"]
