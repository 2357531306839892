"""Drawings of robots: boxes, cylinders, balls and the hulls of meshes, at the places of their links."""

import numpy as np
import pytest
import trimesh
from scipy.spatial import ConvexHull

import eigenmotion as em
from eigenmotion.robots.drawing.solids import capsule, directions, hull
from eigenmotion.webpage.page_object import with_meshes

ROBOT = """<robot name="shown">
  <link name="base">
    <visual><origin xyz="0 0 0.5" rpy="0 1.5707963267948966 0"/>
      <geometry><cylinder radius="0.1" length="1"/></geometry></visual>
  </link>
  <link name="rod"><inertial><origin xyz="0 0 -1"/><mass value="1"/></inertial>
    <visual><geometry><box size="0.2 0.4 0.6"/></geometry></visual>
    <visual><origin xyz="0 0 -1"/>
      <geometry><mesh filename="package://parts/meshes/block.stl" scale="2 2 2"/></geometry></visual>
    <visual><geometry><mesh filename="package://parts/meshes/none.stl"/></geometry></visual>
  </link>
  <joint name="pin" type="continuous"><parent link="base"/><child link="rod"/><axis xyz="0 1 0"/></joint>
</robot>"""


@pytest.fixture
def robot(tmp_path):
    """A pendulum in a package, with a mesh of its own."""
    for folder in ("urdf", "meshes"):
        (tmp_path / "parts" / folder).mkdir(parents=True)
    trimesh.creation.box((0.1, 0.1, 0.3)).export(tmp_path / "parts" / "meshes" / "block.stl")
    file = tmp_path / "parts" / "urdf" / "shown.urdf"
    file.write_text(ROBOT)
    return file


def extent(points):
    return np.array([points.min(axis=0), points.max(axis=0)])


def test_links_are_where_the_file_says(robot):
    system = em.build(em.load_urdf(robot, meshes=True))
    base, box, mesh = (shape.points[0] for shape in system.simulate((0, 0.01)).drawing.shapes)
    assert extent(base) == pytest.approx(np.array([[-0.5, -0.1, 0.4], [0.5, 0.1, 0.6]]), abs=1e-6)
    assert extent(box) == pytest.approx(np.array([[-0.1, -0.2, -0.3], [0.1, 0.2, 0.3]]), abs=1e-6)
    assert extent(mesh) == pytest.approx(np.array([[-0.1, -0.1, -1.3], [0.1, 0.1, -0.7]]), abs=1e-6)
    turned = system.simulate((0, 0.01), x0={"pin": np.pi / 2}).drawing.shapes[2].points[0]
    assert extent(turned) == pytest.approx(np.array([[-1.3, -0.1, -0.1], [-0.7, 0.1, 0.1]]), abs=1e-6)


def test_meshes_that_are_not_there_are_named(robot):
    notes = em.read_urdf(robot, meshes=True).notes
    assert any("1 meshes cannot be read: package://parts/meshes/none.stl" in note for note in notes)
    assert any("2 meshes are not read" in note for note in em.read_urdf(robot).notes)


def test_links_without_solids_have_lines(robot):
    assert {shape.kind for shape in em.load_urdf(robot).drawing} == {"solid"}
    pin = '<joint name="pin" type="continuous"><origin xyz="0 0 0.7"/>'
    bare = ROBOT.replace("visual>", "collision>").replace('<joint name="pin" type="continuous">', pin)
    robot.write_text(bare)
    (line,) = em.load_urdf(robot).drawing
    assert (line.kind, line.numbers[2], line.numbers[5]) == ("line", 0, pytest.approx(0.7))


def test_pages_show_meshes_unless_told_not_to(robot):
    assert len(em.load_model(robot, **with_meshes(robot, {})).drawing) == 3
    assert len(em.load_model(robot, **with_meshes(robot, {"meshes": "no"})).drawing) == 2
    assert with_meshes("pendulum.py", {"n": 2}) == {"n": 2}
    with pytest.raises(em.ModelError, match="meshes='maybe' is neither yes nor no"):
        em.load_model(robot, meshes="maybe")


@pytest.mark.parametrize("seed", range(3))
def test_few_corners_have_nearly_the_hull_of_many(seed):
    points = np.random.default_rng(seed).normal(size=(5000, 3)) * [1, 2, 0.5]
    corners = hull(points)
    assert len(corners) <= 160
    assert ConvexHull(corners).volume > 0.9 * ConvexHull(points).volume
    ways = directions(2000).T  # how far each hull reaches, in ways that it was not made from
    missed = (points @ ways).max(axis=0) - (corners @ ways).max(axis=0)
    assert missed.max() < 0.05 * np.ptp(points, axis=0).max()


def test_geoms_are_solids(tmp_path):
    file = tmp_path / "rod.xml"
    file.write_text(
        '<mujoco><worldbody><body name="rod"><joint name="pin" axis="0 1 0"/>'
        '<geom type="box" pos="0 0 -1" size="0.1 0.2 0.3"/><geom type="capsule" size="0.05 0.4" euler="90 0 0"/>'
        '<geom type="sphere" size="0.1" group="3"/></body></worldbody></mujoco>'
    )
    box, rod = (shape.points[0] for shape in em.build(em.load_mjcf(file)).simulate((0, 0.01)).drawing.shapes)
    assert extent(box) == pytest.approx(np.array([[-0.1, -0.2, -1.3], [0.1, 0.2, -0.7]]), abs=1e-6)
    assert extent(rod) == pytest.approx(np.array([[-0.05, -0.45, -0.05], [0.05, 0.45, 0.05]]), abs=2e-3)


def test_a_capsule_ends_in_half_balls():
    corners = capsule(0.1, 1.0)
    beyond = np.abs(corners) - [0, 0, 0.5]
    assert np.hypot(np.hypot(corners[:, 0], corners[:, 1]), beyond[:, 2]) == pytest.approx(np.full(len(corners), 0.1))
