"""Events of a model along a run of an implicit method, located to rounding on its interpolants."""

from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from numpy.polynomial import Chebyshev
from numpy.polynomial.chebyshev import chebfit, chebval
from scipy.optimize import brentq, minimize_scalar

from ..arguments.names import Vector
from ..arguments.options import Task
from ..runtime import EvaluationError, StopReason, explain

Function = Callable[[float], Vector]
Scalar = Callable[[float], float]
Point = tuple[float, float]

_NODES: Vector = np.array(
    [0.5 - 0.5 * np.cos(np.pi * j / 8) for j in range(9)]
)  # of Chebyshev's polynomials, in [0, 1]
_CLOSER: Vector = np.array(
    [0.25**j for j in range(26, 2, -1)]
)  # places near the start of a run at which an event is zero
_GRID = np.linspace(0.0, 1.0, 129)
_PROBE = 0.38196601125010515
_MOST_HALVINGS = 10  # as em_events.h tries steps shorter by up to 4^5
_ULPS = 256 * np.finfo(float).eps
_OF_TOLERANCE = 1e-3
_AT_ONE_TIME = 8 * np.finfo(float).eps  # as EM_AT_ONE_TIME of em_record.h


@dataclass(slots=True)
class Watch:
    """What crossed zero so far.

    The rules are those of compiled runs (em_events.h): an event fires where g goes over from one sign to the other, in
    the direction of the run, or reaches zero at t_end. A zero at the start, to rounding, takes its sign from what
    follows; one that g touches and turns back from does not fire.

    t, z : for each event the times and states (x, v) (2 n,) at which it fired
    side : (n_events,) the last sign of g, 0 where it has been zero so far
    noise, zero : (n_events,) what g is known to at the start by rounding, and by a part of the tolerances
    quiet : (n_events,) beyond which a g that was zero at the start is so no longer
    after : as z, the states after events that act
    fired : (n_events,) whether an event that acts has just happened; ends : whether a terminal one has
    jumped : (n_events,) whether g begins anew with the leg: it is zero, then, or what it is
    """

    task: Task
    t: list[list[float]] = field(default_factory=list)
    z: list[list[Vector]] = field(default_factory=list)
    side: Vector = field(default_factory=lambda: np.empty(0))
    noise: Vector = field(default_factory=lambda: np.empty(0))
    zero: Vector = field(default_factory=lambda: np.empty(0))
    quiet: Vector = field(default_factory=lambda: np.empty(0))
    started: bool = False
    after: list[list[Vector]] = field(default_factory=list)
    fired: Vector = field(default_factory=lambda: np.empty(0, dtype=bool))
    jumped: Vector = field(default_factory=lambda: np.empty(0, dtype=bool))
    ends: bool = False

    def start(self, t: float, z: Vector, u: Vector) -> None:
        """Judge g at the start of a run: what it changes by with the last places of the time and of each number of z.

        Raises
        ------
        EvaluationError
            An event has no value there; names it.
        """
        model = self.task.model
        self.t, self.z, self.after = [[] for _ in model.events], [[] for _ in model.events], [[] for _ in model.events]
        self.side, self.jumped = np.zeros(len(model.events)), np.zeros(len(model.events), dtype=bool)
        self.fired = self.jumped
        if model.events:
            self._judge(t, z, u)

    def go_on(self, task: Task, t: float, z: Vector, u: Vector, fired: Vector, jumped: Vector) -> None:
        """Begin anew after the events `fired`, which made z of the state; `jumped` are those whose g jumps then."""
        self.task, self.jumped, self.started = task, jumped, False
        for k in np.flatnonzero(fired):
            self.after[k].append(z)
        self._judge(t, z, u)

    def _judge(self, t: float, z: Vector, u: Vector) -> None:
        model, n = self.task.model, self.task.model.n
        g = self.values(t, z, u)
        last = _ULPS * np.abs(z)
        more = last + _OF_TOLERANCE * (np.tile(self.task.atol, 2) + self.task.rtol * np.abs(z))
        moved = np.vstack([z + np.diag(more), z])
        with np.errstate(all="ignore"):
            later = _ULPS * abs(t) * model.motion_rate(t, z, self.task.prepared, u, self.task.least_norm)
            moved[-1] += np.where(np.isfinite(later), later, 0.0)
        times = np.append(np.full(2 * n, t), t + _ULPS * abs(t))
        x, v = np.ascontiguousarray(moved[:, :n]), np.ascontiguousarray(moved[:, n:])
        around = model.event_rows(times, x, v, np.tile(u, (2 * n + 1, 1)), self.task.prepared)
        changes = np.nan_to_num(np.abs(around - g))
        self.zero = changes.sum(axis=0)
        self.noise = np.append(last / np.maximum(more, np.finfo(float).tiny), 1.0) @ changes

    def values(self, t: float, z: Vector, u: Vector) -> Vector:
        """Return g (n_events,), on the constraints where the run's rows are.

        Raises
        ------
        EvaluationError
            An event has no value there; names it.
        """
        model, c, n = self.task.model, self.task.prepared, self.task.model.n
        x, v = z[:n], z[n:]
        if self.task.stabilise and model.m:
            x, v = model.project(t, x, v, c, self.task.least_norm)
        rows = [np.ascontiguousarray(row)[None] for row in (x, v, u)]
        values: Vector = model.event_rows(np.array([t]), rows[0], rows[1], rows[2], c)[0]
        if np.isnan(values).any():
            stop, first = StopReason.EVENT_UNDEFINED, int(np.isnan(values).argmax())
            raise EvaluationError(explain(stop, model.coordinates, first, events=model.events), stop)
        return values

    def step(self, start: float, end: float, z: Function, u: Function, halvings: int = 0) -> float | None:
        """Record the crossings of one step; return the time of the first terminal one, if there is any.

        A step of which nine nodes tell nothing of g is looked at in halves.

        Parameters
        ----------
        z
            The interpolant of the step.
        u
            The inputs within the step.
        halvings
            How often the step was halved already.

        Raises
        ------
        EvaluationError
            An event has no value in the step, before a terminal one.
        """
        times: Vector = start + _NODES * (end - start)
        times[-1] = end
        times, g, undefined = self._survey(times, z, u)
        if halvings < _MOST_HALVINGS and undefined is None and self._is_wild(g, start + _PROBE * (end - start), z, u):
            middle = 0.5 * (start + end)
            stop = self.step(start, middle, z, u, halvings + 1)
            return self.step(middle, end, z, u, halvings + 1) if stop is None else stop
        if len(g) and not self.started:
            self._start_sides(g)
        leaves = (self.side == 0) & (np.abs(g) > self.quiet).any(axis=0)
        if leaves.any() and undefined is None:
            near: Vector = start + _CLOSER * (end - start)
            near, closer, _ = self._survey(near, z, u)
            times, g = np.insert(times, 1, near), np.insert(g, 1, closer, axis=0)
        found = sorted(self._crossings(times, g, z, u), key=lambda crossing: abs(crossing[0] - start))
        stop = self._record(found, z)
        if stop is None and undefined is not None:
            raise undefined
        return stop

    def _survey(self, times: Vector, z: Function, u: Function) -> tuple[Vector, Vector, EvaluationError | None]:
        """Return the times and g (k, n_events) there, up to where an event has no value any longer, and which."""
        rows: list[Vector] = []
        try:
            rows.extend(self.values(t, z(t), u(t)) for t in times)
        except EvaluationError as error:
            if not rows:
                raise
            last, row = self._last_defined(times[len(rows) - 1], times[len(rows)], z, u)
            found = times[: len(rows)] if row is None else np.append(times[: len(rows)], last)
            return found, np.array(rows if row is None else [*rows, row]), error
        return times, np.array(rows), None

    def _is_wild(self, g: Vector, probe: float, z: Function, u: Function) -> bool:
        """Whether nine nodes tell nothing of an event, g (9, n_events): as em_is_wild of em_events.h."""
        if not np.isfinite(g).all():
            return False
        coefficients = chebfit(2 * _NODES - 1, g, len(_NODES) - 1)
        sizes, tail = np.abs(coefficients).sum(axis=0), np.abs(coefficients[-3:]).sum(axis=0)
        with suppress(EvaluationError):
            off = np.abs(chebval(2 * _PROBE - 1, coefficients) - self.values(probe, z(probe), u(probe)))
            return bool((np.maximum(tail, off) > 0.02 * sizes).any())
        return True

    def _last_defined(self, start: float, end: float, z: Function, u: Function) -> tuple[float, Vector | None]:
        """Return the last time at which every event has a value, which they have at start and not at end, and g."""
        g = None
        while (middle := 0.5 * (start + end)) not in (start, end):
            try:
                start, g = middle, self.values(middle, z(middle), u(middle))
            except EvaluationError:
                end = middle
        return start, g

    def _start_sides(self, g: Vector) -> None:
        """Which of g are zero at the start, to rounding beside what follows or a part of the tolerances."""
        largest = np.max(np.where(np.isfinite(g), np.abs(g), 0.0), axis=0)
        rounding = self.noise + _ULPS * largest
        anew = np.sign(g[0]) * (np.abs(g[0]) > np.maximum(rounding, self.zero))
        seen = np.sign(g[0]) * (np.abs(g[0]) > rounding)
        kept = np.where(seen != 0, seen, self.side)
        self.side = np.where(self.jumped, anew, kept) if self.jumped.any() else anew
        self.quiet, self.started = rounding + 4 * np.abs(g[0]), True

    def _crossings(self, times: Vector, g: Vector, z: Function, u: Function) -> Iterator[tuple[float, int]]:
        """Yield the time and the number of what passes zero between the first and the last of some times."""
        model = self.task.model
        for k, ((direction, _), (_, keeps_apart)) in enumerate(zip(model.event_kinds, model.deeds, strict=True)):

            def at(t: float, k: int = k) -> float:
                return float(self.values(t, z(t), u(t))[k])

            points = list(zip(times.tolist(), g[:, k].tolist(), strict=True))
            before = points[0] if points else (0.0, 0.0)
            rests = before[1] == 0
            for here in self._with_dips(points, at):
                sign = np.sign(here[1]) * (self.side[k] != 0 or abs(here[1]) > self.quiet[k])
                enters = self.side[k] == 0 and keeps_apart and np.sign(here[1]) == direction
                if enters and sign:
                    yield _root(at, before, here) if before[1] * here[1] < 0 else before[0], k
                last = here[0] == self.task.t_end and here[1] == 0 and not rests
                passes = self.side[k] != 0 and (sign == -self.side[k] or last)
                if passes and direction in (0, -self.side[k]):
                    yield _root(at, before, here), k
                self.side[k] = sign or self.side[k]
                before, rests = (here, False) if here[1] != 0 and not enters else (before, here[1] == 0)

    def _with_dips(self, points: list[Point], g: Scalar) -> list[Point]:
        """Return the points and, between two of one sign, a place where g has the other one, if there is any."""
        if len(points) < len(_NODES):
            return points
        nodes = [points[0], *points[len(points) - len(_NODES) + 1 :]]
        start, end = nodes[0][0], nodes[-1][0]
        values = np.array([value for _, value in nodes])
        if not np.isfinite(values).all():
            return points
        polynomial = Chebyshev.fit(_NODES, values, len(_NODES) - 1, domain=[0.0, 1.0])
        size, p = np.abs(polynomial.coef).sum(), polynomial(_GRID)
        dips = []
        for (left, a), (right, b) in pairwise(zip(_NODES, values, strict=True)):
            inside = (left < _GRID) & (right > _GRID)
            low = np.sign(a) * p[inside]
            if a * b <= 0 or not low.min() < min(abs(a), abs(b), 0.05 * size):
                continue
            dips.append(_lowest(g, np.sign(a), (start, end), (left, _GRID[inside][low.argmin()], right)))
        found = [(t, value) for t, value, side in dips if side * value < 0]
        return sorted([*points, *found], reverse=end < start)

    def _record(self, found: list[tuple[float, int]], z: Function) -> float | None:
        """Keep the crossings up to the first that is terminal or acts, and what else happens then; return its time."""
        model, stop = self.task.model, None
        self.fired, self.ends = np.zeros(len(model.events), dtype=bool), False
        for t, k in found:
            at_once = stop is not None and self.fired.any() and abs(t - stop) <= _AT_ONE_TIME * abs(stop)
            if (stop is not None and t != stop and not at_once) or self.fired[k]:
                break
            (_, terminal), (acts, _) = model.event_kinds[k], model.deeds[k]
            if stop is None and (terminal or acts):
                stop = t
            self.t[k].append(t if stop is None else stop)
            self.z[k].append(z(self.t[k][-1]))
            self.fired[k], self.ends = acts, self.ends or terminal
        return stop


def _lowest(
    g: Scalar, side: float, step: tuple[float, float], place: tuple[float, float, float]
) -> tuple[float, float, float]:
    """Return the time at which side * g is least near a place in a step, g there, and the side."""
    start, end = step
    left, middle, right = place
    width = 1 / len(_GRID)
    bounds = max(left, middle - width), min(right, middle + width)
    best = minimize_scalar(
        lambda theta: side * g(start + theta * (end - start)), bounds=bounds, method="bounded", options={"xatol": 1e-9}
    )
    return start + float(best.x) * (end - start), side * float(best.fun), side


def _root(g: Scalar, a: Point, b: Point) -> float:
    ends = dict([a, b])  # at the start of a step a held input may have jumped since g was judged there
    for t, value in ends.items():
        if value == 0 or a[0] == b[0]:
            return t
    inside: Scalar = lambda t: ends[t] if t in ends else g(t)  # noqa: E731
    return float(brentq(inside, a[0], b[0], xtol=5e-324, rtol=4 * np.finfo(float).eps, maxiter=500))
