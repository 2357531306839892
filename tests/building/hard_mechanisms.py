"""Mechanisms whose expressions cancel: factors zero unexpanded, axes that turn fast, far-off units, M near singular."""

from __future__ import annotations

import random
from collections.abc import Callable

import sympy
from sympy import Abs, Max, Piecewise, atan, cos, cosh, exp, sin, sinh, sqrt, tan, tanh
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model

Expr = sympy.Expr
A, B, C = X = dynamicsymbols("A B C")
a, b, c = (x.diff() for x in X)
l, r, k = sympy.symbols("l r k")

ZEROS: tuple[Callable[[], Expr], ...] = (
    lambda: (l * sin(A) + r * sin(A) * sin(B)) * cos(A) - (l * cos(A) + r * sin(B) * cos(A)) * sin(A),
    lambda: sympy.Add(sin(A + B), -sin(A) * cos(B), -cos(A) * sin(B), evaluate=False),
    lambda: (A + B) ** 2 - A**2 - 2 * A * B - B**2,
    lambda: (l + r * cos(A)) ** 2 + (r * sin(A)) ** 2 - l**2 - 2 * l * r * cos(A) - r**2,
    lambda: exp(A + B) - exp(A) * exp(B, evaluate=False),
    lambda: tan(A) * cos(A) - sin(A),
    lambda: cosh(A) ** 2 - sinh(A) ** 2 - 1,
    lambda: (A - B) * (A + B) - A**2 + B**2,
    lambda: (A * B - C) ** 3 - A**3 * B**3 + 3 * A**2 * B**2 * C - 3 * A * B * C**2 + C**3,
    lambda: cos(2 * A) - 2 * cos(A) ** 2 + 1,
    lambda: k * (A + l) - k * A - k * l,
)
"""Expressions that are zero and do not show it."""


class Hard:
    """Makes one mechanism of three coordinates; everything follows from the seed."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.T: Expr = (a**2 + b**2 + c**2) / 2
        self.more: dict[str, object] = {}
        kinds = (self.row, self.mass, self.force, self.potential, self.phi, self.turning, self.winding, self.units,
                 self.stiff, self.singular, self.distant, self.kinked)  # fmt: skip
        kinds[seed % len(kinds)]()

    def model(self) -> Model:
        return Model(
            name="hard", coordinates=X, kinetic_energy=self.T, parameters={l: 0.5, r: 0.3, k: 3.7}, **self.more
        )

    def zero(self) -> Expr:
        return self.random.choice(ZEROS)()

    def one_of(self, *numbers: float) -> float:
        return self.random.choice(numbers)

    def row(self) -> None:
        self.more["nonholonomic_constraints"] = [c + a * self.zero() + b * self.random.choice([self.zero(), sin(A)])]

    def mass(self) -> None:
        self.T += self.zero() * a * b * self.one_of(1, 1e3) + self.zero() ** 2 * c**2

    def force(self) -> None:
        size = self.one_of(1, 1e6)
        self.more["forces"] = {A: size * self.zero(), B: self.zero() * b + c, C: -c * Abs(self.zero())}

    def potential(self) -> None:
        self.more["potential_energy"] = self.zero() * self.one_of(1, 1e6, 1e12) + l * cos(A)

    def phi(self) -> None:
        self.more["holonomic_constraints"] = [A - C + self.zero()]

    def turning(self) -> None:
        """Axes of M that turn, or turn over, within a small part of the way."""
        w = self.one_of(1e2, 1e4, 1e6, 1e8)
        angle = self.random.choice([w * A, atan(w * A), w * (A - B), tanh(w * B)])
        along, across = cos(angle) * b + sin(angle) * c, cos(angle) * c - sin(angle) * b
        self.T = (a**2 + self.one_of(4, 1.01, 1e3, 1e6) * along**2 + across**2) / 2

    def winding(self) -> None:
        w = self.one_of(1e2, 1e4, 1e6)
        self.T += ((sin(w * A) * B).diff() ** 2 + (cos(w * A) * B).diff() ** 2) / 2

    def units(self) -> None:
        length, mass = self.one_of(1e-6, 1e3, 1e6), self.one_of(1e-6, 1, 1e6)
        self.T = mass * (a**2 * length**2 * (2 + cos(A - B)) + b**2 * length**2 + c**2 + length * a * c * cos(B)) / 2
        spring = mass * self.one_of(1e-6, 1, 1e12) * (C / length - sin(A)) ** 2
        self.more["potential_energy"] = spring + mass * 9.81 * length * cos(A)
        self.more["initial"] = {C: length}
        if self.random.random() < 0.5:
            self.more["holonomic_constraints"] = [C**2 + (length * sin(A)) ** 2 - length**2]

    def stiff(self) -> None:
        self.more["potential_energy"] = 1e12 * (A - B) ** 2 + 1e10 * (sqrt(A**2 + B**2 + l**2) - l) ** 2 + 9.81 * C

    def singular(self) -> None:
        """M whose least eigenvalue is rounding, or near it."""
        self.T = ((a + b) ** 2 + self.one_of(1e-6, 1e-9, 1e-12, 1e-14, 1e-15) * b**2 + c**2 + cos(A) * c * a / 3) / 2
        self.more["potential_energy"] = cos(A) + B**2 + C * B
        if self.random.random() < 0.5:
            self.more["holonomic_constraints"] = [A - B * C]

    def distant(self) -> None:
        d = self.one_of(1e3, 1e6, 1e9)
        self.T = ((1 + (A - d) ** 2) * a**2 + b**2 + c**2 + cos(A - d) * a * b / 2) / 2
        self.more["potential_energy"] = (A - d) ** 2 * B + (B + d) ** 2 - B**2 - 2 * d * B - d**2
        self.more["initial"] = {A: d}

    def kinked(self) -> None:
        """Roots, absolute values and conditions of what vanishes."""
        self.T = ((1 + self.zero() ** 2) * a**2 + (2 + sqrt(self.zero() ** 2)) * b**2 + c**2) / 2
        self.T += (1 + A**2) ** self.random.choice([sympy.Rational(3, 2), sympy.Rational(-5, 2), 4]) * c**2 / 2
        self.more["potential_energy"] = (Max(self.zero(), 0) * A + Abs(self.zero()) ** 3
                                         + Piecewise((A**2, A + self.zero() > B), (B**2, True)))  # fmt: skip
