"""Construction of a model from a system of bodies of `sympy.physics.mechanics`."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import sympy
from sympy.physics.mechanics import Particle, Point, ReferenceFrame, RigidBody, System

from ..model import Model, ModelError, t
from ..model.normalise import name_of, shown
from .as_system import system_of
from .joint_tree import joint_tree
from .loads import acting_on, check_weights
from .nonholonomic_correction import missing_forces
from .speeds import Speeds, speeds_of
from .tree_check import check_motion
from .tree_loads import check_potentials, generalised_forces, potentials, sort_loads
from .velocity_constraints import velocity_rows

Pairs = Mapping[Any, Any] | Sequence[tuple[Any, Any]]
FEW = 4
"""With as many coordinates as this, energies that are written out are short, and as fast."""


def from_mechanics(
    system: System | Iterable[Particle | RigidBody],
    *,
    name: str = "mechanism",
    parameters: Pairs = (),
    inputs: Pairs = (),
    outputs: Pairs = (),
    events: Pairs = (),
    initial: Pairs = (),
    scales: Pairs | Sequence[float] = (),
    drawing: Iterable[Any] = (),
    tree: bool | None = None,
    frame: ReferenceFrame | None = None,
    fixed_point: Point | None = None,
    loads: Iterable[Any] | None = None,
    coordinates: Iterable[Any] | None = None,
    speeds: Iterable[Any] | None = None,
    kinematic_equations: Iterable[Any] | None = None,
    holonomic_constraints: Iterable[Any] | None = None,
    nonholonomic_constraints: Iterable[Any] | None = None,
    velocity_constraints: Iterable[Any] | None = None,
) -> Model:
    """Return the Model of bodies, joints and loads of `sympy.physics.mechanics`.

    T follows from the velocities of the bodies; V from their potential energies, constant forces (weights) and springs;
    Q from all other loads (Kane: F . dv/du). Speeds that are linear in the rates become quasi-velocities (3). A speed
    that occurs in no kinematic equation becomes the rate of a new coordinate, NAME_integral. Velocities that already
    satisfy a constraint, as those of a rolling disk may, are allowed: see `codegen.mechanics.nonholonomic_correction`.

    Parameters
    ----------
    system
        A System, which contains all the arguments from `frame` on; or bodies (RigidBody and Particle).
    name, parameters, inputs, outputs, events, initial, scales, drawing
        As for `Model`. Masses and inertias that SymPy named are parameters too: `{body.mass: 2.0}`.
    tree
        True: the bodies become a `Tree`, whose recursions derivation, building and runs use. False: energies are
        written out. None: a tree if the joints form one and there are more than four coordinates. The notes of the
        model, which `eigenmotion explain` prints, say which it is, and why.
    frame, fixed_point, loads, coordinates, speeds, kinematic_equations
        Only with bodies: the fixed frame, a fixed point in it (needed for potentials of weights), loads (pairs, Force
        or Torque), q, u, and expressions that equal zero.
    holonomic_constraints, nonholonomic_constraints, velocity_constraints
        Only with bodies: expressions that equal zero. As in SymPy, `velocity_constraints` replaces
        `nonholonomic_constraints`; rows that follow from the holonomic constraints are dropped.

    Raises
    ------
    ModelError
        The system is incomplete, a Model cannot represent it, or it is no tree and `tree` is True; names the part
        and the remedy.

    Examples
    --------
    >>> from sympy.physics.mechanics import Particle, PrismaticJoint, RigidBody, System
    >>> import eigenmotion as em
    >>> wall, cart = RigidBody("wall"), Particle("cart")
    >>> mechanics = System.from_newtonian(wall)
    >>> mechanics.add_joints(PrismaticJoint("rail", wall, cart))
    >>> em.from_mechanics(mechanics, parameters={cart.mass: 2.0}).kinetic_energy
    cart_mass*u_rail(t)**2/2
    """
    parts = {
        "frame": frame, "fixed_point": fixed_point, "loads": loads, "coordinates": coordinates, "speeds": speeds,
        "kinematic_equations": kinematic_equations, "holonomic_constraints": holonomic_constraints,
        "nonholonomic_constraints": nonholonomic_constraints, "velocity_constraints": velocity_constraints,
    }  # fmt: skip
    try:
        read = _read(system_of(system, parts), tree, dict(parameters))
        _check_parameters(read, dict(parameters))
    except ModelError as error:
        raise ModelError(f"Model {shown(name)}: {error}") from error.__cause__
    return Model(name=name, parameters=parameters, inputs=inputs, outputs=outputs, events=events, initial=initial,
                 scales=scales, drawing=drawing, **read)  # fmt: skip


def _read(system: System, tree: bool | None, parameters: dict[Any, Any]) -> dict[str, Any]:
    """Return the arguments of Model that follow from a system."""
    speeds, why = speeds_of(system), ""
    energies: dict[str, Any] | None = None
    try:
        if tree is False:
            why = "tree=False"
        elif tree is None and len(speeds.coordinates) <= FEW:
            why = f"there are no more than {FEW} coordinates"
        else:
            energies = _of_tree(system, speeds, parameters)
    except ModelError as error:
        why = str(error)
        if tree:
            raise ModelError(f"The joints form no tree: {why.rstrip('.')}. Or leave out `tree`.") from error
    note = f"The energies are written out, not those of a tree: {why.rstrip('.')}." if why else "The bodies are a tree."
    write = dict(speeds.written)
    return {
        "coordinates": speeds.coordinates,
        **(energies or _written_out(system, speeds)),
        "holonomic_constraints": list(system.holonomic_constraints),
        "nonholonomic_constraints": [row.xreplace(write) for row in velocity_rows(system, speeds)],
        "quasi_velocities": dict(speeds.in_rates) if speeds.linear else (),
        "notes": (note,),
    }


def _of_tree(system: System, speeds: Speeds, parameters: dict[Any, Any]) -> dict[str, Any]:
    """Return the energies and forces of a system as functions of the bodies of a tree.

    Raises
    ------
    ModelError
        It is no tree, or an inertia has no value (one may be without where it has no effect); says why.
    """
    if not system.joints:
        raise ModelError("there are no joints")
    check_potentials(system)
    loads = sort_loads(system)
    made = joint_tree(system, loads.gravity)
    is_rate_of_place = check_motion(made, system, speeds)
    T = made.tree.kinetic_energy
    _check_values([T], parameters)
    V, others = potentials(system, made, loads, is_rate_of_place)
    forces = generalised_forces(system, made, speeds, others)
    return {"kinetic_energy": T, "potential_energy": V, "forces": forces}


def _written_out(system: System, speeds: Speeds) -> dict[str, Any]:
    """Return the energies and forces of a system in its coordinates and velocities."""
    acting = acting_on(system, speeds)
    check_weights(system, acting)
    forces = [load.Q for load in acting if load.V is None]
    forces += [missing_forces(body, system, speeds) for body in system.bodies]
    write = dict(speeds.written)
    return {
        "kinetic_energy": sum(_kinetic_energy(body, system, speeds) for body in system.bodies),
        "potential_energy": sum(body.potential_energy for body in system.bodies)
        + sum(load.V for load in acting if load.V is not None),
        "forces": [sympy.Add(*column).xreplace(write) for column in zip(*forces, strict=True)],
    }


def _kinetic_energy(body: Particle | RigidBody, system: System, speeds: Speeds) -> sympy.Expr:
    try:
        T = body.kinetic_energy(system.frame)
    except ValueError as error:
        raise ModelError(
            f"The kinetic energy of the body {body.name} cannot be formed: {error} The axes of its inertia and "
            f"velocity must be oriented in {system.frame.name}."
        ) from error
    return T.xreplace(dict(speeds.written))


def _check_parameters(read: dict[str, Any], parameters: dict[Any, Any]) -> None:
    """Raise with all symbols that have no value, since SymPy creates symbols of masses and inertias by itself."""
    energies = [read["kinetic_energy"], read["potential_energy"], *read["forces"], *read["holonomic_constraints"]]
    _check_values([*energies, *read["nonholonomic_constraints"], *dict(read["quasi_velocities"]).values()], parameters)


def _check_values(expressions: Iterable[sympy.Expr], parameters: dict[Any, Any]) -> None:
    missing = sorted(name_of(symbol) for symbol in sympy.Tuple(*expressions).free_symbols - {t, *parameters})
    if missing:
        raise ModelError(f"parameters has no value for {', '.join(missing)}. Give a number for each, by its symbol.")
