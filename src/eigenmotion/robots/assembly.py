"""From the description of a file to a `Robot`: a tree of bodies, energies and forces of joints, inputs, constraints."""

from __future__ import annotations

import logging
import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import sympy
from sympy.physics.mechanics import dynamicsymbols

from ..codegen.model import ModelError, Tree
from ..codegen.model.normalise import nearest, shown
from .description import FREEDOMS, Closure, Description, Part, listed
from .drawing.skeleton import drawing_of
from .driven import Drives, reduced
from .masses import Masses
from .names import identifier, identifiers
from .robot import Robot

_log = logging.getLogger("eigenmotion")
_SUFFIXES = {
    "planar": ("x", "y", "angle"), "spherical": ("s1", "s2", "s3"), "free": ("x", "y", "z", "s1", "s2", "s3"),
}  # fmt: skip
"""Of the names of coordinates; s: modified Rodrigues parameters"""


@dataclass(slots=True)
class _Terms:
    """What joints add to a model besides bodies."""

    kinetic_energy: sympy.Expr = sympy.S.Zero
    potential_energy: sympy.Expr = sympy.S.Zero
    forces: dict[sympy.Expr, sympy.Expr] = field(default_factory=dict)
    initial: dict[sympy.Expr, float] = field(default_factory=dict)


def robot_of(
    described: Description, *, locked: Collection[str], close: Mapping[str, Any], gravity: Any, name: str | None,
    symbolic: bool = False,
) -> Robot:  # fmt: skip
    """Return a robot; with `symbolic`, the inertia of its moving parts are parameters.

    Raises
    ------
    ModelError
        A joint or link is unknown, or none moves; says which.
    """
    given, drives = reduced(described, locked)
    closures = (*given.closures, *_closures(given, close))
    flaws = [f"link {part.name!r}: {flaw}" for part in given.parts if part.mass and (flaw := part.mass.flaw())]
    for flaw in flaws:
        _log.warning("%s: %s; computed as written", given.name, flaw)
    if not any(FREEDOMS[part.joint.kind] for part in given.parts):
        raise ModelError(f"{given.name}: none of its joints moves. base='floating' lets a body without joints move.")
    tree = Tree(gravity)
    masses = Masses(given.parts, symbolic)
    positions, labels = _planted(tree, given, drives, masses)
    torques = _torques(given, drives, labels)
    terms = _terms(given, tree, positions, torques, drives)
    fields = {
        "coordinates": tree.coordinates,
        "kinetic_energy": tree.kinetic_energy + terms.kinetic_energy,
        "potential_energy": tree.potential_energy + terms.potential_energy,
        "forces": terms.forces,
        "inputs": dict.fromkeys(torques.values(), 0.0),
        "parameters": masses.parameters,
        "initial": terms.initial,
        "holonomic_constraints": _constraints(given, tree, closures, positions),
    }
    return Robot(
        identifier(name or given.name), tree, dict(tree.bodies), {p.joint.name: p.joint for p in given.parts},
        positions, torques, drawing_of(given.parts, tree), (*given.notes, *flaws, *_left_out(given)), labels, fields,
    )  # fmt: skip


def _planted(
    tree: Tree, robot: Description, drives: Drives, masses: Masses
) -> tuple[dict[str, sympy.Expr], dict[str, str]]:
    """Add the bodies to a tree; return the positions of joints of one coordinate, and names of joints for C."""
    moving = [part.joint for part in robot.parts if FREEDOMS[part.joint.kind]]
    wanted = {(j.name, s): f"{j.name}_{s}" if s else j.name for j in moving if j.name not in drives
              for s in _SUFFIXES.get(j.kind, ("",))}  # fmt: skip
    known = identifiers(wanted.values())
    q = {key: dynamicsymbols(known[name]) for key, name in wanted.items()}
    zeros = {joint.name: joint.zero for joint in moving}
    positions: dict[str, sympy.Expr] = {}
    for part in robot.parts:
        joint = part.joint
        if FREEDOMS[joint.kind] == 1:
            source, ratio, offset = drives.get(joint.name, (joint.name, 1.0, 0.0))
            displacement = _number(ratio) * q[source, ""] + _number(offset - ratio * zeros[source])
            positions[joint.name] = displacement + _number(joint.zero)
            own: Sequence[sympy.Expr] = (displacement,)
        else:
            own = [q[joint.name, s] for s in _SUFFIXES.get(joint.kind, ())]
        _body(tree, part, own, masses)
    return positions, identifiers(joint.name for joint in moving)


