"""What is measured: one record for ours and for peers alike."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..names import Vector
from ..simulate import simulate
from ..solution import Solution
from ..system import System

METHODS = {"rk34": 4, "dopri5": 5, "dop853": 8}  # compiled ones, with the order that error falls with
OURS = "eigenmotion"
OUR_TOLERANCES = tuple(float(10.0 ** (-k / 2)) for k in range(6, 28))  # 1e-3, 3e-4, ... 3e-14


@dataclass(frozen=True, slots=True)
class Motion:
    """A run seen at the rows asked for, as many as were reached.

    x, v : (k, n); counts are None where a solver does not tell or has no such thing
    message : why the run ended early, or ""
    """

    x: Vector
    v: Vector
    nfev: int | None
    nsteps: int | None
    nrejected: int | None = None
    factor_residual: float | None = None
    message: str = ""


@dataclass(frozen=True, slots=True)
class Attempt:
    """A solver at one tolerance, ready to go.

    run : integrates once, over the whole span, and is what the clock sees
    motion : the rows at given times, off the clock
    """

    run: Callable[[], object]
    motion: Callable[[Vector], Motion]


@dataclass(frozen=True, slots=True)
class Solver:
    """A way to integrate the model; `tolerances` from loose to tight, for absolute and relative error alike."""

    family: str
    formulation: str
    method: str
    tolerances: tuple[float, ...]
    attempt: Callable[[float], Attempt]

    @property
    def label(self) -> str:
        """Say who and how, in two words."""
        return f"{self.formulation if self.family == OURS else self.family} {self.method}"


def our_solvers(system: System, t_end: float, tolerances: tuple[float, ...]) -> list[Solver]:
    """Every compiled method on one formulation."""

    def solver(method: str) -> Solver:
        return Solver(
            OURS, system.formulation, method, tolerances, lambda tolerance: _attempt(system, t_end, method, tolerance)
        )

    return [solver(method) for method in METHODS]


def _attempt(system: System, t_end: float, method: str, tolerance: float) -> Attempt:
    def run(t_eval: Vector | None = None) -> Solution:
        return simulate(system, (0.0, t_end), method=method, rtol=tolerance, atol=tolerance, t_eval=t_eval)

    return Attempt(run, lambda times: _motion(system, run(times), run()))


def _motion(system: System, at_rows: Solution, at_steps: Solution) -> Motion:
    """Rows of one run, counts of the other: interpolation costs right-hand sides that a plain run does not need."""
    factors = at_rows.factor_residual if system.formulation == "eigenfactor" else np.empty(0)
    return Motion(
        at_rows.x.T,
        at_rows.v.T,
        nfev=at_steps.nfev,
        nsteps=at_steps.nsteps,
        nrejected=at_steps.nrejected,
        factor_residual=float(factors.max()) if factors.size else None,
        message="" if at_rows.status == 0 else at_rows.message,
    )
