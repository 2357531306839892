"""`Robot`: what is read of a file, as a tree of bodies with the names of the file, and the models made of it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import sympy

from ..codegen.model import Contact, Friction, Model, ModelError, Tree, draw
from ..codegen.model.normalise import name_of, pairs_of, sequence_of
from ..codegen.model.tree.tree import Body
from .description import Joint

_MERGED = ("parameters", "inputs", "outputs", "events", "initial", "contacts", "states")
_ADDED = ("kinetic_energy", "potential_energy")
_APPENDED = ("coordinates", "notes")


@dataclass(frozen=True, slots=True)
class Robot:
    """A robot that `read_urdf` or `read_mjcf` has read.

    Attributes
    ----------
    name
    tree : its `Tree`
    bodies : link of the file -> its Body, for places and velocities in outputs, contacts, constraints
    joints : joint of the file -> its record: kind, damping, friction, lower, upper, effort, velocity
    positions : joint of one coordinate -> its position as an expression: q, or k q + b where another joint drives it
    coordinates : functions of time, named after the joints
    torques : joint -> its input tau_JOINT [N m or N], 0 by default
    drawing : solids of the file, and lines between the frames of joints of links without solids
    notes : what of the file is not used
    labels : joint -> its name as an identifier
    fields : the other arguments of its models

    Examples
    --------
    A point mass on a rod with a limit, at which it stops:

    >>> from pathlib import Path
    >>> import eigenmotion as em
    >>> bob = '<inertial><origin xyz="0 0 -1"/><mass value="2"/></inertial>'
    >>> links = f'<link name="base"/><link name="rod">{bob}</link>'
    >>> pin = '<joint name="pin" type="revolute"><parent link="base"/><child link="rod"/><axis xyz="0 1 0"/>'
    >>> pin += '<limit lower="-0.5" upper="0.5"/></joint>'
    >>> _ = Path("pendulum.urdf").write_text(f'<robot name="pendulum">{links}{pin}</robot>')
    >>> robot = em.read_urdf("pendulum.urdf")
    >>> run = em.build(robot.model(contacts=robot.stops())).simulate((0, 2), inputs={"tau_pin": 30.0})
    >>> print(run.x[0, -1].round(6))
    0.5
    """

    name: str
    tree: Tree
    bodies: Mapping[str, Body]
    joints: Mapping[str, Joint]
    positions: Mapping[str, sympy.Expr]
    torques: Mapping[str, sympy.Expr]
    drawing: tuple[draw.Line | draw.Solid, ...]
    notes: tuple[str, ...]
    labels: Mapping[str, str]
    fields: Mapping[str, Any]

    @property
    def coordinates(self) -> tuple[sympy.Expr, ...]:
        """(n) coordinates, functions of time."""
        return self.tree.coordinates

    def model(self, **more: Any) -> Model:
        """Return a Model.

        Parameters
        ----------
        **more
            Arguments of `Model`. Energies and forces are added to those of the robot; coordinates and notes are
            appended; mappings are merged (outputs, inputs, parameters, initial, constraints, and so on); `name` and
            `drawing` replace the robot's.

        Raises
        ------
        ModelError
            As `Model`.
        """
        given = {"name": self.name, "drawing": self.drawing, "notes": self.notes, **self.fields}
        for field, value in more.items():
            given[field] = _combined(field, given.get(field), value)
        return Model(**given)

    def stops(self, joints: Iterable[str] | None = None, *, restitution: float = 0.0) -> dict[str, Contact]:
        """Return contacts at the lower and upper limits of joints; None for all that have limits."""
        made = {}
        for name in self._named(joints):
            position, joint, label = self.positions[name], self.joints[name], self.labels[name]
            for side, gap in (("lower", position - joint.lower), ("upper", joint.upper - position)):
                if gap.is_finite is not False:
                    made[f"{label}_{side}"] = Contact(gap, restitution=restitution)
        return made

    def frictions(self, joints: Iterable[str] | None = None) -> dict[str, Friction]:
        """Return Coulomb friction in joints; None for all whose friction the file states."""
        named = [name for name in self._named(joints) if self.joints[name].friction]
        return {
            f"{self.labels[name]}_friction": Friction(self.positions[name].diff(), limit=self.joints[name].friction)
            for name in named
        }

    def _named(self, joints: Iterable[str] | None) -> list[str]:
        names = list(self.positions if joints is None else joints)
        for name in names:
            if name not in self.positions:
                raise ModelError(f"{name!r} is no joint of one coordinate of {self.name}. It has {[*self.positions]}.")
        return names


def _combined(field: str, own: Any, more: Any) -> Any:
    """Return the robot's argument of `Model` and the user's in one."""
    if own is None or field in ("name", "drawing"):
        return more
    if field in _ADDED:
        return own + more
    if field in _APPENDED:
        return (*own, *sequence_of(more, field))
    if field in _MERGED:
        return {**own, **dict(pairs_of(more, field))}
    if field == "units":
        return {**own, **{name_of(key): unit for key, unit in pairs_of(more, field)}}
    if field == "forces":
        given = dict(pairs_of(more, field))
        return {**own, **{q: own.get(q, sympy.S.Zero) + force for q, force in given.items()}}
    if field == "holonomic_constraints" and not isinstance(more, Mapping):
        if own:
            raise ModelError("holonomic_constraints of a robot with loops have names. Give a mapping name -> rows.")
        return more
    return {**own, **more} if isinstance(more, Mapping) else more
