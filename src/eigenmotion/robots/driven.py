"""Joints that others drive, and joints that are held: what remains of the joints of a file."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

import numpy as np
from scipy.spatial.transform import Rotation

from ..codegen.model.normalise import ModelError, nearest
from .description import FREEDOMS, Description, Joint, Part

Drives = Mapping[str, tuple[str, float, float]]
"""Driven joint -> the joint that drives it, ratio and offset; that joint is not driven itself"""


def reduced(robot: Description, locked: Collection[str]) -> tuple[Description, Drives]:
    """Return a robot without the joints that are locked, or driven by such joints, and the drives that remain.

    Raises
    ------
    ModelError
        A joint is unknown, drives itself, or is none that drives or is driven.
    """
    joints = {part.joint.name: part.joint for part in robot.parts}
    if unknown := [name for name in locked if name not in joints]:
        raise ModelError(f"locked names {unknown[0]!r}, which is no joint.{nearest(str(unknown[0]), joints)}")
    joints |= {name: Joint(name, "fixed") for name in locked}
    drives = {name: _source(name, joints) for name, joint in joints.items() if joint.driven}
    still = {name: offset for name, (source, _, offset) in drives.items() if joints[source].kind == "fixed"}
    parts = [replace(part, joint=joints[part.joint.name]) for part in robot.parts]
    for k, (part, before) in enumerate(zip(parts, robot.parts, strict=True)):
        if part.joint.name in still or part.joint is not before.joint:
            parts[k] = _held(before, still.get(part.joint.name, 0.0))
    return replace(robot, parts=tuple(parts)), {name: one for name, one in drives.items() if name not in still}


def _source(name: str, joints: Mapping[str, Joint]) -> tuple[str, float, float]:
    """Return the joint that moves another one, in the end, and the displacement as ratio and offset of its own."""
    ratio, offset, at = 1.0, 0.0, name
    passed = [name]
    while (driven := joints[at].driven) is not None:
        if driven.joint not in joints:
            raise ModelError(
                f"joint {at!r} is driven by {driven.joint!r}, which is no joint.{nearest(driven.joint, joints)}"
            )
        offset += ratio * driven.offset
        ratio, at = ratio * driven.ratio, driven.joint
        if at in passed:
            raise ModelError(f"joint {name!r} is driven by itself: {' <- '.join([*passed, at])}.")
        passed.append(at)
    for one in passed:
        if FREEDOMS[joints[one].kind] > 1:
            raise ModelError(f"joint {one!r} is {joints[one].kind}: only joints of one coordinate drive others.")
    return at, ratio, offset


def _held(part: Part, displacement: float) -> Part:
    """Return a part whose joint is held at a displacement."""
    at, rotation, axis = part.at, part.rotation, np.array(part.joint.axis)
    if part.joint.kind == "prismatic" and displacement:
        at = at + displacement * (rotation @ axis)
    if part.joint.kind == "revolute" and displacement:
        rotation = rotation @ Rotation.from_rotvec(displacement * axis).as_matrix()
    return Part(part.name, part.parent, Joint(part.joint.name, "fixed"), at, rotation, part.mass)
