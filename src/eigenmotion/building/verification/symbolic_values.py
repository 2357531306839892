"""Values of the user's expressions at many points, in hyper-dual numbers."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
import sympy

from ...arguments.named_values import Vector
from ...codegen.model import multiplier, t
from ...codegen.model.statement.mechanism import Mechanism
from .arithmetic.evaluate import Evaluation
from .arithmetic.hyperdual import HyperDual, from_parts
from .arithmetic.rounding_bounds import EPS, Rounded, geometric, joined, rounded
from .compiled_values import CompiledValues
from .test_points import Points

_ZERO, _ONE = Rounded(0.0, 0.0), Rounded(1.0, 0.0)
_AT_ONCE = 30_000
"""Numbers in one array: large compared with the overhead of Python, small compared with the processor's cache."""


@dataclass(frozen=True, slots=True)
class SymbolicValues:
    """Values at k points (first axis), with the accelerations and multipliers of the compiled model.

    M, M_rate (k, n, n); G (k, n); T0, V (k,); momentum (k, n) = dT/dxdot, momentum_rate its rate; T_x, V_x, Q (k, n)
    A, A_rate (k, m, n); row (k, m) = A xdot + b; row_rate (k, m) its rate; phi (k, h); quasi (k, n or 0)
    outputs (k, n_outputs); events (k, n_events);
    drawn (k, n_drawn); unknown: functions that could not be evaluated
    """

    M: Rounded
    M_rate: Rounded
    G: Rounded
    T0: Rounded
    V: Rounded
    momentum: Rounded
    momentum_rate: Rounded
    T_x: Rounded
    V_x: Rounded
    Q: Rounded
    A: Rounded
    A_rate: Rounded
    row: Rounded
    row_rate: Rounded
    phi: Rounded
    quasi: Rounded
    outputs: Rounded
    events: Rounded
    drawn: Rounded
    unknown: frozenset[str]


def evaluate(
    model: Mechanism, points: Points, compiled: CompiledValues, speed: Vector, trusted: bool = False
) -> SymbolicValues:
    """Evaluate all expressions of a model; velocities have the error bound eps `speed` (k, n).

    If M is `trusted`, it is that of the compiled model, without its rate: whoever trusts it compares M v with the
    momenta, since T at all pairs of velocities takes a time proportional to n^3.
    """
    statement = _Values(model, points, compiled, speed)
    with np.errstate(all="ignore"):
        energies, along = statement.rest() if trusted else statement.energies(), statement.along()
        across, twice = statement.across(), statement.twice()
        holonomic = {name: joined([across[name], along[name]], axis=1) for name in ("A", "A_rate", "row")}
        row_rate = joined([twice, along.pop("row_rate")], axis=1)
    parts = energies | across | along | holonomic
    return SymbolicValues(**parts, row_rate=row_rate, unknown=statement.unknown)


