"""Reading of URDF files: names, notes, drawings, refusals; and the command line."""

import logging
import math

import numpy as np
import pytest
import sympy

import eigenmotion as em
from eigenmotion.cli import main
from eigenmotion.robots.names import identifiers
from tests.support.urdf_texts import joint, link, robot

pytest.importorskip("yourdfpy", reason="URDF files are read by yourdfpy: pip install 'eigenmotion[robots]'")

ROD = link("rod", 1.0, center=(0, 0, -0.5), inertia=(0.1, 0, 0, 0.1, 0, 0.01))


@pytest.fixture
def write(tmp_path):
    def written(*elements, name="robot"):
        path = tmp_path / f"{name}.urdf"
        path.write_text(robot(*elements, name=name))
        return path

    return written


def swing(child="rod", name="swing", **more):
    return joint(name, "continuous", "base", child, axis=(0, 1, 0), **more)


def test_names_become_identifiers(write):
    assert identifiers(["left-knee", "left knee", "t", "double", "2nd", "lambda", "a", "__b"]) == {
        "left-knee": "left_knee", "left knee": "left_knee_2", "t": "t_", "double": "double_", "2nd": "n2nd",
        "lambda": "lambda_", "a": "a", "__b": "_b",
    }  # fmt: skip
    made = em.read_urdf(write(link("base"), ROD, swing(name="hip.joint"), name="my robot-1"))
    assert made.name == "my_robot_1"
    assert [one.func.__name__ for one in made.coordinates] == ["hip_joint"]
    assert made.torques["hip.joint"].func.__name__ == "tau_hip_joint"


def test_numbers_of_joints_are_there(write):
    more = '<limit lower="-1" upper="2" effort="30" velocity="4"/><dynamics damping="0.2" friction="0.1"/>'
    made = em.read_urdf(write(link("base"), ROD, joint("j", "revolute", "base", "rod", axis=(0, 0, 3), more=more)))
    one = made.joints["j"]
    assert (one.lower, one.upper, one.effort, one.velocity) == (-1.0, 2.0, 30.0, 4.0)
    assert (one.damping, one.friction, one.axis) == (0.2, 0.1, (0.0, 0.0, 1.0))


def test_what_is_not_used_is_said_by_explain(write, capsys):
    shape = '<collision><geometry><box size="1 1 1"/></geometry></collision>'
    path = write(link("base"), ROD.replace("</link>", f"{shape}</link>"),
                 swing(more='<dynamics friction="0.5"/><limit effort="3" velocity="1"/>'))  # fmt: skip
    assert main(["explain", str(path)]) == 0
    said = capsys.readouterr().out.partition("\nNotes\n")[2]
    assert "1 collision shapes are not used: no contacts" in said
    assert "friction is not used; Robot.frictions gives it to contacts: swing" in said
    assert "limits of efforts and velocities are not used: swing" in said


def test_impossible_inertias_are_warned_of_and_taken(write, caplog):
    """5 > 1 + 1: no body; the pendulum has it all the same."""
    path = write(link("base"), link("odd", 1.0, inertia=(1, 0, 0, 5, 0, 1)), swing("odd"))
    with caplog.at_level(logging.WARNING, logger="eigenmotion"):
        made = em.read_urdf(path)
    assert "link 'odd': its principal moments 1, 1, 5 kg m^2 violate the triangle inequality" in caplog.text
    system = em.build(made.model())
    assert system.acceleration([0.3], [0.0], inputs={"tau_swing": 2.0})[0][0] == pytest.approx(2 / 5, rel=1e-12)


def test_a_massless_link_between_others_is_no_mistake(write):
    """Two joints in one pin, the link between them massless: M of a point mass on a universal joint."""
    second = joint("second", "continuous", "cross", "rod", axis=(1, 0, 0))
    made = em.read_urdf(write(link("base"), link("cross"), ROD, swing("cross", "first"), second), gravity=(0, 0, 0))
    M = em.build(made.model()).mass_matrix([0.2, 0.7], 0.0)
    first = (0.1 + 0.25) * math.cos(0.7) ** 2 + 0.01 * math.sin(0.7) ** 2
    assert np.abs(M - np.diag([first, 0.35])).max() < 1e-14


def test_a_joint_that_moves_nothing_is_named(write):
    path = write(link("base"), ROD, link("tip"), swing(), joint("twist", "continuous", "rod", "tip", axis=(0, 0, 1)))
    with pytest.raises(em.ModelError, match="'twist' moves no mass"):
        em.build(em.load_urdf(path))
    assert em.load_urdf(path, locked=["twist"]).n == 1
    point = write(link("base"), link("tip", 1.0, center=(0, 0, 0.3)), joint("twist", "continuous", "base", "tip",
                  axis=(0, 0, 1)), name="point")  # fmt: skip
    with pytest.raises(em.ModelError, match="'twist' moves no mass"):
        em.build(em.load_urdf(point))


