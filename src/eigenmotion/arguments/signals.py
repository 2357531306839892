"""Inputs u(t) of a run: constants, and samples with zero-order hold, linear or cubic interpolation."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from importlib import import_module
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..codegen.model.normalise import ModelError, number, shown
from ..runtime import CompiledModel
from .named_values import Vector, by_name, is_named, vector
from .sampled import Controlled, by_input

Compiled: TypeAlias = tuple[int, Vector, NDArray[np.float64]]
_KINDS = {"hold": 1, "linear": 2, "cubic": 3}  # em_signal_kind


@dataclass(frozen=True, slots=True, eq=False)
class Signal:
    """Samples u(t_k) = u_k and their interpolation.

    Parameters
    ----------
    times
        (k,) increasing [s].
    values
        (k,) [unit of the input].
    kind
        "hold" (the last sample's value), "linear", or "cubic" (the not-a-knot spline).

    Raises
    ------
    ModelError
        Fewer samples than the kind needs, unequal lengths, times that do not increase, or numbers that are not finite.

    Examples
    --------
    >>> import eigenmotion as em
    >>> pulse = em.Signal([0.0, 1.0, 2.0], [0.0, 5.0, 0.0], kind="hold")
    >>> pulse([0.5, 1.0, 1.5, 9.0])
    array([0., 5., 5., 0.])
    """

    times: ArrayLike
    values: ArrayLike
    kind: Literal["hold", "linear", "cubic"] = "linear"
    _fitted: list[tuple[Any, Vector]] = field(
        init=False, repr=False, default_factory=list
    )  # the spline, computed at the first call

    def __post_init__(self) -> None:
        for name in ("times", "values"):
            numbers = vector(getattr(self, name), f"{name} of a signal")
            numbers.flags.writeable = False  # runs read these arrays without a copy
            object.__setattr__(self, name, numbers)
        times, values = np.asarray(self.times), np.asarray(self.values)
        if not isinstance(self.kind, str) or self.kind not in _KINDS:
            raise ModelError(f"a signal's kind is one of {', '.join(_KINDS)}, not {shown(self.kind)}")
        if times.ndim != 1 or times.shape != values.shape:
            raise ModelError(f"a signal needs as many values {values.shape} as times {times.shape}, one-dimensional")
        if times.size < (1 if self.kind == "hold" else 2):
            raise ModelError(f"a {self.kind} signal needs more than {times.size} samples")
        if not (np.isfinite(times).all() and np.isfinite(values).all()):
            raise ModelError("a signal's times and values must be finite")
        if not (np.diff(times) > 0).all():
            raise ModelError("a signal's times must increase strictly")

    def __call__(self, t: ArrayLike) -> Vector:
        """Return u at times t of any shape. Before the first and after the last sample u is constant, as in runs."""
        times, values = np.asarray(self.times), np.asarray(self.values)
        inside = np.clip(t, times[0], times[-1])
        if self.kind == "hold":
            return np.asarray(values[np.searchsorted(times, inside, side="right") - 1])
        if self.kind == "linear":
            return np.asarray(np.interp(inside, times, values))
        return np.asarray(self._spline[0](inside))

    @property
    def compiled(self) -> Compiled:
        """The kind, times and values of the `em_signal`."""
        times, values = np.asarray(self.times), np.asarray(self.values)
        if self.kind == "cubic":  # (k - 1, 4), highest power first, time from the left sample on
            values = self._spline[1]
        return _KINDS[self.kind], times, values

    @property
    def _spline(self) -> tuple[Any, Vector]:
        """The not-a-knot spline and its coefficients, computed once; scipy.interpolate is imported only if needed."""
        if not self._fitted:
            spline = import_module("scipy.interpolate").CubicSpline(np.asarray(self.times), np.asarray(self.values))
            self._fitted.append((spline, spline.c.T.ravel()))
        return self._fitted[0]

    @property
    def kinks(self) -> Vector:
        """Times at which u or its rate jumps."""
        return np.empty(0) if self.kind == "cubic" else np.asarray(self.times)


@dataclass(frozen=True, eq=False)
class Inputs:
    """The inputs of one run, in the model's order."""

    signals: tuple[float | Signal | Controlled, ...]

    @cached_property
    def compiled(self) -> tuple[Compiled, ...]:
        """One `em_signal` for each input; inputs with a controller have no values outside a run."""
        return tuple(
            signal.compiled if isinstance(signal, Signal) else (0, np.empty(0), np.array([signal]))
            for signal in self.signals
        )

    @cached_property
    def sampled(self) -> bool:
        """Whether some inputs are sampled controllers."""
        return any(isinstance(signal, Controlled) for signal in self.signals)

    @property
    def constant(self) -> bool:
        """Whether no input depends on time."""
        return not any(isinstance(signal, Signal) for signal in self.signals)

    def at(self, t: ArrayLike) -> Vector:
        """Return u at times t: (..., n_inputs); NaN for inputs with a controller."""
        columns = [
            signal(t) if isinstance(signal, Signal)
            else np.full(np.shape(t), np.nan if isinstance(signal, Controlled) else signal)
            for signal in self.signals
        ]  # fmt: skip
        return np.stack(columns, axis=-1) if columns else np.empty((*np.shape(t), 0))

    def kinks(self, start: float, end: float) -> Vector:
        """Return the times strictly between start and end, increasing, at which an input or its rate jumps."""
        times = np.concatenate([np.empty(0), *(s.kinks for s in self.signals if isinstance(s, Signal))])
        return np.unique(times[(times > min(start, end)) & (times < max(start, end))])

    def uncovered(self, start: float, end: float) -> tuple[int, str] | None:
        """Return the first input whose samples do not cover the span, and a message. A held sample lasts forever."""
        for k, signal in enumerate(self.signals):
            if not isinstance(signal, Signal):
                continue
            first, last = float(np.asarray(signal.times)[0]), float(np.asarray(signal.times)[-1])
            if min(start, end) < first or (signal.kind != "hold" and max(start, end) > last):
                return k, f"is sampled on [{first:g}, {last:g}]"
        return None


def check_samples(model: CompiledModel, inputs: Inputs) -> None:
    """Raise EvaluationError if the value of an input contradicts the assumptions of its symbol."""
    for k, signal in enumerate(inputs.signals if any(model.declared) else ()):
        given = signal.values if isinstance(signal, Signal) else () if isinstance(signal, Controlled) else (signal,)
        u = np.array(model.input_defaults)
        for u[k] in np.asarray(given, dtype=np.float64):
            model.check_inputs(u)


def bind(given: Mapping[Any, Any], names: Sequence[str], defaults: Vector) -> Inputs:
    """Return the inputs of a run: name -> number, (times, values) (linear), Signal or Sampled; others have defaults.

    A tuple of names -> a Sampled that sets all of them.

    Raises
    ------
    ModelError
        An unknown name, or a value that is none of these; names it.
    """
    if not is_named(given):
        raise ModelError(f"inputs is {shown(given)}, not a mapping name -> number, (times, values), Signal or Sampled")
    named = by_name(by_input(given), names, "input")
    return Inputs(
        tuple(
            given if isinstance(given := named.get(name, default), Controlled) else as_signal(given, name)
            for name, default in zip(names, defaults, strict=True)
        )
    )


def as_signal(given: Any, name: str) -> float | Signal:
    """Return one input as a number or a Signal: a number, a pair (times, values) or a Signal."""
    if isinstance(given, Signal):
        return given
    if isinstance(given, Controlled):
        raise ModelError(f"input {name!r} is Sampled: only `simulate` and `simulate_ensemble` ask controllers")
    if callable(given):
        raise ModelError(
            f"input {name!r} is a function. Of the time: sample it, as (times, f(times)). Of the state: it is a "
            "controller, em.Sampled(function, period), which is asked with t, x, v."
        )
    if not isinstance(given, tuple | list):
        return number(given, f"input {name!r}: a number, a pair (times, values) or a Signal is needed; what is given")
    if len(given) != 2:
        raise ModelError(f"input {name!r} is {shown(given)}: neither a number, a pair (times, values) nor a Signal")
    try:
        return Signal(*given)
    except ModelError as error:
        raise ModelError(f"input {name!r}: {error}") from error
