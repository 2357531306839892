"""Homogeneous transforms of the bodies of long chains with their derivatives, and bounds of their rounding errors.

A body's transform H = [R p] (3, 4) is that of its parent times [R_j p_j; 0 1] of its joint (Denavit and Hartenberg
1955). Coefficients of jets are arrays (k, w, ...): k points, and w directions e in which the body's coordinates vary;
those of the ground and of parts without e have one. So a body has the directions of the bodies that carry it alone.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import sympy

from ....arguments.named_values import Vector
from ....codegen.model.tree.body import ROTATED, Link, rate_of
from .hyperdual import HyperDual
from .jets import E, Jet, jets_of, powers
from .rotation_bounds import PER_BODY, STILL, Turning, turning_of
from .rounding_bounds import Part, Rounded, constant

_UNIT = np.eye(3)
_SKEW = np.array([[[0, 0, 0], [0, 0, -1], [0, 1, 0]], [[0, 0, 1], [0, 0, 0], [-1, 0, 0]],
                  [[0, -1, 0], [1, 0, 0], [0, 0, 0]]], dtype=float)  # fmt: skip
"""[a x] is the sum of a_k times these."""
_IDENTITY = tuple(map(sympy.Integer, (1, 0, 0, 0, 1, 0, 0, 0, 1)))
_Bounded = tuple[Jet, Jet]
"""A value, and the bound of its error."""


@dataclass(frozen=True, slots=True)
class Placed:
    """A body at k points.

    directions : (w,) the numbers of the directions in which it moves
    H : its transform, coefficients (k, w, 3, 4)
    turning : of the chain that carries it
    size, error : bounds of the norm of R and of its error, (k, w); off : of the error of p
    """

    directions: tuple[int, ...]
    H: Jet
    turning: Turning
    size: Jet
    error: Jet
    off: Jet


_GROUND = Placed((), Jet({0: np.eye(3, 4)[None, None]}), STILL, Jet({0: np.ones((1, 1))}), Jet({}), Jet({}))


@dataclass(frozen=True, slots=True)
class _Joint:
    """What a joint does: its transform (k, w, 4, 4); the way that it moves (k, w), with bounds; sizes of its angles."""

    transform: Jet
    way: _Bounded
    turning: tuple[Jet, Jet]


class Transforms:
    """Transforms of bodies at given coordinates and rates.

    Parameters
    ----------
    of
        Evaluates an expression in parameters.
    values
        Numbers of coordinates, and of their rates, where known.
    """

    def __init__(self, of: Callable[[sympy.Expr], HyperDual], values: Mapping[sympy.Expr, HyperDual]) -> None:
        self._of, self._values = of, values
        self._placed: dict[Link | None, Placed] = {None: _GROUND}

    def vector(self, expressions: tuple[sympy.Expr, ...]) -> Rounded:
        """Return the values of expressions in parameters, (k or 1, 1, number)."""
        if all(isinstance(one, sympy.Number) for one in expressions):
            return _given(expressions)
        numbers = [self._of(one).a for one in expressions]
        return Rounded(*(_stacked([getattr(one, part) for one in numbers]) for part in ("value", "bound")))

    def placed(self, body: Link | None) -> Placed:
        """Return where a body is, after those that carry it."""
        if body not in self._placed:
            assert body is not None
            self._placed[body] = self._on(self.placed(body.parent), body)
        return self._placed[body]

    def _on(self, parent: Placed, body: Link) -> Placed:
        numbers = [(self._values[q], self._values.get(rate_of(q))) for q in body.coordinates]
        own = sorted(set().union(*(directions_of(one) for pair in numbers for one in pair if one is not None)))
        joint = self._joint(body, [_in(own, *jets_of(*pair)) for pair in numbers])
        directions = tuple(dict.fromkeys((*parent.directions, *own)))
        join = _Join(len(parent.directions), len(directions), [directions.index(one) for one in own])
        (sizes, errors), (way, way_off) = joint.turning, joint.way
        turning = Turning(parent.turning.depth + 1, join.sum(parent.turning.sizes, sizes),
                          join.sum(parent.turning.errors, errors))  # fmt: skip
        size = turning.size
        moved = join.product(parent.error, way) + join.product(parent.size, way_off)
        return Placed(
            directions, join.product(parent.H, joint.transform, _matrix_product), turning, size, turning.error(size),
            join.sum(parent.off, Jet({})) + moved,
        )  # fmt: skip

    # -- joints ----------------------------------------------------------------------------------------------------

    def _joint(self, body: Link, q: Sequence[_Bounded]) -> _Joint:
        q = q if body.joint in ROTATED else [self._geared(body, one) for one in q]
        axis, at = self.vector(body.axis).value, self.vector(body.at)
        angles = q if body.joint == "revolute" else q[-3:] if body.joint in ROTATED else []
        ways = q if body.joint == "prismatic" else q[:3] if body.joint == "free" else []
        turned = _turned([value for value, _ in angles], axis)
        moved = _moved([value for value, _ in ways], axis)
        fixed = None if body.rotation == _IDENTITY else self.vector(body.rotation).value
        return _Joint(_fixed_before(fixed, at.value, turned, moved), _way(at, ways), turning_of(angles))

    def _geared(self, body: Link, q: _Bounded) -> _Bounded:
        """Return ratio q + offset."""
        if (body.ratio, body.offset) == (1, 0):
            return q
        (value, bound), (ratio, offset) = q, (self._of(one).a for one in (body.ratio, body.offset))
        scaled = bound.each(lambda part: np.abs(ratio.value) * part) + value.each(lambda x: ratio.bound * np.abs(x))
        return (value.each(lambda part: ratio.value * part) + Jet({0: offset.value}),
                scaled + Jet({0: offset.bound}))  # fmt: skip


def directions_of(number: HyperDual) -> set[int]:
    """Return the directions in which a number varies."""
    parts = [_table(part.value) for part in (number.c, number.f) if part is not None]
    return set().union(*(np.flatnonzero((part != 0.0).any(axis=0)).tolist() for part in parts))


def width_of(part: Rounded | None) -> int:
    """Return the number of directions, or of values at a point, of a coefficient."""
    return 1 if part is None else _table(part.value).shape[1]


def _table(part: Part) -> Vector:
    """Return a coefficient as (k or 1, w or 1)."""
    return np.reshape(part, (-1, np.shape(part)[-1] if np.ndim(part) else 1))


def _in(directions: Sequence[int], value: Jet, bound: Jet) -> _Bounded:
    """Return a number, of whose coefficients of e those in some directions are kept."""

    def kept(jet: Jet) -> Jet:
        return Jet({order: _table(part)[:, directions] if order & E else _table(part)
                    for order, part in jet.parts.items() if directions or not order & E})  # fmt: skip

    return kept(value), kept(bound)


@dataclass(frozen=True, slots=True)
class _Join:
    """Arithmetic of a chain, with `before` directions, and a joint, whose directions become the `own` ones of all."""

    before: int
    width: int
    own: list[int]

    def sum(self, chain: Jet, joint: Jet) -> Jet:
        """Return the sum."""
        parts = dict(chain.parts)
        for order in {**chain.parts, **joint.parts}:
            left, right = chain.parts.get(order), joint.parts.get(order)
            if order & E and (right is not None or self.before < self.width):
                parts[order] = self._joined(left, right)
            elif right is not None and not order & E:
                parts[order] = right if left is None else left + right
        return Jet(parts)

    def product(self, chain: Jet, joint: Jet, of: Callable[[Part, Part], Part] = operator.mul) -> Jet:
        """Return the product; as e^2 = 0, none of its terms has directions of both."""
        return self.sum(chain.times(joint.plain, of), chain.plain.times(joint.across, of))

    def _joined(self, left: Part | None, right: Part | None) -> Part:
        shapes = [np.shape(one) for one in (left, right) if one is not None]
        whole = np.zeros((max(shape[0] for shape in shapes), self.width, *shapes[0][2:]))
        if left is not None:
            whole[:, : self.before] = left
        if right is not None:
            whole[:, self.own] += right
        return whole


def _matrix_product(H: Vector, Q: Vector) -> Vector:
    """Return H Q, (k, w, 3, 4); with one Q for all directions as one product."""
    if Q.shape[1] > 1 or H.shape[1] == 1:
        return H @ Q
    rows = H.reshape(len(H), -1, 4) @ Q[:, 0]
    return rows.reshape(len(rows), *H.shape[1:])


def _fixed_before(fixed: Vector | None, at: Vector, turned: Jet, moved: Jet) -> Jet:
    """Return [F at; 0 1] [R p; 0 1], (k, w, 4, 4), with F (k, 1, 9)."""
    if fixed is not None:
        F = fixed.reshape(len(fixed), 1, 3, 3)
        turned, moved = turned.each(lambda part: F @ part), moved.each(lambda part: (F @ part[..., None])[..., 0])
    moved = moved + Jet({0: at})
    parts = {}
    for order in {**turned.parts, **moved.parts}:
        R, p = turned.parts.get(order), moved.parts.get(order)
        shapes = [np.shape(one)[:2] for one in (R, p) if one is not None]
        parts[order] = np.zeros((*np.broadcast_shapes(*shapes), 4, 4))
        parts[order][..., :3, :3] = 0.0 if R is None else R
        parts[order][..., :3, 3] = 0.0 if p is None else p
        parts[order][..., 3, 3] = order == 0
    return Jet(parts)


def _way(at: Rounded, ways: Sequence[_Bounded]) -> _Bounded:
    """Return a bound of the length of a body's place on its parent, and of its error."""
    length = _sum(value.each(np.abs) for value, _ in ways) + Jet({0: np.abs(at.value).sum(axis=-1)})
    off = _sum(bound for _, bound in ways) + Jet({0: at.bound.sum(axis=-1)})
    return length, off + length.each(lambda part: PER_BODY * part)


