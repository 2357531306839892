"""Places of a branch where the order of events in a period changes, or the contact mode: how they are reached."""

from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise

import numpy as np

from ...arguments.named_values import Vector
from ...results.solution import Solution
from ..cycles.returns import Return, run
from ..state.active_contacts import Switch, holding, switches_of
from ..state.contact_bounds import Bounds
from .curve import CORNER, GRAZING, Curve, Meeting, NoPointError, Place, place, point

_NEAR = 1e-9
"""Distance in units at which such a place counts as reached."""
_POINTS, _PART, _SURE = 4, 0.7, 1e-7
"""Number of points from which the place is extrapolated, the part of the way of a step, the largest error, in units."""
_ACCURATE = 1e-11
_BESIDE = 1e-5
"""Distance in units at which the branch is looked for on the other side."""
_PROBE = 1e-3
_ROUNDS, _FARTHEST, _WALK = 60, 0.02, 0.2
"""Most steps to such a place, the largest one, and the longest way, in units."""
_ABOUT = 1e-5
"""Part of the period, or of an expression's changes, below which something is about to happen."""
_SHORT = 0.1
"""Longest rest, as a part of the period, that may be one that has just begun."""
_BESIDE_SECTION = 0.02
"""Part of a period within which an event is near the section."""
_ELSEWHERE = "so cycles beyond start elsewhere: call find_cycle with another section"
_ANOTHER = "so cycles beyond start elsewhere: call find_cycle at another t, or from another state of the motion"
_NOT_SMOOTH = "where derivatives of the motion jump or are not finite"
_WINDOW, _ROWS = 0.05, 401
"""Part of a period around a moment in which an event is looked at, and at how many times."""


def acting(one: Return) -> tuple[int, ...]:
    """Return the numbers of the events that act in a motion, in order; a motion is smooth at the others."""
    return tuple(k for k in one.order if one.problem.c.acting[k])


def changed(before: Return, after: Return, section: int | None) -> bool:
    """Return whether the order of events is another one, or one has moved past the event where motions start."""
    if acting(before) != acting(after):
        return True
    pairs = zip(_phases(before), _phases(after), strict=True)
    return section is not None and any(abs(a - b) > 0.5 for a, b in pairs)


def meeting_of(before: Return, after: Return, section: int | None) -> Meeting | None:
    """Return the change between two motions if it is a single one, else None; section : the event where they start."""
    if not changed(before, after, section):
        return None
    if section is not None and (meeting := _onto_section(before, section)):
        return meeting
    first, second, names = acting(before), acting(after), before.problem.c.events
    if first == second:
        return None
    more, less = Counter(second) - Counter(first), Counter(first) - Counter(second)
    longer, shorter = (second, first) if more else (first, second)
    k = next(k for k, (a, b) in enumerate(zip(longer, (*shorter, -1), strict=False)) if a != b)
    if more and less:
        return None
    if more or less:
        event = min(more or less)
        friction = next(
            (one for one in switches_of(before.problem.c) if one.event == event and not one.is_contact), None
        )
        if friction is not None:
            return _sticking(before, after, friction, bool(more))
        value = _nearest(event, _moments(after)[k] / after.period) if more else _speed(event, k)
        words = f"grazing: event {names[event]!r} begins or ceases to happen"
        return Meeting(GRAZING, (names[event],), words, _NOT_SMOOTH, _in_order(first), value)
    swaps = [k for k, (a, b) in enumerate(zip(first, second, strict=True)) if a != b]
    if len(swaps) != 2 or swaps[1] != k + 1:
        return None
    both = names[first[k]], names[first[k + 1]]
    words = f"events {both[0]!r} and {both[1]!r} happen at once"
    return Meeting(CORNER, both, words, "", _in_order(first), _gap(k))


def _sticking(before: Return, after: Return, friction: Switch, more: bool) -> Meeting | None:
    """Return that a friction begins or ceases to stick for a while where its slip is zero, or None."""
    pairs = [(_apart(one, k), k) for one in [after if more else before] for k in range(len(acting(one)) - 1)
             if acting(one)[k] == acting(one)[k + 1] == friction.event]  # fmt: skip
    if not pairs or min(pairs)[0] > _SHORT:
        return None
    k, name = min(pairs)[1], before.problem.c.events[friction.event]
    phase = _phases(after if more else before)[k]
    value = _excess(friction, phase) if more else _gap(k)
    words = f"friction {name!r} {'begins' if more else 'ceases'} to stick"
    return Meeting(CORNER, (name,), words, "", _in_order(acting(before)), value)


def _excess(friction: Switch, phase: float) -> Callable[[Return], float]:
    """Return the function of the force that a friction would need to stick at a moment, beyond its limit."""

    def excess(one: Return) -> float:
        solution, row = _at_moment(one, friction.event, phase * one.period)
        q, at = one.problem.rows(solution)[row], float(solution.t[row])
        bounds = Bounds(holding(one.problem.point(q, at, one.problem.in_mode(solution, at)), [friction]))
        return -bounds.margins[friction] / bounds.size

    return excess


