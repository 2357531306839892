"""Trees of SymPy's joints as trees of bodies, against energies that are written out and against Kane's equations."""

from functools import cache

import numpy as np
import pytest
import sympy
from sympy import Rational, symbols
from sympy.physics.mechanics import (
    CylindricalJoint,
    DuffingSpring,
    Force,
    LinearDamper,
    LinearPathway,
    LinearSpring,
    Particle,
    PinJoint,
    PlanarJoint,
    Point,
    PrismaticJoint,
    ReferenceFrame,
    RigidBody,
    SphericalJoint,
    System,
    TorqueActuator,
    WeldJoint,
    dynamicsymbols,
    inertia,
)

import eigenmotion as em

from ..support.generation import relative, system_for
from .kane import Example

g, l, k, c, m = symbols("g l k c m", positive=True)
VALUES = {g: 9.81, l: 0.4, k: 20.0, c: 0.3, m: 1.2}
F, tau = dynamicsymbols("F tau")
TURN = sympy.Matrix([[Rational(3, 5), Rational(-4, 5), 0], [Rational(4, 5), Rational(3, 5), 0], [0, 0, 1]])


class Machine:
    """A random tree of bodies on joints of SymPy, with loads."""

    def __init__(self, kinds: tuple[str, ...], seed: int) -> None:
        self.random = np.random.default_rng(seed)
        self.wall = RigidBody("wall")
        self.system = System.from_newtonian(self.wall)
        self.bodies = [self.wall]
        for number, kind in enumerate(kinds):
            parent = self.bodies[-1 if self.random.random() < 0.7 else int(self.random.integers(len(self.bodies)))]
            self.bodies.append(self.joined(kind, number, parent))
        self.load()

    def numbers(self, count: int) -> list[sympy.Rational]:
        return [Rational(int(one), 10) for one in self.random.integers(-5, 6, count)]

    def vector(self, frame: ReferenceFrame, size: sympy.Expr = l):
        x, y, z = self.numbers(3)
        return size * (x * frame.x + y * frame.y + (z + Rational(1, 20)) * frame.z)

    def joined(self, kind: str, number: int, parent: RigidBody) -> RigidBody:
        child = RigidBody(f"body_{number}", mass=m * (1 + Rational(number, 3)))
        xx, yy, zz = (Rational(int(one), 100) for one in self.random.integers(4, 6, 3))
        child.central_inertia = inertia(child.frame, xx, yy, zz, Rational(1, 200), Rational(-1, 300), 0)
        turned = ReferenceFrame(f"turned_{number}")
        turned.orient_explicit(child.frame, TURN)
        places = {
            "parent_point": self.vector(parent.frame), "child_point": self.vector(child.frame),
            "parent_interframe": 3 * parent.frame.x + 4 * parent.frame.y if number % 2 else None,
            "child_interframe": turned if number % 3 else None,
        }  # fmt: skip
        self.system.add_joints(self.joint(kind, f"joint_{number}", parent, child, places))
        return child

    def joint(self, kind: str, name: str, parent: RigidBody, child: RigidBody, places):
        if kind in ("pin", "prismatic", "cylindrical"):
            make = {"pin": PinJoint, "prismatic": PrismaticJoint, "cylindrical": CylindricalJoint}[kind]
            return make(name, parent, child, joint_axis=3 * parent.frame.y - 4 * parent.frame.z, **places)
        if kind == "spherical":
            return SphericalJoint(name, parent, child, rot_type="body", rot_order="ZXY", **places)
        if kind == "space":
            return SphericalJoint(name, parent, child, rot_type="space", rot_order=312, **places)
        return {"planar": PlanarJoint, "weld": WeldJoint}[kind](name, parent, child, **places)

    def load(self) -> None:
        system, last = self.system, self.bodies[-1]
        system.apply_uniform_gravity(-g * self.wall.y + g * self.wall.x / 10)
        post = self.wall.masscenter.locatenew("post", 3 * l * self.wall.x)
        post.set_vel(self.wall.frame, 0)
        tip = last.masscenter.locatenew("tip", self.vector(last.frame))
        tip.set_vel(last.frame, 0)
        path = LinearPathway(post, last.masscenter)
        system.add_actuators(LinearSpring(k, path, l), LinearDamper(c, path))
        system.add_loads(Force(tip, F * last.frame.x + 2 * self.wall.z), Force(self.bodies[1], 3 * self.wall.x))
        for joint in system.joints:
            if isinstance(joint, PinJoint):
                axis, q = joint.joint_axis, joint.coordinates[0]
                system.add_actuators(TorqueActuator(tau - k * q / 9, axis, joint.child.frame, joint.parent.frame))

    def model(self, tree: bool) -> em.Model:
        return em.from_mechanics(self.system, name="machine", parameters=VALUES, inputs={F: 0.7, tau: -0.4}, tree=tree)


