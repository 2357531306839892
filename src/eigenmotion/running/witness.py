"""What an implicit run knows about itself: em_witness.h and em_chart.h, for steps that cannot be tried again."""

from dataclasses import dataclass, field

import numpy as np
from scipy.linalg.lapack import dpotrf

from ..arguments.names import Vector
from ..arguments.options import Task
from ..runtime import EvaluationError, StopReason, explain

_EVERY = 16  # accepted steps
_STEP_MAY, _RUN_MAY = 10.0, 100.0  # tolerances by which every step may change the energy, and a run as a whole
_BRIEF = 0.1  # the part of the longest step below which one is looked at
_PASSAGE_ADDS = 1e-4  # part of eps / p, p the least pivot of M beside its entry, that a passage adds to the error
_EPSILON = float(np.finfo(float).eps)


@dataclass(slots=True)
class Witness:
    """Holds accepted steps against T2 - T0 + V, and against what rounding leaves of M."""

    task: Task
    energy: float = field(init=False, default=np.nan)
    tolerance: float = field(init=False, default=0.0)
    longest: float = field(init=False, default=0.0)
    steps: int = field(init=False, default=0)

    def begin(self, z: Vector) -> None:
        """Take the energy of z = (x, v) (2 n,) at the start; raise EvaluationError where it is not finite."""
        if self._conserved():
            self.energy, self.tolerance = (
                self._energies(self.task.t_start, z[None])[0],
                self._allowed(self.task.t_start, z),
            )
            if not np.isfinite(self.energy):
                raise self._failure(StopReason.ENERGY_DRIFTED)

    def check(self, t: float, z: Vector, h: float) -> None:
        """Raise EvaluationError where a step of size h that ended in z at t has left the motion."""
        self.steps += 1
        self.longest = max(self.longest, h)
        if h < _BRIEF * self.longest:
            self._check_rounding(t, z[: self.task.model.n])
        if self._conserved() and (self.steps % _EVERY == 0 or t == self.task.t_end):
            self._check_energy(t, z)

    def _conserved(self) -> bool:
        return self.task.model.conserves_energy and self.task.model.m == 0

    def _check_energy(self, t: float, z: Vector) -> None:
        drift = abs(self._energies(t, z[None])[0] - self.energy)
        may = _RUN_MAY + _STEP_MAY * self.steps
        if not drift <= 0.1 * may * self.tolerance:
            self.tolerance = max(self.tolerance, self._allowed(t, z))
        if not drift <= may * self.tolerance:
            raise self._failure(StopReason.ENERGY_DRIFTED)

    def _allowed(self, t: float, z: Vector) -> float:
        """Return what the energy changes by with x and v, one after the other, by their tolerances, and by rounding."""
        near = z + np.diag(np.tile(self.task.atol, 2) + self.task.rtol * np.abs(z))
        change = np.abs(self._energies(t, near) - self._energies(t, z[None]))
        return float(change[np.isfinite(change)].sum() + _EPSILON * np.abs(self._terms(t, z[None])).sum())

    def _energies(self, t: float, z: Vector) -> Vector:
        T2, _, T0, V = self._terms(t, z).T
        energies: Vector = T2 - T0 + V
        return energies

    def _terms(self, t: float, z: Vector) -> Vector:
        """Return T2, T1, T0, V (k, 4) at z (k, 2 n)."""
        x, v = (np.ascontiguousarray(half) for half in np.hsplit(z, 2))
        return self.task.model.energy_rows(np.full(len(z), t), x, v, self.task.prepared)

    def _check_rounding(self, t: float, x: Vector) -> None:
        M = self.task.model.factored_matrix(t, x, self.task.prepared)
        L, singular = dpotrf(M, lower=1)
        pivots = np.diag(L) ** 2
        if singular > 0:
            pivots[singular - 1 :] = 0.0
        lost = ~(pivots * self.task.rtol > _PASSAGE_ADDS * _EPSILON * np.diag(M))
        if lost.any():
            raise self._failure(StopReason.SINGULAR_MASS_MATRIX, int(np.argmax(lost)))

    def _failure(self, stop: StopReason, first: int = -1) -> EvaluationError:
        return EvaluationError(explain(stop, self.task.model.coordinates, first, -2), stop)
