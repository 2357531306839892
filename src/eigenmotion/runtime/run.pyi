from typing import Any

from .point import PointModel, Prepared, Vector
from .status.stop_reasons import StopReason

class Run:
    stop: StopReason
    model: PointModel
    unchanged: RuntimeError | None
    def __init__(self, task: Any, method: int, other: int = -1) -> None: ...
    def fields(self, method: str) -> dict[str, Any]: ...
    @property
    def segments(self) -> tuple[tuple[int, float, tuple[float, ...]], ...]: ...
    @property
    def methods(self) -> list[tuple[float, int]]: ...
    @property
    def charts(self) -> tuple[Vector, Vector, Vector]: ...
    @property
    def last(self) -> tuple[float, Vector] | None: ...
    @property
    def n_dense(self) -> int: ...
    @property
    def step_times(self) -> Vector: ...
    def interpolate(self, t: Vector) -> Vector: ...

def _restored_run(
    prepared: Prepared,
    method: int,
    stabilise: int,
    least_norm: int,
    times: tuple[float, float, float],
    count: int,
    steps: bytes,
    table: bytes,
    segments: bytes = b"",
) -> Run: ...
