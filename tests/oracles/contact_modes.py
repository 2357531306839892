"""Accelerations, or velocities after an impact, that contacts and frictions allow: all modes, one by one.

The law, and this is all that is known of it here; NumPy and SciPy, no code of the package.

Accelerations (at rest and at starts), M a = h + sum of (row times its force):

- permanent rows A0 a + g0 = 0;
- every contact with gap = 0 and gap rate = 0: gapdd >= 0, force p >= 0, p gapdd = 0;
- every friction at rest (slip = 0): the force is in [-L, L] (line) or |force| <= L (cone, two slips), L its limit at
  rest, which may be mu p of its normal; where its slip acceleration is not zero the force is L (the limit for sliding)
  against it;
- a friction that slides already: force = -L slip / |slip|;
- a contact that is closed but separates (gap rate > 0) is open.

The package's constraint force is -A^T lambda, so that p = -lambda of a contact's row.

Impacts, in rounds: all contacts that approach (gap = 0, gap rate < 0) strike at once, with all that are held
(restitution 0 for those) and the frictions on either, in one such problem on impulses, M (v+ - v-) = sum of (row times
its impulse):

- Moreau and Newton: P >= 0, w+ + e w- >= 0, one of them zero; a friction's impulse is in [-mu P, mu P] (a disc for a
  cone), and is mu P against an end slip that is not zero;
- Poisson: compression with e = 0 for all, then expansion, in which Pe - e Pc >= 0 and w+ >= 0, one of them zero;
  friction in each phase is bounded by mu times the normal impulse of that phase, against the slip at its end;
- frictions without a contact as normal (finite force) take no impulse;
- where energy would rise, all restitutions are lowered by one common factor to where it does not;
- contacts that rebound no faster than `rest` stay: their restitution is 0 in a second solution;
- contacts that approach after that strike in the next round.

Numbers are of the order of one: whoever asks scales lengths, masses and times before.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
from scipy.optimize import linprog

from .contact_problem import Problem, Rub

HOLDS, NEAR, SAME = 1e-9, 1e-6, 1e-6
"""An inequality off by HOLDS holds, one off by NEAR might; accelerations that differ by SAME are one."""
SIDES = 48
"""Of the polygon in place of a disc, where forces are not unique."""


@dataclass(frozen=True)
class Mode:
    """held : numbers of contacts; ways : per friction "stick", "free", or the unit vector along which it slides."""

    held: tuple[int, ...]
    ways: tuple[object, ...]


@dataclass(frozen=True)
class Found:
    """a : (n,); p : (nc,) one choice of forces; margin : of the tightest inequality; `many`: one end of a continuum.

    f : those of frictions, one row after the other; NaN where nobody has asked.
    """

    a: np.ndarray
    p: np.ndarray
    f: np.ndarray
    mode: Mode
    margin: float
    many: bool = False
    unique_forces: bool = True


@dataclass(frozen=True)
class Answer:
    """All that a problem allows: distinct accelerations; `clear` is False where rounding or a continuum blurs them."""

    found: tuple[Found, ...]
    clear: bool
    stable: bool = True

    @property
    def count(self) -> int:
        return len(self.found)


@dataclass(frozen=True)
class Linear:
    """a = a0 + B z, inequalities l0 + L z >= 0; z = (multipliers, p of the held, f of the sticking) = z0 + V y."""

    a0: np.ndarray
    B: np.ndarray
    l0: np.ndarray
    L: np.ndarray
    z0: np.ndarray
    V: np.ndarray
    first: int
    residual: float

    def at(self, y: np.ndarray) -> np.ndarray:
        return self.z0 + self.V @ y


def ways_of(rub: Rub, held: Sequence[int]) -> Iterator[object]:
    """Yield what a friction may do in a mode; a cone's ways of sliding are found elsewhere (`contact_cones`)."""
    presses = rub.normal in held
    if not (rub.grip[0] or rub.drag[0] or presses):
        yield "free"
    elif rub.way is not None:
        yield rub.way
    else:
        yield "stick"
        if len(rub.rows) == 1:
            yield from (np.array([1.0]), np.array([-1.0]))


