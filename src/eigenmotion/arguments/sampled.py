"""Sampled controllers: functions that a run calls once a period to set inputs."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from inspect import signature
from math import isfinite
from typing import Any, TypeAlias, cast

from ..codegen.model.normalise import ModelError, number, shown
from .named_values import Vector, spelled

Controller: TypeAlias = Callable[[float, Vector, Vector], Any]


@dataclass(frozen=True, slots=True, eq=False)
class Sampled:
    """A sampled controller: a function that computes an input once every period; the input is constant in between.

    `inputs={"u": Sampled(...)}` is for one input, `inputs={("u1", "u2"): Sampled(...)}` for several, all of which one
    call per period sets.

    **In an ensemble each run has its own controller**: `make` is called once for each run; a callable object, or a
    method of an object, is copied for each run by `copy.deepcopy`. All runs share a plain function, so it must not have
    state: if something that it refers to changes (a variable of an enclosing function, a global, a default), the
    ensemble raises an error that names it.

    Parameters
    ----------
    function
        Called as function(t, x, v), x and v (n,) new arrays, at the start and then every period; returns a number, or
        for several inputs a sequence with one number for each.
    period
        [s]
    delay
        [s] between the call and the time at which its value takes effect, at most the period.
    initial
        The value before the first one takes effect, or a sequence for several inputs; None: the model's default.
    make
        Instead of function: called without arguments, it returns a new function for each run.

    Raises
    ------
    ModelError
        The function cannot be called with (t, x, v), or names these arguments in another order; or a number is out of
        range.

    Examples
    --------
    >>> import eigenmotion as em
    >>> em.Sampled(lambda t, x, v: -2.0 * v[0], period=0.01, delay=0.01).delay
    0.01
    """

    function: Controller | None = None
    period: float = 0.0
    delay: float = 0.0
    initial: float | Sequence[float] | None = None
    make: Callable[[], Controller] | None = None

    def __post_init__(self) -> None:
        if (self.function is None) == (self.make is None):
            raise ModelError("a Sampled input needs a function, or make=, which returns one for each run: one of them")
        for name in ("function", "make"):
            argument = getattr(self, name)
            if argument is not None and not callable(argument):
                raise ModelError(f"the {name} of a Sampled input is {shown(argument)}, which cannot be called")
        if self.function is not None:
            _check_arguments(self.function)
        for name in ("period", "delay"):
            object.__setattr__(self, name, number(getattr(self, name), f"the {name} of a Sampled input"))
        if not self.period > 0:
            raise ModelError(f"the period of a Sampled input is {self.period}, but must be above 0")
        if not 0 <= self.delay <= self.period:
            raise ModelError(
                f"the delay of a Sampled input is {self.delay}, but must be from 0 to its period, {self.period}"
            )
        if self.initial is not None:
            object.__setattr__(self, "initial", _initial(self.initial))

    def controller(self) -> Controller:
        """Return the function of a run: the return value of `make`, or `function`.

        Raises
        ------
        ModelError
            The return value of `make` cannot be called.
        """
        if self.make is None:
            assert self.function is not None
            return self.function
        function = self.make()
        if not callable(function):
            raise ModelError(f"make of a Sampled input returned {shown(function)}, which cannot be called")
        _check_arguments(function)
        return function


def _check_arguments(function: Controller) -> None:
    """Raise ModelError if a function cannot be called with (t, x, v), or has these names in another order."""
    try:
        taken = signature(function)
    except (TypeError, ValueError):  # of some compiled functions
        return
    try:
        names = tuple(taken.bind(0.0, 0.0, 0.0).arguments)
    except TypeError:
        names = tuple(taken.parameters)
    else:
        if sorted(names) != ["t", "v", "x"] or names == ("t", "x", "v"):
            return
    name = getattr(function, "__name__", shown(function))
    raise ModelError(f"the function of a Sampled input is called with (t, x, v), but {name} takes ({', '.join(names)})")


def _initial(argument: Any) -> float | tuple[float, ...]:
    what = "the initial value of a Sampled input"
    values = listed(argument)
    return number(argument, what) if values is None else tuple(number(value, what) for value in values)


def listed(argument: Any) -> list[Any] | None:
    """Return the items of a list, a tuple or an array of one axis; None of anything else."""
    if isinstance(argument, list | tuple):
        return list(argument)
    if getattr(argument, "ndim", 0) == 1 and hasattr(argument, "tolist"):
        return list(argument.tolist())
    return None


@dataclass(frozen=True, slots=True, eq=False)
class Controlled:
    """A controller with the names of its inputs; it takes the place of each of these inputs.

    names : the inputs in the order of its values
    several : whether it returns a sequence
    shared : names of objects to which its function and those of other members of an ensemble refer
    """

    sampled: Sampled
    names: tuple[str, ...]
    several: bool
    shared: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        initial = self.sampled.initial
        if initial is None:
            return
        argument = len(initial) if isinstance(initial, tuple) else None
        if argument != (len(self.names) if self.several else None):
            raise ModelError(f"{self}: initial is {shown(initial)}, but must be {self._needed}")

    def __str__(self) -> str:
        return f"input{'s' if len(self.names) > 1 else ''} {', '.join(map(repr, self.names))}"

    @property
    def _needed(self) -> str:
        return f"a sequence of {len(self.names)} numbers" if self.several else "a number"

    def before(self, defaults: Mapping[str, float]) -> tuple[float, ...]:
        """Return the values before the first ones of the function take effect."""
        initial = self.sampled.initial
        if initial is None:
            return tuple(defaults[name] for name in self.names)
        return initial if isinstance(initial, tuple) else (cast("float", initial),)

    def read(self, returned: Any, t: float) -> tuple[float, ...]:
        """Return the value that the function returned as one number for each input.

        Raises
        ------
        ModelError
            The value has another form; names the time and the inputs.
        """
        if type(returned) is float and isfinite(returned) and not self.several:
            return (returned,)
        values = listed(returned) if self.several else [returned]
        if values is None or len(values) != len(self.names):
            raise ModelError(f"{self} at t = {t:.9g}: {self._needed} is needed; what their function returned is "
                             f"{shown(returned)}")  # fmt: skip
        return tuple(
            number(value, f"input {name!r} at t = {t:.9g}: a number is needed; what its function returned")
            for name, value in zip(self.names, values, strict=True)
        )


def by_input(argument: Mapping[Any, Any]) -> dict[Any, Any]:
    """Return the value of each input; a Sampled, for one name or a tuple of names, becomes a Controlled.

    Raises
    ------
    ModelError
        An input is given twice, or a tuple of names has a value that is not a Sampled.
    """
    values_by_input: dict[Any, Any] = {}
    for keys, value in _parts(argument):
        for key in keys:
            if key in values_by_input:
                raise ModelError(f"input {spelled(key)!r} is given twice: alone and among several, or in two tuples")
            values_by_input[key] = value
    return values_by_input


def _parts(argument: Mapping[Any, Any]) -> Iterator[tuple[tuple[Any, ...], Any]]:
    for key, value in argument.items():
        several = isinstance(key, tuple)
        keys = key if several else (key,)
        if not keys:
            raise ModelError("inputs: a tuple of no names")
        yield keys, _controlled(value, tuple(map(spelled, keys)), several=several)


def _controlled(argument: Any, names: tuple[str, ...], *, several: bool) -> Any:
    if isinstance(argument, Sampled):
        return Controlled(argument, names, several)
    if isinstance(argument, list) and (several or any(isinstance(one, Sampled) for one in argument)):
        return [_controlled(one, names, several=several) for one in argument]
    if several:
        raise ModelError(
            f"inputs {', '.join(map(repr, names))} are given {shown(argument)} at once: give them a Sampled, whose "
            "function returns a number for each, or each a value of its own"
        )
    return argument
