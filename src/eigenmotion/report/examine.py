"""One model from its equations to a recommendation."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from ..arguments.named_values import Vector
from ..codegen.model import Model, ModelError
from ..codegen.model.symbolic.lagrange import Lagrange
from ..progress import Progress, part
from ..reference.lagrange_equations import classical
from ..reference.motion import Reference, reference
from ..results.solution import Solution
from ..system.system import System
from .formulations import Subject, subject
from .measure import Budget, Judge, Measurement, measure, skipped
from .peers import Start, peers
from .recommend import Curve, Recommendation, curves, recommend
from .solvers import OUR_TOLERANCES, Problem, Solver, explicit_solvers, implicit_solvers


@dataclass(frozen=True, slots=True)
class Ask:
    """What to find out.

    error : the accuracy asked for
    t_end : [s]
    tolerances : of our runs with compiled methods, from loose to tight
    settings : parameters, inputs, x0, v0 over the model's own, as `simulate` takes them
    """

    error: float = 1e-8
    t_end: float = 10.0
    tolerances: tuple[float, ...] = OUR_TOLERANCES
    settings: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    budget: Budget = field(default_factory=Budget)

    @property
    def problem(self) -> Problem:
        """Return what every run is of."""
        return Problem(self.t_end, self.settings)


@dataclass(frozen=True, slots=True)
class Findings:
    """All that was found out about one model.

    start : x, v at t = 0
    absent : peers that there are none of here, and why
    skipped : solvers of which some tolerances were not tried, and why
    """

    subject: Subject
    ask: Ask
    start: Vector
    reference: Reference
    measurements: tuple[Measurement, ...]
    absent: tuple[tuple[str, str], ...]
    skipped: tuple[tuple[str, str], ...]
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
    found = subject(model, part(progress, 0.0, 0.2))
    system, parameters = found.systems[0], ask.settings.get("parameters", {})
    progress(0.2, "reference")
    values = {**parameters, **ask.settings.get("inputs", {})}
    equations, probe = classical(model).with_values(values), _probe(system, ask)
    rows = np.concatenate([probe.x, probe.v]).T
    known = reference(equations, rows[0], ask.t_end, along=(probe.t, rows))
    solvers, absent = _solvers(found, ask, equations, rows[0])
    measured = measure(solvers, Judge(known, system, parameters), ask.budget, part(progress, 0.3, 1.0))
    lines = curves(measured)
    left = skipped(solvers, measured, ask.budget)
    return Findings(found, ask, rows[0], known, measured, absent, left, lines, recommend(lines, ask.error))


def _solvers(
    found: Subject, ask: Ask, equations: Lagrange, y: Vector
) -> tuple[list[Solver], tuple[tuple[str, str], ...]]:
    """Return ours and the peers', and what is absent."""
    ours = [solver for system in found.systems for solver in explicit_solvers(system, ask.problem, ask.tolerances)]
    others = peers(equations, Start(y, ask.t_end))
    return [*ours, *implicit_solvers(found.systems, ask.problem), *others.solvers], others.absent


def _probe(system: System, ask: Ask) -> Solution:
    """Return a run that got to the end: of an explicit method, or where that is held up of an implicit one."""
    for method in ("dop853", "radau9"):
        probe = ask.problem.simulate(system, method, 1e-8)
        if probe.status == 0:
            return probe
    raise ModelError(
        f"{system.name}: a run of {system.formulation} ends at t = {probe.t[-1]:.6g} already: {probe.message} "
        "Shorten the span with --t-end."
    )
