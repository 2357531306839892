"""Arrays of results of the members of an ensemble."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arguments.named_values import Vector
from ..arguments.signals import Inputs
from ..arguments.states import names_of_states
from ..arguments.tasks import EnsembleTask, Members
from ..runtime import COUNTS, CompiledModel, StopReason
from .trajectory import Segment

REASONS = tuple(StopReason)
_EACH = ("y", "t_end", "status", "first", "second", "size", "counts", "event_counts", "S")


@dataclass(eq=False)
class BatchArrays:
    """Results of some members: the arrays of `Chunk`, and results that are not arrays.

    counts : (K, 7), the COUNTS of a Solution
    S, dt_events : (K, nt, 2 n, columns) and (events, columns): derivatives of rows, and of event_times
    messages : member -> message, of members that ran or were refused one by one
    segments : member -> segments as in `Trajectory`, for models with contacts
    recorded_inputs : member -> inputs, of members with controllers: the values that these returned, as Signals
    """

    y: Vector
    t_end: Vector
    status: NDArray[Any]
    first: NDArray[Any]
    second: NDArray[Any]
    size: Vector
    counts: NDArray[Any]
    event_times: Vector
    events: Vector
    event_counts: NDArray[Any]
    S: Vector
    dt_events: Vector
    messages: dict[int, str] = field(default_factory=dict)
    segments: dict[int, tuple[Segment, ...]] = field(default_factory=dict)
    recorded_inputs: dict[int, Inputs] = field(default_factory=dict)

    @classmethod
    def unrun(cls, common: EnsembleTask, count: int) -> "BatchArrays":
        """Return the arrays of members that have not run."""
        model, columns = common.model, len(common.differentiated.names) if common.differentiated else 0
        interrupted = REASONS.index(StopReason.INTERRUPTED)
        return cls(
            y=np.full((count, len(common.t_eval), model.n_state), np.nan),
            t_end=np.full(count, common.t_start),
            status=np.full(count, interrupted, dtype=np.intc),
            first=np.full(count, -1, dtype=np.intc),
            second=np.full(count, -1, dtype=np.intc),
            size=np.zeros(count),
            counts=np.zeros((count, len(COUNTS)), dtype=np.int_),
            event_times=np.empty(0),
            events=np.empty((0, model.n_state)),
            event_counts=np.zeros((count, model.n_events), dtype=np.int_),
            S=np.full((count, len(common.t_eval), 2 * model.n, columns), np.nan),
            dt_events=np.empty((0, columns)),
        )

    def inputs_of(self, k: int, members: Members) -> Inputs:
        """Return the inputs of a member in its run."""
        return self.recorded_inputs[k] if k in self.recorded_inputs else members.inputs_of(k)

    def by_mode(
        self, function: Callable[..., Any], rows: tuple[Vector, ...], members: Members, least_norm: int
    ) -> tuple[Vector, ...]:
        """Return the values of a function of rows (t, y, v, u), with the parameters of the mode of each row."""
        t, *others = rows
        parts = []
        for k, columns in enumerate(zip(*others, strict=True)):
            parameters = np.tile(members.row("parameters", k), (t.shape[1], 1))
            for first, _, of_mode in self.segments.get(k, ()):
                parameters[first:] = of_mode
            single = (column[:, None] for column in (t[k if len(t) > 1 else 0], *columns))
            parts.append(function(*single, parameters, least_norm))
        return tuple(np.stack([part[:, 0] for part in each]) for each in zip(*parts, strict=True))


class Collection:
    """Collected results of chunks, which arrive in any order; the memory for all is allocated at once."""

    def __init__(self, common: EnsembleTask, count: int) -> None:
        self._whole, self._events = BatchArrays.unrun(common, count), dict[int, tuple[Vector, ...]]()

    def put(self, start: int, part: BatchArrays) -> None:
        """Store the results of the members from `start` on."""
        for name in _EACH:
            getattr(self._whole, name)[start : start + len(part.t_end)] = getattr(part, name)
        self._whole.messages |= {start + k: text for k, text in part.messages.items()}
        self._whole.segments |= {start + k: segments for k, segments in part.segments.items()}
        self._whole.recorded_inputs |= {start + k: inputs for k, inputs in part.recorded_inputs.items()}
        self._events[start] = part.event_times, part.events, part.dt_events

    @property
    def whole(self) -> BatchArrays:
        """The results of all members."""
        parts = [self._events[start] for start in sorted(self._events)]
        if parts:
            of_all = map(np.concatenate, zip(*parts, strict=True))
            self._whole.event_times, self._whole.events, self._whole.dt_events = of_all
        return self._whole


def empty_fields(model: CompiledModel) -> dict[str, Any]:
    """Return the fields of a `Solution` without rows."""
    n, m, h, empty = model.n_coordinates, model.m, model.h, np.empty(0)
    shapes = {
        "x": (n,), "v": (n,), "eta": (n,), "C": (n, n), "s": (n,), "multipliers": (m,), "energy": (),
        "jacobi_integral": (), "constraint_residual": (m,), "position_residual": (h,), "factor_residual": (),
    }  # fmt: skip
    return {name: np.empty((*shape, 0)) for name, shape in shapes.items()} | {
        "drawing": None,
        "outputs": dict.fromkeys(model.outputs, empty),
        "states": dict.fromkeys(names_of_states(model), empty),
        "quasi_velocities": dict.fromkeys(model.quasi_velocities, empty),
    }