def _at_moment(one: Return, event: int, moment: float) -> tuple[Solution, int]:
    """Return the motion and its row at an event, before this acts, nearest to a moment after the start."""
    solution = run(one.problem, one.q, one.problem.t + one.period)
    times = solution.t_events[event]
    at = float(times[np.abs(times - one.problem.t - moment).argmin()])
    return solution, int(np.flatnonzero(solution.t == at)[0])


def near_meeting(one: Return, section: int | None) -> Meeting | None:
    """Return what is about to happen to the order of events of a motion, or None if nothing is near."""
    if meeting := _onto_section(one, section):
        return meeting
    order, names = acting(one), one.problem.c.events
    found: list[tuple[float, Meeting]] = []
    for k in range(len(order) - 1):
        both = names[order[k]], names[order[k + 1]]
        words = f"events {both[0]!r} and {both[1]!r} happen at once"
        found.append((_apart(one, k), Meeting(CORNER, both, words, "", _in_order(order), _gap(k))))
    for event, acts in enumerate(one.problem.c.acting):
        if acts:
            part, distance = _touched(one, event)
            words = f"grazing: event {names[event]!r} begins to happen"
            found.append((distance, Meeting(GRAZING, (names[event],), words, _NOT_SMOOTH, _in_order(order),
                                            _nearest(event, part))))  # fmt: skip
    nearest = min(found, key=lambda each: each[0], default=None)
    return nearest[1] if nearest is not None and nearest[0] <= _ABOUT else None


def _touched(one: Return, event: int) -> tuple[float, float]:
    """Return where an event is nearest to happening between those that act, as a part of the period, and how near."""
    best = (0.5, np.inf)
    for a, b in pairwise([0.0, *_moments(one), one.period]):
        edge = 1e-3 * (b - a)
        times = np.linspace(a + edge, b - edge, _ROWS)
        rows = np.abs(_along(one, event, times))
        for k in np.flatnonzero((rows[1:-1] <= rows[:-2]) & (rows[1:-1] <= rows[2:])) + 1:
            bend = abs(rows[k - 1] - 2.0 * rows[k] + rows[k + 1])
            if rows[k] - bend < best[1] * np.ptp(rows):
                part = float(times[k] / one.period)
                best = part, _nearest(event, part)(one)
    return best


def _gap(k: int) -> Callable[[Return], float]:
    return lambda one: _apart(one, k)


def _in_order(order: tuple[int, ...]) -> Callable[[Return], bool]:
    return lambda one: acting(one) == order


def _onto_section(one: Return, section: int | None) -> Meeting | None:
    """Return that an event moves onto the start of motions, an event or not, if one is near, or None."""
    phases, order, names = _phases(one), acting(one), one.problem.c.events
    distances = [min(phase, 1.0 - phase) for phase in phases]
    if not distances or min(distances) > _BESIDE_SECTION:
        return None
    k = int(np.argmin(distances))
    late = phases[k] > 0.5

    def before(other: Return) -> bool:
        return acting(other) == order and (_phases(other)[k] > 0.5) == late

    def value(other: Return) -> float:
        return 1.0 - _phases(other)[k] if late else _phases(other)[k]

    if section is None:
        words = f"event {names[order[k]]!r} moves onto the start of the period"
        return Meeting(CORNER, (names[order[k]],), words, _ANOTHER, before, value)
    words = f"event {names[order[k]]!r} moves onto the section, event {names[section]!r},"
    return Meeting(CORNER, (names[order[k]], names[section]), words, _ELSEWHERE, before, value)


def _phases(one: Return) -> list[float]:
    """Return when the events that act happen, as parts of the period."""
    return [t / one.period for t in _moments(one)]


def _moments(one: Return) -> list[float]:
    return [t for t, k in zip(one.moments, one.order, strict=True) if one.problem.c.acting[k]]


def _apart(one: Return, k: int) -> float:
    """Return the time between two events, as a part of the period."""
    moments = _moments(one)
    return (moments[k + 1] - moments[k]) / one.period


def _values(one: Return, event: int, times: Vector, rows: Vector) -> Vector:
    """Return the values of an event's expression at states (rows, 2 n)."""
    problem, n = one.problem, one.problem.c.n
    u = np.array([problem.signals(t) for t in times]).reshape(len(times), -1)
    x, v = np.ascontiguousarray(rows[:, :n]), np.ascontiguousarray(rows[:, n:])
    return np.asarray(problem.c.event_rows(times, x, v, u, problem.prepared)[:, event])


def _along(one: Return, event: int, times: Vector) -> Vector:
    """Return the values of an event's expression at times after the start."""
    solution = run(one.problem, one.q, one.problem.t + float(times[-1]), t_eval=one.problem.t + times)
    return _values(one, event, solution.t, one.problem.rows(solution))


