"""Advice in words."""

from ..presentation.text import number, seconds
from .examine import Findings
from .measure import Measurement
from .solvers import OURS

STEADY = 1.25
"""Quartiles of repeated calls lie closer than this on a machine that does nothing else."""


def spread(m: Measurement) -> str:
    """The quartiles of a run time."""
    return "-" if m.seconds_low is None else f"{seconds(m.seconds_low)} ... {seconds(m.seconds_high)}"


def recommendation(found: Findings) -> tuple[str, ...]:
    """Say what to use, what is as good, and how far peers are; sentence by sentence."""
    advice = found.recommendation
    if advice.chosen is None:
        return (_not_reached(found), *_caution(found))
    best = advice.chosen
    choice = (
        f"For an error of {advice.asked:g}, largest on the way, on this machine: formulation {best.formulation}, "
        f"method {best.method}, rtol = atol = {best.tolerance:.1e}: error {number(best.error_max)} in "
        f"{seconds(best.seconds)} ({spread(best)})."
    )
    given = "".join(f", {name}={dict(numbers)}" for name, numbers in found.ask.settings.items())
    call = (
        f'system = eigenmotion.build(model, formulation="{best.formulation}"); eigenmotion.simulate(system, '
        f'(0, {found.ask.t_end:g}){given}, method="{best.method}", rtol={best.tolerance:.1e}, '
        f"atol={best.tolerance:.1e})"
    )
    return (choice, call, *_as_fast(found), *_others(found), *_spread(best), *_caution(found))


def _not_reached(found: Findings) -> str:
    closest = found.recommendation.closest
    least = "nothing was measured" if closest is None else f"the least is {number(closest.error_max)}, {closest.label}"
    return f"No run reaches an error of {found.recommendation.asked:g}: {least}. Ask for less, or for a shorter span."


def _as_fast(found: Findings) -> tuple[str, ...]:
    names = [f"{m.label} at {m.tolerance:.1e} ({seconds(m.seconds)})" for m in found.recommendation.as_fast]
    return (f"As fast within the spread: {', '.join(names)}.",) if names else ()


def _others(found: Findings) -> tuple[str, ...]:
    """Say how much longer the others take to the same error, each family by its best."""
    asked, chosen = found.recommendation.asked, found.recommendation.chosen
    best: dict[str, float] = {}
    own = next((c for c in found.curves if chosen and c.label == chosen.label and c.family == OURS), None)
    for curve in found.curves:
        needed = curve.seconds_at(asked)
        if needed is not None and (own is None or curve.group != own.group):
            best[curve.group] = min(needed, best.get(curve.group, needed))
    least = own.seconds_at(asked) if own else None
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


def _caution(found: Findings) -> tuple[str, ...]:
    own = float(found.reference.errors.max())
    if own < 0.1 * found.recommendation.asked:
        return ()
    words = (
        f"Caution: the reference itself is only good to {number(own)}, as the motion magnifies small differences; "
        "errors of that size cannot be told apart. Shorten the span with --t-end."
    )
    return (words,)
