"""The problem of a periodic motion: system, values, options of runs, and states as arrays."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ...arguments.differentiation import rates_of
from ...arguments.named_values import Vector, spelled
from ...compiled.compiled_system import CompiledSystem
from ...compiled.projection import Projection
from ...results.solution import Solution
from ...runtime import CompiledModel, Prepared
from ..state.operating_point import OperatingPoint
from .quantities import PERIOD, TIME, Quantity
from .symmetry import Symmetry

NO_LIMIT = 10**9
"""Number of runs that is never reached."""


@dataclass
class Count:
    """Runs so far, their largest number, and the number at which the present attempt ends."""

    most: int
    runs: int = 0
    until: int = NO_LIMIT

    @property
    def spent(self) -> bool:
        """Whether there are no more runs."""
        return self.runs >= min(self.most, self.until)


@dataclass(frozen=True)
class Problem:
    """What a periodic motion is looked for in. States q are (2 n,): x, v of compiled functions, with integrals zero.

    parameters, inputs : of users; prepared : their constants; clock : whether the equations depend on time
    options : of `simulate`; atol : (n,)
    stated_period : as an expression of parameters, or None
    by : names of parameters, inputs and "t" by which motions are differentiated, too
    """

    system: CompiledSystem
    parameters: Any
    inputs: Any
    prepared: Prepared
    t: float
    symmetry: Symmetry
    clock: bool
    options: Mapping[str, Any]
    rtol: float
    count: Count
    free_advance: tuple[int, ...] = field(default=())
    stated_period: Quantity | None = None
    by: tuple[str, ...] = ()

    @property
    def c(self) -> CompiledModel:
        """The compiled model."""
        return self.system.compiled

    @property
    def names(self) -> tuple[str, ...]:
        """Names of initial values by which runs are differentiated."""
        return *self.c.coordinates, *rates_of(self.c.coordinates[: self.c.n_coordinates])

    @property
    def variables(self) -> tuple[str, ...]:
        """Names of all by which runs are differentiated."""
        return *self.names, *(name for name in self.by if name != TIME)

    @property
    def places(self) -> list[int]:
        """The place in q of each name."""
        n, every = self.c.n_coordinates, self.c.n
        return [*range(n), *range(every + n, 2 * every), *range(every, every + n)]

    @property
    def own(self) -> list[int]:
        """The places in q that are no integrals and do not advance freely: those that close."""
        n, every = self.c.n_coordinates, self.c.n
        return [k for k in (*range(n), *range(every, 2 * every)) if k not in self.free_advance]

    def column(self, name: str) -> int:
        """Return the place of a name of `by` among the arguments of derivatives: x, v, inputs, parameters, time."""
        return -1 if name == TIME else 2 * self.c.n + (*self.c.inputs, *self.c.parameters).index(name)

    @property
    def period_slopes(self) -> Vector:
        """The derivative of a stated period by each name of `by`."""
        if self.stated_period is None:
            return np.zeros(len(self.by))
        slopes = self.stated_period.slopes(self.constants)
        return np.array([slopes.get(name, 0.0) for name in self.by])

    def period(self, guess: float) -> float:
        """Return the period that forcing gives, or else the guess."""
        if not self.clock or self.stated_period is None:
            return guess
        return float(self.stated_period.value(self.constants))

    def numbers(self, q: Vector, period: float, t: Any = None) -> dict[str, Any]:
        """Return by name what expressions of users contain, at states (2 n,) or (2 n, rows), at the start or at t."""
        states = {name: q[place] for name, place in zip(self.names, self.places, strict=True)}
        return self.constants | states | {TIME: self.t if t is None else t, PERIOD: period}

    @property
    def constants(self) -> dict[str, float]:
        """The values of inputs at the start, and of parameters, by name."""
        values = (*self.c.inputs, *self.c.parameters), (*self.signals(self.t), *self.prepared.parameters)
        return dict(zip(*values, strict=True))

    def value(self, name: str) -> float:
        """Return the value of a name of `by`."""
        return self.t if name == TIME else float(self.constants[name])

    def with_values(self, names: tuple[str, ...], values: Vector) -> "Problem":
        """Return the problem with other values of parameters, inputs and the time of the start."""
        made = self
        for name, value in zip(names, values.tolist(), strict=True):
            made = made.with_value(name, value)
        return made

    def with_value(self, name: str, value: float) -> "Problem":
        """Return the problem with another value of a parameter, an input, or the time of the start."""
        if name == TIME:
            return replace(self, t=value)
        parameters, inputs = self.parameters, self.inputs
        if name in self.c.inputs:
            inputs = named_values(inputs, self.c.inputs) | {name: value}
        else:
            parameters = named_values(parameters, self.c.parameters) | {name: value}
        prepared = self.system.prepare_both(parameters, inputs)[0]
        return replace(self, parameters=parameters, inputs=inputs, prepared=prepared)

    def rows(self, solution: Solution) -> Vector:
        """Return q (rows, 2 n) of a solution."""
        p = self.c.n_states
        states = np.array([solution.states[name] for name in self.system.states]).reshape(p, solution.t.size)
        return np.vstack([solution.x, np.zeros_like(states), solution.v, states]).T

    def start(self, q: Vector) -> tuple[Vector, Vector]:
        """Return x0, v0 for `simulate`."""
        n, every = self.c.n_coordinates, self.c.n
        return np.concatenate([q[:n], q[every + n :]]), q[every : every + n]

    def in_mode(self, solution: Solution, t: float) -> Prepared:
        """Return the constants in the mode in which a solution is right after t."""
        modes = [mode for since, mode in solution.modes if since <= t]
        if not modes:
            return self.prepared
        values = np.array(self.prepared.parameters)
        for name, value in modes[-1].items():
            values[self.c.parameters.index(name)] = value
        return self.system.prepare(values)

    def point(self, q: Vector, t: float, prepared: Prepared) -> OperatingPoint:
        """Return the operating point of a state."""
        return OperatingPoint(self.c, prepared, t, q[: self.c.n], q[self.c.n :], self.signals(t))

    def signals(self, t: float) -> Vector:
        """Return the values of the inputs."""
        return np.asarray(self.system.signals(self.system.prepare_both(self.parameters, self.inputs)[1], t))

    def flow(self, q: Vector, t: float, prepared: Prepared) -> Vector:
        """Return dq/dt, with integrals zero."""
        f = np.concatenate([q[self.c.n :], self.point(q, t, prepared).motion[0]])
        f[self.c.n_coordinates : self.c.n] = 0.0
        return f

    def event(self, q: Vector, event: int) -> float:
        """Return the value of an event's expression at the start."""
        at = self.point(q, self.t, self.prepared)
        return float(self.c.event_rows(np.array([at.t]), at.x[None], at.v[None], at.u[None], at.prepared)[0, event])

    def projected(self, q: Vector, prepared: Prepared) -> Vector:
        """Return the nearest state on the constraints."""
        if not self.c.m:
            return q
        x, v = Projection(self.c, prepared, self.t, least_norm=True)(q[: self.c.n], q[self.c.n :])
        return np.concatenate([x, v])

    def scales(self, rows: Vector, t: float, period: float) -> Vector:
        """Return (2 n,) sizes of the numbers along a motion, by which deviations are measured.

        A coordinate that hardly moves has a part of the speed of the whole, by inertia. So units make no difference.
        """
        n, every = self.c.n_coordinates, self.c.n
        speed = np.abs(rows[:, every:]).max(axis=0)
        inertia = self.point(rows[0], t, self.prepared).inertia[:n]
        whole = float(np.linalg.norm(inertia * speed[:n]))
        rates = np.maximum(speed[:n], 1e-3 * whole / inertia)
        spread = np.ptp(rows[:, every + n :], axis=0)
        states = np.where(spread > 1e-3 * speed[n:], spread, speed[n:])
        both = np.concatenate([rates * period / (2 * np.pi), states, rates, states])
        return np.where(both > 0.0, both, 1.0)

    def with_tolerance(self, rtol: float, scale: Vector | None, t: float | None = None) -> "Problem":
        """Return the problem with other tolerances, absolute ones relative to the sizes of the motion."""
        options = dict(self.options) | {"rtol": rtol}
        if scale is not None and "atol" not in self.options:
            n = self.c.n
            least = np.minimum(scale[:n], scale[n:])
            options["atol"] = dict(zip(self.c.coordinates[: self.c.n], (rtol * least).tolist(), strict=True))
        return replace(self, options=options, rtol=rtol, t=self.t if t is None else t)


def named_values(values: Any, names: tuple[str, ...]) -> dict[str, Any]:
    """Return the values that users state, by name."""
    if values is None:
        return {}
    if isinstance(values, Mapping):
        return {spelled(name): value for name, value in values.items()}
    return dict(zip(names, values, strict=True))
