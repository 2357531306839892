"""Curve of cycles."""

from dataclasses import dataclass, replace

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from ..cycles.multipliers import multipliers_of
from ..cycles.newton import Search, equations, extent_of, noise, on_section, phases, still
from ..cycles.periodic_problem import Problem
from ..cycles.returns import NoReturnError, Return, returned
from ..cycles.time_dependence import event_at_start, unrepeated
from .curve import NoPointError, Sample, Spectrum

_SMALLEST = 0.03
"""Least unit, relative to the first cycle's."""


@dataclass(frozen=True)
class CycleCurve:
    """Cycles along a parameter, the `by` of the search's problem. extent : its interval's length."""

    search: Search
    first: Return
    extent: float

    def at(self, w: Vector) -> Sample:
        """Return the motion from a place, and the equations that close it."""
        problem, section = self.problem(float(w[-1])), self.search.section
        period = float(w[-2])
        if problem.clock and problem.stated_period is not None:
            period = problem.stated_period.value(problem.c, problem.prepared)
        if not period > 0.0:
            raise NoPointError("the period shrinks to zero")
        try:
            q = on_section(problem, section, problem.projected(w[:-2], problem.prepared), period)
            here = returned(problem, section, q, period)
        except NoReturnError as error:
            meets = self._meets_event(problem, w[:-2], period)
            raise NoPointError(meets or str(error)) from error
        if failure := still(problem, here, self.first, extent_of(problem, self.first, self.first.scale)):
            raise NoPointError(failure)
        return self._sample(problem, here, float(w[-1]))

    def problem(self, value: float) -> Problem:
        """Return the problem at a value of the parameter."""
        return self.search.problem.with_value(self.search.problem.by, value)

    def _sample(self, problem: Problem, here: Return, value: float) -> Sample:
        section, unknowns, shift = self.search.section, self.search.unknowns, here.shift
        assert shift is not None
        J, right = equations(problem, section, unknowns, here, self.first.q)
        closing = (shift.end - problem.symmetry.G @ shift.start) / here.scale
        column = [closing[problem.own], phases(problem, section, unknowns, here, shift.start[:, None])[:, 0]]
        w = np.concatenate([here.q, [here.period, value]])
        unit = np.concatenate([np.maximum(here.scale, _SMALLEST * self.first.scale), [here.period, self.extent]])
        Z = here.basis.Z * here.scale[list(here.basis.free)]
        E = np.zeros((len(w), len(J.T) + 1))
        E[:-2, : len(Z.T)], E[-2, : len(Z.T)] = Z, here.dt * here.scale[list(here.basis.free)]
        E[-2, len(Z.T) : -1] = here.period  # the column of the period, if it is unknown
        E[:, -1] = self.extent * np.concatenate([shift.start, [shift.period, 1.0]])
        J = np.column_stack([J, self.extent * np.concatenate(column)])
        return Sample(w, unit, E, -right, J, noise(problem, here), here)

    def spectrum(self, sample: Sample) -> Spectrum:
        """Return the multipliers."""
        found = multipliers_of(self.problem(sample.parameter), sample.detail)
        return Spectrum(found.values, found.errors, found.stable)

    def obstacle(self, before: Sample, after: Sample) -> str:
        """Return that a cycle has shrunk to an equilibrium between two points, or that its events change, or "".

        Raises
        ------
        ModelError
            The motion closes, but the forcing is another one in the next period.
        """
        a, b, problem = before.detail, after.detail, self.search.problem
        self._check_repeats(after)
        if a.order != b.order:
            if meets := self._meets_event(self.problem(after.parameter), b.q, b.period):
                return meets
            names = problem.c.events
            orders = " to ".join(", ".join(names[k] for k in one) or "none" for one in (a.order, b.order))
            return f"the order of events in a period changes there, from {orders}"
        own = problem.own
        if (a.flow / a.scale)[own] @ (b.flow / a.scale)[own] < 0.0:
            return "the cycle shrinks to an equilibrium there"
        return ""

    def _meets_event(self, problem: Problem, q: Vector, period: float) -> str:
        """Return that an event that acts has moved onto the start of the period, or ""."""
        if self.search.section.event is not None:
            return ""
        event = event_at_start(problem, q, period)
        if event is None:
            return ""
        other = "at another t" if problem.clock else "from another state of the motion"
        name = problem.c.events[event]
        return f"event {name!r} moves onto the start of the period there. Begin elsewhere: call find_cycle {other}"

    def _check_repeats(self, sample: Sample) -> None:
        problem = self.problem(sample.parameter)
        if failure := unrepeated(problem, self.search.section, sample.detail):
            remedy = "Give find_cycle the period as an expression of parameters, such as period='2*pi/w'"
            if not problem.clock:
                remedy = "At the start, nothing depended on time. Begin where the forcing acts, and give its period"
            raise ModelError(f"{problem.c.name}: at {problem.by} = {sample.parameter:.9g}, {failure}. {remedy}")


def curve_of(search: Search, q: Vector, period: float, by: str, extent: float) -> CycleCurve:
    """Return the curve through a cycle, over an interval of a parameter."""
    problem = replace(search.problem, by=by)
    first = returned(problem, search.section, q, period)
    return CycleCurve(replace(search, problem=problem), first, extent)
