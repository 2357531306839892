"""Whether contacts and frictions did what they may at every accepted step of a run.

No held contact pulls, no closed gap accelerates inwards or is negative, no sticking friction exceeds its limit, none
slides the wrong way. Read off the run's own modes, multipliers and the outputs of `contact_models.watched`. Where
forces are not unique some of the same sum have to obey.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from scipy.optimize import linprog

from ..arguments.names import Vector
from ..results.solution import Solution
from ..system.system import System


def missed(solution: Solution, system: System, parameters: Mapping[str, float]) -> float:
    """Return by how much a condition is missed at most, relative to the largest force, gap or slip of the run."""
    return max(_Watched.of(solution, system, parameters).misses(), default=0.0)


@dataclass(frozen=True)
class _Watched:
    """A run row by row (k): of contacts (c, k), of frictions (r, k); modes are NaN where nothing is decided yet."""

    solution: Solution
    system: System
    parameters: Mapping[str, float]
    held: Vector
    stuck: Vector
    ways: Vector

    @classmethod
    def of(cls, solution: Solution, system: System, parameters: Mapping[str, float]) -> "_Watched":
        names = solution.modes[0][1]
        return cls(solution, system, parameters, *(
            np.array([_along(solution, name) for name in names if name.endswith(end)]).reshape(-1, len(solution.t))
            for end in ("_held", "_stuck", "_slides")
        ))  # fmt: skip

    def outputs(self, end: str) -> Vector:
        """(j, k) those of this ending, in the order of the model."""
        found = [values for name, values in self.solution.outputs.items() if name.endswith(end)]
        return np.array(found).reshape(-1, len(self.solution.t))

    def misses(self) -> Iterator[float]:
        """Yield what each condition is missed by."""
        gaps, opens, slips = (self.outputs(end) for end in ("_gap", "_opens", "_slip"))
        size, held = _size(self.solution.x), self.held == 1
        yield _largest(-gaps) / size
        yield _largest(np.abs(gaps[held])) / size
        yield _largest(np.abs(opens[held])) / max(_size(opens), 1.0)
        yield _largest(-np.nan_to_num(self.ways) * slips) / _size(slips)
        yield self.forces()

    def forces(self) -> float:
        """Return by how much forces are beyond what they may be, where there are no others of the same sum."""
        multipliers = self.solution.multipliers
        press, rub = -multipliers[: len(self.held)], multipliers[len(self.held) :]
        limits, size = self.limits(press), max(_size(multipliers), 1e-300)
        beyond = np.maximum(
            -press.min(axis=0, initial=0.0), ((np.abs(rub) - limits) * (self.stuck == 1)).max(axis=0, initial=0.0)
        )
        wrong = np.flatnonzero(beyond > 1e-9 * size)
        return max((min(beyond[k] / size, self.others(int(k)) / size) for k in wrong), default=0.0)

    def limits(self, press: Vector) -> Vector:
        """(r, k) forces up to which frictions stick."""
        on = self.outputs("_on").astype(int)
        pressed = np.array([press[row[0]] if row[0] >= 0 else np.ones_like(row) for row in on]).reshape(on.shape)
        return np.asarray(self.outputs("_limit") * pressed)

    def others(self, k: int) -> float:
        """Return by how much the best forces of the same sum in row k miss their limits [N]."""
        t, x, on = self.solution.t[k], self.solution.x[:, k], self.outputs("_on")[:, k].astype(int)
        modes = dict.fromkeys((name for name in self.solution.modes[0][1] if name.endswith(("_held", "_stuck"))), 1.0)
        A = self.system.pfaffian(x, t, dict(self.parameters) | modes)[0]
        c, limit, way = len(self.held), self.outputs("_limit")[:, k], np.nan_to_num(self.ways[:, k])
        shown = -self.solution.multipliers[:, k]
        for j in np.flatnonzero(way):
            shown[c + j] = -way[j] * limit[j] * (shown[on[j]] if on[j] >= 0 else 1.0)
        return _least(A, A.T @ shown, c, limit, on, way, self.held[:, k] == 1, self.stuck[:, k] == 1)


def _least(
    A: Vector, total: Vector, c: int, limit: Vector, on: Vector, way: Vector, held: Vector, stuck: Vector
) -> float:
    """Return the least s with A^T f = total, f >= -s of contacts, |f| <= limit + s of what sticks."""
    m = len(A)
    equal, right, bounded, bounds = [np.append(row, 0.0) for row in A.T], list(total), [], []
    for j, (L, way_j) in enumerate(zip(limit, way, strict=True)):
        own, most = np.eye(m + 1)[c + j], np.zeros(m + 1)
        if on[j] >= 0:
            most[on[j]] = L
        fixed = 0.0 if on[j] >= 0 else L
        if stuck[j]:
            bounded += [sign * own - most - np.eye(m + 1)[m] for sign in (1.0, -1.0)]
            bounds += [fixed, fixed]
        else:
            equal.append(own + way_j * most)
            right.append(-way_j * fixed)
    limits = [(None if one else 0.0, None if one else 0.0) for one in held] + [(None, None)] * (m - c) + [(0.0, None)]
    bounded += [-np.eye(m + 1)[i] - np.eye(m + 1)[m] for i in range(c)]
    done = linprog(np.eye(m + 1)[m], np.array(bounded), bounds + [0.0] * c, np.array(equal), np.array(right), limits)
    return float(done.x[m]) if done.status == 0 else np.inf


def _along(solution: Solution, name: str) -> Vector:
    """Return the value of a mode's parameter in each row (k,); of two rows at a time the first is of that before.

    NaN: nothing was decided yet.
    """
    since = np.array([t for t, _ in solution.modes])
    values = np.array([mode[name] for _, mode in solution.modes])
    last = np.append(np.diff(solution.t) > 0, True)
    before = np.searchsorted(since, solution.t, "left") - 1
    number = np.where(last, np.searchsorted(since, solution.t, "right") - 1, before)
    return np.where(number < 0, np.nan, values[np.maximum(number, 0)])


def _largest(values: Vector) -> float:
    return float(np.max(values, initial=0.0))


def _size(values: Vector) -> float:
    return max(float(np.max(np.abs(values), initial=0.0)), 1e-300)
