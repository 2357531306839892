"""Path along a curve by steps of arclength, with the special points on it."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np
from scipy.optimize import brentq

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from .curve import Curve, Meeting, NoPointError, Place, Spectrum, corrected, in_between, place, point
from .indicators import BRANCHING, FLUTTER, FOLD, HOPF, TORUS, Indicator, indicators, is_oscillation
from .meetings import beyond, reached

_FIRST, _LARGEST, _LEAST = 0.02, 0.2, 1e-7
"""First, largest and least step, in units."""
_TURN = 0.2
"""Largest angle between tangents at the ends of a step [rad]; half of it allows the next step to be larger."""
_FAMILY = 1e-8
"""Least singular value, relative to the largest, of an isolated branch."""
_SINGLE = 0.01
"""Largest step in which a change of the order of events is looked at."""
_COMPLETE = "complete"


@dataclass(frozen=True)
class Node:
    """A point of a path: its kind is "" unless it is special.

    events : names of those that meet there; at : the parameter where they do, None: that of the place
    """

    place: Place
    spectrum: Spectrum
    kind: str = ""
    events: tuple[str, ...] = ()
    at: float | None = None

    @property
    def parameter(self) -> float:
        """The parameter of what is special."""
        return self.place.sample.parameter if self.at is None else self.at


@dataclass
class Path:
    """Points in order, and why the path ends; complete : whether it has reached its goal.

    signs : kind -> the last sign of its indicator that was decided
    """

    nodes: list[Node] = field(default_factory=list)
    message: str = ""
    complete: bool = False
    signs: dict[str, int] = field(default_factory=dict)


def begun(curve: Curve, start: Vector, to: float) -> Place:
    """Return the first point of a path, with its tangent towards a value of the parameter.

    Raises
    ------
    NoPointError
        The start is not on the curve.
    ModelError
        It is one of a family.
    """
    sample = corrected(curve, start)[0]
    forward = np.zeros_like(start)
    forward[-1] = to - sample.parameter
    first = place(sample, forward)
    if first.smallest < _FAMILY:
        raise ModelError("the start is one of a family, or at a branch point, so there are several branches. Name what "
                         "is free, or start at another value")  # fmt: skip
    return first


def followed(curve: Curve, begin: tuple[Place, ...], ends: tuple[float, float], of_cycle: bool, max_steps: int) -> Path:
    """Return the path from a point until the parameter is at one of the ends, of which the first is the goal.

    begin : the first point, or a branch point and the first one beside it
    """
    path, functions = Path(), indicators(of_cycle)

    def restarted(at: Place) -> None:
        path.nodes.append(Node(at, curve.spectrum(at.sample)))
        path.signs = {kind: function(at, path.nodes[-1].spectrum).sign for kind, function in functions.items()}

    for one in begin:
        restarted(one)
    here, h = begin[-1], _FIRST
    for _ in range(max_steps):
        there, h, change = _stepped(curve, path, here, h)
        if there is None:
            return path
        there, over = _within(curve, (begin[0], here, there), *ends)
        try:
            _add(curve, path, Node(there, curve.spectrum(there.sample)), functions)
        except NoPointError as error:
            near = curve.meeting(there.sample, None)
            reason = f"{near.words}, {near.why}" if near and near.why else f"a special point is not located: {error}"
            path.message = _stuck(here, reason)
            return path
        if over:
            path.complete, path.message = over == _COMPLETE, over
            return path
        if change is not None:
            there = _met(curve, path, *change)
            if there is None:
                return path
            restarted(there)
        here = there
    path.message = f"{max_steps} steps were not enough, at {here.sample.parameter:.9g}; give max_steps"
    return path


def _met(curve: Curve, path: Path, meeting: Meeting, corner: Vector) -> Place | None:
    """Return the first point beyond a change of the order of events, after the last point; or None, with why not."""
    last, at = path.nodes[-1].place, float(corner[-1])
    path.nodes[-1] = replace(path.nodes[-1], kind=meeting.kind, events=meeting.names, at=at)
    if meeting.why:
        path.message = f"{meeting.words} at {at:.9g}, {meeting.why}"
        return None
    there, why = beyond(curve, last, corner, meeting)
    if there is None:
        path.message = f"{meeting.words} at {at:.9g}, and the branch ends: {why}"
    return there


def _stuck(here: Place, reason: str) -> str:
    return f"no step leads beyond {here.sample.parameter:.9g}: {reason}"


Change = tuple[Meeting, Vector]
"""A change of the order of events, or of the contact mode, and w where it is."""


def _stepped(curve: Curve, path: Path, here: Place, h: float) -> tuple[Place | None, float, Change | None]:
    """Return the next point, the size of the step after it, and what changes there; or None, the reason in the path."""
    reason, tried = "", False
    while h > _LEAST:
        meeting = None
        try:
            w = here.sample.w + h * here.tangent * here.sample.unit
            there = point(curve, w, here.tangent * here.sample.unit)
            reason = curve.obstacle(here.sample, there.sample) or _far(here, there, h)
            meeting = curve.meeting(here.sample, there.sample) if h <= _SINGLE and not tried else None
        except NoPointError as error:
            reason = str(error)
        if meeting is not None:
            tried = True
            if (found := reached(curve, here, meeting)) is not None:
                return found[0], _FIRST, (meeting, found[1])
        elif not reason:
            turn = _angle(here, there)
            easy = turn < 0.5 * _TURN and there.rounds <= 4
            return there, min(1.6 * h, _LARGEST) if easy else h, None
        h *= 0.5
    meeting = curve.meeting(here.sample, None)
    if meeting is not None and (found := reached(curve, here, meeting)) is not None:
        return found[0], _FIRST, (meeting, found[1])
    path.message = _stuck(here, f"{meeting.words}, {meeting.why}" if meeting and meeting.why else reason)
    return None, h, None


def _angle(here: Place, there: Place) -> float:
    along = there.tangent * there.sample.unit / here.sample.unit
    return float(np.arccos(np.clip(along @ here.tangent / np.linalg.norm(along), -1.0, 1.0)))


def _far(here: Place, there: Place, h: float) -> str:
    moved = (there.sample.w - here.sample.w) / here.sample.unit
    if not 0.3 * h < moved @ here.tangent < 2.0 * h:
        return "Newton's method leads elsewhere"
    return "the branch turns too sharply" if _angle(here, there) > _TURN else ""


def _within(curve: Curve, last: tuple[Place, Place, Place], to: float, back: float) -> tuple[Place, str]:
    """Return the point, moved back to the end of the interval if it is beyond it, and why the path ends, or ""."""
    first, here, there = last
    value, before = there.sample.parameter, here.sample.parameter
    if (value - to) * (before - to) <= 0.0:
        return _at_value(curve, here, there, to), _COMPLETE
    if (value - back) * (before - back) <= 0.0:
        return _at_value(curve, here, there, back), f"the branch turns back, and reaches {back:.6g}"
    away = [(one.sample.w - first.sample.w) / first.sample.unit for one in (here, there)]
    step = float(np.linalg.norm(away[1] - away[0]))
    passes = here is not first and away[0] @ first.tangent < 0.0 <= away[1] @ first.tangent
    if passes and np.linalg.norm(away[0]) < 1.1 * step and first.tangent @ there.tangent > 0.5:
        return first, "the branch is closed"
    return there, ""


def _at_value(curve: Curve, here: Place, there: Place, goal: float) -> Place:
    part = (goal - here.sample.parameter) / (there.sample.parameter - here.sample.parameter)
    w = in_between(curve, here, there)(part).sample.w.copy()
    w[-1] = goal
    normal = np.zeros_like(w)
    normal[-1] = 1.0 / here.sample.unit[-1]
    return point(curve, w, there.sample.w - here.sample.w, (normal, w), 1e-10)


Functions = dict[str, Callable[[Place, Spectrum], Indicator]]


def _add(curve: Curve, path: Path, node: Node, functions: Functions) -> None:
    """Append a point, and before it the special points between the last one and it."""
    last, found = path.nodes[-1], list[tuple[float, Node]]()
    for kind in _changed(path, last, node, functions):
        if functions[kind](last.place, last.spectrum).sign == 0:  # the last point is itself the special one
            found.append((0.0, Node(last.place, last.spectrum, kind)))
        elif (one := _located(curve, last.place, node.place, functions[kind], kind)) is not None:
            found.append(one)
    path.nodes += [each for _, each in sorted(found, key=lambda pair: pair[0])]
    path.nodes.append(node)


def _changed(path: Path, last: Node, node: Node, functions: Functions) -> list[str]:
    """Return the kinds whose indicators have changed their signs since they were last decided."""
    changes = []
    for kind, function in functions.items():
        before = path.signs.get(kind) or function(last.place, last.spectrum).sign
        after = function(node.place, node.spectrum).sign
        path.signs[kind] = after or before
        if before * after < 0:
            changes.append(kind)
    if FOLD in changes and BRANCHING in changes:
        changes.remove(BRANCHING)  # a fold is where a value is critical, too
    return changes


def _located(curve: Curve, first: Place, second: Place, function: Callable[[Place, Spectrum], Indicator], kind: str
             ) -> tuple[float, Node] | None:  # fmt: skip
    """Return the part of the step at which a function vanishes, and the point; None if it is not special."""
    at = in_between(curve, first, second)

    def value(s: float) -> float:
        here = first if s == 0.0 else second if s == 1.0 else at(s)
        return function(here, curve.spectrum(here.sample)).value

    s = float(brentq(value, 0.0, 1.0, xtol=1e-10, rtol=1e-14, maxiter=60))
    here = at(s)
    spectrum = curve.spectrum(here.sample)
    if kind in {FLUTTER, HOPF, TORUS} and not is_oscillation(kind, spectrum):
        return None
    return s, Node(here, spectrum, kind)
