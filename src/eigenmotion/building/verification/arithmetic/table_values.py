"""Values of tables in hyper-dual numbers, from their piecewise polynomials, independent of C."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from itertools import product
from math import perm

import numpy as np

from ....codegen.model.pieces import Axis, Pieces
from ....codegen.model.table import TableCall
from .hyperdual import HyperDual, plus, times
from .rounding_bounds import EPS, FACTOR, Part, Rounded

_TERMS = 16.0
"""Error of a polynomial in eps times its terms, including the rounding of SciPy's coefficients."""


def of_table(call: TableCall, *point: HyperDual) -> HyperDual:
    """Return the value of a call at a point."""
    derivative = partial(_derivative, call.table.pieces, call.orders, point)
    return _of_one(derivative, *point) if len(point) == 1 else _of_two(derivative, *point)


def _of_one(derivative: partial[Rounded], x: HyperDual) -> HyperDual:
    if not x.varies:
        return HyperDual(derivative((0,)))
    return x.through(*(derivative((order,)) for order in range(3)))


def _of_two(derivative: partial[Rounded], x: HyperDual, y: HyperDual) -> HyperDual:
    """Return f(x, y): coefficient f_x b_x + f_y b_y of d, likewise of e; of d e also the second derivatives."""
    value = derivative((0, 0))
    if not (x.varies or y.varies):
        return HyperDual(value)
    f_x, f_y = derivative((1, 0)), derivative((0, 1))
    b, c, f = (plus(times(f_x, getattr(x, k)), times(f_y, getattr(y, k))) for k in "bcf")
    bent = [times(derivative(orders), times(first, second)) for orders, first, second in
            (((2, 0), x.b, x.c), ((0, 2), y.b, y.c), ((1, 1), x.b, y.c), ((1, 1), y.b, x.c))]  # fmt: skip
    for part in bent:
        f = plus(f, part)
    return HyperDual(value, b, c, f)


def _derivative(pieces: Pieces, orders: Sequence[int], point: Sequence[HyperDual], more: Sequence[int]) -> Rounded:
    """Return a derivative of a table with its bound, from rounding of the terms and errors of the arguments.

    The bound is infinite if rounding decides on which side of a join of pieces an argument is.
    """
    whole = [a + b for a, b in zip(orders, more, strict=True)]
    at = np.broadcast_arrays(*(np.asarray(one.a.value, dtype=float) for one in point))
    off = [np.broadcast_to(one.a.bound, at[0].shape) for one in point]
    value, bound = _polynomial(pieces, whole, at)
    for k, width in enumerate(off):
        raised = [order + (axis == k) for axis, order in enumerate(whole)]
        slope = _polynomial(pieces, raised, at)[0]
        bound = bound + np.where(width == 0.0, 0.0, np.abs(slope) * width)
        bound = np.where(_near_join(pieces.axes[k], at[k], width), np.inf, bound)
    return Rounded(value, bound)


def _near_join(axis: Axis, x: Part, off: Part) -> Part:
    knots = np.array(axis.knots)
    distance = np.abs(np.asarray(x)[..., None] - knots).min(axis=-1)
    near: Part = (distance <= FACTOR * off) & (off > 0.0)
    return near


def _polynomial(pieces: Pieces, orders: Sequence[int], at: Sequence[Part]) -> tuple[Part, Part]:
    """Return a derivative at points, and eps times the size of its terms."""
    within = [_looked_up(axis, x, pieces.outside) for axis, x in zip(pieces.axes, at, strict=True)]
    places = [_places(axis, x) for axis, x in zip(pieces.axes, within, strict=True)]
    powers = [
        _powers(x - np.array(axis.knots)[place], axis.order, order)
        for axis, x, place, order in zip(pieces.axes, within, places, orders, strict=True)
    ]
    shape = [size for axis in pieces.axes for size in (axis.count,)] + [axis.order for axis in pieces.axes]
    table = np.array(pieces.coefficients).reshape(shape)[tuple(places)]
    total, size = np.zeros(np.shape(within[0])), np.zeros(np.shape(within[0]))
    for which in product(*(range(axis.order) for axis in pieces.axes)):
        term = table[(..., *which)] * np.prod([p[m] for p, m in zip(powers, which, strict=True)], axis=0)
        total, size = total + term, size + np.abs(term)
    moved = [bool(order) & (x != original) for order, x, original in zip(orders, within, at, strict=True)]
    flat = np.any(moved, axis=0) if pieces.outside == "hold" else False
    refused = np.any(np.isnan(within), axis=0)  # of NaN the power 0 is 1
    return np.where(refused, np.nan, np.where(flat, 0.0, total)), np.where(flat, 0.0, _TERMS * EPS * size)


def _looked_up(axis: Axis, x: Part, outside: str) -> Part:
    low, high = axis.knots[0], axis.knots[-1]
    if outside == "extend":
        return x
    if outside == "hold":
        return np.clip(x, low, high)
    if outside == "periodic":
        inside = np.clip(x - np.floor((x - low) / (high - low)) * (high - low), low, high)
        return np.where((x >= low) & (x <= high), x, inside)
    return np.where((x >= low) & (x <= high), x, np.nan)


def _places(axis: Axis, x: Part) -> Part:
    found: Part = np.clip(np.searchsorted(np.array(axis.knots), x, side="right") - 1, 0, axis.count - 1)
    return found


def _powers(step: Part, count: int, order: int) -> list[Part]:
    return [perm(m, order) * step ** max(m - order, 0) for m in range(count)]
