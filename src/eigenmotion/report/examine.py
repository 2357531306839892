"""One model from its equations to a recommendation."""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from ..codegen.model import Model, ModelError
from ..simulate import simulate
from ..system import System
from .classical import classical
from .measure import Budget, Judge, Measurement, Progress, measure
from .peers import Start, peers
from .recommend import Curve, Recommendation, curves, recommend
from .reference import Reference, reference
from .solvers import METHODS, OUR_TOLERANCES, our_solvers
from .subject import Subject, subject


@dataclass(frozen=True, slots=True)
class Ask:
    """What to find out.

    error : the accuracy asked for
    t_end : [s]
    tolerances : of our runs, from loose to tight
    """

    error: float = 1e-8
    t_end: float = 10.0
    tolerances: tuple[float, ...] = OUR_TOLERANCES
    budget: Budget = field(default_factory=Budget)


@dataclass(frozen=True, slots=True)
class Findings:
    """All that was found out about one model."""

    subject: Subject
    ask: Ask
    reference: Reference
    measurements: tuple[Measurement, ...]
    absent: tuple[tuple[str, str], ...]
    curves: tuple[Curve, ...]
    recommendation: Recommendation

    @property
    def name(self) -> str:
        """The model's."""
        return self.subject.model.name

    @property
    def floor(self) -> float:
        """Error below which differences say nothing: rounding, or ten times the reference's own error."""
        return max(1e-13, 10 * float(self.reference.errors.max()))


def examine(model: Model, ask: Ask, progress: Progress) -> Findings:
    """Build, integrate and measure.

    Raises
    ------
    ModelError, BuildError
        The model has a mistake, cannot be built, or has no reference to compare with.
    """
    found = subject(model, _part(progress, 0.0, 0.2))
    system = found.systems[0]
    progress(0.2, "reference")
    equations, start = classical(model), _start(system, ask)
    judge = Judge(reference(equations, start.y, ask.t_end), system)
    others = peers(equations, start)
    solvers = [s for system in found.systems for s in our_solvers(system, ask.t_end, ask.tolerances)]
    measured = measure([*solvers, *others.solvers], judge, ask.budget, _part(progress, 0.3, 1.0))
    lines = curves(measured)
    advice = recommend(lines, ask.error)
    return Findings(found, ask, judge.reference, measured, others.absent, lines, advice)


def _part(progress: Progress, start: float, end: float) -> Callable[[float, str], None]:
    return lambda done, what: progress(start + (end - start) * done, what)


def _start(system: System, ask: Ask) -> Start:
    """Return the model's own start, having seen one run get to the end."""
    probe = simulate(system, (0.0, ask.t_end), method=next(reversed(METHODS)), rtol=1e-8, atol=1e-8)
    if probe.status != 0:
        raise ModelError(
            f"{system.name}: a run of {system.formulation} ends at t = {probe.t[-1]:.6g} already: {probe.message} "
            "Shorten the span with --t-end."
        )
    return Start(np.concatenate([probe.x[:, 0], probe.v[:, 0]]), ask.t_end)
