"""Parts of an environment, checked: actions, observations, rewards and starts."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arguments.named_values import Vector, by_name, spelled, unknown
from ..codegen.model import ModelError
from ..codegen.model.normalise import real, shown

if TYPE_CHECKING:
    from ..batch.stepper.steppers import Steppers
    from ..system.system import System

Reward = Callable[[Vector, Vector], Any]
"""Function of the observations (K, d) after a step and the actions (K, a) of it: rewards (K,)."""
Start = Callable[[np.random.Generator], Mapping[str, Mapping[Any, float]]]
"""Function of a generator of random numbers: {"x0": ..., "v0": ..., "parameters": ...}, numbers by name.

What it leaves out is that of the batch: the options x0, v0 and parameters, and the model's start where there are none.
"""

PARTS = ("x0", "v0", "parameters")


@dataclass(frozen=True, slots=True)
class Actions:
    """The inputs that are actions, with their bounds.

    columns : (a,) their places among the inputs of the model
    low, high : (a,)
    """

    names: tuple[str, ...]
    columns: tuple[int, ...]
    low: Vector
    high: Vector


@dataclass(frozen=True, slots=True)
class Observations:
    """What is observed: numbers by name.

    places : (d,) their places among coordinates, rates, states and outputs
    outputs : whether an output is among them
    """

    names: tuple[str, ...]
    places: tuple[int, ...]
    outputs: bool

    def of(self, steppers: "Steppers") -> Vector:
        """Return (K, d) new numbers of the present states."""
        parts = [steppers.x, steppers.v, *(column[:, None] for column in steppers.states.values())]
        if self.outputs:
            parts += [column[:, None] for column in steppers.outputs.values()]
        return np.hstack(parts)[:, self.places]


def actions_of(system: "System", bounds: Mapping[Any, Any]) -> Actions:
    """Return the actions of a mapping name of an input -> (low, high).

    Raises
    ------
    ModelError
        There is none, a name is that of no input, or bounds are not two finite numbers in increasing order.
    """
    if not isinstance(bounds, Mapping) or not bounds:
        raise ModelError(f"actions= is {shown(bounds)}: give bounds by name of an input, as {{'u': (-1.0, 1.0)}}")
    inputs = tuple(system.inputs)
    named = by_name(bounds, inputs, "input of actions")
    pairs = {name: _bounds(name, pair) for name, pair in named.items()}
    low, high = (np.array([pair[k] for pair in pairs.values()]) for k in (0, 1))
    return Actions(tuple(pairs), tuple(inputs.index(name) for name in pairs), low, high)


def _bounds(name: str, pair: Any) -> tuple[float, float]:
    if not isinstance(pair, tuple | list) or len(pair) != 2:
        raise ModelError(f"actions: the bounds of {name} are {shown(pair)}, but must be two numbers (low, high)")
    low, high = (real(one, f"a bound of {name}") for one in pair)
    if not low < high:
        raise ModelError(f"actions: the bounds of {name} are {low} and {high}, but must increase")
    return low, high


def observations_of(system: "System", names: Iterable[Any] | None) -> Observations:
    """Return the observations: coordinates, rates such as theta', states and outputs by name; None: all but outputs.

    Raises
    ------
    ModelError
        There is none, or a name is unknown or given twice.
    """
    moving = (*system.coordinates, *(f"{name}'" for name in system.coordinates), *system.states)
    known = (*moving, *system.outputs)
    chosen = (
        moving if names is None else tuple(spelled(name) for name in ([names] if isinstance(names, str) else names))
    )
    if wrong := set(chosen) - set(known):
        raise ModelError(f"observations: {unknown('number', wrong, known)}")
    if not chosen or len(set(chosen)) < len(chosen):
        raise ModelError(f"observations are {shown(chosen)}: give names, each once")
    return Observations(chosen, tuple(map(known.index, chosen)), any(name in system.outputs for name in chosen))


def rewards_of(system: "System", reward: Reward | str) -> Reward | str:
    """Return the reward: a function, or the name of an output.

    Raises
    ------
    ModelError
        It is neither.
    """
    if callable(reward):
        return reward
    name = spelled(reward)
    if name not in system.outputs:
        raise ModelError(f"reward: {unknown('output', [name], tuple(system.outputs))} Or give a function")
    return name


class Starts:
    """Starts of K environments: columns (K,) by name, which a function draws anew at each reset."""

    def __init__(self, system: "System", steppers: "Steppers", start: Start | None) -> None:
        n, opened = len(system.coordinates), steppers.starts
        names: tuple[tuple[str, ...], ...] = (
            (*system.coordinates, *system.states), tuple(system.coordinates), tuple(system.parameters),
        )  # fmt: skip
        self._draw, self._name = start, system.name
        self._defaults = [
            np.hstack([opened.x[:, :n], opened.v[:, n:]]).T, opened.v[:, :n].T, opened.parameters.T,
        ]  # fmt: skip
        self._tables = [default.copy() for default in self._defaults]
        self.columns = {
            part: dict(zip(named, table, strict=True))
            for part, named, table in zip(PARTS, names, self._tables, strict=True)
        }

    def draw(self, k: int, random: np.random.Generator) -> None:
        """Draw the start of environment k; what the function leaves out is that of the batch again.

        Raises
        ------
        ModelError
            The function returned no mapping of this form, or an unknown name.
        """
        if self._draw is None:
            return
        drawn = self._draw(random)
        if not isinstance(drawn, Mapping) or set(drawn) - set(PARTS):
            raise ModelError(f"{self._name}: start() returned {shown(drawn)}: return numbers by name in a mapping with "
                             f"the keys {', '.join(PARTS)}")  # fmt: skip
        for table, default in zip(self._tables, self._defaults, strict=True):
            table[:, k] = default[:, k]
        for part, numbers in drawn.items():
            columns, what = self.columns[part], f"start()[{part!r}]"
            if not isinstance(numbers, Mapping):
                raise ModelError(f"{self._name}: {what} is {shown(numbers)}: return numbers by name")
            for name, value in by_name(numbers, tuple(columns), f"number of {what}").items():
                columns[name][k] = number = real(value, f"{self._name}: {name} of {what}")
                if not np.isfinite(number):
                    raise ModelError(f"{self._name}: {name} of {what} is {number}, but must be a finite number")
