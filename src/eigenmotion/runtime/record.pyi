from collections.abc import Sequence
from typing import Any

from .point import PointModel, Vector
from .status.stop_reasons import StopReason

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
    y_after_events: list[Vector] | None = None,
    modes: tuple[tuple[float, dict[str, float]], ...] = (),
) -> dict[str, Any]: ...
def modes_of(
    model: PointModel, segments: Sequence[tuple[int, float, tuple[float, ...]]]
) -> tuple[tuple[float, dict[str, float]], ...]: ...
