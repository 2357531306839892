"""First-order states, represented as velocities of additional coordinates.

A state z with zdot = f becomes the velocity of a coordinate Z with unit mass and force f, so that Z'' = f; nothing
depends on Z itself. All formulations, methods, lanes, events and derivatives therefore support states.
"""

from __future__ import annotations

from dataclasses import fields
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from ..normalise import ModelError, expression, name_of, pairs_of, t
from .mechanism import Mechanism
from .substitution import substituted

States = tuple[tuple[sympy.Expr, sympy.Expr], ...]


def states_of(states: Any) -> States:
    """Return pairs of a state z and its rate, in the same order.

    Raises
    ------
    ModelError
        A rate is not an expression; names the state.
    """
    return tuple((z, expression(rate, f"states[{name_of(z)}]")) for z, rate in pairs_of(states, "states"))


def integral(z: sympy.Expr) -> sympy.Expr:
    """Return the coordinate Z of which the state z is the velocity."""
    return sympy.Function(f"integral of {name_of(z)}")(t)


def as_mechanism(model: Mechanism) -> Mechanism:
    """Return the mechanism whose equations are derived: the model itself, or one with a coordinate for each state.

    Its T includes the kinetic energy of these coordinates; the T of the model does not.
    """
    if not model.states:
        return model
    integrals = tuple(integral(z) for z, _ in model.states)
    rates = {z: Z.diff(t) for (z, _), Z in zip(model.states, integrals, strict=True)}
    known = {field.name: getattr(model, field.name) for field in fields(Mechanism)}
    quasi = tuple(rates.items()) if model.quasi_velocities else ()
    made: dict[str, Any] = known | {
        "coordinates": (*model.coordinates, *integrals),
        "kinetic_energy": model.kinetic_energy + sum(rate**2 for rate in rates.values()) / 2,
        "quasi_velocities": (*model.quasi_velocities, *quasi),
        "forces": (*model.forces, *(rate for _, rate in model.states)),
        "scales": (*model.scales, *(1.0 for _ in integrals)),
        "initial": tuple((key if quasi else rates.get(key, key), value) for key, value in model.initial),
    }
    accelerations = {z.diff(t): rate.diff(t) for z, rate in rates.items()}
    for name in ("potential_energy", "forces", "outputs", "events", "contacts", "drawing"):
        made[name] = substituted(substituted(made[name], accelerations), rates)
    return Mechanism(**made)


def check_states(model: Mechanism) -> None:
    """Raise ModelError where a state is not a function of time, or is also a coordinate."""
    for z, _ in model.states:
        if not isinstance(z, AppliedUndef) or z.args != (t,):
            raise ModelError(
                f"states has an entry for {z}, which is not a function of time. Make it with "
                f"dynamicsymbols({name_of(z)!r})."
            )
        if z in model.coordinates:
            raise ModelError(f"{name_of(z)!r} is both a coordinate and a state. A coordinate has inertia: keep one.")