def _body(tree: Tree, part: Part, coordinates: Sequence[sympy.Expr], masses: Masses) -> None:
    turned = None if np.array_equal(part.rotation, np.eye(3)) else part.rotation.tolist()
    tree.body(
        part.name, part.parent, joint=part.joint.kind, axis=part.joint.axis, at=part.at.tolist(), rotation=turned,
        coordinates=coordinates, **masses.of(part),
    )  # fmt: skip


def _number(value: float) -> sympy.Number:
    return sympy.Integer(int(value)) if value == int(value) else sympy.Float(value)


def _torques(robot: Description, drives: Drives, labels: Mapping[str, str]) -> dict[str, sympy.Expr]:
    """Return an input for each joint of one coordinate that no other joint drives."""
    actuated = [j.name for j in (p.joint for p in robot.parts) if FREEDOMS[j.kind] == 1 and j.name not in drives]
    names = identifiers((f"tau_{labels[name]}" for name in actuated), taken=labels.values())
    return {name: dynamicsymbols(names[f"tau_{labels[name]}"]) for name in actuated}


def _terms(
    robot: Description, tree: Tree, positions: Mapping[str, sympy.Expr], torques: Mapping[str, sympy.Expr],
    drives: Drives,
) -> _Terms:  # fmt: skip
    """Return torques, dampers, springs and rotors of joints; a driven joint acts on the coordinate that drives it."""
    terms = _Terms(forces={})
    for part in robot.parts:
        joint, q = part.joint, tree.bodies[part.name].coordinates
        if FREEDOMS[joint.kind] > 1:
            terms.initial |= {one: value for one, value in zip(q, joint.start, strict=False) if value}
        if FREEDOMS[joint.kind] != 1:
            continue
        ratio, rate = _number(drives.get(joint.name, ("", 1.0))[1]), q[0].diff()
        force = ratio * torques.get(joint.name, sympy.S.Zero) - _number(joint.damping) * ratio**2 * rate
        terms.forces[q[0]] = terms.forces.get(q[0], sympy.S.Zero) + force
        terms.kinetic_energy += _number(joint.armature) * ratio**2 * rate**2 / 2
        terms.potential_energy += _number(joint.stiffness) * (positions[joint.name] - _number(joint.rest)) ** 2 / 2
        if joint.start and joint.start[0] and joint.name not in drives:
            terms.initial[q[0]] = joint.start[0]
    return terms


def _closures(robot: Description, close: Mapping[str, Any]) -> Iterator[Closure]:
    links = [part.name for part in robot.parts]
    for name, given in close.items():
        what = f"close[{shown(name)}]"
        if not isinstance(given, Sequence) or len(given) != 4:
            raise ModelError(f"{what} is {shown(given)}. Give (link_a, point_a, link_b, point_b).")
        for link in (given[0], given[2]):
            if link is not None and link not in links:
                raise ModelError(f"{what} names {shown(link)}, which is no link.{nearest(str(link), links)}")
        yield Closure(name, *given)


def _constraints(
    robot: Description, tree: Tree, closures: Sequence[Closure], positions: Mapping[str, sympy.Expr]
) -> dict[str, Any]:
    rows = {one.name: list(_place(tree, one.first, one.first_point) - _place(tree, one.second, one.second_point))
            for one in closures}  # fmt: skip
    zeros = {part.joint.name: part.joint.zero for part in robot.parts}
    for name, (driven, driving, coefficients) in robot.polynomials.items():
        at = positions[driving] - _number(zeros[driving])
        polynomial = sum(_number(a) * at**k for k, a in enumerate(coefficients))
        rows[name] = positions[driven] - _number(zeros[driven]) - polynomial
    names = identifiers(rows)
    return {names[name]: row for name, row in rows.items()}


def _place(tree: Tree, link: str | None, point: Sequence[float]) -> sympy.ImmutableDenseMatrix:
    return sympy.ImmutableDenseMatrix(point) if link is None else tree.bodies[link].position(point)


def _left_out(robot: Description) -> Iterator[str]:
    """Give notes on friction and limits, which are there for whoever asks."""
    joints = [part.joint for part in robot.parts if FREEDOMS[part.joint.kind] == 1]
    for names, words in (
        ([j.name for j in joints if j.friction], "friction is not used; Robot.frictions gives it to contacts"),
        ([j.name for j in joints if math.isfinite(j.lower) or math.isfinite(j.upper)],
         "limits of positions are not used; Robot.stops gives them to contacts"),
        ([j.name for j in joints if math.isfinite(j.effort) or math.isfinite(j.velocity)],
         "limits of efforts and velocities are not used"),
    ):  # fmt: skip
        if names:
            yield f"{words}: {listed(names)}"
