from collections.abc import Callable, Sequence
from typing import Any

from .faults import StopReason
from .point import PointModel, Prepared, Vector

COUNTS: tuple[str, ...]
TOLD: int

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
    model: PointModel, legs: Sequence[tuple[int, float, tuple[float, ...]]]
) -> tuple[tuple[float, dict[str, float]], ...]: ...

class Run:
    stop: StopReason
    model: PointModel
    def __init__(self, task: Any, method: int, whole: bool = True) -> None: ...
    def advance(self, t: float) -> bool: ...
    def tell(
        self, t: float, z: Vector, t_new: float, z_new: Vector, inside: Callable[[Vector], Vector]
    ) -> bool | None: ...
    def set(self, place: int, value: float) -> None: ...
    def now(self) -> tuple[Vector, Vector]: ...
    def close(self, stop: StopReason | None = None, said: str = "") -> None: ...
    def fields(self, method: str, counts: tuple[int | None, ...] | None = None) -> dict[str, Any]: ...
    @property
    def t(self) -> float: ...
    @property
    def nsteps(self) -> int: ...
    @property
    def parameters(self) -> list[float] | None: ...
    @property
    def legs(self) -> tuple[tuple[int, float, tuple[float, ...]], ...]: ...
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
    legs: bytes = b"",
) -> Run: ...
