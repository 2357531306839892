"""The drawing of a robot: lines between the frames of its joints."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..codegen.model import Tree, draw
from .description import Part


def skeleton(parts: Sequence[Part], tree: Tree) -> tuple[draw.Line, ...]:
    """Return a line from each frame to those that it carries, where mass or a joint is beyond."""
    needed: set[str | None] = set()
    lines = []
    for part in reversed(parts):
        if part.name in needed or part.joint.kind != "fixed" or (part.mass is not None and part.mass.mass):
            needed.add(part.parent)
            moves = part.joint.kind in ("prismatic", "planar", "free")
            if part.parent is not None and (moves or np.any(part.at)):
                before = tree.bodies[part.parent]
                end = tree.bodies[part.name].position() if moves else before.position(part.at.tolist())
                lines.append(draw.Line(before.position(), end))
    return tuple(reversed(lines))
