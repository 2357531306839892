import numpy as np
from numpy.typing import ArrayLike, NDArray

from .faults import StopReason

Vector = NDArray[np.float64]

class Prepared:
    @property
    def model(self) -> CompiledModel: ...
    @property
    def parameters(self) -> tuple[float, ...]: ...

class CompiledModel:
    name: str
    formulation: str
    close_eigenvalues: str
    schur: str
    n: int
    m: int
    h: int
    n_state: int
    n_inputs: int
    n_outputs: int
    n_events: int
    coordinates: tuple[str, ...]
    parameters: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    events: tuple[str, ...]
    left_out: tuple[str, ...]
    layout: tuple[tuple[str, int, int], ...]
    block: tuple[int, ...]
    parameter_defaults: Vector
    input_defaults: Vector
    initial_x: Vector
    initial_v: Vector
    scales: Vector
    conserves_energy: bool
    def __init__(self, capsule: object) -> None: ...
    def prepare(self, values: ArrayLike) -> Prepared: ...
    def rhs(
        self, t: float, y: ArrayLike, c: Prepared, u: ArrayLike | None = None, out: Vector | None = None
    ) -> Vector: ...
    def state(self, t: float, x: ArrayLike, v: ArrayLike, c: Prepared) -> Vector: ...
    def mass_matrix(self, t: float, x: ArrayLike, c: Prepared) -> Vector: ...
    def mass_matrix_gradient(self, t: float, x: ArrayLike, c: Prepared) -> Vector: ...
    def pfaffian(self, t: float, x: ArrayLike, c: Prepared) -> tuple[Vector, Vector]: ...
    def position(self, t: float, x: ArrayLike, c: Prepared) -> Vector: ...
    def acceleration(
        self, t: float, x: ArrayLike, v: ArrayLike, c: Prepared, u: ArrayLike, least_norm: bool
    ) -> tuple[Vector, Vector]: ...
    def project(self, t: float, x: ArrayLike, v: ArrayLike, c: Prepared, least_norm: bool) -> tuple[Vector, Vector]: ...
    def velocity_rows(self, t: Vector, y: Vector, c: Prepared) -> Vector: ...
    def energy_rows(self, t: Vector, x: Vector, v: Vector, c: Prepared) -> Vector: ...
    def acceleration_rows(
        self, t: Vector, x: Vector, v: Vector, u: Vector, c: Prepared, least_norm: bool
    ) -> tuple[Vector, Vector]: ...
    def constraint_rows(self, t: Vector, x: Vector, v: Vector, c: Prepared) -> Vector: ...
    def position_rows(self, t: Vector, x: Vector, c: Prepared) -> Vector: ...
    def eigenfactor_rows(self, t: Vector, x: Vector, c: Prepared) -> tuple[Vector, Vector]: ...
    def factor_rows(self, t: Vector, x: Vector, C: Vector, s: Vector, c: Prepared) -> Vector: ...
    def output_rows(self, t: Vector, x: Vector, v: Vector, u: Vector, c: Prepared, least_norm: bool) -> Vector: ...

class Run:
    model: CompiledModel
    stop: StopReason
    def __init__(
        self,
        model: CompiledModel,
        c: Prepared,
        *,
        t_start: float,
        t_end: float,
        y: Vector,
        inputs: tuple[tuple[int, Vector, Vector], ...],
        method: int,
        rtol: float,
        atol: Vector,
        first_step: float,
        max_step: float,
        max_steps: int,
        project: bool,
        least_norm: bool,
        dense: bool,
        t_eval: Vector | None,
    ) -> None: ...
    @property
    def rows(self) -> tuple[Vector, Vector]: ...
    @property
    def events(self) -> tuple[tuple[Vector, Vector], ...]: ...
    @property
    def counts(self) -> tuple[int, int, int, int]: ...
    @property
    def t_reached(self) -> float: ...
    @property
    def message(self) -> str: ...
    @property
    def step_times(self) -> Vector: ...
    def interpolate(self, t: Vector) -> Vector: ...
