"""What a run is compared with: closed forms, or independent integration in extended precision."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cache
from typing import Any, Protocol

import numpy as np

from ..arguments.names import Vector
from ..codegen.model import Model
from ..reference.classical import Classical, classical
from ..reference.extended import Extended, Rhs, extended, trajectory
from .collocation import collocated

FINE, CHECK, ROUGH = range(3)  # how well rows are wanted: to compare with; to tell the error of that; to 1e-9


class Truth(Protocol):
    """Rows (k, 2n) of x, v at times (k,) for a start (2n,) at the first of the times."""

    @property
    def how(self) -> str:
        """What it is, in words."""

    @property
    def own(self) -> float:
        """Error that two levels do not show: rounding."""

    def rows(self, start: Vector, times: Vector, level: int) -> Vector:
        """Integrate, or evaluate."""


@dataclass(frozen=True)
class ClosedForm:
    """function(start (2n,), elapsed (k,)) -> (k, 2n)."""

    function: Callable[[Vector, Vector], Vector]
    how: str
    own: float = 1e-12

    def rows(self, start: Vector, times: Vector, level: int) -> Vector:  # noqa: ARG002, as exact as it gets
        return self.function(start, times - times[0])


@dataclass(frozen=True)
class Integrated:
    """Extrapolated midpoint steps in extended precision; lengths in units of `scale` (2n,), for the step's error."""

    rhs: Rhs
    scale: Vector
    how: str = "extrapolated midpoint steps of order 14 in extended precision, on equations apart from the generator's"
    own: float = 1e-14

    def rows(self, start: Vector, times: Vector, level: int) -> Vector:
        columns, tolerance = ((7, 1e-13), (5, 1e-12), (5, 1e-9))[level]
        elapsed = np.abs(times - times[0])
        rows = trajectory(_scaled(self, times), start / self.scale, elapsed, tolerance, columns)
        return np.asarray(rows * self.scale, dtype=np.float64)


@dataclass(frozen=True)
class Collocated:
    """Radau IIA steps of order 9 on a graded mesh, for motions with strongly damped parts."""

    rhs: Rhs
    scale: Vector
    how: str = (
        "Radau IIA collocation of order 9 on a graded mesh, residuals in extended precision, on equations apart from "
        "the generator's"
    )
    own: float = 1e-14

    def rows(self, start: Vector, times: Vector, level: int) -> Vector:
        per_decade = (16, 11, 7)[level]
        elapsed = np.abs(times - times[0])
        rows = collocated(_scaled(self, times), start / self.scale, elapsed, per_decade)
        return np.asarray(rows * self.scale, dtype=np.float64)


def _scaled(truth: Integrated | Collocated, times: Vector) -> Rhs:
    """Return the right-hand side in elapsed time and units of `scale`."""
    scale, begin = truth.scale.astype(np.longdouble), np.longdouble(times[0])
    way = -1 if times[-1] < times[0] else 1
    return lambda elapsed, z: way * truth.rhs(begin + way * elapsed, z * scale) / scale


@cache
def _equations(model: Model) -> Classical:
    return classical(model)


def lagrange(model: Model, parameters: Mapping[str, float]) -> Rhs:
    """Return f(t, y) of the classical equations in extended precision, with these values over the model's."""
    equations = _equations(model)
    constants = tuple((symbol, parameters.get(str(symbol), value)) for symbol, value in equations.constants)
    return extended(replace(equations, constants=constants))


def oscillation(a: float, b: float, w: float, t: Vector) -> tuple[Vector, Vector]:
    """Return a cos(w t) + b / w sin(w t) and its rate."""
    c, s = np.cos(w * t), np.sin(w * t)
    return a * c + b / w * s, b * c - a * w * s


def chain(masses: Vector, lengths: Vector, g: float) -> Rhs:
    """Return f(t, y) of a hanging chain written down by hand: sums of masses below, differences of angles.

    sum_j mu_ij l_i l_j (cos(a_i - a_j) a_j'' + sin(a_i - a_j) a_j'^2) + mu_ii l_i g sin a_i = 0,
    mu_ij the mass below link max(i, j).
    """
    n = len(masses)
    below, l = np.cumsum(masses[::-1].astype(np.longdouble))[::-1], lengths.astype(np.longdouble)
    shared = below[np.maximum.outer(np.arange(n), np.arange(n))] * np.outer(l, l)
    weight = below * l * np.longdouble(g)

    def rhs(time: Any, y: Extended) -> Extended:  # noqa: ARG001, nothing depends on it
        angle, rate = y[:n], y[n:]
        apart = angle[:, None] - angle[None, :]
        force = -(shared * np.sin(apart)) @ rate**2 - weight * np.sin(angle)
        return np.concatenate([rate, _solved(shared * np.cos(apart), force)])

    return rhs


def _solved(M: Extended, force: Extended) -> Extended:
    """Return M^-1 force for a positive definite M, in whatever precision: Gauss without pivots."""
    a, b, n = M.copy(), force.copy(), len(force)
    for k in range(n - 1):
        factors = a[k + 1 :, k] / a[k, k]
        a[k + 1 :, k + 1 :] -= np.outer(factors, a[k, k + 1 :])
        b[k + 1 :] -= factors * b[k]
    for k in reversed(range(n)):
        b[k] = (b[k] - a[k, k + 1 :] @ b[k + 1 :]) / a[k, k]
    return np.asarray(b)
