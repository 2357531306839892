"""Curve of equilibria."""

from dataclasses import dataclass, replace

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from ...runtime import EvaluationError
from ..equilibrium.equilibrium_equations import Balance
from ..linear.linearize import linearized
from .contact_limits import meeting_at, reached_limit
from .curve import Meeting, NoPointError, Sample, Spectrum

_NOISE = 1e-11
"""Residuals that are errors, relative to the terms of the equations."""
_ERROR = 1e-8
"""Errors of eigenvalues, relative to the largest: double ones have half of the digits."""
_SMALLEST = 1e-2
"""Least unit of coordinates, relative to that at the start."""


@dataclass(frozen=True)
class EquilibriumCurve:
    """Equilibria along a parameter, the last unknown of the balance. extent : its interval's length."""

    balance: Balance
    extent: float

    def at(self, w: Vector) -> Sample:
        """Return the equations at a place."""
        try:
            F, slope, size = self.balance.equations(w)
            unit = self._units(w)
        except EvaluationError as error:
            raise NoPointError(str(error)) from error
        if not (np.isfinite(F).all() and np.isfinite(slope).all()):
            raise NoPointError("accelerations, constraints or their derivatives are not finite")
        J = slope[:, list(self.balance.free)] * unit
        weight = 1.0 / max(float(np.linalg.norm(J, 2)), 1e-300)
        return Sample(w, unit, np.diag(unit), F * weight, J * weight, _NOISE * float(size.max()) * weight, w)

    def _units(self, w: Vector) -> Vector:
        scale = self.balance.scale(self.balance.start)
        first, here = (float(np.linalg.norm((one / scale)[:-1])) for one in (self.balance.start, w))
        unit = scale * (min(1.0, max(here, _SMALLEST * first)) if first else 1.0)
        unit[-1] = self.extent
        return np.asarray(unit)

    def spectrum(self, sample: Sample) -> Spectrum:
        """Return the eigenvalues of the linearised equations of motion."""
        try:
            values = linearized(self.balance.point(sample.w)).eigenvalues().astype(complex)
        except (EvaluationError, ModelError) as error:
            raise NoPointError(str(error)) from error
        errors = np.full(len(values), _ERROR * np.abs(values).max(initial=0.0))
        grows = (values.real > errors).any()
        return Spectrum(values, errors, False if grows else True if (values.real < -errors).all() else None)

    def obstacle(self, before: Sample, after: Sample) -> str:
        """Return that the contact mode ends between two points, or ""."""
        meeting = self.meeting(before, after)
        return meeting.words if meeting else ""

    def meeting(self, before: Sample, after: Sample | None) -> Meeting | None:
        """Return the end of the contact mode between two points, or None."""
        if after is None:
            return None
        first, second = self.balance.point(before.w), self.balance.point(after.w)
        limit = reached_limit(first, second)
        return None if limit is None else meeting_at(limit, first, self.balance.point)


def curve_of(balance: Balance, start: Vector, extent: float) -> EquilibriumCurve:
    """Return the curve through a solution of a balance, over an interval of the parameter."""
    return EquilibriumCurve(replace(balance, given=balance.arguments(start)), extent)
