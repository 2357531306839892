"""Places and Jacobians of bodies against homogeneous matrices: exponentials in 40 digits, and their differences."""

import numpy as np
import pytest
from mpmath import mp
from sympy import symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from tests.oracles.newton_euler import exact, homogeneous, skew
from tests.support.random_trees import RandomTree

STEP = mp.mpf(10) ** -12
"""Of central differences, in 40 digits: errors of 1e-24."""


@pytest.fixture(autouse=True)
def _in_many_digits():
    with mp.workdps(40):
        yield


def turned(s):
    """Return the rotation of modified Rodrigues parameters s = e tan(angle / 4), as an exponential."""
    size = mp.sqrt(sum(one**2 for one in s))
    return mp.expm(skew([one / size * 4 * mp.atan(size) for one in s]))


def joint(link, q, parameters):
    """Return H (4, 4) of a joint at its coordinates."""
    if link.joint == "fixed":
        return mp.eye(4)
    if link.joint in ("spherical", "free"):
        return homogeneous(turned(q[-3:]), q[:3] if link.joint == "free" else [0, 0, 0])
    axis = [*map(mp.mpf, map(float, link.axis))]
    ratio, offset = exact((link.ratio, link.offset), parameters)
    moved = ratio * q[0] + offset
    if link.joint == "prismatic":
        return homogeneous(mp.eye(3), [one * moved for one in axis])
    return homogeneous(mp.expm(skew(axis) * moved), [0, 0, 0])


