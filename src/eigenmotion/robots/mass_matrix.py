"""The mass matrix of a described robot in numbers, at one position: it shows which joint moves no mass."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

from .description import Array, Description, Joint, Mass, Part

_LEAST = 1e-12
"""A pivot smaller than this, relative to what the joint carries, is zero."""
_STEP = 0.6180339887498949
"""Displacements are multiples of this, so that no position is special."""


class Placed(NamedTuple):
    """A part at a position, in the ground's axes: rotation (3, 3), origin (3,), columns (6, k) of its joint."""

    R: Array
    p: Array
    motions: Array


def massless_joint(robot: Description, driven: Mapping[str, tuple[str, float, float]]) -> str:
    """Return the name of a joint that moves no mass; "" if there is none.

    Parameters
    ----------
    driven
        Joints with the joint that drives each, ratio and offset.
    """
    M, scale, names = _mass_matrix(robot, driven)
    for k in reversed(range(len(names))):  # from the tips inwards, as articulated bodies do
        if not M[k, k] > _LEAST * scale[k]:
            return names[k]
        M[:k, :k] -= np.outer(M[:k, k], M[k, :k]) / M[k, k]
    return ""


def _mass_matrix(robot: Description, driven: Mapping[str, tuple[str, float, float]]) -> tuple[Array, Array, list[str]]:
    """Return M (n, n), the size (n,) of the terms of its diagonal, and the name of the joint of each coordinate."""
    places = _placed(robot, driven)
    names = [part.joint.name for part in robot.parts for _ in range(places[part.name].motions.shape[1])]
    firsts = _firsts(robot, places)
    J: dict[str | None, Array] = {None: np.zeros((6, len(names)))}
    M, scale = np.zeros((len(names), len(names))), np.zeros(len(names))
    for part in robot.parts:
        at = places[part.name]
        J[part.name] = J[part.parent].copy()
        columns = slice(firsts[part.name], firsts[part.name] + at.motions.shape[1])
        J[part.name][:, columns] = at.motions
        M[columns, columns] += part.joint.armature * np.eye(at.motions.shape[1])
        scale[columns] += part.joint.armature
        if part.mass is not None:
            terms = _terms(part.mass, at, J[part.name])
            M, scale = M + terms[0], scale + terms[1]
    return _together(M, scale, names, driven)


def _firsts(robot: Description, places: Mapping[str, Placed]) -> dict[str, int]:
    counts = np.cumsum([0, *(places[part.name].motions.shape[1] for part in robot.parts)])
    return {part.name: int(first) for part, first in zip(robot.parts, counts, strict=False)}


def _terms(mass: Mass, at: Placed, J: Array) -> tuple[Array, Array]:
    """Return what a part adds to M, and the size of its terms."""
    c = at.p + at.R @ mass.center
    arms = c[:, None] * np.ones(J.shape[1])
    v = J[3:] + np.cross(J[:3], arms, axis=0)
    inertia = at.R @ mass.inertia @ at.R.T
    size = mass.mass * (J[3:] ** 2 + (J[:3] ** 2).sum(axis=0) * (c**2).sum()) + np.abs(mass.inertia).sum() * J[:3] ** 2
    return mass.mass * v.T @ v + J[:3].T @ inertia @ J[:3], size.sum(axis=0)


def _together(
    M: Array, scale: Array, names: list[str], driven: Mapping[str, tuple[str, float, float]]
) -> tuple[Array, Array, list[str]]:
    """Return these with the rows of driven joints added to those of the joints that drive them."""
    own = [name for name in names if name not in driven]
    B = np.zeros((len(names), len(own)))
    free = iter(range(len(own)))
    for row, name in enumerate(names):
        if name in driven:
            source, ratio, _ = driven[name]
            B[row, own.index(source)] = ratio
        else:
            B[row, next(free)] = 1.0
    return B.T @ M @ B, (B**2).T @ scale, own


def _placed(robot: Description, driven: Mapping[str, tuple[str, float, float]]) -> dict[str, Placed]:
    """Return the parts at a position of no symmetry."""
    moved = {part.joint.name: (k + 1) * _STEP % 1.0 for k, part in enumerate(robot.parts)}
    moved |= {name: ratio * moved[source] + offset for name, (source, ratio, offset) in driven.items()}
    places: dict[str | None, Placed] = {None: Placed(np.eye(3), np.zeros(3), np.zeros((6, 0)))}
    for part in robot.parts:
        before = places[part.parent]
        R, p = before.R @ part.rotation, before.p + before.R @ part.at
        places[part.name] = _moved(part.joint, moved[part.joint.name], R, p)
    return {part.name: places[part.name] for part in robot.parts}


def _moved(joint: Joint, q: float, R: Array, p: Array) -> Placed:
    """Return the place of a part whose joint's frame is R, p; motions are rates of rotation, and of the origin."""
    axis = R @ np.array(joint.axis)
    if joint.kind == "revolute":
        return Placed(R @ turned(joint.axis, q), p, np.concatenate([axis, np.cross(p, axis)])[:, None])
    if joint.kind == "prismatic":
        return Placed(R, p + q * axis, np.concatenate([np.zeros(3), axis])[:, None])
    kinds = {"planar": (0, 1, 5), "spherical": (3, 4, 5), "free": range(6), "fixed": ()}
    along = [np.concatenate([np.zeros(3), R[:, k]]) for k in range(3)]
    about = [np.concatenate([R[:, k], np.cross(p, R[:, k])]) for k in range(3)]
    columns = [(*along, *about)[k] for k in kinds[joint.kind]]
    return Placed(R, p, np.array(columns).T if columns else np.zeros((6, 0)))


def turned(axis: tuple[float, ...], angle: float) -> Array:
    """Return the rotation (3, 3) by an angle about an axis of length 1."""
    return np.array(Rotation.from_rotvec(angle * np.array(axis)).as_matrix())


def locked(part: Part, displacement: float) -> Part:
    """Return a part whose joint is held at a displacement."""
    if part.joint.kind not in ("revolute", "prismatic"):
        at, rotation = part.at, part.rotation
    else:
        placed = _moved(part.joint, displacement, part.rotation, part.at)
        at, rotation = (placed.p, placed.R) if displacement else (part.at, part.rotation)
    return Part(part.name, part.parent, Joint(part.joint.name, "fixed"), at, rotation, part.mass)