MACHINES = {
    "arm": (("pin", "prismatic"), 1),
    "cylinder": (("cylindrical",), 2),
    "plane": (("planar", "weld"), 3),
    "ball": (("spherical",), 4),
    "branches": (("weld", "pin", "pin"), 5),
    "space": (("space",), 6),
}


NAMES = [pytest.param(name, marks=pytest.mark.nightly) if name == "branches" else name for name in MACHINES]
"""SymPy writes out the energies of branches for seconds."""


def machine(name: str) -> Machine:
    """Make a machine anew: SymPy stores velocities in points, and warns where several ways lead to one."""
    return Machine(*MACHINES[name])


@cache
def model_of(name: str, tree: bool) -> em.Model:
    return machine(name).model(tree)


def states(model: em.Model, count: int = 3):
    random = np.random.default_rng(3)
    return [(random.uniform(-1, 1, model.n), random.normal(size=model.n)) for _ in range(count)]


@pytest.mark.parametrize("name", NAMES)
def test_energies_written_out(name):
    tree, written = (model_of(name, one) for one in (True, False))
    assert tree.notes == ("The bodies are a tree.",)
    assert written.notes[0].endswith("tree=False.")
    assert (tree.coordinates, tree.quasi_velocities) == (written.coordinates, written.quasi_velocities)
    first, second = system_for(tree, "lagrange"), system_for(written, "lagrange")
    for x, v in states(tree):
        assert relative(first.mass_matrix(x).ravel(), second.mass_matrix(x).ravel()) < 1e-12
        assert relative(first.acceleration(x, v)[0], second.acceleration(x, v)[0], 1.0) < 1e-10
        assert first.energy(x, v) == pytest.approx(second.energy(x, v), rel=1e-12)


@pytest.mark.parametrize("name", NAMES)
def test_articulated_bodies_against_kanes_equations(name):
    model, system = model_of(name, True), machine(name).system
    system.validate_system()
    system.form_eoms()
    kane, compiled = Example(model, system.eom_method), system_for(model, "articulated_body")
    for x, v in states(model):
        a, _ = compiled.acceleration(x, v)
        inputs = [value for _, value in model.inputs]
        right, found = kane.speed_rates(x, v, inputs), kane.found(x, v, a, inputs)
        assert np.abs(found - right).max() < 1e-9 * (1 + np.abs(right).max())


def pins(count: int, **given) -> em.Model:
    """A chain of links by pin joints, with a torque in each and an end force."""
    wall = RigidBody("wall")
    system, parent = System.from_newtonian(wall), wall
    for number in range(count):
        link = RigidBody(f"link_{number}", mass=m)
        link.central_inertia = inertia(link.frame, 0, 0, m * l**2 / 12)
        pin = PinJoint(f"pin_{number}", parent, link, joint_axis=parent.frame.z, child_point=-l * link.frame.x / 2,
                       parent_point=l * parent.frame.x / 2 if number else None)  # fmt: skip
        system.add_joints(pin)
        torque = -k * pin.coordinates[0] + tau
        system.add_actuators(TorqueActuator(torque, parent.frame.z, link.frame, parent.frame))
        parent = link
    system.apply_uniform_gravity(-g * wall.y)
    return em.from_mechanics(
        system, name="pins", parameters={g: 9.81, l: 0.4, k: 20.0, m: 1.2}, inputs={tau: 0.0}, **given
    )


def test_torques_between_neighbours_act_on_one_coordinate():
    model = pins(6)
    for q, force in zip(model.coordinates, model.forces, strict=True):
        assert sympy.expand(force + k * q - tau) == 0