def placed(link, values, parameters):
    """Return H (4, 4) of a body: products of homogeneous matrices from the ground outwards."""
    if link is None:
        return mp.eye(4)
    at, rotation = exact(link.at, parameters), exact(link.rotation, parameters)
    fixed = homogeneous(mp.matrix(3, 3), at)
    for k, entry in enumerate(rotation):
        fixed[k // 3, k % 3] = entry
    return (
        placed(link.parent, values, parameters) * fixed * joint(link, [values[q] for q in link.coordinates], parameters)
    )


def numbers(matrix):
    return np.array(matrix.tolist(), dtype=float)


def expected_jacobian(link, point, values, parameters):
    """Return J (6, n) by central differences of H: Hdot H^-1 has the angular velocity, Hdot y the velocity."""
    y, columns = mp.matrix([*map(mp.mpf, point), 1]), []
    inverse = placed(link, values, parameters) ** -1
    for q in values:
        ahead, behind = (placed(link, values | {q: values[q] + h}, parameters) for h in (STEP, -STEP))
        rate = (ahead - behind) / (2 * STEP)
        v, w = rate * y, rate * inverse
        columns.append([v[0], v[1], v[2], w[2, 1], w[0, 2], w[1, 0]])
    return np.array(columns, dtype=float).T


def model_of(made, name, **more):
    tree = made.tree
    for body in made.bodies:
        tree.body(f"load of {body.name}", body, joint="fixed", at=(0.2, 0.1, 0), mass=0.7, inertia=(0.1, 0.2, 0.15))
    return em.Model(name=name, coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                    potential_energy=tree.potential_energy, parameters=made.parameters, **more)  # fmt: skip


@pytest.mark.parametrize("seed", [1, 9, *(pytest.param(seed, marks=pytest.mark.nightly) for seed in range(10, 40))])
def test_random_trees_are_where_homogeneous_matrices_say(seed):
    made = RandomTree(seed, most=9, driven=True)
    system = em.build(model_of(made, f"posed{seed}"), formulation="lagrange")
    assert system.bodies == tuple(made.tree.bodies)
    chance = np.random.default_rng(seed)
    x, point = chance.uniform(-0.6, 0.6, system.n), chance.normal(size=3)
    values = dict(zip(made.tree.coordinates, map(mp.mpf, x), strict=True))
    for name, body in made.tree.bodies.items():
        H = numbers(placed(body.link, values, made.parameters))
        R, p = system.pose(name, x)
        assert np.abs(R - H[:3, :3]).max() < 1e-14
        assert np.abs(p - H[:3, 3]).max() < 1e-14 * (1 + np.abs(H).max())
        J = expected_jacobian(body.link, point, values, made.parameters)
        assert np.abs(system.jacobian_of(body, point, x) - J).max() < 1e-14 * (1 + np.abs(J).max())


@pytest.fixture(scope="module")
def crane():
    """A free hull, a mast with two angles, and a hook on a slide whose length is a parameter."""
    l, m = symbols("l m", positive=True)
    tree = em.Tree()
    hull = tree.body("hull", joint="free", mass=3.0, inertia=(1.0, 2.0, 2.5))
    mast = tree.body("mast", hull, joint="cylindrical", at=(0.1, 0, l), axis=(1, 2, 2), mass=m, inertia=(0.1, 0.2, 0.2))
    hook = tree.body("hook", mast, joint="revolute", axis="x", at=(0, l, 0), mass=m, center=(0, 0, -l))
    end = (0.1, 0.2, -0.3)
    given = [*hook.velocity(end), *hook.angular_velocity]
    model = em.Model(name="crane", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                     potential_energy=tree.potential_energy, parameters={l: 0.7, m: 1.1},
                     outputs={f"v{k}": one for k, one in enumerate(given)}
                     | {f"p{k}": one for k, one in enumerate(hook.position(end))})  # fmt: skip
    return em.build(model, formulation="articulated_body"), end


@pytest.mark.parametrize("parameters", [None, {"l": 1.3}])
def test_jacobians_times_rates_are_the_velocities(crane, parameters):
    """At all states of a run, in one call: outputs are written by the recursions, which share nothing with these."""
    system, end = crane
    chance = np.random.default_rng(5)
    x0, v0 = chance.uniform(-0.4, 0.4, system.n), chance.normal(size=system.n)
    run = system.simulate((0, 0.3), x0=x0, v0=v0, parameters=parameters)
    J = system.jacobian_of("hook", end, run.x, parameters=parameters)
    R, p = system.pose("hook", run.x, parameters=parameters)
    assert J.shape == (6, system.n, len(run.t))
    moved = np.einsum("ijk,jk->ik", J, run.v)
    assert np.abs(moved - [run.outputs[f"v{k}"] for k in range(6)]).max() < 1e-12
    assert np.abs(p + np.einsum("ijk,j->ik", R, end) - [run.outputs[f"p{k}"] for k in range(3)]).max() < 1e-13
    assert np.abs(system.jacobian_of("hook", end, run.x[:, 4], parameters=parameters) - J[:, :, 4]).max() == 0


def test_a_force_at_a_point_moves_the_coordinates_by_the_transposed_jacobian(crane):
    """Its power is force . velocity, whatever the rates are."""
    system, end = crane
    x, v, force = np.full(system.n, 0.2), np.linspace(-1, 1, system.n), np.array([3.0, -2.0, 5.0])
    J = system.jacobian_of("hook", end, x)
    assert J[:3].T @ force @ v == pytest.approx(force @ (J[:3] @ v))
    assert system.bodies == ("hull", "mast", "hook")


def test_a_body_that_is_not_there_is_named(crane):
    system, _ = crane
    with pytest.raises(em.ModelError, match="unknown body 'hok'; known: hull, mast, hook"):
        system.pose("hok", np.zeros(system.n))
    with pytest.raises(em.ModelError, match=r"point is \(1, 2\). Give three"):
        system.jacobian_of("hook", (1, 2), np.zeros(system.n))
    with pytest.raises(em.ModelError, match=r"x has shape \(3, 4\)"):
        system.pose("hook", np.zeros((3, 4)))


def test_a_model_of_energies_has_no_bodies():
    system = em.build("models/pendulum.py")
    assert system.bodies == ()
    with pytest.raises(em.ModelError, match=r"pendulum has no bodies: .* State its bodies by eigenmotion\.Tree"):
        system.pose("rod", [0.1])


def test_a_model_read_back_from_a_folder_has_its_bodies(tmp_path, monkeypatch):
    """It has a first-order state as well, of which J has no column."""
    tree, lag = em.Tree(), dynamicsymbols("lag")
    rod = tree.body("rod", joint="revolute", axis="y", mass=1.0, center=(0, 0, -0.5))
    tree.body("slider", rod, joint="prismatic", axis="z", at=(0, 0, -1), mass=0.2)
    model = em.Model(name="swing_of_bodies", coordinates=tree.coordinates, kinetic_energy=tree.kinetic_energy,
                     potential_energy=tree.potential_energy, states={lag: -lag})  # fmt: skip
    em.build(model, output=tmp_path)
    monkeypatch.syspath_prepend(tmp_path)
    system = __import__("swing_of_bodies").system
    R, p = system.pose("slider", {"rod": 0.3, "slider": 0.25})
    assert system.bodies == ("rod", "slider")
    assert np.abs(p - [-0.75 * np.sin(0.3), 0, -0.75 * np.cos(0.3)]).max() < 1e-15
    assert R[0, 2] == pytest.approx(np.sin(0.3))
    J = system.jacobian_of("slider", (0, 0, 0), [[0.3, 0.0], [0.25, 0.25]])
    assert np.abs(J[:3, 1, 0] - [np.sin(0.3), 0, np.cos(0.3)]).max() < 1e-15
    assert np.abs(J[:, :, 1] - [[-0.75, 0], [0, 0], [0, 1], [0, 0], [1, 0], [0, 0]]).max() < 1e-15
