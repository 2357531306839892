"""Positions, velocities and accelerations of one state or of many, as rows of compiled functions."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ...arguments.named_values import Vector, by_spelling, is_named, unknown, vector
from ...arguments.states import names_of_states
from ...codegen.model.normalise import ModelError
from ...compiled.compiled_system import CompiledSystem
from ...runtime import CompiledModel, Prepared


@dataclass(frozen=True)
class Motion:
    """Rows of a motion. t : (k,); x, v, a : (k, n + p); u : (k, n_inputs); many : whether states have an axis."""

    model: CompiledModel
    prepared: Prepared
    t: Vector
    x: Vector
    v: Vector
    a: Vector
    u: Vector
    many: bool

    def rows(self, which: Any) -> "Motion":
        """Return some of the rows."""
        t, x, v, a, u = (np.ascontiguousarray(rows[which]) for rows in self.arguments[:5])
        return Motion(self.model, self.prepared, t, x, v, a, u, self.many)

    @property
    def arguments(self) -> tuple[Vector, Vector, Vector, Vector, Vector, Prepared]:
        """t, x, v, a, u and the constants."""
        return self.t, self.x, self.v, self.a, self.u, self.prepared

    def moved(self, move: Callable[[Vector], Vector]) -> "Motion":
        """Return the motion with x, v and a changed by a function."""
        return replace(self, x=move(self.x), v=move(self.v), a=move(self.a))

    def in_mode(self, prepared: Prepared) -> "Motion":
        """Return the motion with other constants."""
        return replace(self, prepared=prepared)

    def out(self, rows: Vector) -> Vector:
        """Return rows (k, ...) with the axis of states last, or the only row without that axis."""
        return np.moveaxis(rows, 0, -1) if self.many else rows[0]


def motion_of(system: CompiledSystem, x: Any, v: Any, a: Any, t: Any, parameters: Any, inputs: Any) -> Motion:
    """Return the rows of a user's arguments: arrays (n,) or (n, k), or mappings name -> number or (k,).

    Raises
    ------
    ModelError
        An unknown name, a wrong shape, or a number that is not finite.
    """
    c, n = system.compiled, system.compiled.n_coordinates
    prepared, inputs = system.prepare_both(parameters, inputs)
    names, states = c.coordinates[:n], names_of_states(c)
    q, z = _split(c, x)
    given = {
        "x": _table(q, names, c.initial_x[:n], "x"),
        "z": _table(z, states, c.initial_v[n:], "state of x"),
        "v": _table(v, names, np.zeros(n), "v"),
        "a": _table(a, names, np.zeros(n), "a"),
        "t": vector(t, "t")[None],
        "u": _inputs(system, inputs, vector(t, "t")),
    }
    lengths = {values.shape[1] for values in given.values() if values.ndim > 1}
    if len(lengths - {1}) > 1:
        raise ModelError(f"{c.name}: x, v, a, t and inputs have {', '.join(map(str, sorted(lengths)))} states")
    many, k = bool(lengths), max(lengths, default=1)
    wide = {name: np.broadcast_to(w if w.ndim > 1 else w[:, None], (len(w), k)) for name, w in given.items()}
    for name, values in wide.items():
        if not np.isfinite(values).all():
            raise ModelError(f"{c.name}: {'x' if name == 'z' else name} has a number that is not finite")
    nothing = np.zeros((c.n_states, k))
    pairs = {"x": (wide["x"], nothing), "v": (wide["v"], wide["z"]), "a": (wide["a"], nothing)}
    stacked = {name: np.ascontiguousarray(np.vstack(parts).T) for name, parts in pairs.items()}
    u = np.ascontiguousarray(wide["u"].T)
    return Motion(c, prepared, np.ascontiguousarray(wide["t"][0]), **stacked, u=u, many=many)


def _split(c: CompiledModel, x: Any) -> tuple[Any, Any]:
    """Split x into coordinates and first-order states; None for states that it does not have."""
    if not c.n_states or x is None:
        return x, None
    states = names_of_states(c)
    if not is_named(x):
        values, n = vector(x, "x"), c.n_coordinates
        return (values[:n], values[n:]) if values.ndim and len(values) == c.n else (values, None)
    named = by_spelling(x, "x")
    return tuple({k: w for k, w in named.items() if (k in states) == which} for which in (False, True))  # type: ignore[return-value]


def _table(given: Any, names: tuple[str, ...], defaults: Vector, what: str) -> Vector:
    """Return (n,) or (n, k): an array of that shape, or a mapping over defaults."""
    if given is None:
        return defaults
    if not is_named(given):
        values = vector(given, what)
        if values.ndim not in (1, 2) or len(values) != len(names):
            raise ModelError(
                f"{what} has shape {values.shape}. Give ({len(names)},) or ({len(names)}, k): {', '.join(names)}."
            )
        return values
    return _of_mapping(given, names, defaults, what)


def _of_mapping(given: Mapping[Any, Any], names: tuple[str, ...], defaults: Vector, what: str) -> Vector:
    named = {name: vector(value, f"{what} {name!r}") for name, value in by_spelling(given, what).items()}
    if wrong := named.keys() - set(names):
        raise ModelError(unknown(f"coordinate of {what}", wrong, names))
    shape = np.broadcast_shapes(defaults.shape[1:], *(value.shape for value in named.values()))
    if len(shape) > 1:
        raise ModelError(f"{what}: values of shape {shape}. Give numbers or arrays of one dimension.")
    columns = [named.get(name, default) for name, default in zip(names, defaults, strict=True)]
    return np.array([np.broadcast_to(column, shape) for column in columns])


def _inputs(system: CompiledSystem, inputs: Any, t: Vector) -> Vector:
    """Return u (n_inputs,) or (n_inputs, k)."""
    c = system.compiled
    if inputs is not None and not is_named(inputs):
        return _table(inputs, c.inputs, c.input_defaults, "inputs")
    held = {} if inputs is None else dict(inputs.items())
    arrays = {key: value for key, value in held.items() if isinstance(value, np.ndarray) and value.ndim == 1}
    bound = system.bind({key: value for key, value in held.items() if key not in arrays})
    if bound.sampled:
        raise ModelError(
            f"{c.name}: a Sampled input is known in a run alone. Give its value, or take it for an actuator."
        )
    values = np.moveaxis(bound.at(t), -1, 0)
    return _of_mapping(arrays, c.inputs, values, "input") if arrays else values
