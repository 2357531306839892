"""A motion as a function of numbers: rows of runs, and products of their derivatives with vectors, for many at once."""

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...arguments.differentiation import differentiated, rates_of, variable_name
from ...arguments.named_values import Vector, by_spelling, is_named, rate_name, unknown, vector
from ...arguments.options import is_system, rows_at, span
from ...arguments.states import names_of_states
from ...batch.simulate_ensemble import simulate_ensemble
from ...codegen.model.normalise import ModelError, shown
from ...compiled.compiled_system import CompiledSystem
from ...cores import cores
from ...results.ensemble import Ensemble
from ...results.solution import Solution
from ...runtime import EvaluationError
from ...simulation.derivable_run import derivable_run
from ...simulation.simulate import refused, simulate
from ..fitting.measurements import predictions
from ..fitting.starts import argument_columns
from .vjp import pulled

PARTS = ("x", "v", "states", "outputs")
"""Parts of a motion, in the order of the documentation."""
_OPTIONS = (
    *("x0", "v0", "parameters", "inputs", "method", "rtol", "atol", "first_step", "max_step", "max_steps"),
    *("stabilisation", "dependent_constraints"),
)


@dataclass(frozen=True, eq=False)
class MotionMap:
    """The rows of a motion by the values of names: rows = f(values), of K motions at once.

    A row of values is (names,); a row of results holds the parts one after another, each (its names, times).

    names : of parameters, inputs and initial values, as in `sensitivities`
    parts : part -> names in it
    times : (nt,)
    options : of `simulate`, without those in `fixed`
    fixed : x0, v0, parameters, inputs -> name -> value, of what does not vary
    """

    system: CompiledSystem
    t_span: tuple[float, float]
    names: tuple[str, ...]
    parts: Mapping[str, tuple[str, ...]]
    times: Vector
    options: Mapping[str, Any]
    fixed: Mapping[str, Mapping[str, Any] | None]
    memory: float

    @property
    def size(self) -> int:
        """The length of a row of results."""
        return sum(map(len, self.parts.values())) * len(self.times)

    def arranged(self, rows: Any) -> dict[str, Any]:
        """Return rows (..., size) of any library as x, v (..., n, nt), and states, outputs: name -> (..., nt)."""
        made, first, nt = dict[str, Any](), 0, len(self.times)
        for part, names in self.parts.items():
            last = first + len(names) * nt
            block = rows[..., first:last].reshape(*rows.shape[:-1], len(names), nt)
            made[part] = block if part in ("x", "v") else {name: block[..., k, :] for k, name in enumerate(names)}
            first = last
        return made

    def product(self, kind: str, *arrays: Any) -> Vector:
        """Return `values`, `push` or `pull` of arrays (..., length), whose leading axes are broadcast."""
        given = [np.asarray(one, dtype=float) for one in arrays]
        leading = np.broadcast_shapes(*(one.shape[:-1] for one in given))
        flat = [np.broadcast_to(one, (*leading, one.shape[-1])).reshape(-1, one.shape[-1]) for one in given]
        result: Vector = getattr(self, kind)(*flat)
        return result.reshape(*leading, result.shape[-1])

    def length(self, kind: str) -> int:
        """Return the last axis of a result of `product`."""
        return len(self.names) if kind == "pull" else self.size

    def values(self, P: Vector) -> Vector:
        """Return rows (K, size) at values (K, names): one run, or one ensemble.

        Raises
        ------
        ModelError
            A run cannot start, fails or ends early: its reason, and which one it is.
        """
        if len(P) == 1:
            run = simulate(self.system, self.t_span, t_eval=self.times, **self._arguments(P[0]))
            self._check_whole(run)
            return self._rows(run)[None]
        if not len(P):
            return np.empty((0, self.size))
        runs = simulate_ensemble(self.system, self.t_span, t_eval=self.times, **self._arguments(P.T))
        for k in map(int, np.flatnonzero(~runs.success | np.isnan(runs.y).any(axis=(1, 2)))[:1]):
            raise self._failed(runs.message(k), k, len(P), bool(runs.success[k]))
        return self._rows(runs)

    def push(self, P: Vector, D: Vector) -> Vector:
        """Return derivatives (K, size) of rows at values (K, names) along directions (K, names), by sensitivities."""
        made = np.empty((len(P), self.size))

        def work(at: Vector, which: list[int]) -> None:
            made[which] = D[which] @ self._jacobian(at).T

        self._each(P, work)
        return made

    def pull(self, P: Vector, W: Vector) -> Vector:
        """Return gradients (K, names) at values (K, names) for cotangents (K, size), by the adjoint."""
        made = np.empty(P.shape)

        def work(at: Vector, which: list[int]) -> None:
            run = derivable_run(
                "vjp", self.system, self.t_span, self.names, self.memory, t_eval=self.times, **self._arguments(at)
            )
            self._check_whole(run.solution)
            for k in which:
                W_k = self.arranged(W[k])
                made[k] = pulled(run, W_k.get("x"), W_k.get("v"), W_k.get("states"), W_k.get("outputs"))

        self._each(P, work)
        return made

    def _jacobian(self, at: Vector) -> Vector:
        """Return derivatives (size, names) of a row by the values."""
        c = self.system.compiled
        run = simulate(self.system, self.t_span, t_eval=self.times, sensitivities=self.names, **self._arguments(at))
        self._check_whole(run)
        moved = [run.sensitivity[name] for name in self.names]
        Z = np.stack([np.vstack([s.dx, np.zeros_like(s.dz), s.dv, s.dz]) for s in moved], axis=-1)
        quantities = tuple(name for names in self.parts.values() for name in names)
        found = predictions(c, quantities, run, Z, argument_columns(c, self.names))
        return np.concatenate([slopes for _, slopes in found])

    def _each(self, P: Vector, work: Callable[[Vector, list[int]], None]) -> None:
        """Call `work` once for each different row of P, with the places where it is, in threads."""
        places: dict[bytes, list[int]] = {}
        for k, row in enumerate(P):
            places.setdefault(row.tobytes(), []).append(k)

        def one(which: list[int]) -> None:
            try:
                work(P[which[0]], which)
            except (ModelError, EvaluationError) as error:
                if len(places) == 1:
                    raise
                raise self._failed(str(error), which[0], len(P)) from error

        if len(places) == 1:
            one(*places.values())
        elif places:
            with ThreadPoolExecutor(min(cores(), len(places))) as pool:
                list(pool.map(one, places.values()))

    def _arguments(self, values: Vector) -> dict[str, Any]:
        """Return options of `simulate`, or of `simulate_ensemble`, for values (names,) or (names, K)."""
        c, given = self.system.compiled, dict(zip(self.names, values, strict=True))
        start = {name: value for name, value in given.items() if name in c.coordinates}
        parameters = {name: value for name, value in given.items() if name in c.parameters}
        inputs = {name: value for name, value in given.items() if name in c.inputs}
        rest = given.keys() - start.keys() - parameters.keys() - inputs.keys()
        rates = {name.removesuffix("'"): value for name, value in given.items() if name in rest}
        varied = {"x0": start, "v0": rates, "parameters": parameters, "inputs": inputs}
        return dict(self.options) | {
            key: dict(self.fixed[key] or {}) | more if more else self.fixed[key] for key, more in varied.items()
        }

    def _rows(self, run: Solution | Ensemble) -> Vector:
        """Return rows (size,) of a run, or (K, size) of an ensemble."""
        arrays: dict[str, Any] = {}
        for part, names in self.parts.items():
            found = getattr(run, part)
            arrays[part] = found if part in ("x", "v") else [found[name] for name in names]
        blocks = [
            np.asarray(array) if part in ("x", "v") else np.stack(array, axis=-2)
            for part, array in arrays.items()
            if self.parts[part]
        ]
        rows = np.concatenate(blocks, axis=-2)
        return np.ascontiguousarray(rows.reshape(*rows.shape[:-2], -1))

    def _check_whole(self, run: Solution) -> None:
        if not run.success or len(run.t) != len(self.times):
            raise self._failed(run.message, success=run.success)

    def _failed(self, message: str, k: int = 0, count: int = 1, success: bool = False) -> ModelError:
        """Return the error of a run, the k-th of several, that failed, or that an event ended early."""
        which = f"motion {k} (of 0 to {count - 1}): " if count > 1 else ""
        early = f"the run ended before its last row, at t = {self.times[-1]:.6g}. " if success else ""
        return ModelError(f"{self.system.name}: {which}{early}{message.removeprefix(f'{self.system.name}: ')}")


