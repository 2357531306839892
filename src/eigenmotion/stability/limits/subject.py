"""Subject of an examination: a user's model with its start, span and units."""

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from math import pi
from typing import Any

import numpy as np

from ...analysis.equilibrium.assemble import assemble
from ...arguments.named_values import Vector, spelled
from ...codegen.model import Model, ModelError
from ...comparison.deadline import NONE, Deadline, TooLateError
from ...comparison.obstacles import acts, without_reference
from ...reference.motion import rates_of, rows_of
from ...results.solution import Solution
from ...runtime import EvaluationError
from ...simulation.simulate import simulate
from ...system.system import System
from ..cases.case import Trial, rows, spread
from ..expectation.truth import Truth, lagrange
from .references import MOST_COORDINATES, Independent, TightRuns, system_of

PERIODS = 20  # of the fastest oscillation, to which spans are limited
SPAN = 5.0  # characteristic periods of a run, unless the span is what is varied
_ROWS = 40
_LONGER = 4.0  # patience for references over given spans
_PROBING = 3.0  # patience for that run
_NOISE = 1e-9  # sizes below are errors of that run: of a coordinate that is held, for example
_PROBE = 400  # rows of the run that the periods and units are taken from


@dataclass(frozen=True)
class Subject:
    """A model as it is examined; everything can be sent to other processes.

    Attributes
    ----------
    parameters, inputs : over the model's defaults
    x0, v0, z0 : (n,), (n,), (p,) start
    t_end : [s] longest span, unless spans are what is varied
    period : [s] characteristic period of the motion, at most t_end
    units : (n + p,) size of each coordinate and state in its motion, at most 1: the unit of atol and of errors
    motion : (k, 2n + p) rows of the motion, in which singular positions are looked for
    why : why there is no independent reference; "": there is one
    patience : [s] of the processor for a reference
    deadline : of all runs and references
    """

    model: Model
    formulations: tuple[str, ...]
    parameters: Mapping[str, float]
    inputs: Mapping[str, float]
    x0: Vector
    v0: Vector
    z0: Vector
    t_end: float
    period: float
    units: Vector
    motion: Vector
    why: str = ""
    patience: float = 5.0
    deadline: Deadline = NONE

    @property
    def system(self) -> System:
        """The model in the first of the formulations."""
        return system_of(self.model, self.formulations[0])

    @property
    def lengths(self) -> Vector:
        """The units (n,) of the coordinates."""
        return self.units[: len(self.x0)]

    @property
    def conserves(self) -> bool:
        """Whether the energy is constant; between impacts only it is not."""
        return self.system.conserves_energy and not acts(self.model)

    @property
    def span(self) -> float:
        """The span [s] of runs."""
        return min(self.t_end, SPAN * self.period)

    def trial(
        self, label: str, changed: Mapping[str, float] | None = None, start: tuple[Vector, Vector] | None = None,
        span: float | None = None, tolerance: float | None = None, periods: float = 0.0,
    ) -> Trial:  # fmt: skip
        """Return the run with other parameters or another start."""
        parameters = {**self.parameters, **(changed or {})}
        x0, v0 = self.consistent(*(start or (self.x0, self.v0)), parameters)
        tight = partial(
            TightRuns, self.model, self.formulations, parameters, self.inputs, self.units, deadline=self.deadline
        )
        truth, end = self._truth(tight, (x0, v0), parameters, span, fine=bool(span or tolerance))
        return Trial(
            label, parameters, x0, v0, self.units, 0.0, rows(0.0, end, _ROWS), truth,
            conserves=self.conserves, periods=periods, inputs=self.inputs, tolerance=tolerance,
            otherwise=tight if truth.independent else None, may_lose_digits=True,
            nearby=not self.model.contacts, z0=self.z0, rotations=self.system.compiled.rotations,
            deadline=self.deadline,
        )  # fmt: skip

    def _truth(
        self,
        tight: partial[TightRuns],
        start: tuple[Vector, Vector],
        parameters: Mapping[str, float],
        span: float | None,
        fine: bool,
    ) -> tuple[Truth, float]:
        """Return the reference and the span, which is limited to PERIODS of the fastest oscillation if it is free."""
        end = span or self.span
        if self.why:
            return tight(self.why), end
        try:
            rhs, y = lagrange(self.model, {**parameters, **self.inputs}), np.concatenate([*start, self.z0])
            with np.errstate(all="ignore"):
                fastest = _fastest(rates_of(rhs, np.zeros(1), y[None]))
        except (ArithmeticError, ValueError, TypeError, NameError, AttributeError) as error:
            return tight(f"plain equations cannot be evaluated at the start: {error}"), end
        if span is None and np.isfinite(fastest) and fastest * end > 2 * pi * PERIODS:
            end = 2 * pi * PERIODS / fastest
        until = time.process_time() + self.patience * (_LONGER if span else 1.0)
        scale = spread(self.units, len(self.x0)) + np.abs(y)
        return Independent(rhs, scale, until=until, deadline=self.deadline, fine=fine), end

    def consistent(self, x0: Vector, v0: Vector, parameters: Mapping[str, float]) -> tuple[Vector, Vector]:
        """Return the nearest start on the constraints; the same if there is none, which runs refuse."""
        if self.system.m == 0 or self.model.contacts:
            return x0, v0
        for close in (self.system.project_initial_state, partial(assemble, self.system)):
            try:
                x, v = close(x0, v0, parameters=parameters)
                return np.array(x), np.array(v)
            except (ModelError, EvaluationError):
                continue
        return x0, v0


