"""The model of a system of bodies, read off what SymPy's mechanics knows of it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import sympy
from sympy.physics.mechanics import Particle, Point, ReferenceFrame, RigidBody, System

from ..model import Model, ModelError, t
from ..model.normalise import name_of, shown
from .as_system import system_of
from .loads import acting_on, weights_counted_twice
from .nonholonomic_correction import missing_forces
from .speeds import Speeds, speeds_of
from .velocity_constraints import velocity_rows

Pairs = Mapping[Any, Any] | Sequence[tuple[Any, Any]]


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

    T comes of the bodies' velocities, V of their potential energies, of weights and springs, Q of all other loads
    (Kane: F . dv/du). Speeds that are linear in the rates become quasi-velocities (3); a speed that no kinematic
    equation holds becomes the rate of a coordinate, NAME_integral. Velocities that already satisfy a constraint, as of
    a rolling disk, are allowed: see `codegen.mechanics.nonholonomic_correction`.

    Parameters
    ----------
    system
        A System, which has everything of the last group below; or bodies, RigidBody and Particle.
    name, parameters, inputs, outputs, events, initial, scales, drawing
        As for `Model`. Masses and inertias that SymPy named are parameters too: `{body.mass: 2.0}`.
    frame, fixed_point, loads, coordinates, speeds, kinematic_equations
        Of bodies: the frame that is fixed and a point in it (without one no weight has a potential), pairs or Force and
        Torque, q, u, and expressions that are zero.
    holonomic_constraints, nonholonomic_constraints, velocity_constraints
        Expressions that are zero. The last in place of the one before it, as SymPy's: those of the holonomic ones
        that are among them are left out.

    Raises
    ------
    ModelError
        What SymPy holds is no mechanism, or one that a Model cannot state; names it, and says what to do.

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
        read = _read(system_of(system, parts))
        _check_parameters(read, dict(parameters))
    except ModelError as error:
        raise ModelError(f"Model {shown(name)}: {error}") from error.__cause__
    return Model(name=name, parameters=parameters, inputs=inputs, outputs=outputs, events=events, initial=initial,
                 scales=scales, drawing=drawing, **read)  # fmt: skip


def _read(system: System) -> dict[str, Any]:
    """Return the arguments of Model that a system has."""
    speeds = speeds_of(system)
    acting = acting_on(system, speeds)
    weights_counted_twice(system, acting)
    forces = [load.Q for load in acting if load.V is None]
    forces += [missing_forces(body, system, speeds) for body in system.bodies]
    write = dict(speeds.written)
    return {
        "coordinates": speeds.coordinates,
        "kinetic_energy": sum(_kinetic_energy(body, system, speeds) for body in system.bodies),
        "potential_energy": sum(body.potential_energy for body in system.bodies)
        + sum(load.V for load in acting if load.V is not None),
        "forces": [sympy.Add(*column).xreplace(write) for column in zip(*forces, strict=True)],
        "holonomic_constraints": list(system.holonomic_constraints),
        "nonholonomic_constraints": [row.xreplace(write) for row in velocity_rows(system, speeds)],
        "quasi_velocities": dict(speeds.in_rates) if speeds.linear else (),
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


def _check_parameters(read: dict[str, Any], given: dict[Any, Any]) -> None:
    """Raise with every symbol that has no value: SymPy makes masses and inertias of its own."""
    energies = [read["kinetic_energy"], read["potential_energy"], *read["forces"], *read["holonomic_constraints"]]
    held = sympy.Tuple(*energies, *read["nonholonomic_constraints"], *dict(read["quasi_velocities"]).values())
    missing = sorted(name_of(symbol) for symbol in held.free_symbols - {t, *given})
    if missing:
        raise ModelError(f"parameters has no value for {', '.join(missing)}. Give a number for each, by its symbol.")
