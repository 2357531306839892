"""Solids of robots for drawings: corners of convex hulls of boxes, balls, cylinders and meshes."""

from __future__ import annotations

import numpy as np

from ..description import Array

_AROUND = 24
"""Corners of a circle"""
_DIRECTIONS = 160
"""Directions in which a body is touched by a plane: at most so many corners are kept of a mesh"""


def box(sizes: Array) -> Array:
    """Return the corners (8, 3) of a box about the origin with sides (3,) [m]."""
    signs = np.array(np.meshgrid([-0.5, 0.5], [-0.5, 0.5], [-0.5, 0.5])).reshape(3, -1).T
    return np.array(signs * sizes)


def cylinder(radius: float, length: float) -> Array:
    """Return the corners of a cylinder about the z axis, the origin in its middle."""
    return np.concatenate([_circle(radius, -length / 2), _circle(radius, length / 2)])


def ball(radii: Array) -> Array:
    """Return corners of an ellipsoid about the origin with radii (3,) [m]."""
    return directions(_DIRECTIONS // 2) * radii


def capsule(radius: float, length: float) -> Array:
    """Return corners of a cylinder about the z axis with half balls at both ends, `length` apart."""
    ends = directions(_DIRECTIONS // 2) * radius
    return np.array(ends + np.where(ends[:, 2:] < 0, -1, 1) * [0, 0, length / 2])


def hull(points: Array) -> Array:
    """Return those of points (k, 3) that a plane touches first from one of many directions: corners of their hull.

    The smaller hull misses the larger one by no more than some hundredths of its size.
    """
    touched = np.unique(np.argmax(points @ directions(_DIRECTIONS).T, axis=0))
    return np.array(points[touched])


def placed(corners: Array, at: Array, rotation: Array) -> Array:
    """Return corners (k, 3) in another frame, in which their own has the origin `at` and the axes `rotation`."""
    return np.array(corners @ rotation.T + at)


def directions(count: int) -> Array:
    """Return unit vectors (count, 3), evenly spread: along a spiral with the golden angle."""
    k = np.arange(count) + 0.5
    z, angle = 1 - 2 * k / count, np.pi * (3 - np.sqrt(5)) * k
    across = np.sqrt(1 - z**2)
    return np.column_stack([across * np.cos(angle), across * np.sin(angle), z])


def _circle(radius: float, height: float) -> Array:
    angle = 2 * np.pi * np.arange(_AROUND) / _AROUND
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), np.full(_AROUND, height)])
