"""Conversion of the user's arguments to a `sympy.physics.mechanics.System`."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from sympy.physics.mechanics import Point, ReferenceFrame, System

from ..model import ModelError
from ..model.normalise import name_of, shown

_WAYS = "Give a sympy.physics.mechanics.System, or bodies with loads=, frame=, coordinates= and the rest."


def system_of(source: Any, parts: dict[str, Any]) -> System:
    """Return a system as it is, or assemble one from bodies and the other parts.

    Raises
    ------
    ModelError
        The argument is neither a system nor bodies, or a model has no counterpart of one of its parts.
    """
    extra = {name: value for name, value in parts.items() if value is not None}
    if isinstance(source, System):
        if extra:
            raise ModelError(
                f"{', '.join(extra)}: a System has its own. Add to it before, or give bodies in its place."
            )
        system = source
    else:
        system = _assembled(source, **extra)
    _check(system)
    return system


def _assembled(
    bodies: Any,
    *,
    frame: ReferenceFrame | None = None,
    fixed_point: Point | None = None,
    loads: Iterable[Any] = (),
    coordinates: Iterable[Any] = (),
    speeds: Iterable[Any] = (),
    kinematic_equations: Iterable[Any] = (),
    holonomic_constraints: Iterable[Any] = (),
    nonholonomic_constraints: Iterable[Any] = (),
    velocity_constraints: Iterable[Any] | None = None,
) -> System:
    if isinstance(bodies, str) or not isinstance(bodies, Iterable):
        raise ModelError(f"{shown(bodies)} is not what a model is read off. {_WAYS}")
    if not isinstance(frame, ReferenceFrame):
        raise ModelError(f"frame is {shown(frame)}: bodies move in a ReferenceFrame that is fixed. {_WAYS}")
    system = System(frame, fixed_point)
    try:
        system.add_bodies(*bodies)
        system.add_loads(*loads)
        system.add_coordinates(*coordinates)
        system.add_speeds(*speeds)
        system.add_kdes(*kinematic_equations)
        system.add_holonomic_constraints(*holonomic_constraints)
        system.add_nonholonomic_constraints(*nonholonomic_constraints)
        system.velocity_constraints = None if velocity_constraints is None else list(velocity_constraints)
    except (TypeError, ValueError) as error:
        raise ModelError(f"SymPy does not take it: {error} {_WAYS}") from error
    return system


def _check(system: System) -> None:
    if not system.bodies:
        raise ModelError("There are no bodies. Add them by add_bodies or add_joints.")
    if not system.q:
        raise ModelError("There are no coordinates. Add them by add_coordinates or add_joints.")
    if system.u_aux:
        names = ", ".join(map(name_of, system.u_aux))
        raise ModelError(
            f"The auxiliary speeds {names} are not supported: they bring a force of constraint into the equations. "
            "Leave them out, state the constraint, and read its force off by outputs with eigenmotion.multiplier."
        )
    known = {*system.q}
    for joint in system.joints:
        missing = [name_of(q) for q in joint.coordinates if q not in known]
        if missing:
            raise ModelError(
                f"The joint {joint.name} has the coordinates {', '.join(missing)}, which the system has not. "
                "Add them by add_coordinates."
            )
