"""Regressors against SymPy's derivatives, Pinocchio and inverse dynamics."""

import numpy as np
import pytest
import sympy
from sympy import cos, sin
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

from ..equations.test_equation_partials import by_sympy
from ..states.mechanisms import servo
from ..support import hand_written
from ..support.example_robots import pinocchio, robot_file
from ..support.generation import model_of, system_for
from ..support.random_machines import Machine
from .mechanisms import crank_four_bar


def random_motion(system, count, seed=3):
    """x, v, a (n, count), off the constraints."""
    random, n = np.random.default_rng(seed), system.n
    x = system.initial[0][:n, None] + random.uniform(-0.4, 0.4, (n, count))
    return x, random.normal(size=(n, count)), random.normal(size=(n, count))


@pytest.mark.parametrize("of", ["crank_four_bar", "four_bar"])
def test_four_bars_against_sympy(of):
    model, names = (crank_four_bar(), None) if of == "crank_four_bar" else (model_of("four_bar"), ["density"])
    system = system_for(model)
    names = [name for name in system.parameters if name != "g"] if names is None else names
    x, v, a = random_motion(system, 3)
    found = system.regressor(names, x, v, a)
    known = list(system.parameters)
    columns = [2 * system.n + known.index(name) for name in names]
    for k in range(3):
        right = by_sympy(model, 0.0, x[:, k], v[:, k], a[:, k], np.zeros(system.m))[: system.n, columns]
        assert np.abs(found.Y[..., k] - right).max() < 1e-11 * max(1.0, np.abs(right).max())


def test_a_regressor_unpacks_as_Y_and_rest():
    """At one state and at many: Y p + rest are the forces of a motion without reactions."""
    system = system_for(servo())
    x, v, a = random_motion(system, 2)
    for state in ((x, v, a), (x[:, 0], v[:, 0], a[:, 0])):
        Y, rest = found = system.regressor(list(system.parameters)[:1], *state)
        assert Y is found.Y
        assert rest is found.rest
        assert Y.shape == (system.n, 1, *state[0].shape[1:])
        assert rest.shape == state[0].shape


@pytest.mark.parametrize("seed", [1, 4, 7, *(pytest.param(seed, marks=pytest.mark.nightly) for seed in range(10, 20))])
def test_random_machines_need_the_forces_of_inverse_dynamics(seed):
    """Y p + rest at other values of the parameters; geared joints have ratios that are not linear."""
    machine = Machine(seed, moments=seed % 2 == 0)
    system, linear = system_for(machine.model, "articulated_body"), []
    x, v, a = random_motion(system, 3)
    for name in system.parameters:
        try:
            linear += system.regressor([name], x, v, a).parameters
        except em.ModelError:  # it drives a joint
            continue
    masses = [str(body.link.mass) for body in machine.made.bodies if str(body.link.mass) in linear]
    if not masses:
        pytest.skip("it has no masses that are parameters")
    found = system.regressor(masses, x, v, a)
    values = dict(zip(masses, np.random.default_rng(seed).uniform(0.3, 3, len(masses)), strict=True))
    p = system.parameters | values
    forces = np.einsum("nks,k->ns", found.Y, list(values.values())) + found.rest
    right = system.compiled.required_rows(np.zeros(3), x.T, v.T, a.T, np.zeros((3, 0)), system.prepare(p))[0].T
    assert np.abs(forces - right).max() < 1e-12 * (np.abs(found.Y).max() * 3 + np.abs(right).max())
    if not system.m:
        assert (
            np.abs(forces - system.inverse_dynamics(x, v, a, parameters=p).forces).max() < 1e-12 * np.abs(right).max()
        )


def test_first_order_states_have_no_forces():
    system = system_for(servo())
    found = system.regressor(["J", "K"], {"theta": 0.3, "i": 0.4}, [1.1], [0.7])
    assert np.abs(found.Y - [[0.7, -0.4]]).max() < 1e-15
    assert found.rest == pytest.approx([3 * np.sin(0.3)])


def test_modes_of_frictions_are_no_parameters():
    system = system_for(rubbing())
    hidden = system.compiled.parameters[system.compiled.switches[0][2]]
    with pytest.raises(em.ModelError, match=f"unknown parameter {hidden!r}"):
        system.regressor([hidden], [0.0], [1.0], [0.0])


def rubbing():
    x, mu, m = dynamicsymbols("x"), *sympy.symbols("mu m")
    return em.Model(name="rubbing", coordinates=[x], kinetic_energy=m * x.diff() ** 2 / 2, parameters={mu: 0.4, m: 2.0},
                    contacts={"guide": em.Friction(x.diff(), limit=mu * 5)})  # fmt: skip


