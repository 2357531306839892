"""Solvers that are measured: one record for ours and for peers alike."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arguments import methods
from ..arguments.named_values import Vector
from ..results.solution import Solution
from ..simulation.simulate import simulate
from ..system.system import System

METHODS = {name: method.order for name, method in methods.METHODS.items() if not method.implicit}
"""Explicit ones, with the order that error falls with."""
IMPLICIT = tuple(methods.IMPLICIT)
OURS = "eigenmotion"
OUR_TOLERANCES = tuple(float(10.0 ** (-k / 2)) for k in range(6, 28))  # 1e-3, 3e-4, ... 3e-14
IMPLICIT_TOLERANCES = tuple(float(10.0**-k) for k in range(3, 14))
MOST_STEPS = 1_000_000
_PLAIN = "lagrange"


@dataclass(frozen=True, slots=True)
class Track:
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
    track : the rows at given times, off the clock; it is handed what `run` returned
    """

    run: Callable[[], Any]
    track: Callable[[Vector, Any], Track]


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


@dataclass(frozen=True, slots=True)
class Problem:
    """What every run of ours is given: the span, and the arguments parameters, inputs, x0, v0 of `simulate`."""

    t_end: float
    settings: Mapping[str, Mapping[str, float]]

    def simulate(self, system: System, method: str, tolerance: float, t_eval: Vector | None = None) -> Solution:
        """Run one method at one tolerance."""
        given: dict[str, Any] = {**self.settings, "max_steps": MOST_STEPS}
        return simulate(
            system, (0.0, self.t_end), method=method, rtol=tolerance, atol=tolerance, t_eval=t_eval, **given
        )


def explicit_solvers(system: System, problem: Problem, tolerances: tuple[float, ...]) -> list[Solver]:
    """Every explicit method on one formulation."""
    return [_solver(system, problem, method, tolerances) for method in METHODS]


def implicit_solvers(systems: Sequence[System], problem: Problem) -> list[Solver]:
    """Every implicit method, once.

    They integrate (x, v) with a compiled Jacobian whatever the formulation, which only says what a row holds beside
    them: lagrange nothing, so that its rows are the quickest.
    """
    chosen = next((system for system in systems if system.formulation == _PLAIN), systems[0])
    return [_solver(chosen, problem, method, IMPLICIT_TOLERANCES) for method in IMPLICIT]


def _solver(system: System, problem: Problem, method: str, tolerances: tuple[float, ...]) -> Solver:
    return Solver(
        OURS, system.formulation, method, tolerances, lambda tolerance: _attempt(system, problem, method, tolerance)
    )


def _attempt(system: System, problem: Problem, method: str, tolerance: float) -> Attempt:
    def run(t_eval: Vector | None = None) -> Solution:
        return problem.simulate(system, method, tolerance, t_eval)

    return Attempt(run, lambda times, done: _track(system, run(times) if done.status == 0 else done, done))


def _track(system: System, at_rows: Solution, at_steps: Solution) -> Track:
    """Rows of one run; the end and counts of the other, which is timed: rows cost right-hand sides, shorter steps."""
    x, v = at_rows.x.T.copy(), at_rows.v.T.copy()
    x[-1:], v[-1:] = at_steps.x.T[-1:], at_steps.v.T[-1:]
    factors = at_rows.factor_residual if system.formulation == "eigenfactor" else np.empty(0)
    return Track(
        x,
        v,
        nfev=at_steps.nfev,
        nsteps=at_steps.nsteps,
        nrejected=at_steps.nrejected,
        factor_residual=float(factors.max()) if factors.size else None,
        message="" if at_rows.status == 0 else at_rows.message,
    )
