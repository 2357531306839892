from typing import Any

from numpy.typing import ArrayLike

from .point import PointModel, Prepared, Vector
from .run import Run
from .status.stop_reasons import EvaluationError

def motion_derivatives(
    model: PointModel, t: float, x: ArrayLike, v: ArrayLike, c: Prepared, u: ArrayLike, least_norm: int
) -> tuple[Vector, Vector, Vector, Vector]: ...
def equation_partials(
    model: PointModel,
    t: float,
    x: ArrayLike,
    v: ArrayLike,
    a: ArrayLike,
    multipliers: ArrayLike,
    c: Prepared,
    u: ArrayLike,
) -> Vector: ...
def reaction_rows(
    model: PointModel, t: float, x: ArrayLike, v: ArrayLike, c: Prepared, u: ArrayLike
) -> tuple[Vector, Vector]: ...
def levels(model: PointModel, t: float, x: ArrayLike, v: ArrayLike, c: Prepared, u: ArrayLike) -> Vector: ...
def input_columns(
    model: PointModel, t: float, x: ArrayLike, v: ArrayLike, a: ArrayLike, c: Prepared, u: ArrayLike
) -> Vector: ...
def constraint_partials(model: PointModel, t: float, x: ArrayLike, v: ArrayLike, c: Prepared) -> Vector: ...
def output_partials(
    model: PointModel,
    t: float,
    x: ArrayLike,
    v: ArrayLike,
    a: ArrayLike,
    multipliers: ArrayLike,
    c: Prepared,
    u: ArrayLike,
) -> Vector: ...
def quasi_partials(model: PointModel, t: float, x: ArrayLike, v: ArrayLike, c: Prepared) -> Vector: ...
def tangent(
    model: PointModel, t: float, x: ArrayLike, v: ArrayLike, c: Prepared, least_norm: int, S: Vector, P: Vector
) -> Vector: ...
def act_along(
    model: PointModel,
    t: float,
    x: ArrayLike,
    v: ArrayLike,
    c: Prepared,
    u: ArrayLike,
    least_norm: int,
    fired: ArrayLike,
    S: Vector,
    P: Vector,
) -> tuple[Vector, Vector, Prepared, Vector]: ...

class Variations:
    at_stops: Vector
    shifts: Vector
    at_rows: Vector
    def __init__(
        self,
        model: PointModel,
        c: Prepared,
        run: Run | None,
        inputs: tuple[Any, ...],
        direction: float,
        tolerance: float,
        together: float,
        stops: tuple[ArrayLike, ArrayLike, ArrayLike],
        spans: tuple[ArrayLike, ArrayLike],
        marks: tuple[ArrayLike, ArrayLike],
        nodes: tuple[ArrayLike, ArrayLike, ArrayLike, ArrayLike],
        rows: ArrayLike,
        S: Vector,
        P: Vector,
        stabilise: bool,
        least_norm: int,
    ) -> None: ...
    @property
    def model(self) -> PointModel: ...
    @property
    def counts(self) -> tuple[int, int, int]: ...
    def integrate(self) -> EvaluationError | None: ...

class Tape:
    def __init__(self, variations: Variations, basis: Vector) -> None: ...
    @property
    def variations(self) -> Variations: ...
    @property
    def fault(self) -> EvaluationError | None: ...
    @property
    def size(self) -> tuple[int, int]: ...
    def pull(self, at_stops: Vector, at_rows: Vector, cotangents: Vector) -> tuple[Vector, Vector]: ...
