"""Quantities computed from the rows of a run: velocities, eigenfactors, multipliers, energies, residuals."""

from collections.abc import Callable
from functools import cached_property
from typing import Any

import numpy as np

from ..arguments.named_values import Vector
from ..arguments.states import names_of_states
from ..arguments.tasks import Task
from ..codegen.model.normalise import ModelError
from ..runtime import CompiledModel, Prepared
from .pictures.moving_shapes import Drawing

Segment = tuple[int, float, tuple[float, ...]]


class Trajectory:
    """Rows of a run, and quantities computed from them; time is the first axis of all arrays.

    Parameters
    ----------
    t : (k,) [s]
    rows : (k, n_state), published meaning
    segments : first row, start time and parameters of each mode; () if the mode does not change
    """

    def __init__(self, task: Task, t: Vector, rows: Vector, segments: tuple[Segment, ...] = ()) -> None:
        self.task, self.model, self.t, self.rows, self.segments = task, task.model, t, rows, segments

    @cached_property
    def modes(self) -> list[tuple[slice, Prepared]]:
        """The rows of each segment, and its prepared parameters."""
        return _segment_rows(self.task, len(self.t), self.segments)

    def at(self, t: Vector, rows: Vector) -> "Trajectory":
        """Return the rows (j, n_state) of the same run at other times t (j,), in the order of the run.

        Raises
        ------
        ModelError
            The times are not in order.
        """
        sign = -1.0 if self.task.t_end < self.task.t_start else 1.0
        if (np.diff(sign * t) < 0.0).any():
            raise ModelError("the times are not in the order of the run: sort them")
        starts = [start for _, start, _ in self.segments]
        firsts = [0, *np.searchsorted(sign * t, [sign * start for start in starts[1:]]).tolist(), len(t)]
        segments = tuple(
            (first, start, parameters)
            for first, end, (_, start, parameters) in zip(firsts, firsts[1:], self.segments, strict=False)
            if first < end
        )
        return Trajectory(self.task, t, rows, segments)

    def _by_segment(self, function: Callable[..., Any], *columns: Vector) -> Any:
        """Return the rows of function(*columns, prepared), with the prepared parameters of the mode of each row."""
        if len(self.modes) == 1:
            return function(*columns, self.modes[0][1])
        parts = [function(*(np.ascontiguousarray(column[rows]) for column in columns), c) for rows, c in self.modes]
        if isinstance(parts[0], tuple):
            return tuple(map(np.concatenate, zip(*parts, strict=True)))
        return np.concatenate(parts)

    @property
    def n(self) -> int:
        """The number of coordinates; in all arrays here they come first, then states or their integrals."""
        return self.model.n_coordinates

    @cached_property
    def states(self) -> dict[str, Vector]:
        """Name -> (k,): the first-order states."""
        return {name: self.v[:, self.n + k] for k, name in enumerate(names_of_states(self.model))}

    @cached_property
    def x(self) -> Vector:
        """(k, n)."""
        return np.ascontiguousarray(self.rows[:, : self.model.n])

    @cached_property
    def v(self) -> Vector:
        """(k, n)."""
        return self.model.velocity_rows(self.t, self.rows, self.task.prepared)

    @cached_property
    def u(self) -> Vector:
        """(k, n_inputs)."""
        return np.ascontiguousarray(self.task.inputs.at(self.t))

    @cached_property
    def eta(self) -> Vector:
        """(k, n): the quasi-velocities in y (S C xdot (17), or L^T xdot), or S C xdot of M(x) if y has none."""
        for name, start, length in self.model.layout:
            if name == "eta":
                return self.rows[:, start : start + length + self.model.n_states]
        C, s = self.factors
        return np.asarray(s * np.einsum("kij,kj->ki", C, self.v / self.model.scales))

    @cached_property
    def factors(self) -> tuple[Vector, Vector]:
        """C (k, n, n), s (k, n): those in y for the blocks that y has, those of M(x) for the others."""
        computed = self.model.eigenfactor_rows(self.t, self.x, self.task.prepared)
        parts = {name: self.rows[:, start : start + length] for name, start, length in self.model.layout}
        if "s" not in parts:
            return computed
        return _filled(computed, parts["C"], parts["s"], _carried_blocks(self.model))

    @cached_property
    def factor_residual(self) -> Vector:
        """(k,): max|M - C^T S^2 C| / max|M|."""
        return self.model.factor_rows(self.t, self.x, *self.factors, self.task.prepared)

    @cached_property
    def energies(self) -> Vector:
        """(k, 4): T2, T1, T0, V [J]."""
        return self.model.energy_rows(self.t, self.x, self.v, self.task.prepared)

    @cached_property
    def multipliers(self) -> Vector:
        """(k, m)."""
        if self.model.m == 0:
            return np.empty((len(self.t), 0))
        rows: Vector = self._by_segment(self._accelerations, self.t, self.x, self.v, self.u)[1]
        return rows

    @cached_property
    def accelerations(self) -> Vector:
        """(k, n), at the inputs of the run."""
        rows: Vector = self._by_segment(self._accelerations, self.t, self.x, self.v, self.u)[0]
        return rows

    def _accelerations(self, t: Vector, x: Vector, v: Vector, u: Vector, c: Prepared) -> tuple[Vector, Vector]:
        return self.model.acceleration_rows(t, x, v, u, c, self.task.least_norm)

    @cached_property
    def constraint_residual(self) -> Vector:
        """(k, m): A v + b."""
        return np.asarray(self._by_segment(self.model.constraint_rows, self.t, self.x, self.v))

    @cached_property
    def position_residual(self) -> Vector:
        """(k, h): phi."""
        return np.asarray(self._by_segment(self.model.position_rows, self.t, self.x))

    @cached_property
    def quasi_velocities(self) -> dict[str, Vector]:
        """Name -> (k,): y = P(x, t) xdot (3)."""
        columns = self.model.quasi_rows(self.t, self.x, self.v, self.task.prepared)
        return {name: columns[:, k] for k, name in enumerate(self.model.quasi_velocities)}

    @cached_property
    def drawing(self) -> Drawing | None:
        """The drawing of the mechanism at every row; None if the model has no drawing."""
        return self.drawn(self.t, self.x, self.v)

    def drawn(self, t: Vector, x: Vector, v: Vector) -> Drawing | None:
        """The drawing of the mechanism at t (k,), x (k, n), v (k, n); None if the model has no drawing."""
        if not self.model.shapes:
            return None
        numbers = self.model.drawn_rows(t, x, v, self.task.prepared)
        return Drawing(self.model.name, t, self.model.dimension, self.model.shapes, numbers, self.model.units)

    @cached_property
    def outputs(self) -> dict[str, Vector]:
        """Name -> (k,)."""
        columns = self._by_segment(self._outputs, self.t, self.x, self.v, self.u)
        return {name: columns[:, k] for k, name in enumerate(self.model.outputs)}

    def _outputs(self, t: Vector, x: Vector, v: Vector, u: Vector, c: Prepared) -> Vector:
        return self.model.output_rows(t, x, v, u, c, self.task.least_norm)


