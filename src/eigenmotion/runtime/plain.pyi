from typing import Any, TypeVar

from .point import PointModel, Prepared, Vector

T = TypeVar("T")
MOST_STEPS: int

def mass_matrix(model: PointModel, defaults: Prepared, x: Any, t: Any, parameters: Any) -> Vector | None: ...
def energies(
    model: PointModel, defaults: Prepared, x: Any, v: Any, t: Any, parameters: Any
) -> tuple[float, float, float, float] | None: ...
def acceleration(
    model: PointModel, defaults: Prepared, x: Any, v: Any, t: Any, parameters: Any, inputs: Any, least_norm: Any
) -> tuple[Vector, Vector] | None: ...
def task(
    Task: type[T],
    model: PointModel,
    defaults: Prepared,
    inputs: Any,
    t_span: Any,
    x0: Any,
    v0: Any,
    parameters: Any,
    rtol: Any,
    atol: Any,
    t_eval: Any,
    dense: Any,
    first_step: Any,
    max_step: Any,
    max_steps: Any,
    stabilisation: Any,
    stabilisations: dict[str, bool],
    dependent: Any,
    dependents: dict[str, int],
) -> T | None: ...
