"""Obstacles to an independent reference: what plain equations of a model do not contain."""

from collections.abc import Iterator
from math import inf

from sympy import Expr

from ..codegen.model import Model
from ..codegen.model.tree.functions import BodyFunction


def without_reference(model: Model, most_coordinates: float = inf) -> str:
    """Return why a model's motion has no independent reference; "" if it has.

    most_coordinates : for which equations by plain SymPy are few enough
    """
    if model.contacts:
        return "contacts and friction"
    if acts(model):
        return "events that act on the motion"
    if model.tables:
        return "prescribed motions" if len(model.prescribed) == len(model.tables) else "tables"
    if any(one.has(BodyFunction) for one in _in_equations(model)):
        return "functions of a tree of bodies"
    return f"{model.n} coordinates, more than {most_coordinates:g}" if model.n > most_coordinates else ""


def _in_equations(model: Model) -> Iterator[Expr]:
    yield model.kinetic_energy
    yield model.potential_energy
    yield from (*model.forces, *model.holonomic_constraints, *model.nonholonomic_constraints)
    yield from (rate for _, rate in model.states)


def acts(model: Model) -> bool:
    """Return whether an event or a contact acts on the motion, so that energy is not constant and rows change."""
    return bool(model.contacts) or any(event.acts for _, event in model.events)
