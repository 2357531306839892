"""Whether an integration that nothing projects is still one of the mechanism: em_check_drift of em_guard.h."""

from dataclasses import dataclass

import numpy as np
from scipy.linalg import qr

from ..arguments.names import Vector
from ..arguments.options import Task
from ..runtime import EvaluationError, StopReason, explain
from .consistent import length

_DRIFTED = 0.3  # x and v may be off the constraints by this part of the largest distance and velocity so far
_FARTHEST = 10.0  # and by this many times the tolerances


@dataclass(slots=True)
class Drift:
    """How far and how fast a run got [sqrt(J) s, sqrt(J)], in the mass metric."""

    task: Task
    farthest: float = 0.0
    fastest: float = 0.0

    def check(self, t: float, z: Vector) -> None:
        """Raise EvaluationError where the constraints turn within what z = (x, v) has drifted off them."""
        model, c, n = self.task.model, self.task.prepared, self.task.model.n
        if model.h == 0:
            return
        x, v = z[:n], z[n:]
        M = model.factored_matrix(t, x, c)
        self.farthest = max(self.farthest, length(M, x - self.task.y[:n]))
        self.fastest = max(self.fastest, length(M, v))
        near_x, near_v = model.project(t, x, v, c, self.task.least_norm)
        allowed = (_FARTHEST * length(M, self.task.atol + self.task.rtol * np.abs(q)) for q in (x, v))
        if length(M, near_x - x) > _DRIFTED * self.farthest + next(allowed):
            raise self._failure(t, x, M)
        if length(M, near_v - v) > _DRIFTED * self.fastest + next(allowed):
            raise self._failure(t, x, M)

    def _failure(self, t: float, x: Vector, M: Vector) -> EvaluationError:
        """Return a failure that names the row which adds least to the others."""
        A = self.task.model.pfaffian(t, x, self.task.prepared)[0]
        weakest = int(qr(np.linalg.solve(np.linalg.cholesky(M), A.T), mode="r", pivoting=True)[1][-1])
        stop = StopReason.DEPENDENT_CONSTRAINTS
        return EvaluationError(explain(stop, self.task.model.coordinates, weakest), stop)
