"""Mistakes in the words of robots' files: what is left out, misspelt or no number is named, with its place."""

import contextlib
import io
from collections.abc import Iterator
from xml.etree import ElementTree as Xml

import pytest

import eigenmotion as em
from eigenmotion.cli import main

from ..support.example_robots import robot_file

pytest.importorskip("yourdfpy")

WHOLE = """<robot name="arm">
<link name="base"><visual><origin xyz="0 0 1"/><geometry><box size="1 1 1"/></geometry></visual></link>
<link name="rod"><inertial><origin xyz="0 0 1" rpy="0 0 0"/><mass value="2"/>
  <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
  <visual><geometry><cylinder radius="0.1" length="1"/></geometry></visual>
  <collision><geometry><sphere radius="1"/></geometry></collision></link>
<link name="tip"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1"/></inertial></link>
<joint name="swing" type="revolute"><parent link="base"/><child link="rod"/><axis xyz="0 1 0"/>
  <limit lower="-1" upper="1" effort="9" velocity="9"/><dynamics damping="0.1" friction="0"/></joint>
<joint name="bend" type="prismatic"><origin xyz="0 0 1" rpy="0 0.1 0"/><parent link="rod"/><child link="tip"/>
  <mimic joint="swing" multiplier="2" offset="0"/></joint>
</robot>"""
HINGE = """<mujoco model="m"><worldbody><body name="a" pos="0 0 1"><joint name="j" type="hinge" axis="0 0 1"/>
<geom type="sphere" size="0.1" mass="1"/></body></worldbody></mujoco>"""


@pytest.mark.parametrize(("old", "new", "words"), [
    (WHOLE, "", ": the file is empty."),
    (WHOLE, "hello", ": it is no XML: syntax error: line 1"),
    (WHOLE, WHOLE[:200], ": it is no XML: "),
    (WHOLE, "<model/>", ": it begins with <model>, and URDF with <robot name=...>."),
    (WHOLE, '<robot name="a" xmlns:xacro="x"><xacro:a/></robot>', ": it has elements of xacro. Expand them first"),
    (' name="arm"', "", ": <robot> has no attribute 'name'. Give it name=\"...\"."),
    (' name="rod"', "", ": <link> number 2 has no attribute 'name'."),
    (' type="revolute"', "", ": joint 'swing' has no attribute 'type'."),
    (' type="revolute"', ' tpye="revolute"', ": joint 'swing' has no attribute 'type'. Is its 'tpye' misspelt?"),
    ('<parent link="base"/>', "", ": joint 'swing' has no <parent>."),
    ('parent link="base"', "parent", ": joint 'swing': <parent> has no attribute 'link'."),
    ('axis xyz="0 1 0"', 'axis xyz="0 1"', ": joint 'swing': <axis>: xyz='0 1': 3 numbers are expected, not 2."),
    ('axis xyz="0 1 0"', 'axis xyz="0 1 y"', ": joint 'swing': <axis>: xyz='0 1 y': 3 numbers are expected."),
    ('axis xyz="0 1 0"', 'axis xyz="0 nan 0"', ": joint 'swing': <axis>: xyz='0 nan 0' is not finite."),
    ('lower="-1"', 'lower="2"', ": joint 'swing': <limit>: lower 2 is above upper 1."),
    ('mimic joint="swing"', "mimic", ": joint 'bend': <mimic> has no attribute 'joint'."),
    ('mimic joint="swing"', 'mimic joint="swung"', ": joint 'bend' is driven by 'swung', which is no joint."),
    ('damping="0.1"', 'damping="x"', ": joint 'swing': <dynamics>: damping='x': a number is expected."),
    ('damping="0.1"', 'dampin="0.1"', ": joint 'swing': <dynamics> has an attribute 'dampin', which URDF does"),
    ("inertial>", "inertal>", ": link 'rod' has an element <inertal>, which URDF does not know."),
    ('<mass value="2"/>', '<mass value="heavy"/>', ": link 'rod': <inertial><mass>: value='heavy': a number is"),
    (' size="1 1 1"', "", ": link 'base': <visual><geometry><box> has no attribute 'size'."),
    ('<box size="1 1 1"/>', "", ": link 'base': <visual><geometry> has no shape. Give it one of <box>"),
])  # fmt: skip
def test_urdf_is_told_the_place_and_the_remedy(tmp_path, capsys, old, new, words):
    """They ended with KeyError: 'name' or with "could not broadcast input array", or were taken without a word."""
    path = tmp_path / "arm.urdf"
    path.write_text(WHOLE.replace(old, new))
    with pytest.raises(em.ModelError) as error:
        em.load_urdf(path)
    assert str(error.value).startswith(f"{path}{words}")
    assert main(["explain", str(path)]) == 2
    assert words in capsys.readouterr().err