def test_a_chain_of_many_pins_is_a_tree_and_a_short_one_is_written_out():
    assert pins(6).notes == ("The bodies are a tree.",)
    assert pins(2).notes[0].endswith("there are no more than 4 coordinates.")


def arm(count: int = 2) -> tuple[System, list[RigidBody]]:
    """A chain of links by pin joints about several axes; returns its system and its bodies, the wall first."""
    bodies = [RigidBody("wall")]
    system = System.from_newtonian(bodies[0])
    for number in range(count):
        parent, link = bodies[-1], RigidBody(f"link_{number}", mass=m)
        link.central_inertia = inertia(link.frame, Rational(1, 50), Rational(1, 60), Rational(1, 70))
        axis = (parent.frame.z, parent.frame.x)[number % 2]
        system.add_joints(PinJoint(f"pin_{number}", parent, link, parent_point=l * parent.frame.x / 2, joint_axis=axis,
                                   child_point=-l * link.frame.x / 2))  # fmt: skip
        bodies.append(link)
    return system, bodies


# --- what is no tree --------------------------------------------------------------------------------------------------


def loose() -> System:
    """A body that no joint moves."""
    wall, first = RigidBody("wall"), RigidBody("first")
    system = System.from_newtonian(wall)
    system.add_joints(PinJoint("a", wall, first))
    free = RigidBody("free", mass=m)
    system.add_bodies(free)
    free.masscenter.set_vel(wall.frame, 0)
    free.frame.set_ang_vel(wall.frame, 0)
    return system


def slipping() -> System:
    """A joint whose body the user gave another velocity."""
    wall, first = RigidBody("wall"), RigidBody("first")
    system = System.from_newtonian(wall)
    system.add_joints(PinJoint("a", wall, first, child_point=first.frame.x))
    first.masscenter.set_vel(wall.frame, 2 * system.u[0] * first.frame.x)
    return system


def with_energy() -> System:
    wall, first = RigidBody("wall"), RigidBody("first")
    system = System.from_newtonian(wall)
    system.add_joints(PrismaticJoint("a", wall, first))
    first.potential_energy = k * system.q[0] ** 2
    return system


def turned_axis() -> System:
    wall, first = RigidBody("wall"), RigidBody("first")
    system = System.from_newtonian(wall)
    system.add_joints(PrismaticJoint("a", wall, first, joint_axis=wall.x + l * wall.y))
    return system


def varying() -> System:
    system, bodies = arm()
    bodies[-1].mass = m * (1 + system.q[0] ** 2)
    return system


def parted() -> System:
    """Two joints at a particle, whose frames there nothing connects."""
    wall, first, last = RigidBody("wall"), Particle("first", mass=m), Particle("last", mass=m)
    system = System.from_newtonian(wall)
    system.add_joints(PrismaticJoint("a", wall, first), PrismaticJoint("b", first, last))
    system.apply_uniform_gravity(-g * wall.y)
    return system


NO_TREES = {
    "mass": (varying, "the mass of the body link_1 varies"),
    "particle": (parted, "No connecting orientation path found between a_first_frame and b_first_frame"),
    "loose body": (loose, "no joint moves the body free"),
    "velocity": (slipping, "the body first does not move as its joint does"),
    "energy": (with_energy, "the body first has a potential energy of its own"),
    "axis": (turned_axis, "the axis of the joint a contains symbols"),
    "no joints": (lambda: System.from_newtonian(RigidBody("wall")), "no coordinates"),
}


@pytest.mark.parametrize("case", NO_TREES)
def test_what_is_no_tree_says_why(case):
    make, words = NO_TREES[case]
    with pytest.raises(em.ModelError, match=words):
        em.from_mechanics(make(), tree=True)


def test_a_mass_that_varies_is_written_out():
    model = em.from_mechanics(varying(), parameters=VALUES, tree=None)
    assert model.kinetic_energy.has(model.coordinates[0])


def test_a_system_that_sympy_cannot_place_is_refused():
    with pytest.raises(em.ModelError, match=r"The velocity of the point last_masscenter .* is not known"):
        em.from_mechanics(parted(), parameters=VALUES)


# --- velocities and loads that users set ------------------------------------------------------------------------------


