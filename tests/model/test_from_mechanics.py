"""Models read off bodies, joints and loads of SymPy's mechanics, against Kane's equations that SymPy forms of them."""

from functools import cache

import numpy as np
import pytest
import sympy
from sympy import cos, symbols
from sympy.physics.mechanics import (
    DuffingSpring,
    Force,
    LinearPathway,
    Particle,
    PinJoint,
    Point,
    PrismaticJoint,
    ReferenceFrame,
    RigidBody,
    System,
    Torque,
    dynamicsymbols,
)

import eigenmotion as em

from ..support.generation import system_for
from . import kane
from .kane import Example
from .kane_bicycle import bicycle

q, u = dynamicsymbols("q u")
m, k, l, g, c = symbols("m k l g c", positive=True)
MAKERS = (kane.pendulum_on_cart, kane.masses_and_springs, kane.rolling_disc, kane.disc_on_coordinates, kane.four_bar,
          kane.cart_pendulum, bicycle)  # fmt: skip
EXAMPLES = {make.__name__: make for make in MAKERS}
KINEMATIC = (q.diff() - u,)
SLOW = {"bicycle", "disc_on_coordinates"}
"""SymPy forms their equations for seconds."""
NAMES = [pytest.param(name, marks=pytest.mark.nightly) if name in SLOW else name for name in EXAMPLES]


@cache
def example(name: str) -> Example:
    return EXAMPLES[name]()


@cache
def system_of(name: str) -> em.System:
    return system_for(example(name).model, "lagrange")


def states(model: em.Model, system: em.System, count: int = 3):
    """Give q, v and inputs at random about the start; v satisfies the constraints."""
    random = np.random.default_rng(sum(map(ord, model.name)))
    for _ in range(count):
        x = system.initial[0] + random.uniform(-0.4, 0.4, model.n)
        v, A = random.uniform(-1, 1, model.n), system.pfaffian(x)[0]
        yield x, v - np.linalg.pinv(A) @ A @ v if model.m else v, random.uniform(-1, 1, len(model.inputs))


@pytest.mark.parametrize("name", NAMES)
def test_kanes_equations(name):
    one, system = example(name), system_of(name)
    for x, v, inputs in states(one.model, system):
        a, _ = system.acceleration(x, v, inputs=dict(zip(system.inputs, inputs, strict=True)))
        right, found = one.speed_rates(x, v, inputs), one.found(x, v, a, inputs)
        assert np.abs(found - right).max() < 1e-10 * (1 + np.abs(right).max())


def test_weights_and_springs_have_potentials_and_dampers_have_none():
    model = example("cart_pendulum").model
    speeds = {str(y): rate for y, rate in model.quasi_velocities}
    named = {str(symbol): symbol for symbol, _ in model.parameters}
    x, theta = model.coordinates
    g, l, k, l0, mb = (named[name] for name in ("g", "l", "k", "l0", "mb"))
    spring = k * (sympy.sqrt((x + 2) ** 2 + 1) - l0) ** 2 / 2
    assert sympy.simplify(model.potential_energy - spring + mb * g * l * cos(theta)) == 0
    assert speeds == {"v(t)": x.diff(), "omega(t)": theta.diff()}
    assert model.forces[1] == -named["kt"] * theta
    assert {str(one) for one in model.forces[0].atoms(sympy.Function)} >= {"F(t)", "v(t)"}


def test_a_disc_that_rolls_by_its_velocities_keeps_its_energy():
    """What Lagrange's equations miss there does no work; without it, the disc gains or loses."""
    system, start = system_of("rolling_disc"), {"q2": 0.3, "q1'": 0.4, "q2'": 0.1, "q3'": 3.0}
    x0 = {name: value for name, value in start.items() if "'" not in name}
    v0 = {name.strip("'"): value for name, value in start.items() if "'" in name}
    run = system.simulate((0.0, 2.0), x0=x0, v0=v0, rtol=1e-10, atol=1e-10)
    assert run.success, run.message
    assert np.ptp(run.x[1]) > 0.1
    assert np.ptp(run.energy) < 1e-8 * run.energy[0]


# --- what may be given ------------------------------------------------------------------------------------------------


def pendulum(speed=u, **given) -> em.Model:
    """A bob on a pin joint, under a weight."""
    wall, bob, arm = RigidBody("wall"), Particle("bob", mass=m), ReferenceFrame("arm")
    system = System.from_newtonian(wall)
    system.add_joints(
        PinJoint("pin", wall, bob, q, speed, joint_axis=wall.z, child_interframe=arm, child_point=l * arm.y)
    )
    system.apply_uniform_gravity(-g * wall.y)
    return em.from_mechanics(system, **({"parameters": {m: 2.0, l: 0.5, g: 9.81}, "name": "swing"} | given))


def test_the_speeds_may_be_the_rates():
    wall, block = RigidBody("wall"), Particle("block", mass=m)
    system = System.from_newtonian(wall)
    system.add_joints(PrismaticJoint("rail", wall, block, q, q.diff(), joint_axis=wall.x))
    block.potential_energy = k * q**2 / 2
    model = em.from_mechanics(system, parameters={m: 2.0, k: 3.0})
    assert model.name == "mechanism"
    assert not model.quasi_velocities
    assert sympy.simplify(model.kinetic_energy - m * q.diff() ** 2 / 2) == 0
    assert model.potential_energy == k * q**2 / 2


