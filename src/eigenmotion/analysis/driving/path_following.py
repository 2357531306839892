"""Motions of mechanisms of which some coordinates are prescribed: the others follow from the constraints.

The rates of the others solve A_D v_D = -(A_P v_P + b), and those of first-order states their own equations. Both are
integrated from time to time, and each position is then closed: phi(x, t) = 0, by Newton's method. While A_D has full
rank, the motion is unique (the theorem on implicit functions). Where it loses its rank, branches of the motion meet: a
dead centre, at which this stops.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import scipy

from ...arguments.named_values import Vector
from ...arguments.signals import Inputs
from ...codegen.model.normalise import ModelError
from ...compiled.projection import closure
from ...runtime import CompiledModel, Prepared
from .prescribed_paths import Path

_PREDICTOR = 1e-4
"""Relative error of a step whose positions are closed afterwards: the closure corrects it."""
_INTEGRATOR = 1e-11
"""Relative error of a step that nothing corrects: nonholonomic constraints, and states."""
_SINGULAR = 1e-7
"""Least singular value of A_D, with unit rows of A in the mass metric, at full rank."""
_NEARLY_SINGULAR = 0.03
"""That value relative to the start's, where a position cannot be closed: beyond a dead centre nothing is reached."""
_CONTRACTION = 0.25
"""Largest ratio of two corrections of Newton's method if the branch is the predicted one."""
_ROUNDED = 1e-9
"""Corrections below this part of x may be rounding."""
_MOST_CORRECTIONS = 12
_KEPT = 0.5
"""Least part of the determinant of A_D that is left after a step."""
_SHORTEST = 1e-8
"""Shortest step, as a part of the interval between two times."""
_CLOSED = 1e4
"""Largest residual phi, in roundings of its terms."""


