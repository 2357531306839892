"""Joints of SymPy as sequences of simple motions: along or about an axis of the joint's frame on the parent."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import (
    CylindricalJoint,
    PinJoint,
    PlanarJoint,
    PrismaticJoint,
    SphericalJoint,
    WeldJoint,
)

from ..model import ModelError, t
from ..model.normalise import name_of

_LETTERS = {"1": "x", "2": "y", "3": "z", "X": "x", "Y": "y", "Z": "z"}


@dataclass(frozen=True, slots=True)
class Motion:
    """kind : "revolute", "prismatic" or "fixed"; axis : a letter or (3,) numbers; q : its coordinate, if it has one"""

    kind: str
    axis: Any = "z"
    q: sympy.Expr | None = None


def motions_of(joint: Any) -> list[Motion]:
    """Return the motions of a joint, the first one next to the parent.

    Raises
    ------
    ModelError
        The joint is of another kind, or its coordinates or axis are not simple; names it.
    """
    make = _KINDS.get(type(joint))
    if make is None:
        raise ModelError(f"the joint {joint.name} is a {type(joint).__name__}")
    motions = make(joint)
    for motion in motions:
        if motion.q is not None and not (isinstance(motion.q, AppliedUndef) and motion.q.args == (t,)):
            raise ModelError(f"the joint {joint.name} has the coordinate {name_of(motion.q)}, no function of time")
    return motions


def _axis(joint: Any) -> tuple[sympy.Expr, ...]:
    axis = tuple(joint.joint_axis.to_matrix(joint.parent_interframe))
    if not all(entry.is_number for entry in axis):
        raise ModelError(f"the axis of the joint {joint.name} contains symbols")
    return axis


def _pin(joint: Any) -> list[Motion]:
    return [Motion("revolute", _axis(joint), joint.coordinates[0])]


def _prismatic(joint: Any) -> list[Motion]:
    return [Motion("prismatic", _axis(joint), joint.coordinates[0])]


def _cylindrical(joint: Any) -> list[Motion]:
    angle, distance = joint.coordinates
    return [Motion("prismatic", _axis(joint), distance), Motion("revolute", _axis(joint), angle)]


def _planar(joint: Any) -> list[Motion]:
    angle, y, z = joint.coordinates
    return [Motion("prismatic", "y", y), Motion("prismatic", "z", z), Motion("revolute", "x", angle)]


def _spherical(joint: Any) -> list[Motion]:
    """Return three rotations; those about axes fixed in space are in the opposite order about axes of the body."""
    amounts = joint.coordinates if joint._amounts is None else joint._amounts
    turns = [
        Motion("revolute", _LETTERS[letter], q)
        for letter, q in zip(str(joint._rot_order).upper(), amounts, strict=True)
    ]
    return turns[::-1] if joint._rot_type.upper() == "SPACE" else turns


def _weld(_: Any) -> list[Motion]:
    return [Motion("fixed")]


_KINDS: Mapping[type, Callable[[Any], list[Motion]]] = {
    PinJoint: _pin,
    PrismaticJoint: _prismatic,
    CylindricalJoint: _cylindrical,
    PlanarJoint: _planar,
    SphericalJoint: _spherical,
    WeldJoint: _weld,
}
