"""Runs with controllers that advance together from one sample time to the next."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, wait
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np

from ..arguments.named_values import Vector
from ..arguments.sampled import Controlled
from ..arguments.signals import Signal
from ..arguments.tasks import Task
from ..runtime import IncrementalRun, IncrementalRuns, StopReason
from ..runtime.ensemble import Stop
from ..simulation.sampled_inputs import ControllerRecord, Schedule, open_controllers, with_recorded_inputs

_LEAST = 64  # fewest runs for which a thread pays


def pace(task: Task) -> tuple[Any, ...]:
    """Return the inputs, periods and delays of the controllers. Runs with equal ones have common sample times."""
    controllers = dict.fromkeys(one for one in task.inputs.signals if isinstance(one, Controlled))
    return tuple((one.names, one.sampled.period, one.sampled.delay) for one in controllers)


class _ControllerValues:
    """The controllers of the same inputs in K runs, and the values that they have returned.

    places : indices of these inputs in the model
    times : (k,) from which each of `rows` (k, K, inputs) holds
    """

    def __init__(self, start: float, of_runs: Sequence[ControllerRecord]) -> None:
        self.places, self._controlled = of_runs[0].places, [records.controlled for records in of_runs]
        self._functions = [records.function for records in of_runs]
        self.times, self.rows = [start], [np.array([records.values for records in of_runs])]

    def call(self, running: list[int], t: float, x: Vector, v: Vector, failed: dict[int, Exception]) -> Vector:
        """Call controllers of the runs that continue; return values (K, inputs), put exceptions into `failed`."""
        values: list[Any] = list(self.rows[-1])
        for i, x_i, v_i in zip(running, x[running], v[running], strict=True):
            try:
                values[i] = self._controlled[i].read(self._functions[i](t, x_i, v_i), t)
            except Exception as error:  # whatever a controller of the user's raises
                failed[i] = error
        return np.array(values)

    def record(self, t: float, rows: Vector) -> None:
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
    """Open runs over one time span, with common sample times of their controllers.

    Parameters
    ----------
    tasks
        Number of the member -> its task.

    Attributes
    ----------
    failed : number -> time and exception of a controller
    """

    def __init__(self, tasks: Mapping[int, Task], method: int) -> None:
        started = [open_controllers(task) for task in tasks.values()]
        self._numbers, self._tasks = list(tasks), [task for task, _ in started]
        self._runs = [IncrementalRun(task, method) for task in self._tasks]
        one = self._tasks[0]
        self._end, self._together = one.t_end, IncrementalRuns(one.model, self._runs)
        by_controller = zip(*(records for _, records in started), strict=True)
        self._values = [_ControllerValues(one.t_start, of_runs) for of_runs in by_controller]
        self._running, self._counts = list(range(len(self._runs))), dict[int, list[int]]()
        self.failed: dict[int, tuple[float, Exception]] = {}
        controllers = [records.controlled.sampled for records in started[0][1]]
        self._schedule = Schedule(one.t_start, controllers, self._call, self._apply)

    def advance(self, workers: int, stop: Stop) -> Iterator[float]:
        """Advance all runs to the end of the span; yield each sample time, after the controllers were called."""
        parts = _parts(len(self._runs), workers)
        with ThreadPoolExecutor(max(1, len(parts) - 1), "controlled") as threads:
            while self._running and not stop and (t := self._schedule.next) < self._end:
                self._advance_to(t, parts, threads, stop)
                self._schedule.act(t)
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
        self._close(ended, None)
        if any(self._runs[i].stop is StopReason.INTERRUPTED for i in ended):
            stop.set()

    def _close(self, over: Iterable[int], reason: StopReason | None) -> None:
        """Close runs that have ended; with a reason, end them."""
        for i in over:
            self._runs[i].close(reason)
            self._counts[i] = [len(values.times) for values in self._values]
            self._running.remove(i)

    def _call(self, k: int, t: float) -> Vector:
        failed: dict[int, Exception] = {}
        rows = self._values[k].call(self._running, t, *self._together.now(), failed)
        for i, error in failed.items():
            self.failed[self._numbers[i]] = t, error
        self._close(failed, StopReason.INTERRUPTED)
        return rows

    def _apply(self, k: int, t: float, rows: Vector) -> None:
        values = self._values[k]
        for place, column in zip(values.places, rows.T, strict=True):
            self._together.set(place, column)
        values.record(t, rows)

    def results(self) -> Iterator[tuple[int, Task, IncrementalRun]]:
        """Close all runs; yield the number of each, its task with the recorded inputs, and the run."""
        interrupted = [i for i in self._running if self._runs[i].reached < self._end]
        self._close(interrupted, StopReason.INTERRUPTED)
        self._close(list(self._running), None)
        for i, (number, task, run) in enumerate(zip(self._numbers, self._tasks, self._runs, strict=True)):
            records = zip(self._values, self._counts[i], strict=True)
            yield number, with_recorded_inputs(task, {one.places: one.signals(i, count) for one, count in records}), run


def _parts(count: int, workers: int) -> list[tuple[int, int]]:
    """Return the range of runs of each thread."""
    shares = max(1, min(workers, count // _LEAST))
    return list(pairwise(round(count * k / shares) for k in range(shares + 1)))