def motion_map(
    call: str, system: CompiledSystem, t_span: tuple[float, float], t_eval: ArrayLike, by: Sequence[Any],
    of: Sequence[str], memory: float, options: Mapping[str, Any],
) -> MotionMap:  # fmt: skip
    """Return the map of a motion, as `to_jax` and `to_torch` are told; `call` is the one that messages name.

    Raises
    ------
    ModelError
        An unknown name, part or option; times outside the span.
    """
    if not is_system(system) or options.keys() - set(_OPTIONS):
        wrong = {name: value for name, value in options.items() if name not in _OPTIONS}
        raise refused(call, system, (), wrong, (*_OPTIONS, "by", "of", "memory"))
    c, (start, end) = system.compiled, span(t_span)
    times = rows_at(t_eval, start, end)
    if times is None or not len(times):
        raise ModelError(f"{call}: t_eval is {shown(t_eval)}; give the times of the rows, whose number shapes need")
    names = differentiated(c, by, options.get("v0"), "by").names
    if not names:
        raise ModelError(f"{call}: by is empty; name parameters, inputs or initial values")
    fixed = {
        "x0": _named(options.get("x0"), c.coordinates, "x0"), "v0": _named(options.get("v0"), c.coordinates, "v0"),
        "parameters": _named(options.get("parameters"), c.parameters, "parameters"), "inputs": options.get("inputs"),
    }  # fmt: skip
    others = {name: value for name, value in options.items() if name not in fixed}
    return MotionMap(system, (start, end), names, _parts(call, system, of), times, others, fixed, memory)


