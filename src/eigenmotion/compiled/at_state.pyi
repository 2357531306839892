from collections.abc import Iterator
from typing import Any

from ..runtime import CompiledModel, Prepared
from ..runtime.point import Vector

def begin(
    system: Any, model: CompiledModel, defaults: Prepared, x0: Any, v0: Any, t: Any, parameters: Any
) -> tuple[Vector, Vector]: ...
def mass_matrix(system: Any, model: CompiledModel, defaults: Prepared, x: Any, t: Any, parameters: Any) -> Vector: ...
def energies(
    system: Any, model: CompiledModel, defaults: Prepared, x: Any, v: Any, t: Any, parameters: Any
) -> tuple[float, float, float, float]: ...
def acceleration(
    system: Any,
    model: CompiledModel,
    defaults: Prepared,
    x: Any,
    v: Any,
    t: Any,
    parameters: Any,
    inputs: Any,
    least_norm: int,
) -> tuple[Vector, Vector]: ...

class InverseDynamics:
    forces: Vector
    multipliers: Vector
    residual: Vector
    def __init__(self, forces: Vector, multipliers: Vector, residual: Vector) -> None: ...
    def __iter__(self) -> Iterator[Vector]: ...

def inverse_dynamics(
    system: Any, x: Any, v: Any, a: Any, t: Any, parameters: Any, inputs: Any, actuators: Any
) -> InverseDynamics | None: ...
