"""Derivatives of inverse dynamics against differences of inverse dynamics, along motions that constraints allow."""

import numpy as np
import pytest
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

from ..driving import linkages
from ..support.generation import system_for, system_of

STEP = 1e-3


def difference(function):
    """The derivative of a function at 0, by differences of order 6."""
    points = [(function(k * STEP) - function(-k * STEP)) / (2 * k * STEP) for k in (1, 2, 3)]
    return 1.5 * points[0] - 0.6 * points[1] + 0.1 * points[2]


def agrees(found, wanted, within=1e-8):
    return np.abs(found - wanted).max() <= within * (np.abs(wanted).max() + np.abs(found).max()) + 1e-11


def test_an_arm_by_every_argument():
    system, random = system_of("puma", "lagrange"), np.random.default_rng(1)
    x, v, a = random.normal(size=(3, system.n))
    names = [*system.parameters][:4]
    found = system.inverse_dynamics_derivatives(x, v, a, by=names)
    for k, unit in enumerate(np.eye(system.n)):
        for whole, at in ((found.dx, 0), (found.dv, 1), (found.da, 2)):
            moved = lambda e, at=at, unit=unit: [w + e * unit * (j == at) for j, w in enumerate((x, v, a))]  # noqa: E731
            assert agrees(whole[:, k], difference(lambda e, moved=moved: system.inverse_dynamics(*moved(e)).forces))
    for name in names:
        value = system.parameters[name]
        wanted = difference(lambda e, n=name, p=value: system.inverse_dynamics(x, v, a, parameters={n: p + e}).forces)
        assert agrees(found.by[name], wanted)


def along(system, paths, motion, actuators):
    """Check dx dot(x) + dv dot(v) + da dot(a) along a family of motions paths(e), at the time 0.3."""
    times = np.array([0.0, 0.15, 0.3])
    base = em.drive(system, times, paths(0.0), x0=motion)
    family = {k: em.drive(system, times, paths(k * STEP), x0=motion) for k in (-3, -2, -1, 1, 2, 3)}

    def rate(read):
        return difference(lambda e: read(family[round(e / STEP)]))

    dx, dv, da = (rate(lambda d, name=name: getattr(d, name)[:, -1]) for name in ("x", "v", "a"))
    at = base.x[:, -1], base.v[:, -1], base.a[:, -1]
    found = system.inverse_dynamics_derivatives(*at, actuators=actuators)
    wanted = rate(lambda d: system.inverse_dynamics(d.x[:, -1], d.v[:, -1], d.a[:, -1], actuators=actuators).forces)
    assert agrees(found.dx @ dx + found.dv @ dv + found.da @ da, wanted)


@pytest.mark.parametrize("actuators", [("q1",), ("q3",), ("q1", "q3"), {"q1": 5.0, "q2": 1.0, "q3": 0.2}, None])
def test_a_linkage_along_its_motions(actuators):
    t = em.t
    along(system_of("four_bar", "lagrange"), lambda e: {"q1": 0.5 + 2 * t + e * sin(3 * t + 1)}, None, actuators)


@pytest.mark.parametrize(
    "actuators", [("u_a", "u_b", "u_c"), ("u_a", "u_b", "u_c", "x"), {"u_a": 2.0, "u_b": 1.0, "y": 3.0, "z": 0.5}]
)
def test_a_delta_robot_with_motors(actuators):
    t = em.t

    def paths(e):
        return {"x": 0.1 * sin(2 * t + e), "y": 0.05 * sin(3 * t) + e * t, "z": -0.45 + 0.05 * sin(t) + e * cos(t)}

    along(em.build(linkages.delta()), paths, None, actuators)