def _nearest(event: int, part: float) -> Callable[[Return], float]:
    """Return the function of the distance of an event that does not happen: the extremum near a part of the period."""

    def distance(one: Return) -> float:
        moments = [0.0, *_moments(one), one.period]
        low, high = next((a, b) for a, b in pairwise(moments) if a <= part * one.period <= b)
        begin, end = max(low, (part - _WINDOW) * one.period), min(high, (part + _WINDOW) * one.period)
        edge = 1e-6 * one.period  # beside the events, where the motion jumps
        times = np.linspace(begin + edge, end - edge, _ROWS)
        rows = np.abs(_along(one, event, times))
        lows = np.flatnonzero((rows[1:-1] <= rows[:-2]) & (rows[1:-1] <= rows[2:])) + 1
        k = int(lows[rows[lows].argmin()]) if len(lows) else int(rows.argmin())
        k = min(max(k, 2), len(rows) - 3)
        fit = np.polynomial.Polynomial.fit(times[k - 2 : k + 3], rows[k - 2 : k + 3], 4)
        return float(fit(np.linspace(times[k - 2], times[k + 2], _ROWS)).min() / np.ptp(rows))

    return distance


def _speed(event: int, k: int) -> Callable[[Return], float]:
    """Return the function of the speed with which an event, the k-th that acts, begins, in its changes per period."""

    def speed(one: Return) -> float:
        problem = one.problem
        solution, row = _at_moment(one, event, _moments(one)[k])
        at = float(solution.t[row])
        q, small = problem.rows(solution)[row], 1e-6 * one.period
        flow = problem.flow(q, at, problem.in_mode(solution, float(solution.t[row - 1])))
        there = np.array([q - small * flow, q + small * flow])
        values = _values(one, event, np.array([at - small, at + small]), there)
        whole = _values(one, event, solution.t, problem.rows(solution))
        return float(abs(values[1] - values[0]) / (2.0 * small) * one.period / np.ptp(whole))

    return speed


def reached(curve: Curve, here: Place, meeting: Meeting) -> tuple[Place, Vector] | None:
    """Return the last point of a branch before its order of events changes, and w at the change; None if not reached.

    The change is where points, as polynomials of the value, have the value 0: before a contact that grazes, derivatives
    grow without bound, and points nearer to it are less accurate.
    """
    last, value, h = here, meeting.value(here.sample.detail), _PROBE
    values, points, best, walked = [value], [here.sample.w], (np.inf, here.sample.w), 0.0
    for _ in range(_ROUNDS):
        there = _step(curve, last, h) if h > _NEAR else None
        if there is None or not meeting.before(there.sample.detail):
            h *= 0.3
            if h > _NEAR:
                continue
            break
        after = meeting.value(there.sample.detail)
        slope = (after - value) / h
        last, value = there, after
        values.append(value)
        points.append(there.sample.w)
        best = min(best, _extrapolated(values, points, there.sample.unit), key=lambda one: one[0])
        walked += h
        if walked > _WALK:
            return None
        left = -value / slope if slope < 0.0 else np.inf
        ahead = there.sample.w + left * there.tangent * there.sample.unit
        best = min(best, (left, ahead), key=lambda one: one[0])
        if left <= _NEAR:
            break
        h = min(_PART * left, 4.0 * h, _FARTHEST)
    return (last, best[1]) if best[0] <= _SURE else None


def _extrapolated(values: list[float], points: list[Vector], unit: Vector) -> tuple[float, Vector]:
    """Return an estimate of the error of w at the value 0, in units, and w: by the last points, as Neville does."""
    v, rows = values[-_POINTS:], points[-_POINTS:]
    estimates = [rows[-1]]
    for order in range(1, len(rows)):
        rows = [(v[k] * rows[k + 1] - v[k + order] * rows[k]) / (v[k] - v[k + order]) for k in range(len(rows) - 1)]
        estimates.append(rows[-1])
    if len(estimates) < _POINTS:
        return np.inf, estimates[-1]
    return float(np.linalg.norm((estimates[-1] - estimates[-2]) / unit)), estimates[-1]


def _step(curve: Curve, last: Place, h: float) -> Place | None:
    unit = last.sample.unit
    w = last.sample.w + h * last.tangent * unit
    try:
        return point(curve, w, last.tangent * unit, (last.tangent / unit, w), _ACCURATE)
    except NoPointError:
        return None


def beyond(curve: Curve, last: Place, corner: Vector, meeting: Meeting) -> tuple[Place | None, str]:
    """Return the first point on the other side of a corner, or None and why there is none."""
    unit = last.sample.unit
    try:
        probe = curve.at(corner + _BESIDE * last.tangent * unit)
    except NoPointError as error:
        return None, str(error)
    if meeting.before(probe.detail):
        return None, "no motion with the other order is found"
    if float(np.abs(probe.F).max()) > 100.0 * _BESIDE:
        return None, "which is first makes a difference to the motion after them"
    along = place(probe, last.tangent * unit).tangent
    for side in (1.0, -1.0):
        turned = replace(last, sample=replace(last.sample, w=corner), tangent=side * along)
        near, far = (_step(curve, turned, h) for h in (_BESIDE, 2.0 * _BESIDE))
        if near is None or far is None or meeting.before(near.sample.detail):
            continue
        back = 2.0 * near.sample.w - far.sample.w
        if float(np.linalg.norm((back - corner) / unit)) <= 0.1 * _BESIDE:
            return near, ""
    return None, "no motion of the branch is found on the other side"
