"""Cycle: a periodic motion with its multipliers."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ...arguments.named_values import Vector
from ...compiled.compiled_system import CompiledSystem
from ...results.solution import Solution
from .newton import Search


@dataclass(frozen=True)
class Cycle:
    """A periodic motion of a mechanism, or the best approximation of one.

    Attributes
    ----------
    success, message : whether the motion closes, and what was found, or why nothing was
    t : start [s]; it matters only if the equations depend on time
    period : [s]
    x0, v0 : name -> value of coordinates and states, and of rates: the start, for `simulate`
    multipliers : (k,) complex, Floquet's, the largest first: factors of deviations in one period. Those of a shift
        along the motion, of free advances, and of constraints are left out
    multiplier_error : (k,) estimated errors
    stable : True: deviations decay; False: some grow; None: the largest multiplier is 1 within its error
    neutral : number of multipliers that are 1 within their errors: the cycle is one of a family, or at a bifurcation
    advance : name -> change in one period, of coordinates on which nothing depends
    closes : the distance between the end and the start of another run with a tenth of the tolerance, relative to the
        motion
    events : names of the events in one period, in order
    solution : the motion over one period, with dense output
    runs : number of runs
    parameters : all values by name
    free : name -> value of the parameters and inputs that were among the unknowns, and of "t"
    search : the equations that it solves, for `follow`

    Examples
    --------
    >>> import eigenmotion as em
    >>> system = em.build("models/rimless_wheel.py")
    >>> cycle = em.find_cycle(system, x0={"theta": -0.3}, v0={"theta": 1.2}, section="step")
    >>> print(cycle)
    rimless_wheel: period 1.03455 s, stable
    multipliers: 0.5
    """

    system: CompiledSystem
    success: bool
    message: str
    t: float
    period: float
    x0: dict[str, float]
    v0: dict[str, float]
    multipliers: NDArray[np.complex128]
    multiplier_error: Vector
    stable: bool | None
    neutral: int
    advance: dict[str, float]
    closes: float
    events: tuple[str, ...]
    solution: Solution | None
    runs: int
    parameters: dict[str, float]
    free: dict[str, float] = field(default_factory=dict)
    search: Search | None = None

    def __str__(self) -> str:
        if not self.success:
            return f"{self.system.name}: {self.message}"
        lines = [f"{self.system.name}: period {self.period:.6g} s, {self.message}"]
        lines += [f"{name} = {value:.9g}" for name, value in self.free.items()]
        lines.append(f"multipliers: {', '.join(map(_text, self.multipliers, self.multiplier_error))}")
        lines += [f"advance of {name}: {value:.6g}" for name, value in self.advance.items()]
        return "\n".join(lines)

    def __repr__(self) -> str:
        return f"<Cycle {self})>".replace("\n", "; ").replace(")>", ">")


def _text(value: complex, error: float) -> str:
    """Return a multiplier as text; 0 within its error is 0."""
    if abs(value) <= error:
        return "0"
    if not value.imag:
        return f"{value.real + 0.0:.6g}"
    return f"{value.real:.6g} {'+' if value.imag > 0 else '-'} {abs(value.imag):.6g} i"
