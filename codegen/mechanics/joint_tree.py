"""Systems of SymPy whose joints form a tree, as an `eigenmotion.Tree`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import Particle, Point, ReferenceFrame, RigidBody, System, Vector

from ..model import ModelError, Tree, t
from ..model.normalise import name_of
from ..model.tree.tree import Body
from .joint_motions import Motion, motions_of

Entries = Sequence[sympy.Expr]


@dataclass(frozen=True, slots=True)
class Place:
    """The frame and origin of a body of SymPy, which are those of a body of the tree; body None is the ground.

    parent : that of the body that carries it
    """

    body: Body | None
    frame: ReferenceFrame
    origin: Point
    parent: Place | None


@dataclass(slots=True)
class JointTree:
    """A tree of bodies, and where SymPy's frames are in it.

    places : those of SymPy's bodies
    axes : frame -> (body of the tree, R (3, 3) whose columns are the frame's axes in those of the body)
    """

    tree: Tree
    places: dict[Any, Place] = field(default_factory=dict)
    axes: dict[ReferenceFrame, tuple[Body | None, sympy.ImmutableDenseMatrix]] = field(default_factory=dict)

    def in_ground(self, vector: Vector) -> sympy.ImmutableDenseMatrix:
        """Return a vector (3, 1) in the axes of the ground, by functions of bodies.

        Raises
        ------
        ModelError
            It is in a frame that is fixed in no body; names the frame.
        """
        whole = sympy.ImmutableDenseMatrix([0, 0, 0])
        for entries, frame in vector.args:
            body, R = self.fixed_in(frame)
            column = R * entries
            whole += body.rotation * column if body else column
        return whole

    def dot(self, a: Vector, b: Vector) -> sympy.Expr:
        """Return a . b; without functions of bodies where both are in one frame."""
        frames = {frame for _, frame in (*a.args, *b.args)}
        if not a.args or not b.args:
            return sympy.S.Zero
        if len(frames) == 1:
            return a.args[0][0].dot(b.args[0][0])
        return self.in_ground(a).dot(self.in_ground(b))

    def fixed_in(self, frame: ReferenceFrame) -> tuple[Body | None, sympy.ImmutableDenseMatrix]:
        """Return the body in which a frame of SymPy is fixed, and its axes in those of the body.

        Raises
        ------
        ModelError
            There is none; names the frame.
        """
        if frame not in self.axes:
            self.axes[frame] = self._found(frame)
        return self.axes[frame]

    def _found(self, frame: ReferenceFrame) -> tuple[Body | None, sympy.ImmutableDenseMatrix]:
        for place in self.places.values():
            try:
                R = place.frame.dcm(frame)
            except ValueError:
                continue
            if is_constant(R):
                return place.body, R
        raise ModelError(f"the frame {frame.name} is fixed in no body")


def is_constant(entries: Any) -> bool:
    """Whether expressions consist of numbers and parameters."""
    return not any(one.atoms(AppliedUndef, sympy.Derivative) or t in one.free_symbols for one in entries)


def joint_tree(system: System, gravity: Entries) -> JointTree:
    """Return the tree that the joints of a system form.

    Parameters
    ----------
    gravity
        (3,) that of the tree, in the system's frame [m / s^2].

    Raises
    ------
    ModelError
        They form none, or SymPy does not know where they are; says why.
    """
    made = JointTree(Tree(gravity=gravity))
    ground = [body for body in system.bodies if getattr(body, "frame", None) == system.frame]
    for body in ground:
        made.places[body] = Place(None, system.frame, system.fixed_point, None)
    made.axes[system.frame] = (None, sympy.ImmutableDenseMatrix.eye(3))
    try:
        _add_all(made, system)
    except ValueError as error:
        raise ModelError(str(error)) from error
    loose = [body.name for body in system.bodies if body not in made.places]
    if loose:
        raise ModelError(f"no joint moves the body {loose[0]}")
    missing = [name_of(q) for q in system.q if q not in made.tree.coordinates]
    if missing:
        raise ModelError(f"no joint has the coordinate {missing[0]}")
    return made


def _add_all(made: JointTree, system: System) -> None:
    pending = list(system.joints)
    while pending:
        ready = [joint for joint in pending if joint.parent in made.places]
        if not ready:
            raise ModelError(f"the parent of the joint {pending[0].name} is on no joint from the ground")
        for joint in ready:
            if joint.child in made.places:
                raise ModelError(f"the child of the joint {joint.name} is the ground, or on another joint")
            _add(made, joint)
            pending.remove(joint)


def _add(made: JointTree, joint: Any) -> None:
    """Add a joint and its child: massless bodies but for the last one, which has the frame and origin of SymPy's."""
    place, child = made.places[joint.parent], joint.child
    at = joint.parent_point.pos_from(place.origin).to_matrix(place.frame)
    R = place.frame.dcm(joint.parent_interframe)
    frame = child.frame if isinstance(child, RigidBody) else joint.child_interframe
    offset = child.masscenter.pos_from(joint.child_point).to_matrix(joint.child_interframe)
    turned = joint.child_interframe.dcm(frame)
    if not is_constant([*at, *R, *offset, *turned]):
        raise ModelError(f"the points and frames of the joint {joint.name} are not fixed in its bodies")
    motions, body = motions_of(joint), place.body
    is_apart = any(offset) or turned != sympy.eye(3)
    placed: dict[str, Any] = {"at": list(at), "rotation": R}
    for number, motion in enumerate(motions, 1):
        is_last = number == len(motions) and not is_apart
        name = child.name if is_last else f"{joint.name} joint {number}"
        inertia = _inertia(child) if is_last else {}
        body = made.tree.body(name, body, **_joint(motion), **placed, **inertia)
        placed = {}
    made.axes[joint.parent_interframe] = (place.body, R)
    made.axes[joint.child_interframe] = (body, sympy.ImmutableDenseMatrix.eye(3))
    if is_apart:
        body = made.tree.body(child.name, body, joint="fixed", at=list(offset), rotation=turned, **_inertia(child))
    made.axes[frame] = (body, sympy.ImmutableDenseMatrix.eye(3))
    made.places[child] = Place(body, frame, child.masscenter, place)


def _joint(motion: Motion) -> Mapping[str, Any]:
    if motion.kind == "fixed":
        return {"joint": "fixed"}
    return {"joint": motion.kind, "axis": motion.axis, "coordinates": [motion.q]}


def _inertia(body: Particle | RigidBody) -> Mapping[str, Any]:
    """Return mass and inertia about the mass centre, which is the origin of the body's frame."""
    if not is_constant([sympy.sympify(body.mass)]):
        raise ModelError(f"the mass of the body {body.name} varies")
    if not isinstance(body, RigidBody):
        return {"mass": body.mass}
    J = body.central_inertia.to_matrix(body.frame)
    if not is_constant(J):
        raise ModelError(f"the inertia of the body {body.name} is not fixed in it")
    return {"mass": body.mass, "inertia": J}
