"""Piecewise polynomials in local power form: coefficients, evaluation, and jumps of derivatives at the knots."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import partial
from itertools import pairwise, product

OUTSIDE = ("refuse", "hold", "extend", "periodic")
"""Extrapolation modes: how a table continues beyond its range; in the order of em_outside in em_table.h."""
JUMPS = 1e-9
"""A derivative jumps at a join if its two sides differ by more than this part of the sum of their absolute terms."""
_SMOOTH = 99.0
MOST_JUMPING = 3
"""The highest derivative whose jumps the step control considers."""


@dataclass(frozen=True, slots=True)
class Axis:
    """One argument of a table. The pieces lie between its knots; each has `order` coefficients along this axis."""

    knots: tuple[float, ...]
    order: int

    @property
    def count(self) -> int:
        """Number of pieces."""
        return len(self.knots) - 1

    def piece(self, x: float) -> int:
        """Return the index of the piece that contains x; beyond the range, of the first or last piece."""
        return min(max(bisect_right(self.knots, x) - 1, 0), self.count - 1)

    def starts(self) -> list[int]:
        """(count + 1) indices of the pieces at equally spaced points: starting points of a search (em_table.h)."""
        first, last = self.knots[0], self.knots[-1]
        return [self.piece(first + (last - first) * k / self.count) for k in range(self.count + 1)]


@dataclass(frozen=True, slots=True)
class Pieces:
    """A piecewise polynomial of one or two arguments.

    axes : one for each argument
    coefficients : piece by piece, the last argument varying fastest; within a piece by ascending powers of the
        distances from its lower knots, powers of the last argument varying fastest
    outside : extrapolation mode, one of OUTSIDE
    """

    axes: tuple[Axis, ...]
    coefficients: tuple[float, ...]
    outside: str
    _joins: dict[int, tuple[tuple[float, int], ...]] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )

    def of_piece(self, places: Sequence[int]) -> tuple[float, ...]:
        """Return the coefficients of one piece."""
        number, size = 0, math.prod(axis.order for axis in self.axes)
        for axis, place in zip(self.axes, places, strict=True):
            number = number * axis.count + place
        return self.coefficients[number * size : (number + 1) * size]

    def value(self, orders: Sequence[int], point: Sequence[float]) -> float:
        """Return the derivative of these orders at a point; NaN where the mode is "refuse" and the point is outside."""
        within = [_within(axis, x, self.outside) for axis, x in zip(self.axes, point, strict=True)]
        if any(math.isnan(x) for x in within):
            return math.nan
        clamped = zip(orders, within, point, strict=True)
        if self.outside == "hold" and any(order and x != argument for order, x, argument in clamped):
            return 0.0
        places = [axis.piece(x) for axis, x in zip(self.axes, within, strict=True)]
        powers = [
            _powers(x - axis.knots[place], axis.order, order)
            for axis, x, place, order in zip(self.axes, within, places, orders, strict=True)
        ]
        terms = zip(product(*powers), self.of_piece(places), strict=True)
        return math.fsum(math.prod(factors) * coefficient for factors, coefficient in terms)

    def joins(self, axis: int) -> tuple[tuple[float, int], ...]:
        """Return (knot, order) along an axis where a derivative up to MOST_JUMPING jumps; order is the lowest such."""
        if axis not in self._joins:  # many numbers are compared for these few
            self._joins[axis] = self._compared(axis)
        return self._joins[axis]

    def _compared(self, axis: int) -> tuple[tuple[float, int], ...]:
        """Return what `joins` does, from the coefficients."""
        along = self.axes[axis]
        pairs = [(k, k - 1, k) for k in range(1, along.count)]
        if self.outside == "periodic":
            pairs.append((0, along.count - 1, 0))
        jumps = [(along.knots[knot], self._jump(axis, left, right)) for knot, left, right in pairs]
        if self.outside == "hold":
            ends = ((0, 0), (along.count, along.count - 1))
            jumps += [(along.knots[knot], self._bend(axis, piece, knot != piece)) for knot, piece in ends]
        return tuple(sorted((at, order) for at, order in jumps if order <= MOST_JUMPING))

    def _jump(self, axis: int, left: int, right: int) -> int:
        """Return the lowest derivative along an axis that differs between two neighbouring pieces, over all lines."""
        ends = self._end(axis, left, True), self._end(axis, right, False)
        lines = zip(self._lines(axis, left), self._lines(axis, right), strict=True)
        return min(_first_jump(*(list(map(partial(_sized, line), end)) for line, end in zip(pair, ends, strict=True)))
                   for pair in lines)  # fmt: skip

    def _bend(self, axis: int, piece: int, upper: bool) -> int:
        """Return the lowest derivative along an axis, from the first on, that is not zero at an end of a piece."""
        end = self._end(axis, piece, upper)
        sized = [[_sized(line, factors) for factors in end] for line in self._lines(axis, piece)]
        return min(
            next((d for d, (value, size) in enumerate(one) if d and abs(value) > JUMPS * size), 9) for one in sized
        )

    def _end(self, axis: int, piece: int, upper: bool) -> list[list[float]]:
        """Return the factors of the coefficients in each derivative along an axis, at one end of a piece."""
        along = self.axes[axis]
        step = along.knots[piece + 1] - along.knots[piece] if upper else 0.0
        return [_powers(step, along.order, order) for order in range(MOST_JUMPING + 1)]

    def _lines(self, axis: int, piece: int) -> Iterator[tuple[float, ...]]:
        """Yield the coefficients along an axis: one line for each piece and power of the other argument."""
        if len(self.axes) == 1:
            yield self.of_piece((piece,))
            return
        other = self.axes[1 - axis]
        for beside in range(other.count):
            patch = self.of_piece((piece, beside) if axis == 0 else (beside, piece))
            width = self.axes[1].order
            for power in range(other.order):
                yield patch[power::width] if axis == 0 else patch[power * width : (power + 1) * width]

    def numbers(self) -> list[float]:
        """Return the array that em_table.h reads: sizes; knots, starts and joins of each axis; coefficients."""
        joins = [self.joins(k) for k in range(len(self.axes))]
        head = [float(len(self.axes)), float(OUTSIDE.index(self.outside))]
        for axis, jumps in zip(self.axes, joins, strict=True):
            scale = axis.count / (axis.knots[-1] - axis.knots[0])
            head += [float(axis.count), float(axis.order), scale, float(len(jumps))]
        head += [0.0] * (10 - len(head))
        head += [min((float(order) for _, order in jumps), default=_SMOOTH) for jumps in (*joins, ())[:2]]
        for axis, jumps in zip(self.axes, joins, strict=True):
            head += [*axis.knots, *map(float, axis.starts()), *(float(one) for pair in jumps for one in pair)]
        return [*head, *self.coefficients]


def _within(axis: Axis, x: float, outside: str) -> float:
    """Return x mapped into the range by the extrapolation mode; NaN where it is refused."""
    first, last = axis.knots[0], axis.knots[-1]
    if first <= x <= last or outside == "extend":
        return x
    if outside == "hold":
        return min(max(x, first), last) if x == x else x
    if outside == "periodic" and math.isfinite(x):
        return min(max(x - math.floor((x - first) / (last - first)) * (last - first), first), last)
    return math.nan


def _powers(step: float, count: int, order: int) -> list[float]:
    """Return the factors of the coefficients in a derivative: m! / (m - order)! step^(m - order)."""
    return [math.perm(m, order) * step ** (m - order) if m >= order else 0.0 for m in range(count)]


def _sized(coefficients: Sequence[float], factors: Sequence[float]) -> tuple[float, float]:
    terms = [a * b for a, b in zip(coefficients, factors, strict=True)]
    return sum(terms), sum(map(abs, terms))


def _first_jump(left: list[tuple[float, float]], right: list[tuple[float, float]]) -> int:
    pairs = enumerate(zip(left, right, strict=True))
    return next((d for d, ((a, s), (b, r)) in pairs if abs(a - b) > JUMPS * (s + r)), MOST_JUMPING + 1)


def is_increasing(numbers: Sequence[float]) -> bool:
    """Whether each number is larger than the one before."""
    return all(low < high for low, high in pairwise(numbers))