def _named(argument: Any, names: tuple[str, ...], what: str) -> dict[str, Any] | None:
    """Return values by name; an array has them in the order of `names`."""
    if argument is None:
        return None
    if is_named(argument):
        return by_spelling(argument, what, rate_name)
    return dict(zip(names, vector(argument, what), strict=False))


def _parts(call: str, system: CompiledSystem, of: Sequence[str]) -> dict[str, tuple[str, ...]]:
    c = system.compiled
    own = c.coordinates[: c.n_coordinates]
    known = {"x": own, "v": rates_of(own), "states": names_of_states(c), "outputs": tuple(c.outputs)}
    asked = (of,) if isinstance(of, str) else tuple(of)
    if not asked or (wrong := set(asked) - set(PARTS)):
        raise ModelError(f"{call}: {unknown('part in of', wrong if asked else [], PARTS)}")
    parts = {part: known[part] for part in dict.fromkeys(asked)}
    if not any(parts.values()):
        raise ModelError(f"{call}: {system.name} has no {' and no '.join(asked)}")
    return parts


def check_names(call: str, motion: MotionMap, values: Any) -> dict[str, Any]:
    """Return values by name.

    Raises
    ------
    ModelError
        They are no mapping of the names that `by` gave.
    """
    if not isinstance(values, Mapping):
        raise ModelError(f"{call}: the function takes a mapping name -> number, of {', '.join(motion.names)}")
    given = by_spelling(values, call, variable_name)
    if wrong := set(given) - set(motion.names):
        raise ModelError(f"{call}: {unknown('name', wrong, motion.names)}")
    if missing := [name for name in motion.names if name not in given]:
        raise ModelError(f"{call}: no value for {', '.join(map(repr, missing))}, which `by` names")
    return given