def subsets(count: int) -> Iterator[tuple[int, ...]]:
    for bits in product((0, 1), repeat=count):
        yield tuple(k for k, bit in enumerate(bits) if bit)


def modes(problem: Problem) -> Iterator[Mode]:
    for held in subsets(len(problem.c)):
        for ways in product(*(tuple(ways_of(rub, held)) for rub in problem.rubs)):
            yield Mode(held, ways)


def limit(rub: Rub, how: tuple[float, float], held: Sequence[int], first: int, size: int) -> tuple[float, np.ndarray]:
    """Return L + mu p of a friction as a number and a row on z."""
    row = np.zeros(size)
    if rub.normal in held:
        row[first + held.index(rub.normal)] = how[1]
    return how[0], row


def linear(problem: Problem, mode: Mode) -> Linear:
    """Return the equations of a mode, solved in the least-squares sense, and its inequalities."""
    A0, g0 = problem.permanent
    held, first = mode.held, len(A0)
    stuck = [k for k, way in enumerate(mode.ways) if isinstance(way, str) and way == "stick"]
    rows = np.vstack([A0, problem.N[list(held)], *(problem.rubs[k].rows for k in stuck)])
    offsets = np.concatenate([g0, problem.c[list(held)], *(problem.rubs[k].offset for k in stuck)])
    K, h = rows.T.copy(), problem.h.astype(float)
    for rub, way in zip(problem.rubs, mode.ways, strict=True):
        if not isinstance(way, str):
            L, mu = limit(rub, rub.drag, held, first, len(rows))
            h -= L * (rub.rows.T @ way)
            K -= np.outer(rub.rows.T @ way, mu)
    B, a0 = problem.inverse @ K, problem.inverse @ h
    z0, V, residual = solved(rows @ B, -(rows @ a0 + offsets))
    l0, L = inequalities(problem, mode, a0, B, first)
    return Linear(a0, B, l0, L, z0, V, first, residual)


def solved(G: np.ndarray, r: np.ndarray) -> tuple[np.ndarray, np.ndarray, float]:
    """Return the least solution of G z = r, a basis of what it leaves open, and how far off it is."""
    if not len(r):
        return np.zeros(0), np.zeros((0, 0)), 0.0
    U, s, Vt = np.linalg.svd(G)
    rank = int(np.sum(s > 1e-10 * max(s[0], 1e-300)))
    z = Vt[:rank].T @ ((U[:, :rank].T @ r) / s[:rank])
    return z, Vt[rank:].T, float(np.abs(G @ z - r).max())


def inequalities(
    problem: Problem, mode: Mode, a0: np.ndarray, B: np.ndarray, first: int
) -> tuple[np.ndarray, np.ndarray]:
    size, held = B.shape[1], mode.held
    numbers, rows = [], []

    def wanted(number: float, row: np.ndarray) -> None:
        numbers.append(number)
        rows.append(row)

    for k in range(len(held)):
        wanted(0.0, np.eye(size)[first + k])
    for k in set(range(len(problem.c))) - set(held):
        wanted(problem.N[k] @ a0 + problem.c[k], problem.N[k] @ B)
    at = first + len(held)
    for rub, way in zip(problem.rubs, mode.ways, strict=True):
        if isinstance(way, str) and way == "stick":
            L, mu = limit(rub, rub.grip, held, first, size)
            for side in sides(len(rub.rows)):
                wanted(L, mu - side @ np.eye(size)[at : at + len(side)])
            at += len(rub.rows)
        elif not isinstance(way, str) and rub.way is None:
            wanted(way @ (rub.rows @ a0 + rub.offset), way @ rub.rows @ B)
    return np.array(numbers), np.array(rows).reshape(len(numbers), size)


def sides(d: int) -> np.ndarray:
    """Directions (k, d) in which a force may not exceed its limit: a segment's, or those of a polygon about a disc."""
    angles = 2 * np.pi * np.arange(SIDES) / SIDES
    return np.array([[1.0], [-1.0]]) if d == 1 else np.stack([np.cos(angles), np.sin(angles)], axis=1)


