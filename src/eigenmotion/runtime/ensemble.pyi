from typing import Any

from numpy.typing import NDArray

from .point import PointModel, Vector

class Stop:
    def set(self) -> None: ...
    def __bool__(self) -> bool: ...

class Chunk:
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
    def __init__(self, task: Any, members: Any, stop: Stop) -> None: ...

def velocities(model: PointModel, t: Vector, y: Vector, parameters: Vector) -> Vector: ...
def energies(model: PointModel, t: Vector, y: Vector, v: Vector, parameters: Vector) -> Vector: ...
def reactions(
    model: PointModel, t: Vector, y: Vector, v: Vector, u: Vector, parameters: Vector, least_norm: int
) -> tuple[Vector, Vector, Vector]: ...