def test_inputs_whose_direction_turns_and_states():
    """A thruster of input u along the heading of a cart on a circle, against a bristle z."""
    x, y, theta, z, u, w = dynamicsymbols("x y theta z u w")
    model = em.Model(
        name="thruster",
        coordinates=[x, y, theta],
        kinetic_energy=(2 * x.diff() ** 2 + 3 * y.diff() ** 2 + theta.diff() ** 2) / 2,
        forces={x: u * cos(theta) - z, y: u * sin(theta) + w * x.diff()},
        states={z: x.diff() - z},
        inputs={u: 0.0, w: 0.5},
        holonomic_constraints=[x - cos(theta), y - sin(theta) ** 2],
        initial={x: 1.0, z: 0.3},
    )
    system = em.build(model)
    near = {"x": 0.92, "y": 0.15, "z": 0.3}
    for actuators in (("u",), ("u", "theta"), {"u": 3.0, "y": 0.4}):
        along(system, lambda e: {"theta": 0.4 + em.t + e * em.t**2 + e}, near, actuators)
    at = em.drive(system, [0.0, 0.1], {"theta": 0.4 + em.t}, x0=near)
    place = (*at.x[:, -1], 0.7), at.v[:, -1], at.a[:, -1]
    found = system.inverse_dynamics_derivatives(*place, actuators=("u", "theta"), by=["z", "w"])

    def forces(z=0.7, w=0.5):
        return system.inverse_dynamics((*place[0][:3], z), *place[1:], inputs={"w": w}, actuators=("u", "theta")).forces

    assert agrees(found.by["z"], difference(lambda e: forces(z=0.7 + e)))
    assert agrees(found.by["w"], difference(lambda e: forces(w=0.5 + e)))


def test_many_states_and_mistakes():
    system = system_of("four_bar", "lagrange")
    turn = em.drive(system, np.linspace(0.0, 1.0, 5), {"q1": 0.5 + 2 * em.t})
    found = system.inverse_dynamics_derivatives(turn.x, turn.v, turn.a, actuators=("q1",), by=["density"])
    assert found.dx.shape == (1, 3, 5)
    assert np.abs(found.forces - turn.forces).max() < 1e-12
    assert agrees(found.by["density"], turn.forces / system.parameters["density"])
    one = system.inverse_dynamics_derivatives(turn.x[:, 2], turn.v[:, 2], turn.a[:, 2], actuators=("q1",))
    assert np.array_equal(one.dv, found.dv[..., 2])
    with pytest.raises(em.ModelError, match="'none'"):
        system.inverse_dynamics_derivatives(turn.x, turn.v, turn.a, by=["none"])
    pendulum = system_of("furuta_pendulum", "lagrange")
    rest = np.array([0.0, 0.0])
    with pytest.raises(em.ModelError, match="not every motion beside it"):
        pendulum.inverse_dynamics_derivatives(rest, rest, rest, actuators=("u",))


@pytest.mark.parametrize("gain", [1e-12, 1e-6, 1.0, 1e6, 1e12])
@pytest.mark.parametrize("mass", [1e-12, 1e-7, 1e-3, 1.0, 1e9, 1e12])
def test_units_do_not_matter(mass, gain):
    """All forces are proportional to J; two actuators of other units, one with a large weight, drive two freedoms."""
    x, y, u, w = dynamicsymbols("x y u w")
    J, G = symbols("J G")
    bent = em.Model(
        name="bent",
        coordinates=[x, y],
        kinetic_energy=J * (x.diff() ** 2 + y.diff() ** 2) / 2,
        potential_energy=3 * J * sin(x) * y,
        holonomic_constraints=[y + x * (1 + x)],
        parameters={J: 1.0},
        initial={x: 0.5, y: -0.75},
    )
    at = [0.5, -0.75], [1.0, -2.0], [0.5, -3.0]
    for actuators in (None, ("x",), ("y",), ("x", "y")):
        ones, found = (
            system_for(bent, "lagrange").inverse_dynamics_derivatives(
                *at, parameters={"J": J}, actuators=actuators, by=["J"]
            )
            for J in (1.0, mass)
        )
        assert agrees(found.by["J"] * mass / found.forces, np.ones(len(found.forces)))
        for name in ("dx", "dv", "da"):
            assert agrees(getattr(found, name) / mass, getattr(ones, name))
    free = em.Model(name="gains", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
                    forces={x: u, y: G * w - 3 * y}, inputs={u: 0.0, w: 0.0}, parameters={G: 1.0})  # fmt: skip
    for actuators in (("u", "w"), {"u": 1.0, "w": mass}):
        found = system_for(free, "lagrange").inverse_dynamics_derivatives(
            [0.1, 0.2], [0.3, 0.4], [0.5, 0.6], parameters={"G": gain}, actuators=actuators
        )
        assert agrees(found.dx * [[1.0], [gain]], np.array([[0.0, 0.0], [0.0, 3.0]]))
        assert agrees(found.da * [[1.0], [gain]], np.eye(2))


