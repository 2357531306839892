"""Stability matrix: all points of all cases, examined in parallel."""

import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Future, ProcessPoolExecutor, as_completed
from dataclasses import dataclass
from typing import TypeVar

from ...comparison.interrupts import Pool
from ...progress import Progress, part
from ..cases.case import Case
from ..cases.catalogue import CASES
from ..cases.variants import Variant
from .examine import PointResult, examine, program
from .outcome import Cell, Outcome

CaseValue = tuple[str, float]  # a case's name and one of its values
Result = TypeVar("Result")


@dataclass(frozen=True, slots=True)
class Matrix:
    """All points, in the order of the cases, and the run time [s]; `own` are cases that are not in `CASES`."""

    points: tuple[PointResult, ...]
    seconds: float
    workers: int
    own: tuple[Case, ...] = ()

    @property
    def cells(self) -> tuple[Cell, ...]:
        """Every run."""
        return tuple(cell for point in self.points for cell in point.cells)

    @property
    def cases(self) -> tuple[Case, ...]:
        """The cases that were examined."""
        known = CASES | {case.name: case for case in self.own}
        return tuple(known[name] for name in dict.fromkeys(point.case for point in self.points))

    def of(self, case: Case) -> tuple[PointResult, ...]:
        """Return the points of a case."""
        return tuple(point for point in self.points if point.case == case.name)

    def has_periods(self, case: Case) -> bool:
        """Return whether a case spans many periods, so that drifts have a slope per period."""
        return any(point.periods for point in self.of(case))

    def count(self, outcome: Outcome) -> int:
        """Return the number of cells with this outcome."""
        return sum(cell.outcome is outcome for cell in self.cells)


def survey(names: Sequence[str], workers: int, progress: Progress, reduced: bool = False) -> Matrix:
    """Build the systems of the cases, then examine every point, or only those of each case's `reduced`."""
    begin = time.perf_counter()
    chosen = [CASES[name] for name in names]
    points = [(case.name, value) for case in chosen for value in (case.reduced if reduced else case.values)]
    if workers <= 1:
        results = _in_turn(points, progress)
    else:
        with Pool(workers) as pool:
            results = _in_parallel(pool, points, progress)
    return Matrix(tuple(results[one] for one in points), time.perf_counter() - begin, workers)


def _in_turn(points: Sequence[CaseValue], progress: Progress) -> dict[CaseValue, PointResult]:
    results = {}
    for k, (name, value) in enumerate(points):
        results[name, value] = examine(CASES[name], value)
        progress((k + 1) / len(points), name)
    return results


def _in_parallel(pool: ProcessPoolExecutor, points: Sequence[CaseValue], progress: Progress
                 ) -> dict[CaseValue, PointResult]:  # fmt: skip
    """Build each system once, then examine the points; the most expensive ones begin first."""
    by_cost = sorted(points, key=lambda one: -CASES[one[0]].cost(one[1]))
    builds = {pool.submit(_build, *one): f"building {CASES[one[0]].model(one[1]).name}" for one in _programs(by_cost)}
    for build in _finished(builds, part(progress, 0.0, 0.5)):
        build.result()
    runs = {pool.submit(_examine, *one): one for one in by_cost}
    names = {run: name for run, (name, _) in runs.items()}
    return {runs[run]: run.result() for run in _finished(names, part(progress, 0.5, 1.0))}


def _finished(futures: Mapping["Future[Result]", str], progress: Progress) -> Iterator["Future[Result]"]:
    """Yield futures as they end, with their names in the progress; the first failure cancels the rest."""
    for k, future in enumerate(as_completed(futures)):
        if future.exception() is not None:
            for other in futures:
                other.cancel()
        yield future
        progress((k + 1) / len(futures), futures[future])


def _programs(points: Iterable[CaseValue]) -> Iterator[tuple[str, float, Variant]]:
    """Yield the systems to build: cases with the same model share its systems."""
    seen = set()
    for name, value in points:
        case = CASES[name]
        for variant in case.variants:
            key = (case.model(value).name, *variant.build.values(), case.flags)
            if key not in seen:
                seen.add(key)
                yield name, value, variant


def _build(name: str, value: float, variant: Variant) -> None:
    program(CASES[name], value, variant)


def _examine(name: str, value: float) -> PointResult:
    return examine(CASES[name], value)