def widest(l0: np.ndarray, L: np.ndarray, V: np.ndarray) -> tuple[np.ndarray, float]:
    """Return y that keeps the tightest of l0 + L V y >= 0 as far off as one, and that margin."""
    rows = L @ V
    k = V.shape[1]
    done = linprog(
        np.append(np.zeros(k), -1.0), A_ub=np.hstack([-rows, np.ones((len(l0), 1))]), b_ub=l0,
        bounds=[(None, None)] * k + [(None, 1.0)],
    )  # fmt: skip
    return (done.x[:k], done.x[k]) if done.status == 0 else (np.zeros(k), -np.inf)


def of_mode(problem: Problem, mode: Mode) -> Iterator[Found]:
    """Yield what a mode allows, also where an inequality is off by up to NEAR (its margin says so)."""
    one = linear(problem, mode)
    if one.residual > HOLDS * (1 + np.abs(one.z0).max(initial=0.0)):
        return
    if not one.V.size:
        margin, y = float(one.l0.min(initial=1.0) if not one.L.size else (one.l0 + one.L @ one.z0).min()), np.zeros(0)
    elif not len(one.l0):
        margin, y = 1.0, np.zeros(one.V.shape[1])
    else:
        y, margin = widest(one.l0 + one.L @ one.z0, one.L, one.V)
    if margin >= -NEAR:
        yield from ends(problem, mode, one, y, margin)


def ends(problem: Problem, mode: Mode, one: Linear, y: np.ndarray, margin: float) -> Iterator[Found]:
    """Yield the acceleration, or two ends of the continuum there is where forces that slide are not unique."""
    moved = one.B @ one.V
    several = moved.size > 0 and np.abs(moved).max() > 1e-8
    choices = [y]
    if several and margin >= -HOLDS:
        way = moved.T @ np.random.default_rng(0).normal(size=len(one.a0))
        rows, at = one.L @ one.V, one.l0 + one.L @ one.z0 + HOLDS
        both = [linprog(sign * way, A_ub=-rows, b_ub=at, bounds=[(None, None)] * len(y)) for sign in (1, -1)]
        choices = [done.x if done.status == 0 else y for done in both]
        several = bool(np.abs(moved @ (choices[0] - choices[1])).max() > SAME)
    for chosen in choices[: 1 + several]:
        z, p = one.at(chosen), np.zeros(len(problem.c))
        p[list(mode.held)] = z[one.first : one.first + len(mode.held)]
        yield Found(
            one.a0 + one.B @ z, p, rubbed(problem, mode, z, one.first, p), mode, margin, several, not one.V.size
        )


def rubbed(problem: Problem, mode: Mode, z: np.ndarray, first: int, p: np.ndarray) -> np.ndarray:
    """Return the forces of frictions, one row after the other."""
    found, at = [np.zeros(0)], first + len(mode.held)
    for rub, way in zip(problem.rubs, mode.ways, strict=True):
        d = len(rub.rows)
        if isinstance(way, str):
            found.append(z[at : at + d] if way == "stick" else np.zeros(d))
            at += d * (way == "stick")
        else:
            found.append(-(rub.drag[0] + rub.drag[1] * (p[rub.normal] if rub.normal >= 0 else 0.0)) * way)
    return np.concatenate(found)


def answer(found: Sequence[Found]) -> Answer:
    """Return the distinct accelerations of what holds; what nearly holds and is none of them blurs the answer."""
    kept: list[Found] = []
    for one in sorted(found, key=lambda one: -one.margin):
        equal = [k for k, other in enumerate(kept) if same(one.a, other.a)]
        if equal:
            both = kept[equal[0]]
            kept[equal[0]] = replace(both, unique_forces=both.unique_forces and same(both.p, one.p))
        else:
            kept.append(one)
    holds = tuple(one for one in kept if one.margin >= -HOLDS)
    return Answer(holds, len(holds) == len(kept) and not any(one.many for one in holds))


def same(a: np.ndarray, b: np.ndarray) -> bool:
    return bool(np.abs(a - b).max(initial=0.0) <= SAME * (1 + np.abs(b).max(initial=0.0)))


def enumerated(problem: Problem) -> Answer:
    """Return all accelerations that a problem of frictions on lines (or cones that slide already or stick) allows."""
    return answer([found for mode in modes(problem) for found in of_mode(problem, mode)])
