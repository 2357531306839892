"""Natural modes: eigenvalues and shapes of a linearised mechanism, with descriptions."""

from dataclasses import dataclass
from math import pi

import numpy as np
import scipy

from ...arguments.named_values import Vector

_NEUTRAL = 1e-7
"""Largest neutral eigenvalue, relative to the largest of all: rounding moves double zeros by about its square root."""
_TAKES_PART = 0.1
"""Coordinates with less than this part of the largest share are not named."""


@dataclass(frozen=True, slots=True)
class Mode:
    """One mode; of a pair of complex eigenvalues, the one with positive frequency.

    Attributes
    ----------
    eigenvalue : [1 / s]; deviations are proportional to exp(eigenvalue t)
    shape : (n,) complex deviations of the coordinates; 1 for the one with the largest share
    share : (n,) |shape_k| sqrt(M_kk), scaled so that the largest is 1
    coordinates : names of x
    neutral : whether the eigenvalue is zero relative to the largest one
    """

    eigenvalue: complex
    shape: Vector
    share: Vector
    coordinates: tuple[str, ...]
    neutral: bool

    @property
    def frequency(self) -> float:
        """Frequency of oscillation [Hz]."""
        return 0.0 if self.neutral else abs(self.eigenvalue.imag) / (2 * pi)

    @property
    def damping(self) -> float:
        """The damping ratio, -Re / |eigenvalue|: 1 for pure decay, negative for growth, NaN if neutral."""
        return float("nan") if self.neutral else -self.eigenvalue.real / abs(self.eigenvalue)

    @property
    def grows(self) -> bool:
        """Whether the mode is unstable."""
        return not self.neutral and self.damping < -_NEUTRAL

    @property
    def decays(self) -> bool:
        """Whether the mode decays."""
        return not self.neutral and self.damping > _NEUTRAL

    @property
    def words(self) -> str:
        """A description of the behaviour and of the coordinates that take part."""
        return f"{self._behaviour()}: {self._shape()}"

    def _behaviour(self) -> str:
        rate, oscillates = self.eigenvalue.real, self.eigenvalue.imag != 0
        if self.neutral:
            return "neutral, nothing brings it back"
        undamped = abs(rate) <= _NEUTRAL * abs(self.eigenvalue)
        how = "undamped" if undamped else f"damping ratio {self.damping:.3g}"
        text = f"oscillates at {self.frequency:.4g} Hz, {how}" if oscillates else ""
        if undamped:
            return text
        grows = f"{'grows' if rate > 0 else 'decays'} by e in {1 / abs(rate):.4g} s"
        return f"{text}, {grows}" if text else grows

    def _shape(self) -> str:
        order = [int(k) for k in np.argsort(-self.share, kind="stable") if self.share[k] >= _TAKES_PART]
        if not order:
            return "velocities alone"
        named = [self.coordinates[order[0]], *(f"{self.coordinates[k]}{self._phase(k)}" for k in order[1:])]
        return ", ".join(named)

    def _phase(self, k: int) -> str:
        angle = float(np.angle(self.shape[k], deg=True))
        if abs(angle) < 10:
            return " alike"
        return " opposite" if abs(angle) > 170 else f" {angle:+.0f} deg"


@dataclass(frozen=True, slots=True)
class Reduced:
    """A system split into a core and followers, which no equation depends on and which have zero eigenvalues.

    core : (r, r); kept : (r,) indices of the numbers in the core; followers : indices of the others
    """

    matrix: Vector
    core: Vector
    kept: tuple[int, ...]
    followers: tuple[int, ...]


def reduced(matrix: Vector) -> Reduced:
    """Remove, repeatedly, the numbers on which no other remaining number depends."""
    kept = list(range(len(matrix)))
    while followers := [k for k in kept if not matrix[kept, k].any()]:
        kept = [k for k in kept if k not in followers]
    gone = tuple(k for k in range(len(matrix)) if k not in kept)
    return Reduced(matrix, matrix[np.ix_(kept, kept)], tuple(kept), gone)


def eigenvalues(system: Reduced) -> Vector:
    """Return the eigenvalues, the least stable first."""
    values = np.concatenate([np.zeros(len(system.followers)), _values(system.core)])
    return values[np.lexsort((values.imag, np.abs(values), -values.real))]


def eigenvectors(system: Reduced) -> list[tuple[complex, Vector]]:
    """Return (eigenvalue, vector of the whole system), one of each complex pair; followers have eigenvalue zero."""
    pairs = [(0j, np.eye(len(system.matrix), dtype=complex)[k]) for k in system.followers]
    values, vectors = np.linalg.eig(system.core) if system.kept else (np.zeros(0), np.zeros((0, 0)))
    for value, vector in zip(values, vectors.T, strict=True):
        if value.imag >= 0:
            pairs.append((complex(value), _with_followers(system, value, vector)))
    return pairs


def _with_followers(system: Reduced, value: complex, vector: Vector) -> Vector:
    """Return the eigenvector with its followers: (value - A_ff) z_f = A_fk z_k."""
    kept, gone = list(system.kept), list(system.followers)
    whole = np.zeros(len(system.matrix), dtype=complex)
    whole[kept] = vector
    if gone and value != 0:
        among = value * np.eye(len(gone)) - system.matrix[np.ix_(gone, gone)]
        whole[gone] = np.linalg.solve(among, system.matrix[np.ix_(gone, kept)] @ vector)
    return whole


def _values(matrix: Vector) -> Vector:
    return scipy.linalg.eigvals(matrix).astype(complex) if len(matrix) else np.zeros(0, dtype=complex)


def modes(system: Reduced, Z: Vector, inertia: Vector, coordinates: tuple[str, ...]) -> tuple[Mode, ...]:
    """Return the modes, the least stable first; Z (2 n, k) maps the system's numbers to deviations of x and v."""
    pairs, n = eigenvectors(system), len(coordinates)
    largest = max((abs(value) for value, _ in pairs), default=0.0)
    unsorted = [_mode(value, Z[:n] @ vector, inertia, coordinates, abs(value) <= _NEUTRAL * largest)
                for value, vector in pairs]  # fmt: skip
    return tuple(sorted(unsorted, key=lambda mode: (-mode.eigenvalue.real, abs(mode.eigenvalue))))


def _mode(value: complex, shape: Vector, inertia: Vector, coordinates: tuple[str, ...], neutral: bool) -> Mode:
    share = np.abs(shape) * inertia
    if largest := share.max():
        shape, share = shape / shape[int(share.argmax())], share / largest
    return Mode(value, shape, share, coordinates, neutral)
