"""Outcome of a run: right, degraded, refused or wrong; for a user's model also what lies between."""

from dataclasses import dataclass
from enum import StrEnum
from math import pi

from .error_indicators import NOTHING_SHOWN, Indicators

MARGIN = 100.0  # bound of a right error, in tolerances times 1 + kappa
MEANINGLESS = 0.1  # largest bound, relative to the motion itself
DEGRADED = 100.0  # an error of up to this many bounds is degraded


class Outcome(StrEnum):
    """The outcome of a cell of the matrix; from best to worst."""

    RIGHT = "right"
    AGREES = "agrees"
    NO_DIGITS = "no digits"
    REFUSED = "refused"
    DEGRADED = "degraded"
    DIFFERS = "differs"
    WRONG = "wrong"


JUDGED_RIGHT = (Outcome.RIGHT, Outcome.AGREES)
"""Outcomes of runs that were compared, and passed."""
OF_OWN_MODELS = (Outcome.AGREES, Outcome.NO_DIGITS, Outcome.DIFFERS)
"""Outcomes that occur only with a user's model, whose motion may have no independent reference."""


RULES = {
    Outcome.RIGHT: f"The run says it succeeded, and its error is at most {MARGIN:g} x tolerance x (1 + kappa), "
    f"and at most {MEANINGLESS:g}.",
    Outcome.AGREES: "The same, but there is no independent reference: the rows are compared with those of two tight "
    "runs of this tool, by two formulations and two methods. A fault that both share stays hidden.",
    Outcome.NO_DIGITS: "Not judged: kappa x tolerance is above 1, so that an error of the size of the tolerance grows "
    "to the size of the motion; or what the run is compared with has no digits left itself. Energy, constraints and "
    "contacts are checked all the same.",
    Outcome.REFUSED: "No program, no start or no end, and a named reason instead.",
    Outcome.DEGRADED: f"The run says it succeeded with an error above that, but at most {DEGRADED:g} times that; or, "
    "over a span of N periods, at most 2 pi N times the largest of the run's own indicators: the drift of the energy, "
    "the residuals of constraints and eigenfactors, each relative to its own terms. (A frequency that is off by such "
    "a drift is out of phase by that.)",
    Outcome.DIFFERS: "There is no independent reference, and the run differs from two tight runs by more than that; or "
    "these differ from each other, although perturbations do not grow so much.",
    Outcome.WRONG: "The run says it succeeded with an error above all that; or it ended without a row for every time "
    "asked for, or with numbers that are not finite, or without a named reason; or a contact or a friction does what "
    "it may not at an accepted step.",
}


@dataclass(frozen=True, slots=True)
class Cell:
    """One run of the matrix. None: the number does not exist.

    error : largest, over rows and over components of x and v, of |y - y_ref| / (unit + max |y_ref|)
    bound : of a right error
    shown : the error indicators of the run
    """

    case: str
    point: str
    variant: str
    method: str
    tolerance: float
    outcome: Outcome = Outcome.REFUSED
    reason: str = ""
    message: str = ""
    error: float | None = None
    bound: float | None = None
    shown: Indicators = NOTHING_SHOWN
    nsteps: int | None = None
    nfev: int | None = None
    seconds: float = 0.0


def classify(error: float, bound: float, indicator: float, periods: float = 0.0) -> Outcome:
    """Return the outcome of a run that reports success; NaN is wrong."""
    if error <= bound:
        return Outcome.RIGHT
    return Outcome.DEGRADED if error <= max(DEGRADED * bound, 2 * pi * periods * indicator) else Outcome.WRONG