def test_a_drawing_is_lines_between_joints(write):
    made = em.read_urdf(write(link("base"), ROD, link("camera"), link("hand", 0.1),
                              swing(xyz=(0, 0, 2)), joint("mount", "fixed", "rod", "camera", xyz=(1, 0, 0)),
                              joint("palm", "fixed", "rod", "hand", xyz=(0, 0, -1))))  # fmt: skip
    first, second = made.drawing  # of the camera, which has no mass, there is no line
    assert list(first.p) == [0, 0, 0]
    assert list(first.q) == [0, 0, 2]
    assert second.p == made.bodies["rod"].position()
    assert second.q == made.bodies["rod"].position((0, 0, -1))


def test_models_of_a_robot_have_what_is_added(write):
    made = em.read_urdf(write(link("base"), ROD, swing()))
    (q,) = made.coordinates
    k = sympy.Symbol("k", positive=True)
    model = made.model(name="sprung", potential_energy=k * q**2 / 2, forces={q: -q.diff()}, parameters={k: 3.0})
    assert model.name == "sprung"
    a, _ = em.build(model).acceleration([0.4], [0.5], inputs={"tau_swing": 1.0})
    assert a[0] == pytest.approx((1.0 - 0.5 - 3 * 0.4 - 9.81 * 0.5 * math.sin(0.4)) / 0.35, rel=1e-12)


TWO = (link("base"), ROD, swing())


@pytest.mark.parametrize(("elements", "arguments", "words"), [
    ((*TWO, swing(name="other")), {}, "child of two joints, 'swing' and 'other'"),
    ((*TWO, swing("rode", "other")), {}, "names a link 'rode'. Did you mean 'rod'"),
    ((*TWO, link("alone", 1.0)), {}, "base, alone have no parent"),
    ((*TWO, ROD), {}, "two links are named 'rod'"),
    ((link("base"), ROD, joint("a", "hinge", "base", "rod")), {}, "joint 'a' is 'hinge'. Give one of"),
    ((link("base"), ROD, joint("a", "revolute", "base", "rod", axis=(0, 0, 0))), {}, "its axis is [0.0, 0.0, 0.0]"),
    ((link("base"), ROD, joint("a", "fixed", "base", "rod")), {}, "none of its joints moves"),
    ((link("base"), ROD, swing(more='<mimic joint="b"/>')), {}, "driven by 'b', which is no joint"),
    ((link("base"), ROD, swing(more='<mimic joint="swing"/>')), {}, "driven by itself: swing <- swing"),
    (TWO, {"locked": ["swin"]}, "locked names 'swin', which is no joint. Did you mean 'swing'"),
    (TWO, {"base": "free"}, "base is 'free'. Give 'fixed' or 'floating'"),
    (TWO, {"close": {"pin": ("rod", (0, 0, 0))}}, "Give (link_a, point_a, link_b, point_b)"),
    (TWO, {"close": {"pin": ("rod", (0, 0, 0), "bas", (0, 0, 0))}}, "'bas', which is no link. Did you mean 'base'"),
])  # fmt: skip
def test_mistakes_are_named(write, elements, arguments, words):
    path = write(*elements)
    with pytest.raises(em.ModelError) as error:
        em.load_urdf(path, **arguments)
    assert words in str(error.value)


def test_files_that_cannot_be_read_are_named(tmp_path, write, monkeypatch):
    with pytest.raises(em.ModelError, match=r"none\.urdf.*No such file"):
        em.load_urdf(tmp_path / "none.urdf")
    (tmp_path / "broken.urdf").write_text("<robot name='a'><link")
    with pytest.raises(em.ModelError, match=r"broken\.urdf"):
        em.load_urdf(tmp_path / "broken.urdf")
    path = write(*TWO)
    monkeypatch.setattr("eigenmotion.robots.urdf.find_spec", lambda name: None)
    with pytest.raises(em.ModelError, match=r"pip install 'eigenmotion\[robots\]'"):
        em.load_urdf(path)


def test_commands_take_files_of_robots(write, tmp_path, capsys):
    path = write(*TWO, name="swinging")
    saved = tmp_path / "run.csv"
    assert main(["run", str(path), "--t-end", "1", "--save", str(saved)]) == 0
    assert saved.read_text().startswith("t [s],swing [rad],swing' [rad/s]")
    assert em.load_model(path, base="floating", locked="swing").n == 6
    with pytest.raises(em.ModelError, match="a robot has no argument `gravity` for texts"):
        em.load_model(path, gravity="0")
    other = tmp_path / "same.xml"
    other.write_text(path.read_text())
    assert em.load_model(other).n == 1
