"""Page of a report, with a section for each model."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ....presentation.page import render
from ....presentation.tables import Row, Table
from ....presentation.text import number, seconds
from ....presentation.units import Units, on_axis, time_unit, unit_of
from ...examine import Findings
from ...measure import SLOW, SLOW_TURNS, Measurement
from ...peers import LONGEST
from ...recommend import LEVELS, Curve
from ...solvers import IMPLICIT, MOST_STEPS, OURS
from ..chart import Chart
from ..choice import RULE
from ..looks import INKS
from ..text import recommendation, spread, units_of
from .drawing import NARROW, WIDE, Drawn, drawn, run_in_words

_YARDSTICK = (OURS, "eigenfactor", "dop853")


@dataclass(frozen=True, slots=True)
class LiveChart:
    """A chart of the page: wide and narrow, with few and with all curves; the run in its panel at first."""

    title: str
    text: str
    count: int
    drawings: tuple[Drawn, ...]
    run: Mapping[str, str]
    is_recommended: bool


@dataclass(frozen=True, slots=True)
class ModelSection:
    """The section of one model.

    has_call : whether the second sentence of the advice is a call
    runs : the runs of the charts in words; charts refer to them by number
    """

    name: str
    about: str
    advice: tuple[str, ...]
    has_call: bool
    runs: tuple[Mapping[str, str], ...]
    charts: tuple[LiveChart, ...]
    reaching: Table
    ratios: Table
    costs: Table
    builds: Table
    left_out: tuple[tuple[str, tuple[str, ...]], ...]
    limits: str
    absent: tuple[tuple[str, str], ...]
    reference: str
    measurements: Table


def page(reports: Sequence[Findings], drawings: Sequence[Sequence[Chart]], machine: Mapping[str, str]) -> str:
    """Render the page; `drawings` are the charts of each model."""
    sections = [_section(findings, charts) for findings, charts in zip(reports, drawings, strict=True)]
    return render(__package__, sections=sections, machine=machine, rule=RULE, inks=list(INKS.values()))


def _live(chart: Chart, runs: dict[int, int], words: Sequence[Mapping[str, str]]) -> LiveChart:
    drawings = tuple(drawn(chart, runs, layout, every) for layout in (WIDE, NARROW) for every in (False, True))
    points = [m for line in chart.few for *_, m in line.points]
    first = next((m for m in points if m == chart.recommended), points[0] if points else None)
    run = words[runs[id(first)]] if first else {"label": "nothing was measured"}
    return LiveChart(chart.title, chart.text, len(chart.every), drawings, run, first == chart.recommended is not None)


def _section(findings: Findings, charts: Sequence[Chart]) -> ModelSection:
    reference = findings.reference
    timed = [m for m in findings.measurements if m.seconds is not None]
    numbers, words = {id(m): k for k, m in enumerate(timed)}, tuple(map(run_in_words, timed))
    return ModelSection(
        name=findings.name,
        about=_about(findings),
        advice=recommendation(findings),
        has_call=findings.recommendation.chosen is not None,
        runs=words,
        charts=tuple(_live(chart, numbers, words) for chart in charts),
        reaching=_reaching(findings),
        ratios=_ratios(findings),
        costs=_costs(findings),
        builds=_builds(findings),
        left_out=tuple((s.formulation, s.left_out or ("nothing",)) for s in findings.subject.systems),
        limits=_limits(findings),
        absent=(*findings.absent, *findings.skipped),
        reference=f"{reference.how} Estimate: {number(float(reference.errors[-1]))} at the end, "
        f"{number(float(reference.errors.max()))} at the most.",
        measurements=_measurements(findings),
    )


def _about(findings: Findings) -> str:
    system, units = findings.subject.systems[0], units_of(findings)
    names, states = (_named(of, units) for of in (system.coordinates, system.states))
    end = f"{findings.options.t_end:g} {time_unit(units)}".rstrip()
    given = _given(findings)
    return (
        f"Coordinates: {system.n}, {names}. "
        + (f"First-order states: {states}. " if states else "")
        + f"Constraint rows: {system.m}, {system.h} of them holonomic. "
        f"Motion: t = 0 ... {end}, errors at {len(findings.reference.t)} equidistant times. "
        + (f"Set: {', '.join(given)}." if given else "Parameters and start: the model's own.")
    )


def _named(names: Sequence[str], units: Units) -> str:
    return ", ".join(on_axis(name, unit_of(units, name)) for name in names)


def _given(findings: Findings) -> list[str]:
    """Return the settings as text, each with its unit."""
    units, settings = units_of(findings), findings.options.settings
    kinds = (("parameters", "", 0), ("inputs", "", 0), ("x0", "", 0), ("v0", "'", 1))
    return [
        f"{name}{mark} = {value:g} {unit_of(units, name, order)}".rstrip()
        for kind, mark, order in kinds for name, value in settings.get(kind, {}).items()
    ]  # fmt: skip


def _limits(findings: Findings) -> str:
    """Return a text about measurements that are left out or repeated less often."""
    budget, plain = (
        findings.options.budget,
        next((c.formulation for c in findings.curves if c.is_implicit), "none here"),
    )
    return (
        f"The implicit methods {', '.join(IMPLICIT)} integrate (x, xdot) with a compiled Jacobian in every "
        f"formulation, which only adds other numbers to the rows: they are measured once, with {plain}, at whole "
        f"decades of the tolerance. A run is stopped after {MOST_STEPS:,} steps (ours, heyoka.py, CVODES) or "
        f"{LONGEST:g} s (SciPy); tighter tolerances are then skipped. After a run that took k times "
        f"{budget.grain:g} s the next k tolerances are skipped. Runs of more than {SLOW:g} s are timed "
        f"{SLOW_TURNS + 1} times."
    )


def _reaching(findings: Findings) -> Table:
    rows = [(c.label, *(seconds(c.seconds_at(level)) for level in LEVELS)) for c in findings.curves]
    return Table(("solver", *(f"{level:.0e}" for level in LEVELS)), tuple(rows))


def _ratios(findings: Findings) -> Table:
    """Return the run time of each solver relative to the paper's formulation at the same error."""
    yardstick = next((c for c in findings.curves if (c.family, c.formulation, c.method) == _YARDSTICK), None)
    head = ("solver", *(f"{level:.0e}" for level in LEVELS))
    if yardstick is None:
        return Table(head, ())
    return Table(head, tuple((c.label, *(_ratio(c, yardstick, level) for level in LEVELS)) for c in findings.curves))


