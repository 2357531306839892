"""Units of FMI 2.0 and 3.0, in co-simulation and in model exchange: fmpy validates them, and its motions are ours."""

from pathlib import Path
from zipfile import ZipFile

import numpy as np
import pytest

import eigenmotion as em
from eigenmotion import ModelError
from eigenmotion.cli import main

from ..support.fmu_slaves import Slave, exchanged, fmpy, stepped
from ..support.generation import MODELS, system_of

validation = pytest.importorskip("fmpy.validation")
pytestmark = pytest.mark.usefixtures("hurried")

UNITS = (("dual_link", 3), ("furuta_pendulum", 2), ("furuta_pendulum", 3))
FORMULATIONS = {"dual_link": "eigenfactor", "furuta_pendulum": "lagrange"}
TORQUE = np.array([(0.0, 0.02), (1.0, 0.02)], dtype=[("time", float), ("u", float)])
LABELS = {"units": {"theta": "rad", "m": "kg", "u": "N*m"}, "descriptions": {"u": "torque of the motor"}}


@pytest.fixture(scope="module")
def units(tmp_path_factory, hurried) -> dict[tuple[str, int], Path]:
    folder = tmp_path_factory.mktemp("units")

    def unit(name, fmi):
        options = LABELS if name == "furuta_pendulum" else {}
        path = folder / f"{name}{fmi}.fmu"
        return em.export_fmu(MODELS / f"{name}.py", path, fmi=fmi, formulation=FORMULATIONS[name], **options)

    return {one: unit(*one) for one in UNITS}


@pytest.mark.parametrize(("name", "fmi"), UNITS)
def test_valid_and_the_same_motion_both_ways(units, name, fmi):
    """To 1e-8 by our steps, and to 1e-6 by a solver that knows nothing of us."""
    assert validation.validate_fmu(str(units[name, fmi])) == []
    inputs = {"u": 0.02} if name == "furuta_pendulum" else None
    given = {"input": TORQUE} if inputs else {}
    run = system_of(name).simulate((0, 1), rtol=1e-11, atol=1e-14, inputs=inputs)
    names = (*system_of(name).coordinates, *(f"der({one})" for one in system_of(name).coordinates))
    for simulated, tolerance in ((stepped, 1e-8), (exchanged, 1e-6)):
        rows = simulated(units[name, fmi], 1.0, **given)
        found = np.array([rows[each][-1] for each in names])
        assert np.abs(found - np.concatenate([run.x[:, -1], run.v[:, -1]])).max() < tolerance


@pytest.mark.parametrize("fmi", [2, 3])
def test_units_and_descriptions(units, fmi):
    description = fmpy.read_model_description(str(units["furuta_pendulum", fmi]))
    variables = {one.name: one for one in description.modelVariables}
    assert [variables[name].unit for name in ("theta", "der(theta)", "der(der(theta))", "m", "u", "phi")] == [
        "rad", "rad/s", "rad/s^2", "kg", "N*m", None,
    ]  # fmt: skip
    assert variables["u"].description == "torque of the motor"
    assert variables["phi"].description == "coordinate"
    bases = {one.name: one.baseUnit for one in description.unitDefinitions}
    torque = bases["N*m"]
    assert (torque.kg, torque.m, torque.s, torque.rad, torque.factor) == (1, 2, -2, 0, 1.0)
    assert variables["der(der(theta))"].derivative is variables["der(theta)"]
    assert variables["der(theta)"].derivative is variables["theta"]


def test_labels_that_name_nothing_are_refused(tmp_path):
    for options, words in (
        ({"units": {"angle": "rad"}}, "angle"),
        ({"units": {"theta": "furlong"}}, "furlong"),
        ({"units": {"theta": "rad//s"}}, "no physical unit"),
        ({"descriptions": {"theta": "two\nlines"}}, "line of text"),
        ({"fmi": 1}, "fmi is 1"),
    ):
        with pytest.raises(ModelError, match=words):
            em.export_fmu(MODELS / "pendulum.py", tmp_path / "a.fmu", formulation="lagrange", **options)


