"""Energies, places and velocities of the bodies of long chains, from their homogeneous transforms.

The kinetic energy of a body is tr(U B U^T) / 2, where the columns of U are the rates of those of R and of the mass
centre, and B (4, 4) has the second and first moments about that and the mass (Paul 1981, section 6.3). A body that
states its first moments has them about its origin, where its centre is then said to be.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import sympy

from ....arguments.named_values import Vector
from ....codegen.model.tree.body import Link, coordinates_of, rate_of
from ....codegen.model.tree.quantity import Quantity
from .hyperdual import HyperDual
from .jets import LETTERS, E, Jet
from .rounding_bounds import Part, Rounded
from .transforms import Placed, Transforms

_SECOND = np.array([[-0.5, 0, 0, 0.5, 0, 0.5], [0, -1, 0, 0, 0, 0], [0, 0, -1, 0, 0, 0],
                    [0, -1, 0, 0, 0, 0], [0.5, 0, 0, -0.5, 0, 0.5], [0, 0, 0, 0, -1, 0],
                    [0, 0, -1, 0, 0, 0], [0, 0, 0, 0, -1, 0], [0.5, 0, 0, 0.5, 0, -0.5]])  # fmt: skip
"""The second moments tr(I) / 2 - I (9,) from the inertia I (xx, xy, xz, yy, yz, zz)."""

_Term = tuple[tuple[int, ...], Jet, Jet]
"""The directions of a body, and a value in d and e, coefficients (k, w), with the bound of its error."""


class BodyQuantities:
    """Values of quantities of bodies in hyper-dual numbers.

    Parameters
    ----------
    of
        Evaluates an expression in parameters.
    values
        Numbers of coordinates, and of their rates, where known.
    width
        The number of directions in which numbers vary.
    """

    def __init__(
        self, of: Callable[[sympy.Expr], HyperDual], values: Mapping[sympy.Expr, HyperDual], width: int
    ) -> None:
        self._transforms, self._values, self._width = Transforms(of, values), values, width

    def __call__(self, quantity: Quantity) -> HyperDual:
        """Return the value of a quantity."""
        if quantity.kind == "kinetic_energy" and not self._moves(quantity):
            return HyperDual(Rounded(0.0, 0.0))
        parts: tuple[dict[int, Part], dict[int, Part]] = ({0: 0.0}, {0: 0.0})
        term = {"kinetic_energy": self._kinetic_energy, "potential_energy": self._potential_energy,
                "rotation": self._entry, "angular_velocity": self._turning}  # fmt: skip
        for body in quantity.bodies if quantity.kind.endswith("energy") else quantity.bodies[-1:]:
            directions, *jets = term.get(quantity.kind, self._of_point)(body, quantity)
            for whole, jet in zip(parts, jets, strict=True):
                for order, part in jet.parts.items():
                    _add(whole, order, part, directions, self._width)
        value, bound = parts
        return HyperDual(**{letter: Rounded(value[order], bound.get(order, 0.0)) for order, letter in LETTERS.items()
                            if order in value})  # fmt: skip

    def _moves(self, quantity: Quantity) -> bool:
        """Return whether bodies have velocities: a quadratic form and its first derivatives vanish at rest."""
        rates = (self._values[rate_of(q)] for q in coordinates_of(quantity.bodies))
        return any(np.any(part.value) or np.any(part.bound) for one in rates for part in (one.a, one.b) if part)

    def _kinetic_energy(self, body: Link, _: Quantity) -> _Term:
        placed, c = self._transforms.placed(body), self._transforms.vector(body.center)
        J, m, h = map(self._transforms.vector, (body.inertia, (body.mass,), body.moment))
        bound = _blocks(J.bound @ np.abs(_SECOND).T, m.bound, h.bound)
        B = Rounded(_blocks(J.value @ _SECOND.T, m.value, h.value), bound)
        at, off = _point(placed, c)
        turn, moved = placed.H.rate.each(lambda part: part[..., :3]), at.rate
        U = Jet({order: np.concatenate([turn.parts[order], moved.parts[order][..., None]], axis=-1)
                 for order in moved.parts})  # fmt: skip
        sizes = U.each(lambda part: np.sqrt(np.einsum("kwij,kwij->kwj", part, part)))
        offs = placed.error.rate.each(lambda part: part[..., None] * [1, 1, 1, 0])
        offs = offs + off.rate.each(lambda part: part[..., None] * [0, 0, 0, 1])
        large = _weighed(offs, np.abs(B.value) + B.bound) + _weighed(sizes, 0.5 * B.bound)
        return placed.directions, _half_square(U, B.value), sizes.times(large, _dots)

    def _potential_energy(self, body: Link, quantity: Quantity) -> _Term:
        placed, m = self._transforms.placed(body), self._transforms.vector((body.mass,))
        lift = Rounded(-1.0, 0.0) * self._transforms.vector(quantity.vector)
        value, error = _work(*_point(placed, self._transforms.vector(body.center)), m * lift)
        if any(body.moment):
            parts = _work(*_point(placed, self._transforms.vector(body.moment), 0.0), lift)
            value, error = value + parts[0], error + parts[1]
        return placed.directions, value, error

    def _entry(self, body: Link, quantity: Quantity) -> _Term:
        placed, (i, j) = self._transforms.placed(body), quantity.place
        return placed.directions, placed.H.timeless.each(lambda part: part[..., i, j]), placed.error.timeless

    def _turning(self, body: Link, quantity: Quantity) -> _Term:
        """Return an entry of Rdot R^T."""
        placed, (i, j) = self._transforms.placed(body), ((2, 1), (0, 2), (1, 0))[quantity.place[0]]
        rates = placed.H.rate.each(lambda part: part[..., i, :3])
        row = placed.H.timeless.each(lambda part: part[..., j, :3])
        error = placed.error.each(lambda part: np.broadcast_to(part[..., None], (*np.shape(part), 3)))
        bound = rates.each(np.abs).times(error.timeless, _dots) + error.rate.times(row.each(np.abs), _dots)
        return placed.directions, rates.times(row, _dots), bound

    def _of_point(self, body: Link, quantity: Quantity) -> _Term:
        placed, (place,) = self._transforms.placed(body), quantity.place
        at, off = _point(placed, self._transforms.vector(quantity.vector))
        at = at.each(lambda part: part[..., place])
        if quantity.kind == "velocity":
            return placed.directions, at.rate, off.rate
        return placed.directions, at.timeless, off.timeless


def _work(at: Jet, off: Jet, force: Rounded) -> tuple[Jet, Jet]:
    """Return the products (k, w) of places (k, w, 3) with a force, and the bound of their error."""
    at, lost = at.timeless, np.abs(force.value).sum(axis=-1) + force.bound.sum(axis=-1)
    off = off.timeless.each(lambda part: part * lost)
    given = at.each(lambda part: (np.abs(part) * force.bound).sum(axis=-1))
    return at.each(lambda part: (part * force.value).sum(axis=-1)), off + given


def _point(body: Placed, point: Rounded, from_ground: float = 1.0) -> tuple[Jet, Jet]:
    """Return the place (k, w, 3) of a point of a body, and the bound (k, w) of its error; 0: from the body's origin."""
    end = np.full_like(point.value[..., :1], from_ground)
    one = np.concatenate([point.value, end], axis=-1).swapaxes(1, 2)
    length, lost = np.abs(point.value).sum(axis=-1), point.bound.sum(axis=-1)
    error, size = body.error.each(lambda part: part * length), body.size.each(lambda part: part * lost)
    return body.H.each(lambda part: _times(part, one)), body.off + error + size