def particle(rate, *, fixed_point: bool = True, kinematic=KINEMATIC, **given) -> em.Model:
    """A particle on a line, by bodies and a frame."""
    N, O = ReferenceFrame("N"), Point("O")
    O.set_vel(N, 0)
    P = O.locatenew("P", q * N.x)
    P.set_vel(N, rate * N.x)
    parts = {"loads": [(P, -m * g * N.x)], "coordinates": [q], "speeds": [u], "kinematic_equations": kinematic}
    parts |= {"fixed_point": O if fixed_point else None, "parameters": {m: 2.0, g: 9.81, c: 0.3}} | given
    return em.from_mechanics([Particle("P", P, m)], frame=N, **parts)


def test_a_weight_has_no_potential_where_no_point_is_fixed():
    model = particle(u, fixed_point=False)
    assert (model.potential_energy, model.forces) == (0, (-g * m,))
    assert particle(u).potential_energy == g * m * q


def test_speeds_that_are_not_linear_in_the_rates_are_written_in_them():
    model = particle(u - c, kinematic=[q.diff() + c - u])
    assert not model.quasi_velocities
    assert sympy.expand(model.kinetic_energy - m * q.diff() ** 2 / 2) == 0


def test_a_stiffening_spring_stores_its_energy():
    N, O = ReferenceFrame("N"), Point("O")
    O.set_vel(N, 0)
    P = O.locatenew("P", q * N.x)
    P.set_vel(N, u * N.x)
    system = System(N, O)
    system.add_bodies(Particle("P", P, m))
    system.add_coordinates(q)
    system.add_speeds(u)
    system.add_kdes(q.diff() - u)
    system.add_actuators(DuffingSpring(k, c, LinearPathway(O, P), l))
    model = em.from_mechanics(system, parameters={m: 1.0, k: 2.0, c: 3.0, l: 0.2})
    stretched = sympy.sqrt(q**2) - l
    assert sympy.simplify(model.potential_energy - k * stretched**2 / 2 - c * stretched**4 / 4) == 0
    assert model.forces == (0,)


# --- what is refused --------------------------------------------------------------------------------------------------


def lonely(**given):
    """A particle whose velocity nobody knows."""
    N = ReferenceFrame("N")
    return em.from_mechanics([Particle("P", Point("P"), m)], frame=N, coordinates=[q], speeds=[u],
                             kinematic_equations=KINEMATIC, parameters={m: 1.0}, name="lonely", **given)  # fmt: skip


def loose(part: str):
    """A body whose frame nothing turns, and a torque on another such frame."""
    N, B, O = ReferenceFrame("N"), ReferenceFrame("B"), Point("O")
    O.set_vel(N, u * N.x)
    body = Particle("P", O, m) if part == "torque" else RigidBody("P", O, B, m)
    loads = [Torque(B, N.x)] if part == "torque" else [Force(O, B.x)]
    return em.from_mechanics([body], frame=N, loads=loads, coordinates=[q], speeds=[u],
                             kinematic_equations=[q.diff() - u], parameters={m: 1.0}, name="loose")  # fmt: skip


def with_auxiliary():
    wall, block = RigidBody("wall"), Particle("block", mass=m)
    system = System.from_newtonian(wall)
    system.add_joints(PrismaticJoint("rail", wall, block, q, u, joint_axis=wall.x))
    system.add_auxiliary_speeds(dynamicsymbols("u_a"))
    return em.from_mechanics(system, parameters={m: 1.0}, name="aux")


def counted_twice():
    wall, block = RigidBody("wall"), Particle("block", mass=m)
    system = System.from_newtonian(wall)
    system.add_joints(PrismaticJoint("rail", wall, block, q, u, joint_axis=wall.y))
    system.apply_uniform_gravity(-g * wall.y)
    block.potential_energy = m * g * q
    return em.from_mechanics(system, parameters={m: 1.0, g: 9.81}, name="twice")


N_ = ReferenceFrame("N")
REFUSED = {
    "no system": (lambda: em.from_mechanics(42), "42 is not what a model is read off. Give a .*System"),
    "no frame": (lambda: em.from_mechanics([Particle("P")]), "frame is None"),
    "no bodies": (lambda: em.from_mechanics([], frame=N_), "There are no bodies"),
    "no coordinates": (lambda: em.from_mechanics([Particle("P")], frame=N_), "There are no coordinates"),
    "parts beside a system": (lambda: em.from_mechanics(System(), frame=N_), "frame: a System has its own"),
    "no velocity": (lonely, r"Model 'lonely': The velocity of the point P in the frame N is not known"),
    "no orientation": (lambda: loose("body"), "Model 'loose': The .*N.*"),
    "a torque on a loose frame": (lambda: loose("torque"), "The angular velocity of the frame B in N is not known"),
    "auxiliary speeds": (with_auxiliary, "Model 'aux': The auxiliary speeds u_a are not supported.*multiplier"),
    "a weight twice": (counted_twice, "The body block has a potential energy and a load that has the same one"),
    "parameters without a value": (lambda: pendulum(parameters={m: 1.0}), "parameters has no value for g, l"),
    "a square of a rate": (lambda: particle(u, kinematic=[q.diff() ** 2 - u]), "is not linear in the speeds and rates"),
    "no kinematic equation": (lambda: particle(u, kinematic=[]), "0 kinematic equations for the 1 coordinates q"),
    "two of them": (lambda: particle(u, kinematic=[q.diff() - u, q.diff() - 2 * u]), "2 kinematic equations"),
    "no input": (lambda: particle(u, loads=[(Point("O"), N_.x)]), "The velocity of the point O"),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_what_is_refused_says_why(case):
    make, words = REFUSED[case]
    with pytest.raises(em.ModelError, match=words):
        make()


def test_a_pendulum_moves():
    model = pendulum(initial={q: 0.3, u: 1.0})
    a, _ = system_for(model, "lagrange").acceleration(list(model.initial_x), [0.0])
    assert a == pytest.approx([-9.81 / 0.5 * np.sin(0.3)], rel=1e-14)
