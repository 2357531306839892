"""Loads on a tree of joints: potentials by functions of bodies, generalised forces by SymPy's partial velocities."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy
from sympy.physics.mechanics import Force, LinearPathway, Point, ReferenceFrame, System, Torque, Vector

from ..model import ModelError
from .joint_tree import Entries, JointTree, is_constant
from .loads import angular_velocity, stored_energy, velocity
from .speeds import Speeds

NO_GRAVITY = (sympy.S.Zero,) * 3


@dataclass(frozen=True, slots=True)
class Sorted:
    """Loads of a system.

    gravity : (3,) acceleration of gravity, where constant forces at mass centres are those of one field
    constant : forces that are constant in the system's frame, weights of that field left out, as (point, (3,))
    others : all other loads
    """

    gravity: Entries
    constant: Sequence[tuple[Point, sympy.ImmutableDenseMatrix]]
    others: Sequence[Force | Torque]


def sort_loads(system: System) -> Sorted:
    """Return the loads of a system, without those of actuators, by how they enter a model."""
    constant, others = [], []
    for load in system.loads:
        F = _constant(load, system.frame)
        if F is None:
            others.append(load)
        else:
            constant.append((load.point, F))
    masses = _masses(system)
    field = _field(masses, constant)
    if field is not None:
        constant = [(point, F) for point, F in constant if point not in masses]
    return Sorted(field or NO_GRAVITY, constant, others)


def _constant(load: Force | Torque, frame: ReferenceFrame) -> sympy.ImmutableDenseMatrix | None:
    if not isinstance(load, Force) or {one for _, one in load.vector.args} - {frame}:
        return None
    F = load.vector.to_matrix(frame)
    return F if is_constant(F) else None


def _masses(system: System) -> dict[Point, sympy.Expr]:
    """Return the mass at each mass centre that moves: bodies may share one, and may have none."""
    masses: dict[Point, sympy.Expr] = {}
    for body in system.bodies:
        if getattr(body, "frame", None) != system.frame:
            masses[body.masscenter] = masses.get(body.masscenter, sympy.S.Zero) + body.mass
    return {point: mass for point, mass in masses.items() if mass != 0}


def _field(masses: Mapping[Point, sympy.Expr], constant: Iterable[tuple[Point, Any]]) -> tuple[sympy.Expr, ...] | None:
    """Return g (3,) if the constant forces at mass centres are m g; None if they are those of no field."""
    totals: dict[Point, Any] = {}
    for point, F in constant:
        totals[point] = totals[point] + F if point in totals else F
    if not all(point in totals for point in masses):
        return None
    fields = {tuple(sympy.cancel(one / mass) for one in totals[point]) for point, mass in masses.items()}
    return fields.pop() if len(fields) == 1 else None


def potentials(
    system: System, made: JointTree, loads: Sorted, is_rate_of_place: Callable[[Point], bool]
) -> tuple[sympy.Expr, list[Force | Torque]]:
    """Return the potential energy of gravity, constant forces (-F . r) and springs [J], and all loads without one."""
    V, others = made.tree.potential_energy, list(loads.others)
    for point, F in loads.constant:
        if is_rate_of_place(point):
            V -= F.dot(made.in_ground(point.pos_from(system.fixed_point)))
        else:
            others.append(Force(point, Vector([(sympy.Matrix(F), system.frame)])))
    for actuator in system.actuators:
        energy = _energy_of_spring(actuator, made, is_rate_of_place)
        if energy is None:
            others += actuator.to_loads()
        else:
            V += energy
    return V, others


def _energy_of_spring(spring: Any, made: JointTree, is_rate_of_place: Callable[[Point], bool]) -> sympy.Expr | None:
    """Return the energy of a spring along a straight line; None for other actuators, and where it is no potential."""
    if not isinstance(getattr(spring, "pathway", None), LinearPathway):
        return None
    first, last = spring.pathway.attachments
    if not (is_rate_of_place(first) and is_rate_of_place(last)):
        return None
    line = made.in_ground(last.pos_from(first))
    return stored_energy(spring, sympy.sqrt(line.dot(line)))


def generalised_forces(
    system: System, made: JointTree, speeds: Speeds, loads: Iterable[Force | Torque]
) -> list[sympy.Expr]:
    """Return (n) generalised forces P^T (F . dv/dw), where w are the velocities in which the model is written.

    Opposite loads are taken together, so that a torque between neighbours acts on one coordinate alone.
    """
    parts = [sympy.S.Zero] * len(speeds.velocities)
    for vector, v in _grouped(loads, system.frame, dict(speeds.written)):
        for k, w in enumerate(speeds.velocities):
            parts[k] += made.dot(vector, v.diff(w, system.frame, var_in_dcm=False))
    return list(speeds.P.T * sympy.ImmutableDenseMatrix(parts))


def _grouped(
    loads: Iterable[Force | Torque], frame: ReferenceFrame, written: dict[sympy.Expr, sympy.Expr]
) -> list[tuple[Vector, Vector]]:
    """Return (load, velocity) pairs, where the velocities of places with equal or opposite loads are added."""
    groups: dict[Any, list[Vector]] = {}
    for load in loads:
        is_force = isinstance(load, Force)
        with warnings.catch_warnings():  # SymPy warns of two ways to a velocity; `check_motion` compared them
            warnings.simplefilter("ignore", UserWarning)
            v = velocity(load.point, frame) if is_force else angular_velocity(load.frame, frame)
        v, vector = v.xreplace(written), load.vector.xreplace(written)
        opposite = groups.get((is_force, _key(-vector)))
        if opposite:
            opposite[1] -= v
            continue
        group = groups.setdefault((is_force, _key(vector)), [vector, Vector(0)])
        group[1] += v
    return [(vector, v) for vector, v in groups.values()]


def _key(vector: Vector) -> frozenset[Any]:
    """Return what equal vectors have in common, however their entries are written."""
    return frozenset((frame, sympy.ImmutableDenseMatrix(entries.expand())) for entries, frame in vector.args)


def check_potentials(system: System) -> None:
    """Check that no body has a potential energy of its own, of which weights might be a part.

    Raises
    ------
    ModelError
        One has; names it.
    """
    for body in system.bodies:
        if body.potential_energy != 0:
            raise ModelError(f"the body {body.name} has a potential energy of its own")
