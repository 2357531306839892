"""Inputs u(t) of a run: constants, and samples with zero-order hold, linear or cubic interpolation."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from importlib import import_module
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..codegen.model import Table
from ..codegen.model.normalise import ModelError, number, shown
from ..runtime import CompiledModel
from .named_values import Vector, by_name, is_named, vector
from .sampled import Controlled, by_input

Compiled: TypeAlias = tuple[int, Vector, NDArray[np.float64]]
_KINDS = {"hold": 1, "linear": 2, "cubic": 3, "spline": 3}  # em_signal_kind
_SAMPLED, _SMOOTH = ("hold", "linear", "cubic"), ("cubic", "spline")
_CUBIC = 4
"""Coefficients of a piece of a smooth signal."""


@dataclass(frozen=True, slots=True, eq=False)
class Signal:
    """Samples u(t_k) = u_k and their interpolation, or an interpolant.

    Parameters
    ----------
    times
        (k,) increasing [s]; or in place of samples an interpolant of SciPy: a piecewise polynomial or a spline.
    values
        (k,) [unit of the input]; of an interpolant none.
    kind
        "hold" (the last sample's value), "linear", or "cubic" (the not-a-knot spline); of an interpolant "spline".

    Raises
    ------
    ModelError
        Fewer samples than the kind needs, unequal lengths, times that do not increase, numbers that are not finite, or
        an interpolant that is no piecewise polynomial.

    Examples
    --------
    >>> import eigenmotion as em
    >>> pulse = em.Signal([0.0, 1.0, 2.0], [0.0, 5.0, 0.0], kind="hold")
    >>> pulse([0.5, 1.0, 1.5, 9.0])
    array([0., 5., 5., 0.])
    """

    times: Any
    values: Any = None
    kind: Literal["hold", "linear", "cubic", "spline"] = "linear"
    _fitted: list[Any] = field(init=False, repr=False, default_factory=list)  # the spline, computed at the first call
    _cubics: list[Vector] = field(init=False, repr=False, default_factory=list)  # its coefficients, likewise
    _tables: list[Table] = field(init=False, repr=False, default_factory=list)  # made where one is needed

    def __post_init__(self) -> None:
        if self.values is None:
            self._read_interpolant()
        for name in ("times", "values"):
            numbers = vector(getattr(self, name), f"{name} of a signal")
            numbers.flags.writeable = False  # runs read these arrays without a copy
            object.__setattr__(self, name, numbers)
        times, values = self.times, self.values
        if not isinstance(self.kind, str) or self.kind not in _KINDS:
            raise ModelError(f"a signal's kind is one of {', '.join(_SAMPLED)}, not {shown(self.kind)}")
        if times.ndim != 1 or times.shape != values.shape:
            raise ModelError(f"a signal needs as many values {values.shape} as times {times.shape}, one-dimensional")
        if times.size < (1 if self.kind == "hold" else 2):
            raise ModelError(f"a {self.kind} signal needs more than {times.size} samples")
        if not (np.isfinite(times).all() and np.isfinite(values).all()):
            raise ModelError("a signal's times and values must be finite")
        if not (np.diff(times) > 0).all():
            raise ModelError("a signal's times must increase strictly")

    def _read_interpolant(self) -> None:
        """Take the knots of an interpolant, and the values there, for samples."""
        given = self.times
        if isinstance(given, list | tuple | np.ndarray | Table) or not callable(given):
            raise ModelError(f"Signal({shown(given)}) has no values. Give Signal(times, values), or an interpolant.")
        table = Table(given, name="signal")
        if table.arguments != 1:
            raise ModelError(f"a signal is a function of the time, and {shown(given)} is one of two arguments")
        self._fitted.append(given)
        self._tables.append(table)
        knots = np.array(table.pieces.axes[0].knots)
        for name, value in (("values", [table.pieces.value((0,), (at,)) for at in knots]), ("times", knots),
                            ("kind", "spline")):  # fmt: skip
            object.__setattr__(self, name, value)

    def __call__(self, t: ArrayLike) -> Vector:
        """Return u at times t of any shape. Before the first and after the last sample u is constant, as in runs."""
        times, values = self.times, self.values
        inside = np.clip(t, times[0], times[-1])
        if self.kind == "hold":
            return np.asarray(values[np.searchsorted(times, inside, side="right") - 1])
        if self.kind == "linear":
            return np.asarray(np.interp(inside, times, values))
        return np.asarray(self.interpolant(inside))

    @property
    def interpolant(self) -> Any:
        """The interpolant of SciPy, made once; None of a signal that has no smooth rates: "hold" and "linear"."""
        if self.kind not in _SMOOTH:
            return None
        if not self._fitted:  # SciPy takes a while to import
            self._fitted.append(import_module("scipy.interpolate").CubicSpline(self.times, self.values))
        return self._fitted[0]

    @property
    def table(self) -> Table:
        """The signal as a table of the time, made once. One of kind "hold" jumps, and has none."""
        if not self._tables:
            curve = (self.times, self.values) if self.interpolant is None else self.interpolant
            self._tables.append(Table(curve, name="signal"))
        made: Table = self._tables[0]
        return made

    @property
    def compiled(self) -> Compiled:
        """Return the kind, times and values of the `em_signal`.

        Raises
        ------
        ModelError
            An interpolant that jumps, or whose rate does, or with more than the powers of a cubic.
        """
        if self.kind not in _SMOOTH:
            return _KINDS[self.kind], self.times, self.values
        if not self._cubics:
            self._cubics.append(self.interpolant.c.T.ravel() if self.kind == "cubic" else cubics(self.table))
        return _KINDS[self.kind], self.times, self._cubics[0]

    @property
    def kinks(self) -> Vector:
        """Times at which u or its rate jumps."""
        return np.empty(0) if self.kind in _SMOOTH else self.times


def cubics(table: Table) -> Vector:
    """Return coefficients (4 (k - 1)) of the pieces of a signal, the highest power first."""
    axis = table.pieces.axes[0]
    coefficients = np.array(table.pieces.coefficients).reshape(axis.count, axis.order)
    if axis.order > _CUBIC and coefficients[:, _CUBIC:].any():
        raise ModelError(f"a signal of degree {axis.order - 1} is not taken as an input: cubics are. Write it into the "
                         "model: em.Table(interpolant)(t), which takes any degree.")  # fmt: skip
    if rough := [at for at, order in table.pieces.joins(0) if order < 2]:
        raise ModelError(f"an interpolant that jumps, or whose rate does, at t = {rough[0]:g} is no input. "
                         "Give samples, of kind 'hold' or 'linear', or a table: em.Table(interpolant)(t).")  # fmt: skip
    made = np.zeros((axis.count, _CUBIC))
    made[:, : axis.order] = coefficients[:, :_CUBIC]
    return made[:, ::-1].ravel()


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
            first, last = float(signal.times[0]), float(signal.times[-1])
            if min(start, end) < first or (signal.kind != "hold" and max(start, end) > last):
                return k, f"is sampled on [{first:g}, {last:g}]"
        return None


def check_samples(model: CompiledModel, inputs: Inputs) -> None:
    """Raise EvaluationError if the value of an input contradicts the assumptions of its symbol."""
    for k, signal in enumerate(inputs.signals if any(model.declared) else ()):
        argument = signal.values if isinstance(signal, Signal) else () if isinstance(signal, Controlled) else (signal,)
        u = np.array(model.input_defaults)
        for u[k] in np.asarray(argument, dtype=np.float64):
            model.check_inputs(u)


def bind(argument: Mapping[Any, Any], names: Sequence[str], defaults: Vector) -> Inputs:
    """Return the inputs of a run: name -> number, (times, values) (linear), Signal or Sampled; others have defaults.

    A tuple of names -> a Sampled that sets all of them.

    Raises
    ------
    ModelError
        An unknown name, or a value that is none of these; names it.
    """
    if not is_named(argument):
        raise ModelError(
            f"inputs is {shown(argument)}, not a mapping name -> number, (times, values), Signal or Sampled"
        )
    named = by_name(by_input(argument), names, "input")
    return Inputs(
        tuple(
            argument if isinstance(argument := named.get(name, default), Controlled) else as_signal(argument, name)
            for name, default in zip(names, defaults, strict=True)
        )
    )


def as_signal(argument: Any, name: str) -> float | Signal:
    """Return one input as a number or a Signal: a number, a pair (times, values), a Signal or an interpolant."""
    if isinstance(argument, Controlled):
        raise ModelError(f"input {name!r} is Sampled: only `simulate` and `simulate_ensemble` ask controllers")
    interpolant = callable(argument) and hasattr(argument, "c")  # SciPy's interpolants have coefficients
    if callable(argument) and not isinstance(argument, Signal) and not interpolant:
        raise ModelError(
            f"input {name!r} is a function. Of the time: sample it, as (times, f(times)). Of the state: it is a "
            "controller, em.Sampled(function, period), which is asked with t, x, v."
        )
    if not callable(argument) and not isinstance(argument, tuple | list):
        return number(
            argument, f"input {name!r}: a number, a pair (times, values) or a Signal is needed; what is given"
        )
    if isinstance(argument, tuple | list) and len(argument) != 2:
        raise ModelError(f"input {name!r} is {shown(argument)}: neither a number, a pair (times, values) nor a Signal")
    try:
        if isinstance(argument, Signal):
            signal = argument
        elif interpolant:
            signal = Signal(argument)
        else:
            signal = Signal(*argument)
        _ = signal.compiled  # raises the error of an interpolant that cannot be compiled
    except ModelError as error:
        raise ModelError(f"input {name!r}: {error}") from error
    return signal
