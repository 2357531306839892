"""The drawing of a model along a run: the numbers of its shapes, row by row."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...arguments.named_values import Vector
from ...codegen.model import ModelError

_AXIS = 3


@dataclass(frozen=True)
class Shape:
    """One shape in all rows: points (k, p, d) [m]; `more` (k, ...) of a disk: radius, axle (space), angle."""

    kind: str
    points: Vector
    more: Vector

    @property
    def radius(self) -> Vector:
        """(k,) of a disk."""
        return self.more[:, 0]

    @property
    def axis(self) -> Vector | None:
        """(k, 3) of a wheel in space, None: a ball, or the plane."""
        return self.more[:, 1 : 1 + _AXIS] if self.more.shape[1] > _AXIS else None

    @property
    def angle(self) -> Vector | None:
        """(k,) of the mark on a disk, None: there is none."""
        return self.more[:, -1] if self.more.shape[1] in (2, 2 + _AXIS) else None


@dataclass(frozen=True)
class Drawing:
    """What a mechanism looks like at k times.

    t : (k,) [s]
    dimension : 2 or 3
    kinds : of each shape its kind, and the place and count of its numbers
    numbers : (k, n_drawn), those of all shapes
    """

    name: str
    t: Vector
    dimension: int
    kinds: tuple[tuple[str, int, int], ...]
    numbers: Vector

    @cached_property
    def shapes(self) -> tuple[Shape, ...]:
        """Every shape, in the order of the model."""
        return tuple(self._shape(*kind) for kind in self.kinds)

    def _shape(self, kind: str, first: int, count: int) -> Shape:
        numbers, d = self.numbers[:, first : first + count], self.dimension
        end = d if kind == "disk" else count
        return Shape(kind, numbers[:, :end].reshape(len(numbers), -1, d), numbers[:, end:])

    @cached_property
    def box(self) -> tuple[Vector, Vector]:
        """Lower and upper corner (d,) of all that is ever drawn, with some room."""
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
        """The longest side of the box [m]: what marks of no size of their own are sized by."""
        low, high = self.box
        return float(np.max(high - low))


def require_drawing(drawing: Drawing | None, name: str) -> Drawing:
    """Return a drawing.

    Raises
    ------
    ModelError
        The model has none; says how to give it one.
    """
    if drawing is None:
        raise ModelError(f"{name} has no drawing. Give it one: Model(drawing=[eigenmotion.draw.Line(p, q), ...])")
    return drawing
