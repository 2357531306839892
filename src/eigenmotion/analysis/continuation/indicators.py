"""Indicators of bifurcations: functions along a branch that change sign where one is."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .curve import Place, Spectrum

FOLD, BRANCHING, HOPF, DOUBLING, TORUS = "fold", "branch point", "Hopf", "doubling", "torus"
FLUTTER = "flutter"
"""Two frequencies of an undamped equilibrium meet."""
_SYMMETRIC, _MET = 1e-6, 1e-12
"""Largest sum of two opposite eigenvalues, and discriminant that is 0, relative to their sizes."""
_FLAT = 1e-10
"""Parameter's part of a tangent below which the sign is undecided."""


@dataclass(frozen=True)
class Indicator:
    """The value of a function whose sign changes; sign : -1, 1, or 0 if it is undecided."""

    value: float
    sign: int


def indicators(of_cycle: bool) -> dict[str, Callable[[Place, Spectrum], Indicator]]:
    """Return the functions for cycles, or for equilibria."""
    shared = {FOLD: _turning}
    if of_cycle:
        return shared | {BRANCHING: _at(1.0), DOUBLING: _at(-1.0), TORUS: _pairs(_product)}
    return shared | {BRANCHING: _at(0.0), HOPF: _pairs(_sum), FLUTTER: _meeting}


def is_oscillation(kind: str, spectrum: Spectrum) -> bool:
    """Return whether the pair that is critical at a Hopf bifurcation or at a torus is complex."""
    values = spectrum.values
    if kind == FLUTTER:  # two pairs, both complex
        gaps = np.abs(values[:, None] - values) + np.diag(np.full(len(values), np.inf))
        met = np.flatnonzero(gaps.min(axis=1) <= 2.0 * gaps.min())
        return bool((np.abs(values.imag) > 1e-6 * np.abs(values))[met].all())
    distance = np.abs(values.real) if kind == HOPF else np.abs(np.abs(values) - 1.0)
    turning = np.abs(values.imag) > 1e-6 * np.abs(values)
    nearest = np.argsort(distance)[:2]
    return len(nearest) == 2 and bool(turning[nearest].all())


def _turning(here: Place, _: Spectrum) -> Indicator:
    value = float(here.tangent[-1])
    return Indicator(value, 0 if abs(value) <= _FLAT else int(np.sign(value)))


def _at(critical: float) -> Callable[[Place, Spectrum], Indicator]:
    """Return the product of the distances from a real number.

    Those of multipliers that are 0 are positive: there may be others as many on the other side of a rest.
    """
    side = -1.0 if critical >= 0.0 else 1.0

    def product(_: Place, spectrum: Spectrum) -> Indicator:
        distances = side * (spectrum.values - critical)
        return _product_of(distances, 1.0 + np.abs(spectrum.values), spectrum.errors)

    return product


Pairing = Callable[[NDArray[np.complex128], NDArray[np.complex128]], tuple[NDArray[np.complex128], NDArray[np.float64]]]


def _pairs(pairing: Pairing) -> Callable[[Place, Spectrum], Indicator]:
    """Return the product over all pairs of different values."""

    def product(_: Place, spectrum: Spectrum) -> Indicator:
        first, second = np.triu_indices(len(spectrum.values), 1)
        distances, sizes = pairing(spectrum.values[first], spectrum.values[second])
        return _product_of(distances, sizes, spectrum.errors[first] + spectrum.errors[second])

    return product


def _sum(first: NDArray[np.complex128], second: NDArray[np.complex128]
         ) -> tuple[NDArray[np.complex128], NDArray[np.float64]]:  # fmt: skip
    return first + second, np.maximum(np.abs(first) + np.abs(second), 1e-300)


def _product(first: NDArray[np.complex128], second: NDArray[np.complex128]
             ) -> tuple[NDArray[np.complex128], NDArray[np.float64]]:  # fmt: skip
    return first * second - 1.0, 1.0 + np.abs(first * second)


def _product_of(distances: NDArray[np.complex128], sizes: NDArray[np.float64], errors: NDArray[np.float64]
                ) -> Indicator:  # fmt: skip
    if not len(distances):
        return Indicator(1.0, 1)
    value = float(np.prod(distances / sizes).real)
    return Indicator(value, 0 if (np.abs(distances) <= errors).any() else int(np.sign(value)))


def _meeting(_: Place, spectrum: Spectrum) -> Indicator:
    """Return the discriminant of the squares of eigenvalues that come in opposite pairs; undecided if they do not."""
    values = spectrum.values
    size = np.abs(values).max(initial=0.0)
    opposite = np.abs(values[:, None] + values).min(axis=1, initial=np.inf) <= _SYMMETRIC * size
    turning = np.abs(values.imag) > _SYMMETRIC * size
    halves = values[np.where(turning, values.imag > 0.0, values.real > 0.0)]
    if not opposite.all() or 2 * len(halves) != len(values):
        return Indicator(1.0, 0)
    squares = (halves / size) ** 2
    first, second = np.triu_indices(len(squares), 1)
    value = float(np.prod((squares[first] - squares[second]) ** 2).real)
    return Indicator(value, 0 if abs(value) <= _MET ** len(first) else int(np.sign(value)))
