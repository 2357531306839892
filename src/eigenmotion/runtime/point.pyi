from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Vector = NDArray[np.float64]

class Prepared:
    @property
    def model(self) -> PointModel: ...
    @property
    def parameters(self) -> tuple[float, ...]: ...

class Actuators:
    @property
    def names(self) -> tuple[str, ...]: ...
    @property
    def weights(self) -> tuple[float, ...] | None: ...
    def __init__(
        self,
        names: Sequence[str],
        coordinates: Sequence[int],
        inputs: Sequence[int],
        weights: Sequence[float] | None = None,
    ) -> None: ...

class PointModel:
    name: str
    formulation: str
    close_eigenvalues: str
    schur: str
    n: int
    m: int
    h: int
    n_state: int
    n_states: int
    n_coordinates: int
    n_inputs: int
    n_outputs: int
    n_events: int
    n_arguments: int
    lanes: int
    lane_groups: bool
    dimension: int
    n_drawn: int
    coordinates: tuple[str, ...]
    parameters: tuple[str, ...]
    tables: dict[str, tuple[int, int]]
    prescribed: dict[str, int]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    events: tuple[str, ...]
    left_out: tuple[str, ...]
    layout: tuple[tuple[str, int, int], ...]
    block: tuple[int, ...]
    acting: tuple[bool, ...]
    rotations: tuple[tuple[int, int, int], ...]
    """Coordinates that are modified Rodrigues parameters and may be replaced by their shadow set."""
    switches: tuple[tuple[int, int, int, int, int, int, int], ...]
    has_cones: bool
    acts: bool
    shapes: tuple[tuple[str, int, int, Vector | None], ...]
    quasi_velocities: tuple[str, ...]
    row_names: tuple[str, ...]
    carried: tuple[int, ...]
    parameter_defaults: Vector
    input_defaults: Vector
    initial_x: Vector
    initial_v: Vector
    initial_y: Vector | None
    scales: Vector
    augmented: bool
    conserves_energy: bool
    extrapolates: bool
    known_actuators: dict[Any, Actuators]
    recipe: Callable[[], Any] | None
    load_part: Callable[[str], Any] | None
    undefined_terms: Callable[[dict[str, float]], str] | None
    units: dict[str, str] | None
    @property
    def mixed_inputs(self) -> frozenset[tuple[int, int]]: ...
    @property
    def pushes(self) -> bool: ...
    @property
    def inverts(self) -> bool: ...
    @property
    def differentiates(self) -> bool: ...
    def __init__(self, capsule: object) -> None: ...
    def inside(
        self, t: float, x: Vector, v: Vector, c: Prepared, rtol: float, atol: Vector
    ) -> tuple[str, float] | None: ...
    def smooth_interval(self, t: float, direction: float, c: Prepared) -> tuple[float, float, float]: ...
    def identity(self, c: Prepared) -> tuple[Any, ...]: ...
    def undefined(self, t: float, x: Vector, v: Vector | None, c: Prepared, u: Vector | None = None) -> str: ...
    def check_table_arguments(self, t: float, x: ArrayLike, v: ArrayLike, c: Prepared) -> None: ...
    def check_tables_of(self, rows: Vector) -> None: ...
    def outside_of(self, name: str) -> str: ...
    def prepare(self, values: ArrayLike) -> Prepared: ...
    def rhs(
        self, t: float, y: ArrayLike, c: Prepared, u: ArrayLike | None = None, out: Vector | None = None
    ) -> Vector: ...
    def state(self, t: float, x: ArrayLike, v: ArrayLike, c: Prepared) -> Vector: ...
    def start(
        self, t: float, x: Vector, v: Vector, c: Prepared, rtol: float, atol: Vector
    ) -> tuple[int, Vector, int, Any]: ...
    def mass_matrix(self, t: float, x: ArrayLike, c: Prepared) -> Vector: ...
    def mass_matrix_gradient(self, t: float, x: ArrayLike, c: Prepared) -> Vector: ...
    def factored_matrix(self, t: float, x: ArrayLike, c: Prepared) -> Vector: ...
    def factored_gradient(self, t: float, x: ArrayLike, c: Prepared) -> Vector: ...
    def pfaffian(self, t: float, x: ArrayLike, c: Prepared) -> tuple[Vector, Vector]: ...
    def position(self, t: float, x: ArrayLike, c: Prepared) -> tuple[Vector, Vector]: ...
    def acceleration(
        self, t: float, x: ArrayLike, v: ArrayLike, c: Prepared, u: ArrayLike, least_norm: int
    ) -> tuple[Vector, Vector]: ...
    def redundant(self, t: float, x: ArrayLike, c: Prepared) -> tuple[int, tuple[int, ...]]: ...
    def shares(self, t: float, x: ArrayLike, c: Prepared, option: int) -> int: ...
    def project(self, t: float, x: ArrayLike, v: ArrayLike, c: Prepared, least_norm: int) -> tuple[Vector, Vector]: ...

def _compiled(recipe: Callable[[], Any]) -> PointModel: ...
def _prepared(model: PointModel, parameters: ArrayLike) -> Prepared: ...
