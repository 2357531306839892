"""Copies of a model with other fields, by dataclasses.replace: the models that are stated with these fields."""

import copy
import pickle
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from sympy import cos, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Contact, Friction, Model, ModelError, multiplier

from ..support.generation import system_for

x, y, z, u = dynamicsymbols("x y z u")
mu, d, g = symbols("mu d g", positive=True)
STATED: dict[str, Any] = {
    "name": "sledge",
    "coordinates": [x, y, z],
    "kinetic_energy": (x.diff() ** 2 + y.diff() ** 2 + z.diff() ** 2) / 2,
    "potential_energy": g * (y + z),
    "forces": {x: u - d * x.diff()},
    "inputs": {u: 0.0},
    "holonomic_constraints": {"rail": y},
    "nonholonomic_constraints": {"rope": [z.diff() - x.diff() / 10]},
    "contacts": {"rub": Friction(x.diff(), limit=mu, normal="rail"), "floor": Contact(z + 1, rest=0.01)},
    "outputs": {"press": -multiplier("rail"), "pull": multiplier("rope"), "on_floor": -multiplier("floor")},
    "events": {"far": x - 3},
    "parameters": {mu: 0.1, d: 0.2, g: 9.81},
    "initial": {x.diff(): 1.0, z.diff(): 0.1},
    "units": {x: "m"},
}


@pytest.mark.parametrize("changes", [
    {}, {"forces": {x: -5 * d * x.diff()}}, {"forces": {}}, {"contacts": {}, "outputs": {}},
    {"contacts": {"rub": Friction(x.diff(), limit=mu / 2, normal="rail")}, "outputs": {}},
    {"contacts": STATED["contacts"] | {"wall": Contact(1 - x, restitution=0.5)}},
    {"holonomic_constraints": {"stretch": x - y * cos(y) - x, "rail": y}}, {"events": {}}, {"events": {"near": x - 2}},
    {"parameters": {mu: 0.3, d: 0.01, g: 1.0}}, {"holonomic_constraints": {"rail": y - u}},
    {"outputs": {"drag": multiplier("floor")}}, {"coordinates": [z, y, x]},
], ids=str)  # fmt: skip
def test_a_copy_is_the_model_that_is_stated_so(changes):
    made, again = replace(Model(**STATED), **changes), Model(**(STATED | changes))
    assert made.canonical() == again.canonical()
    assert (
        replace(pickle.loads(pickle.dumps(made)), name="other").canonical() == replace(again, name="other").canonical()
    )
    assert replace(made, **STATED).canonical() == Model(**STATED).canonical()


def test_entries_of_a_model_in_lists_add_no_contact_twice():
    model = Model(**STATED)
    parts = {field: list(getattr(model, field)) for field in
             ("holonomic_constraints", "nonholonomic_constraints", "events", "parameters", "contacts")}  # fmt: skip
    assert replace(model, **parts).canonical() == model.canonical()
    assert copy.deepcopy(model) == model
    with pytest.raises(ModelError, match=r"forces\[x\] has the force of contacts\[rub\]"):
        replace(model, forces=list(model.forces))


def test_names_stay_with_their_rows():
    """A list of other rows has no names; a list that begins with the model's rows keeps theirs."""
    model = Model(**STATED)
    longer = replace(model, holonomic_constraints=[*model.holonomic_constraints, z - x])
    assert longer.row_names == ("rail", "", "", "rope", "")
    assert dict(longer.outputs)["pull"] == multiplier(3)
    with pytest.raises(ModelError, match="'rail'"):
        replace(model, holonomic_constraints=[z - x])


def test_other_forces_leave_the_friction():
    """x'' = -mu g; a copy with other forces had lost its friction, and one with another coefficient kept the old."""
    alone = {"holonomic_constraints": {"rail": y, "level": z}, "nonholonomic_constraints": {}, "outputs": {}}
    model = replace(Model(**STATED), **alone, contacts={"rub": STATED["contacts"]["rub"]}, initial={x.diff(): 1.0})
    for changed, coefficient in (
        ({}, 0.1),
        ({"contacts": {"rub": Friction(x.diff(), limit=mu / 2, normal="rail")}}, 0.05),
    ):
        system = system_for(replace(model, forces={}, **changed), "lagrange")
        run = em.simulate(system, (0.0, 0.5), rtol=1e-10)
        np.testing.assert_allclose(run.v[0, -1], 1 - coefficient * 9.81 * 0.5, rtol=1e-9)
