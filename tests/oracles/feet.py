"""Rigid bodies on feet by Newton's and Euler's laws, in velocities of the centre and angular ones, in fixed axes.

Rows of a point r from the centre along n: (n, r x n); its acceleration along n: (n, r x n) . a + n . (w x (w x r)).
Planar bodies are spatial ones that keep to x, y and turn about z.
"""

from dataclasses import dataclass, field, replace

import numpy as np

from .contact_impacts import Strike
from .contact_problem import NONE, Problem, Rub

PLANAR = [0, 1, 5]
ALL = [0, 1, 2, 3, 4, 5]


@dataclass(frozen=True)
class Ground:
    """What a point meets: along `normal` it is at level + rate t + lift t^2 / 2, and runs along each of `along` (d, 3).

    At belt + pull t.
    """

    normal: np.ndarray
    along: np.ndarray
    level: float = 0.0
    rate: float = 0.0
    lift: float = 0.0
    belt: np.ndarray = field(default_factory=lambda: np.zeros(0))
    pull: np.ndarray = field(default_factory=lambda: np.zeros(0))


@dataclass(frozen=True)
class Foot:
    """A point of the body (3,), in its axes; grip, drag: friction coefficients at rest and sliding.

    Or, where a brake holds it and no contact (`presses` False), forces.
    """

    at: np.ndarray
    ground: Ground
    drag: float = 0.0
    grip: float = 0.0
    e: float = 0.0
    presses: bool = True


@dataclass(frozen=True)
class Body:
    """m, principal moments J (3,), force and torque (3,) in fixed axes; feet in order."""

    m: float
    J: np.ndarray
    force: np.ndarray
    torque: np.ndarray
    feet: tuple[Foot, ...]
    planar: bool = True
    rest: float = 0.0
    law: str = "newton"

    @property
    def kept(self) -> list[int]:
        return PLANAR if self.planar else ALL


@dataclass(frozen=True)
class State:
    """x (3,), R (3, 3), velocities u (6,) and the time."""

    x: np.ndarray
    R: np.ndarray
    u: np.ndarray
    t: float = 0.0


@dataclass(frozen=True)
class Point:
    """A foot in a state: gap, its rate, row (6,) and bias; of friction slip (d,), rows (d, 6), offset (d,)."""

    gap: float
    rate: float
    row: np.ndarray
    bias: float
    slip: np.ndarray
    rows: np.ndarray
    offset: np.ndarray


def turned(angles: np.ndarray) -> np.ndarray:
    """Return R (3, 3), turned about x, then the new y, then the new z."""
    a, b, c = angles
    about = lambda k, phi: _about(k, np.cos(phi), np.sin(phi))  # noqa: E731
    return about(0, a) @ about(1, b) @ about(2, c)


def _about(k: int, c: float, s: float) -> np.ndarray:
    i, j = (k + 1) % 3, (k + 2) % 3
    R = np.eye(3)
    R[i, i] = R[j, j] = c
    R[i, j], R[j, i] = -s, s
    return R


def axes(angles: np.ndarray) -> np.ndarray:
    """Return E (3, 3), angular velocity = E @ rates of the angles."""
    first = turned([angles[0], 0, 0])
    return np.stack([np.eye(3)[0], first[:, 1], (first @ turned([0, angles[1], 0]))[:, 2]], axis=1)


def angular(angles: np.ndarray, rates: np.ndarray, accelerations: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return angular velocity and acceleration."""
    E = axes(angles)
    first, second = E[:, 0] * rates[0], E[:, 1] * rates[1]
    turning = np.cross(first, E[:, 1]) * rates[1] + np.cross(first + second, E[:, 2]) * rates[2]
    return E @ rates, E @ accelerations + turning


def point(foot: Foot, s: State) -> Point:
    r, w, ground = s.R @ foot.at, s.u[3:], foot.ground
    speed, pulled = s.u[:3] + np.cross(w, r), np.cross(w, np.cross(w, r))
    row = lambda n: np.append(n, np.cross(r, n))  # noqa: E731
    level = ground.level + ground.rate * s.t + ground.lift * s.t**2 / 2
    along = ground.along.reshape(-1, 3)
    return Point(
        ground.normal @ (s.x + r) - level,
        ground.normal @ speed - ground.rate - ground.lift * s.t,
        row(ground.normal),
        ground.normal @ pulled - ground.lift,
        along @ speed - ground.belt - ground.pull * s.t,
        np.array([row(one) for one in along]).reshape(len(along), 6),
        along @ pulled - ground.pull,
    )


def mass(body: Body, s: State) -> tuple[np.ndarray, np.ndarray]:
    """Return M (6, 6) and h (6,)."""
    J, w = s.R @ np.diag(body.J) @ s.R.T, s.u[3:]
    M = np.zeros((6, 6))
    M[:3, :3], M[3:, 3:] = body.m * np.eye(3), J
    return M, np.append(body.force, body.torque - np.cross(w, J @ w))


def problem(body: Body, s: State, closed: list[int], slips: dict[int, np.ndarray]) -> Problem:
    """Return the problem of accelerations with these contacts closed and frictions sliding as `slips` says, by foot."""
    keep, points = body.kept, [point(foot, s) for foot in body.feet]
    M, h = mass(body, s)
    rubs = tuple(
        rub(foot, at, keep, closed.index(k) if foot.presses else NONE, slips.get(k))
        for k, (foot, at) in enumerate(zip(body.feet, points, strict=True))
        if len(at.slip) and (k in closed or not foot.presses)
    )
    N = np.array([points[k].row[keep] for k in closed]).reshape(len(closed), len(keep))
    return Problem(M[np.ix_(keep, keep)], h[keep], N, np.array([points[k].bias for k in closed]), rubs)


def rub(foot: Foot, at: Point, keep: list[int], normal: int, slip: np.ndarray | None) -> Rub:
    limits = [(0.0, value) if foot.presses else (value, 0.0) for value in (foot.grip, foot.drag)]
    return Rub(at.rows[:, keep], at.offset, *limits, normal, slip)


def strike(body: Body, s: State, closed: list[int]) -> tuple[Strike, np.ndarray]:
    """Return the impact of these contacts, and the velocities before it."""
    keep, points = body.kept, [point(foot, s) for foot in body.feet]
    rows = problem(body, s, closed, {})
    rubs = [one for one in rows.rubs if one.normal != NONE]
    own = [k for k in closed if len(points[k].slip)]
    rubs = [replace(one, offset=points[k].slip - points[k].rows @ s.u) for one, k in zip(rubs, own, strict=True)]
    b = np.array([points[k].rate - points[k].row @ s.u for k in closed])
    e = np.array([body.feet[k].e for k in closed])
    return Strike(rows.M, rows.N, b, tuple(rubs), e, np.full(len(closed), body.rest), body.law), s.u[keep]
