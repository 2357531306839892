"""References of a user's model: independent equations, or else two tight runs of this tool."""

import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from itertools import count
from typing import Any

import numpy as np

from ...arguments.named_values import Vector
from ...building.build import build
from ...codegen.model import Model
from ...comparison.deadline import NONE, Deadline, TooLateError
from ...comparison.tight_runs import tight_rows
from ...reference.collocation import Collocation
from ...reference.extended_precision import Extended, Rhs
from ...reference.integration import Midpoint, NotReachedError, Scheme, integrate_adaptive
from ...reference.motion import rates_of
from ...results.solution import Solution
from ...simulation.simulate import simulate
from ...system.system import System
from ..evaluation.contact_outputs import with_contact_outputs
from ..expectation.truth import FINE, FINE_RUN, ROUGH_RUN, Integrated

MOST_COORDINATES = 10
"""of models for which plain SymPy derives equations in a moment"""
_DECAYS = 1e4  # e-foldings of the fastest decay in the span beyond which stability would limit explicit steps
_FINE, _QUICK = ((7, 1e-14), (5, 1e-13), (5, 1e-9)), ((6, 1e-12), (5, 1e-11), (4, 1e-8))
"""Columns and tolerances of extrapolated steps, by level"""
_EVERY = 20  # evaluations between two readings of the clock
_MOST_STEPS = 200_000
_METHODS = (("dop853", "radau9"), ("radau9", "dop853"), ("dop853", "radau9"))  # by level, in order of preference
_TIGHT = (FINE_RUN, FINE_RUN, ROUGH_RUN)  # tolerances by level


@dataclass(frozen=True)
class Independent(Integrated):
    """Extrapolation, or collocation if parts are strongly damped, in extended precision.

    until : reading of `time.process_time` at which it gives up
    deadline : at which it gives up, too
    fine : whether it is to judge runs with tolerances below 1e-8
    """

    until: float = np.inf
    deadline: Deadline = NONE
    fine: bool = True

    def _integrated(self, rhs: Rhs, z: Vector, elapsed: Vector, level: int) -> Extended:
        try:
            scheme, tolerance = _scheme(rhs, z, float(elapsed[-1]), level, self.fine)
            return integrate_adaptive(scheme, self._timed(rhs), z, elapsed, tolerance)
        except (ArithmeticError, ValueError, TypeError, NameError, np.linalg.LinAlgError) as error:
            raise NotReachedError(f"{error}") from error

    def _timed(self, rhs: Rhs) -> Rhs:
        calls = count()

        def timed(now: Any, z: Extended) -> Extended:
            if next(calls) % _EVERY == 0 and (time.process_time() > self.until or self.deadline.left < 0):
                raise NotReachedError("the reference in extended precision takes too long")
            return rhs(now, z)

        return timed


def _scheme(rhs: Rhs, z: Vector, span: float, level: int, fine: bool) -> tuple[Scheme, float]:
    """Return the steps and their tolerance; those that are not fine are for runs at tolerances of 1e-8 and looser."""
    rates = rates_of(rhs, np.zeros(1), np.asarray(z, dtype=np.float64)[None])
    if -rates.real.min() * span < _DECAYS:
        columns, tolerance = (_FINE if fine else _QUICK)[level]
        return Midpoint(columns), tolerance
    stages, tolerance = ((5, 1e-13), (4, 1e-12), (4, 1e-10))[level]
    return Collocation(stages, rounding=1e-15), tolerance


@cache
def system_of(model: Model, formulation: str) -> System:
    """Return the model in one formulation, with the outputs that checks of contacts need; built, or from the cache."""
    return build(with_contact_outputs(model), formulation=formulation)


@dataclass(frozen=True)
class TightRuns:
    """Two tight runs of this tool, by two formulations and two methods: agreement with them is no proof."""

    model: Model
    formulations: tuple[str, ...]
    parameters: Mapping[str, float]
    inputs: Mapping[str, Any]
    units: Vector
    why: str
    deadline: Deadline = NONE
    own: float = 1e-13
    independent: bool = field(default=False, init=False)

    @property
    def how(self) -> str:
        """Description, with the reason why there is no independent reference."""
        first, second = self.formulations[0], self.formulations[-1]
        return (
            f"no independent reference ({self.why}): {first} with {_METHODS[0][0]} and {second} with "
            f"{_METHODS[1][0]} at {_TIGHT[FINE]:g}, whose difference is the error given"
        )

    def rows(self, start: Vector, times: Vector, level: int) -> Vector:
        """Return the rows of a tight run.

        Raises
        ------
        NotReachedError
            No method reaches the end.
        """
        system = system_of(self.model, self.formulations[-1 if level == 1 else 0])
        tolerance = _TIGHT[level]
        given = {"parameters": self.parameters, "inputs": self.inputs, "atol": tolerance * self.units}

        def run(**more: Any) -> Solution:
            return self.deadline.complete(lambda steps: simulate(**more, max_steps=steps), _MOST_STEPS)

        try:
            return tight_rows(system, _METHODS[level], start, times, tolerance, run, **given)[0]
        except TooLateError:
            raise NotReachedError(f"{self.why}; and two tight runs do not end in time") from None
        except NotReachedError as error:
            raise NotReachedError(f"{self.why}; and two tight runs do not reach the end: {error}") from error
