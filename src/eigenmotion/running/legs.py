"""The legs of an implicit run, between events that act, and the rows of all of them."""

from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import OdeSolution

from ..arguments.names import Vector
from ..arguments.options import Task
from ..runtime import EvaluationError


@dataclass(slots=True)
class Leg:
    """Steps between events that act: the task in the mode of then, its first row, ends of steps and interpolants."""

    task: Task
    first: int
    t: list[float]
    z: Vector
    pieces: list[Any] = field(default_factory=list)

    def between(self, t: Vector) -> Vector:
        """Return z (k, 2 n) at t (k,)."""
        if not self.pieces or not t.size:  # SciPy's interpolants take no empty array
            return np.repeat(self.z[None], len(t), axis=0)
        return np.ascontiguousarray(OdeSolution(np.array(self.t), self.pieces)(t).T)


def _on_constraints(task: Task, t: Vector, z: Vector) -> Vector:
    """Return z (k, 2 n) projected where that is asked for."""
    n, model = task.model.n, task.model
    if task.stabilise and model.m:
        z = z.copy()
        for k, time in enumerate(t):
            with suppress(EvaluationError):  # the run has ended there, and says why
                z[k] = np.concatenate(model.project(time, z[k, :n], z[k, n:], task.prepared, task.least_norm))
    return z


def published(legs: list[Leg], which: NDArray[np.intp], t: Vector, z: Vector) -> Vector:
    """Return y (k, n_state) at z (k, 2 n), each of a leg: projected, eigenfactors continuous from row to row."""
    task, rows = legs[0].task, np.reshape(z, (-1, 2 * legs[0].task.model.n)).astype(float)
    for number, leg in enumerate(legs):
        there = which == number
        rows[there] = _on_constraints(leg.task, t[there], rows[there])
    x, v = (np.ascontiguousarray(half) for half in np.hsplit(rows, 2))
    return task.model.state_rows(t, x, v, task.prepared)


def leg_at(legs: list[Leg], t: Vector, side: Literal["left", "right"]) -> NDArray[np.intp]:
    """Return (k,) the leg of each time: where one begins, itself ("right") or the one before it."""
    if len(legs) == 1:
        return np.zeros(len(t), dtype=np.intp)
    return np.asarray(np.searchsorted(np.array([leg.t[0] for leg in legs[1:]]), t, side))


def between(legs: list[Leg], side: Literal["left", "right"], t: Vector) -> Vector:
    """Return y (k, n_state) at t (k,) from the interpolants."""
    which = leg_at(legs, t, side)
    z = np.empty((len(t), 2 * legs[0].task.model.n))
    for number, leg in enumerate(legs):
        z[which == number] = leg.between(t[which == number])
    return published(legs, which, t, z)


def modes(legs: list[Leg], t: Vector, every: bool) -> tuple[tuple[int, float, tuple[float, ...]], ...]:
    """Return of each mode the first row, since when, and its parameters."""
    firsts = [
        leg.first if every else int(np.searchsorted(t, leg.t[0], "right" if leg.first else "left")) for leg in legs
    ]
    found = zip(firsts, legs, strict=True)
    return tuple((first, leg.t[0], leg.task.prepared.parameters) for first, leg in found)


def event_rows(
    legs: list[Leg], times: list[list[float]], states: list[list[Vector]]
) -> tuple[list[Vector], list[Vector]] | tuple[None, None]:
    """Return t_events and y_events; None where the model has no events."""
    if not times:
        return None, None
    t, rows = [np.array(each) for each in times], []
    for at, z in zip(t, states, strict=True):
        known = at[: len(z)]  # the state after the last one is not, where what it does has no answer
        rows.append(published(legs, leg_at(legs, known, "left"), known, np.array(z)))
    return t, rows
