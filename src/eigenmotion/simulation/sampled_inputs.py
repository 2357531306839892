"""Sampled controllers of a run: Python functions that are called once a period; inputs are constant in between."""

from array import array
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from heapq import heappop, heappush
from typing import Any

import numpy as np

from ..arguments.named_values import Vector
from ..arguments.options import Task
from ..arguments.sampled import Controlled, Controller, Sampled
from ..arguments.signals import Inputs, Signal
from ..codegen.model.normalise import ModelError
from ..runtime import IncrementalRun

_VALUE, _QUESTION = 0, 1  # actions that may be due at the same time, in this order


def check_forwards(start: float, end: float) -> None:
    """Raise ModelError for a run backwards in time."""
    if end < start:
        raise ModelError("Sampled inputs are for runs forwards in time: a controller knows the past alone")


class Schedule:
    """Times at which controllers are called, and at which their values take effect after a delay.

    Actions are ordered by time. At equal times a delayed value takes effect before the next call.

    Parameters
    ----------
    ask
        Called with the number of a controller and the time; returns its value.
    take
        Called with the number of a controller, the time and a value that holds from then on.
    """

    def __init__(
        self, start: float, controllers: Sequence[Sampled], ask: Callable[[int, float], Any],
        take: Callable[[int, float, Any], None],
    ) -> None:  # fmt: skip
        self._start, self._controllers, self._ask, self._take = start, controllers, ask, take
        self._counts = [0] * len(controllers)
        self._due: list[tuple[float, int, int, Any]] = [(start, _QUESTION, k, None) for k in range(len(controllers))]

    @property
    def next(self) -> float:
        """The time of the next action."""
        return self._due[0][0]

    def answer(self, t: float) -> None:
        """Do all that is due at t, which the runs have reached."""
        while self._due[0][0] == t:
            _, kind, k, answer = heappop(self._due)
            if kind == _VALUE:
                self._take(k, t, answer)
                continue
            answer, taken = self._ask(k, t), self._time(k, self._controllers[k].delay / self._controllers[k].period)
            self._counts[k] += 1
            heappush(self._due, (self._time(k, 0.0), _QUESTION, k, None))
            if taken > t:
                heappush(self._due, (taken, _VALUE, k, answer))
            else:
                self._take(k, t, answer)

    def _time(self, k: int, periods: float) -> float:
        """Return the time after so many more periods."""
        return self._start + (self._counts[k] + periods) * self._controllers[k].period


@dataclass(slots=True, eq=False)
class Held:
    """One controller of a run and its history.

    places : indices of its inputs in the model
    times, values : (k,), (k * inputs,) the times of changes, and the values from then on
    """

    places: tuple[int, ...]
    controlled: Controlled
    function: Controller
    times: "array[float]"
    values: "array[float]"

    def ask(self, t: float, x: Vector, v: Vector) -> tuple[float, ...]:
        """Return the values that the function gives."""
        return self.controlled.read(self.function(t, x, v), t)

    def note(self, t: float, values: tuple[float, ...]) -> None:
        """Record that the inputs have values from t on."""
        if t == self.times[-1]:
            del self.values[-len(values) :]
        else:
            self.times.append(t)
        self.values.extend(values)

    @property
    def signals(self) -> tuple[Signal, ...]:
        """The recorded values of each input."""
        rows = np.array(self.values).reshape(-1, len(self.places))
        return tuple(Signal(np.array(self.times), column, "hold") for column in rows.T)


class DrivenRun:
    """An open run and its controllers."""

    def __init__(self, task: Task, method: int) -> None:
        self.task, self.held = opened(task)
        self.run = IncrementalRun(self.task, method)
        self._schedule = Schedule(task.t_start, [one.controlled.sampled for one in self.held], self._ask, self._take)

    def go(self) -> None:
        """Advance the run to its end, and call the controllers when they are due."""
        end = self.task.t_end
        while (t := self._schedule.next) < end:
            if not self.run.advance(t):
                return
            self._schedule.answer(t)
        self.run.advance(end)

    def _ask(self, k: int, t: float) -> tuple[float, ...]:
        return self.held[k].ask(t, *self.run.now())

    def _take(self, k: int, t: float, values: tuple[float, ...]) -> None:
        one = self.held[k]
        for place, value in zip(one.places, values, strict=True):
            self.run.set(place, value)
        one.note(t, values)

    @property
    def as_held(self) -> Task:
        """The task with the recorded inputs as Signals: it gives the same motion without calling the controllers."""
        return with_held(self.task, {one.places: one.signals for one in self.held})


def with_held(task: Task, held: Mapping[tuple[int, ...], Sequence[Signal]]) -> Task:
    """Return a task with recorded inputs, by their indices in the model."""
    signals = list(task.inputs.signals)
    for places, of_one in held.items():
        for place, signal in zip(places, of_one, strict=True):
            signals[place] = signal
    return task._replace(inputs=Inputs(tuple(signals)))


def opened(task: Task) -> tuple[Task, list[Held]]:
    """Return the task with sampled inputs at their first values, and its controllers."""
    names, signals = task.model.inputs, list(task.inputs.signals)
    defaults = dict(zip(names, task.model.input_defaults.tolist(), strict=True))
    held = [_held(one, names, defaults, task.t_start) for one in dict.fromkeys(signals) if isinstance(one, Controlled)]
    for one in held:
        for place, value in zip(one.places, one.values, strict=True):
            signals[place] = value
    return task._replace(inputs=Inputs(tuple(signals))), held


def _held(controlled: Controlled, names: tuple[str, ...], defaults: Mapping[str, float], start: float) -> Held:
    places, before = tuple(names.index(name) for name in controlled.names), controlled.before(defaults)
    return Held(places, controlled, controlled.sampled.controller(), array("d", [start]), array("d", before))
