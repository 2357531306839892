"""Derivatives of the eigenfactors and of eta with respect to the coordinates: (23), (24), the paper's reference 5."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arguments.named_values import Vector
from ..runtime import EvaluationError, StopReason


@dataclass(frozen=True, slots=True)
class EigenfactorGradient:
    """Eigenfactors M = C^T S^2 C at one position, in units of `System.scales`, and their derivatives.

    C : (n, n); s : (n,); dC : (n, n, n), dC[k] = dC / dx_k; ds : (n, n), ds[k] = ds / dx_k.
    """

    C: Vector
    s: Vector
    dC: Vector
    ds: Vector


def eigenfactor_gradient(
    M_gradient: Vector, C: Vector, s: Vector, scales: Vector, blocks: tuple[tuple[int, ...], ...]
) -> EigenfactorGradient:
    """Differentiate the eigenfactors: (30)-(35) with d/dx_k in place of d/dt.

    Parameters
    ----------
    M_gradient
        (n, n, n), [k, i, j] = dM_ij / dx_k.
    blocks
        Coordinates that M couples; eigenvectors turn only within a block.

    Raises
    ------
    EvaluationError
        Two eigenvalues of one block coincide while their axes turn: there is no derivative.
    """
    mu = C @ (scales[:, None] * M_gradient * scales) @ C.T
    gap = s[None, :] ** 2 - s[:, None] ** 2
    coupled = np.zeros((s.size, s.size), dtype=bool)
    for block in blocks:
        coupled[np.ix_(block, block)] = True
    turning = coupled & ~np.eye(s.size, dtype=bool)
    _refuse_coincident(gap, mu, turning)
    Omega = np.where(turning, mu / np.where(turning & (gap != 0.0), gap, 1.0), 0.0)
    return EigenfactorGradient(C, s, -Omega @ C, np.einsum("kii->ki", mu) / (2.0 * s))


def _refuse_coincident(gap: Vector, mu: Vector, turning: NDArray[np.bool_]) -> None:
    lost = turning & (gap == 0.0) & (mu != 0.0).any(axis=0)
    if lost.any():
        first, second = np.argwhere(lost)[0]
        raise EvaluationError(
            f"eigenvalues {first} and {second} coincide and their axes turn: the eigenfactors have no derivative there",
            StopReason.COINCIDENT_EIGENVALUES,
        )


def eta_sensitivity(gradient: EigenfactorGradient, eta: Vector) -> Vector:
    """Return J = d eta / dx at fixed xdot, (n, n): column k is (dS/dx_k + S dC/dx_k C^T) S^-1 eta (24)."""
    w = eta / gradient.s
    turning = gradient.s * (gradient.dC @ gradient.C.T @ w)
    return (gradient.ds * w + turning).T
