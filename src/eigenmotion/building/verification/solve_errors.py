"""Error bounds of the compiled linear solves, from the terms of their right-hand sides and condition numbers."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...arguments.named_values import Vector
from .arithmetic.rounding_bounds import EPS, Rounded, applied, geometric, inverse, rounded
from .compiled_values import CompiledValues
from .symbolic_values import SymbolicValues


@dataclass(frozen=True)
class Errors:
    """Bounds at k points.

    solved : (k, n) bound of the residual of M a = f - A^T lambda, with a computed by a root of M
    W : M^-1; None without rows, as of many coordinates this takes long
    free : (k, n) sizes of the terms of a = M^-1 f - M^-1 A^T lambda, which may cancel
    """

    compiled: CompiledValues
    symbolic: SymbolicValues
    terms: list[Rounded]
    solved: Vector
    W: Rounded | None
    free: Vector

    @property
    def a(self) -> Vector:
        """Bound (k, n) of the accelerations."""
        return self._of_solution[0]

    @property
    def rows(self) -> Vector:
        """Bound (k, m) of A a + gamma for these accelerations."""
        A = self.symbolic.A.value
        return self._of_solution[1] if A.shape[1] else np.zeros(A.shape[:2])

    @cached_property
    def _of_solution(self) -> tuple[Vector, Vector]:
        compiled, symbolic = self.compiled, self.symbolic
        W = inverse(symbolic.M) if self.W is None else self.W
        left = sum((term.bound for term in self.terms), self.solved)
        wide = np.abs(W.value)
        alone = _times(wide, left + _times(symbolic.M.bound, self.free))
        delta = symbolic.A @ W @ symbolic.A.turned
        lost = _times(np.abs(symbolic.A.value), alone) + symbolic.row_rate.bound
        rows = lost + _times(delta.bound + EPS * geometric(delta.value), np.abs(compiled.multipliers))
        pushed = _times(np.abs(inverse(delta).value), rows)
        moved = _times(wide, _times(np.abs(symbolic.A.value).swapaxes(1, 2), pushed))
        rows[compiled.least_norm != 0.0] = np.inf  # dependent rows may contradict each other off the constraints
        return alone + moved, rows


def errors(compiled: CompiledValues, symbolic: SymbolicValues, terms: list[Rounded], recursive: bool = False) -> Errors:
    """Return bounds for lambda = Delta^-1 (A M^-1 f + gamma), a = M^-1 (f - A^T lambda), with errors eps of each term.

    Here M is the factored matrix, and `terms` are the terms of Lagrange's equations. If `recursive`, each equation has
    the errors of the others too, since bodies pass on forces in axes of their own.
    """
    sizes, free, W = geometric(compiled.factored), np.abs(compiled.a), None
    if symbolic.A.value.shape[1]:
        W = inverse(symbolic.M)
        free = free + np.abs(applied(W, applied(symbolic.A.turned, rounded(compiled.multipliers))).value)
    solved = EPS * _times(sizes, free)
    if recursive:
        square = np.abs(np.einsum("kii->ki", compiled.factored))
        forces = sum(np.abs(term.value) for term in terms) / np.where(square > 0.0, square, np.inf)
        solved = solved + EPS * _times(sizes, forces)
    return Errors(compiled, symbolic, terms, solved, W, free)


def _times(M: Vector, v: Vector) -> Vector:
    return np.asarray(np.einsum("kij,kj->ki", M, v))
