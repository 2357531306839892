"""Curve of cycles."""

from dataclasses import dataclass, replace

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from ..cycles.multipliers import multipliers_of
from ..cycles.newton import Search, equations, extent_of, noise, on_section, still
from ..cycles.periodic_problem import Problem
from ..cycles.returns import NoReturnError, Return, returned
from ..cycles.time_dependence import event_at_start, unrepeated
from .curve import Meeting, NoPointError, Sample, Spectrum
from .meetings import acting, changed, meeting_of, near_meeting

_SMALLEST = 0.03
"""Least unit, relative to the first cycle's."""


@dataclass(frozen=True)
class CycleCurve:
    """Cycles along a parameter, the last of what `by` of the search's problem names. extent : its interval's length.

    A place w has the state, the period, the other names of `by`, and the parameter.
    """

    search: Search
    first: Return
    extent: float

    def at(self, w: Vector) -> Sample:
        """Return the motion from a place, and the equations that close it."""
        problem, (q, period) = self.problem(w), self.parts(w)
        section, period = self.search.section, problem.period(period)
        if not period > 0.0:
            raise NoPointError("the period shrinks to zero")
        try:
            q = on_section(problem, section, problem.projected(q, problem.prepared), period)
            here = returned(problem, section, q, period)
        except NoReturnError as error:
            meets = self._meets_event(problem, q, period)
            raise NoPointError(meets or str(error)) from error
        if failure := still(problem, here, self.first, extent_of(problem, self.first, self.first.scale)):
            raise NoPointError(failure)
        return self._sample(here, w)

    def parts(self, w: Vector) -> tuple[Vector, float]:
        """Return the state (2 n,) and the period of a place."""
        every = len(self.first.q)
        return w[:every], float(w[every])

    def problem(self, w: Vector) -> Problem:
        """Return the problem at a place."""
        problem = self.search.problem
        return problem.with_values(problem.by, w[len(self.first.q) + 1 :])

    def _sample(self, here: Return, w: Vector) -> Sample:
        sizes = (*self.search.unknowns.sizes, self.extent)
        linear = equations(self.search, here, self.first.q, sizes)
        changes, every = linear.changes, len(here.q)
        E = np.vstack([changes.q, changes.period, changes.values])
        w = np.concatenate([here.q, [here.period], w[every + 1 :]])
        unit = np.concatenate([np.maximum(here.scale, _SMALLEST * self.first.scale), [here.period], sizes])
        return Sample(w, unit, E, -linear.right, linear.J, noise(here.problem, here), here)

    def spectrum(self, sample: Sample) -> Spectrum:
        """Return the multipliers."""
        found = multipliers_of(sample.detail.problem, sample.detail)
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
        if changed(a, b, self.search.section.event):
            if meets := self._meets_event(b.problem, b.q, b.period):
                return meets
            names = problem.c.events
            orders = " to ".join(", ".join(names[k] for k in one) or "none" for one in (acting(a), acting(b)))
            return f"the order of events in a period changes there, from {orders}"
        own = problem.own
        if (a.flow / a.scale)[own] @ (b.flow / a.scale)[own] < 0.0:
            return "the cycle shrinks to an equilibrium there"
        return ""

    def meeting(self, before: Sample, after: Sample | None) -> Meeting | None:
        """Return the single change of the order of events between two points, or the one that is near, or None.

        An event that moves onto the start is none.
        """
        a, section = before.detail, self.search.section.event
        if after is None:
            return None if self._meets_event(a.problem, a.q, a.period) else near_meeting(a, section)
        b = after.detail
        if not changed(a, b, section) or self._meets_event(b.problem, b.q, b.period):
            return None
        return meeting_of(a, b, section)

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
        problem = sample.detail.problem
        if failure := unrepeated(problem, self.search.section, sample.detail):
            remedy = "Give find_cycle the period as an expression of parameters, such as period='2*pi/w'"
            if not problem.clock:
                remedy = "At the start, nothing depended on time. Begin where the forcing acts, and give its period"
            raise ModelError(f"{problem.c.name}: at {problem.by[-1]} = {sample.parameter:.9g}, {failure}. {remedy}")


def curve_of(search: Search, q: Vector, period: float, by: str, extent: float) -> CycleCurve:
    """Return the curve through a cycle, over an interval of a parameter."""
    problem = replace(search.problem, by=(*search.unknowns.names, by))
    first = returned(problem, search.section, q, period)
    return CycleCurve(replace(search, problem=problem), first, extent)
