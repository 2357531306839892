"""Tables of MuJoCo's models: kinds, names, and what of them is not used."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from .description import listed

FREE, BALL, SLIDE, HINGE = range(4)
"""mjtJoint"""
CONNECT, WELD, JOINT = range(3)
"""mjtEq"""
BODY = 1
"""mjOBJ_BODY: constraints of sites have other kinds of objects"""


class Names:
    """Names of bodies, joints and constraints; those without one are numbered."""

    def __init__(self, m: Any) -> None:
        self.bodies = [m.body(k).name or f"body_{k}" for k in range(m.nbody)]
        self.joints = [m.joint(k).name or self._joint(m, k) for k in range(m.njnt)]
        self.equalities = [m.equality(k).name or f"equality_{k}" for k in range(m.neq)]

    def _joint(self, m: Any, k: int) -> str:
        body = int(m.jnt_bodyid[k])
        place = k - int(m.body_jntadr[body])
        return self.bodies[body] + (f"_joint_{place + 1}" if m.body_jntnum[body] > 1 else "_joint")

    def parent(self, m: Any, body: int) -> str | None:
        """Return the name of the body that carries another; None for the world."""
        parent = int(m.body_parentid[body])
        return self.bodies[parent] if parent else None


def notes(m: Any, names: Names) -> Iterator[str]:
    """Give what is in the file and not used."""
    equalities = list(enumerate(names.equalities))
    others = [name for k, name in equalities if m.eq_active0[k] and m.eq_type[k] not in (CONNECT, JOINT)]
    for found, words in (
        ([name for k, name in equalities if not m.eq_active0[k]], "constraints that are not active"),
        (others, "constraints of kinds other than connect and joint (weld, tendon, flex)"),
        ([n for k, n in enumerate(names.bodies) if m.body_gravcomp[k]], "compensation of gravity (gravcomp)"),
        ([n for k, n in enumerate(names.bodies) if m.body_mocapid[k] >= 0], "motions of mocap bodies: they are fixed"),
        *_of_joints(m, names),
    ):
        if found:
            yield f"not used: {words}: {listed(found)}"
    for count, words in (
        (m.nu, "actuators: torques act at joints"),
        (m.ntendon, "tendons, with their springs and limits"),
        (m.ngeom, "contacts of geoms"),
        (m.nkey, "keyframes"),
        (m.opt.density or m.opt.viscosity, "density and viscosity of a fluid"),
    ):
        if count:
            yield f"not used: {words}"


def _of_joints(m: Any, names: Names) -> Iterator[tuple[list[str], str]]:
    """Give joints with damping and the like that is not used, and what it is."""
    sizes = {FREE: 6, BALL: 3}
    dofs = {name: slice(int(m.jnt_dofadr[k]), int(m.jnt_dofadr[k]) + sizes[int(m.jnt_type[k])])
            for k, name in enumerate(names.joints) if int(m.jnt_type[k]) in sizes}  # fmt: skip
    for table, what in ((m.dof_damping, "damping"), (m.dof_armature, "armature"), (m.dof_frictionloss, "friction")):
        yield [name for name, rows in dofs.items() if np.any(table[rows])], f"{what} of joints of several coordinates"
    stiff = [name for k, name in enumerate(names.joints) if name in dofs and m.jnt_stiffness[k]]
    yield stiff, "springs of joints of several coordinates"
    springs, dampers = (getattr(m, field, None) for field in ("jnt_stiffnesspoly", "dof_dampingpoly"))
    curved = [name for k, name in enumerate(names.joints) if (springs is not None and np.any(springs[k]))
              or (dampers is not None and np.any(dampers[int(m.jnt_dofadr[k])]))]  # fmt: skip
    yield curved, "terms of higher degree of springs and dampers"  # newer versions of MuJoCo have these
