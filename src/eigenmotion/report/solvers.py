"""Solvers of a report: a common interface for ours and those of peers."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arguments import methods
from ..arguments.named_values import Vector
from ..comparison.interrupts import uninterrupted
from ..reference.motion import positions, rows_of
from ..results.solution import Solution
from ..simulation.simulate import simulate
from ..system.system import System

METHODS = {name: method.order for name, method in methods.METHODS.items() if not method.implicit}
"""Explicit methods -> order."""
IMPLICIT = tuple(methods.IMPLICIT)
OURS = "eigenmotion"
OUR_TOLERANCES = tuple(float(10.0 ** (-k / 2)) for k in range(6, 28))  # 1e-3, 3e-4, ... 3e-14
IMPLICIT_TOLERANCES = tuple(float(10.0**-k) for k in range(3, 14))
MOST_STEPS = 1_000_000
_PLAIN = "lagrange"


@dataclass(frozen=True, slots=True)
class Track:
    """The rows of a run at requested times, as far as it got.

    x : (k, n + p) coordinates and first-order states; v : (k, n); counts are None if a solver does not have them
    message : why the run ended early, or ""
    """

    x: Vector
    v: Vector
    nfev: int | None
    nsteps: int | None
    nrejected: int | None = None
    factor_residual: float | None = None
    message: str = ""


def track_of(rows: Vector, n: int, **counts: Any) -> Track:
    """Return the track of rows (k, 2n + p) of (x, v, z)."""
    return Track(positions(rows, n), rows[:, n : 2 * n], **counts)


@dataclass(frozen=True, slots=True)
class Attempt:
    """A solver that is set up for one tolerance.

    run : integrates over the complete span; this is timed
    track : returns the rows at given times, from the times and the result of `run`; this is not timed
    """

    run: Callable[[], Any]
    track: Callable[[Vector, Any], Track]


@dataclass(frozen=True, slots=True)
class Solver:
    """A solver for the model; `tolerances`, absolute and relative, from loose to tight."""

    family: str
    formulation: str
    method: str
    tolerances: tuple[float, ...]
    attempt: Callable[[float], Attempt]

    @property
    def label(self) -> str:
        """The label in two words."""
        return f"{self.formulation if self.family == OURS else self.family} {self.method}"


@dataclass(frozen=True, slots=True)
class Problem:
    """The span and the arguments parameters, inputs, x0, v0 of all runs by `simulate`."""

    t_end: float
    settings: Mapping[str, Mapping[str, float]]

    def simulate(self, system: System, method: str, tolerance: float, t_eval: Vector | None = None) -> Solution:
        """Run one method at one tolerance."""
        given: dict[str, Any] = {**self.settings, "max_steps": MOST_STEPS}
        return uninterrupted(
            simulate(system, (0.0, self.t_end), method=method, rtol=tolerance, atol=tolerance, t_eval=t_eval, **given)
        )


def explicit_solvers(system: System, problem: Problem, tolerances: tuple[float, ...]) -> list[Solver]:
    """Return every explicit method for one formulation."""
    return [_solver(system, problem, method, tolerances) for method in METHODS]


def implicit_solvers(systems: Sequence[System], problem: Problem) -> list[Solver]:
    """Return every implicit method, for one formulation.

    They integrate (x, v) with a compiled Jacobian in every formulation, which only adds other numbers to the rows.
    "lagrange" adds none, so that its rows are the fastest.
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
    """Return the rows of one run, with the last row and the counts of the timed run, whose steps are longer."""
    rows = rows_of(at_rows)
    rows[-1:] = rows_of(at_steps)[-1:]
    factors = at_rows.factor_residual if system.formulation == "eigenfactor" else np.empty(0)
    return track_of(
        rows,
        system.n,
        nfev=at_steps.nfev,
        nsteps=at_steps.nsteps,
        nrejected=at_steps.nrejected,
        factor_residual=float(factors.max()) if factors.size else None,
        message="" if at_rows.status == 0 else at_rows.message,
    )