def _ratio(curve: Curve, yardstick: Curve, level: float) -> str:
    own, other = curve.seconds_at(level), yardstick.seconds_at(level)
    return "-" if own is None or other is None else f"{own / other:.3g}"


def _costs(findings: Findings) -> Table:
    head = ("solver", "order seen", "a call", "a right-hand side more")
    return Table(head, tuple((c.label, *_cost(c, findings.floor)) for c in findings.curves))


def _cost(curve: Curve, floor: float) -> Row:
    order, cost = curve.order(floor), curve.cost()
    seen = "-" if order is None else f"{order:.1f}"
    if cost is None:
        return seen, "-", "-"
    return seen, seconds(cost[0]) if cost[0] > 0 else "too little to see", seconds(cost[1])


def _builds(findings: Findings) -> Table:
    derived = seconds(findings.subject.derivation)
    rows = [
        (b.formulation, derived, seconds(b.generation), seconds(b.compilation), str(b.system.n_state))
        if b.system
        else (b.formulation, derived, "-", "-", f"refused: {b.refused.splitlines()[0]}")
        for b in findings.subject.built
    ]
    return Table(("formulation", "derivation", "generation (with it)", "compilation", "states"), tuple(rows))


def _measurements(findings: Findings) -> Table:
    units = units_of(findings)
    work = " ".join(unit for unit in (unit_of(units, "energy"), time_unit(units)) if unit_of(units, "energy"))
    head = (
        "solver", "tolerance", "error at the end", "largest error", "of velocities", "run time", "quartiles", "repeats",
        "right-hand sides", "ns each", "steps", "rejected", "|A v + b|", "|phi|", on_axis("energy (62)", work),
        "factor residual", "remark",
    )  # fmt: skip
    return Table(head, tuple(map(_measurement, findings.measurements)))


def _measurement(m: Measurement) -> Row:
    return (
        m.label, number(m.tolerance), number(m.error_end), number(m.error_max), number(m.velocity_error_max),
        seconds(m.seconds), spread(m), str(m.repeats), _count(m.nfev), number(m.ns_per_rhs), _count(m.nsteps),
        _count(m.nrejected), number(m.constraint_violation), number(m.position_violation), number(m.energy_integral),
        number(m.factor_residual), m.message,
    )  # fmt: skip


def _count(value: int | None) -> str:
    return "-" if value is None else str(value)
