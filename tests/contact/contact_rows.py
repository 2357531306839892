"""The four conditions at every row of a run, in the oracle's own terms.

Nothing pulls, no closed gap is pressed inwards, nothing that sticks is held by more than its limit, nothing slides the
wrong way.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from ..oracles.contact_check import off
from ..oracles.feet import Point, point, problem
from .contact_cases import Case
from .contact_models import Row, rows_of
from .contact_verdicts import size_of, state_of

TOLERANCE = 1e-6
"""Of gaps, their rates and slips along a run at 1e-9, and of forces relative to those that balance."""
SHIFT = 1e-7
"""What the slip of a cone may count from, at 1e-9: its force is off by as much beside the slip."""


def with_modes(case: Case, run: Any) -> Iterator[tuple[Row, Mapping[str, float]]]:
    """Yield rows with their modes; of rows at one time the first is of the mode before, the last of that after.

    Between the two are modes that last no time. Where a run ends for a reason, nothing is decided yet.
    """
    rows, modes = rows_of(case, run), list(run.modes)
    for k, (row, t) in enumerate(zip(rows, run.t, strict=True)):
        first, last = k == 0 or run.t[k - 1] < t, k + 1 == len(rows) or run.t[k + 1] > t
        before = [mode for since, mode in modes if since < t or (last and since <= t)]
        if before and (first or last) and (run.success or t < run.t[-1]):
            yield row, before[-1]


def faults(case: Case, run: Any) -> list[str]:
    """Return what is wrong in the rows of a run."""
    return [f"t = {row.t:.9g}: {what}" for row, mode in with_modes(case, run) for what in at_row(case, row, mode)]


def at_row(case: Case, row: Row, mode: Mapping[str, float]) -> Iterator[str]:
    s = state_of(row)
    points = [point(foot, s) for foot in case.body.feet]
    contacts = range(case.shape.contacts)
    held = [k for k in contacts if mode[f"foot{k}_held"]]
    yield from (f"foot {k} is inside by {-points[k].gap:.2g}" for k in contacts if points[k].gap < -TOLERANCE)
    yield from (
        f"foot {k} is held in the air" for k in held if max(abs(points[k].gap), abs(points[k].rate)) > TOLERANCE
    )
    touching = [k for k in contacts if k in held or (abs(points[k].gap) < 1e-9 and abs(points[k].rate) < 1e-9)]
    rubs = [k for k, at in enumerate(points) if len(at.slip) and (k in touching or k >= case.shape.contacts)]
    if case.shape.cone:
        ways = [ways_of_cone(points[k]) for k in rubs]
    else:
        yield from (what for k in rubs for what in wrong_way(k, points[k], mode))
        ways = [ways_of_line(points[k], mode[f"rub{k}_slides"], bool(mode[f"rub{k}_stuck"])) for k in rubs]
    missed = min(off_by(case, row, touching, dict(zip(rubs, chosen, strict=True))) for chosen in choices(ways))
    slowest = min((np.linalg.norm(points[k].slip) for k in rubs), default=1.0) if case.shape.cone else 1.0
    if not missed <= TOLERANCE + (SHIFT / max(slowest, SHIFT) if case.shape.cone else 0.0):
        yield f"accelerations {row.a[case.body.kept]} need forces that are off by {missed:.2g} in mode {dict(mode)}"


def wrong_way(k: int, at: Point, mode: Mapping[str, float]) -> Iterator[str]:
    slides = mode[f"rub{k}_slides"]
    if mode[f"rub{k}_stuck"] and np.abs(at.slip).max() > TOLERANCE:
        yield f"friction {k} sticks and slips at {at.slip}"
    if slides * at.slip[0] < -TOLERANCE:
        yield f"friction {k} slides the wrong way"


def ways_of_line(at: Point, slides: float, stuck: bool) -> list[np.ndarray | None]:
    """Along what it slides; None: at rest. As it begins or ends to slide, either."""
    if stuck or not slides:
        return [None if stuck or abs(at.slip[0]) <= TOLERANCE else at.slip]
    way = np.array([slides])
    return [way, None] if abs(at.slip[0]) <= TOLERANCE else [way]


def ways_of_cone(at: Point) -> list[np.ndarray | None]:
    size = np.linalg.norm(at.slip)
    return [None] if size <= 1e-12 else [at.slip, None] if size <= TOLERANCE else [at.slip]


def choices(ways: list[list[np.ndarray | None]]) -> Iterator[list[np.ndarray | None]]:
    if not ways:
        yield []
        return
    for first in ways[0]:
        for others in choices(ways[1:]):
            yield [first, *others]


def off_by(case: Case, row: Row, touching: list[int], ways: dict[int, np.ndarray | None]) -> float:
    """Return by how much forces are missing, relative to those that balance."""
    slips = {k: way for k, way in ways.items() if way is not None}
    one, a = problem(case.body, state_of(row), touching, slips), row.a[case.body.kept]
    return off(one, a, TOLERANCE * (1 + float(np.abs(a).max()))) / size_of(one, a)


def let_go(case: Case, height: float) -> Case:
    """Return a case on flat ground a height above it and tilted, with impacts that lose energy."""
    up = np.eye(3)[1 if case.shape.planar else 2]
    feet = tuple(replace(foot, e=0.6 * foot.e) for foot in case.body.feet)
    tilt = np.array([0.0, 0.0, 0.2]) if case.shape.planar else np.array([0.1, 0.2, 0.0])
    tilted = replace(case, body=replace(case.body, feet=feet, rest=1e-3), units=(1.0, 1.0, 1.0))
    if not height:
        return tilted
    tilted = replace(tilted, angles=tilt)
    lowest = min(point(foot, tilted.state).gap for foot in feet if foot.presses)
    return replace(tilted, x=case.x + (height - lowest) * up)
