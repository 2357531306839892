"""Units of inverse dynamics: a motion is set, by fmpy, and forces are read."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from sympy import cos, lambdify, sin

import eigenmotion as em
from eigenmotion import ModelError
from eigenmotion.cli import main

from ..driving import linkages
from ..support.fmu_slaves import Unit, fmpy
from ..support.generation import MODELS, system_of

validation = pytest.importorskip("fmpy.validation")
pytestmark = pytest.mark.usefixtures("hurried")


def spelled(names, x, v, a):
    """Inputs by name."""
    orders = zip(("{}", "der({})", "der(der({}))"), (x, v, a), strict=True)
    return {text.format(name): value for text, values in orders for name, value in zip(names, values, strict=True)}


def exported(folder, name, formulation="lagrange", **options) -> Path:
    return em.export_fmu(MODELS / f"{name}.py", folder / f"{name}.fmu", formulation=formulation, **options)


@pytest.fixture(scope="module")
def crank(tmp_path_factory, hurried) -> Path:
    """A four-bar with the motion of its crank."""
    return exported(tmp_path_factory.mktemp("crank"), "four_bar", inverse_dynamics=["q1"])


def turned(unit, angle, rate=2.0, second=0.0):
    unit.set(**spelled(["q1"], [angle], [rate], [second]))
    return unit


def test_torques_of_an_arm(tmp_path):
    """By its inputs, at random motions, with another parameter; a valid unit whose forces are those of Python."""
    system = system_of("puma", "lagrange")
    names, torques = system.coordinates, tuple(system.inputs)
    path = exported(tmp_path, "puma", inverse_dynamics=torques)
    assert validation.validate_fmu(str(path)) == []
    unit = Unit(path, tmp_path / "a").begin(load=2.5)
    draws = np.random.default_rng(1)
    for k in range(20):
        x, v, a = draws.normal(size=(3, 6))
        unit.set(**spelled(names, x, v, a))
        expected = system.inverse_dynamics(x, v, a, actuators=torques, parameters={"load": 2.5}).forces
        assert unit.get(*torques) == pytest.approx(expected, rel=1e-12, abs=1e-12 * abs(expected).max())
        unit.step(0.01 * k, 0.01)
        assert unit.get(*torques) == pytest.approx(expected, rel=1e-12, abs=1e-12 * abs(expected).max())


def test_a_crank_turns_and_the_loop_follows(crank, tmp_path):
    assert validation.validate_fmu(str(crank)) == []
    times = np.linspace(0.0, 4.0, 81)
    turn = em.drive(system_of("four_bar", "lagrange"), times, {"q1": 0.5 + 2 * em.t}, parameters={"density": 3.0})
    unit = turned(Unit(crank, tmp_path / "a"), 0.5)
    unit.begin(density=3.0)
    found = []
    for before, t in zip((0.0, *times), times, strict=False):
        turned(unit, 0.5 + 2 * t).step(before, t - before)
        found.append(unit.get("force(q1)", "q2", "q3", "der(q2)", "der(q3)", "der(der(q2))", "der(der(q3))"))
    expected = np.vstack([turn.forces, turn.x[1:], turn.v[1:], turn.a[1:]]).T
    assert np.abs(found - expected).max() < 1e-11 * np.abs(expected).max()


def test_long_steps_stay_on_the_branch(crank, tmp_path):
    """Turned by steps of more than half a turn, it is where small steps lead; a guess chooses the other branch."""
    system = system_of("four_bar", "lagrange")
    unit = turned(Unit(crank, tmp_path / "a"), 0.5).begin()
    for k in range(1, 6):
        turned(unit, 0.5 + 4.0 * k).step(k - 1.0, 1.0)
    turn = em.drive(system, np.linspace(0.0, 5.0, 501), {"q1": 0.5 + 4 * em.t})
    assert unit.get("q2", "q3") == pytest.approx(turn.x[1:, -1], abs=1e-12)
    below = turned(Unit(crank, tmp_path / "a", "other"), 0.5).begin(q2=-1.0, q3=-2.0)
    other = em.assemble(system, [0.5, -1.0, -2.0], keep=["q1"]).x
    assert below.get("q2", "q3") == pytest.approx(other[1:], abs=1e-12)
    assert abs(below.get("q3")[0] - turn.x[2, 0]) > 1.0


def test_what_is_tried_between_steps_has_no_effect(crank, tmp_path):
    """Forces depend on the last step and on what is set now, to the last bit."""
    unit = turned(Unit(crank, tmp_path / "a"), 0.5).begin().step(0.0, 0.1)
    first = turned(unit, 0.7).get("force(q1)", "q2")
    turned(unit, 3.0).get("force(q1)")
    turned(unit, -2.0).get("force(q1)")
    assert turned(unit, 0.7).get("force(q1)", "q2") == first


def test_states_go_back_to_the_last_bit(crank, tmp_path):
    unit = turned(Unit(crank, tmp_path / "a"), 0.5).begin()
    for k in range(5):
        turned(unit, 0.5 + 0.3 * k).step(0.1 * k, 0.1)
    state = unit.slave.getFMUstate()
    packed = unit.slave.serializeFMUstate(state)

    def on():
        found = [unit.get("force(q1)", "q2", "der(der(q3))")]
        for k in range(5, 9):
            turned(unit, 0.5 + 0.3 * k).step(0.1 * k, 0.1)
            found.append(unit.get("force(q1)", "q2", "der(der(q3))"))
        return found

    first = on()
    unit.slave.setFMUstate(state)
    assert on() == first
    unit.slave.reset()
    turned(unit, 2.0).begin(density=4.0).step(0.0, 0.3)
    again = unit.slave.deSerializeFMUstate(packed)
    unit.slave.setFMUstate(again)
    assert on() == first
    unit.slave.freeFMUstate(state)
    unit.slave.freeFMUstate(again)


def test_the_motion_of_all_coordinates(tmp_path):
    """Of a nonholonomic mechanism: more actuators than freedoms share the load; a motion off a row names it."""
    system = system_of("dual_link", "lagrange")
    every = tuple(system.coordinates)
    with pytest.raises(ModelError, match="nonholonomic"):
        exported(tmp_path, "dual_link", inverse_dynamics=every[:3])
    path = exported(tmp_path, "dual_link", inverse_dynamics=dict.fromkeys(every, 2.0))
    assert validation.validate_fmu(str(path)) == []
    unit = Unit(path, tmp_path / "a").begin()
    draws = np.random.default_rng(2)
    for _ in range(10):
        x, v = system.project_initial_state(draws.normal(size=4), draws.normal(size=4))
        a, _ = system.acceleration(x, v)
        free = np.linalg.svd(system.compiled.pfaffian(0.0, x, system.prepare(None))[0])[2][1:]
        a = a + draws.normal(size=3) @ free
        unit.set(**spelled(every, x, v, a))
        expected = system.inverse_dynamics(x, v, a, actuators=dict.fromkeys(every, 2.0)).forces
        found = unit.get(*(f"force({name})" for name in every))
        assert found == pytest.approx(expected, rel=1e-12, abs=1e-12 * abs(expected).max())
    unit.set(**{f"der({every[0]})": 7.0})
    with pytest.raises(Exception, match="fmi2GetReal failed"):
        unit.get(f"force({every[0]})")
    assert "the velocities do not satisfy constraint" in unit.words


def test_dead_centres_and_what_is_out_of_reach(tmp_path):
    """A slider moves its crank until that is stretched; the unit then stays where it was."""
    path = exported(tmp_path, "slider_crank", inverse_dynamics=["theta"], motion=["x"])
    unit = Unit(path, tmp_path / "a")
    unit.begin(x=1.1)
    unit.set(x=1.2)
    unit.step(0.0, 0.1)
    before = unit.get("force(theta)", "theta")
    for x in (1.3, 1.5, 0.5):
        unit.set(x=x)
        with pytest.raises(Exception, match="fmi2DoStep failed"):
            unit.step(0.1, 0.1)
        assert "a dead centre, at which x does not determine theta and phi" in unit.words
    unit.set(x=1.2)
    assert unit.get("force(theta)", "theta") == pytest.approx(before, rel=1e-13)
    unit = Unit(path, tmp_path / "a", "two")
    with pytest.raises(Exception, match="fmi2ExitInitializationMode failed"):
        unit.begin(x=4.0)
    assert "a dead centre" in unit.words
    unit = Unit(path, tmp_path / "a", "three")
    with pytest.raises(Exception, match="fmi2ExitInitializationMode failed"):
        unit.begin(x=4.0, theta=1.0, phi=0.7)
    assert "the mechanism does not close: constraint number" in unit.words


def test_what_is_not_exported(tmp_path):
    for name, options, words in (
        ("furuta_pendulum", {"inverse_dynamics": ["u"]}, "2 degrees of freedom, and 1 actuator"),
        ("four_bar", {"inverse_dynamics": ["q4"]}, "q4"),
        ("four_bar", {"inverse_dynamics": ["q1"], "motion": ["q9"]}, "q9"),
        ("four_bar", {"inverse_dynamics": ["q1", "q2"]}, "motion of 2 coordinates"),
        ("four_bar", {"motion": ["q1"]}, "give inverse_dynamics="),
        ("four_bar", {"inverse_dynamics": ["q1"], "rtol": 1e-3}, "rtol= is for units that move"),
    ):
        with pytest.raises(ModelError, match=words):
            exported(tmp_path, name, **options)


def test_from_the_command_line(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    model = str(MODELS / "four_bar.py")
    options = ["--fmu", "inverse.fmu", "--formulation", "lagrange", "--inverse", "q1, q3", "--path", "q3"]
    assert main(["export", model, *options]) == 0
    assert "wrote inverse.fmu" in capsys.readouterr().out
    rows = fmpy.simulate_fmu("inverse.fmu", stop_time=0.2, output_interval=0.1, output=["force(q1)", "force(q3)"])
    assert rows["force(q1)"][0] == rows["force(q1)"][-1] != 0.0
    assert main(["export", model, *options, "--method", "rk4"]) == 2
    assert "method= is for units that move" in capsys.readouterr().err


def test_rows_that_follow_from_others(tmp_path, crank):
    """A loop with a third row, the sum of the two others, moves by the same torque."""
    whole = em.load_model(MODELS / "four_bar.py")
    across, up = whole.holonomic_constraints
    more = replace(whole, name="redundant", holonomic_constraints=[across + up, across, up])
    path = em.export_fmu(more, tmp_path / "more.fmu", formulation="lagrange", inverse_dynamics=["q1"])
    names = ("force(q1)", "q2", "q3", "der(q3)", "der(der(q2))")
    found = []
    for one in (path, crank):
        unit = turned(Unit(one, tmp_path / one.stem), 0.5).begin()
        for k in range(1, 20):
            turned(unit, 0.5 + 0.4 * k, 4.0, 1.0).step(0.1 * k - 0.1, 0.1)
        found.append(unit.get(*names))
    assert found[0] == pytest.approx(found[1], rel=1e-12)


def test_pivot_that_moves_by_itself(tmp_path):
    """Constraints that depend on the time, and an output."""
    whole = em.load_model(MODELS / "driven_pendulum.py")
    _, y = whole.coordinates
    seen = replace(whole, outputs={"height": y + em.t, "pull": em.multiplier(0), "fall": y.diff(em.t, 2)})
    path = em.export_fmu(seen, tmp_path / "pull.fmu", formulation="lagrange", inverse_dynamics=["x"])
    assert validation.validate_fmu(str(path)) == []
    unit = Unit(path, tmp_path / "a").begin()
    times = np.linspace(0.0, 2.0, 41)
    start = float(em.build(seen, formulation="lagrange").begin()[0][0])
    found = []
    for before, t in zip((0.0, *times), times, strict=False):
        swing = start * np.cos(t), -start * np.sin(t), -start * np.cos(t)
        unit.set(**dict(zip(("x", "der(x)", "der(der(x))"), swing, strict=True)))
        unit.step(before, t - before)
        found.append(unit.get("force(x)", "y", "height", "pull", "fall"))
    run = em.drive(em.build(seen, formulation="lagrange"), times, {"x": start * cos(em.t)})
    expected = np.vstack([run.forces, run.x[1:], *(run.outputs[name] for name in ("height", "pull", "fall"))]).T
    assert np.abs(found - expected).max() < 1e-11 * np.abs(expected).max()


def test_bristles_are_inputs(tmp_path):
    """The value of a first-order state is set."""
    path = exported(tmp_path, "lugre_oscillator", inverse_dynamics=["x"])
    assert validation.validate_fmu(str(path)) == []
    system = system_of("lugre_oscillator", "lagrange")
    unit = Unit(path, tmp_path / "a").begin()
    for z in (0.0, 1e-5, -2e-5):
        unit.set(z=z, **spelled(["x"], [0.1], [0.05], [3.0]))
        expected = system.inverse_dynamics({"x": 0.1, "z": z}, [0.05], [3.0]).forces
        assert unit.get("force(x)") == pytest.approx(expected, rel=1e-13)


def test_rounding_is_no_obstacle(tmp_path):
    """All coordinates of the gripper are zero where it starts, and so are all terms of its loops."""
    path = exported(tmp_path, "gripper", inverse_dynamics=["plunger"], motion=["left_pad"])
    unit = Unit(path, tmp_path / "a").begin(left_pad=0.01)
    unit.set(left_pad=0.02)
    unit.step(0.0, 0.1)
    names = ("plunger", "left_crank", "left_rocker", "left_pad", "right_crank", "right_rocker", "right_pad")
    system = system_of("gripper", "lagrange")
    expected = em.assemble(system, unit.get(*names), keep=["left_pad"]).x
    assert unit.get(*names) == pytest.approx(expected, abs=1e-14)


@pytest.mark.nightly
@pytest.mark.parametrize(
    ("name", "motors", "moved"), [("six_bar", ["u0"], ["q1"]), ("delta", ["u_a", "u_b", "u_c"], ["x", "y", "z"])]
)
def test_motors_of_linkages(tmp_path, name, motors, moved):
    """Inputs that act, behind loops that close from a rough start."""
    model = getattr(linkages, name)()
    path = em.export_fmu(model, tmp_path / "moved.fmu", inverse_dynamics=motors, motion=moved)
    system = em.build(model)
    start = dict(zip(system.coordinates, system.begin()[0], strict=True))
    paths = {one: float(start[one]) + 0.05 * sin((2 + k) * em.t) for k, one in enumerate(moved)}
    times = np.linspace(0.0, 2.0, 201)
    unit, found = Unit(path, tmp_path / "a"), []
    motions = [[lambdify(em.t, one.diff(em.t, order)) for one in paths.values()] for order in range(3)]
    for before, t in zip((0.0, *times), times, strict=False):
        unit.set(**spelled(moved, *([float(at(t)) for at in row] for row in motions)))
        if not found:
            unit.begin()
        unit.step(before, t - before)
        found.append(unit.get(*motors))
    driven = em.drive(system, times, paths, actuators=motors)
    assert np.abs(np.array(found).T - driven.forces).max() < 1e-11 * np.abs(driven.forces).max()
