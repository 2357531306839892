"""Examination of a user's model within a time budget: builds, search, and the points one after the other."""

import os
import time
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import dataclass, field

from ...building.errors import BuildError
from ...building.request import request
from ...codegen.choices import FORMULATIONS
from ...codegen.model import Model, ModelError
from ...comparison.deadline import Deadline
from ...comparison.interrupts import SPAWN, Pool, ends_silently, starting
from ...progress import Progress
from ..cases.case import Case, power
from ..evaluation.examine import PointResult, examine
from ..evaluation.matrix import Matrix
from .families import families
from .references import system_of
from .singular_search import searches
from .subject import Subject, subject

BUDGET = 90.0
"""[s] default time for an examination"""
_BUILDS, _SEARCH, _PATIENCE, _POINT = 0.4, 0.06, 0.03, 0.1  # parts of the budget for builds, search, references, points
_LEAST, _FIRST = 1.0, 30.0  # [s] of such a part; of the first point and what comes before it, after the builds
_WORTH = 0.5  # part of a point's mean time that must be left for another to begin
_PLACE = tuple[str, float]


@dataclass(frozen=True)
class Limits:
    """The result: the matrix, and what was not run.

    unbuilt : formulations that do not exist for the model, and why
    searched : in words, for singular positions
    left_out : (case title, labels of points) that the budget did not allow
    interrupted : whether Ctrl-C ended the examination
    """

    own: Subject
    matrix: Matrix
    budget: float
    unbuilt: tuple[tuple[str, str], ...]
    searched: tuple[str, ...]
    left_out: tuple[tuple[str, tuple[str, ...]], ...]
    interrupted: bool = False


def limits_of(
    model: Model, settings: Mapping[str, Mapping[str, float]] | None = None, *, t_end: float = 10.0,
    budget: float = BUDGET, workers: int = 1, progress: Progress | None = None,
) -> Limits:  # fmt: skip
    """Drive a model to its limits.

    Parameters
    ----------
    settings
        parameters, inputs, x0, v0 of `simulate`, over those of the model.
    t_end
        [s] longest span of the runs that vary other things than the span.
    budget
        [s] after which no run goes on, except those of the first point; those that were not run are named.

    Raises
    ------
    ModelError, BuildError
        The model cannot be built, or its motion cannot start.

    Examples
    --------
    >>> from eigenmotion.models.pendulum import model
    >>> from eigenmotion.stability import Outcome, limits_of
    >>> found = limits_of(model, budget=4.0)  # doctest: +SKIP
    >>> found.matrix.count(Outcome.WRONG)  # doctest: +SKIP
    0
    """
    begin = time.monotonic()
    clock = _Clock(begin, budget, progress or (lambda *_: None))
    formulations, unbuilt = _built(model, clock)
    clock(f"motion of {model.name}")
    deadline = Deadline(max(clock.until, time.monotonic() + _FIRST))
    own = subject(model, formulations, settings or {}, t_end, max(_LEAST, _PATIENCE * budget), deadline)
    clock("singular positions")
    searched = searches(own, deadline.sooner(max(_LEAST, _SEARCH * budget)))
    cases = families(own, [one.found for one in searched if one.found])
    points = in_order(cases)
    results, interrupted = _examined(cases, points, clock, workers)
    done = tuple(results[place] for case in cases for place in _sorted(case) if place in results)
    matrix = Matrix(done, time.monotonic() - begin, workers, tuple(cases))
    return Limits(own, matrix, budget, unbuilt, tuple(one.words for one in searched), _left_out(cases, results),
                  interrupted)  # fmt: skip


@dataclass(frozen=True)
class _Clock:
    """The time since the beginning, and its part of the budget as progress."""

    begin: float
    budget: float
    progress: Progress

    @property
    def until(self) -> float:
        return self.begin + self.budget

    def __call__(self, what: str) -> None:
        self.progress(min(0.99, (time.monotonic() - self.begin) / self.budget), what)


def in_order(cases: Sequence[Case]) -> list[_PLACE]:
    """Return the points in the order in which they run: the first value of every case, then the second, and so on."""
    longest = max(len(case.values) for case in cases)
    return [(case.name, case.values[k]) for k in range(longest) for case in cases if k < len(case.values)]


def _sorted(case: Case) -> list[_PLACE]:
    return [(case.name, value) for value in sorted(case.values)]


def _left_out(cases: Sequence[Case], results: Mapping[_PLACE, PointResult]) -> tuple[tuple[str, tuple[str, ...]], ...]:
    left = [(c.title, tuple(power(v) for n, v in _sorted(c) if (n, v) not in results)) for c in cases]
    return tuple((title, labels) for title, labels in left if labels)


