"""Functional Mock-up Units: what fmpy, which knows nothing of us, says of them and makes of them."""

import re
import shutil
from pathlib import Path
from zipfile import ZipFile

import numpy as np
import pytest
from sympy import Symbol
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import ModelError
from eigenmotion.cli import main

from ..support.fmu_slaves import Unit, fmpy
from ..support.generation import MODELS, system_of

validation = pytest.importorskip("fmpy.validation")
pytestmark = pytest.mark.usefixtures("hurried")

NAMES = ("dual_link", "furuta_pendulum")
TORQUE = np.array([(0.0, 0.02), (1.0, 0.02)], dtype=[("time", float), ("u", float)])


@pytest.fixture(scope="module")
def units(tmp_path_factory, hurried) -> dict[str, Path]:
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


@pytest.mark.parametrize("fmi", [2, 3])
def test_rows_that_depend_on_each_other_share_the_force(tmp_path, fmi):
    """A bob on a rod that two rows hold: its swing, and by least norm a force in proportion to the rows."""
    x, y = dynamicsymbols("x y")
    rod = (x**2 + y**2 - 1) / 2
    model = em.Model(name="twice_held", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
                     potential_energy=9.81 * y, holonomic_constraints=[rod, 2 * rod], initial={x: 1e-4, y: -1 + 5e-9},
                     outputs={"one": em.multiplier(0), "two": em.multiplier(1)})  # fmt: skip
    unit = em.export_fmu(model, tmp_path / "unit.fmu", formulation="lagrange", fmi=fmi)
    quarter = np.pi / 2 / np.sqrt(9.81)
    for kind in ("CoSimulation", "ModelExchange"):
        rows = fmpy.simulate_fmu(str(unit), stop_time=quarter, output_interval=quarter / 50, relative_tolerance=1e-9,
                                 fmi_type=kind, output=["x", "y", "der(der(y))", "one", "two"])  # fmt: skip
        assert np.abs(rows["x"] - 1e-4 * np.cos(np.sqrt(9.81) * rows["time"])).max() < 1e-8
        assert rows["y"][-1] == pytest.approx(-1, abs=1e-8)
        assert rows["one"][-1] == pytest.approx(9.81 / 5, rel=1e-6)
        assert rows["two"] == pytest.approx(2 * rows["one"], rel=1e-9)


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


@pytest.mark.parametrize(("name", "fmi"), [("x", 2), ("x", 3), ("time", 3)])
def test_a_name_of_two_numbers_is_named(tmp_path, name, fmi):
    x, mass = dynamicsymbols("x"), Symbol("time" if name == "time" else "mass")
    model = em.Model(name="named", coordinates=[x], kinetic_energy=mass * x.diff() ** 2 / 2, parameters={mass: 1.0},
                     outputs={"x": x**2} if name == "x" else {})  # fmt: skip
    with pytest.raises(ModelError, match=f"named: two numbers of the unit have one name, {name}, "):
        em.export_fmu(model, tmp_path / "unit.fmu", fmi=fmi, formulation="lagrange")


def test_options_that_no_unit_has(tmp_path):
    for options, words in (
        ({"rtol": 0.0}, "rtol is 0.0"),
        ({"method": "Radau"}, "is SciPy's"),
        ({"step": 0.1}, "step="),
    ):
        with pytest.raises(ModelError, match=words):
            em.export_fmu(MODELS / "pendulum.py", tmp_path / "a.fmu", **options)


@pytest.mark.parametrize("name", ["a\x1bb", "a\nb", "a\tb", "\ufffe", "\x85"])
def test_a_name_that_no_xml_holds_is_refused_by_name(tmp_path, name):
    """One of a control character made the description of a unit unreadable."""
    x, p = dynamicsymbols("x"), Symbol(name)
    model = em.Model(name="named", coordinates=[x], kinetic_energy=p * x.diff() ** 2, parameters={p: 1.0})
    with pytest.raises(ModelError, match=f"named: {re.escape(repr(name))} has a character.*XML"):
        em.export_fmu(model, tmp_path / "named.fmu", formulation="lagrange")


DECLARED = """\
from sympy import Symbol
from sympy.physics.mechanics import dynamicsymbols
from eigenmotion import Model
x, u = dynamicsymbols("x", positive=True), dynamicsymbols("u", nonnegative=True)
m, teeth = Symbol("m", positive=True), Symbol("teeth", integer=True)
model = Model(name="declared", coordinates=[x], kinetic_energy=m * x.diff() ** 2 / 2, potential_energy=teeth * x,
              forces={x: u}, parameters={m: 1.0, teeth: 3.0}, inputs={u: 0.0}, initial={x: 2.0})
"""


def test_numbers_that_were_not_declared_are_refused_by_name(scene, tmp_path):
    """A parameter declared positive, or an integer, is that in a unit, too, as it is set."""
    scene.write_text(DECLARED)
    unit = Unit(em.export_fmu("scene.py", "declared.fmu", formulation="lagrange"), tmp_path / "declared")
    for name, value in (("m", -1.0), ("teeth", 0.5), ("x", 0.0), ("u", -1.0)):
        with pytest.raises(fmpy.fmi1.FMICallException):
            unit.set(**{name: value})
    unit.begin(m=2.0, teeth=-1.0, x=1.0, u=1.0).step(0.0, 1.0)
    assert unit.get("x") == pytest.approx([1.5])
    with pytest.raises(fmpy.fmi1.FMICallException):
        unit.set(u=-1.0)