@dataclass(frozen=True)
class Follower:
    """A mechanism of which some coordinates have paths.

    x, v, a in these methods have the integrals, values and rates of states behind the coordinates: (n + p,).

    Parameters
    ----------
    first, start : the first time, and x there
    """

    model: CompiledModel
    prepared: Prepared
    paths: Sequence[Path]
    inputs: Inputs
    start: Vector
    first: float

    @cached_property
    def unit(self) -> Vector:
        """(n + p,) 1 / sqrt(M_kk) at the start: changes of coordinates in these units can be compared."""
        M = self.model.factored_matrix(self.first, self.start, self.prepared)
        return np.asarray(1.0 / np.sqrt(np.diag(M)))

    @cached_property
    def prescribed(self) -> list[int]:
        """Indices of the prescribed coordinates."""
        return [path.index for path in self.paths]

    @cached_property
    def dependent(self) -> list[int]:
        """Indices of the other coordinates."""
        return [k for k in range(self.model.n_coordinates) if k not in self.prescribed]

    @cached_property
    def is_integrated(self) -> bool:
        """Whether some positions or states are known from their rates alone."""
        return bool(self.model.n_states) or self.model.m > self.model.h

    def follow(self, times: Vector, z: Vector) -> tuple[Vector, Vector, Vector]:
        """Return x, v, a (k, n + p) at times (k,); z (p,) are the states at the first.

        Raises
        ------
        ModelError
            The position is singular, or the mechanism cannot be closed; names the time and the coordinates.
        """
        t = float(times[0])
        w = np.concatenate([self._closed(t, self.start)[self.dependent], z])
        self._check_rank(t, self._placed(t, w)[0])
        rows = [self._row(t, w)]
        for end in map(float, times[1:]):
            w, t = self._advanced(t, end, w), end
            rows.append(self._row(t, w))
        x, v, a = (np.array(column) for column in zip(*rows, strict=True))
        return x, v, a

    def _placed(self, t: float, w: Vector) -> tuple[Vector, Vector]:
        """Return x and v (n + p,) with the paths and w = (x_D, z) in them; v_D is 0."""
        x, v, n, d = self.start.copy(), np.zeros(self.model.n), self.model.n_coordinates, len(self.dependent)
        for path in self.paths:
            x[path.index], v[path.index], _ = path(t)
        x[self.dependent], v[n:] = w[:d], w[d:]
        return x, v

    def _moving(self, t: float, w: Vector) -> tuple[Vector, Vector]:
        """Return x and v (n + p,)."""
        x, v = self._placed(t, w)
        if self.dependent:
            A, b = self.model.pfaffian(t, x, self.prepared)
            v[self.dependent] = self._solved(A, -(A @ v + b))
        return x, v

    def _solved(self, A: Vector, right: Vector) -> Vector:
        """Return the y of least norm with A_D y = right, of all rows or some of them."""
        unit = self.unit[self.dependent]
        columns = A[:, self.dependent] * unit
        if len(columns) == len(unit):
            try:
                return np.asarray(np.linalg.solve(columns, right) * unit)
            except np.linalg.LinAlgError:
                pass  # singular: the caller names the dead centre
        length = np.linalg.norm(A * self.unit, axis=1)
        length[length == 0.0] = 1.0
        return np.asarray(np.linalg.lstsq(columns / length[:, None], right / length, rcond=_SINGULAR)[0] * unit)

    def _row(self, t: float, w: Vector) -> tuple[Vector, Vector, Vector]:
        """Return x, v, a (n + p,)."""
        x, v = self._moving(t, w)
        a = np.zeros(self.model.n)
        for path in self.paths:
            a[path.index] = path(t)[2]
        required, gamma = self._required(t, x, v, a)
        if self.dependent:
            A, _ = self.model.pfaffian(t, x, self.prepared)
            a[self.dependent] = self._solved(A, -gamma)
        a[self.model.n_coordinates :] = -required[self.model.n_coordinates :]
        return x, v, a

    def _required(self, t: float, x: Vector, v: Vector, a: Vector) -> tuple[Vector, Vector]:
        """Return M a - f (n + p,), of which the last p are minus the rates of states, and A a + gamma (m,)."""
        u = self.inputs.at(np.array([t]))
        forces, rows = self.model.required_rows(np.array([t]), x[None], v[None], a[None], u, self.prepared)
        return forces[0], rows[0]

    # --- from one time to the next ---

    def _advanced(self, t: float, end: float, w: Vector) -> Vector:
        """Return w at the end of an interval.

        A step is repeated with half its length where the determinant of A_D falls below half, so that no step passes a
        zero of it: the steps towards a dead centre become ever shorter, and it is named.
        """
        step, least, failure = end - t, _SHORTEST * (end - t), None
        while t < end and len(w):
            try:
                later, after = self._stepped(t, min(end, t + step), w)
            except ModelError as error:  # not closed: the step may be too long
                step, failure = step / 2, error
            else:
                if self._keeps_rank((t, w), (later, after)):
                    step, t, w, failure = 2.0 * (later - t), later, after, None
                else:
                    step = (later - t) / 2
            if step < least:
                raise failure or self._singular(t, self._placed(t, w)[0])
        self._check_rank(end, self._placed(end, w)[0])
        return w

    def _stepped(self, t: float, end: float, w: Vector) -> tuple[float, Vector]:
        """Return a time up to the end, as far as the error of a step allows, and w there, closed."""
        of = scipy.integrate
        method, rtol = (of.DOP853, _INTEGRATOR) if self.is_integrated else (of.RK23, _PREDICTOR)
        x, v = self._moving(t, w)
        reach = np.linalg.norm(x / self.unit) + (end - t) * np.linalg.norm(v / self.unit)
        least = np.concatenate([reach * self.unit[self.dependent], np.abs(w[len(self.dependent) :])])
        rates = (end - t) * np.abs(self._rates(t, w))
        atol = rtol * np.maximum(least, rates) + np.finfo(float).tiny
        solver = method(self._rates, t, w, end, rtol=rtol, atol=atol, first_step=end - t)
        solver.step()
        if solver.status == "failed" or not np.isfinite(solver.y).all():
            raise self._singular(t, x)
        after = solver.y.copy()
        after[: len(self.dependent)] = self._closed(solver.t, self._placed(solver.t, after)[0])[self.dependent]
        return solver.t, after

    def _rates(self, t: float, w: Vector) -> Vector:
        """Return the rates of w = (x_D, z)."""
        x, v = self._moving(t, w)
        if not self.model.n_states:
            return v[self.dependent]
        required, _ = self._required(t, x, v, np.zeros(self.model.n))
        return np.concatenate([v[self.dependent], -required[self.model.n_coordinates :]])

    def _closed(self, t: float, x: Vector) -> Vector:
        """Return x with phi(x, t) = 0, near by: Newton's method, each correction at most a quarter of the one before.

        The corrections are those of least norm in the mass metric, of the dependent coordinates alone.
        """
        c, x, last = self.model, x.copy(), np.inf
        for _ in range(_MOST_CORRECTIONS if c.h and self.dependent else 0):
            phi, _ = c.position(t, x, self.prepared)
            A = c.pfaffian(t, x, self.prepared)[0][: c.h]
            step = self._solved(A, -phi)
            before = x.copy()
            x[self.dependent] += step
            size = float(np.linalg.norm(step / self.unit[self.dependent]))
            if size <= 4.0 * np.finfo(float).eps * np.linalg.norm(x / self.unit):
                break
            if not size <= _CONTRACTION * last:
                if size > _ROUNDED * np.linalg.norm(x / self.unit):  # by rounding, or it is lost: back, and see
                    x = before
                break
            last = size
        self._check_closed(t, x)
        return x

    # --- what can go wrong ---

    def _check_closed(self, t: float, x: Vector) -> None:
        phi, rounding = closure(self.model, self.prepared, t, x)
        if not (np.abs(phi) <= _CLOSED * rounding).all():
            raise self._open(t, x)

    def _open(self, t: float, x: Vector) -> ModelError:
        """Return the error of a position that Newton's method does not close, or not quickly."""
        if self._independence(t, x) < _NEARLY_SINGULAR * self._usual:
            return self._singular(t, x)
        phi, rounding = closure(self.model, self.prepared, t, x)
        row = int(np.argmax(np.abs(phi) / np.maximum(rounding, np.finfo(float).tiny)))
        return ModelError(
            f"{self.model.name} cannot follow the motion at t = {t:.9g}: constraint {self.model.row_names[row]!r} "
            f"stays open by {phi[row]:.3g}. The mechanism does not reach {self._paths} there, or the times are too far "
            "apart."
        )

    def _scaled(self, t: float, x: Vector) -> Vector:
        """Return A_D (m, d) in the mass metric, with unit rows of A."""
        A = self.model.pfaffian(t, x, self.prepared)[0] * self.unit
        length = np.linalg.norm(A, axis=1)
        return np.asarray(A[:, self.dependent] / np.where(length > 0.0, length, 1.0)[:, None])

    def _independence(self, t: float, x: Vector) -> float:
        """Return the least singular value of A_D."""
        sizes = np.linalg.svd(self._scaled(t, x), compute_uv=False)
        return float(sizes[-1]) if len(sizes) == len(self.dependent) else 0.0

    @cached_property
    def _usual(self) -> float:
        """The least singular value at the start."""
        return self._independence(self.first, self.start)

    def _check_rank(self, t: float, x: Vector) -> None:
        if self.dependent and not self._independence(t, x) > _SINGULAR:
            raise self._singular(t, x)

    def _keeps_rank(self, before: tuple[float, Vector], after: tuple[float, Vector]) -> bool:
        """Return whether the determinant of independent rows of A_D keeps half its size in a step between (t, w)."""
        if not self.dependent:
            return True
        first, second = (self._scaled(t, self._placed(t, w)[0]) for t, w in (before, after))
        for matrix in (first, second):
            rows = self._independent(matrix)
            was, now = np.linalg.det(first[rows]), np.linalg.det(second[rows])
            if now * was > 0.0 and abs(now) >= _KEPT * abs(was):
                return True
        return False

    def _independent(self, scaled: Vector) -> Any:
        """Return which rows of A_D (m, d) are the most independent: d of them."""
        count = len(self.dependent)
        if len(scaled) == count:
            return slice(None)
        return scipy.linalg.qr(scaled.T, mode="r", pivoting=True)[1][:count]

    def _singular(self, t: float, x: Vector) -> ModelError:
        """Return the error that names the coordinates that are free while the prescribed ones rest."""
        sizes = np.abs(np.linalg.svd(self._scaled(t, x))[2][-1])
        names = [self.model.coordinates[k] for k in self.dependent]
        loose = [names[k] for k in np.argsort(-sizes)[:3] if sizes[k] > 0.01 * sizes.max()]
        return ModelError(
            f"{self.model.name} reaches a dead centre at t = {t:.9g}: there {self._paths} "
            f"{'do' if len(self.paths) > 1 else 'does'} not determine {' and '.join(loose)}. Prescribe a coordinate "
            "that does, or a motion that ends before."
        )

    @property
    def _paths(self) -> str:
        return " and ".join(path.name for path in self.paths)
