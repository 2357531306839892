from typing import Any

from ..runtime import Actuators, CompiledModel, Prepared
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
def inverse_dynamics(
    system: Any,
    model: CompiledModel,
    defaults: Prepared,
    x: Any,
    v: Any,
    a: Any,
    t: Any,
    parameters: Any,
    inputs: Any,
    of: Actuators,
) -> tuple[Vector, Vector, Vector, float, float] | None: ...
