"""The faces of solids in space: which corners go round each, found once, for solids stay what they are."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import scipy

from ..arguments.named_values import Vector
from ..codegen.model import Model
from ..codegen.model.normalise import t


def faces(model: Model) -> Iterator[dict[str, Any]]:
    """Return for each shape of a drawing {"faces": indices of corners, face by face} of a solid in space, else {}."""
    values = dict(zip(model.coordinates, model.initial_x, strict=True)) | dict(model.parameters)
    for shape in model.drawing:
        if shape.kind != "body" or shape.dimension == len("xy"):
            yield {}
            continue
        numbers = [float(number.xreplace(values).xreplace({t: 0}).evalf(17)) for number in shape.numbers]
        yield {"faces": around(np.array(numbers).reshape(-1, shape.dimension))}


def around(corners: Vector) -> list[list[int]]:
    """Return the faces of the hull of corners (k, 3), each in the order round it; all corners where they are flat."""
    try:
        hull = scipy.spatial.ConvexHull(corners)
    except (scipy.spatial.QhullError, ValueError):
        return [list(range(len(corners)))]
    planes: dict[tuple[float, ...], set[int]] = {}
    for plane, triangle in zip(hull.equations, hull.simplices, strict=True):
        planes.setdefault(tuple(np.round(plane, 6)), set()).update(map(int, triangle))
    return [_round(corners, np.array(plane[:3]), sorted(held)) for plane, held in planes.items()]


def _round(corners: Vector, normal: Vector, held: list[int]) -> list[int]:
    middle = corners[held].mean(axis=0)
    first = corners[held[0]] - middle
    second = np.cross(normal, first)
    return sorted(held, key=lambda k: float(np.arctan2((corners[k] - middle) @ second, (corners[k] - middle) @ first)))
