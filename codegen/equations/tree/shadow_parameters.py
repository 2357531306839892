"""Orientation without singularities: the modified Rodrigues parameters that a run may replace by their shadow set.

Parameters s and -s / |s|^2 are the same rotation (Schaub and Junkins 1996). Functions of bodies are the same for both.
Expressions with the parameters themselves need not be: there a change to the shadow set would change the motion. These
are compared in both sets at random states.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import sympy
from sympy.core.function import AppliedUndef

from ...model.recursion_depth import expressions_in
from ...model.statement.mechanism import Mechanism
from ...model.tree.body import ROTATED, Link, rate_of
from ...model.tree.functions import BodyFunction
from .placements import bodies_of

_STATES = 2
"""Number of random states."""
_ROUNDING = 1e-9
"""Relative difference of equal values."""

Point = Mapping[sympy.Expr, sympy.Expr]
Rotation = tuple[sympy.Expr, sympy.Expr, sympy.Expr]


def rotations(model: Mechanism) -> tuple[tuple[int, ...], ...]:
    """Return the numbers of the parameters, three for each rotation, whose shadow set has the same motion."""
    numbers = {q: number for number, q in enumerate(model.coordinates)}
    bodies = tuple(bodies_of(model))
    found = {frozenset(s): s for s in (body.coordinates[-3:] for body in bodies if body.joint in ROTATED)}
    return tuple(
        tuple(numbers[q] for q in s)
        for s in found.values()
        if not any(_uses_otherwise(body, s) for body in bodies) and _has_same_motion(model, s)
    )


def _uses_otherwise(body: Link, s: Rotation) -> bool:
    """Whether the joint of a body has some of these parameters, but not as those of its rotation."""
    own = body.coordinates[:-3] if body.joint in ROTATED and set(body.coordinates[-3:]) == set(s) else body.coordinates
    return not set(s).isdisjoint(own)


def _has_same_motion(model: Mechanism, s: Rotation) -> bool:
    own = {*s, *map(rate_of, s)}
    explicit = [one for one in _invariants(model, s) if _contains(one, own)]
    forces = [Q for q, Q in zip(model.coordinates, model.forces, strict=True) if q in s]
    if not explicit and not any(forces):
        return True
    states = [_States.random(model, s, seed) for seed in range(_STATES)]
    return all(one.has_same_values(explicit) and one.has_same_powers(forces) for one in states)


def _invariants(model: Mechanism, s: Rotation) -> Iterator[sympy.Expr]:
    """Yield the expressions of the motion whose values must be the same; not the forces on the parameters."""
    yield from (model.kinetic_energy, model.potential_energy)
    yield from (*model.holonomic_constraints, *model.nonholonomic_constraints)
    yield from (Q for q, Q in zip(model.coordinates, model.forces, strict=True) if q not in s)
    yield from (rate for _, rate in model.states)
    yield from expressions_in(model.contacts)


def _contains(expression: sympy.Expr, own: set[sympy.Expr]) -> bool:
    """Whether an expression contains parameters or their rates, other than in functions of bodies."""
    stack: list[sympy.Basic] = [expression]
    seen: set[sympy.Basic] = set()
    while stack:
        part = stack.pop()
        if part in own:
            return True
        if part in seen or (isinstance(part, BodyFunction) and not any(part.orders)):
            continue
        seen.add(part)
        stack.extend(part.args)
    return False


@dataclass(frozen=True)
class _States:
    """A state in both sets of the parameters s (3,): values of all coordinates and rates."""

    s: tuple[float, ...]
    here: Point
    there: Point

    @classmethod
    def random(cls, model: Mechanism, s: Rotation, seed: int) -> _States:
        """Return a random state."""
        draw = random.Random(seed)
        values = {q: draw.uniform(0.3, 1.3) for q in (*model.coordinates, *model.rates)}
        a, v = [values[q] for q in s], [values[rate_of(q)] for q in s]
        square, along = sum(x * x for x in a), sum(x * y for x, y in zip(a, v, strict=True))
        after = values | {q: -x / square for q, x in zip(s, a, strict=True)}
        after |= {rate_of(q): (2 * along / square * x - y) / square for q, x, y in zip(s, a, v, strict=True)}
        return cls(tuple(a), *({q: sympy.Float(x) for q, x in one.items()} for one in (values, after)))

    def has_same_values(self, expressions: Sequence[sympy.Expr]) -> bool:
        """Whether expressions have the same values in both sets."""
        return all(_is_same(_value(one, self.here), _value(one, self.there)) for one in expressions)

    def has_same_powers(self, forces: Sequence[sympy.Expr]) -> bool:
        """Whether forces on the parameters have the same power: Q = D^T Q', D = d s' / d s."""
        here, there = ([_value(Q, point) for Q in forces] for point in (self.here, self.there))
        square = sum(x * x for x in self.s)
        along = sum(x * Q for x, Q in zip(self.s, there, strict=True))
        turned = [(2 * along / square * x - Q) / square for x, Q in zip(self.s, there, strict=True)]
        return all(map(_is_same, here, turned))


def _is_same(a: complex, b: complex) -> bool:
    return abs(a - b) <= _ROUNDING * max(abs(a), abs(b), 1e-3)  # False for NaN


def _value(expression: sympy.Expr, point: Point) -> complex:
    """Return a value, with numbers of order 1 for all other symbols and functions; NaN if there is none."""
    leaves = expression.free_symbols | expression.atoms(AppliedUndef, sympy.Derivative)
    others = {leaf: sympy.Float(random.Random(str(leaf)).uniform(0.5, 1.5)) for leaf in leaves if leaf not in point}
    try:
        return complex(expression.xreplace({**others, **point}).evalf())
    except TypeError:
        return complex("nan")
