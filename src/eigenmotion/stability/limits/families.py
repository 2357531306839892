"""Cases that are generated from a model: tolerances, singular positions, spans and parameters."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model import Model
from ..cases.case import TOLERANCES as METHODS
from ..cases.case import Case, Trial, power
from ..cases.variants import Variant
from .singular_search import SingularPosition
from .subject import PERIODS, SPAN, Subject, swept

TOLERANCES = (1e-8, 1e-4, 1e-12, 1e-6, 1e-10)
DISTANCES = (1e-3, 1e-6, 1e-1, 1e-9, 1e-2, 1e-4, 1e-5, 1e-7, 1e-8)
SPANS = (10.0, 100.0, 1.0, 1000.0)
FACTORS = (1e-2, 1e2, 1e-4, 1e4, 1e-1, 1e1, 1e-6, 1e6)
"""Values in the order in which they are run: what is left out when time runs out is what is named last."""
PARAMETER = "parameter_"
_MOST_STEPS = 20_000


@dataclass(frozen=True)
class Families:
    """The trials of one subject; methods of this can be sent to other processes."""

    own: Subject

    def model(self, _: float) -> Model:
        return self.own.model

    def at_tolerance(self, tolerance: float) -> Trial:
        return self.own.trial(power(tolerance), tolerance=tolerance)

    def over(self, periods: float) -> Trial:
        return self.own.trial(power(periods), span=periods * self.own.period, periods=periods)

    def with_parameter(self, name: str, value: float, factor: float) -> Trial:
        return self.own.trial(power(factor), {name: factor * value})

    def near(self, position: SingularPosition, distance: float) -> Trial:
        return self.own.trial(power(distance), start=(position.near(distance, self.own.lengths), self._moving()))

    def _moving(self) -> Vector:
        """Return the velocity of the start, or the greatest of the motion if it starts at rest."""
        n = len(self.own.x0)
        if np.any(self.own.v0):
            return self.own.v0
        rates = self.own.motion[:, n : 2 * n]
        return np.asarray(rates[np.argmax(np.linalg.norm(rates, axis=1))])


def families(own: Subject, found: Sequence[SingularPosition]) -> tuple[Case, ...]:
    """Return the cases of a subject, in the order in which they are run."""
    made = Families(own)
    steps = max(3_000, _MOST_STEPS // max(1, len(own.x0) // 2))
    variants = tuple(Variant(name, dependent_constraints="auto") for name in own.formulations)
    blank = Case("", "", "", "", (), made.model, made.at_tolerance, (), variants, dict(METHODS), steps)
    span = f"{own.span:.4g} s"
    return (
        replace(blank, name="tolerances", title="Tolerances", axis="rtol", values=TOLERANCES,
                about=f"The model's own motion over {span} at tighter and tighter tolerances."),
        *(_near(blank, made, position) for position in found),
        replace(blank, name="spans", title="Long spans", axis="periods", values=SPANS, trial=made.over,
                about=f"The model's own motion over 1 to 1000 of its characteristic periods of {own.period:.3g} s.",
                max_steps=20 * steps),
        *(_sweep(blank, made, name, value) for name, value in swept(own.model, own.parameters)),
    )  # fmt: skip


def _near(blank: Case, made: Families, position: SingularPosition) -> Case:
    what = position.what
    return replace(
        blank, name=f"singular_{what}".replace(" ", "_"), title=f"Starts near a singular position: {what}",
        axis="distance", values=DISTANCES, trial=partial(made.near, position),
        about=f"Starts at distances from a singular position of the {what}, in units of the coordinates, on the "
        "line to the model's start; with its velocity, or if that is zero with the greatest of its motion, projected "
        "onto the constraints.",
    )  # fmt: skip


def _sweep(blank: Case, made: Families, name: str, value: float) -> Case:
    return replace(
        blank, name=f"{PARAMETER}{name}", title=f"Parameter {name}", axis=f"{name} / {value:.6g}", values=FACTORS,
        trial=partial(made.with_parameter, name, value),
        about=f"The parameter {name} times a factor; all others are the model's. Loops are closed again by the nearest "
        f"start. Runs take {SPAN:g} characteristic periods of the model, or {PERIODS} of the fastest oscillation if "
        "that is less.",
    )  # fmt: skip