def contact(system: System, bodies: list[RigidBody]) -> Point:
    """A point below the last body, with the velocity of the body there: as the body turns, it is another part of it."""
    wall, last = bodies[0], bodies[-1]
    point = last.masscenter.locatenew("contact", -l * wall.y)
    point.v2pt_theory(last.masscenter, wall.frame, last.frame)
    return point


def path(bodies: list[RigidBody], end: Point) -> LinearPathway:
    post = bodies[0].masscenter.locatenew("post", 3 * l * bodies[0].x)
    post.set_vel(bodies[0].frame, 0)
    return LinearPathway(post, end)


def force_on_contact(system: System, bodies: list[RigidBody]) -> None:
    system.add_loads(Force(contact(system, bodies), 5 * bodies[0].x))


def spring_on_contact(system: System, bodies: list[RigidBody]) -> None:
    system.add_actuators(LinearSpring(k, path(bodies, contact(system, bodies)), l))


def force_on_no_place(system: System, bodies: list[RigidBody]) -> None:
    point = Point("somewhere")
    point.set_vel(bodies[0].frame, system.u[0] * l * bodies[0].x)
    system.add_loads(Force(point, 5 * bodies[0].x))


def force_on_massless(system: System, bodies: list[RigidBody]) -> None:
    tip = RigidBody("tip", mass=0)
    tip.central_inertia = inertia(tip.frame, 0, 0, 0)
    system.add_joints(WeldJoint("weld", bodies[-1], tip, parent_point=l * bodies[-1].frame.x))
    system.apply_uniform_gravity(-g * bodies[0].y)
    system.add_loads(Force(tip.masscenter, 5 * bodies[0].x))


def stiffness_of_angle(system: System, bodies: list[RigidBody]) -> None:
    stiffness, length = k * (1 + system.q[0] ** 2), l * sympy.cos(system.q[1])
    ways = path(bodies, bodies[-1].masscenter), path(bodies, bodies[1].masscenter)
    system.add_actuators(LinearSpring(stiffness, ways[0], l), DuffingSpring(k, k, ways[1], length))


def length_of_input(system: System, bodies: list[RigidBody]) -> None:
    """Two cables: a winch gives the length of one, and moves the post of the other."""
    moved = bodies[0].masscenter.locatenew("moved", F * bodies[0].x)
    moved.set_vel(bodies[0].frame, 0)
    second = LinearPathway(moved, bodies[1].masscenter)
    system.add_actuators(LinearSpring(k, path(bodies, bodies[-1].masscenter), F), LinearSpring(k, second, l))


def stiffness_of_speed(system: System, bodies: list[RigidBody]) -> None:
    system.add_actuators(LinearSpring(k * (1 + system.u[0] ** 2), path(bodies, bodies[-1].masscenter), l))


LOADS = (force_on_contact, spring_on_contact, force_on_no_place, force_on_massless, stiffness_of_angle,
         length_of_input, stiffness_of_speed)  # fmt: skip


@pytest.mark.parametrize("load", LOADS)
def test_loads_are_those_of_kanes_equations(load):
    def loaded() -> System:
        system, bodies = arm()
        load(system, bodies)
        return system

    system = loaded()
    system.validate_system()
    system.form_eoms()
    for tree in (True, False):
        inputs = {F: 0.7} if load is length_of_input else {}
        model = em.from_mechanics(loaded(), name="arm", parameters=VALUES, inputs=inputs, tree=tree)
        given = list(inputs.values())
        kane, compiled = Example(model, system.eom_method), system_for(model, "lagrange")
        for x, v in states(model):
            right, found = kane.speed_rates(x, v, given), kane.found(x, v, compiled.acceleration(x, v)[0], given)
            assert np.abs(found - right).max() < 1e-9 * (1 + np.abs(right).max())


@pytest.mark.filterwarnings("ignore::UserWarning")
def test_a_velocity_that_others_follow_from_is_compared():
    system, bodies = arm()
    point = bodies[-1].masscenter.locatenew("held", l * bodies[-1].x)
    point.set_vel(bodies[0].frame, 0)
    with pytest.raises(em.ModelError, match="does not move as its joint does"):
        em.from_mechanics(system, name="arm", parameters=VALUES, tree=True)
