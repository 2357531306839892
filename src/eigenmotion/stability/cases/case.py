"""A case: a mechanism driven to its limits by a parameter."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np

from ...arguments.named_values import Vector
from ...arguments.signals import Signal
from ...codegen.model import Model
from ...reference.extended_precision import Rhs
from ..expectation.truth import Integrated, Truth
from .variants import UNCONSTRAINED, Variant

EXPLICIT = {"rk34": 1e-7, "dopri5": 1e-8, "dop853": 1e-8, "ra15": 1e-8}
STIFF = {"radau5": 1e-7, "radau9": 1e-8}
TOLERANCES: Mapping[str, float] = MappingProxyType(EXPLICIT | STIFF)


@dataclass(frozen=True)
class Trial:
    """What is run at one value of a case's parameter.

    Attributes
    ----------
    label : the value in words
    parameters : over the model's defaults
    x0, v0 : (n,)
    units : (n,) size of a small coordinate: atol is tolerance x units, of the velocity as well
    times : (k,) rows that are compared; the run goes from `start` to the last
    truth : what they are compared with
    conserves : whether T2 - T0 + V is constant here
    turns : (n,) after which a coordinate is the same again, 0: never; None: no coordinate is an angle that may wind
    periods : how many the span holds, 0 where they are few or have no meaning
    inputs : over the model's defaults
    nearby : whether starts near this one are ones, by which kappa is measured: of what begins in contact they are not
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
    inputs: Mapping[str, Signal] = field(default_factory=dict)
    nearby: bool = True


@dataclass(frozen=True)
class Case:
    """A family of trials of one model.

    Attributes
    ----------
    axis : what is swept, with its unit
    values : what `trial` is called with, and `model` too
    reduced : those of the quick check
    tolerances : of the methods it is run with
    max_steps : accepted steps after which a run gives up
    flags : C compiler flags after ours
    weight : expected cost of a value, to begin with the longest
    growth : of that cost, relative to it, with the value
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
        """Return what a value is expected to cost."""
        return self.weight * (1 + self.growth * value)


def power(value: float) -> str:
    """Write a value of a sweep as a power of ten where it is one."""
    if value == 0:
        return "0"
    exponent = np.log10(value)
    return f"1e{exponent:.0f}" if abs(exponent - round(exponent)) < 1e-9 else f"{value:g}"


def start_of(model: Model) -> tuple[Vector, Vector]:
    """Return the model's own x0, v0 (n,)."""
    return np.array(model.initial_x), np.array(model.initial_v)


def scale_of(units: Vector, x0: Vector, v0: Vector) -> Vector:
    """Return (2n,) by which a reference measures its own steps."""
    return np.concatenate([units + np.abs(x0), units + np.abs(v0)])


def rows(start: float, end: float, count: int = 40) -> Vector:
    """Return the times of `count` rows, the last at the end and none at the start; where they are one, of one row."""
    return np.linspace(start, end, count + 1)[1:] if start != end else np.array([end])


def integrated(
    label: str, rhs: Rhs, parameters: Mapping[str, float], x0: Vector, v0: Vector, units: Vector, times: Vector,
    start: float = 0.0,
) -> Trial:  # fmt: skip
    """Return a trial whose truth is integrated in extended precision."""
    return Trial(label, parameters, x0, v0, units, start, times, Integrated(rhs, scale_of(units, x0, v0)))
