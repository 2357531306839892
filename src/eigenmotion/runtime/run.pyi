from typing import Any

from .faults import StopReason
from .point import Prepared, Vector

COUNTS: tuple[str, ...]

def record(
    t: Vector,
    y: Vector,
    t_events: list[Vector] | None,
    y_events: list[Vector] | None,
    stop: StopReason,
    message: str,
    method: str,
    counts: tuple[int | None, ...],
    sol: Any = None,
) -> dict[str, Any]: ...

class Run:
    stop: StopReason
    def __init__(self, task: Any, method: int) -> None: ...
    def fields(self, method: str) -> dict[str, Any]: ...
    @property
    def n_dense(self) -> int: ...
    @property
    def step_times(self) -> Vector: ...
    def interpolate(self, t: Vector) -> Vector: ...

def _kept(
    prepared: Prepared,
    method: int,
    stabilise: int,
    least_norm: int,
    times: tuple[float, float, float],
    count: int,
    steps: bytes,
    table: bytes,
) -> Run: ...
