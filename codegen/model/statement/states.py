"""First-order states: their rates, and the mechanism in which each is the rate of a coordinate of its own.

A state z with zdot = f is the velocity of a coordinate Z that has unit mass and the force f, and that nothing else
depends on: Z'' = f. Formulations, methods, lanes, events and derivatives know velocities, and so they know states.
"""

from __future__ import annotations

from copy import copy
from dataclasses import fields, is_dataclass
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from ..normalise import ModelError, expression, name_of, pairs_of, t
from .mechanism import Mechanism

States = tuple[tuple[sympy.Expr, sympy.Expr], ...]


def states_of(given: Any) -> States:
    """Return pairs of a state z and its rate, as they were given.

    Raises
    ------
    ModelError
        A rate is not an expression; names the state.
    """
    return tuple((z, expression(rate, f"states[{name_of(z)}]")) for z, rate in pairs_of(given, "states"))


def integral(z: sympy.Expr) -> sympy.Expr:
    """Return the coordinate Z whose velocity a state is."""
    return sympy.Function(f"integral of {name_of(z)}")(t)


def as_mechanism(model: Mechanism) -> Mechanism:
    """Return the mechanism that is derived: a model itself, or where it has states one with a coordinate for each.

    The kinetic energy of the new coordinates is in its T; that of the model is without.
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
    twice = {z.diff(t): rate.diff(t) for z, rate in rates.items()}
    for name in ("potential_energy", "forces", "outputs", "events", "contacts"):
        made[name] = _written(_written(made[name], twice), rates)
    return Mechanism(**made)


def _written(given: Any, replacements: dict[sympy.Expr, sympy.Expr]) -> Any:
    """Return expressions, in tuples and records, with replacements made."""
    if isinstance(given, sympy.Basic):
        return given.xreplace(replacements)
    if isinstance(given, tuple):
        return tuple(_written(part, replacements) for part in given)
    if not is_dataclass(given):
        return given
    made = copy(given)
    for field in fields(given):
        object.__setattr__(made, field.name, _written(getattr(given, field.name), replacements))
    return made


def check_states(model: Mechanism) -> None:
    """Raise ModelError where a state is no function of time, or is a coordinate."""
    for z, _ in model.states:
        if not isinstance(z, AppliedUndef) or z.args != (t,):
            raise ModelError(
                f"states has an entry for {z}, which is not a function of time. Make it with "
                f"dynamicsymbols({name_of(z)!r})."
            )
        if z in model.coordinates:
            raise ModelError(f"{name_of(z)!r} is both a coordinate and a state. A coordinate has inertia: keep one.")