def _fastest(rates: Any) -> float:
    """Return the fastest oscillation or growth [1/s]; decays do not limit a span."""
    return float(max(np.abs(rates.imag).max(), rates.real.max()))


def subject(
    model: Model, formulations: tuple[str, ...], settings: Mapping[str, Mapping[str, float]], t_end: float,
    patience: float, deadline: Deadline = NONE,
) -> Subject:  # fmt: skip
    """Return the subject, from a run of its motion.

    Raises
    ------
    ModelError
        The motion cannot start.
    """
    system, given = system_of(model, formulations[0]), dict(settings)
    parameters, inputs = given.get("parameters", {}), given.get("inputs", {})
    motion = _motion(system, given, t_end, deadline, _PROBING * patience)
    found, n = rows_of(motion), system.n
    largest = np.max(np.abs(found), axis=0)
    sizes = np.concatenate([np.maximum(largest[:n], largest[n : 2 * n]), largest[2 * n :]])
    units = np.where(sizes > _NOISE, np.minimum(sizes, 1.0), 1.0)
    x0, v0, z0 = np.split(found[0], (n, 2 * n))
    return Subject(
        model, formulations, parameters, inputs, x0, v0, z0, t_end, _period(motion, t_end), units,
        found[:: max(1, len(found) // 8)].copy(), without_reference(model, MOST_COORDINATES), patience, deadline,
    )  # fmt: skip


def _motion(system: System, settings: Mapping[str, Any], t_end: float, deadline: Deadline, seconds: float) -> Any:
    """Return a run by the first method that reaches the end in some seconds, or else the longest."""
    best, times = None, np.linspace(0.0, t_end, _PROBE)
    for method in ("dop853", "radau9"):
        run = partial(
            simulate, system, (0.0, t_end), method=method, rtol=1e-8, atol=_NOISE / 10, t_eval=times, **settings
        )  # fmt: skip
        try:
            done = deadline.sooner(seconds).run(partial(_with_steps, run), 100_000)
        except TooLateError:
            break
        if done.success:
            return done
        best = done if best is None or len(done.t) > len(best.t) else best
    if best is None or len(best.t) < 10:
        raise ModelError(
            f"{system.name}: the motion ends at its start already: {best.message if best else ''} "
            "Give another start with --set, or values under which it moves."
        )
    return best


def _with_steps(run: Callable[..., Solution], steps: int) -> Solution:
    return run(max_steps=steps)


def _period(motion: Any, t_end: float) -> float:
    """Return 2 pi / w [s] with w the median, over the coordinates, of rms acceleration / rms velocity."""
    t, v = motion.t, motion.v
    steps = np.maximum(np.diff(t), 1e-300)
    a = np.diff(v, axis=1) / steps
    sizes, changes = np.sqrt(np.mean(v**2, axis=1)), np.sqrt(np.mean(a**2, axis=1))
    moving = sizes > 1e-9 * max(float(sizes.max()), 1e-300)
    w = float(np.median(changes[moving] / sizes[moving])) if moving.any() else 0.0
    return float(min(t_end, 2 * pi / w)) if w > 0 else float(t_end)


def swept(model: Model, parameters: Mapping[str, float]) -> tuple[tuple[str, float], ...]:
    """Return names and values of the parameters that are swept: not zero, not those of contacts and tables."""
    names = {f"{name}_{end}" for name, _ in model.contacts for end in ("held", "stuck")} | set(model.prescribed)
    names |= {table.name for table in model.tables}
    pairs = [(spelled(key), parameters.get(spelled(key), float(value))) for key, value in model.parameters]
    return tuple((name, value) for name, value in pairs if value != 0.0 and name not in names)
