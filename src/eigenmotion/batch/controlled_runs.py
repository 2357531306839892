"""Runs with controllers that advance together, from one sample time to the next."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, wait
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np

from ..arguments.named_values import Vector
from ..arguments.options import Task
from ..arguments.sampled import Controlled
from ..arguments.signals import Signal
from ..runtime import RunInParts, RunsInParts, StopReason
from ..runtime.ensemble import Stop
from ..simulation.sampled_inputs import Held, Schedule, opened, with_held

_LEAST = 64  # runs for which a thread is worth asking


def pace(task: Task) -> tuple[Any, ...]:
    """Return the inputs, periods and delays of controllers; if they are equal, runs have common sample times."""
    controllers = dict.fromkeys(one for one in task.inputs.signals if isinstance(one, Controlled))
    return tuple((one.names, one.sampled.period, one.sampled.delay) for one in controllers)


class _Answers:
    """Controllers of K runs, for the same inputs, and the values that they have returned.

    places : indices of these inputs in the model
    times : (k,) from which each of `rows` (k, K, inputs) holds
    """

    def __init__(self, start: float, of_runs: Sequence[Held]) -> None:
        self.places, self._controlled = of_runs[0].places, [held.controlled for held in of_runs]
        self._functions = [held.function for held in of_runs]
        self.times, self.rows = [start], [np.array([held.values for held in of_runs])]

    def ask(self, going: list[int], t: float, x: Vector, v: Vector, failed: dict[int, Exception]) -> Vector:
        """Call controllers of the runs that continue; return values (K, inputs), put exceptions into `failed`."""
        answers: list[Any] = list(self.rows[-1])
        for i, x_i, v_i in zip(going, x[going], v[going], strict=True):
            try:
                answers[i] = self._controlled[i].read(self._functions[i](t, x_i, v_i), t)
            except Exception as error:  # whatever a controller of the user's raises
                failed[i] = error
        return np.array(answers)

    def note(self, t: float, rows: Vector) -> None:
        """Record the values that hold from t on."""
        if t == self.times[-1]:
            self.rows[-1] = rows
        else:
            self.times.append(t)
            self.rows.append(rows)

    @cached_property
    def table(self) -> Vector:
        """(k, K, inputs)."""
        return np.array(self.rows)

    def signals(self, i: int, count: int) -> tuple[Signal, ...]:
        """Return the first `count` values of run i as signals, one for each input."""
        times = np.array(self.times[:count])
        return tuple(Signal(times, column, "hold") for column in self.table[:count, i].T)


class ControlledRuns:
    """Open runs of one span whose controllers have common sample times.

    Parameters
    ----------
    tasks
        By the number of the member.

    Attributes
    ----------
    failed : number -> time and exception of a controller
    """

    def __init__(self, tasks: Mapping[int, Task], method: int) -> None:
        started = [opened(task) for task in tasks.values()]
        self._numbers, self._tasks = list(tasks), [task for task, _ in started]
        self._runs = [RunInParts(task, method) for task in self._tasks]
        one = self._tasks[0]
        self._end, self._together = one.t_end, RunsInParts(one.model, self._runs)
        self._answers = [_Answers(one.t_start, each) for each in zip(*(held for _, held in started), strict=True)]
        self._going, self._counts = list(range(len(self._runs))), dict[int, list[int]]()
        self.failed: dict[int, tuple[float, Exception]] = {}
        controllers = [held.controlled.sampled for held in started[0][1]]
        self._schedule = Schedule(one.t_start, controllers, self._ask, self._take)

    def advance(self, workers: int, stop: Stop) -> Iterator[float]:
        """Advance all runs to the end of the span; yield each sample time, after the controllers were called."""
        parts = _parts(len(self._runs), workers)
        with ThreadPoolExecutor(max(1, len(parts) - 1), "controlled") as threads:
            while self._going and not stop and (t := self._schedule.next) < self._end:
                self._advance_to(t, parts, threads, stop)
                self._schedule.answer(t)
                yield t
            if not stop:
                self._advance_to(self._end, parts, threads, stop)

    def _advance_to(self, t: float, parts: list[tuple[int, int]], threads: ThreadPoolExecutor, stop: Stop) -> None:
        """Advance ranges of runs in threads, the first in this one, which receives signals."""
        others = [threads.submit(self._together.advance, t, *part) for part in parts[1:]]
        try:
            self._together.advance(t, *parts[0])
        finally:
            wait(others)
        ended = [i for i in self._together.ended() if i not in self._counts]
        self._leave(ended, None)
        if any(self._runs[i].stop is StopReason.INTERRUPTED for i in ended):
            stop.set()

    def _leave(self, over: Iterable[int], reason: StopReason | None) -> None:
        """Close runs that have ended, or that end now for a reason."""
        for i in over:
            self._runs[i].close(reason)
            self._counts[i] = [len(answers.times) for answers in self._answers]
            self._going.remove(i)

    def _ask(self, k: int, t: float) -> Vector:
        failed: dict[int, Exception] = {}
        rows = self._answers[k].ask(self._going, t, *self._together.now(), failed)
        for i, error in failed.items():
            self.failed[self._numbers[i]] = t, error
        self._leave(failed, StopReason.INTERRUPTED)
        return rows

    def _take(self, k: int, t: float, rows: Vector) -> None:
        answers = self._answers[k]
        for place, column in zip(answers.places, rows.T, strict=True):
            self._together.set(place, column)
        answers.note(t, rows)

    def results(self) -> Iterator[tuple[int, Task, RunInParts]]:
        """Close all runs; yield the number of each, its task with the recorded inputs, and the run."""
        interrupted = [i for i in self._going if self._runs[i].reached < self._end]
        self._leave(interrupted, StopReason.INTERRUPTED)
        self._leave(list(self._going), None)
        for i, (number, task, run) in enumerate(zip(self._numbers, self._tasks, self._runs, strict=True)):
            held = zip(self._answers, self._counts[i], strict=True)
            yield number, with_held(task, {one.places: one.signals(i, count) for one, count in held}), run


def _parts(count: int, workers: int) -> list[tuple[int, int]]:
    """Return the range of runs of each thread."""
    shares = max(1, min(workers, count // _LEAST))
    return list(pairwise(round(count * k / shares) for k in range(shares + 1)))
