"""URDF files, read by yourdfpy."""

from __future__ import annotations

import logging
import math
from collections import Counter
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from ..codegen.model.normalise import ModelError, nearest, shown
from .description import Array, Description, Driven, Joint, Mass, Part, listed
from .drawing.visuals import Visuals, place
from .urdf_words import check_words

_KINDS = {"fixed": "fixed", "revolute": "revolute", "continuous": "revolute", "prismatic": "prismatic",
          "planar": "planar", "floating": "free"}  # fmt: skip


def read(file: Path, base: str, meshes: bool = False) -> Description:
    """Return what a URDF file describes; with `meshes`, those that its links show are read, too.

    Raises
    ------
    ModelError
        yourdfpy is missing, or the file has a mistake; names the link or joint.
    """
    robot = _parsed(file)
    links = {link.name: link for link in robot.links}
    _check(file, robot, links)
    root = _root(file, robot, links)
    first = Joint("base", "free" if base == "floating" else "fixed")
    seen = Visuals(file, meshes)
    parts = [Part(root, None, first, np.zeros(3), np.eye(3), _mass(file, links[root]), seen.solids(links[root]))]
    for joint in _outwards(root, robot.joints):
        at, rotation = place(joint.origin)
        part = _part(file, joint, at, rotation, links[joint.child])
        parts.append(replace(part, solids=seen.solids(links[joint.child])))
    if len(parts) < len(links):
        missing = sorted(set(links) - {part.name for part in parts})
        raise ModelError(f"{file}: no joint leads from {root!r} to {listed(missing)}.")
    return Description(robot.name or file.stem, tuple(parts), (0.0, 0.0, -9.81), notes=(*_notes(robot), *seen.notes()))


def _parsed(file: Path) -> Any:
    """Return yourdfpy's record of a robot."""
    if find_spec("yourdfpy") is None:
        raise ModelError(f"{file}: reading URDF needs yourdfpy: pip install 'eigenmotion[robots]'")
    check_words(file)
    from yourdfpy import URDF  # noqa: PLC0415, loads trimesh

    try:
        with _quiet("yourdfpy"):
            return URDF.load(str(file), build_scene_graph=False, load_meshes=False).robot
    except Exception as error:  # of any kind: it reads attributes without looking whether they are there
        raise ModelError(f"{file}: yourdfpy cannot read it: {type(error).__name__}: {error}") from error


@contextmanager
def _quiet(name: str) -> Iterator[None]:
    log = logging.getLogger(name)
    before, log.disabled = log.disabled, True
    try:
        yield
    finally:
        log.disabled = before


def _check(file: Path, robot: Any, links: dict[str, Any]) -> None:
    for what, names in (("links", [one.name for one in robot.links]), ("joints", [one.name for one in robot.joints])):
        if twice := [name for name, count in Counter(names).items() if count > 1]:
            raise ModelError(f"{file}: two {what} are named {twice[0]!r}. Rename one.")
    parents: dict[str, str] = {}
    for joint in robot.joints:
        for link in (joint.parent, joint.child):
            if link not in links:
                raise ModelError(f"{file}: joint {joint.name!r} names a link {link!r}.{nearest(str(link), links)}")
        if joint.type not in _KINDS:
            raise ModelError(f"{file}: joint {joint.name!r} is {shown(joint.type)}. Give one of {', '.join(_KINDS)}.")
        if joint.child in parents:
            other = parents[joint.child]
            raise ModelError(
                f"{file}: link {joint.child!r} is the child of two joints, {other!r} and {joint.name!r}. A loop is "
                "closed by `close`."
            )
        parents[joint.child] = joint.name


def _root(file: Path, robot: Any, links: dict[str, Any]) -> str:
    roots = [name for name in links if name not in {joint.child for joint in robot.joints}]
    if len(roots) != 1:
        words = f"links {listed(roots)} have no parent" if roots else "each link has a parent"
        raise ModelError(f"{file}: {words}. A robot has one link without a parent.")
    return roots[0]


