"""Sampled controllers of a run: Python functions that are called once a period; inputs are constant in between."""

from array import array
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from heapq import heappop, heappush
from typing import Any

import numpy as np

from ..arguments.named_values import Vector
from ..arguments.sampled import Controlled, Controller, Sampled
from ..arguments.signals import Inputs, Signal
from ..arguments.tasks import Task
from ..codegen.model.normalise import ModelError
from ..runtime import IncrementalRun

_VALUE, _CALL = 0, 1  # actions that may be due at the same time, in this order


def check_forwards(start: float, end: float) -> None:
    """Raise ModelError for a run backwards in time."""
    if end < start:
        raise ModelError("Sampled inputs are for runs forwards in time: a controller knows the past alone")


class Schedule:
    """Times at which controllers are called, and at which their values take effect after a delay.

    Actions are ordered by time. At equal times a delayed value takes effect before the next call.

    Parameters
    ----------
    call
        Function of the number of a controller and the time; returns the controller's value.
    apply
        Function of the number of a controller, the time and a value; sets the inputs from then on.
    """

    def __init__(
        self, start: float, controllers: Sequence[Sampled], call: Callable[[int, float], Any],
        apply: Callable[[int, float, Any], None],
    ) -> None:  # fmt: skip
        self._start, self._controllers, self._call, self._apply = start, controllers, call, apply
        self._counts = [0] * len(controllers)
        self._due: list[tuple[float, int, int, Any]] = [(start, _CALL, k, None) for k in range(len(controllers))]

    @property
    def next(self) -> float:
        """The time of the next action."""
        return self._due[0][0]

    def act(self, t: float) -> None:
        """Perform all actions that are due at t, which the runs have reached."""
        while self._due[0][0] == t:
            _, kind, k, value = heappop(self._due)
            if kind == _VALUE:
                self._apply(k, t, value)
                continue
            value = self._call(k, t)
            effective = self._time(k, self._controllers[k].delay / self._controllers[k].period)
            self._counts[k] += 1
            heappush(self._due, (self._time(k, 0.0), _CALL, k, None))
            if effective > t:
                heappush(self._due, (effective, _VALUE, k, value))
            else:
                self._apply(k, t, value)

    def _time(self, k: int, periods: float) -> float:
        """Return the time after so many more periods."""
        return self._start + (self._counts[k] + periods) * self._controllers[k].period


@dataclass(slots=True, eq=False)
class ControllerRecord:
    """One controller of a run, and the record of its values.

    places : indices of its inputs in the model
    times, values : (k,), (k * inputs,) the times of changes, and the values from then on
    """

    places: tuple[int, ...]
    controlled: Controlled
    function: Controller
    times: "array[float]"
    values: "array[float]"

    def call(self, t: float, x: Vector, v: Vector) -> tuple[float, ...]:
        """Call the function and return its values."""
        return self.controlled.read(self.function(t, x, v), t)

    def record(self, t: float, values: tuple[float, ...]) -> None:
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


class ControlledRun:
    """An incremental run with its controllers."""

    def __init__(self, task: Task, method: int, other: int = -1) -> None:
        self.task, self.records = open_controllers(task)
        self.run = IncrementalRun(self.task, method, other)
        self._schedule = Schedule(
            task.t_start, [one.controlled.sampled for one in self.records], self._call, self._apply
        )

    def go(self) -> None:
        """Advance the run to its end, and call the controllers when they are due."""
        end = self.task.t_end
        while (t := self._schedule.next) < end:
            if not self.run.advance(t):
                return
            self._schedule.act(t)
        self.run.advance(end)

    def _call(self, k: int, t: float) -> tuple[float, ...]:
        return self.records[k].call(t, *self.run.now())

    def _apply(self, k: int, t: float, values: tuple[float, ...]) -> None:
        one = self.records[k]
        for place, value in zip(one.places, values, strict=True):
            self.run.set(place, value)
        one.record(t, values)

    @property
    def recorded_task(self) -> Task:
        """The task with the recorded inputs as Signals, which gives the same motion without controllers."""
        return with_recorded_inputs(self.task, {one.places: one.signals for one in self.records})


def with_recorded_inputs(task: Task, records: Mapping[tuple[int, ...], Sequence[Signal]]) -> Task:
    """Return a task with recorded inputs; `records`: indices of inputs -> Signals."""
    signals = list(task.inputs.signals)
    for places, of_one in records.items():
        for place, signal in zip(places, of_one, strict=True):
            signals[place] = signal
    return task._replace(inputs=Inputs(tuple(signals)))


def open_controllers(task: Task) -> tuple[Task, list[ControllerRecord]]:
    """Return the task with sampled inputs at their first values, and its controllers."""
    names, signals = task.model.inputs, list(task.inputs.signals)
    defaults = dict(zip(names, task.model.input_defaults.tolist(), strict=True))
    records = [
        _record_of(one, names, defaults, task.t_start) for one in dict.fromkeys(signals) if isinstance(one, Controlled)
    ]
    for one in records:
        for place, value in zip(one.places, one.values, strict=True):
            signals[place] = value
    return task._replace(inputs=Inputs(tuple(signals))), records


def _record_of(
    controlled: Controlled, names: tuple[str, ...], defaults: Mapping[str, float], start: float
) -> ControllerRecord:
    places, before = tuple(names.index(name) for name in controlled.names), controlled.before(defaults)
    return ControllerRecord(
        places, controlled, controlled.sampled.controller(), array("d", [start]), array("d", before)
    )
