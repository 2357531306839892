"""A case: a mechanism driven to its limits by a parameter."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np

from ...arguments.named_values import Vector
from ...arguments.signals import Signal
from ...codegen.model import Model
from ...comparison.deadline import NONE, Deadline
from ...reference.extended_precision import Rhs
from ..expectation.truth import Integrated, Truth
from .variants import UNCONSTRAINED, Variant

EXPLICIT = {"rk34": 1e-7, "dopri5": 1e-8, "dop853": 1e-8, "ra15": 1e-8}
STIFF = {"radau5": 1e-7, "radau9": 1e-8}
TOLERANCES: Mapping[str, float] = MappingProxyType(EXPLICIT | STIFF)


@dataclass(frozen=True)
class Trial:
    """The run at one value of a case's parameter.

    Attributes
    ----------
    label : the value as text
    parameters : over the model's defaults
    x0, v0, z0 : (n,), (n,), (p,) start; z are first-order states
    units : (n + p,) size of a small coordinate or state; atol is tolerance x units, also for velocities
    times : (k,) of the rows that are compared; the run goes from `start` to the last
    truth : the motion that the rows are compared with
    conserves : whether T2 - T0 + V is constant
    turns : (n,) period of a coordinate that is an angle, 0: not periodic; None: no coordinate may wind
    periods : number of periods in the span; 0 if they are few or have no meaning
    inputs : over the model's defaults
    nearby : whether perturbed starts are possible, to measure kappa (they are not if the motion begins in contact)
    tolerance : of all methods, in place of those of the case
    otherwise : what to compare with if `truth` is not reached, from the reason; None: a run that succeeds is wrong
    rotations : coordinates of each rotation that a run may turn to its other set of parameters
    deadline : of its runs
    may_lose_digits : whether runs are not judged where perturbations grow to the size of the motion
    """

    label: str
    parameters: Mapping[str, float]
    x0: Vector
    v0: Vector
    units: Vector
    start: float
    times: Vector
    truth: Truth
    conserves: bool = True
    turns: Vector | None = None
    periods: float = 0.0
    inputs: Mapping[str, Signal | float] = field(default_factory=dict)
    nearby: bool = True
    tolerance: float | None = None
    otherwise: Callable[[str], Truth] | None = None
    may_lose_digits: bool = False
    z0: Vector = field(default_factory=lambda: np.zeros(0))
    rotations: tuple[tuple[int, ...], ...] = ()
    deadline: Deadline = NONE

    @property
    def row(self) -> Vector:
        """The start (2n + p,): x0, v0, z0."""
        return np.concatenate([self.x0, self.v0, self.z0])

    @property
    def sizes(self) -> Vector:
        """The units (2n + p,) of the numbers of a row."""
        return spread(self.units, len(self.x0))


@dataclass(frozen=True)
class Case:
    """A family of trials of one model.

    Attributes
    ----------
    axis : name of the swept value, with its unit
    values : arguments of `trial` and `model`
    reduced : values of the quick check
    tolerances : method -> tolerance
    max_steps : accepted steps after which a run ends
    flags : C compiler flags after ours
    weight : expected cost of a value; the longest runs begin first
    growth : relative growth of that cost with the value
    """

    name: str
    title: str
    about: str
    axis: str
    values: tuple[float, ...]
    model: Callable[[float], Model]
    trial: Callable[[float], Trial]
    reduced: tuple[float, ...] = ()
    variants: tuple[Variant, ...] = UNCONSTRAINED
    tolerances: Mapping[str, float] = field(default_factory=lambda: TOLERANCES)
    max_steps: int = 200_000
    flags: str | None = None
    weight: float = 1.0
    growth: float = 0.0

    def cost(self, value: float) -> float:
        """Return the expected cost of a value."""
        return self.weight * (1 + self.growth * value)


def power(value: float) -> str:
    """Return a value as text, as a power of ten if it is one."""
    if value == 0:
        return "0"
    exponent = np.log10(value)
    return f"1e{exponent:.0f}" if abs(exponent - round(exponent)) < 1e-9 else f"{value:g}"


def start_of(model: Model) -> tuple[Vector, Vector]:
    """Return the model's own x0, v0 (n,)."""
    return np.array(model.initial_x), np.array(model.initial_v)


def spread(units: Vector, n: int) -> Vector:
    """Return the units (2n + p,) of rows (x, v, z), from those of n coordinates and p states."""
    return np.concatenate([units[:n], units])


def scale_of(units: Vector, x0: Vector, v0: Vector) -> Vector:
    """Return the scale (2n,) of the step error of a reference."""
    return np.concatenate([units + np.abs(x0), units + np.abs(v0)])


def rows(start: float, end: float, count: int = 40) -> Vector:
    """Return the times of `count` rows, the last at the end, none at the start; one row if start and end are equal."""
    return np.linspace(start, end, count + 1)[1:] if start != end else np.array([end])


def integrated(
    label: str, rhs: Rhs, parameters: Mapping[str, float], x0: Vector, v0: Vector, units: Vector, times: Vector,
    start: float = 0.0,
) -> Trial:  # fmt: skip
    """Return a trial whose motion is integrated in extended precision."""
    return Trial(label, parameters, x0, v0, units, start, times, Integrated(rhs, scale_of(units, x0, v0)))