def test_states_of_fmi_3_go_back_to_the_last_bit(units, tmp_path):
    unit = Slave(units["furuta_pendulum", 3], tmp_path / "a").begin(u=0.01)
    unit.slave.doStep(0.0, 0.2)
    state = unit.slave.getFMUState()
    packed = unit.slave.serializeFMUState(state)

    def on():
        unit.slave.doStep(0.2, 0.3)
        return unit.get("time", "theta", "der(phi)", "height of the tip", "time")

    first = on()
    assert first[0] == first[-1] == 0.5
    unit.slave.setFMUState(state)
    assert on() == first
    unit.slave.setFMUState(unit.slave.deserializeFMUState(packed))
    assert on() == first
    with pytest.raises(Exception, match="fmi3SetFloat64 failed"):
        unit.slave.setFloat64([unit.places["m"]], [0.3])
    assert unit.said[-1].endswith("parameters and start are fixed while stepping")


def test_directional_derivatives_of_fmi_3(units, tmp_path):
    unit = Slave(units["furuta_pendulum", 3], tmp_path / "a").begin(phi=0.4, u=0.01)
    system = system_of("furuta_pendulum")
    known = ("theta", "phi", "der(theta)", "der(phi)", "u")
    rows = [unit.places[name] for name in ("der(der(theta))", "der(der(phi))")]
    found = np.array([unit.slave.getDirectionalDerivative(rows, [unit.places[name]], [1.0]) for name in known]).T
    x, v, h = np.array([0.0, 0.4]), np.zeros(2), 1e-6

    def accelerations(k, change):
        moved = np.array([*x, *v, 0.01])
        moved[k] += change
        return system.acceleration(moved[:2], moved[2:4], inputs={"u": moved[4]})[0]

    differences = np.array([(accelerations(k, h) - accelerations(k, -h)) / (2 * h) for k in range(5)]).T
    assert found == pytest.approx(differences, abs=1e-6 * abs(differences).max())


def test_fmi_3_from_the_command_line(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    told = ["export", str(MODELS / "pendulum.py"), "--fmu", "swing.fmu", "--formulation", "lagrange", "--fmi", "3"]
    assert main([*told, "--unit", "theta=deg", "--describe", "theta=angle of the rod"]) == 0
    assert "speaks FMI 3.0" in capsys.readouterr().out
    with ZipFile("swing.fmu") as archive:
        assert "sources/buildDescription.xml" in archive.namelist()
    description = fmpy.read_model_description("swing.fmu")
    assert description.unitDefinitions[0].baseUnit.factor == pytest.approx(np.pi / 180)
    assert main([*told, "--unit", "theta"]) == 2


def test_inverse_dynamics_in_fmi_3(tmp_path):
    """Forces of a motion are for co-simulation, and those of em.drive."""
    path = em.export_fmu(MODELS / "four_bar.py", tmp_path / "crank.fmu", inverse_dynamics=["q1"], fmi=3,
                         formulation="lagrange")  # fmt: skip
    assert validation.validate_fmu(str(path)) == []
    assert fmpy.read_model_description(str(path)).modelExchange is None
    turn = [(t, 0.5 + 2 * t, 2.0, 0.0) for t in np.linspace(0.0, 0.5, 51)]
    names = ("time", "q1", "der(q1)", "der(der(q1))")
    given = np.array(turn, dtype=[(name, float) for name in names])
    rows = stepped(path, 0.5, input=given, output=["force(q1)"])
    driven = em.drive(system_of("four_bar", "lagrange"), given["time"], {"q1": 0.5 + 2 * em.t})
    assert abs(rows["force(q1)"][1:] - driven.forces[0, :-1]).max() < 1e-9
