"""Adjoint of a run: gradients of functions of its rows, by the transpose of its derivative.

The derivative of a run is a product of linear maps: steps of the variational equations, projections, events. A pass in
random directions chooses the steps and records the maps (em_derivative_tape.h); one of them, the probe, checks each
transpose. A long run goes in parts: from the last to the first, each is run again from its checkpoint and recorded.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...arguments.methods import Method
from ...arguments.named_values import Vector
from ...arguments.tasks import Task
from ...codegen.model.normalise import ModelError
from ...runtime import EvaluationError, Prepared, Run, StopReason
from ...runtime.checkpoints import Checkpoint, ReplayedRun
from ...runtime.variations import Tape, tangent
from .collocation_mesh import NODES
from .run_path import Path
from .sensitivities import TOGETHER, Directions, remedied, variations_of

_COLUMNS = 3
"""Columns of a pass: a direction from the start on (the probe), and two that are drawn at every step, so that steps
resolve what the probe has little of; with the motion itself they fill a vector of the processor."""
_APART = 1e-7
"""Difference of <w, D s> and <D^T w, s> for a probe s, relative to the sum of the sizes of its terms."""
_DENSE = 10
"""Rows of the dense output of a step, each (n_state,) (EM_DENSE_COEFFICIENTS of em_run.h)."""


class Part(NamedTuple):
    """A part of a run: its path, the nodes first to last - 1 of the whole that are in it, and its tape.

    begins : whether the path has a node before `first`, where the part begins
    """

    path: Path
    first: int
    last: int
    begins: bool
    tape: Tape
    stops: NDArray[np.int_]


def steps_within(task: Task, varied: Directions, megabytes: float) -> int:
    """Return the number of steps of a run whose dense output and maps need this memory; a map a step, or fewer."""
    n, size = task.model.n, NODES * task.model.n
    maps = size * (size + _COLUMNS + 2) + (NODES + 3) * n * (2 * n + len(varied.names))
    return max(16, int(min(megabytes, 1e9) * 1e6 / 8.0 / (maps + _DENSE * task.model.n_state)))


@dataclass(frozen=True)
class Adjoint:
    """The derivative of a run of a task.

    run : its dense output, of the last part that starts at a checkpoint
    path : the whole path
    """

    task: Task
    method: Method
    varied: Directions
    run: Run
    path: Path
    checkpoints: list[Checkpoint]

    def __post_init__(self) -> None:
        if len(self.checkpoints) == 1:  # its errors are those of the call
            _ = self.only_part

    @cached_property
    def only_part(self) -> Part:
        """The whole run, as one part."""
        return self._part(0, self.run)

    @cached_property
    def start(self) -> Vector:
        """(2 n, names) directions at the start, on the tangent of the constraints."""
        return self._tangent(self.path, self.varied.S, self.varied.P)

    @cached_property
    def given(self) -> list[int]:
        """The names that are inputs or parameters, as places among the names."""
        return [int(place) for place in np.flatnonzero(self.varied.P.any(axis=0))]

    @cached_property
    def probes(self) -> Vector:
        """(names, columns): the first is random, as large as the values of what it changes; the others are zero."""
        made = np.zeros((len(self.varied.names), _COLUMNS))
        made[:, 0] = _drawn(len(made)) * _sizes(self.task, self.varied)
        return made

    def pull(self, rows: Vector) -> Vector:
        """Return the gradient (names,) for cotangents (k, 2 n) of x and v at the rows of the run.

        Raises
        ------
        ModelError
            As `sensitivity`: a force jumps without an event of the model, or the time of an event has no derivative.
        EvaluationError
            The transpose does not agree with the derivative along the probes.
        """
        W = np.zeros((len(self.path.t), rows.shape[1]))
        np.add.at(W, self.path.of_rows, rows)
        cotangents, along = np.zeros(rows.shape[1]), np.zeros(len(self.given))
        for part in self._parts():
            cotangents, added = _pull_part(part, W, cotangents, self.probes[self.given])
            along += added
        gradient = self.start.T @ cotangents
        gradient[self.given] += along
        return np.asarray(gradient)

    def _parts(self) -> Iterator[Part]:
        """Return the parts from the last to the first."""
        if len(self.checkpoints) == 1:
            yield self.only_part
            return
        yield self._part(len(self.checkpoints) - 1, self.run)
        for k in range(len(self.checkpoints) - 2, -1, -1):
            yield self._part(k, ReplayedRun(self.task, self.method.number, self.checkpoints[k]))

    def _part(self, k: int, run: Run) -> Part:
        path, first, last, begins = _path_between(self.path, self.checkpoints, k, self.task)
        S = self.start @ self.probes if k == 0 else self._random_start(path)
        together, P = TOGETHER.get(self.method.name, 3.0), self.varied.P @ self.probes
        along, mesh = variations_of(self.task, run, path, S, P, together)
        tape = Tape(along, np.ascontiguousarray(self.varied.P[:, self.given]))
        if tape.fault is not None:
            raise ModelError(remedied(self.task.model, tape.fault))
        return Part(path, first, last, begins, tape, mesh.stops)

    def _random_start(self, path: Path) -> Vector:
        n, size = self.task.model.n, np.abs(path.z[0])
        size = np.maximum(size, np.repeat([size[:n].max(), size[n:].max()], n))
        random = np.random.default_rng(1).standard_normal((2 * n, _COLUMNS)) * np.where(size > 0.0, size, 1.0)[:, None]
        return self._tangent(path, random, self.varied.P @ self.probes)

    def _tangent(self, path: Path, S: Vector, P: Vector) -> Vector:
        n = self.task.model.n
        return tangent(
            self.task.model, path.t[0], path.z[0, :n], path.z[0, n:], path.prepared, self.task.least_norm, S, P
        )


@lru_cache(maxsize=16)
def _drawn(count: int) -> Vector:
    return np.random.default_rng(0).standard_normal(count)


def _path_between(path: Path, checkpoints: list[Checkpoint], k: int, task: Task) -> tuple[Path, int, int, bool]:
    """Return the path of a part, its first node and its end among those of the whole, and whether it has one before."""
    if len(checkpoints) == 1:
        return path, 0, len(path.t), False
    sign = 1.0 if task.t_end >= task.t_start else -1.0
    places = [int(np.searchsorted(sign * path.t, sign * at.t, "right")) for at in checkpoints[1:]]
    first, last = [0, *places, len(path.t)][k : k + 2]
    before = [_node(checkpoints[k], task)] if k > 0 else []
    reached = k + 1 == len(checkpoints) or (last > first and path.t[last - 1] == checkpoints[k + 1].t)
    after = [] if reached else [_node(checkpoints[k + 1], task)]
    t = np.concatenate([[at for at, _ in before], path.t[first:last], [at for at, _ in after]])
    z = np.concatenate([*(one[None] for _, one in before), path.z[first:last], *(one[None] for _, one in after)])
    within = (path.mark_row >= first) & (path.mark_row < last)
    marks = path.mark_row[within] - first + len(before), path.mark_event[within]
    prepared: Prepared = checkpoints[k].prepared if k > 0 else path.prepared
    return Path(t, z, *marks, np.empty(0, dtype=int), [], prepared), first, last, bool(before)


def _node(at: Checkpoint, task: Task) -> tuple[float, Vector]:
    """Return t and z (2 n,) of a checkpoint."""
    y = at.y[None]
    return at.t, np.concatenate([y[0, : task.model.n], task.model.velocity_rows(np.array([at.t]), y, at.prepared)[0]])


def _pull_part(part: Part, W: Vector, end: Vector, given: Vector) -> tuple[Vector, Vector]:
    """Return cotangents (2 n,) at the start of a part, and the gradient along the basis, from those at its end."""
    at_nodes = np.zeros((len(part.path.t), len(end)))
    at_nodes[part.begins : part.begins + part.last - part.first] = W[part.first : part.last]
    at_stops = at_nodes[part.stops]
    at_nodes[part.stops] = 0.0
    at_stops[-1] += end
    found = part.tape.variations
    within = at_nodes if len(found.at_rows) else at_nodes[:0]
    start, along = part.tape.pull(at_stops, within, np.zeros(len(end)))
    _check(part, at_stops, within, start, along, given)
    return start, along


def _check(part: Part, at_stops: Vector, within: Vector, start: Vector, along: Vector, given: Vector) -> None:
    """Raise EvaluationError if the transpose differs from the derivative along the probes."""
    found = part.tape.variations
    pairs = (found.at_stops, at_stops), (found.at_rows, within)
    terms = [np.where(W != 0.0, S[:, :, 0] * W, 0.0) for S, W in pairs]  # rows at stops, or after the end, have no S
    back = [found.at_stops[0, :, 0] * start, given[:, 0] * along]
    off = abs(sum(one.sum() for one in terms) - sum(one.sum() for one in back))
    size = sum(np.abs(one).sum() for one in (*terms, *back))
    if not off <= _APART * size:
        raise EvaluationError(
            f"{found.model.name}: the gradient is uncertain: along a random direction it differs from the derivative "
            f"by {off / size:.1g} of its terms. Take `sensitivities` of `simulate` in its place",
            StopReason.NON_FINITE_STATE,
        )


def _sizes(task: Task, varied: Directions) -> Vector:
    """Return the size (names,) of each variable, by which probes move it: its value, or 1 if that is zero."""
    c, y = task.model, task.y
    u = [abs(signal) if isinstance(signal, int | float) else 0.0 for signal in task.inputs.signals]
    v = c.velocity_rows(np.array([task.t_start]), y[None, :], task.prepared)[0]
    given = np.concatenate([u, np.abs(task.prepared.parameters), [0.0]])
    now = np.abs(np.concatenate([y[: c.n], v])) @ np.abs(varied.S) + given[: len(varied.P)] @ np.abs(varied.P)
    return np.where(now > 0.0, now, 1.0)