def _times(H: Vector, one: Vector) -> Vector:
    """Return the products (k, w, 3) of matrices (k, w, 3, 4) with a column (k, 4, 1)."""
    rows = H.reshape(len(H), -1, 4) @ one
    return rows.reshape(len(rows), -1, 3)


def _blocks(second: Vector, mass: Vector, first: Vector) -> Vector:
    """Return B (k, 1, 4, 4)."""
    B = np.zeros((*np.broadcast_shapes(second.shape[:2], mass.shape[:2], first.shape[:2]), 4, 4))
    B[..., :3, 3] = B[..., 3, :3] = first
    B[..., :3, :3], B[..., 3, 3] = second.reshape(*second.shape[:2], 3, 3), mass[..., 0]
    return B


def _weighed(sizes: Jet, B: Vector) -> Jet:
    return sizes.each(lambda part: part @ B[:, 0])


def _half_square(U: Jet, B: Vector) -> Jet:
    """Return tr(U B U^T) / 2."""
    plain, across = U.plain, U.across
    weighed = plain.each(lambda part: part @ B)
    square = plain.times(weighed, lambda a, b: 0.5 * np.einsum("kwij,kwij->kw", a, b))
    return square + across.times(weighed, _all_dots)


def _all_dots(rows: Vector, one: Vector) -> Vector:
    """Return the products (k, w) of matrices (k, w, 3, 4) with one of all directions, (k, 1, 3, 4)."""
    return _dots(rows.reshape(*rows.shape[:2], 12), one.reshape(len(one), 1, 12))


def _dots(a: Vector, b: Vector) -> Vector:
    """Return the products (k, w) of rows (k, w or 1, r)."""
    few, many = sorted((a, b), key=lambda rows: rows.shape[1])
    return (many @ few.swapaxes(1, 2))[..., 0] if few.shape[1] == 1 else np.einsum("kwj,kwj->kw", a, b)


def _add(whole: dict[int, Part], order: int, part: Part, directions: tuple[int, ...], width: int) -> None:
    """Add a coefficient to that of its order, in all directions."""
    if not order & E:
        whole[order] = whole[order] + part if order in whole else part
        return
    if order not in whole or len(whole[order]) < len(part):
        whole[order] = np.zeros((len(part), width)) + whole.get(order, 0.0)
    whole[order][:, _index(directions)] += part


def _index(directions: tuple[int, ...]) -> Any:
    """Return a slice, which is faster, in place of consecutive numbers."""
    ends = directions[0], directions[-1] + 1
    return slice(*ends) if directions == tuple(range(*ends)) else directions
