"""Arguments of an ensemble, broadcast to K members."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..arguments.named_values import Vector, by_name, by_spelling, is_named, overlay, rate_name, vector
from ..arguments.own_controllers import OwnControllers
from ..arguments.prescribed import with_prescribed
from ..arguments.sampled import Controlled, by_input
from ..arguments.signals import Inputs, as_signal, check_samples
from ..arguments.states import refuse_states, split_states
from ..arguments.tables import with_tables
from ..arguments.tasks import Column, Members
from ..codegen.model.normalise import ModelError, shown
from ..compiled.compiled_system import CompiledSystem
from ..runtime import CompiledModel, EvaluationError, Prepared

Table = dict[str, Vector] | Vector


class _Arguments:
    """Sizes of the arguments of an ensemble, by name, and the number of members that follows from them."""

    def __init__(self) -> None:
        self.sizes: dict[str, int] = {}
        self.swept: dict[str, Vector] = {}

    def numbers(self, value: Any, what: str, label: str) -> Vector:
        """Return a number, or (K,) numbers. Of (K,) numbers some may be infinite or NaN: only those members fail."""
        array = vector(value, what)
        if array.ndim > 1:
            raise ModelError(f"{what} has shape {array.shape}; give a number, or one for each member")
        if array.ndim == 0 and not np.isfinite(array):
            raise ModelError(f"{what} is not a finite number")
        if array.ndim:
            self.note(what, len(array))
            self.swept[label] = array
        return array

    def note(self, what: str, size: int) -> None:
        self.sizes[what] = size

    @property
    def count(self) -> int:
        """K. Arguments of length one fit any K.

        Raises
        ------
        ModelError
            Arguments have different lengths, or one is empty; the message lists the lengths.
        """
        sizes = {size for size in self.sizes.values() if size != 1}
        if 0 in sizes:
            empty = next(what for what, size in self.sizes.items() if size == 0)
            raise ModelError(f"{empty} is empty: an ensemble has at least one member")
        if len(sizes) > 1:
            listed = ", ".join(f"{what}: {size}" for what, size in self.sizes.items())
            raise ModelError(f"members of an ensemble cannot be counted: arrays differ in length ({listed})")
        return sizes.pop() if sizes else 1

    def table(self, argument: Any, names: Sequence[str], defaults: Vector, what: str, mark: str = "") -> Table:
        """Return columns by name, or rows (K or 1, n) for an array (n,) or (K, n)."""
        if argument is None:
            return {}
        if not is_named(argument):
            return self._rows(argument, names, defaults, what, mark)
        named = by_name(argument, names, what)
        return {name: self.numbers(value, f"{what} {name!r}", name + mark) for name, value in named.items()}

    def _rows(self, argument: Any, names: Sequence[str], defaults: Vector, what: str, mark: str) -> Vector:
        array = vector(argument, what)
        if array.ndim != 2:
            return overlay(array, names, defaults, what)[None]
        if array.shape[1] != len(names):
            raise ModelError(
                f"{what}: rows of {array.shape[1]} numbers, but {len(names)} are needed: {', '.join(names)}"
            )
        self.note(what, len(array))
        self.swept |= {name + mark: array[:, k] for k, name in enumerate(names)}
        return array


def _filled(table: Table, names: Sequence[str], defaults: Vector) -> Vector:
    """Return rows (K or 1, n): the columns of the table over the defaults."""
    if not isinstance(table, dict):
        return table
    count = max((column.size for column in table.values()), default=1)
    rows = np.repeat(defaults[None], count, axis=0)
    for name, column in table.items():
        rows[:, list(names).index(name)] = column
    return rows


def gather(system: CompiledSystem, t: float, x0: Any, v0: Any, parameters: Any, inputs: Any) -> Members:
    """Return the members that start at t: mappings name -> number or (K,) array, arrays (n,) or (K, n).

    Raises
    ------
    ModelError
        An unknown name, arrays of different lengths, or a value of all members that is out of range.
    """
    c, arguments = system.compiled, _Arguments()
    if isinstance(parameters, Prepared):
        parameters = np.array(system.prepare(parameters).parameters)
    parameters, inputs = with_prescribed(c, parameters, inputs, several=True)
    p = arguments.table(with_tables(c, parameters, several=True), c.parameters, c.parameter_defaults, "parameter")
    _check_shared(c, p)
    x0, z0 = split_states(c, x0)
    names, n = system.coordinates, system.n
    x = arguments.table(x0, names, c.initial_x[:n], "coordinate of x0", "(0)")
    z = arguments.table(z0, system.states, c.initial_v[n:], "state of x0", "(0)")
    v0 = by_spelling(v0, "v0", rate_name) if is_named(v0) else v0
    quick = _rates(system, v0)
    if isinstance(v0, Mapping):
        refuse_states(c, v0)
    v = arguments.table(v0, names, c.initial_v[:n], "coordinate of v0", "'(0)") if quick else None
    quasi = {} if v is not None or v0 is None else _columns(arguments, v0)
    signals = _signals(system, inputs, arguments)
    count = arguments.count
    P, X = _filled(p, c.parameters, c.parameter_defaults), _filled(x, names, c.initial_x[:n])
    c.check_tables_of(P)
    reasons: dict[int, str] = {}
    own = OwnControllers(count, reasons)
    signals = tuple(own.column(column) for column in signals)
    V = _by_member(system, t, count, P, X, quasi, reasons) if v is None else _filled(v, names, c.initial_v[:n])
    if c.n_states:
        X = np.hstack([X, np.zeros((len(X), c.n_states))])
        V = _beside(V, _filled(z, system.states, c.initial_v[n:]))
    _check_finite(reasons, count, (c.parameters, P, "parameter"), (c.coordinates, X, "x0"), (c.coordinates, V, "v0"))
    refused = np.zeros(count, dtype=np.bool_)
    refused[list(reasons)] = True
    swept = {name: np.broadcast_to(column, count) for name, column in arguments.swept.items() if count > 1}
    return Members(count, P, X, V, signals, refused, reasons, swept)


def _beside(left: Vector, right: Vector) -> Vector:
    """Return the columns of two tables (K or 1, ...) side by side."""
    count = max(len(left), len(right))
    return np.hstack([np.broadcast_to(part, (count, part.shape[1])) for part in (left, right)])


def _check_shared(c: CompiledModel, argument: Table) -> None:
    """Raise EvaluationError if a value of all members contradicts the assumptions of its symbol.

    If members have different values, only the members with a wrong value fail, later.
    """
    if isinstance(argument, dict):
        shared = {name: column for name, column in argument.items() if column.size == 1}
        c.check_parameters(_filled(shared, c.parameters, c.parameter_defaults)[0])
    elif len(argument) == 1:
        c.check_parameters(argument[0])


def _rates(system: CompiledSystem, v0: Any) -> bool:
    """Whether v0 gives rates, which do not depend on the position as quasi-velocities do."""
    if system.compiled.initial_y is None and not isinstance(v0, Mapping):
        return True
    if not isinstance(v0, Mapping):
        return v0 is not None
    if v0.keys() & set(system.quasi_velocities):
        return False
    return system.compiled.initial_y is None or len(v0) == system.n


def _columns(arguments: _Arguments, v0: Any) -> dict[str, Vector]:
    return {name: arguments.numbers(value, f"v0 {name!r}", f"{name}(0)") for name, value in v0.items()}


def _by_member(
    system: CompiledSystem, t: float, count: int, P: Vector, X: Vector, v0: dict[str, Vector], reasons: dict[int, str]
) -> Vector:
    """Return rates (K, n) from quasi-velocities, with P(x, t) of each member; `reasons` gets members without rates."""
    V = np.zeros((count, system.n))
    for k in range(count):
        p, x = P[k if len(P) > 1 else 0], X[k if len(X) > 1 else 0]
        argument = {name: column[k % column.size] if column.ndim else float(column) for name, column in v0.items()}
        try:
            V[k] = system.start(x, argument or None, t, system.prepare(p))[1]
        except (ModelError, EvaluationError) as error:
            if count == 1:
                raise
            reasons[k] = str(error)
    return V


def _check_finite(reasons: dict[int, str], count: int, *tables: tuple[Sequence[str], Vector, str]) -> None:
    for names, rows, what in tables:
        finite = np.isfinite(rows)
        if finite.all():
            continue
        for k, place in np.argwhere(~finite).tolist():
            reasons.setdefault(k, f"{what} {names[place]!r} is not a finite number")
            if len(rows) == 1:
                reasons |= dict.fromkeys(range(count), reasons[k])


def _signals(system: CompiledSystem, inputs: Any, arguments: _Arguments) -> tuple[Column, ...]:
    names, defaults = system.compiled.inputs, system.compiled.input_defaults
    if inputs is None:
        return tuple(defaults.tolist())
    if not is_named(inputs):
        raise ModelError(
            f"inputs is {shown(inputs)}, not a mapping name -> number, array, (times, values), Signal or Sampled"
        )
    named = by_name(by_input(inputs), names, "input")
    columns = tuple(_column(named[name], name, arguments) if name in named else float(default)
                    for name, default in zip(names, defaults, strict=True))  # fmt: skip
    for k, column in enumerate(columns if any(system.compiled.declared) else ()):
        for one in column if isinstance(column, list | np.ndarray) else (column,):
            check_samples(system.compiled, Inputs((*defaults[:k].tolist(), one, *defaults[k + 1 :].tolist())))
    return columns


def _column(argument: Any, name: str, arguments: _Arguments) -> Column:
    """Return one input: a number, a pair, a Signal or a controller for all; a list or an array, one for each member."""
    what = f"input {name!r}"
    if isinstance(argument, Controlled):
        return argument
    if isinstance(argument, list) and any(isinstance(one, tuple | Controlled) or callable(one) for one in argument):
        arguments.note(what, len(argument))
        signals: list[Any] = [one if isinstance(one, Controlled) else as_signal(one, name) for one in argument]
        return signals if len(signals) > 1 else signals[0]
    if isinstance(argument, list | np.ndarray) and np.ndim(argument):
        column = arguments.numbers(argument, what, name)
        if not np.isfinite(column).all():
            raise ModelError(f"{what} of member {int(np.argmin(np.isfinite(column)))} is not a finite number")
        return column if len(column) > 1 else float(column[0])
    return as_signal(argument, name)
