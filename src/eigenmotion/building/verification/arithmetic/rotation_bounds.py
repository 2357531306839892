"""Bounds of the rounding error of rotations that are multiplied along a chain of bodies.

A running error bound of each entry grows by a factor with each product, so that after a hundred bodies it says nothing.
But a product of rotations has norm 1, so that errors of its factors add: after d bodies it is off by a multiple of
d eps. A derivative of it is a sum of products in which factors are replaced by their derivatives, whose norms are those
of the derivatives of the angles.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import prod
from typing import Any

import numpy as np

from ....codegen.model.tree.forward_kinematics import Moving
from .hyperdual import HyperDual
from .rounding_bounds import EPS, Part, Rounded

Order = frozenset[str]
"""A derivative: by d, by e (the parts of a hyper-dual number), and along the motion (r), each once at most."""
PER_BODY = 16.0 * EPS
"""Error of two products of rotations, of what they multiply, and of lengths that are not quite 1."""
STEEP = 8.0
"""Bound of the turning, and of its change, by a change of modified Rodrigues parameters."""
FROM = 12
"""Number of bodies in a chain from which these bounds are used."""
_PARTS = {"": "a", "d": "b", "e": "c", "de": "f"}
_ORDERS = tuple(frozenset(order + rate) for rate in ("", "r") for order in _PARTS)


@dataclass(frozen=True, slots=True)
class Turning:
    """What is known of a chain: its number of bodies, and sums over its joints.

    sizes : order -> sum of the absolute derivatives of angles, where there are some; errors : of their bounds
    """

    depth: int
    sizes: Mapping[Order, Part]
    errors: Mapping[Order, Part]


def settled(chain: Turning | None, angles: Sequence[Moving], R: Any) -> tuple[Turning, Any]:
    """Return the chain with a body whose joint has these angles, and its rotation with the smaller of both bounds.

    angles : one of a revolute joint, three modified Rodrigues parameters, none of a joint that does not turn
    """
    before = chain or Turning(0, {}, {})
    steep = STEEP if len(angles) > 1 else 1.0
    sizes, errors = dict(before.sizes), dict(before.errors)
    for order, one in _derivatives(angles):
        sizes[order] = sizes.get(order, 0.0) + steep * np.abs(one.value)
        errors[order] = errors.get(order, 0.0) + steep * one.bound
    now = Turning(before.depth + 1, sizes, errors)
    if now.depth < FROM:
        return now, R
    bounds = {order: _error(now, order) for order in _ORDERS}
    return now, [[_bounded(entry, bounds) for entry in row] for row in R]


def _derivatives(angles: Iterable[Moving]) -> Iterator[tuple[Order, Rounded]]:
    for angle in angles:
        for number, rate in ((angle.value, ""), (angle.rate, "r")):
            for order, part in _PARTS.items() if number is not None else ():
                one = getattr(number, part)
                if one is not None:
                    yield frozenset(order + rate), one


def _error(chain: Turning, order: Order) -> Part:
    """Return a bound of the error of a derivative of the rotation, from the sums over all ways to differentiate it."""
    rounding = PER_BODY * chain.depth + chain.errors.get(frozenset(), 0.0)
    whole: Part = 0.0
    for blocks in _partitions(sorted(order)):
        sizes = [chain.sizes.get(block, 0.0) for block in blocks]
        whole = whole + rounding * prod(sizes)
        for place, block in enumerate(blocks):
            whole = whole + chain.errors.get(block, 0.0) * prod(sizes[:place] + sizes[place + 1 :])
    return whole


def _partitions(letters: list[str]) -> Iterator[list[Order]]:
    """Yield the ways to divide letters into blocks."""
    if not letters:
        yield []
        return
    first, rest = letters[0], letters[1:]
    for chosen in range(2 ** len(rest)):
        beside = [letter for k, letter in enumerate(rest) if chosen >> k & 1]
        for blocks in _partitions([letter for letter in rest if letter not in beside]):
            yield [frozenset([first, *beside]), *blocks]


def _bounded(entry: Moving, bounds: Mapping[Order, Part]) -> Moving:
    return Moving(_smaller(entry.value, bounds, ""), _smaller(entry.rate, bounds, "r"))


def _smaller(number: HyperDual | None, bounds: Mapping[Order, Part], rate: str) -> HyperDual | None:
    if number is None:
        return None
    parts = {part: getattr(number, part) for part in _PARTS.values()}
    return HyperDual(**{
        part: one and Rounded(one.value, np.minimum(one.bound, bounds[frozenset(order + rate)]))
        for (order, part), one in zip(_PARTS.items(), parts.values(), strict=True)
    })  # fmt: skip
