"""Noise of measured quantities, estimated from residuals, and the covariance of estimates."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import scipy

from ...arguments.named_values import Vector
from ...codegen.model.normalise import ModelError
from .experiment import Evaluation
from .measurements import Quantity


def floors(quantities: tuple[Quantity, ...], rtol: float) -> Vector:
    """Return the standard deviations below which residuals are errors of the run itself."""
    sizes = [float(np.sqrt(np.mean(q.samples[q.seen] ** 2))) for q in quantities]
    return np.array([rtol * size if size else np.finfo(float).tiny ** 0.5 for size in sizes])


def first_deviations(quantities: tuple[Quantity, ...]) -> Vector:
    """Return standard deviations to begin with: known ones, and otherwise the spread of the samples."""
    made = []
    for q in quantities:
        values = q.samples[q.seen]
        spread = float(values.std()) or float(np.abs(values).max()) or 1.0
        made.append(q.deviation if q.deviation is not None else spread)
    return np.array(made)


@dataclass(frozen=True)
class Linearised:
    """Residuals and derivatives at a point, of samples with a variance of 1.

    residual : (samples,); Q, R : of the derivatives (samples, k) by unknowns, each in units of `length` (k,)
    parts : the rows of each quantity
    """

    residual: Vector
    Q: Vector
    R: Vector
    length: Vector
    parts: tuple[slice, ...]

    @property
    def explained(self) -> float:
        """The length of the part of the residual that another step would remove."""
        return float(np.linalg.norm(self.Q.T @ self.residual))

    @property
    def gain(self) -> Vector:
        """(k, samples) derivatives of estimates by samples."""
        return np.asarray(scipy.linalg.solve_triangular(self.R, self.Q.T) / self.length[:, None])

    @property
    def freedoms(self) -> Vector:
        """(quantities,) samples less what estimates take of them."""
        return np.array([part.stop - part.start - float((self.Q[part] ** 2).sum()) for part in self.parts])

    def estimated(self, deviations: Vector) -> Vector:
        """Return the standard deviation of each quantity from its own residuals."""
        squares = np.array([float(self.residual[part] @ self.residual[part]) for part in self.parts])
        return np.asarray(deviations * np.sqrt(squares / np.maximum(self.freedoms, 1e-300)))


def weighted(evaluation: Evaluation, deviations: Vector) -> tuple[Vector, Vector]:
    """Return residuals (samples,) and derivatives (samples, k) of samples with a variance of 1."""
    residual = np.concatenate([r / s for r, s in zip(evaluation.residuals, deviations, strict=True)])
    return residual, np.vstack([D / s for D, s in zip(evaluation.slopes, deviations, strict=True)])


def linearised(evaluation: Evaluation, deviations: Vector, free: list[int]) -> Linearised:
    """Return an evaluation by the unknowns `free` (indices), whose derivatives are independent."""
    residual, slopes = weighted(evaluation, deviations)
    length = np.linalg.norm(slopes[:, free], axis=0)
    Q, R = np.linalg.qr(slopes[:, free] / length)
    ends = np.cumsum([0, *(len(r) for r in evaluation.residuals)]).tolist()
    parts = tuple(slice(a, b) for a, b in pairwise(ends))
    return Linearised(residual, Q, R, length, parts)


def check_freedoms(model: str, quantities: tuple[Quantity, ...], freedoms: Vector, estimates: int) -> None:
    """Raise ModelError if the noise of a quantity is to be estimated from too few samples."""
    for q, free in zip(quantities, freedoms, strict=True):
        if q.deviation is None and free < 0.5:
            raise ModelError(f"{model}: {q.count} samples of {q.name!r} do not tell their own noise beside {estimates} "
                             "unknowns. Give its deviation, or more samples.")  # fmt: skip


def freedoms_of_estimates(gain: Vector, parts: tuple[slice, ...], freedoms: Vector) -> Vector:
    """Return the freedoms (k,) of the variances of estimates, sums of those of quantities (Satterthwaite 1946).

    freedoms : (quantities,), infinite where the deviation is known
    """
    shares = np.array([(gain[:, part] ** 2).sum(axis=1) for part in parts])
    inverse = (shares**2 / freedoms[:, None]).sum(axis=0) / shares.sum(axis=0) ** 2
    return np.asarray(1.0 / np.maximum(inverse, 1e-12))