def _segment_rows(task: Task, count: int, segments: tuple[Segment, ...]) -> list[tuple[slice, Prepared]]:
    """Return the rows of each segment, and its prepared parameters."""
    if not segments:
        return [(slice(0, count), task.prepared)]
    ends = [first for first, _, _ in segments[1:]] + [count]
    prepared = {parameters: task.model.prepare(np.array(parameters)) for _, _, parameters in segments}
    starts = [(first, prepared[parameters]) for first, _, parameters in segments]
    return [(slice(first, end), c) for (first, c), end in zip(starts, ends, strict=True)]


def _carried_blocks(model: CompiledModel) -> list[list[int]]:
    """Return the coordinates of each block of M whose C and s are in y."""
    numbers = sorted({model.block[k] for k in model.carried})
    return [[k for k, number in enumerate(model.block) if number == which] for which in numbers]


def _filled(computed: tuple[Vector, Vector], C: Vector, s: Vector, blocks: list[list[int]]) -> tuple[Vector, Vector]:
    """Return the computed eigenfactors, with those of some blocks replaced by C and s of the state."""
    full, roots = computed[0].copy(), computed[1].copy()
    at, root = 0, 0
    for block in blocks:
        size = len(block)
        full[np.ix_(range(len(full)), block, block)] = C[:, at : at + size**2].reshape(-1, size, size)
        roots[:, block] = s[:, root : root + size]
        at, root = at + size**2, root + size
    return full, roots
