"""Equations of an equilibrium, and their solution."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from ...arguments.named_values import Vector
from ...codegen.model import ModelError
from ...compiled.compiled_system import CompiledSystem
from ...runtime import EvaluationError
from ..state.operating_point import OperatingPoint

_SATISFIED = 1e-9
"""Largest residual of a solved equation, relative to its terms or to its value at the start."""

_STEPS = 200
"""Most steps of the downhill search."""
_FAR = 1e3
"""Tolerances are relative to the size of the solution, unless this is so many times the size of the given values."""
_LEAST = float(np.finfo(float).tiny)
"""Smaller numbers are denormal and have few digits."""
_NOWHERE = (EvaluationError, np.linalg.LinAlgError)
"""Exceptions at points without values."""


@dataclass(frozen=True)
class Balance:
    """Equations a = 0, phi = 0, A v + b = 0 for some of the arguments: x, v, inputs, parameters.

    names, given : of all arguments; free : indices of the unknowns; rows : indices of accelerations that must vanish
    """

    system: CompiledSystem
    names: tuple[str, ...]
    given: Vector
    free: tuple[int, ...]
    rows: tuple[int, ...]
    t: float

    @property
    def start(self) -> Vector:
        return self.given[list(self.free)]

    @property
    def of_coordinates_alone(self) -> bool:
        n = self.system.compiled.n
        return set(self.free) == set(range(n)) and not self.given[n : 2 * n].any()

    @property
    def of_states(self) -> bool:
        """Whether the unknowns are all coordinates and all first-order states of a system that has some, at rest."""
        c, n = self.system.compiled, self.system.n
        unknowns = (*range(n), *range(c.n + n, 2 * c.n))
        return bool(c.n_states) and self.free == unknowns and not self.given[c.n : c.n + n].any()

    def arguments(self, q: Vector) -> Vector:
        z = self.given.copy()
        z[list(self.free)] = q
        return z

    def point(self, q: Vector) -> OperatingPoint:
        n, k = self.system.compiled.n, len(self.system.compiled.inputs)
        x, v, u, p = np.split(self.arguments(q), [n, 2 * n, 2 * n + k])
        return OperatingPoint(self.system.compiled, self.system.prepare(p), self.t, x, v, u)

    def equations(self, q: Vector) -> tuple[Vector, Vector, Vector]:
        """Return the residuals, their derivatives with respect to all arguments, and the size of their terms.

        Accelerations are in units of inertia, constraints in units of their rows, so that the result does not depend on
        the user's units.
        """
        at = self.point(q)
        n, h = at.model.n, at.model.h
        a, da = at.motion[0], at.slopes
        D = at.constraints
        A, b = at.model.pfaffian(at.t, at.x, at.prepared)
        phi, terms = at.model.position(at.t, at.x, at.prepared)
        inverse = 1.0 / at.inertia
        length = np.sqrt(((A * inverse) ** 2).sum(axis=1))
        unit = 1.0 / np.where(length > 0.0, length, 1.0)
        rate = np.sqrt(np.linalg.norm(at.inertia[:, None] * da[:, :n] * inverse)) or 1.0
        weight = np.concatenate([at.inertia[list(self.rows)], unit[:h] * rate**2, unit * rate])
        value = np.concatenate([a[list(self.rows)], phi, A @ at.v + b])
        slope = np.vstack([da[list(self.rows)], D])[:, : len(self.given)]
        size = np.abs(slope) @ np.abs(self.arguments(q))
        size[: len(self.rows)] += at.reaction_terms[list(self.rows)]
        size[len(self.rows) : len(self.rows) + h] += terms
        return weight * value, weight[:, None] * slope, weight * size

    def solve(self, start: Vector) -> Vector:
        """Return the least-squares solution near `start`, accurate to rounding."""

        def value(q: Vector) -> Vector:
            try:
                return self.equations(q)[0]
            except EvaluationError:  # the solver tries a shorter step
                return np.full(len(self.rows) + self.system.h + self.system.m, np.nan)

        def slope(q: Vector) -> Vector:
            return self.equations(q)[1][:, list(self.free)]

        self._check_finite(start)
        found = least_squares(value, start, slope, x_scale=self.scale(start), xtol=1e-15, ftol=1e-15, gtol=1e-15)
        return self._cleaned(self._polished(np.asarray(found.x)), start)

    def _check_finite(self, start: Vector) -> None:
        """Raise ModelError if the equations, their slopes or their terms are not finite at the start."""
        if all(np.isfinite(numbers).all() for numbers in self.equations(start)):
            return
        largest = self.names[int(np.abs(self.given).argmax())]
        raise ModelError(
            f"{self.system.name}: accelerations, constraints or their derivatives are not finite where the search "
            f"begins; the largest number there is {largest} = {np.abs(self.given).max():.3g}. Begin elsewhere"
        )

    def scale(self, start: Vector) -> Vector:
        """Return the units of the unknowns; those of coordinates and rates follow from inertia."""
        at, n = self.point(start), self.system.compiled.n
        slope = self.equations(start)[1]
        inertia = at.inertia / np.linalg.norm(at.inertia) * np.sqrt(n)
        rate = np.sqrt(np.linalg.norm(at.inertia[:, None] * at.slopes[:, :n] / at.inertia)) or 1.0
        columns = np.linalg.norm(slope[:, 2 * n :], axis=0) / np.linalg.norm(at.inertia * rate**2)
        given = np.concatenate([1.0 / inertia, rate / inertia, 1.0 / np.where(columns > 0.0, columns, 1.0)])
        return np.asarray(given[list(self.free)])

    def _cleaned(self, q: Vector, start: Vector) -> Vector:
        """Replace numbers that are rounding errors by zero, if the residuals do not increase."""
        dust = np.abs(q) < 1e-9 * np.maximum(np.abs(start), np.abs(self.start))
        zeros = np.where(dust, 0.0, q)
        try:
            before, after = (np.linalg.norm(self.equations(point)[0]) for point in (q, zeros))
        except EvaluationError:  # such as a length much smaller than the guess, but not zero
            return q
        return zeros if after <= before else q

    def _polished(self, q: Vector) -> Vector:
        """Apply Newton's method as long as each step halves the residual."""
        value, slope, _ = self.equations(q)
        for _ in range(10):
            columns = slope[:, list(self.free)]
            scale = np.linalg.norm(columns, axis=0)
            scale = np.where(scale > 0.0, scale, 1.0)
            try:
                nearer = q - np.linalg.lstsq(columns / scale, value, rcond=1e-12)[0] / scale
                next_value, slope, _ = self.equations(nearer)
            except _NOWHERE:
                return q
            if not np.linalg.norm(next_value) < 0.5 * np.linalg.norm(value):
                return q
            q, value = nearer, next_value
        return q

    def follow_to_rest(self, start: Vector) -> Vector:
        """Follow dx/dt = a(x) by implicit steps, which grow as it slows down, to a stable equilibrium."""
        q, n, step, before = start, self.system.compiled.n, 0.0, np.inf
        for _ in range(_STEPS):
            try:
                at = self.point(q)
                slope, push = at.inertia[:, None] * at.slopes[:, :n] / at.inertia, at.inertia * at.motion[0]
            except EvaluationError:
                break
            left = float(np.linalg.norm(push))
            if not 0.0 < left < np.inf:
                break
            step = step * min(2.0, before / left) if step else 0.1 / float(np.linalg.norm(slope) or 1.0)
            before = left
            try:
                q = q + np.linalg.solve(np.eye(n) / step - slope, push) / at.inertia
                if self.system.h:
                    q = at.model.project(self.t, q, at.v, at.prepared, True)[0]
            except _NOWHERE:
                break
        return q

    def satisfied(self, q: Vector, start: Vector) -> bool:
        return not self.unsatisfied(q, start).any()

    def unsatisfied(self, q: Vector, start: Vector) -> NDArray[np.bool_]:
        """Return which residuals exceed the rounding of their terms, or of their values at the start."""
        first, _, size = self.equations(start)
        value, _, here = self.equations(q)
        here = np.where(np.linalg.norm(q) <= _FAR * np.linalg.norm(self.given), here, size)
        most, count = np.maximum(np.maximum(size, here), np.abs(first)), len(self.rows)
        limits = np.repeat([most[:count].max(initial=0.0), most[count:].max(initial=0.0)],
                           [count, len(value) - count])  # fmt: skip
        if value.any() and self.point(q).unresolved:
            limits = np.zeros_like(limits)
        return np.asarray(~(np.abs(value) <= _SATISFIED * limits + _LEAST))
