"""Polynomials in d, e and r with d^2 = e^2 = r^2 = 0: values with mixed derivatives, exact to rounding.

d and e are the units of hyper-dual numbers, and r that of time, along which bodies have velocities. A product has the
product rule. Coefficients are arrays, without bounds of their errors: bounds are jets of their own, of the sizes and
errors of coefficients.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from .hyperdual import HyperDual
from .rounding_bounds import Part, Rounded

D, E, R = 1, 2, 4
LETTERS = {0: "a", D: "b", E: "c", D | E: "f"}
"""Order of a derivative -> the part of a hyper-dual number."""


@dataclass(frozen=True, slots=True, eq=False)
class Jet:
    """A polynomial in d, e and r.

    parts : order, a sum of D, E and R -> coefficient; zero where there is none
    """

    parts: Mapping[int, Part]

    def __add__(self, other: Jet) -> Jet:
        parts = dict(self.parts)
        for order, part in other.parts.items():
            parts[order] = parts[order] + part if order in parts else part
        return Jet(parts)

    def __mul__(self, other: Jet) -> Jet:
        return self.times(other, operator.mul)

    def times(self, other: Jet, product: Callable[[Part, Part], Part]) -> Jet:
        """Return the product, with a bilinear function of coefficients as theirs."""
        parts: dict[int, Part] = {}
        for order, part in self.parts.items():
            for beside, factor in other.parts.items():
                if not order & beside:
                    term = product(part, factor)
                    whole = order | beside
                    parts[whole] = parts[whole] + term if whole in parts else term
        return Jet(parts)

    def each(self, function: Callable[[Part], Part]) -> Jet:
        """Return a linear function of the coefficients."""
        return Jet({order: function(part) for order, part in self.parts.items()})

    @property
    def rate(self) -> Jet:
        """The coefficient of r, which is a jet in d and e."""
        return Jet({order & ~R: part for order, part in self.parts.items() if order & R})

    @property
    def timeless(self) -> Jet:
        """The terms without r."""
        return Jet({order: part for order, part in self.parts.items() if not order & R})

    @property
    def plain(self) -> Jet:
        """The terms without e."""
        return Jet({order: part for order, part in self.parts.items() if not order & E})

    @property
    def across(self) -> Jet:
        """The terms with e."""
        return Jet({order: part for order, part in self.parts.items() if order & E})

    @property
    def change(self) -> Jet:
        """The terms but for the value: of their sum, powers from the fourth on vanish."""
        return Jet({order: part for order, part in self.parts.items() if order})


def exponential(jet: Jet) -> Jet:
    """Return exp of a jet without a value: 1 + x + x^2 / 2 + x^3 / 6."""
    first, second, third = powers(jet)
    return Jet({0: np.ones((1, 1))}) + first + second + third


def powers(jet: Jet) -> tuple[Jet, Jet, Jet]:
    """Return x, x^2 / 2 and x^3 / 6 of a jet without a value."""
    square = (jet * jet).each(lambda part: 0.5 * part)
    return jet, square, (square * jet).each(lambda part: part / 3.0)


def jets_of(value: HyperDual, rate: HyperDual | None) -> tuple[Jet, Jet]:
    """Return a number and its rate as a jet, and the bounds of their errors as another."""
    parts: dict[int, Rounded] = {}
    for number, along in ((value, 0), (rate, R)):
        for order, letter in LETTERS.items() if number is not None else ():
            if (part := getattr(number, letter)) is not None:
                parts[order | along] = part
    return (Jet({order: part.value for order, part in parts.items()}),
            Jet({order: part.bound for order, part in parts.items()}))  # fmt: skip
