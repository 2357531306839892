"""Units of models with contacts, and what units say of their directional derivatives."""

from pathlib import Path

import numpy as np
import pytest
from sympy import Rational, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Contact, Friction, Model, multiplier, t

from ..support.fmu_slaves import Unit, fmpy
from ..support.generation import system_for

validation = pytest.importorskip("fmpy.validation")


def hopper() -> Model:
    """A ball on a hard spring that bounces on a floor and slides on it, pushed by u."""
    x, z, u = dynamicsymbols("x z u")
    m, g, k, e, mu = symbols("m g k e mu", positive=True)
    return Model(
        name="hopper",
        coordinates=[x, z],
        kinetic_energy=m * (x.diff() ** 2 + z.diff() ** 2) / 2,
        potential_energy=m * g * z + k * x**4 / 4,
        forces={x: u},
        inputs={u: 0.0},
        contacts={
            "floor": Contact(z, restitution=e, rest=Rational(1, 1000)),
            "rub": Friction(x.diff(), limit=mu, normal="floor"),
        },
        parameters={m: 2.0, g: 9.81, k: 3.0, e: 0.5, mu: 0.2},
        outputs={"push": x.diff(t, 2), "load": -multiplier(0), "power": u * x.diff()},
        initial={z: 0.5, x.diff(): 2.0},
    )


@pytest.fixture(scope="module")
def contact(tmp_path_factory, hurried) -> Path:
    return em.export_fmu(hopper(), tmp_path_factory.mktemp("contact") / "hopper.fmu", formulation="lagrange", rtol=1e-9)


def test_contacts_strike_rest_and_rub_in_a_unit(contact):
    """Told by fmpy in steps of 10 ms; what it says at its steps is what one run has there."""
    assert validation.validate_fmu(str(contact)) == []
    rows = fmpy.simulate_fmu(str(contact), stop_time=2.0, output_interval=0.01, relative_tolerance=1e-10)
    run = system_for(hopper(), "lagrange").simulate((0, 2), rtol=1e-10, atol=1e-12, t_eval=rows["time"])
    assert len(run.t_events[0]) > 5
    found = np.array([rows[name] for name in ("x", "z", "der(x)", "der(z)")])
    assert np.abs(found - np.vstack([run.x, run.v])).max() < 1e-7
    assert run.outputs["load"][-1] == pytest.approx(2 * 9.81)
    assert rows["load"][-1] == pytest.approx(2 * 9.81)
    assert rows["push"] == pytest.approx(run.outputs["push"], abs=1e-6)


def derivatives(unit, unknown, known):
    """(unknown, known), as the unit says."""
    rows, columns = ([unit.places[name] for name in names] for names in (unknown, known))
    return np.array([unit.slave.getDirectionalDerivative(rows, [k], [1.0]) for k in columns]).T


@pytest.mark.parametrize("floor", [False, True])
def test_directional_derivatives_are_those_of_differences(contact, tmp_path, floor):
    """In the air, and where it slides on the floor, which it does once it has stepped."""
    known, unknown = ("x", "z", "der(x)", "der(z)", "u"), ("push", "load", "power", "x", "der(z)")
    here = {"x": 0.7, "z": 0.0 if floor else 0.3, "der(x)": 1.1, "der(z)": 0.0, "u": 0.9}
    unit = Unit(contact, tmp_path / "a")

    def begun(**given):
        unit.slave.reset()
        unit.begin(**here | given).step(0.0, 1e-9)
        return unit

    def said(**given):
        return np.array(begun(**given).get(*unknown))

    found = derivatives(begun(), unknown, known)
    assert begun().get("load")[0] == pytest.approx(19.62 if floor else 0.0)
    for k, name in enumerate(known):
        if not (floor and "z" in name):  # off the floor it is another mode
            differences = (said(**{name: here[name] + 1e-6}) - said(**{name: here[name] - 1e-6})) / 2e-6
            assert found[:, k] == pytest.approx(differences, abs=1e-6), name
    begun()
    both = [unit.places["push"], unit.places["power"]], [unit.places["x"], unit.places["u"]], [2.0, -1.0]
    assert list(unit.slave.getDirectionalDerivative(*both)) == pytest.approx(found[[0, 2]][:, [0, 4]] @ [2.0, -1.0])
    by_mass = derivatives(unit, ("push", "load"), ("m",))[:, 0]
    assert by_mass == pytest.approx([-(0.9 - 3 * 0.7**3) / 4.0, 9.81 if floor else 0.0], abs=1e-8)
    for wrong in (("m", "x"), ("x", "push")):
        with pytest.raises(Exception, match="fmi2GetDirectionalDerivative failed"):
            derivatives(unit, wrong[:1], wrong[1:])
