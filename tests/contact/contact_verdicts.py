"""Verdict on a run of a case, by the oracle alone: right, wrong, refused where there is a motion, or named."""

from dataclasses import dataclass, replace
from enum import StrEnum
from itertools import pairwise
from typing import Any

import numpy as np

from eigenmotion import ModelError
from eigenmotion.runtime import EvaluationError

from ..oracles.contact_check import off
from ..oracles.contact_cones import solutions
from ..oracles.contact_impacts import STILL, After, struck
from ..oracles.contact_modes import Problem
from ..oracles.feet import Body, State, point, problem, strike, turned
from .contact_cases import Case
from .contact_models import Row, rows_of, simulated

SPAN = 1e-3
MOMENT = 1e-7
CLOSED = 1e-9
BEGINS = 1e-3
"""Relative, of accelerations where a cone begins to slide: rounding and shifts turn a slip as long as it is small."""
PIECES = 40
"""Steps at least where the directions of cones turn."""
SOON = (1e-13, 1e-12)
"""Later than times can tell apart, sooner than a gap opens: a motion that has reached its end goes no further."""
AGREES = 1e-6
"""Relative, of accelerations and velocities; runs are made at 1e-9."""


class Verdict(StrEnum):
    """Of one run."""

    RIGHT = "right"
    ONE_OF_SEVERAL = "one of several"
    NAMED = "none exists, and named"
    WRONG = "wrong"
    REFUSED = "refused where one motion exists"
    REFUSED_OF_SEVERAL = "refused where several exist"
    BLURRED = "not judged"


FATAL = (Verdict.WRONG, Verdict.REFUSED, Verdict.REFUSED_OF_SEVERAL)


@dataclass(frozen=True)
class Judged:
    """A verdict, and what it is about."""

    verdict: Verdict
    why: str = ""


@dataclass(frozen=True)
class Start:
    """What came of a start: rows `struck`, after its impacts, `settled`, a moment later, `later`, until a mode changes.

    None: `why` it was refused. What is apart by rounding is closed a moment later, and a slip that begins turns the way
    it goes on; velocities are those of the last impact, since accelerations change them in a moment, too.
    """

    struck: Row | None
    settled: Row | None = None
    later: tuple[Row, ...] = ()
    why: str = ""


def closed(body: Body, s: State, rate: float = np.inf) -> list[int]:
    """Contacts that are closed in a state and open no faster than `rate`."""
    points = [point(foot, s) for foot in body.feet]
    return [
        k for k, (foot, at) in enumerate(zip(body.feet, points, strict=True))
        if foot.presses and abs(at.gap) <= CLOSED and at.rate <= rate
    ]  # fmt: skip


def here(body: Body, s: State) -> Problem:
    """The problem of accelerations in a state in which nothing strikes."""
    slips = [point(foot, s).slip for foot in body.feet]
    moving = {k: slip for k, slip in enumerate(slips) if np.abs(slip).max(initial=0.0) > STILL}
    return problem(body, s, closed(body, s, STILL), moving)


def velocities(body: Body, s: State) -> After:
    """All velocities (6,) that a state may go on with."""
    after = struck(*strike(body, s, closed(body, s)))
    return replace(after, found=tuple(full(body, u) for u in after.found))


def full(body: Body, u: np.ndarray) -> np.ndarray:
    whole = np.zeros(6)
    whole[body.kept] = u
    return whole


def started(case: Case, formulation: str = "lagrange") -> Start:
    """Run a case for a short time; by a stiff method where that is what a run that ends too early asks for."""
    options = {"max_step": SPAN * case.units[2] / PIECES} if case.shape.cone else {}
    try:
        run = simulated(case, SPAN, formulation, **options)
        if "use a stiff method (radau9)" in run.message:
            run = simulated(case, SPAN, formulation, method="radau9", **options)
    except (ModelError, EvaluationError) as error:
        return Start(None, why=str(error))
    return of_run(case, run)


def of_run(case: Case, run: Any) -> Start:
    """Read a run."""
    rows, moment = rows_of(case, run), MOMENT * case.units[2]
    if run.t[-1] <= moment and not run.success:
        return Start(None, why=run.message)
    changes = np.array([run.t[0], *(t for t, _ in run.modes), *np.concatenate(run.t_events)])
    struck, settled, ends = (
        int(np.sum(run.t <= changes[changes <= moment].max())), int(np.sum(run.t <= moment)),
        int(np.sum(run.t < changes[changes > moment].min(initial=np.inf))),
    )  # fmt: skip
    later = tuple(rows[settled : ends + 1])
    return Start(rows[struck - 1], rows[settled - 1], later, "" if run.success else run.message)


