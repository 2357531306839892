"""What becomes of a run, and when it counts as right, degraded, refused or wrong."""

from dataclasses import dataclass
from enum import StrEnum

from ..codegen.lower import FORMULATIONS

MARGIN = 100.0  # a right error is at most this many tolerances times 1 + kappa
DEGRADED = 100.0  # and one that is larger by no more than this is degraded
VISIBLE = 100.0  # an indicator of a run shows an error where it is above this many tolerances


class Outcome(StrEnum):
    """How a cell of the matrix ended; from best to worst."""

    RIGHT = "right"
    REFUSED = "refused"
    DEGRADED = "degraded"
    WRONG = "wrong"


RULES = {
    Outcome.RIGHT: f"The run says it succeeded, and its error is at most {MARGIN:g} x tolerance x (1 + kappa).",
    Outcome.REFUSED: "No program, no start or no end, and a named reason instead.",
    Outcome.DEGRADED: "The run says it succeeded with an error above that, and either the error is at most "
    f"{DEGRADED:g} times that, or the run's own indicators show it: a drift of the energy, a residual of the "
    f"constraints or of the eigenfactors, each relative to its own terms, is above {VISIBLE:g} x tolerance.",
    Outcome.WRONG: "The run says it succeeded with an error above all that, and nothing shows it; or it ended "
    "without a row for every time asked for, or with numbers that are not finite, or without a named reason.",
}


@dataclass(frozen=True, slots=True)
class Variant:
    """A formulation and its options."""

    formulation: str
    close_eigenvalues: str = "bounded"
    schur: str = "auto"
    stabilisation: str = "project"
    dependent_constraints: str = "refuse"

    @property
    def label(self) -> str:
        """Name it by what differs from the defaults."""
        defaults = {"bounded", "auto", "project", "refuse"}
        words = {"eigenfactor": "schur eigenfactor", "none": "not stabilised", "least_norm": "least norm"}
        chosen = (self.close_eigenvalues, self.schur, self.stabilisation, self.dependent_constraints)
        return ", ".join([self.formulation, *(words.get(c, c) for c in chosen if c not in defaults)])

    @property
    def build(self) -> dict[str, str]:
        """Return the options of `eigenmotion.build`."""
        return {
            "formulation": self.formulation, "close_eigenvalues": self.close_eigenvalues, "schur": self.schur,
        }  # fmt: skip

    @property
    def run(self) -> dict[str, str]:
        """Return the options of `eigenmotion.simulate`."""
        return {"stabilisation": self.stabilisation, "dependent_constraints": self.dependent_constraints}


PLAIN = tuple(Variant(formulation) for formulation in FORMULATIONS)
EXTRAPOLATE = Variant("eigenfactor", close_eigenvalues="extrapolate")
UNSTABILISED = Variant("eigenfactor", stabilisation="none")
IMPLICIT = (Variant("eigenfactor"), Variant("lagrange"))  # these methods integrate x and v in every formulation
UNCONSTRAINED = (*PLAIN, EXTRAPOLATE, UNSTABILISED)
CONSTRAINED = (*UNCONSTRAINED, Variant("lagrange", stabilisation="none"))
SEVERAL_ROWS = (*CONSTRAINED, Variant("eigenfactor", schur="eigenfactor"))
DEPENDENT_ROWS = (*SEVERAL_ROWS, *(Variant(f, dependent_constraints="least_norm") for f in ("eigenfactor", "lagrange")))


@dataclass(frozen=True, slots=True)
class Cell:
    """One run of the matrix. None: there is no such number.

    error : largest, over rows and over components of x and v, of |y - y_ref| / (unit + max |y_ref|)
    bound : of a right error
    energy : largest |P(t) - P(t0)| relative to the energies exchanged, P = T2 - T0 + V; where P is conserved
    constraint, position : largest |A v + b| and |phi| relative to the terms that cancel in them
    factor : largest max|M - C^T S^2 C| / max|M|
    energy_slope, position_slope : least-squares slopes of `energy` and `position` a period
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
    energy: float | None = None
    constraint: float | None = None
    position: float | None = None
    factor: float | None = None
    energy_slope: float | None = None
    position_slope: float | None = None
    nsteps: int | None = None
    nfev: int | None = None
    seconds: float = 0.0

    @property
    def indicator(self) -> float:
        """The largest of what the run itself shows."""
        return max((i for i in (self.energy, self.constraint, self.position, self.factor) if i is not None), default=0.0)


def judged(error: float, bound: float, indicator: float, tolerance: float) -> Outcome:
    """Return the outcome of a run that says it succeeded; NaN is wrong."""
    if error <= bound:
        return Outcome.RIGHT
    if error <= DEGRADED * bound or indicator > VISIBLE * tolerance:
        return Outcome.DEGRADED
    return Outcome.WRONG
