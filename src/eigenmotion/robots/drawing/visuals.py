"""Visible shapes of the links of a URDF file: boxes, cylinders, balls, and meshes read by trimesh."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from ..description import Array, listed
from .solids import ball, box, cylinder, hull, placed


def place(origin: Array | None) -> tuple[Array, Array]:
    """Return the position (3,) and the rotation (3, 3) of a frame from a matrix (4, 4)."""
    return (np.zeros(3), np.eye(3)) if origin is None else (origin[:3, 3], origin[:3, :3])


class Visuals:
    """Solids of links, and what of them is not shown."""

    def __init__(self, file: Path, meshes: bool) -> None:
        self.file, self.meshes = file, meshes
        self.unread = 0
        self.failed: dict[str, str] = {}
        self._known: dict[str, Array | None] = {}

    def solids(self, link: Any) -> tuple[Array, ...]:
        """Return the corners (k, 3) [m] of each solid of a link, in its frame."""
        return tuple(
            placed(corners, *place(visual.origin))
            for visual in link.visuals
            if visual.geometry is not None and (corners := self._corners(visual.geometry)) is not None
        )

    def notes(self) -> Iterator[str]:
        """Give what is not shown, for people."""
        if self.unread:
            yield f"{self.unread} meshes are not read, of which meshes=True shows the convex hulls"
        if self.failed:
            reason = next(iter(self.failed.values()))
            yield f"{len(self.failed)} meshes cannot be read: {listed([*self.failed])}: {reason}"

    def _corners(self, geometry: Any) -> Array | None:
        if geometry.box is not None:
            return box(geometry.box.size)
        if geometry.cylinder is not None:
            return cylinder(geometry.cylinder.radius, geometry.cylinder.length)
        if geometry.sphere is not None:
            return ball(np.full(3, geometry.sphere.radius))
        if geometry.mesh is None:
            return None
        if not self.meshes:
            self.unread += 1
            return None
        corners = self._of_mesh(geometry.mesh.filename)
        scale = 1.0 if geometry.mesh.scale is None else geometry.mesh.scale
        return None if corners is None else corners * scale

    def _of_mesh(self, name: str) -> Array | None:
        """Return corners of the hull of a mesh, which links may share; None where it cannot be read."""
        if name not in self._known:
            try:
                self._known[name] = hull(_vertices(self.file, name))
            except Exception as error:  # of any kind: readers of meshes raise what they meet
                self._known[name] = None
                self.failed[name] = f"{type(error).__name__}: {error}"
        return self._known[name]


def _vertices(file: Path, name: str) -> Array:
    """Return the vertices (k, 3) of a mesh that a URDF file names, by a path or by package://."""
    import trimesh  # noqa: PLC0415, slow to load
    from yourdfpy.urdf import filename_handler_magic  # noqa: PLC0415

    path = Path(filename_handler_magic(name, dir=str(file.resolve().parent)))
    if not path.is_file():
        raise FileNotFoundError(f"there is no file {path.name} at that place or under a package of that name")
    mesh: Any = trimesh.load(path, force="mesh")
    return np.array(mesh.vertices, dtype=np.float64)
