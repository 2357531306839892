"""MJCF files, compiled by MuJoCo: the tables of bodies, joints and equality constraints of its model."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from ..codegen.model.normalise import ModelError
from .description import Array, Closure, Description, Driven, Joint, Mass, Part
from .drawing.geoms import solids
from .mjcf_tables import BALL, BODY, CONNECT, FREE, HINGE, JOINT, SLIDE, Names, notes

_OF_BODIES = {"mass": "body_mass", "inertia": "body_inertia", "place": "body_pos", "rotation": "body_quat",
              "mass centre": "body_ipos"}  # fmt: skip
_OF_JOINTS = {"axis": "jnt_axis", "place": "jnt_pos", "stiffness": "jnt_stiffness", "range": "jnt_range"}
_KINDS = {FREE: "free", BALL: "spherical", SLIDE: "prismatic", HINGE: "revolute"}


def read(file: Path) -> Description:
    """Return what an MJCF file describes.

    Raises
    ------
    ModelError
        MuJoCo is missing, refuses the file, or has no body that moves.
    """
    m = _compiled(file)
    try:
        names = Names(m)
    except UnicodeDecodeError as error:
        raise ModelError(f"{file}: a name is not in UTF-8 ({error}). Save the file as UTF-8.") from error
    _check_finite(file, m, names)
    parts = tuple(part for body in range(1, m.nbody) for part in _parts(m, names, body))
    drives, polynomials = _driven(m, names)
    parts = tuple(replace(part, joint=replace(part.joint, driven=drives.get(part.joint.name))) for part in parts)
    if not parts:
        raise ModelError(f"{file}: it has no body.")
    text = bytes(m.names).split(b"\0", 1)[0].decode()
    return Description(
        file.stem if text in ("", "MuJoCo Model") else text, parts, tuple(map(float, m.opt.gravity)),
        tuple(_closures(m, names)), polynomials, tuple(notes(m, names)),
    )  # fmt: skip


def _compiled(file: Path) -> Any:
    if find_spec("mujoco") is None:
        raise ModelError(f"{file}: reading MJCF needs mujoco: pip install 'eigenmotion[robots]'")
    import mujoco  # noqa: PLC0415, loads its library

    try:
        return mujoco.MjModel.from_xml_path(str(file))
    except Exception as error:
        raise ModelError(f"{file}: MuJoCo cannot read it: {' '.join(str(error).split())}") from error


def _check_finite(file: Path, m: Any, names: Names) -> None:
    """Raise ModelError for a number of a body or joint that is not finite; MuJoCo takes it, with a warning."""
    for what, owners, tables in (("body", names.bodies, _OF_BODIES), ("joint", names.joints, _OF_JOINTS)):
        for word, table in tables.items():
            for name, numbers in zip(owners, getattr(m, table), strict=True):
                if not np.isfinite(numbers).all():
                    raise ModelError(f"{file}: {what} {name!r}: its {word} is not finite: {numbers.tolist()}.")


def _rotation(quaternion: Array) -> Array:
    """Return the rotation (3, 3) of a quaternion (4,), the scalar first."""
    return np.array(Rotation.from_quat(quaternion, scalar_first=True).as_matrix())


def _parts(m: Any, names: Names, body: int) -> Iterator[Part]:
    """Give a part for each joint of a body, and the body itself where its frame is not that of the last joint."""
    name, parent = names.bodies[body], names.parent(m, body)
    place, rotation = m.body_pos[body].copy(), _rotation(m.body_quat[body])
    first, count = int(m.body_jntadr[body]), int(m.body_jntnum[body])
    joints = range(first, first + count)
    last = m.jnt_pos[first + count - 1] if count and m.jnt_type[first] != FREE else np.zeros(3)
    own = Mass(float(m.body_mass[body]), m.body_ipos[body].copy(), _inertia(m, body))
    seen = tuple(solids(m, body))
    apart = not count or bool(np.any(last))
    before = np.zeros(3)
    for k in joints:
        free = m.jnt_type[k] == FREE
        at, R = (np.zeros(3), np.eye(3)) if free else (place + rotation @ (m.jnt_pos[k] - before), rotation)
        ends = k == joints[-1] and not apart
        yield Part(
            name if ends else f"{name} {names.joints[k]}", parent, _joint(m, names, k), at, R, own if ends else None,
            seen if ends else (),
        )  # fmt: skip
        parent, place, rotation = (name if ends else f"{name} {names.joints[k]}"), np.zeros(3), np.eye(3)
        before = m.jnt_pos[k] if not free else before
    if apart:
        yield Part(
            name, parent, Joint(f"{name} fixed", "fixed"), place - before if count else place, rotation, own, seen
        )


def _inertia(m: Any, body: int) -> Array:
    R = _rotation(m.body_iquat[body])
    return R @ np.diag(m.body_inertia[body]) @ R.T


def _joint(m: Any, names: Names, k: int) -> Joint:
    kind, dof, at = int(m.jnt_type[k]), int(m.jnt_dofadr[k]), int(m.jnt_qposadr[k])
    if kind == FREE:
        return Joint(names.joints[k], "free", start=_free_start(m.qpos0[at : at + 7]))
    if kind == BALL:
        return Joint(names.joints[k], "spherical")
    zero, limited = float(m.qpos0[at]), bool(m.jnt_limited[k])
    lower, upper = map(float, m.jnt_range[k]) if limited else (-np.inf, np.inf)
    return Joint(
        names.joints[k], _KINDS[kind], tuple(map(float, m.jnt_axis[k])), zero, damping=float(m.dof_damping[dof]),
        armature=float(m.dof_armature[dof]), stiffness=float(m.jnt_stiffness[k]), rest=float(m.qpos_spring[at]),
        friction=float(m.dof_frictionloss[dof]), lower=lower, upper=upper, start=(zero,),
    )  # fmt: skip


def _free_start(q: Array) -> tuple[float, ...]:
    """Return the place, and the modified Rodrigues parameters of a quaternion: of both signs the shorter rotation."""
    w, *axis = q[3:] if q[3] >= 0 else -q[3:]
    return (*map(float, q[:3]), *(float(entry / (1 + w)) for entry in axis))


def _active(m: Any, kind: int) -> list[int]:
    return [k for k in range(m.neq) if m.eq_type[k] == kind and m.eq_active0[k]]


def _driven(m: Any, names: Names) -> tuple[dict[str, Driven], dict[str, tuple[str, str, tuple[float, ...]]]]:
    """Return the joints that linear constraints eliminate, and polynomials between others."""
    drives: dict[str, Driven] = {}
    polynomials = {}
    for k in _active(m, JOINT):
        first, second = int(m.eq_obj1id[k]), int(m.eq_obj2id[k])
        coefficients = tuple(map(float, m.eq_data[k][:5]))
        if second < 0:
            polynomials[names.equalities[k]] = names.joints[first], names.joints[first], coefficients[:1]
        elif any(coefficients[2:]) or not coefficients[1] or names.joints[first] in drives:
            polynomials[names.equalities[k]] = names.joints[first], names.joints[second], coefficients
        else:
            drives[names.joints[first]] = Driven(names.joints[second], coefficients[1], coefficients[0])
    return drives, polynomials


def _closures(m: Any, names: Names) -> Iterator[Closure]:
    for k in _active(m, CONNECT):
        objects = int(m.eq_obj1id[k]), int(m.eq_obj2id[k])
        if m.eq_objtype[k] == BODY:
            bodies, points = [*objects], [m.eq_data[k][:3], m.eq_data[k][3:6]]
        else:
            bodies, points = [int(m.site_bodyid[one]) for one in objects], [m.site_pos[one] for one in objects]
        a, b = (names.bodies[body] if body else None for body in bodies)
        yield Closure(names.equalities[k], a, points[0].tolist(), b, points[1].tolist())
