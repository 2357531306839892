"""Examination of one model: from its equations to a recommendation."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from ..arguments.named_values import Vector
from ..codegen.model import Model, ModelError
from ..comparison.obstacles import acts, without_reference
from ..progress import Progress, part
from ..reference.lagrange_equations import classical
from ..reference.motion import Reference, reference, rows_of
from ..results.solution import Solution
from ..system.system import System
from .agreement import agreement
from .formulations import Subject, subject
from .measure import Budget, Judge, Measurement, measure, skipped
from .peers import PEERS, Peers, Start, peers
from .recommend import Curve, Recommendation, curves, recommend
from .solvers import OUR_TOLERANCES, Problem, Solver, explicit_solvers, implicit_solvers


@dataclass(frozen=True, slots=True)
class ReportOptions:
    """Options of a report.

    error : the requested accuracy
    t_end : [s]
    tolerances : of our explicit methods, from loose to tight
    settings : parameters, inputs, x0, v0 of `simulate`, over those of the model
    """

    error: float = 1e-8
    t_end: float = 10.0
    tolerances: tuple[float, ...] = OUR_TOLERANCES
    settings: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    budget: Budget = field(default_factory=Budget)

    @property
    def problem(self) -> Problem:
        """The span and settings of every run."""
        return Problem(self.t_end, self.settings)


@dataclass(frozen=True, slots=True)
class Findings:
    """The results for one model.

    start : x, v, z at t = 0
    absent : peers that could not be measured, and why
    skipped : solvers for which some tolerances were skipped, and why
    """

    subject: Subject
    options: ReportOptions
    start: Vector
    reference: Reference
    measurements: tuple[Measurement, ...]
    absent: tuple[tuple[str, str], ...]
    skipped: tuple[tuple[str, str], ...]
    curves: tuple[Curve, ...]
    recommendation: Recommendation

    @property
    def name(self) -> str:
        """The name of the model."""
        return self.subject.model.name

    @property
    def floor(self) -> float:
        """Smallest meaningful error: rounding, or ten times the error of the reference."""
        return max(1e-13, 10 * float(self.reference.errors.max()))


def examine(model: Model, options: ReportOptions, progress: Progress) -> Findings:
    """Build a model in all formulations, compute the reference, and measure all solvers.

    Raises
    ------
    ModelError, BuildError
        The model has a mistake, cannot be built, or has no reference to compare with.
    """
    built = subject(model, part(progress, 0.0, 0.2))
    system, parameters = built.systems[0], options.settings.get("parameters", {})
    progress(0.2, "reference")
    probe, why = _probe(system, options), without_reference(model)
    start = rows_of(probe)[0]
    if why:
        known = agreement(built.systems, options.problem, start, why)
        others = Peers((), ((PEERS, f"left out, since they have no {why}"),))
    else:
        equations = classical(model).with_values({**parameters, **options.settings.get("inputs", {})})
        known = reference(equations, start, options.t_end, along=(probe.t, rows_of(probe)))
        others = peers(equations, Start(start, system.n, options.t_end))
    solvers = _solvers(built, options, others)
    judge = Judge(known, system, parameters, acts(model))
    measured = measure(solvers, judge, options.budget, part(progress, 0.3, 1.0))
    lines = curves(measured)
    left = skipped(solvers, measured, options.budget)
    return Findings(built, options, start, known, measured, others.absent, left, lines, recommend(lines, options.error))


def _solvers(built: Subject, options: ReportOptions, others: Peers) -> list[Solver]:
    """Return our solvers and those of peers."""
    ours = [
        solver for system in built.systems for solver in explicit_solvers(system, options.problem, options.tolerances)
    ]
    return [*ours, *implicit_solvers(built.systems, options.problem), *others.solvers]


def _probe(system: System, options: ReportOptions) -> Solution:
    """Return a complete run: by an explicit method, or by an implicit method if that fails."""
    for method in ("dop853", "radau9"):
        probe = options.problem.simulate(system, method, 1e-8)
        if probe.status == 0:
            return probe
    raise ModelError(
        f"{system.name}: a run of {system.formulation} ends at t = {probe.t[-1]:.6g} already: {probe.message} "
        "Shorten the span with --t-end."
    )