def test_limits_of_frictions_are_linear():
    found = system_for(rubbing()).regressor(
        ["mu", "m"], np.zeros((1, 3)), np.array([[1.0, -1.0, 0.0]]), np.zeros((1, 3))
    )
    assert found.Y[0, 0] == pytest.approx([5.0, -5.0, 0.0])
    assert found.rest == pytest.approx(np.zeros((1, 3)))


def rod():
    q = dynamicsymbols("q")
    m, length, g, k, c = sympy.symbols("m l g k c")
    return em.Model(name="rod_of_parameters", coordinates=[q], kinetic_energy=m * length**2 * q.diff() ** 2 / 2,
                    potential_energy=-m * g * length * cos(q), forces={q: -k * q - c * sin(k * q)},
                    parameters={m: 1.0, length: 0.8, g: 9.81, k: 2.0, c: 0.1})  # fmt: skip


@pytest.mark.parametrize(("names", "words"), [
    (("l",), "not linear in parameter 'l'"), (("m", "g"), "contain the product of parameters 'm' and 'g'"),
    (("k",), "not linear in parameter 'k'"), (("q",), "unknown parameter 'q'"), ((), "Give names"), ("m", "Give names"),
    (("m", "m"), "given twice"),
])  # fmt: skip
def test_parameters_that_are_not_linear_are_named(names, words):
    with pytest.raises(em.ModelError, match=words):
        system_for(rod()).regressor(names, [0.3], [0.1], [0.2])


def test_linearity_does_not_depend_on_the_states_asked_for():
    """At rest in q = 0 forces are linear in anything."""
    with pytest.raises(em.ModelError, match="not linear"):
        system_for(rod()).regressor(["l"], [0.0], [0.0], [0.0])


def test_models_by_hand_have_none():
    with pytest.raises(em.ModelError, match="was written by hand"):
        hand_written.bead().regressor(["g"], [0.0, 0.0], [0.0, 0.0], [0.0, 0.0])


def test_constraints_that_depend_on_parameters_leave_no_linear_forces():
    x, y, length, m = *dynamicsymbols("x y"), *sympy.symbols("length m")
    model = em.Model(name="string", coordinates=[x, y], kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2) / 2,
                     parameters={length: 1.2, m: 1.0}, holonomic_constraints=[x + length * y])  # fmt: skip
    found = system_for(model).regressor(["m", "length"], [0.0, 0.0], [0.0, 0.0], [1.0, 2.0])
    assert np.abs(found.Y - [[1.0, 0.0], [2.0, 0.0]]).max() < 1e-15
    with pytest.raises(em.ModelError, match="constraints depend on 'length'"):
        _ = found.free
    Y, rest = system_for(model).regressor(["m"], [0.0, 0.0], [0.0, 0.0], [1.2, -1.0]).free
    assert abs(Y[0, 0]) == pytest.approx(np.hypot(1.2, 1.0))
    assert rest == pytest.approx([0.0])


def test_the_inertial_parameters_of_a_robot_against_pinocchio():
    """All 60 columns of a UR5; tools that are fixed to its last link have ten more."""
    pin, file = pinocchio(), robot_file("ur_description/urdf/ur5_robot.urdf")
    theirs = pin.buildModelFromUrdf(str(file))
    system = em.build(em.load_urdf(file, inertial_parameters=True))
    links = ("shoulder", "upper_arm", "forearm", "wrist_1", "wrist_2", "wrist_3")
    order = ("m", "mx", "my", "mz", "Ixx", "Ixy", "Iyy", "Ixz", "Iyz", "Izz")
    names = [f"{letter}_{link}_link" for link in links for letter in order]
    assert system.coordinates == tuple(theirs.names)[1:]
    random = np.random.default_rng(2)
    x, v, a = random.uniform(-3, 3, (6, 20)), random.normal(0, 2, (6, 20)), random.normal(0, 5, (6, 20))
    found, data = system.regressor(names, x, v, a), theirs.createData()
    for k in range(20):
        right = pin.computeJointTorqueRegressor(theirs, data, x[:, k], v[:, k], a[:, k])
        assert np.abs(found.Y[..., k] - right).max() < 1e-10 * np.abs(right).max()
        forces = found.Y[..., k] @ found.values + found.rest[:, k]
        assert forces == pytest.approx(pin.rnea(theirs, data, x[:, k], v[:, k], a[:, k]), abs=1e-10)
