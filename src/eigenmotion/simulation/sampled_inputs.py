"""Sampled controllers of a run: Python functions that are called once a period; inputs are constant in between."""

from dataclasses import dataclass
from heapq import heappop, heappush

from ..arguments.named_values import Vector
from ..arguments.options import Task
from ..arguments.signals import Inputs, Sampled, Signal
from ..codegen.model.normalise import number
from ..runtime import RunInParts

_VALUE, _QUESTION = 0, 1  # actions that may be due at the same time, in this order


@dataclass
class Held:
    """One sampled input of a run: its present value and its history.

    place : of the input in the model
    times, values : (k,) the times of its changes, and the values from then on
    count : the number of calls of its function
    """

    place: int
    name: str
    sampled: Sampled
    times: list[float]
    values: list[float]
    count: int = 0

    def ask(self, t: float, x: Vector, v: Vector) -> float:
        """Return the value that the function gives."""
        said = self.sampled.function(t, x, v)
        return number(said, f"input {self.name!r} at t = {t:.9g}: a number is needed; what its function returned")

    def time(self, start: float, periods: float) -> float:
        """Return the time after so many more periods."""
        return start + (self.count + periods) * self.sampled.period

    def note(self, t: float, value: float) -> None:
        """Record that the input has a value from t on."""
        if t == self.times[-1]:
            self.values[-1] = value
        else:
            self.times.append(t)
            self.values.append(value)


def opened(task: Task) -> tuple[Task, list[Held]]:
    """Return the task with sampled inputs at their first values, and the sampled inputs."""
    signals, held = list(task.inputs.signals), []
    for k, signal in enumerate(signals):
        if isinstance(signal, Sampled):
            signals[k] = first = signal.before(float(task.model.input_defaults[k]))
            held.append(Held(k, task.model.inputs[k], signal, [task.t_start], [first]))
    return task._replace(inputs=Inputs(tuple(signals))), held


def as_held(task: Task, held: list[Held]) -> Task:
    """Return the task with the recorded inputs as Signals: it gives the same motion without calling the controller."""
    signals = list(task.inputs.signals)
    for one in held:
        signals[one.place] = Signal(one.times, one.values, "hold")
    return task._replace(inputs=Inputs(tuple(signals)))


def drive(run: RunInParts, task: Task, held: list[Held]) -> None:
    """Advance an open run to its end, and call the controllers when they are due.

    Actions are ordered by time. At equal times a delayed value takes effect before the next call.
    """
    start = task.t_start
    due = [(start, _QUESTION, k, 0.0) for k in range(len(held))]
    while due[0][0] < task.t_end:
        t, kind, k, value = heappop(due)
        if not run.advance(t):
            return
        one = held[k]
        if kind == _QUESTION:
            value = one.ask(t, *run.now())
            taken = one.time(start, one.sampled.delay / one.sampled.period)
            one.count += 1
            heappush(due, (one.time(start, 0.0), _QUESTION, k, 0.0))
            if taken > t:
                heappush(due, (taken, _VALUE, k, value))
                continue
        run.set(one.place, value)
        one.note(t, value)
    run.advance(task.t_end)