@pytest.mark.parametrize(("old", "new"), [
    ("</robot>", "<!-- <xacro:gripper reduction='1.0'/>\n <xacro:property name='pi' value='3.1'/> --></robot>"),
    ('effort="9" velocity="9"', 'effort="9" velocity="9" command_effort="7" current="3"'),
    ("</robot>", '<loop_joint name="loop" type="revolute"/></robot>'),
])  # fmt: skip
def test_files_with_extensions_and_comments_are_read(tmp_path, old, new):
    """ANYmal's limits have a command_effort beside their effort; Talos has calls of xacro in comments."""
    path = tmp_path / "arm.urdf"
    path.write_text(WHOLE.replace(old, new))
    assert em.load_urdf(path).n == 1


UNREADABLE = {"alex_psyonic_hands", "quadrotor_base", "iris_simple", "ur3"}
"""A mimic that names no joint, two bodies without a joint, and a file without a name."""


@pytest.mark.nightly("other people's files: where example-robot-data is installed")
def test_other_peoples_files_are_read():
    refused = set()
    for path in robot_file("ur_description/urdf/ur5_robot.urdf").parents[2].rglob("*.urdf"):
        try:
            em.load_urdf(path)
        except em.ModelError:
            refused.add(path.stem)
    assert refused == UNREADABLE


def spoilt() -> Iterator[tuple[str, str]]:
    """Give files in which an element or attribute is missing, or a value is no number, not finite or unknown."""
    count = len(list(Xml.fromstring(WHOLE).iter()))
    for k in range(1, count):
        root = Xml.fromstring(WHOLE)
        element = list(root.iter())[k]
        next(one for one in root.iter() if element in list(one)).remove(element)
        yield f"without <{element.tag}>", Xml.tostring(root, encoding="unicode")
    for k in range(count):
        for name in list(Xml.fromstring(WHOLE).iter())[k].attrib:
            for value in (None, "", "x", "nan", "-inf", "0", "0 0 0", "1 2 3 4"):
                root = Xml.fromstring(WHOLE)
                element = list(root.iter())[k]
                element.attrib.pop(name) if value is None else element.set(name, value)
                yield f"<{element.tag}> {name}={value}", Xml.tostring(root, encoding="unicode")


def test_no_mistake_ends_in_an_error_of_another_kind(tmp_path):
    """Each single mistake is refused by name, or the file is a robot still."""
    path, told = tmp_path / "arm.urdf", []
    for what, text in spoilt():
        path.write_text(text)
        try:
            with contextlib.redirect_stderr(io.StringIO()):
                em.load_urdf(path)
        except em.ModelError as error:
            told.append((what, str(error)))
    assert len(told) > 150
    assert not [one for one in told if not one[1].startswith(f"{path}: ") or "yourdfpy" in one[1]]


def test_comments_may_be_in_another_encoding(tmp_path):
    path = tmp_path / "arm.urdf"
    path.write_bytes(WHOLE.replace("</robot>", "<!-- Gr\xf6\xdfe --></robot>").encode("latin-1"))
    assert em.load_urdf(path).n == 1


@pytest.mark.parametrize(("old", "new", "words"), [
    ('axis="0 0 1"', 'axis="0 nan 1"', ": joint 'j': its axis is not finite: [0.0, nan, 1.0]."),
    ('pos="0 0 1"', 'pos="0 0 nan"', ": body 'a': its place is not finite: [0.0, 0.0, nan]."),
    ('name="j"', 'name="\xe9"', ": a name is not in UTF-8 ("),
    ("hinge", "spin", ": MuJoCo cannot read it: XML Error: invalid keyword: 'spin' Element 'joint', line 1"),
])  # fmt: skip
def test_mjcf_is_told_the_place(tmp_path, old, new, words):
    """NaN was found late, without the name of the file; a name in another encoding ended in UnicodeDecodeError."""
    pytest.importorskip("mujoco")
    path = tmp_path / "m.xml"
    path.write_bytes(HINGE.replace(old, new).encode("latin-1"))
    with pytest.raises(em.ModelError) as error:
        em.load_mjcf(path)
    assert str(error.value).startswith(f"{path}{words}")
