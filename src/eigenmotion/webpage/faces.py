"""Faces of solids in space as lists of corners, computed once, since solids are rigid."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import scipy

from ..arguments.named_values import Vector
from ..codegen.model import Model
from ..codegen.model.normalise import t


def faces(model: Model) -> Iterator[dict[str, Any]]:
    """Yield for each shape {"faces": indices of corners, face by face} if it is a solid in space, else {}.

    With a frame the corners are those in the frame, which are data of the page, too.
    """
    values = dict(zip(model.coordinates, model.initial_x, strict=True)) | dict(model.parameters)
    for shape in model.drawing:
        if shape.kind == "solid":
            corners = np.round(np.array(shape.corners), 6)
            yield {"corners": corners.tolist(), "faces": around(corners)}
            continue
        if shape.kind != "body" or shape.dimension == len("xy"):
            yield {}
            continue
        numbers = [float(number.xreplace(values).xreplace({t: 0}).evalf(17)) for number in shape.numbers]
        yield {"faces": around(np.array(numbers).reshape(-1, shape.dimension))}


def around(corners: Vector) -> list[list[int]]:
    """Return the faces of the convex hull of corners (k, 3), corners in order; all corners if they are in one plane."""
    try:
        hull = scipy.spatial.ConvexHull(corners)
    except (scipy.spatial.QhullError, ValueError):
        return [list(range(len(corners)))]
    planes: dict[tuple[float, ...], set[int]] = {}
    for plane, triangle in zip(hull.equations, hull.simplices, strict=True):
        planes.setdefault(tuple(np.round(plane, 6)), set()).update(map(int, triangle))
    return [_round(corners, np.array(plane[:3]), sorted(members)) for plane, members in planes.items()]


def _round(corners: Vector, normal: Vector, members: list[int]) -> list[int]:
    middle = corners[members].mean(axis=0)
    first = corners[members[0]] - middle
    second = np.cross(normal, first)
    return sorted(
        members, key=lambda k: float(np.arctan2((corners[k] - middle) @ second, (corners[k] - middle) @ first))
    )