def _turned(angles: Sequence[Jet], axis: Vector) -> Jet:
    """Return the rotation of a joint, (k, w, 3, 3)."""
    if len(angles) == 1:
        return _about(axis, angles[0])
    return _rodrigues(angles) if angles else Jet({0: _UNIT[None, None]})


def _moved(ways: Sequence[Jet], axis: Vector) -> Jet:
    """Return the place of the body in the frame of its joint, (k, w, 3)."""
    axes = (axis,) if len(ways) == 1 else _UNIT
    return _sum(_along(way, one) for way, one in zip(ways, axes, strict=False))


def _along(number: Jet, direction: Vector, axes: int = 1) -> Jet:
    """Return a number (k, w) times an array, whose last axes these are."""
    return number.each(lambda part: part.reshape(*part.shape, *axes * (1,)) * direction)


def _about(axis: Vector, angle: Jet) -> Jet:
    """Return c 1 + (1 - c) a a^T + s K with K = [a x], and its derivatives from those of exp(angle K), K^3 = -K."""
    K = np.einsum("...i,ijk->...jk", axis, _SKEW)
    value = angle.parts[0][..., None, None]
    turned = _UNIT + np.sin(value) * K + (1.0 - np.cos(value)) * (K @ K)
    first, second, third = powers(angle.change)
    along, bent = turned @ K, turned @ K @ K
    odd = (first + third.each(np.negative)).each(lambda part: part[..., None, None] * along)
    return Jet({0: turned}) + odd + second.each(lambda part: part[..., None, None] * bent)


