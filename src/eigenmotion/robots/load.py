"""Reading of robots: `read_urdf`, `read_mjcf`, and in one call their models, `load_urdf`, `load_mjcf`."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

from ..codegen.model import Model, ModelError
from ..codegen.model.normalise import name_of, shown
from . import mjcf, urdf
from .assembly import robot_of
from .robot import Robot

Closed = Mapping[str, tuple[str | None, Sequence[float], str | None, Sequence[float]]]


def read_urdf(
    path: str | os.PathLike[str],
    *,
    base: str = "fixed",
    locked: Collection[str] = (),
    close: Closed | None = None,
    gravity: Sequence[Any] = (0, 0, -9.81),
    name: str | None = None,
    meshes: bool = False,
    inertial_parameters: bool = False,
) -> Robot:
    """Read a URDF file and return a `Robot`: its bodies by name, and models of it.

    Parameters
    ----------
    path
        The file.
    base
        "fixed": the first link is the ground. "floating": it moves freely, with the coordinates base_x, base_y, base_z
        [m] and base_s1, base_s2, base_s3, modified Rodrigues parameters: tan(angle / 4) times the axis of its rotation.
    locked
        Joints, by name, that are held at 0.
    close
        Closed loops: a mapping name -> (link_a, point_a, link_b, point_b). The point (3,) [m] of the one link, in its
        frame, stays at the point of the other, by the position constraints of that name; None is the ground.
    gravity
        (3,) acceleration of gravity in the axes of the ground [m / s^2]; numbers, or expressions in parameters.
    name
        Name of the model; None for that of the robot.
    meshes
        Whether drawings show the convex hulls of meshes, which are read by trimesh; reading them may take longer than
        all else. Boxes, cylinders and balls are shown in any case, and lines between joints of links without solids.
    inertial_parameters
        Whether the inertia of links that move are parameters: m_LINK [kg], mx_LINK, my_LINK, mz_LINK, mass times centre
        [kg m], and Ixx_LINK, Ixy_LINK, Ixz_LINK, Iyy_LINK, Iyz_LINK, Izz_LINK about the origin of the link's frame
        [kg m^2], by default those of the file. Forces are linear in them (`System.regressor`).

    Raises
    ------
    ModelError
        yourdfpy is not installed (the extra `robots`), or the file or an argument has a mistake; says where.

    Examples
    --------
    A point mass on a rod, and its height as an output:

    >>> from pathlib import Path
    >>> import eigenmotion as em
    >>> bob = '<inertial><origin xyz="0 0 -1"/><mass value="2"/></inertial>'
    >>> links = f'<link name="base"/><link name="rod">{bob}</link>'
    >>> pin = '<joint name="pin" type="continuous"><parent link="base"/><child link="rod"/><axis xyz="0 1 0"/></joint>'
    >>> _ = Path("pendulum.urdf").write_text(f'<robot name="pendulum">{links}{pin}</robot>')
    >>> robot = em.read_urdf("pendulum.urdf")
    >>> height = robot.bodies["rod"].position((0, 0, -1))[2]
    >>> system = em.build(robot.model(outputs={"height": height}))
    >>> print(system.simulate((0, 1), x0={"pin": 0.5}).outputs["height"][0].round(4))
    -0.8776
    """
    if base not in ("fixed", "floating"):
        raise ModelError(f"base is {shown(base)}. Give 'fixed' or 'floating'.")
    with _naming(file := _file(path)):
        described = urdf.read(file, base, meshes)
        made = robot_of(
            described, locked=locked, close=close or {}, gravity=gravity, name=name, symbolic=inertial_parameters
        )
        return replace(made, fields={**made.fields, "units": _si(made)})


def _si(robot: Robot) -> dict[str, str]:
    """Return the units of coordinates and torques: those of the format URDF are metres, kilograms and seconds."""
    coordinates = {name_of(q): unit for q, unit in robot.tree.units("m").items()}
    torques = {
        name_of(torque): "N" if robot.joints[joint].kind == "prismatic" else "N m"
        for joint, torque in robot.torques.items()
    }
    return {**coordinates, **torques, "length": "m", "energy": "J"}


def read_mjcf(
    path: str | os.PathLike[str],
    *,
    locked: Collection[str] = (),
    close: Closed | None = None,
    gravity: Sequence[Any] | None = None,
    name: str | None = None,
) -> Robot:
    """Read an MJCF file by MuJoCo's compiler and return a `Robot`.

    Bodies, joints (with damping, armature, springs) and equality constraints are used; a constraint of two joints that
    is linear eliminates one of them. Bodies that nothing carries move as their joints say. Contacts, tendons and
    actuators are not used; `Robot.notes` says so.

    Parameters
    ----------
    path
        The file, and those that it includes.
    locked, close, name
        As for `read_urdf`; joints are held where the file has them at the start.
    gravity
        As for `read_urdf`; None for that of the file.

    Raises
    ------
    ModelError
        MuJoCo is not installed (the extra `robots`), or refuses the file; says why.

    Examples
    --------
    >>> from pathlib import Path
    >>> import eigenmotion as em
    >>> rod = '<body name="rod"><joint name="pin" axis="0 1 0"/><geom pos="0 0 -1" size="0.1"/></body>'
    >>> _ = Path("pendulum.xml").write_text(f"<mujoco><worldbody>{rod}</worldbody></mujoco>")
    >>> em.read_mjcf("pendulum.xml").notes
    ('not used: contacts of geoms',)
    """
    with _naming(file := _file(path)):
        described = mjcf.read(file)
        given = described.gravity if gravity is None else gravity
        return robot_of(described, locked=locked, close=close or {}, gravity=given, name=name)


@contextmanager
def _naming(file: Path) -> Iterator[None]:
    """Add the name of the file to an error that does not have it."""
    try:
        yield
    except ModelError as error:
        if str(error).startswith(str(file)):
            raise
        raise ModelError(f"{file}: {error}") from error


def load_urdf(
    path: str | os.PathLike[str],
    *,
    base: str = "fixed",
    locked: Collection[str] = (),
    close: Closed | None = None,
    gravity: Sequence[Any] = (0, 0, -9.81),
    name: str | None = None,
    meshes: bool = False,
    inertial_parameters: bool = False,
) -> Model:
    """Return the model of a URDF file: `read_urdf(...).model()`.

    Coordinates have the names of joints, and each joint has a torque or force as an input, tau_JOINT. The arguments are
    those of `read_urdf`.

    Examples
    --------
    >>> from pathlib import Path
    >>> import eigenmotion as em
    >>> bob = '<inertial><origin xyz="0 0 -1"/><mass value="2"/></inertial>'
    >>> links = f'<link name="base"/><link name="rod">{bob}</link>'
    >>> pin = '<joint name="pin" type="continuous"><parent link="base"/><child link="rod"/><axis xyz="0 1 0"/></joint>'
    >>> _ = Path("pendulum.urdf").write_text(f'<robot name="pendulum">{links}{pin}</robot>')
    >>> system = em.build(em.load_urdf("pendulum.urdf"))
    >>> system.simulate((0, 1), inputs={"tau_pin": 1.5}).success
    True
    """
    robot = read_urdf(
        path, base=base, locked=locked, close=close, gravity=gravity, name=name, meshes=meshes,
        inertial_parameters=inertial_parameters,
    )  # fmt: skip
    return robot.model()


def load_mjcf(
    path: str | os.PathLike[str],
    *,
    locked: Collection[str] = (),
    close: Closed | None = None,
    gravity: Sequence[Any] | None = None,
    name: str | None = None,
) -> Model:
    """Return the model of an MJCF file: `read_mjcf(...).model()`, with the arguments of `read_mjcf`.

    Examples
    --------
    >>> from pathlib import Path
    >>> import eigenmotion as em
    >>> rod = '<body name="rod"><joint name="pin" axis="0 1 0"/><geom pos="0 0 -1" size="0.1"/></body>'
    >>> _ = Path("pendulum.xml").write_text(f"<mujoco><worldbody>{rod}</worldbody></mujoco>")
    >>> em.load_mjcf("pendulum.xml").coordinates
    (pin(t),)
    """
    return read_mjcf(path, locked=locked, close=close, gravity=gravity, name=name).model()


def _file(path: str | os.PathLike[str]) -> Path:
    try:
        file = Path(path)
        file.read_bytes()
    except (TypeError, ValueError) as error:
        raise ModelError(f"{shown(path)} is not the path of a file.") from error
    except OSError as error:
        raise ModelError(f"{shown(str(path))}: {error.strerror or error}") from error
    return file
