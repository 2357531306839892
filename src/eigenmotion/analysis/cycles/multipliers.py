"""Floquet multipliers of a closed motion, without those of its own directions."""

from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from ...arguments.named_values import Vector
from .newton import growth
from .periodic_problem import Problem
from .returns import Return


class Multipliers(NamedTuple):
    """values : (k,) complex, the largest first; errors : (k,) estimated."""

    values: NDArray[np.complex128]
    errors: Vector

    @property
    def neutral(self) -> int:
        """The number of multipliers that are 1 within their errors."""
        return int((np.abs(self.values - 1.0) <= self.errors).sum())

    @property
    def stable(self) -> bool | None:
        """Whether deviations decay; None if the largest multiplier is 1 in size within its error."""
        excess = np.abs(self.values) - 1.0
        if (excess > self.errors).any():
            return False
        return True if (excess < -self.errors).all() else None


def multipliers_of(problem: Problem, one: Return) -> Multipliers:
    """Return the eigenvalues of the derivative of the motion over a period, modulo its own directions.

    Those are the direction of the motion, if equations do not depend on time, and of coordinates that advance freely.
    Their multipliers are 1, and the difference from 1 that is found measures the error of all.
    """
    free = list(one.basis.free)
    unit = one.scale[free]
    M = problem.symmetry.undone(one.S)[free] / unit[:, None] * unit
    own = [np.eye(len(one.q))[k][free] for k in problem.free_advance]
    if not problem.clock:
        own.append(one.flow[free] / unit)
    W = np.array(own).reshape(-1, len(free)).T
    W = W / np.linalg.norm(W, axis=0)
    error = 100.0 * problem.rtol * growth(one)
    if W.size:
        error = max(error, float(np.linalg.norm(M @ W - W, axis=0).max()))
    Q = scipy.linalg.qr(W)[0][:, W.shape[1] :] if W.size else np.eye(len(free))
    return _sorted(Q.T @ M @ Q, error)


def _sorted(M: Vector, error: float) -> Multipliers:
    if not len(M):
        return Multipliers(np.zeros(0, dtype=complex), np.zeros(0))
    values, left, right = scipy.linalg.eig(M, left=True, right=True)
    cosines = np.abs((left.conj() * right).sum(axis=0))
    least = error / np.maximum(np.linalg.norm(M, 2), 1.0)  # a double one moves by the root of the error
    errors = np.minimum(error / np.maximum(cosines, 1e-300), max(1.0, float(np.linalg.norm(M, 2))) * least**0.5)
    errors = np.maximum(errors, error)
    order = np.lexsort((-values.imag, -np.round(np.abs(values), 14)))
    return Multipliers(values[order].astype(complex), errors[order])
