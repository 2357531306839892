"""The page of a report, model by model."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ..presentation.figures import Picture
from ..presentation.page import render
from ..presentation.tables import Row, Table
from ..presentation.text import number, seconds
from .examine import Findings
from .measure import SLOW, SLOW_TURNS, Measurement
from .peers import LONGEST
from .recommend import LEVELS, Curve
from .solvers import IMPLICIT, MOST_STEPS, OURS
from .text import recommendation, spread

_YARDSTICK = (OURS, "eigenfactor", "dop853")


@dataclass(frozen=True, slots=True)
class ModelSection:
    """One model on the page."""

    name: str
    about: str
    advice: tuple[str, ...]
    pictures: tuple[Picture, ...]
    reaching: Table
    ratios: Table
    costs: Table
    builds: Table
    left_out: tuple[tuple[str, tuple[str, ...]], ...]
    limits: str
    absent: tuple[tuple[str, str], ...]
    reference: str
    measurements: Table


def page(reports: Sequence[Findings], drawings: Sequence[Sequence[Picture]], machine: Mapping[str, str]) -> str:
    """Render the page of all models; `drawings` are each one's pictures."""
    sections = [_section(found, drawn) for found, drawn in zip(reports, drawings, strict=True)]
    return render(__package__, sections=sections, machine=machine)


def _section(found: Findings, drawn: Sequence[Picture]) -> ModelSection:
    reference = found.reference
    return ModelSection(
        name=found.name,
        about=_about(found),
        advice=recommendation(found),
        pictures=tuple(drawn),
        reaching=_reaching(found),
        ratios=_ratios(found),
        costs=_costs(found),
        builds=_builds(found),
        left_out=tuple((s.formulation, s.left_out or ("nothing",)) for s in found.subject.systems),
        limits=_limits(found),
        absent=(*found.absent, *found.skipped),
        reference=f"{reference.how} Estimate: {number(float(reference.errors[-1]))} at the end, "
        f"{number(float(reference.errors.max()))} at the most.",
        measurements=_measurements(found.measurements),
    )


def _about(found: Findings) -> str:
    system = found.subject.systems[0]
    given = [f"{name}{mark} = {value:g}" for kind, mark in (("parameters", ""), ("inputs", ""), ("x0", ""), ("v0", "'"))
             for name, value in found.ask.settings.get(kind, {}).items()]  # fmt: skip
    return (
        f"Coordinates: {system.n}. Constraint rows: {system.m}, {system.h} of them holonomic. "
        f"Motion: t = 0 ... {found.ask.t_end:g}, errors at {len(found.reference.t)} equidistant times. "
        + (f"Set: {', '.join(given)}." if given else "Parameters and start: the model's own.")
    )


def _limits(found: Findings) -> str:
    """Say what is measured less often than the rest, and why."""
    budget, plain = found.ask.budget, next((c.formulation for c in found.curves if c.is_implicit), "none here")
    return (
        f"The implicit methods {', '.join(IMPLICIT)} integrate (x, xdot) with a compiled Jacobian in every "
        f"formulation, which only says what a row holds beside them: they are measured once, on {plain}, at whole "
        f"decades of the tolerance. A run is stopped after {MOST_STEPS:,} steps of ours, of heyoka.py or of CVODES, "
        f"or {LONGEST:g} s of SciPy's; nothing tighter is tried then. After a run that took k times {budget.grain:g} s "
        f"the next k tolerances are skipped. Runs of more than {SLOW:g} s are timed {SLOW_TURNS + 1} times."
    )


def _reaching(found: Findings) -> Table:
    rows = [(c.label, *(seconds(c.seconds_at(level)) for level in LEVELS)) for c in found.curves]
    return Table(("solver", *(f"{level:.0e}" for level in LEVELS)), tuple(rows))


def _ratios(found: Findings) -> Table:
    """How many times longer than the paper's formulation each solver takes to the same error."""
    yardstick = next((c for c in found.curves if (c.family, c.formulation, c.method) == _YARDSTICK), None)
    head = ("solver", *(f"{level:.0e}" for level in LEVELS))
    if yardstick is None:
        return Table(head, ())
    return Table(head, tuple((c.label, *(_ratio(c, yardstick, level) for level in LEVELS)) for c in found.curves))


def _ratio(curve: Curve, yardstick: Curve, level: float) -> str:
    own, other = curve.seconds_at(level), yardstick.seconds_at(level)
    return "-" if own is None or other is None else f"{own / other:.3g}"


def _costs(found: Findings) -> Table:
    head = ("solver", "order seen", "a call", "a right-hand side more")
    return Table(head, tuple((c.label, *_cost(c, found.floor)) for c in found.curves))


def _cost(curve: Curve, floor: float) -> Row:
    order, cost = curve.order(floor), curve.cost()
    seen = "-" if order is None else f"{order:.1f}"
    if cost is None:
        return seen, "-", "-"
    return seen, seconds(cost[0]) if cost[0] > 0 else "too little to see", seconds(cost[1])


def _builds(found: Findings) -> Table:
    derived = seconds(found.subject.derivation)
    rows = [
        (b.formulation, derived, seconds(b.generation), seconds(b.compilation), str(b.system.n_state))
        if b.system
        else (b.formulation, derived, "-", "-", f"refused: {b.refused.splitlines()[0]}")
        for b in found.subject.built
    ]
    return Table(("formulation", "derivation", "generation (with it)", "compilation", "states"), tuple(rows))


def _measurements(measurements: Sequence[Measurement]) -> Table:
    head = (
        "solver", "tolerance", "error at the end", "largest error", "of velocities", "run time", "quartiles", "repeats",
        "right-hand sides", "ns each", "steps", "rejected", "|A v + b|", "|phi|", "energy (62)", "factor residual",
        "remark",
    )  # fmt: skip
    return Table(head, tuple(map(_measurement, measurements)))


def _measurement(m: Measurement) -> Row:
    return (
        m.label, number(m.tolerance), number(m.error_end), number(m.error_max), number(m.velocity_error_max),
        seconds(m.seconds), spread(m), str(m.repeats), _count(m.nfev), number(m.ns_per_rhs), _count(m.nsteps),
        _count(m.nrejected), number(m.constraint_violation), number(m.position_violation), number(m.energy_integral),
        number(m.factor_residual), m.message,
    )  # fmt: skip


def _count(value: int | None) -> str:
    return "-" if value is None else str(value)