def guided(joint=False):
    """A bead on a parabola in an upright plane, whose guide rubs, and a mass on a spring that it carries.

    joint: as a pendulum whose bearing, of two rows, rubs instead.
    """
    x, y, s, theta, mu, k = *dynamicsymbols("x y s theta"), *symbols("mu k")
    T = (2 * x.diff() ** 2 + 2 * y.diff() ** 2 + (x.diff() + s.diff()) ** 2 + theta.diff() ** 2) / 2
    rows = {"pin": [x - sin(theta), y + cos(theta)]} if joint else {"guide": [y - x**2]}
    rub = em.Friction(theta.diff(), mu * 0.3, "pin") if joint else em.Friction(x.diff(), mu, "guide")
    return em.Model(
        name="guided", coordinates=[x, y, s, theta], kinetic_energy=T, potential_energy=20 * y + k * s**2 / 2,
        holonomic_constraints=rows, contacts={"rub": rub}, parameters={mu: 0.3, k: 30.0},
        initial={x: sin(0.4) if joint else 0.4, y: -cos(0.4) if joint else 0.16, theta: 0.4},
    )  # fmt: skip


@pytest.mark.parametrize("joint", [False, True])
def test_friction_that_is_proportional_to_reactions(joint):
    system, t = system_for(guided(joint), "lagrange"), em.t
    paths = {"s": lambda e: 0.1 * sin(4 * t) + e * cos(3 * t), "theta": lambda e: 0.4 + 0.6 * t + e * t**2}
    if not joint:
        paths["x"] = lambda e: 0.4 + t + e * sin(5 * t + 1)
    along(system, lambda e: {name: path(e) for name, path in paths.items()}, None, tuple(paths))
    turn = em.drive(system, [0.0, 0.2], {name: path(0.0) for name, path in paths.items()})
    at = turn.x[:, -1], turn.v[:, -1], turn.a[:, -1]
    found = system.inverse_dynamics_derivatives(*at, actuators=tuple(paths), by=["mu", "k"])

    def forces(parameters):
        return system.inverse_dynamics(*at, actuators=tuple(paths), parameters=parameters).forces

    for name, value in (("mu", 0.3), ("k", 30.0)):
        wanted = difference(lambda e, n=name, p=value: forces({n: p + e}))
        assert np.abs(wanted).max() > 1e-2
        assert agrees(found.by[name], wanted)
    frictionless = system.inverse_dynamics_derivatives(*at, actuators=tuple(paths), parameters={"mu": 0.0})
    assert not agrees(found.da, frictionless.da)
    if joint:
        with pytest.raises(em.ModelError, match="more actuators than degrees of freedom"):
            system.inverse_dynamics_derivatives(*at)


def test_a_choice_of_actuators_beside_friction():
    """The norm of one multiplier is linear in it, but for its sign."""
    t = em.t
    paths = lambda e: {"s": 0.1 * sin(4 * t), "theta": 0.4 + t, "x": 0.4 + t + e * sin(5 * t + 1)}  # noqa: E731
    for actuators in (("x", "y", "s", "theta"), {"x": 1.0, "y": 0.2, "s": 3.0, "theta": 2.0}, None):
        along(system_for(guided(), "lagrange"), paths, None, actuators)


def test_reactions_that_vanish():
    """The pendulum falls freely from its bearing's height."""
    system = system_for(guided(joint=True), "lagrange")
    at = {"x": 1.0, "y": 0.0, "theta": np.pi / 2}, {}, {"y": -10.0, "theta": -10.0}
    with pytest.raises(em.ModelError, match="are zero at t = 0"):
        system.inverse_dynamics_derivatives(*at, actuators=("s", "theta"))
