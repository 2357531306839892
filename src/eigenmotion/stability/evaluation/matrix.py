"""The whole matrix: all points of all cases, on two processors."""

import multiprocessing
import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Future, ProcessPoolExecutor, as_completed
from dataclasses import dataclass
from typing import TypeVar

from ...progress import Progress, part
from ..cases.case import Case
from ..cases.catalogue import CASES
from ..cases.variants import Variant
from .examine import Examined, examine, program
from .outcome import Cell, Outcome

CaseValue = tuple[str, float]  # a case's name and one of its values
Result = TypeVar("Result")


@dataclass(frozen=True, slots=True)
class Matrix:
    """All points, in the order of the cases, and how long it took [s]."""

    points: tuple[Examined, ...]
    seconds: float
    workers: int

    @property
    def cells(self) -> tuple[Cell, ...]:
        """Every run."""
        return tuple(cell for point in self.points for cell in point.cells)

    @property
    def cases(self) -> tuple[Case, ...]:
        """The cases that were examined."""
        return tuple(CASES[name] for name in dict.fromkeys(point.case for point in self.points))

    def of(self, case: Case) -> tuple[Examined, ...]:
        """Return the points of a case."""
        return tuple(point for point in self.points if point.case == case.name)

    def has_periods(self, case: Case) -> bool:
        """Whether a case's spans hold many periods, so that drifts have a slope."""
        return any(point.periods for point in self.of(case))

    def count(self, outcome: Outcome) -> int:
        """Return how many cells ended so."""
        return sum(cell.outcome is outcome for cell in self.cells)


def survey(names: Sequence[str], workers: int, progress: Progress, reduced: bool = False) -> Matrix:
    """Build what the cases need, then examine every point, or the few of each case's `reduced`."""
    begin = time.perf_counter()
    chosen = [CASES[name] for name in names]
    wanted = [(case.name, value) for case in chosen for value in (case.reduced if reduced else case.values)]
    if workers <= 1:
        found = _in_turn(wanted, progress)
    else:
        with _pool(workers) as pool:
            found = _in_parallel(pool, wanted, progress)
    return Matrix(tuple(found[one] for one in wanted), time.perf_counter() - begin, workers)


def _in_turn(wanted: Sequence[CaseValue], progress: Progress) -> dict[CaseValue, Examined]:
    found = {}
    for k, (name, value) in enumerate(wanted):
        found[name, value] = examine(CASES[name], value)
        progress((k + 1) / len(wanted), name)
    return found


def _pool(workers: int) -> ProcessPoolExecutor:
    """Return fresh processes: forks of one that has threads may hang."""
    return ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn"))


def _in_parallel(pool: ProcessPoolExecutor, wanted: Sequence[CaseValue], progress: Progress
                 ) -> dict[CaseValue, Examined]:  # fmt: skip
    """Programs first, each built once, the longest to build first; then points, likewise."""
    by_cost = sorted(wanted, key=lambda one: -CASES[one[0]].cost(one[1]))
    builds = {pool.submit(_build, *one): f"building {CASES[one[0]].model(one[1]).name}" for one in _programs(by_cost)}
    for build in _finished(builds, part(progress, 0.0, 0.5)):
        build.result()
    runs = {pool.submit(_examine, *one): one for one in by_cost}
    names = {run: name for run, (name, _) in runs.items()}
    return {runs[run]: run.result() for run in _finished(names, part(progress, 0.5, 1.0))}


def _finished(futures: Mapping["Future[Result]", str], progress: Progress) -> Iterator["Future[Result]"]:
    """Yield them as they end, by name in the progress; the first failure ends the rest."""
    for k, future in enumerate(as_completed(futures)):
        if future.exception() is not None:
            for other in futures:
                other.cancel()
        yield future
        progress((k + 1) / len(futures), futures[future])


def _programs(wanted: Iterable[CaseValue]) -> Iterator[tuple[str, float, Variant]]:
    """Yield what to build: cases that share a model share its programs."""
    seen = set()
    for name, value in wanted:
        case = CASES[name]
        for variant in case.variants:
            key = (case.model(value).name, *variant.build.values(), case.flags)
            if key not in seen:
                seen.add(key)
                yield name, value, variant


def _build(name: str, value: float, variant: Variant) -> None:
    program(CASES[name], value, variant)


def _examine(name: str, value: float) -> Examined:
    return examine(CASES[name], value)
