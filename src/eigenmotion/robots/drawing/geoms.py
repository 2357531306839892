"""Geoms of a compiled MJCF file as solids."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from ..description import Array
from .solids import ball, box, capsule, cylinder, hull, placed

SPHERE, CAPSULE, ELLIPSOID, CYLINDER, BOX, MESH = range(2, 8)
"""mjtGeom"""
_GROUPS = 3
"""Groups of geoms that MuJoCo's viewer shows at first: the others are for collisions"""


def solids(m: Any, body: int) -> Iterator[Array]:
    """Yield the corners (k, 3) of each visible geom of a body, in its frame."""
    first = int(m.body_geomadr[body])
    for k in range(first, first + int(m.body_geomnum[body])):
        if m.geom_group[k] < _GROUPS and (corners := _corners(m, k)) is not None:
            turned = Rotation.from_quat(m.geom_quat[k], scalar_first=True).as_matrix()
            yield placed(corners, m.geom_pos[k], turned)


def _corners(m: Any, k: int) -> Array | None:
    size, kind = np.array(m.geom_size[k]), int(m.geom_type[k])
    if kind == SPHERE:
        return ball(np.full(3, size[0]))
    if kind == CAPSULE:
        return capsule(size[0], 2 * size[1])
    if kind == ELLIPSOID:
        return ball(size)
    if kind == CYLINDER:
        return cylinder(size[0], 2 * size[1])
    if kind == BOX:
        return box(2 * size)
    return hull(_vertices(m, int(m.geom_dataid[k]))) if kind == MESH else None


def _vertices(m: Any, mesh: int) -> Array:
    first, count = int(m.mesh_vertadr[mesh]), int(m.mesh_vertnum[mesh])
    return np.array(m.mesh_vert[first : first + count], dtype=float)
