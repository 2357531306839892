"""Judgement of a run that reports success, by what it is compared with, and by its own indicators."""

from dataclasses import dataclass

from .expected_rows import Expected
from .outcome import MARGIN, MEANINGLESS, Outcome, classify

_SURE = 10.0
"""Errors of the reference, above which an error is that of the run."""


@dataclass(frozen=True, slots=True)
class Verdict:
    """An outcome, and a reason where the error alone does not give it."""

    outcome: Outcome
    reason: str = ""
    message: str = ""


def bound_of(expected: Expected, tolerance: float) -> float:
    """Return the largest error that is right."""
    bound = MARGIN * tolerance * (1 + expected.kappa)
    if expected.trial.may_lose_digits and expected.error == expected.error:
        bound = max(bound, _SURE * expected.error)
    return min(bound, MEANINGLESS)


def judged(expected: Expected, tolerance: float, error: float, indicator: float) -> Verdict:
    """Return the verdict on an error; `indicator` is the largest of the run's own."""
    trial, bound = expected.trial, bound_of(expected, tolerance)
    if not trial.may_lose_digits:
        return Verdict(classify(error, bound, indicator, trial.periods))
    lost = _nothing_to_compare(expected, tolerance)
    if lost is None and trial.truth.independent:
        return Verdict(classify(error, bound, indicator, trial.periods))
    checked = classify(indicator, MARGIN * tolerance * (1 + trial.periods), 0.0)
    if checked is not Outcome.RIGHT:
        return Verdict(checked, "energy or constraints", f"they drift by {indicator:.2g} of their terms")
    return lost or _compared(classify(error, bound, indicator, trial.periods), error)


def _compared(outcome: Outcome, error: float) -> Verdict:
    """Return what a comparison with other runs of this tool allows to say."""
    if error != error:
        return Verdict(Outcome.WRONG, "not finite")
    if outcome is Outcome.RIGHT:
        return Verdict(Outcome.AGREES)
    if outcome is Outcome.DEGRADED:
        return Verdict(outcome)
    return Verdict(Outcome.DIFFERS, "differs", f"it differs from two tight runs by {error:.2g} of the motion")


def _nothing_to_compare(expected: Expected, tolerance: float) -> Verdict | None:
    """Return a verdict if no digits can be compared."""
    kappa, own = expected.kappa, expected.error
    most = 1.0 if expected.trial.nearby else MEANINGLESS  # without near starts kappa is known by its size only
    if kappa * tolerance > most:
        words = f"perturbations grow by {kappa:.1g}: errors of the size of the tolerance grow to that of the motion"
        return Verdict(Outcome.NO_DIGITS, "growth of perturbations", words)
    if own != own:
        return Verdict(Outcome.NO_DIGITS, "nothing to compare with", expected.how)
    if _SURE * own <= MEANINGLESS:
        return None
    words = f"what it is compared with is uncertain by {own:.1g} of the motion"
    if expected.trial.truth.independent or kappa * MARGIN * tolerance > MEANINGLESS:
        return Verdict(Outcome.NO_DIGITS, "uncertain reference", words)
    return Verdict(Outcome.DIFFERS, "two formulations differ", words)
