"""Functional Mock-up Units: what fmpy, which knows nothing of us, says of them and makes of them."""

import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from zipfile import ZipFile

import numpy as np
import pytest
from sympy import Rational, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Contact, Friction, Model, ModelError, multiplier, t
from eigenmotion.cli import main

from .generation import MODELS, system_for, system_of

fmpy = pytest.importorskip("fmpy")
fmi2 = pytest.importorskip("fmpy.fmi2")
validation = pytest.importorskip("fmpy.validation")

NAMES = ("dual_link", "furuta_pendulum")
TORQUE = np.array([(0.0, 0.02), (1.0, 0.02)], dtype=[("time", float), ("u", float)])


@pytest.fixture(scope="module", autouse=True)
def hurried() -> Iterator[None]:
    """Units are compiled in a hurry."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("EIGENMOTION_CFLAGS", "-O0")
        if shutil.which("clang") and "CC" not in os.environ:
            patch.setenv("CC", "clang")
        yield


@pytest.fixture(scope="module")
def units(tmp_path_factory) -> dict[str, Path]:
    folder = tmp_path_factory.mktemp("units")
    return {
        name: em.export_fmu(MODELS / f"{name}.py", folder / f"{name}.fmu", formulation=formulation)
        for name, formulation in zip(NAMES, ("eigenfactor", "lagrange"), strict=True)
    }


def simulated(unit, name, **options):
    """x and v at the end of a second, as fmpy finds them."""
    given = TORQUE if name == "furuta_pendulum" else None
    rows = fmpy.simulate_fmu(
        str(unit), stop_time=1.0, output_interval=0.01, relative_tolerance=1e-9, input=given, **options
    )
    assert rows["time"][-1] == pytest.approx(1.0)
    names = system_of(name).coordinates
    return np.array([rows[each][-1] for each in (*names, *(f"der({one})" for one in names))])


@pytest.mark.parametrize("name", NAMES)
def test_valid_and_the_same_motion(units, name):
    assert validation.validate_fmu(str(units[name])) == []
    inputs = {"u": 0.02} if name == "furuta_pendulum" else None
    run = system_of(name).simulate((0, 1), rtol=1e-11, atol=1e-14, inputs=inputs)
    found = simulated(units[name], name)
    assert np.abs(found - np.concatenate([run.x[:, -1], run.v[:, -1]])).max() < 1e-8


def test_others_can_compile_it(units, tmp_path):
    """fmpy builds it from its sources alone, and it moves the same."""
    build = pytest.importorskip("fmpy.build")
    if shutil.which("cmake") is None:
        pytest.skip("fmpy builds with cmake")
    made = tmp_path / "made"
    made.mkdir()
    fmpy.extract(str(units["dual_link"]), str(tmp_path / "unit"))
    shutil.rmtree(tmp_path / "unit" / "binaries")
    build.build_platform_binary(tmp_path / "unit", build_dir=made, configuration="Debug")
    assert list((tmp_path / "unit" / "binaries").rglob("dual_link.*"))
    assert simulated(tmp_path / "unit", "dual_link") == pytest.approx(
        simulated(units["dual_link"], "dual_link"), abs=1e-9
    )


class Unit:
    """One instance of a unit, by fmpy."""

    def __init__(self, path, folder, name="one"):
        self.description = fmpy.read_model_description(str(path))
        self.places = {variable.name: variable.valueReference for variable in self.description.modelVariables}
        self.said: list[str] = []
        if not folder.exists():
            fmpy.extract(str(path), str(folder))
        self.slave = fmi2.FMU2Slave(
            guid=self.description.guid, unzipDirectory=str(folder), instanceName=name,
            modelIdentifier=self.description.coSimulation.modelIdentifier,
        )  # fmt: skip
        self.slave.instantiate()

    def begin(self, **start):
        self.slave.setupExperiment(tolerance=1e-9, startTime=0.0)
        self.slave.enterInitializationMode()
        self.set(**start)
        self.slave.exitInitializationMode()
        return self

    def set(self, **values):
        self.slave.setReal([self.places[name] for name in values], list(values.values()))

    def get(self, *names):
        return self.slave.getReal([self.places[name] for name in names])

    def step(self, t, h):
        self.slave.doStep(currentCommunicationPoint=t, communicationStepSize=h)
        return self


NOW = ("theta", "phi", "der(theta)", "der(phi)", "height of the tip")


def test_states_go_back_to_the_last_bit(units, tmp_path):
    unit = Unit(units["furuta_pendulum"], tmp_path / "a").begin(u=0.01)
    for k in range(50):
        unit.step(0.01 * k, 0.01)
    state = unit.slave.getFMUstate()
    packed = unit.slave.serializeFMUstate(state)

    def on():
        unit.set(u=-0.02)
        for k in range(50, 80):
            unit.step(0.01 * k, 0.01)
        return unit.get(*NOW)

    first = on()
    unit.slave.setFMUstate(state)
    assert on() == first
    unit.slave.reset()
    unit.begin(m=0.2, phi=0.5)
    unit.step(0.0, 0.3)
    again = unit.slave.deSerializeFMUstate(packed)
    unit.slave.setFMUstate(again)
    assert on() == first
    unit.slave.freeFMUstate(state)
    unit.slave.freeFMUstate(again)
    unit.slave.terminate()
    unit.slave.freeInstance()


def test_parameters_start_and_outputs_by_their_names(units, tmp_path):
    unit = Unit(units["furuta_pendulum"], tmp_path / "a")
    unit.begin(m=0.15, phi=0.4, **{"der(theta)": 1.5})
    assert unit.get("m", *NOW[:4]) == pytest.approx([0.15, 0.0, 0.4, 1.5, 0.0], abs=1e-15)
    assert unit.get("height of the tip")[0] == pytest.approx(0.2 * np.cos(0.4))
    unit.step(0.0, 0.7)
    system = system_of("furuta_pendulum")
    run = system.simulate((0, 0.7), x0={"phi": 0.4}, v0={"theta": 1.5}, parameters={"m": 0.15}, rtol=1e-10, atol=1e-12)
    assert unit.get(*NOW[:2]) == pytest.approx(run.x[:, -1], abs=1e-7)
    assert unit.get("height of the tip")[0] == pytest.approx(run.outputs["height of the tip"][-1], abs=1e-7)


def test_two_instances_know_nothing_of_each_other(units, tmp_path):
    one = Unit(units["furuta_pendulum"], tmp_path / "a").begin(u=0.01)
    two = Unit(units["furuta_pendulum"], tmp_path / "a", "two").begin(u=0.03)
    for k in range(20):
        one.step(0.01 * k, 0.01)
        two.step(0.01 * k, 0.01)
    alone = Unit(units["furuta_pendulum"], tmp_path / "a", "three").begin(u=0.01)
    for k in range(20):
        alone.step(0.01 * k, 0.01)
    assert alone.get(*NOW) == one.get(*NOW)
    assert two.get("theta") != one.get("theta")


def test_what_it_refuses(units, tmp_path):
    """A start off the constraints; parameters on the way; numbers that are none."""
    unit = Unit(units["dual_link"], tmp_path / "dual_link")
    unit.slave.setupExperiment(startTime=0.0)
    unit.slave.enterInitializationMode()
    unit.set(**{"der(theta1)": 3.0})
    with pytest.raises(Exception, match="fmi2ExitInitializationMode failed"):
        unit.slave.exitInitializationMode()
    unit = Unit(units["furuta_pendulum"], tmp_path / "furuta").begin()
    unit.step(0.0, 0.1)
    for wrong in ({"m": 0.3}, {"phi": 0.1}, {"u": np.nan}):
        with pytest.raises(Exception, match="fmi2SetReal failed"):
            unit.set(**wrong)
    before = unit.get(*NOW)
    with pytest.raises(Exception, match="fmi2GetReal failed"):
        unit.slave.getReal([99])
    assert unit.get(*NOW) == before


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
def contact(tmp_path_factory) -> Path:
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


@pytest.mark.nightly
def test_the_same_model_gives_the_same_bytes(units, tmp_path):
    again = em.export_fmu(MODELS / "dual_link.py", tmp_path / "again.fmu")
    assert again.read_bytes() == units["dual_link"].read_bytes()


def test_from_the_command_line(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    model = str(MODELS / "pendulum.py")
    assert (
        main(["export", model, "--fmu", "swing.fmu", "--formulation", "lagrange", "--method", "rk4", "--step", "0.001"])
        == 0
    )
    assert "wrote swing.fmu" in capsys.readouterr().out
    with ZipFile("swing.fmu") as archive:
        assert "sources/pendulum.c" in archive.namelist()
    assert validation.validate_fmu("swing.fmu") == []
    rows = fmpy.simulate_fmu("swing.fmu", stop_time=1.0, output_interval=0.01)
    run = system_of("pendulum").simulate((0, 1), rtol=1e-11, atol=1e-12)
    assert rows["theta"][-1] == pytest.approx(run.x[0, -1], abs=1e-9)
    for wrong, words in (
        (["--fmu", "swing.zip"], "ends in .fmu"),
        (["--fmu", "nowhere/swing.fmu"], "no folder"),
        (["--fmu", "a.fmu", "--method", "rk4"], "step="),
    ):
        assert main(["export", model, *wrong]) == 2
        assert words in capsys.readouterr().err


def test_options_that_no_unit_has(tmp_path):
    for options, words in (
        ({"rtol": 0.0}, "rtol is 0.0"),
        ({"method": "Radau"}, "unknown method"),
        ({"step": 0.1}, "step="),
    ):
        with pytest.raises(ModelError, match=words):
            em.export_fmu(MODELS / "pendulum.py", tmp_path / "a.fmu", **options)
