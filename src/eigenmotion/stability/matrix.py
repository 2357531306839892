"""The whole matrix: all points of all cases, on two processors."""

import multiprocessing
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor, as_completed
from dataclasses import dataclass
from typing import TypeVar

from .case import Case
from .cases import CASES
from .examine import Examined, examine, program
from .outcome import Cell, Outcome
from .variants import Variant

Task = tuple[str, float]  # a case and a value
Result = TypeVar("Result")
Progress = Callable[[float, str], None]  # how much of the whole is done, 0 ... 1, and what was done last


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

    def count(self, outcome: Outcome) -> int:
        """Return how many cells ended so."""
        return sum(cell.outcome is outcome for cell in self.cells)


def survey(names: Sequence[str], workers: int, progress: Progress, reduced: bool = False) -> Matrix:
    """Build what the cases need, then examine every point, or the few of each case's `reduced`."""
    begin = time.perf_counter()
    chosen = [CASES[name] for name in names]
    tasks = [(case.name, value) for case in chosen for value in (case.reduced if reduced else case.values)]
    if workers <= 1:
        points = {task: _report(progress, k, tasks, examine(CASES[task[0]], task[1])) for k, task in enumerate(tasks)}
    else:
        with _pool(workers) as pool:
            points = _in_parallel(pool, tasks, progress)
    return Matrix(tuple(points[task] for task in tasks), time.perf_counter() - begin, workers)


def _report(progress: Progress, k: int, tasks: Sequence[object], found: Examined) -> Examined:
    progress((k + 1) / len(tasks), found.case)
    return found


def _pool(workers: int) -> ProcessPoolExecutor:
    """Return fresh processes: forks of one that has threads may hang."""
    return ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn"))


def _in_parallel(pool: ProcessPoolExecutor, tasks: list[Task], progress: Progress) -> dict[Task, Examined]:
    """Programs first, each built once, the longest to build first; then points, likewise."""
    by_cost = sorted(tasks, key=lambda task: -CASES[task[0]].weight * (1 + task[1] * (task[0] == "chain")))
    orders = list(_orders(by_cost))
    builds = [pool.submit(_build, *order) for order in orders]
    for k, done in enumerate(_finished(builds)):
        progress(0.5 * (k + 1) / len(builds), done.result())
    futures = {pool.submit(_examine, *task): task for task in by_cost}
    found = {}
    for k, future in enumerate(_finished(list(futures))):
        found[futures[future]] = future.result()
        progress(0.5 + 0.5 * (k + 1) / len(futures), futures[future][0])
    return found


def _finished(futures: Sequence["Future[Result]"]) -> Iterator["Future[Result]"]:
    """Yield them as they end; the first failure ends the rest."""
    for future in as_completed(futures):
        if future.exception() is not None:
            for other in futures:
                other.cancel()
        yield future


def _orders(tasks: Iterable[Task]) -> Iterator[tuple[str, float, Variant]]:
    """Yield what to build: cases that share a model share its programs."""
    seen = set()
    for name, value in tasks:
        case = CASES[name]
        for variant in case.variants:
            wanted = (case.model(value).name, *variant.build.values(), case.flags)
            if wanted not in seen:
                seen.add(wanted)
                yield name, value, variant


def _build(name: str, value: float, variant: Variant) -> str:
    program(CASES[name], value, variant)
    return f"building {CASES[name].model(value).name}"


def _examine(name: str, value: float) -> Examined:
    return examine(CASES[name], value)