class _Values:
    """Evaluations of one model at the same points, with different parts varied."""

    def __init__(self, model: Mechanism, points: Points, compiled: CompiledValues, speed: Vector) -> None:
        self.model, self.points, self.compiled = model, points, compiled
        self.k, self.n = points.x.shape
        self.x = _columns(rounded(points.x))
        self.v = _columns(Rounded(points.v, EPS * np.maximum(np.abs(points.v), speed)))
        self.a, self.each = (
            _columns(rounded(compiled.a)),
            _columns(Rounded(np.eye(self.n), np.zeros((1, self.n))), axis=0),
        )
        self.time = rounded(points.t[:, None])
        self._second_rates = [sympy.Derivative(x, (t, 2)) for x in model.coordinates]
        self._evaluations: list[Evaluation] = []

    @property
    def unknown(self) -> frozenset[str]:
        """The functions in the expressions that hyper-dual numbers do not support."""
        return frozenset().union(*(value.unknown for value in self._evaluations))

    def energies(self) -> dict[str, Rounded]:
        """Return M, G, T0 and the rate of M, from T at rest, at unit velocities and at sums of two of them."""
        pairs = list(combinations(range(self.n), 2))
        one, none = np.eye(self.n), np.zeros((1, self.n))
        patterns = np.concatenate([none, one, -one, *(one[[i]] + one[[j]] for i, j in pairs)])
        size = max(1, _AT_ONCE // len(patterns))
        parts = [self._energies(slice(i, i + size), patterns) for i in range(0, self.k, size)]
        unit = _units(self.compiled)
        (T, T_rate) = (joined(part, axis=0) for part in zip(*parts, strict=True))
        M, G, T0 = _quadratic(T, unit, pairs)
        return {"M": M, "G": G, "T0": T0, "M_rate": _quadratic(T_rate, unit, pairs)[0]}

    def rest(self) -> dict[str, Rounded]:
        """Return G and T0 from T at rest, and M of the compiled model."""
        moving = [HyperDual(_ZERO, None, one) for one in self.each]
        T = self._evaluation(list(map(HyperDual, self.x)), moving, HyperDual(self.time))(self.model.kinetic_energy)
        M = self.compiled.M
        unknown = rounded(np.full(M.shape, np.nan))
        G, T0 = _filled(T.c, (self.k, self.n)), _filled(T.a, (self.k, 1))[:, 0]
        return {"M": Rounded(M, EPS * geometric(M)), "M_rate": unknown, "G": G, "T0": T0}

    def _energies(self, rows: slice, patterns: Vector) -> tuple[Rounded, Rounded]:
        unit = _units(self.compiled)[rows]
        moving = [HyperDual(x[rows], v[rows]) for x, v in zip(self.x, self.v, strict=True)]
        velocities = [from_parts(patterns[:, i] * unit[:, i : i + 1]) for i in range(self.n)]
        value = self._evaluation(moving, velocities, HyperDual(self.time[rows], _ONE), rows)
        T = value(self.model.kinetic_energy)
        shape = (len(unit), len(patterns))
        return _filled(T.a, shape), _filled(T.b, shape)

    def along(self) -> dict[str, Rounded]:
        """Return derivatives along the motion and with respect to velocities, and values without derivatives."""
        model = self.model
        x = [HyperDual(*pair) for pair in zip(self.x, self.v, strict=True)]
        v = [HyperDual(*parts) for parts in zip(self.v, self.a, self.each, strict=True)]
        value = self._evaluation(x, v, HyperDual(self.time, _ONE))
        rows, T = [value(row) for row in model.nonholonomic_constraints], value(model.kinetic_energy)
        return {
            "momentum": _filled(T.c, (self.k, self.n)), "momentum_rate": _filled(T.f, (self.k, self.n)),
            "Q": self._table(value(Q).a for Q in model.forces),
            "A": self._matrix(row.c for row in rows), "A_rate": self._matrix(row.f for row in rows),
            "row": self._table(row.a for row in rows), "row_rate": self._table(row.b for row in rows),
            "quasi": self._table(value(y).a for y, _ in model.quasi_velocities),
            "outputs": self._table(value(output).a for _, output in model.outputs),
            "events": self._table(value(event.expression).a for _, event in model.events),
            "drawn": self._table(value(number).a for shape in model.drawing for number in shape.numbers),
        }  # fmt: skip

    def across(self) -> dict[str, Rounded]:
        """Return the derivatives with respect to coordinates, and their rates."""
        model, v = self.model, list(map(HyperDual, self.v))
        still = [HyperDual(x, None, one) for x, one in zip(self.x, self.each, strict=True)]
        value = self._evaluation(still, v, HyperDual(self.time))
        T, V = value(model.kinetic_energy), value(model.potential_energy)
        x = [HyperDual(*parts) for parts in zip(self.x, self.v, self.each, strict=True)]
        value = self._evaluation(x, v, HyperDual(self.time, _ONE))
        phi = [value(row) for row in model.holonomic_constraints]
        return {
            "T_x": _filled(T.c, (self.k, self.n)), "V_x": _filled(V.c, (self.k, self.n)),
            "V": _filled(V.a, (self.k, 1))[:, 0], "phi": self._table(row.a for row in phi),
            "A": self._matrix(row.c for row in phi), "A_rate": self._matrix(row.f for row in phi),
            "row": self._table(row.b for row in phi),
        }  # fmt: skip

    def twice(self) -> Rounded:
        """Return d2 phi / dt2 (k, h) along the motion."""
        if not self.model.holonomic_constraints:
            return self._table(())
        x = [HyperDual(x, v, v, a) for x, v, a in zip(self.x, self.v, self.a, strict=True)]
        value = self._evaluation(x, [], HyperDual(self.time, _ONE, _ONE))
        return self._table(value(row).f for row in self.model.holonomic_constraints)

    def _evaluation(
        self,
        x: Sequence[HyperDual],
        v: Sequence[HyperDual],
        time: HyperDual,
        rows: slice = slice(None),
    ) -> Evaluation:
        """Return an evaluation in which coordinates, rates and the time have these values."""
        model, points = self.model, self.points
        values: dict[sympy.Basic, HyperDual] = {t: time}
        values |= zip(model.coordinates, x, strict=True)
        values |= zip(model.rates, v, strict=False)
        values |= zip(self._second_rates, map(HyperDual, self.a), strict=True)
        values |= zip((p for p, _ in model.parameters), map(HyperDual, self._parameters(rows)), strict=True)
        values |= zip((u for u, _ in model.inputs), map(HyperDual, _columns(rounded(points.u[rows]))), strict=True)
        values |= {multiplier(row): from_parts(self.compiled.multipliers[:, row, None]) for row in range(model.m)}
        value = Evaluation(values)
        for y, P_xdot in model.quasi_velocities if v else ():
            value.define(y, value(P_xdot))
            value.define(y.diff(t), from_parts(np.nan) if (rate := value(y).b) is None else HyperDual(rate))
        self._evaluations.append(value)
        return value

    def _parameters(self, rows: slice) -> list[Rounded]:
        """Return the values of parameters; integers are exact, such as those of contact modes."""
        p = self.points.p[rows]
        return _columns(Rounded(p, np.where(p == np.round(p), 0.0, EPS * np.abs(p))))

    def _table(self, values: Iterable[Rounded | None]) -> Rounded:
        """Return values as columns of an array (k, number of values)."""
        columns = [_filled(value, (self.k, 1)) for value in values]
        return joined([rounded(np.empty((self.k, 0))), *columns], axis=1)

    def _matrix(self, values: Iterable[Rounded | None]) -> Rounded:
        """Return values as rows of an array (k, number of values, n)."""
        rows = [_filled(value, (self.k, self.n))[:, None] for value in values]
        return joined([rounded(np.empty((self.k, 0, self.n))), *rows], axis=1)


def _columns(table: Rounded, axis: int = 1) -> list[Rounded]:
    """Return the columns (k, 1), or the rows (1, n), of a table."""
    values, bounds = (np.broadcast_to(part, table.value.shape) for part in (table.value, table.bound))
    cut = (
        np.split(part, table.value.shape[axis], axis) if table.value.shape[axis] else [] for part in (values, bounds)
    )
    return list(map(Rounded, *cut))


def _filled(part: Rounded | None, shape: tuple[int, int]) -> Rounded:
    return (part or _ZERO).filled(shape)


def _units(compiled: CompiledValues) -> Vector:
    """Return velocities (k, n), each with as much kinetic energy as at rest, so that no term is lost by rounding."""
    diagonal, T0 = np.einsum("kii->ki", compiled.M), np.abs(compiled.energies[:, 2:3])
    unit = np.sqrt(np.where(T0 > 0.0, T0, 1.0) / np.abs(diagonal))
    return np.where(np.isfinite(unit) & (unit > 0.0), unit, 1.0)


def _quadratic(T: Rounded, unit: Vector, pairs: list[tuple[int, int]]) -> tuple[Rounded, Rounded, Rounded]:
    """Return M (k, n, n), G (k, n), T0 (k,) from T at rest, at plus and minus unit velocities, and at sums of two."""
    n = unit.shape[1]
    rest, plus, minus, both = T[:, :1], T[:, 1 : n + 1], T[:, n + 1 : 2 * n + 1], T[:, 2 * n + 1 :]
    squares, (i, j) = plus + minus - 2.0 * rest, np.array(pairs, dtype=int).reshape(-1, 2).T
    mixed = both - plus[:, i] - plus[:, j] + rest
    M = Rounded(*(np.zeros((*unit.shape, n)) for _ in range(2)))
    for table, diagonal, off in zip(*((one.value, one.bound) for one in (M, squares, mixed)), strict=True):
        table[:, range(n), range(n)] = diagonal
        table[:, i, j] = table[:, j, i] = off
    one = rounded(1.0 / unit)
    return M * one[:, :, None] * one[:, None, :], 0.5 * (plus - minus) * one, rest[:, 0]
