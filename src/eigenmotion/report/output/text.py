"""Recommendation of a report as text."""

from ...presentation.text import number, seconds
from ...presentation.units import Units
from ..examine import Findings
from ..measure import Measurement
from ..solvers import OURS

STEADY = 1.25
"""Largest ratio of the quartiles of repeated calls on an idle machine."""


def spread(m: Measurement) -> str:
    """Return the quartiles of a run time as text."""
    return "-" if m.seconds_low is None else f"{seconds(m.seconds_low)} ... {seconds(m.seconds_high)}"


def recommendation(findings: Findings) -> tuple[str, ...]:
    """Return the recommendation as sentences: what to use, alternatives, times of others, warnings."""
    advice = findings.recommendation
    if advice.chosen is None:
        return (_not_reached(findings), *_unsure(findings), *_caution(findings))
    best = advice.chosen
    choice = (
        f"formulation {best.formulation}, method {best.method}, rtol = atol = {best.tolerance:.1e}: error "
        f"{number(best.error_max)} in {seconds(best.seconds)} (asked: {advice.requested:g})."
    )
    given = "".join(f", {name}={dict(numbers)}" for name, numbers in findings.options.settings.items())
    call = (
        f'system = eigenmotion.build(model, formulation="{best.formulation}"); eigenmotion.simulate(system, '
        f'(0, {findings.options.t_end:g}){given}, method="{best.method}", rtol={best.tolerance:.1e}, '
        f"atol={best.tolerance:.1e})"
    )
    doubts = (*_spread(best), *_unsure(findings), *_caution(findings))
    return (choice, call, _measured(best), *_as_fast(findings), *_others(findings), *doubts)


def _measured(best: Measurement) -> str:
    return (
        f"The error is the largest on the way; the time is the median of {best.repeats} calls on this machine, with "
        f"quartiles {spread(best)}."
    )


def units_of(findings: Findings) -> Units:
    """Return the units of the model's quantities: name -> word; None if it has none."""
    return dict(findings.subject.model.units) or None


def _not_reached(findings: Findings) -> str:
    closest = findings.recommendation.closest
    least = "nothing was measured" if closest is None else f"the least is {number(closest.error_max)}, {closest.label}"
    limit = findings.recommendation.requested
    return f"No run reaches an error of {limit:g}: {least}. Ask for less, or for a shorter span."


def _as_fast(findings: Findings) -> tuple[str, ...]:
    names = [f"{m.label} at {m.tolerance:.1e} ({seconds(m.seconds)})" for m in findings.recommendation.as_fast]
    return (f"As fast within the spread: {', '.join(names)}.",) if names else ()


def _others(findings: Findings) -> tuple[str, ...]:
    """Return the relative times of other solvers for the same error, the best of each group."""
    requested, chosen = findings.recommendation.requested, findings.recommendation.chosen
    best: dict[str, float] = {}
    own = next((c for c in findings.curves if chosen and c.label == chosen.label and c.family == OURS), None)
    for curve in findings.curves:
        needed = curve.seconds_at(requested)
        if needed is not None and (own is None or curve.group != own.group):
            best[curve.group] = min(needed, best.get(curve.group, needed))
    least = own.seconds_at(requested) if own else None
    if not best or not least:
        return ()
    ranked = sorted(best.items(), key=lambda item: item[1])
    return ("Times as long to that error: " + ", ".join(f"{name} {t / least:.2g}" for name, t in ranked) + ".",)


def _spread(best: Measurement) -> tuple[str, ...]:
    low, high = best.seconds_low or 0.0, best.seconds_high or 0.0
    if high <= STEADY * low:
        return ()
    words = (
        f"The times spread: the upper quartile of this run is {high / low:.2g} times the lower one, as where others "
        "use the machine. Measure again on a quiet one before you choose by them."
    )
    return (words,)


def _unsure(findings: Findings) -> tuple[str, ...]:
    """Return where the reference comes from, if from this tool."""
    reference = findings.reference
    if not reference.why:
        return ()
    words = (
        f"No independent reference, because of {reference.why}: errors are differences from a tight run of this tool, "
        f"which another formulation and method repeats to {number(float(reference.errors.max()))}. A fault that both "
        "share stays hidden."
    )
    return (words,)


def _caution(findings: Findings) -> tuple[str, ...]:
    own = float(findings.reference.errors.max())
    if own < 0.1 * findings.recommendation.requested:
        return ()
    words = (
        f"Caution: the reference itself is only good to {number(own)}, as the motion magnifies small differences; "
        "errors of that size cannot be told apart. Shorten the span with --t-end."
    )
    return (words,)
