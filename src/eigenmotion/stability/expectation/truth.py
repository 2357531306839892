"""Reference motions: closed forms, or independent integration in extended precision."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Protocol

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model import Model
from ...codegen.model.symbolic.lagrange import Lagrange
from ...reference.collocation import Collocation
from ...reference.extended_precision import Extended, Rhs, extended
from ...reference.integration import Midpoint, integrate_adaptive, integrate_graded
from ...reference.lagrange_equations import classical

FINE, CHECK, ROUGH = range(3)  # levels of accuracy: for the comparison; to estimate its error; to about 1e-9
FINE_RUN, ROUGH_RUN = 1e-12, 1e-10  # tolerances of the first two, and of the last, of runs of this tool


class Truth(Protocol):
    """Rows (k, 2n) of x, v at times (k,) for a start (2n,) at the first of the times."""

    @property
    def how(self) -> str:
        """Description of the reference."""

    @property
    def own(self) -> float:
        """Error by rounding, which the difference of two levels does not show."""

    @property
    def independent(self) -> bool:
        """Whether it shares no code with the runs that are compared with it."""

    def rows(self, start: Vector, times: Vector, level: int) -> Vector:
        """Return the rows at a level of accuracy."""


@dataclass(frozen=True)
class ClosedForm:
    """function(start (2n,), elapsed (k,)) -> (k, 2n)."""

    function: Callable[[Vector, Vector], Vector]
    how: str
    own: float = 1e-12
    independent: bool = True

    def rows(self, start: Vector, times: Vector, level: int) -> Vector:  # noqa: ARG002, the same at all levels
        return self.function(start, times - times[0])


@dataclass(frozen=True)
class Integrated:
    """Extrapolated midpoint steps in extended precision; `scale` (2n,) is the unit of the step error."""

    rhs: Rhs
    scale: Vector
    how: str = "extrapolated midpoint steps of order 14 in extended precision, on equations apart from the generator's"
    own: float = 1e-14
    independent: bool = True

    def rows(self, start: Vector, times: Vector, level: int) -> Vector:
        values = self._integrated(_scaled(self, times), start / self.scale, np.abs(times - times[0]), level)
        return np.asarray(values * self.scale, dtype=np.float64)

    def _integrated(self, rhs: Rhs, z: Vector, elapsed: Vector, level: int) -> Extended:
        columns, tolerance = ((7, 1e-13), (5, 1e-12), (5, 1e-9))[level]
        return integrate_adaptive(Midpoint(columns), rhs, z, elapsed, tolerance)


@dataclass(frozen=True)
class Collocated(Integrated):
    """Radau IIA steps of order 9 on a graded mesh, for motions with strongly damped parts."""

    how: str = (
        "Radau IIA collocation of order 9 on a graded mesh, residuals in extended precision, on equations apart from "
        "the generator's"
    )

    def _integrated(self, rhs: Rhs, z: Vector, elapsed: Vector, level: int) -> Extended:
        return integrate_graded(Collocation(5, rounding=1e-15), rhs, z, elapsed, (16, 11, 7)[level])


def _scaled(truth: Integrated, times: Vector) -> Rhs:
    """Return the right-hand side in elapsed time and units of `scale`."""
    scale, begin = truth.scale.astype(np.longdouble), np.longdouble(times[0])
    way = -1 if times[-1] < times[0] else 1
    return lambda elapsed, z: way * truth.rhs(begin + way * elapsed, z * scale) / scale


@cache
def _equations(model: Model) -> Lagrange:
    return classical(model)


def lagrange(model: Model, parameters: Mapping[str, float]) -> Rhs:
    """Return f(t, y) of the classical equations in extended precision, with these values over the model's."""
    return extended(_equations(model).with_values(parameters))
