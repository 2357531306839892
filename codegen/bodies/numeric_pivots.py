"""Articulated bodies in floating point, for tests whether joints move mass: their pivots, and what they carry."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

Rows = list[list[float]]


@dataclass(frozen=True, slots=True)
class NumericLink:
    """A moving body: `LinkRow` with numbers in place of nodes."""

    parent: int
    joint: str
    coordinates: tuple[int, ...]
    numbers: Sequence[float]


def pivots(links: Sequence[NumericLink], x: Sequence[float], armature: Sequence[float]) -> list[tuple[float, float]]:
    """Return (pivot, bound of the diagonal of M) of each coordinate of these links; (0, 0) of others.

    Parameters
    ----------
    x, armature : (n,) coordinates, and their inertia besides that of the bodies
    """
    articulated, composite = [_inertia(one.numbers) for one in links], [_inertia(one.numbers) for one in links]
    found = [(0.0, 0.0)] * len(x)
    for number in reversed(range(len(links))):
        link = links[number]
        X, S = _joint(link, [x[k] for k in link.coordinates])
        mass, trace = composite[number][3][3], sum(composite[number][k][k] for k in range(3))
        for motion, k in zip(S, link.coordinates, strict=True):
            size = _dot(motion[:3], motion[:3]) * trace + _dot(motion[3:], motion[3:]) * mass + armature[k]
            force = _applied(articulated[number], motion)
            pivot = _dot(motion, force) + armature[k]
            found[k] = pivot, size
            if pivot != 0.0:
                articulated[number] = _less(articulated[number], force, pivot)
        if link.parent >= 0:
            for whole in (articulated, composite):
                whole[link.parent] = _sum(whole[link.parent], _congruent(X, whole[number]))
    return found


def _dot(a: Sequence[float], b: Sequence[float]) -> float:
    return sum(x * y for x, y in zip(a, b, strict=True))


def _applied(A: Rows, a: Sequence[float]) -> list[float]:
    return [_dot(row, a) for row in A]


def _sum(A: Rows, B: Rows) -> Rows:
    return [[a + b for a, b in zip(*rows, strict=True)] for rows in zip(A, B, strict=True)]


def _less(A: Rows, force: Sequence[float], pivot: float) -> Rows:
    return [[a - f * g / pivot for a, g in zip(row, force, strict=True)] for row, f in zip(A, force, strict=True)]


def _product(A: Rows, B: Rows) -> Rows:
    columns = list(zip(*B, strict=True))
    return [[_dot(row, column) for column in columns] for row in A]


def _congruent(X: Rows, A: Rows) -> Rows:
    """Return X^T A X."""
    return _product([list(column) for column in zip(*X, strict=True)], _product(A, X))


def _skew(a: Sequence[float]) -> Rows:
    return [[0.0, -a[2], a[1]], [a[2], 0.0, -a[0]], [-a[1], a[0], 0.0]]


def _blocks(A: Rows, B: Rows, C: Rows, D: Rows) -> Rows:
    return [[*a, *b] for a, b in zip(A, B, strict=True)] + [[*c, *d] for c, d in zip(C, D, strict=True)]


def _inertia(numbers: Sequence[float]) -> Rows:
    """Return the inertia (6, 6) of a body, [J, [h x]; -[h x], m]."""
    m, h, (xx, xy, xz, yy, yz, zz) = numbers[14], numbers[15:18], numbers[18:24]
    H, J = _skew(h), [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
    return _blocks(J, H, [[-e for e in row] for row in H], [[m * (i == j) for j in range(3)] for i in range(3)])


def _joint(link: NumericLink, q: Sequence[float]) -> tuple[Rows, Rows]:
    """Return X (6, 6), which takes motions of the parent's frame to the body's, and the motions of the joint."""
    numbers = link.numbers
    p, R0, moved = list(numbers[:3]), [list(numbers[k : k + 3]) for k in (3, 6, 9)], numbers[12] * q[0] + numbers[13]
    turned, S = _UNIT, [[0.0, 0.0, 0.0, 0.0, 0.0, numbers[12]]]
    if link.joint == "revolute":
        c, s = math.cos(moved), math.sin(moved)
        turned, S = [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]], [[0.0, 0.0, numbers[12], 0.0, 0.0, 0.0]]
    elif link.joint == "prismatic":
        p = [one + row[2] * moved for one, row in zip(p, R0, strict=True)]
    else:
        turned, S = _rodrigues(q[-3:])
    if link.joint == "free":
        p = [one + _dot(row, q[:3]) for one, row in zip(p, R0, strict=True)]
        S = [[0.0, 0.0, 0.0, *row] for row in turned] + S
    back = [list(column) for column in zip(*_product(R0, turned), strict=True)]
    across = [[-entry for entry in row] for row in _product(back, _skew(p))]
    return _blocks(back, _NONE, across, back), S


def _rodrigues(s: Sequence[float]) -> tuple[Rows, Rows]:
    """Return the rotation by modified Rodrigues parameters, and the motions at unit rates of them."""
    square, cross = _dot(s, s), _skew(s)
    d = (1 + square) ** 2
    R, B = (
        [[outer * s[i] * s[j] / d + turn * cross[i][j] / d + diagonal * (i == j) for j in range(3)] for i in range(3)]
        for outer, turn, diagonal in (
            (8, 4 * (1 - square), 1 - 8 * square / d),
            (8, -8, 4 * (1 - square) / d),
        )
    )
    return R, [[B[i][k] for i in range(3)] + [0.0] * 3 for k in range(3)]


_UNIT = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
_NONE = [[0.0] * 3] * 3
