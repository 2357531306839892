"""Events of a model along a run of an implicit method, located to rounding on its interpolants."""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from scipy.optimize import brentq

from .names import Vector
from .options import Task

Function = Callable[[float], Vector]


@dataclass(slots=True)
class Watch:
    """What crossed zero so far.

    The rules are those of compiled runs (em_events.h): an event fires where g changes sign or reaches zero between
    two accepted states, in the direction of the run; a zero at the start does not fire.

    t, z : for each event the times and states (x, v) (2 n,) at which it fired
    g : (n_events,) at the last accepted state
    """

    task: Task
    t: list[list[float]] = field(default_factory=list)
    z: list[list[Vector]] = field(default_factory=list)
    g: Vector = field(default_factory=lambda: np.empty(0))

    def start(self, t: float, z: Vector, u: Vector) -> None:
        """Judge g at the start of a run."""
        self.t, self.z = [[] for _ in self.task.model.events], [[] for _ in self.task.model.events]
        self.g = self.values(t, z, u)

    def values(self, t: float, z: Vector, u: Vector) -> Vector:
        """Return g (n_events,), on the constraints where the run's rows are."""
        model, c, n = self.task.model, self.task.prepared, self.task.model.n
        x, v = z[:n], z[n:]
        if self.task.project and model.m:
            x, v = model.project(t, x, v, c, self.task.least_norm)
        rows = [np.ascontiguousarray(row)[None] for row in (x, v, u)]
        values: Vector = model.event_rows(np.array([t]), rows[0], rows[1], rows[2], c)[0]
        return values

    def step(
        self, start: float, end: float, z_end: Vector, between: Callable[[], Function], u: Function
    ) -> float | None:
        """Record the crossings of one step; return the time of the first terminal one, if there is any.

        Parameters
        ----------
        between
            Makes the interpolant of the step; called where something crosses.
        u
            The inputs within the step.
        """
        before, self.g = self.g, self.values(end, z_end, u(end))
        crossed = [k for k, (direction, _) in enumerate(self.task.model.event_kinds)
                   if _crosses(direction, before[k], self.g[k])]  # fmt: skip
        if not crossed:
            return None
        inside = between()
        found = [(self._root(k, (start, before[k]), (end, self.g[k]), inside, u), k) for k in crossed]
        for t, k in sorted(found, reverse=end < start):
            self.t[k].append(t)
            self.z[k].append(z_end if t == end else inside(t))
            if self.task.model.event_kinds[k][1]:
                return t
        return None

    def _root(self, k: int, a: tuple[float, float], b: tuple[float, float], z: Function, u: Function) -> float:
        ends = dict([a, b])  # at the start of a step a held input may have jumped since g was judged there

        def g(t: float) -> float:
            return ends[t] if t in ends else float(self.values(t, z(t), u(t))[k])

        return float(brentq(g, a[0], b[0], xtol=5e-324, rtol=4 * np.finfo(float).eps, maxiter=500))


def _crosses(direction: int, before: float, after: float) -> bool:
    up, down = before < 0 <= after, before > 0 >= after
    return (up and direction >= 0) or (down and direction <= 0)
