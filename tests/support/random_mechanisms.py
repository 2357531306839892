"""Random mechanisms as a user may write them, with whatever the contract allows: see `Maker`.

Inertia comes from point masses, bodies and roots; frames turn with the time, so that T1 and T0 are there; coordinates
are declared real or nothing; parameters are positive or of either sign.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy
from sympy import Abs, Float, Max, Min, Piecewise, Rational, atan, cos, exp, sin, sqrt, tanh
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, t

Expr = sympy.Expr


@dataclass(frozen=True)
class State:
    """Where a mechanism is looked at: numbers of both signs, of sizes from 0.03 to 10."""

    x: np.ndarray
    v: np.ndarray
    time: float
    parameters: dict[str, float]
    inputs: dict[str, float]


class Maker:
    """Makes one mechanism; everything follows from the seed."""

    def __init__(self, seed: int) -> None:
        self.seed, self.random = seed, random.Random(seed)
        self.real = self.random.random() < 0.6
        self.n = self.random.choice((1, 2, 2, 3, 3, 4))
        self.q = list(
            dynamicsymbols(f"q_1:{self.n + 1}", real=True) if self.real else dynamicsymbols(f"q_1:{self.n + 1}")
        )
        self.v = [q.diff() for q in self.q]
        self.m = sympy.symbols("m_1:4", positive=True)
        self.k, self.a = sympy.Symbol("k", positive=True), sympy.Symbol("a", real=self.real or None)
        self.values = {m: self.random.uniform(0.3, 3) for m in self.m}
        self.values |= {self.k: self.random.uniform(0.3, 3), self.a: self.random.uniform(-2, 2)}
        self.u = dynamicsymbols("u")

    def chance(self, probability: float) -> bool:
        return self.random.random() < probability

    def one_of(self, *makers: Callable[[], Expr]) -> Expr:
        return self.random.choice(makers)()

    def number(self) -> Expr:
        exact = Rational(self.random.randint(1, 9), self.random.choice((1, 2, 3, 4)))
        return self.random.choice((-1, 1)) * (exact if self.chance(0.6) else Float(round(float(exact), 2)))

    def coordinate(self) -> Expr:
        return self.random.choice(self.q)

    # -- pieces ----------------------------------------------------------------------------------------------------

    def positive(self) -> Expr:
        """An expression that is positive everywhere; many of them are roots of squares."""
        q, r, c = self.coordinate(), self.coordinate(), self.number()
        return self.one_of(
            lambda: sqrt(1 + q**2 / 4), lambda: sqrt(2 + 2 * cos(q) ** 2), lambda: 1 + (sqrt(q**2) - q) / 2,
            lambda: 1 + sqrt((q - c) ** 2) + q - c, lambda: sqrt(self.k**2 + (q - r) ** 2), lambda: 1 + self.size(q),
            lambda: 1 + Max(0, q - c), lambda: Piecewise((1 + q**2, q > c), (1 + c**2, True)), lambda: exp(-q * q / 9),
            lambda: (1 + q**2 * r**2) ** Rational(1, 3), lambda: (2 + sin(q)) ** Rational(-3, 2),
            lambda: 2 + tanh(q - c), lambda: sqrt(sqrt(4 * q**2) + 1), lambda: sqrt(4 * (1 + q**2)),
        )  # fmt: skip

    def size(self, q: Expr) -> Expr:
        """|q| in one of its spellings; SymPy differentiates Abs of what is declared real only."""
        return Abs(q) if self.real and self.chance(0.5) else sqrt(q**2)

    def angle(self) -> Expr:
        return (
            self.coordinate() + (self.coordinate() if self.chance(0.3) else 0) + (self.a * t if self.chance(0.2) else 0)
        )

    def length(self) -> Expr:
        q = self.coordinate()
        return self.one_of(self.number, lambda: q, self.positive, lambda: self.k + q, lambda: self.number() + q / 3)

    def place(self) -> list[Expr]:
        """A point in space."""
        angle, length, tilt = self.angle(), self.length(), self.angle()
        spots = self.random.choice((
            [length * cos(angle), length * sin(angle), 0],
            [length * cos(angle) * cos(tilt), length * sin(angle) * cos(tilt), length * sin(tilt)],
            [self.coordinate(), self.positive(), self.coordinate() * self.number()],
        ))  # fmt: skip
        if self.chance(0.25):  # seen from a frame that turns, or moves
            c, s = cos(self.a * t), sin(self.a * t)
            spots = [c * spots[0] - s * spots[1] + t * self.k, s * spots[0] + c * spots[1], spots[2]]
        return [sympy.sympify(spot) for spot in spots]

    def rate(self) -> Expr:
        """Linear in the velocities."""
        terms = [self.factor() * v for v in self.v if self.chance(0.6)] or [self.factor() * self.random.choice(self.v)]
        return sympy.Add(*terms)

    def factor(self) -> Expr:
        return self.one_of(self.number, self.positive, lambda: sin(self.angle()), lambda: cos(self.angle()),
                           self.coordinate, lambda: self.k * self.positive())  # fmt: skip

    # -- the whole -------------------------------------------------------------------------------------------------

    def kinetic_energy(self) -> Expr:
        T = sympy.Add(
            *(self.random.choice(self.m) * v**2 / 2 * (self.positive() if self.chance(0.5) else 1) for v in self.v)
        )
        for m in self.m[: self.random.choice((0, 1, 1, 2))]:
            T += m / 2 * sympy.Add(*(coordinate.diff(t) ** 2 for coordinate in self.place()))
        for _ in range(self.random.choice((0, 1, 2))):
            T += self.k * self.rate() ** 2 / 2
        if self.chance(0.3):
            T += self.factor() * self.random.choice(self.v) + self.factor() * cos(t) / 3
        return T

    def potential_energy(self) -> Expr:
        q, c = self.coordinate(), self.number()
        terms = [self.m[0] * Float(9.81) * self.place()[2], self.k * (q - c) ** 2 / 2, self.size(q), self.factor(),
                 self.k * Max(0, q - c) ** 2, Piecewise((sqrt(q - c) ** 3, q > c), (0, True)), Min(q, c) * q,
                 Piecewise(((q - c) ** Rational(5, 2), q > c), (c * (q - c), True)), cos(self.a * t) * q]  # fmt: skip
        return sympy.Add(*self.random.sample(terms, self.random.randint(0, 3)))

    def forces(self) -> dict[Expr, Expr]:
        def force(q: Expr, v: Expr) -> Expr:
            return self.one_of(
                lambda: -self.k * v, lambda: -v * self.size(v), lambda: self.u * self.factor(),
                lambda: -tanh(v / self.k), lambda: atan(q) * cos(t), lambda: -(v**3) / 9 + self.u * t,
            )  # fmt: skip

        return {q: force(q, v) for q, v in zip(self.q, self.v, strict=True) if self.chance(0.4)}

    def holonomic(self) -> Expr:
        q, r = self.random.sample(self.q, 2)
        return self.one_of(
            lambda: q**2 + r**2 - 2, lambda: sin(q) + cos(r) * self.number(), lambda: sqrt(q**2 + 1) + r * 2,
            lambda: q * self.number() - r + sin(t), lambda: q + sqrt((r - 3) ** 2),
        )  # fmt: skip

    def rows(self) -> tuple[list[Expr], list[Expr]]:
        count = min(self.random.choice((0, 0, 1, 1, 2)), self.n - 1)
        holonomic = [self.holonomic() for _ in range(count) if self.chance(0.5)]
        others = [self.rate() + (self.factor() if self.chance(0.4) else 0) for _ in range(count - len(holonomic))]
        return holonomic, others

    def quasi(self) -> dict[Expr, Expr]:
        if not self.chance(0.25):
            return {}
        names = dynamicsymbols(f"w_1:{self.n + 1}")
        return {w: v + sum(sin(q) * other for q, other in zip(self.q[:k], self.v[:k], strict=True))
                for k, (w, v) in enumerate(zip(names, self.v, strict=True))}  # fmt: skip

    def model(self) -> Model:
        """Return the mechanism."""
        return Model(**self.fields())

    def fields(self) -> dict[str, Any]:
        """Return what the mechanism is made of, by name."""
        quasi, (holonomic, others) = self.quasi(), self.rows()
        T = self.kinetic_energy()
        if quasi:
            w = list(quasi)
            T += self.m[0] * w[0] ** 2 / 2 + w[-1] * self.random.choice(w) * self.k / 4 + w[-1] ** 2 * self.k
            others = [row + w[-1] * self.factor() for row in others]
        return {
            "name": f"fuzz_{self.seed}", "coordinates": self.q, "kinetic_energy": T,
            "potential_energy": self.potential_energy(), "forces": self.forces(),
            "holonomic_constraints": holonomic, "nonholonomic_constraints": others, "quasi_velocities": quasi,
            "parameters": self.values, "inputs": {self.u: 0.7},
            "scales": {q: self.random.choice((1, 1, 0.1, 30)) for q in self.q},
            "outputs": {"first": self.q[0] * self.v[0]},
            "initial": {q: self.random.uniform(-2, 2) for q in self.q},
        }  # fmt: skip

    def state(self) -> State:
        """Return a state at random."""
        size = 10 ** self.random.uniform(-1.5, 1)
        x, v = ([size * self.random.uniform(-1, 1) for _ in self.q] for _ in range(2))
        p = {str(symbol): self.random.uniform(0.3, 3) for symbol in self.values} | {"a": self.random.uniform(-2, 2)}
        return State(np.array(x), np.array(v), self.random.uniform(0, 3), p, {"u": self.random.uniform(-2, 2)})
