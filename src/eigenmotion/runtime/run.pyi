from typing import Any

from .faults import StopReason
from .point import Prepared, Vector

class Run:
    stop: StopReason
    def __init__(self, task: Any, method: int) -> None: ...
    @property
    def fields(self) -> dict[str, Any]: ...
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