def _outwards(root: str, joints: Iterable[Any]) -> Iterator[Any]:
    """Give the joints depth first: each branch in one piece, branches in the order of the file."""
    children: dict[str, list[Any]] = {}
    for joint in joints:
        children.setdefault(joint.parent, []).append(joint)
    waiting = [*reversed(children.get(root, []))]
    while waiting:
        joint = waiting.pop()
        yield joint
        waiting += reversed(children.get(joint.child, []))


def _part(file: Path, joint: Any, at: Array, rotation: Array, link: Any) -> Part:
    kind = _KINDS[joint.type]
    axis: tuple[float, ...] = (0.0, 0.0, 1.0)
    if kind in ("revolute", "prismatic", "planar"):
        length = float(np.linalg.norm(joint.axis))
        if not length > 0.0:
            raise ModelError(f"{file}: joint {joint.name!r}: its axis is {joint.axis.tolist()}. Give a direction.")
        axis = tuple(float(entry) / length for entry in joint.axis)
    if kind == "planar":  # the plane across the axis; its own x and y are those of the joint where the axis is z
        rotation, axis = rotation @ _with_z(np.array(axis)), (0.0, 0.0, 1.0)
    return Part(link.name, joint.parent, _joint(joint, kind, axis), at, rotation, _mass(file, link))


def _with_z(axis: Array) -> Array:
    """Return a rotation (3, 3) that turns z to an axis by the shortest way."""
    if axis[2] < 0.0 and not np.any(axis[:2]):
        return np.diag([1.0, -1.0, -1.0])
    x, y, z = axis
    return np.array([[1 - x * x / (1 + z), -x * y / (1 + z), x], [-x * y / (1 + z), 1 - y * y / (1 + z), y],
                     [-x, -y, z]])  # fmt: skip


def _joint(joint: Any, kind: str, axis: tuple[float, ...]) -> Joint:
    limit, mimic, dynamics = joint.limit, joint.mimic, joint.dynamics
    bounded = limit is not None and joint.type in ("revolute", "prismatic")
    driven = mimic and Driven(mimic.joint, _number(mimic.multiplier, 1.0), _number(mimic.offset, 0.0))
    return Joint(
        joint.name, kind, axis, driven=driven,
        damping=_number(dynamics and dynamics.damping, 0.0), friction=_number(dynamics and dynamics.friction, 0.0),
        lower=_number(bounded and limit.lower, -math.inf), upper=_number(bounded and limit.upper, math.inf),
        effort=_number(limit and limit.effort, math.inf), velocity=_number(limit and limit.velocity, math.inf),
    )  # fmt: skip


def _number(given: Any, missing: float) -> float:
    return missing if given is None or given is False else float(given)


def _mass(file: Path, link: Any) -> Mass | None:
    """Return mass and inertia of a link, about its mass centre in its own axes."""
    inertial = link.inertial
    if inertial is None:
        return None
    center, turned = place(inertial.origin)
    inertia = np.zeros((3, 3)) if inertial.inertia is None else np.array(inertial.inertia, dtype=float)
    numbers = [_number(inertial.mass, 0.0), *center, *inertia.flat, *turned.flat]
    if not np.all(np.isfinite(numbers)):
        raise ModelError(f"{file}: link {link.name!r}: its inertial has a number that is not finite.")
    return Mass(numbers[0], center, turned @ inertia @ turned.T)


def _notes(robot: Any) -> Iterator[str]:
    """Give what is in the file and not used."""
    for count, what in (
        (sum(len(link.collisions) for link in robot.links), "collision shapes are not used: no contacts"),
        (len(robot.transmission), "transmissions are not used: torques act at joints"),
        (len(robot.gazebo), "gazebo elements are not used"),
        (sum(joint.safety_controller is not None for joint in robot.joints), "safety controllers are not used"),
        (sum(joint.calibration is not None for joint in robot.joints), "calibrations are not used"),
    ):
        if count:
            yield f"{count} {what}"
