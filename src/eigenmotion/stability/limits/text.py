"""Summary of the limits of a model, in a few lines: the worst first."""

from collections.abc import Iterator

from ...presentation.counts import count_of
from ..evaluation.outcome import JUDGED_RIGHT, Cell, Outcome
from ..output.text import counted, described, runs_of
from .findings import Range, Record, places, ranges, records
from .survey import Limits

_MOST = 5
"""Runs that are named one by one"""


def summary_of(found: Limits) -> tuple[str, ...]:
    """Return the lines of the summary."""
    return tuple(_lines(found))


def _lines(found: Limits) -> Iterator[str]:
    matrix = found.matrix
    if found.interrupted:
        yield f"interrupted after {len(matrix.points)} of {count_of(_count(found), 'point')}: the rest was not run"
    yield (f"{found.own.model.name}: {runs_of(matrix)} in {matrix.seconds:.0f} s: {counted(matrix)}.")
    for outcome in (Outcome.WRONG, Outcome.DIFFERS):
        yield from _named(found, outcome)
    if matrix.cells:
        yield from _recommended(found)
    yield from _groups(found, Outcome.DEGRADED)
    yield from _groups(found, Outcome.REFUSED)
    yield from _doubts(found)
    yield from found.searched
    yield from (f"not built: {name}: {why}" for name, why in found.unbuilt)
    yield from _rest(found)


def _named(found: Limits, outcome: Outcome) -> Iterator[str]:
    cells = [cell for cell in found.matrix.cells if cell.outcome is outcome]
    for cell in cells[:_MOST]:
        yield f"{str(outcome).upper()}: {described(cell)}" + (f"; {cell.message}" if cell.message else "")
    if len(cells) > _MOST:
        yield f"{str(outcome).upper()}: and {len(cells) - _MOST} more, in {places(found.matrix, cells)}"


def _recommended(found: Limits) -> Iterator[str]:
    best, *others = records(found.matrix)
    formulation, method = best.combination
    if not best.right:
        points = count_of(len(found.matrix.points), "point")
        yield f"no formulation with any method is known to be right in any of {points}"
        return
    lost = len(best.cells) - len(best.right) - len(best.bad)
    unjudged = f", with no digits left to judge in {lost}" if lost else ""
    if len(best.right) == len(best.cells):
        yield f"use {formulation} with {method}: {_word(best)} in {_all(len(best.cells))}"
    else:
        where = f"; not in {places(found.matrix, best.bad)}" if best.bad else ""
        more = any(len(other.right) > len(best.right) for other in others)
        rank = "the most of those that are wrong least often" if more else "as many as any other"
        right = f"{_word(best)} in {len(best.right)} of {count_of(len(best.cells), 'point')}"
        yield f"use {formulation} with {method}: {right}, {rank}{unjudged}{where}"
    yield from _limits(ranges(found.matrix, best.combination))


def _all(points: int) -> str:
    return "the only point" if points == 1 else f"all {points} points"


def _word(record: Record) -> str:
    """Return what its right cells are."""
    present = {cell.outcome for cell in record.right}
    words = [str(outcome) for outcome in JUDGED_RIGHT if outcome in present]
    return " or ".join({"agrees": "agrees with tight runs only"}.get(word, word) for word in words) or "right"


def _limits(found: list[Range]) -> Iterator[str]:
    """Yield the ranges of parameters: those with limits one by one, the others together."""
    if not found:
        yield "parameters: none was varied"
        return
    for one in found:
        if one.limited:
            why = "; ".join(text for text in (one.below, one.above) if text)
            yield f"  {one.name} from {one.least:g} to {one.most:g} times its value ({why})"
    spans: dict[tuple[float, float], list[str]] = {}
    for one in found:
        if not one.limited:
            spans.setdefault((one.least, one.most), []).append(one.name)
    for (least, most), names in spans.items():
        yield f"  {', '.join(names)} from {least:g} to {most:g} times the value: no limit found"


def _groups(found: Limits, outcome: Outcome) -> Iterator[str]:
    """Yield the runs with an outcome, by reason."""
    by_reason: dict[str, list[Cell]] = {}
    for cell in found.matrix.cells:
        if cell.outcome is outcome:
            by_reason.setdefault(cell.reason, []).append(cell)
    for reason, cells in sorted(by_reason.items(), key=lambda pair: -len(pair[1])):
        methods = list(dict.fromkeys(cell.method for cell in cells))
        variants = list(dict.fromkeys(cell.variant for cell in cells))
        by = ", ".join(methods if len(methods) < len(variants) or len(methods) < _MOST else ["all methods"])
        words = f", {reason}" if reason else ""
        yield f"{outcome}{words} ({count_of(len(cells), 'run')}; {by}): {places(found.matrix, cells)}"


def _doubts(found: Limits) -> Iterator[str]:
    """Yield where there was no independent reference."""
    points = [point for point in found.matrix.points if not point.independent]
    if found.own.why:
        yield (
            f"no independent reference, because of {found.own.why}: no run is called right; runs are compared with two "
            "tight runs by other formulations and methods"
        )
    elif points:
        yield f"no independent reference in {count_of(len(points), 'point')}: {places(found.matrix, points)}"


def _count(found: Limits) -> int:
    return len(found.matrix.points) + sum(len(labels) for _, labels in found.left_out)


def _rest(found: Limits) -> Iterator[str]:
    """Yield what was not run."""
    count = sum(len(labels) for _, labels in found.left_out)
    runs = sum(point.left_out for point in found.matrix.points)
    if count:
        texts = [f"{title.replace('Parameter ', '')} {', '.join(labels)}" for title, labels in found.left_out]
        rest = f"; and {len(texts) - _MOST} more" if len(texts) > _MOST else ""
        yield f"not run, {count_of(count, 'point')}: {'; '.join(texts[:_MOST])}{rest}"
    if runs:
        points = [point for point in found.matrix.points if point.left_out]
        yield f"not run, {count_of(runs, 'run')} of points that took too long: {places(found.matrix, points)}"
    if not found.interrupted and (count or runs) or any("budget" in why for _, why in found.unbuilt):
        yield f"the budget of {found.budget:g} s was too short for these: raise --budget"
