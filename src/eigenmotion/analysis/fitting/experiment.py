"""An experiment: a run of the model at values of the unknowns, and what it predicts for the samples."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from ...results.sensitivity import Sensitivity
from ...results.solution import Solution
from ...runtime import StopReason
from ...simulation.simulate import simulate
from .measurements import Quantity, predictions
from .starts import ConstrainedStart, FreeStart, argument_columns
from .unknowns import Given, Unknowns


@dataclass(frozen=True)
class Evaluation:
    """A run at values (k,) of the unknowns.

    residuals : of each quantity (samples,), measured less predicted
    slopes : of each quantity (samples, k), derivatives of what is predicted
    begin : x, v of compiled functions at the start
    parameters : name -> value, of unknown ones
    """

    values: Vector
    residuals: tuple[Vector, ...]
    slopes: tuple[Vector, ...]
    solution: Solution
    begin: tuple[Vector, Vector]
    parameters: dict[str, float]


@dataclass(frozen=True)
class Experiment:
    """A measured motion: where it starts, what was measured at times (nt,), and options of `simulate`."""

    given: Given
    unknowns: Unknowns
    start: FreeStart | ConstrainedStart
    times: Vector
    quantities: tuple[Quantity, ...]
    options: Mapping[str, Any]

    def at(self, values: Vector) -> Evaluation:
        """Return the run at values (k,) of the unknowns.

        Raises
        ------
        ModelError, EvaluationError
            The run cannot start, fails, ends before the last sample, or has no derivatives.
        """
        c, given, names = self.given.system.compiled, self.given, self.unknowns.names
        by_name = {name: float(value) for name, value in zip(names, values, strict=True)}
        parameters, inputs = parameters_at(given, self.unknowns, by_name)
        prepared = given.system.prepare_both(parameters, inputs)[0]
        start = self.start.at(by_name, prepared)
        asked = list(dict.fromkeys(name for one in start.directions for name in one))
        solution = simulate(
            given.system, (given.t, float(self.times[-1])), x0=start.x0, v0=start.v0, parameters=parameters,
            inputs=inputs, t_eval=self.times, sensitivities=asked, **self.options,
        )  # fmt: skip
        _check_whole(c.name, solution, self.times)
        Z = np.stack([_along(solution.sensitivity, one) for one in start.directions], axis=-1)
        found = predictions(c, tuple(q.name for q in self.quantities), solution, Z, argument_columns(c, names))
        both = [(q.samples[q.seen] - y[q.seen], D[q.seen]) for q, (y, D) in zip(self.quantities, found, strict=True)]
        residuals, slopes = zip(*both, strict=True)
        if not all(np.isfinite(part).all() for part in (*residuals, *slopes)):
            raise ModelError(f"{c.name}: the run has rows, or derivatives of rows, that are not finite")
        own = {name: by_name[name] for name in self.unknowns.parameters}
        begin = given.system.begin(start.x0, start.v0, given.t, prepared)
        return Evaluation(values.copy(), residuals, slopes, solution, begin, own)


def parameters_at(given: Given, unknowns: Unknowns, values: Mapping[str, float]) -> tuple[Vector, Any]:
    """Return parameters (n_parameters,) and inputs at values of the unknowns."""
    c = given.system.compiled
    parameters = np.array(given.system.prepare(given.parameters).parameters)
    for name in unknowns.parameters:
        parameters[c.parameters.index(name)] = values[name]
    if not unknowns.inputs:
        return parameters, given.inputs
    return parameters, dict(given.inputs or {}) | {name: values[name] for name in unknowns.inputs}


def _along(sensitivity: Mapping[str, Sensitivity], direction: Mapping[str, float]) -> Vector:
    """Return derivatives (2 n, nt) of x, v of compiled functions in a direction of the start."""
    parts = [(factor, sensitivity[name]) for name, factor in direction.items()]
    dx, dv, dz = (sum(factor * getattr(one, part) for factor, one in parts) for part in ("dx", "dv", "dz"))
    return np.vstack([dx, np.zeros_like(dz), dv, dz])


def _check_whole(model: str, solution: Solution, times: Vector) -> None:
    """Raise if a run does not have all rows."""
    if solution.stop is StopReason.INTERRUPTED:
        raise KeyboardInterrupt
    if not solution.success:
        raise ModelError(solution.message)
    if len(solution.t) != len(times):
        reached = float(solution.t[-1]) if len(solution.t) else float("nan")
        raise ModelError(f"{model}: the run ended before the last sample, at t = {reached:.6g} of {times[-1]:.6g}: "
                         f"{solution.message}")  # fmt: skip
