"""Values of functions of bodies by forward kinematics: rotations and places multiplied from the ground outwards.

This defines the functions. It shares nothing with the recursions of `codegen.bodies`, which are checked against it.
Numbers may be of any kind that adds and multiplies; rates follow by the product rule.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy

from .body import ROTATED, Link, rate_of
from .quantity import Quantity

Number = Any
"""A number; None is zero."""


@dataclass(frozen=True, slots=True)
class Arithmetic:
    """What numbers do besides + and *.

    of, entry : evaluate an expression in parameters; `entry` one of a rotation or an axis, whose error is that of 1,
    however small it is: 6e-17 for the cosine of a right angle
    settled : if given, it bounds errors of rotations along chains: from what it returned first for the body's parent,
    the angles of the joint, and the rotation of the body
    """

    of: Callable[[sympy.Expr], Number]
    entry: Callable[[sympy.Expr], Number]
    sin: Callable[[Number], Number]
    cos: Callable[[Number], Number]
    inverse: Callable[[Number], Number]
    settled: Callable[[Any, Sequence[Moving], Matrix], tuple[Any, Matrix]] | None = None


def plus(a: Number, b: Number) -> Number:
    """Return a + b."""
    return b if a is None else a if b is None else a + b


def times(a: Number, b: Number) -> Number:
    """Return a b."""
    return None if a is None or b is None else a * b


@dataclass(frozen=True, slots=True, eq=False)
class Moving:
    """A number and its rate."""

    value: Number = None
    rate: Number = None

    def __add__(self, other: Moving) -> Moving:
        return Moving(plus(self.value, other.value), plus(self.rate, other.rate))

    def __mul__(self, other: Moving) -> Moving:
        return Moving(
            times(self.value, other.value), plus(times(self.rate, other.value), times(self.value, other.rate))
        )


Matrix = Sequence[Sequence[Moving]]


def dot(a: Sequence[Moving], b: Sequence[Moving]) -> Moving:
    """Return a . b."""
    whole = Moving()
    for x, y in zip(a, b, strict=True):
        whole = whole + x * y
    return whole


def product(A: Matrix, B: Matrix) -> Matrix:
    """Return A B."""
    return [[dot(row, column) for column in zip(*B, strict=True)] for row in A]


_UNIT = tuple(map(sympy.Integer, (1, 0, 0, 0, 1, 0, 0, 0, 1)))


class ForwardKinematics:
    """Rotations and places of bodies at given coordinates and rates.

    Parameters
    ----------
    values
        Numbers of coordinates, of their rates, where known, and of parameters.
    """

    def __init__(self, arithmetic: Arithmetic, values: Mapping[sympy.Expr, Number]) -> None:
        self.numbers, self.values = arithmetic, values
        self.minus = self.constant(sympy.S.NegativeOne)
        self._turnings: dict[Link | None, Any] = {}
        self._placed: dict[Link | None, tuple[Matrix, list[Moving]]] = {None: (self._matrix(_UNIT), [Moving()] * 3)}

    def constant(self, expression: sympy.Expr) -> Moving:
        """Return an expression in parameters."""
        return Moving(None if expression == 0 else self.numbers.of(expression))

    def vector(self, expressions: Sequence[sympy.Expr]) -> list[Moving]:
        """Return expressions in parameters."""
        return [self.constant(one) for one in expressions]

    def _directions(self, expressions: Sequence[sympy.Expr]) -> list[Moving]:
        return [Moving(None if one == 0 else self.numbers.entry(one)) for one in expressions]

    def _matrix(self, expressions: Any) -> Matrix:
        entries = self._directions(expressions)
        return [entries[k : k + 3] for k in (0, 3, 6)]

    def placed(self, body: Link | None) -> tuple[Matrix, list[Moving]]:
        """Return the rotation (3, 3) of a body and the place (3,) of its origin."""
        if body not in self._placed:
            assert body is not None
            R, p = self.placed(body.parent)
            moved, turned = self._joint(body)
            fixed = R if body.rotation == _UNIT else product(R, self._matrix(body.rotation))
            at = self._at(R, p, self.vector(body.at))
            place = self._at(fixed, at, moved)
            self._placed[body] = self._settled(body, product(fixed, turned) if turned else fixed), place
        return self._placed[body]

    def _settled(self, body: Link, R: Matrix) -> Matrix:
        if self.numbers.settled is None:
            return R
        angles = body.coordinates[-3:] if body.joint in ROTATED else body.coordinates * (body.joint == "revolute")
        turns = [self._moved(body, one) for one in angles]
        self._turnings[body], R = self.numbers.settled(self._turnings.get(body.parent), turns, R)
        return R

    def _at(self, R: Matrix, p: Sequence[Moving], point: Sequence[Moving]) -> list[Moving]:
        return [origin + dot(row, point) for origin, row in zip(p, R, strict=True)]

    def _joint(self, body: Link) -> tuple[list[Moving], Matrix | None]:
        """Return the place and the rotation of the body in the frame of its joint."""
        q = [self._moved(body, one) for one in body.coordinates]
        still = [Moving()] * 3
        if body.joint == "fixed":
            return still, None
        if body.joint == "prismatic":
            return [axis * q[0] for axis in self._directions(body.axis)], None
        if body.joint == "revolute":
            return still, self._about(self._directions(body.axis), q[0])
        return (q[:3] if body.joint == "free" else still), self._rodrigues(q[-3:])

    def _moved(self, body: Link, coordinate: sympy.Expr) -> Moving:
        """Return ratio q + offset, and its rate."""
        q = Moving(self.values[coordinate], self.values.get(rate_of(coordinate)))
        scaled = q if body.ratio == 1 else self.constant(body.ratio) * q
        return scaled if body.offset == 0 else scaled + self.constant(body.offset)

    def _about(self, axis: Sequence[Moving], angle: Moving) -> Matrix:
        """Return c 1 + (1 - c) a a^T + s [a x]."""
        sine, cosine = self.numbers.sin(angle.value), self.numbers.cos(angle.value)
        s = Moving(sine, times(cosine, angle.rate))
        c = Moving(cosine, times(times(self.minus.value, sine), angle.rate))
        rest = Moving(self.numbers.of(sympy.S.One)) + self.minus * c
        return self._combined(c, [[a * b * rest for b in axis] for a in axis], s, axis)

    def _rodrigues(self, s: Sequence[Moving]) -> Matrix:
        """Return 1 + (8 [s x]^2 + 4 (1 - s.s) [s x]) / (1 + s.s)^2, where [s x]^2 = s s^T - s.s 1."""
        one, square = Moving(self.numbers.of(sympy.S.One)), dot(s, s)
        d = self._inverse((one + square) * (one + square))
        eight, four = Moving(self.numbers.of(sympy.Integer(8))) * d, Moving(self.numbers.of(sympy.Integer(4))) * d
        diagonal = one + self.minus * eight * square
        outer = [[a * b * eight for b in s] for a in s]
        return self._combined(diagonal, outer, four * (one + self.minus * square), s)

    def _combined(self, diagonal: Moving, outer: Matrix, factor: Moving, a: Sequence[Moving]) -> Matrix:
        """Return diagonal 1 + outer + factor [a x]."""
        x, y, z = (factor * entry for entry in a)
        minus_x, minus_y, minus_z = (self.minus * entry for entry in (x, y, z))
        skew = [[Moving(), minus_z, y], [z, Moving(), minus_x], [minus_y, x, Moving()]]
        return [[outer[i][j] + skew[i][j] + (diagonal if i == j else Moving()) for j in range(3)] for i in range(3)]

    def _inverse(self, d: Moving) -> Moving:
        value = self.numbers.inverse(d.value)
        return Moving(value, times(times(self.minus.value, times(value, value)), d.rate))

    # -- quantities ------------------------------------------------------------------------------------------------

    def quantity(self, quantity: Quantity) -> Number:
        """Return the value of a quantity; None if it is zero."""
        body = quantity.bodies[-1]
        if quantity.kind == "kinetic_energy":
            return self._sum(map(self._kinetic_energy, quantity.bodies))
        if quantity.kind == "potential_energy":
            return self._sum(self._potential_energy(one, self.vector(quantity.vector)) for one in quantity.bodies)
        R, p = self.placed(body)
        if quantity.kind == "rotation":
            return R[quantity.place[0]][quantity.place[1]].value
        if quantity.kind == "angular_velocity":
            row, other = ((2, 1), (0, 2), (1, 0))[quantity.place[0]]
            return dot([Moving(entry.rate) for entry in R[row]], R[other]).value
        (place,) = quantity.place
        point = self._at(R, p, self.vector(quantity.vector))[place]
        return point.value if quantity.kind == "position" else point.rate

    @staticmethod
    def _sum(terms: Any) -> Number:
        whole = None
        for term in terms:
            whole = plus(whole, term)
        return whole

    def _kinetic_energy(self, body: Link) -> Number:
        """Return m cdot^2 / 2 + h_i rdot_i . pdot + sum E_ij rdot_i . rdot_j / 2, with the columns r of R.

        E = tr(J) / 2 - J, and h is the first moment besides m c.
        """
        R, p = self.placed(body)
        xx, xy, xz, yy, yz, zz = body.inertia
        half = sympy.Rational(1, 2)
        E = {(0, 0): half * (yy + zz - xx) / 2, (1, 1): half * (xx + zz - yy) / 2, (2, 2): half * (xx + yy - zz) / 2,
             (0, 1): -xy, (0, 2): -xz, (1, 2): -yz}  # fmt: skip
        columns = [[Moving(row[k].rate) for row in R] for k in range(3)]
        c = [Moving(x.rate) for x in self._at(R, p, self.vector(body.center))]
        terms = [self.constant(body.mass / 2) * dot(c, c)]
        terms += [self.constant(e) * dot(columns[i], columns[j]) for (i, j), e in E.items() if e != 0]
        moved = [Moving(x.rate) for x in p]
        terms += [self.constant(h) * dot(columns[k], moved) for k, h in enumerate(body.moment) if h != 0]
        return self._sum(term.value for term in terms)

    def _potential_energy(self, body: Link, gravity: Sequence[Moving]) -> Number:
        R, p = self.placed(body)
        c = self._at(R, p, self.vector(body.center))
        weighed = self._at(R, [Moving()] * 3, self.vector(body.moment))
        return (self.minus * (self.constant(body.mass) * dot(c, gravity) + dot(weighed, gravity))).value
