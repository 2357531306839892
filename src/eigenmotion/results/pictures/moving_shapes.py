"""Drawing of a model along a run: points and sizes of its shapes at each row."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model import ModelError
from ...presentation.units import Units

_AXIS = 3


@dataclass(frozen=True)
class Shape:
    """One shape at all rows: points (k, p, d) [m]; for a disk also `more` (k, ...): radius, axle (in space), angle."""

    kind: str
    points: Vector
    more: Vector

    @property
    def radius(self) -> Vector:
        """(k,) radius of a disk."""
        return self.more[:, 0]

    @property
    def axis(self) -> Vector | None:
        """(k, 3) axle of a wheel in space; None: a ball, or a disk in the plane."""
        return self.more[:, 1 : 1 + _AXIS] if self.more.shape[1] > _AXIS else None

    @property
    def angle(self) -> Vector | None:
        """(k,) angle of the mark on a disk; None: there is no mark."""
        return self.more[:, -1] if self.more.shape[1] in (2, 2 + _AXIS) else None


@dataclass(frozen=True)
class Drawing:
    """The shapes of a mechanism at k times.

    t : (k,) [s]
    dimension : 2 or 3
    kinds : for each shape its kind, the first column and number of columns of its numbers, and of a solid the corners
        (k, 3) in its frame, else None
    numbers : (k, n_drawn), of all shapes
    units : of the model, as words
    """

    name: str
    t: Vector
    dimension: int
    kinds: tuple[tuple[str, int, int, Vector | None], ...]
    numbers: Vector
    units: Units = None

    @cached_property
    def shapes(self) -> tuple[Shape, ...]:
        """Every shape, in the order of the model."""
        return tuple(self._shape(*kind) for kind in self.kinds)

    def _shape(self, kind: str, first: int, count: int, corners: Vector | None) -> Shape:
        numbers, d = self.numbers[:, first : first + count], self.dimension
        if corners is not None:
            axes = numbers[:, d:].reshape(-1, d, d)
            return Shape(kind, numbers[:, None, :d] + corners @ axes.transpose(0, 2, 1), numbers[:, :0])
        end = d if kind == "disk" else count
        return Shape(kind, numbers[:, :end].reshape(len(numbers), -1, d), numbers[:, end:])

    @cached_property
    def box(self) -> tuple[Vector, Vector]:
        """Lower and upper corner (d,) of a box around all shapes at all rows, with a margin."""
        low, high = np.full(self.dimension, np.inf), np.full(self.dimension, -np.inf)
        for shape in self.shapes:
            room = shape.radius[:, None, None] if shape.kind == "disk" else 0.0
            with np.errstate(invalid="ignore"):
                low = np.fmin(low, np.nanmin(shape.points - room, axis=(0, 1)))
                high = np.fmax(high, np.nanmax(shape.points + room, axis=(0, 1)))
        room = 0.06 * float(np.max(high - low)) or 1.0
        return low - room, high + room

    @property
    def size(self) -> float:
        """The longest side of the box [m], by which marks without a size of their own are scaled."""
        low, high = self.box
        return float(np.max(high - low))


def require_drawing(drawing: Drawing | None, name: str) -> Drawing:
    """Return a drawing.

    Raises
    ------
    ModelError
        The model has no drawing; the message tells how to add one.
    """
    if drawing is None:
        raise ModelError(f"{name} has no drawing. Give it one: Model(drawing=[eigenmotion.draw.Line(p, q), ...])")
    return drawing
