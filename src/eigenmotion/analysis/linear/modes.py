"""Natural modes: eigenvalues and shapes of a linearised mechanism, and what they mean in words."""

from dataclasses import dataclass
from math import pi

import numpy as np
import scipy

from ...arguments.named_values import Vector

_NEUTRAL = 1e-7
"""Of the largest eigenvalue: what is left of double zeros by rounding is about the root of it."""
_TAKES_PART = 0.1
"""Of the largest share: below it a coordinate is not named."""


@dataclass(frozen=True, slots=True)
class Mode:
    """One mode, of a pair of complex eigenvalues that with the positive frequency.

    Attributes
    ----------
    eigenvalue : [1 / s]; deviations go with exp(eigenvalue t)
    shape : (n,) complex deviations of the coordinates, that with the largest share 1
    share : (n,) how much each takes part, |shape_k| sqrt(M_kk), the largest 1
    coordinates : names of x
    neutral : whether the eigenvalue is zero beside the largest of them
    """

    eigenvalue: complex
    shape: Vector
    share: Vector
    coordinates: tuple[str, ...]
    neutral: bool

    @property
    def frequency(self) -> float:
        """Oscillations a second [Hz]."""
        return 0.0 if self.neutral else abs(self.eigenvalue.imag) / (2 * pi)

    @property
    def damping(self) -> float:
        """The damping ratio, -Re / |eigenvalue|: 1 does not oscillate, what is below 0 grows. NaN where neutral."""
        return float("nan") if self.neutral else -self.eigenvalue.real / abs(self.eigenvalue)

    @property
    def grows(self) -> bool:
        """Whether it is unstable."""
        return not self.neutral and self.damping < -_NEUTRAL

    @property
    def decays(self) -> bool:
        """Whether it dies out."""
        return not self.neutral and self.damping > _NEUTRAL

    @property
    def words(self) -> str:
        """What it does, and who takes part."""
        return f"{self._behaviour()}: {self._shape()}"

    def _behaviour(self) -> str:
        rate, oscillates = self.eigenvalue.real, self.eigenvalue.imag != 0
        if self.neutral:
            return "neutral, nothing brings it back"
        undamped = abs(rate) <= _NEUTRAL * abs(self.eigenvalue)
        how = "undamped" if undamped else f"damping ratio {self.damping:.3g}"
        said = f"oscillates at {self.frequency:.4g} Hz, {how}" if oscillates else ""
        if undamped:
            return said
        grows = f"{'grows' if rate > 0 else 'decays'} by e in {1 / abs(rate):.4g} s"
        return f"{said}, {grows}" if said else grows

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
    """A system without what nothing depends on: coordinates that only follow have eigenvalues of zero.

    core : (r, r); kept : (r,) and followers : which of the numbers these are
    """

    matrix: Vector
    core: Vector
    kept: tuple[int, ...]
    followers: tuple[int, ...]


def reduced(matrix: Vector) -> Reduced:
    """Strip a system of numbers on which no other, but those stripped, depends."""
    kept = list(range(len(matrix)))
    while followers := [k for k in kept if not matrix[kept, k].any()]:
        kept = [k for k in kept if k not in followers]
    gone = tuple(k for k in range(len(matrix)) if k not in kept)
    return Reduced(matrix, matrix[np.ix_(kept, kept)], tuple(kept), gone)


def eigenvalues(system: Reduced) -> Vector:
    """Return them, the least stable first."""
    values = np.concatenate([np.zeros(len(system.followers)), _values(system.core)])
    return values[np.lexsort((values.imag, np.abs(values), -values.real))]


def eigenvectors(system: Reduced) -> list[tuple[complex, Vector]]:
    """Return (eigenvalue, vector of the whole system), one of each pair; what only follows stands alone, with zero."""
    found = [(0j, np.eye(len(system.matrix), dtype=complex)[k]) for k in system.followers]
    values, vectors = np.linalg.eig(system.core) if system.kept else (np.zeros(0), np.zeros((0, 0)))
    for value, vector in zip(values, vectors.T, strict=True):
        if value.imag >= 0:
            found.append((complex(value), _followed(system, value, vector)))
    return found


def _followed(system: Reduced, value: complex, vector: Vector) -> Vector:
    """Give the numbers that only follow what they have in this mode: (value - A_ff) z_f = A_fk z_k."""
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
    """Return the modes, the least stable first; Z (2 n, k) makes deviations of x and v of the system's numbers."""
    found, n = eigenvectors(system), len(coordinates)
    largest = max((abs(value) for value, _ in found), default=0.0)
    made = [_mode(value, Z[:n] @ vector, inertia, coordinates, abs(value) <= _NEUTRAL * largest)
            for value, vector in found]  # fmt: skip
    return tuple(sorted(made, key=lambda mode: (-mode.eigenvalue.real, abs(mode.eigenvalue))))


def _mode(value: complex, shape: Vector, inertia: Vector, coordinates: tuple[str, ...], neutral: bool) -> Mode:
    share = np.abs(shape) * inertia
    if largest := share.max():
        shape, share = shape / shape[int(share.argmax())], share / largest
    return Mode(value, shape, share, coordinates, neutral)