def _rodrigues(s: Sequence[Jet]) -> Jet:
    """Return 1 + (8 [s x]^2 + 4 (1 - s.s) [s x]) / (1 + s.s)^2."""
    S = _sum(_along(one, _SKEW[k], axes=2) for k, one in enumerate(s))
    square, one = _sum(number * number for number in s), Jet({0: np.ones((1, 1))})
    inverse = _inverse((one + square) * (one + square))
    factor = (one + square.each(np.negative)) * inverse
    eight, four = inverse.each(lambda part: 8.0 * part), factor.each(lambda part: 4.0 * part)
    square_of_S = S.times(S, operator.matmul)
    return Jet({0: _UNIT[None, None]}) + eight.times(square_of_S, _scaled) + four.times(S, _scaled)


def _scaled(number: Part, matrix: Part) -> Part:
    return number[..., None, None] * matrix


def _inverse(number: Jet) -> Jet:
    """Return 1 / a (1 - x + x^2 - x^3), where the number is a (1 + x)."""
    back = 1.0 / number.parts[0]
    first, second, third = powers(number.change.each(lambda part: part * back))
    whole = first.each(np.negative) + second.each(lambda part: 2.0 * part) + third.each(lambda part: -6.0 * part)
    return Jet({0: back}) + whole.each(lambda part: part * back)


def _sum(jets: Iterator[Jet] | Sequence[Jet]) -> Jet:
    whole = Jet({})
    for jet in jets:
        whole = whole + jet
    return whole


@lru_cache(maxsize=10_000)
def _given(numbers: tuple[sympy.Number, ...]) -> Rounded:
    """Return numbers, (1, 1, number)."""
    given = list(map(constant, numbers))
    return Rounded(*(_stacked([getattr(one, part) for one in given]) for part in ("value", "bound")))


def _stacked(numbers: Sequence[Part]) -> Vector:
    """Return numbers, or columns (k, 1), as (k or 1, 1, number)."""
    if not any(map(np.ndim, numbers)):
        return np.array(numbers, dtype=float).reshape(1, 1, -1)
    return np.stack([np.asarray(one) for one in np.broadcast_arrays(*numbers)], axis=-1)
