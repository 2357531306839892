"""The drawing of a robot: its solids, and lines between the frames of joints where it has none."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...codegen.model import Tree, draw
from ..description import Part


def drawing_of(parts: Sequence[Part], tree: Tree) -> tuple[draw.Line | draw.Solid, ...]:
    """Return the solids of a robot, and the skeleton of the parts that show none."""
    solids = [(tree.bodies[part.name], corners.tolist()) for part in parts for corners in part.solids]
    shown = (draw.Solid(body.position(), body.rotation, corners) for body, corners in solids)
    return (*shown, *skeleton(parts, tree))


def skeleton(parts: Sequence[Part], tree: Tree) -> tuple[draw.Line, ...]:
    """Return a line from each frame to those that it carries, where mass or a joint is beyond.

    Frames whose part shows solids have no lines.
    """
    shown = {part.name for part in parts if part.solids}
    needed: set[str | None] = set()
    lines = []
    for part in reversed(parts):
        if part.name in needed or part.joint.kind != "fixed" or (part.mass is not None and part.mass.mass):
            needed.add(part.parent)
            moves = part.joint.kind in ("prismatic", "planar", "free")
            if part.parent is not None and part.parent not in shown and (moves or np.any(part.at)):
                before = tree.bodies[part.parent]
                end = tree.bodies[part.name].position() if moves else before.position(part.at.tolist())
                lines.append(draw.Line(before.position(), end))
    return tuple(reversed(lines))
