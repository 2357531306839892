"""Curve of solutions: fewer equations than unknowns by one, and Newton's method for the nearest point."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError

_ITERATIONS = 8
_SINGULAR = 1e-7
"""Singular values below this part of the largest count as 0: near a branch point the other branch is left alone."""
CORNER, GRAZING, MODE = "corner", "grazing", "mode change"
_ACCURATE = 1e-7
"""Largest correction of a point that is left out."""


class NoPointError(ModelError):
    """There is no point of the curve near."""


@dataclass(frozen=True)
class Sample:
    """A place near a curve.

    w : (N,) the state, perhaps the period, and the followed parameter, which is last
    unit : (N,) sizes by which changes of w are measured
    E : (N, k) changes of w with the k unknowns, which are in units; the last unknown is the parameter
    F, J : (m,) residuals in units, (m, k) their derivatives
    noise : size of residuals that are errors; detail : the motion or the state
    """

    w: Vector
    unit: Vector
    E: Vector
    F: Vector
    J: Vector
    noise: float
    detail: Any

    @property
    def parameter(self) -> float:
        """The value of the followed parameter."""
        return float(self.w[-1])


@dataclass(frozen=True)
class Spectrum:
    """values : (k,) complex multipliers or eigenvalues; errors : (k,); stable : None if undecided."""

    values: NDArray[np.complex128]
    errors: Vector
    stable: bool | None


@dataclass(frozen=True)
class Place:
    """A point of a curve.

    tangent : (N,) of unit length, in units of the sample; smallest : the least singular value of J, relative to the
    largest: 0 where branches cross; rounds : number of samples that Newton's method took
    """

    sample: Sample
    tangent: Vector
    smallest: float
    rounds: int


@dataclass(frozen=True)
class Meeting:
    """A change between two points of what a curve's equations hold for: of the order of events, or of the contact mode.

    kind : CORNER, beyond which a curve may go on, GRAZING or MODE; names : of the events, the contact or the friction
    words : what happens there; why : why the curve ends there, or ""
    before : of a detail, whether it is on the first side; value : of a detail before, which is 0 there
    """

    kind: str
    names: tuple[str, ...]
    words: str
    why: str
    before: Callable[[Any], bool]
    value: Callable[[Any], float]


class Curve(Protocol):
    """Equations with one unknown more than there are equations."""

    def at(self, w: Vector) -> Sample:
        """Return the equations at a place near the curve; raises NoPointError."""

    def spectrum(self, sample: Sample) -> Spectrum:
        """Return the multipliers or eigenvalues at a point."""

    def obstacle(self, before: Sample, after: Sample, /) -> str:
        """Return the reason why a curve is not smooth between two points, or ""."""

    def meeting(self, before: Sample, after: Sample | None, /) -> "Meeting | None":
        """Return the single change of the order of events, or of the contact mode, between two points, or None.

        Without a second point: the change that is about to happen.
        """


Normal = tuple[Vector, Vector]
"""A hyperplane of w: its normal (N,), and a point on it."""


def corrected(curve: Curve, w: Vector, plane: Normal | None = None, accurate: float = _ACCURATE) -> tuple[Sample, int]:
    """Return the point of the curve nearest to w, or that in a hyperplane, by Newton's method.

    Raises
    ------
    NoPointError
        The method does not converge.
    """
    before = np.inf
    for rounds in range(1, _ITERATIONS + 1):
        here = curve.at(w)
        change = _correction(here, plane)
        size = float(np.linalg.norm(change))
        if not np.isfinite(size):
            raise NoPointError("the derivatives are not finite")
        within = float(np.abs(here.F).max(initial=0.0)) <= here.noise
        if within and (size <= accurate or size > 0.3 * before):
            return here, rounds
        if size > 1.5 * before or size > 10.0:
            break
        before, w = size, here.w + here.E @ change
    raise NoPointError("Newton's method does not converge")


def _correction(here: Sample, plane: Normal | None) -> Vector:
    """Return the shortest change of the unknowns that solves the linearised equations."""
    J, F, least = here.J, here.F, len(here.J.T) - 1
    if plane is not None:
        normal, through = plane
        J = np.vstack([J, normal @ here.E])
        F, least = np.append(F, normal @ (here.w - through)), least + 1
    U, s, V = np.linalg.svd(J, full_matrices=False)
    kept = (np.arange(len(s)) < least) & (s > _SINGULAR * s[0])
    change: Vector = -V[kept].T @ ((U[:, kept].T @ F) / s[kept])
    return change


def place(sample: Sample, forward: Vector, rounds: int = 0) -> Place:
    """Return a point with its tangent, which points along `forward` (N,), a change of w."""
    s, V = np.linalg.svd(sample.J)[1:]
    along = sample.E @ V[-1] / sample.unit
    along = along / np.linalg.norm(along)
    count = len(V) - 1
    smallest = float(s[count - 1] / s[0]) if 0 < count <= len(s) else 1.0
    return Place(sample, along * (1.0 if along @ (forward / sample.unit) >= 0.0 else -1.0), smallest, rounds)


def point(curve: Curve, w: Vector, forward: Vector, plane: Normal | None = None, accurate: float = _ACCURATE) -> Place:
    """Return the point of the curve that `corrected` finds, with its tangent along `forward`; raises NoPointError."""
    sample, rounds = corrected(curve, w, plane, accurate)
    return place(sample, forward, rounds)


def in_between(curve: Curve, first: Place, second: Place) -> Callable[[float], Place]:
    """Return the function of points between two: at the part s in [0, 1] of the chord."""
    a, b, unit = first.sample.w, second.sample.w, first.sample.unit
    chord = b - a
    length = float(np.linalg.norm(chord / unit))
    normal = chord / unit**2 / length
    slopes = [one.tangent * one.sample.unit for one in (first, second)]
    slopes = [slope * length / float((slope / unit) @ (chord / unit) / length) for slope in slopes]

    def at(s: float) -> Place:
        r = 1.0 - s
        w = a * (1 + 2 * s) * r**2 + b * (3 - 2 * s) * s**2 + slopes[0] * s * r**2 - slopes[1] * s**2 * r
        through = a + s * chord
        w = w + (normal @ (through - w)) * unit**2 * normal
        return point(curve, w, chord, (normal, through), 1e-11)

    return at