def judged(case: Case, start: Start) -> Judged:
    """Return what a start is worth."""
    struck, now = start.struck, start.settled
    if struck is None or now is None:
        return of_refusal(case.body, case.state, start.why)
    after = velocities(case.body, case.state)
    if not any(close(struck.u, u) for u in after.found):
        if after.clear:
            return Judged(Verdict.WRONG, f"velocities {struck.u}, allowed {after.found}")
        return Judged(Verdict.BLURRED, "velocities")
    first = struck if case.shape.cone else now
    settles = (
        case.shape.cone and struck.t > 0.0
    )  # a slip within the tolerances goes to and fro: what it comes to counts
    why = "" if settles else wrong_at(case, first, begins=case.shape.cone)
    if why := why or wrong_later(case, start):
        stable = not case.shape.cone or solutions(here(case.body, state_of(first))).stable
        return Judged(Verdict.WRONG if stable else Verdict.BLURRED, why)
    alone = after.clear and len(after.found) == 1
    return Judged(Verdict.RIGHT if alone else Verdict.ONE_OF_SEVERAL, start.why)


def wrong_at(case: Case, row: Row, *, begins: bool) -> str:
    """Say what is wrong with the accelerations of a row."""
    one = here(case.body, state_of(row))
    missed = off(one, row.a[case.body.kept])
    if missed <= (BEGINS if begins else AGREES) * size_of(one, row.a):
        return ""
    return f"accelerations {row.a[case.body.kept]}, off by {missed:.2g}; {allowed(one)}"


def wrong_later(case: Case, start: Start) -> str:
    """Say what is wrong afterwards, until a mode changes."""
    if not follows(start):
        return "velocities do not follow the accelerations"
    middle = len(start.later) // 2
    return wrong_at(case, start.later[middle], begins=True) if case.shape.cone and middle else ""


def follows(start: Start) -> bool:
    """Whether velocities have changed by what was said of accelerations, step by step, until a mode changes."""
    rows = [row for row in (start.settled, *start.later) if row]
    steps = [then.t - now.t for now, then in pairwise(rows)]
    means = [(now.a + then.a) / 2 for now, then in pairwise(rows)]
    missed = rows[-1].u - rows[0].u - sum(h * a for h, a in zip(steps, means, strict=True))
    largest = max(np.abs(row.a).max() for row in rows)
    return bool(np.abs(missed).max() <= 1e-4 * SPAN * (1 + largest**2))


def of_refusal(body: Body, s: State, why: str) -> Judged:
    """Return what it is worth that a run does not go beyond a state."""
    if not why:
        return Judged(Verdict.WRONG, "ended without a reason")
    after, count, clear, stays = velocities(body, s), 0, True, 0
    for u in after.found:
        found = solutions(here(body, now := replace(s, u=u)))
        count, clear = count + found.count, clear and found.clear and found.stable
        stays += sum(not ends(body, now, one.a) for one in found.found)
    if count > 1:
        return Judged(Verdict.REFUSED_OF_SEVERAL, why)
    if not (clear and after.clear):
        return Judged(Verdict.BLURRED, why)
    return Judged(Verdict.REFUSED if stays else Verdict.NAMED, why)


def ends(body: Body, s: State, a: np.ndarray) -> bool:
    """Whether a motion with these accelerations has none to follow it: forces have grown without bound (Painleve)."""
    moments = (replace(s, x=s.x + dt * s.u[:3], u=s.u + dt * full(body, a), t=s.t + dt) for dt in SOON)
    return not any(solutions(here(body, one)).count for one in moments)


def allowed(one: Problem) -> str:
    """Say what would be right."""
    found = solutions(one)
    return f"allowed {[each.a.round(6).tolist() for each in found.found]}{'' if found.clear else ', perhaps more'}"


def close(a: np.ndarray, b: np.ndarray) -> bool:
    return bool(np.abs(a - b).max() <= AGREES * (1 + np.abs(b).max()))


def size_of(one: Problem, a: np.ndarray) -> float:
    """Return the size of the forces that have to balance."""
    return float(1 + np.abs(one.h).max() + np.abs(one.M).max() * np.abs(a).max())


def state_of(row: Row) -> State:
    return State(row.x, turned(row.angles), row.u, row.t)
