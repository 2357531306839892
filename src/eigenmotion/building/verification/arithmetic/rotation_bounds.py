"""Bounds of the rounding error of rotations that are multiplied along a chain of bodies.

A running error bound of each entry grows by a factor with each product, so that after a hundred bodies it says nothing.
But a product of rotations has norm 1, so that errors of its factors add: after d bodies it is off by a multiple of
d eps. A derivative of it is a sum of products in which factors are replaced by their derivatives, whose norms are those
of the derivatives of the angles: the sizes of all derivatives are the coefficients of exp of the sum of the angles'.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ....codegen.model.tree.forward_kinematics import Moving
from .hyperdual import HyperDual
from .jets import LETTERS, Jet, R, exponential, jets_of
from .rounding_bounds import EPS, Part, Rounded

PER_BODY = 16.0 * EPS
"""Error of two products of rotations, of what they multiply, and of lengths that are not quite 1."""
STEEP = 8.0
"""Bound of the turning, and of its change, by a change of modified Rodrigues parameters."""
FROM = 12
"""Number of bodies in a chain from which these bounds are used."""


@dataclass(frozen=True, slots=True)
class Turning:
    """What is known of a chain: its number of bodies, and sums over its joints.

    sizes : absolute derivatives of angles; errors : bounds of angles and of their derivatives
    """

    depth: int
    sizes: Jet
    errors: Jet

    @property
    def size(self) -> Jet:
        """A bound of the norm of the rotation and of its derivatives."""
        return exponential(self.sizes)

    def error(self, size: Jet) -> Jet:
        """Return a bound of the error of the rotation and of its derivatives; `size` is that above."""
        return (Jet({0: PER_BODY * self.depth}) + self.errors) * size


STILL = Turning(0, Jet({}), Jet({}))
"""That of the ground."""


def turning_of(angles: Sequence[tuple[Jet, Jet]]) -> tuple[Jet, Jet]:
    """Return what a joint adds to sizes and errors: an angle, or three modified Rodrigues parameters, and bounds."""
    steep = STEEP if len(angles) > 1 else 1.0
    sizes, errors = Jet({}), Jet({})
    for angle, bounds in angles:
        sizes = sizes + angle.change.each(lambda part: steep * np.abs(part))
        errors = errors + bounds.each(lambda part: steep * part)
    return sizes, errors


def settled(chain: Turning | None, angles: Sequence[Moving], rotation: Any) -> tuple[Turning, Any]:
    """Return the chain with a body whose joint has these angles, and its rotation with the smaller of both bounds.

    angles : one of a revolute joint, three modified Rodrigues parameters, none of a joint that does not turn
    """
    before = chain or STILL
    sizes, errors = turning_of([jets_of(angle.value, angle.rate) for angle in angles])
    now = Turning(before.depth + 1, before.sizes + sizes, before.errors + errors)
    if now.depth < FROM:
        return now, rotation
    bounds = now.error(now.size).parts
    return now, [[_bounded(entry, bounds) for entry in row] for row in rotation]


def _bounded(entry: Moving, bounds: Mapping[int, Part]) -> Moving:
    return Moving(_smaller(entry.value, bounds, 0), _smaller(entry.rate, bounds, R))


def _smaller(number: HyperDual | None, bounds: Mapping[int, Part], rate: int) -> HyperDual | None:
    if number is None:
        return None
    parts = {letter: getattr(number, letter) for letter in LETTERS.values()}
    return HyperDual(**{
        letter: one and Rounded(one.value, np.minimum(one.bound, bounds.get(order | rate, 0.0)))
        for (order, letter), one in zip(LETTERS.items(), parts.values(), strict=True)
    })  # fmt: skip