def _built(model: Model, clock: _Clock) -> tuple[tuple[str, ...], tuple[tuple[str, str], ...]]:
    """Return the formulations that were built, the one that `build` chooses first; and the others with reasons."""
    chosen = request(model).choices.formulation
    names = dict.fromkeys((chosen, "lagrange", *FORMULATIONS))
    ready: list[str] = []
    without: list[tuple[str, str]] = []
    for name in names:
        clock(f"building {name}")
        spent = time.monotonic() - clock.begin
        if ready and (spent > _BUILDS * clock.budget or not _in_time(model, name, _BUILDS * clock.budget - spent)):
            without.append((name, "its build did not fit into the budget"))
            continue
        try:
            system_of(model, name)
            ready.append(name)
        except (ModelError, BuildError) as error:
            if name == chosen:
                raise
            without.append((name, str(error)))
    return tuple(ready), tuple(without)


def _in_time(model: Model, name: str, seconds: float) -> bool:
    """Build in a process that is ended if it takes too long; the result is then in the cache."""
    builder = SPAWN.Process(target=_try_to_build, args=(model, name), daemon=True)
    with starting():
        builder.start()
    try:
        builder.join(seconds)
        return not builder.is_alive()
    finally:
        builder.terminate()


def _try_to_build(model: Model, name: str) -> None:
    ends_silently()
    try:
        system_of(model, name)
    except (ModelError, BuildError):  # the caller meets the same error
        os._exit(0)


def _examined(
    cases: Sequence[Case], points: Sequence[_PLACE], clock: _Clock, workers: int
) -> tuple[dict[_PLACE, PointResult], bool]:
    """Return the results, and whether Ctrl-C ended the examination after some of them."""
    known = {case.name: case for case in cases}
    results: dict[_PLACE, PointResult] = {}
    cut: dict[_PLACE, PointResult] = {}
    each = max(_LEAST, _POINT * clock.budget)
    try:
        for place, result in _stream(known, points, Pace(Deadline(clock.until)), each, workers):
            (results if result.cells else cut)[place] = result
            clock(f"{len(results)} of {len(points)} points, {known[place[0]].title}")
    except KeyboardInterrupt:
        if not results:
            raise
        return results, True
    return results or dict([*cut.items()][:1]), False


@dataclass
class Pace:
    """Whether another point may begin: the first always, others if about as much time is left as one takes."""

    deadline: Deadline
    begun: int = 0
    seconds: list[float] = field(default_factory=list)

    def allows(self) -> bool:
        """Return whether a point may begin."""
        mean = sum(self.seconds) / len(self.seconds) if self.seconds else 0.0
        return self.begun == 0 or self.deadline.left > _WORTH * mean

    def begin(self) -> float:
        """Count a point that begins; return when."""
        self.begun += 1
        return self.deadline.now()

    def end(self, begin: float) -> None:
        """Note the time that a point took."""
        self.seconds.append(self.deadline.now() - begin)


def _stream(
    known: Mapping[str, Case], points: Sequence[_PLACE], pace: Pace, each: float, workers: int
) -> Iterator[tuple[_PLACE, PointResult]]:
    """Yield the results of the points that the pace allows."""
    if workers <= 1:
        for name, value in points:
            if not pace.allows():
                return
            begin = pace.begin()
            result = examine(known[name], value, seconds=each)
            pace.end(begin)
            yield (name, value), result
        return
    with Pool(workers, _take, (known,)) as pool:
        yield from _fed(pool, iter(points), pace, each, workers)


def _fed(
    pool: Pool, points: Iterator[_PLACE], pace: Pace, each: float, workers: int
) -> Iterator[tuple[_PLACE, PointResult]]:
    running: dict[Future[PointResult], tuple[_PLACE, float]] = {}
    while True:
        while len(running) < workers and pace.allows() and (place := next(points, None)) is not None:
            running[pool.submit(_examine, place, each)] = place, pace.begin()
        if not running:
            return
        for future in wait(running, return_when=FIRST_COMPLETED).done:
            place, begin = running.pop(future)
            pace.end(begin)
            yield place, future.result()


_KNOWN: dict[str, Case] = {}
"""The cases, in processes of a pool"""


def _take(known: Mapping[str, Case]) -> None:
    _KNOWN.update(known)


def _examine(place: _PLACE, each: float) -> PointResult:
    return examine(_KNOWN[place[0]], place[1], seconds=each)
