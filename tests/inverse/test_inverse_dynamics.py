"""Inverse dynamics against the equations that it inverts."""

import numpy as np
import pytest
import sympy
from sympy import cos, sin
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

from ..oracles.lagrange import Lagrange
from ..support.generation import FORMULATIONS, NAMES, states, system_for, system_of

BY_DAY = {number: FORMULATIONS[number % len(FORMULATIONS)] for number in range(len(NAMES))}


def consistent(system, count, seed=1):
    """x, v, t of random states on the constraints."""
    for x, v, t in states(system, count, seed):
        try:
            yield *system.project_initial_state(x, v, t), t
        except em.EvaluationError:  # the nearest point on the constraints is far away
            continue


def allowed(system, x, v, t, random):
    """Random accelerations that the constraints allow: those of the motion, and a random admissible part."""
    a, multipliers = system.acceleration(x, v, t)
    A, _ = system.pfaffian(x, t)
    part = random.normal(size=system.n) * (np.abs(a).max() + 1.0)
    return a, multipliers, a + part - np.linalg.pinv(A) @ (A @ part) if system.m else a + part


def forces_for(system, x, v, t, a):
    """M (a - a0) - A^T lambda0: the forces at zero multipliers, from the motion without them."""
    own, multipliers = system.acceleration(x, v, t)
    M, (A, _) = system.mass_matrix(x, t), system.pfaffian(x, t)
    return M @ (a - own) - A.T @ multipliers


def is_smooth(name):
    return not system_of(name).compiled.switches and not system_of(name).compiled.n_states


@pytest.mark.parametrize("name", NAMES)
def test_forces_of_our_models_are_those_of_their_motion(name):
    """M a + A^T lambda = f + forces at random accelerations, with the least forces where they are not unique."""
    if not is_smooth(name):
        pytest.skip("frictions and states have tests of their own")
    system, random = (
        system_of(name, BY_DAY[NAMES.index(name)] if name not in LARGE else "lagrange"),
        np.random.default_rng(5),
    )
    seen = 0
    for x, v, t in consistent(system, 3):
        _, _, a = allowed(system, x, v, t, random)
        found = system.inverse_dynamics(x, v, a, t)
        A, _ = system.pfaffian(x, t)
        right = forces_for(system, x, v, t, a)
        size = np.abs(right).max() + np.abs(A.T @ found.multipliers).max(initial=0.0)
        assert np.abs(found.forces - right - A.T @ found.multipliers).max() <= 1e-11 * size
        assert np.abs(A @ found.forces).max(initial=0.0) <= 1e-10 * size * np.abs(A).max(initial=0.0)
        assert not found.residual.any()
        seen += 1
    assert seen


LARGE = ("bicycle", "humanoid", "jansen", "quadruped")


def four_bar():
    """A four-bar of three angles from the ground, with a spring, damping, gravity and a motor by an input."""
    q = dynamicsymbols("q_1:4")
    u, g = dynamicsymbols("u"), sympy.Symbol("g")
    lengths, masses = (0.4, 1.1, 0.9), (1.2, 2.1, 1.7)
    knee = sympy.Matrix([lengths[0] * cos(q[0]), lengths[0] * sin(q[0])])
    rod = sympy.Matrix([cos(q[1]), sin(q[1])])
    rocker = sympy.Matrix([cos(q[2]), sin(q[2])])
    centres = (knee / 2, knee + lengths[1] * rod / 2, sympy.Matrix([1.0, 0.0]) + lengths[2] * rocker / 2)
    closed = knee + lengths[1] * rod - sympy.Matrix([1.0, 0.0]) - lengths[2] * rocker
    rates = [centre.diff(em.t) for centre in centres]
    T = sum(m * (v.dot(v) / 2 + length**2 / 24 * w.diff() ** 2)
            for m, v, length, w in zip(masses, rates, lengths, q, strict=True))  # fmt: skip
    V = sum(m * g * centre[1] for m, centre in zip(masses, centres, strict=True)) + 3 * (q[2] - 1) ** 2
    return em.Model(name="motor_four_bar", coordinates=q, kinetic_energy=T, potential_energy=V,
                    forces={q[0]: 2 * u - q[0].diff() / 5, q[2]: u / 3}, inputs={u: 0.0}, parameters={g: 9.81},
                    holonomic_constraints={"loop": list(closed)},
                    initial={q[0]: 0.6, q[1]: 0.5, q[2]: 1.3, q[0].diff(): 2.0})  # fmt: skip


def on_four_bar(count=5):
    """The system, its oracle, and consistent x, v with admissible a and the power balance's terms."""
    model = four_bar()
    system, oracle, random = system_for(model), Lagrange(model), np.random.default_rng(2)
    for _ in range(count):
        x, v = system.project_initial_state(
            np.array([0.6, 0.5, 1.3]) + random.normal(0, 0.2, 3), random.normal(0, 2, 3)
        )
        a, _ = system.acceleration(x, v, inputs={"u": random.normal()})
        A = system.pfaffian(x)[0]
        free = np.linalg.svd(A)[2][-1]
        yield system, oracle, x, v, a + free * random.normal(0, 5), free


@pytest.mark.parametrize("actuators", [("q_1",), ("q_3",), ("u",)])
def test_one_actuator_drives_a_four_bar(actuators):
    """The oracle's motion with the force found is the motion asked for."""
    for system, oracle, x, v, a, _ in on_four_bar():
        found = system.inverse_dynamics(x, v, a, actuators=actuators)
        if actuators == ("u",):
            again, multipliers = oracle(x, v, inputs={"u": found.forces[0]})
        else:
            again, multipliers = with_forces(oracle, x, v, {int(actuators[0][2:]) - 1: found.forces[0]})
        assert again == pytest.approx(a, rel=1e-10, abs=1e-10 * np.abs(a).max())
        assert found.multipliers == pytest.approx(multipliers, rel=1e-9, abs=1e-9 * np.abs(multipliers).max())


def with_forces(oracle, x, v, forces):
    """The oracle's accelerations and multipliers with more forces: its own are linear in them."""
    n, m = oracle.n, oracle.m
    values = np.array(oracle._function(*oracle._arguments(x, v, 0.0, None, None)), dtype=float)
    M, A = values[: n * n].reshape(n, n), values[n * n + n + m :].reshape(m, n)
    f = values[n * n : n * n + n].copy()
    for k, force in forces.items():
        f[k] += force
    solved = np.linalg.solve(np.block([[M, A.T], [A, np.zeros((m, m))]]), [*f, *values[n * n + n : n * n + n + m]])
    return solved[:n], solved[n:]


def test_of_several_actuators_the_least_forces_act():
    """They drive the motion, and no other forces that do have a smaller weighted sum of squares."""
    weights = {"q_1": 1.0, "q_3": 4.0, "u": 0.3}
    for system, _, x, v, a, free in on_four_bar():
        r = system.inverse_dynamics(x, v, a, actuators={"q_1": 1.0}).forces[0] * free[0]
        B = np.array([[1.0, 0.0, 2.0], [0.0, 0.0, 0.0], [0.0, 1.0, 1 / 3]])
        along, w = free @ B, np.array(list(weights.values()))
        least = along / w * r / (along / w @ along)
        found = system.inverse_dynamics(x, v, a, actuators=weights)
        assert found.forces == pytest.approx(least, rel=1e-11)
        one = system.inverse_dynamics(x, v, a, actuators=("q_1",))
        A = system.pfaffian(x)[0]
        right = A.T @ one.multipliers - B[:, 0] * one.forces[0]
        assert A.T @ found.multipliers - B @ found.forces == pytest.approx(right, abs=1e-10 * np.abs(right).max())


def test_many_states_in_one_call():
    """Rows, mappings, times and inputs give what single states give."""
    system, _, x, v, a, _ = next(on_four_bar(1))
    X, V, N = np.array([x, x, x]).T, np.array([v, v, v]).T, np.array([a, a, a]).T
    u = np.array([0.0, 1.0, -2.0])
    many = system.inverse_dynamics(X, V, N, np.zeros(3), inputs={"u": u}, actuators=("q_1",))
    assert many.forces.shape == (1, 3)
    assert many.multipliers.shape == (2, 3)
    assert many.residual.shape == (3, 3)
    for k in range(3):
        one = system.inverse_dynamics(x, v, a, inputs={"u": u[k]}, actuators=("q_1",))
        assert np.array_equal(many.forces[:, k], one.forces)
        assert np.array_equal(many.multipliers[:, k], one.multipliers)
    named = {name: X[k] for k, name in enumerate(system.coordinates)}
    again = system.inverse_dynamics(named, V, N, inputs={"u": u}, actuators=("q_1",))
    assert np.array_equal(again.forces, many.forces)
    with pytest.raises(em.ModelError, match="have 2, 3 states"):
        system.inverse_dynamics(X, V[:, :2], N)


def test_what_constraints_do_not_allow_is_refused():
    system, _, x, v, a, _ = next(on_four_bar(1))
    for off, match in (
        (0, r"x does not satisfy constraint 'loop\["),
        (1, "v does not satisfy"),
        (2, "a does not satisfy"),
    ):
        given = [x, v, a]
        given[off] = given[off] + np.array([0.01, 0.0, 0.0])
        with pytest.raises(em.ModelError, match=match):
            system.inverse_dynamics(*given, actuators=("q_1",))
    states = [np.array([one, one]).T for one in (x, v, a)]
    states[2][0, 1] += 0.1
    with pytest.raises(em.ModelError, match=r"state 1 of 2"):
        system.inverse_dynamics(*states, actuators=("q_1",))


def test_actuators_that_are_none_are_refused():
    system = system_for(four_bar())
    x, v = system.project_initial_state()
    a = system.acceleration(x, v)[0]
    for given, match in ((("q_4",), "unknown actuator 'q_4'"), ("q_1", "Give names"), (("q_1", "q_1"), "given twice"),
                         ({"q_1": -1.0}, "weights are positive"), (3, "Give names"), ((), "Give names"),
                         ({}, "Give names"), (([1],), "unknown actuator")):  # fmt: skip
        with pytest.raises(em.ModelError, match=match):
            system.inverse_dynamics(x, v, a, actuators=given)


def cart_pole():
    x, q, F, w = dynamicsymbols("x q F w")
    place = sympy.Matrix([x + 0.7 * sin(q), 0.7 * cos(q)])
    v = place.diff(em.t)
    return em.Model(name="cart_pole", coordinates=[x, q], kinetic_energy=1.5 * x.diff() ** 2 / 2 + 0.4 * v.dot(v) / 2,
                    potential_energy=0.4 * 9.81 * place[1], forces={x: F + w**2}, inputs={F: 0.0, w: 0.0})  # fmt: skip


def test_fewer_actuators_than_freedoms_are_named():
    """What the actuator can drive is driven; what it cannot is refused, with the motion that nobody drives."""
    system = system_for(cart_pole())
    x, v = np.array([0.3, 0.4]), np.array([-0.2, 1.1])
    a = system.acceleration(x, v, inputs={"F": 3.7})[0]
    found = system.inverse_dynamics(x, v, a, actuators=("F",))
    assert found.forces == pytest.approx([3.7], rel=1e-13)
    assert not found.residual.any()
    with pytest.raises(
        em.ModelError, match=r"F cannot drive this motion: it has 2 degrees of freedom, and 1 actuator.*q"
    ):
        system.inverse_dynamics(x, v, a + np.array([0.0, 0.5]), actuators=("F",))
    hanging = system.inverse_dynamics([0.0, np.pi], [0.0, 0.0], [0.0, 0.0], actuators=("x",))
    assert hanging.forces == pytest.approx([0.0], abs=1e-14)
    assert not hanging.residual.any()
    with pytest.raises(em.ModelError, match="not linear in input 'w'"):
        system.inverse_dynamics(x, v, a, actuators=("w",))


def slider_crank(reach=1.0):
    q, p, s = dynamicsymbols("q p s")
    closed = [sympy.Rational(3, 10) * cos(q) + cos(p) * reach - s, sympy.Rational(3, 10) * sin(q) + sin(p) * reach]
    return em.Model(name="crank", coordinates=[q, p, s], potential_energy=3 * s,
                    kinetic_energy=(q.diff() ** 2 / 10 + p.diff() ** 2 / 5 + s.diff() ** 2) / 2,
                    holonomic_constraints={"loop": closed}, initial={q: 0.5, p: -0.1, s: 1.2})  # fmt: skip


def test_dead_centres_are_named():
    """At its dead centre the slider drives nothing; the crank does, and the slider's force is then that of statics."""
    system = system_for(slider_crank())
    dead, rest = np.array([0.0, 0.0, 1.3]), np.zeros(3)
    a = np.array([1.0, -0.3, 0.0])  # turning from rest
    with pytest.raises(
        em.ModelError, match=r"s cannot drive this motion: this position is singular.*q by 1, p by -0.3"
    ):
        system.inverse_dynamics(dead, rest, a, actuators=("s",))
    assert system.inverse_dynamics(dead, rest, a, actuators=("q",)).forces == pytest.approx([0.1 + 0.3**2 * 0.2])
    near = system.project_initial_state({"q": 1e-4, "p": -3e-5, "s": 1.3}, rest).x
    A = system.pfaffian(near)[0]
    free = np.linalg.svd(A)[2][-1]
    a = free / free[0]
    found = system.inverse_dynamics(near, rest, a, actuators=("s",)).forces[0]
    assert found * a[2] == pytest.approx(0.1 + 0.3**2 * 0.2 + a[2] * (3 + a[2]), rel=1e-6)


def test_redundant_rows_are_no_obstacle():
    """A loop stated twice: the force is the same, multipliers are those of least norm."""
    model = slider_crank()
    q, p, s = model.coordinates
    rows = list(model.holonomic_constraints)
    twice = em.Model(name="crank_twice", coordinates=[q, p, s], kinetic_energy=model.kinetic_energy,
                     potential_energy=3 * s, holonomic_constraints=[*rows, rows[0] + 2 * rows[1]],
                     initial={q: 0.5, p: -0.1, s: 1.2})  # fmt: skip
    once, other = system_for(model), system_for(twice)
    x, v = once.project_initial_state({"q": 0.7}, {"q": 1.3})
    a = once.acceleration(x, v)[0]
    forces = [one.inverse_dynamics(x, v, a, actuators=("q",)) for one in (once, other)]
    assert abs(forces[0].forces - forces[1].forces).max() < 1e-12
    A = other.pfaffian(x)[0]
    assert A.T @ forces[1].multipliers == pytest.approx(once.pfaffian(x)[0].T @ forces[0].multipliers, abs=1e-11)
    assert np.abs(np.linalg.svd(A)[0][:, -1] @ forces[1].multipliers) < 1e-10


@pytest.mark.parametrize("units", [1e-3, 1e3])
def test_the_units_of_coordinates_do_not_matter(units):
    """The cart pole with its place in other units: the force of the same actuator scales, refusals are the same."""
    model = cart_pole()
    x = model.coordinates[0]
    small = em.Model(name="cart_units", coordinates=model.coordinates, potential_energy=model.potential_energy,
                     kinetic_energy=model.kinetic_energy.subs(x, x / units).doit(),
                     forces={x: model.forces[0] / units}, inputs=dict(model.inputs))  # fmt: skip
    system, other = system_for(model), system_for(small)
    at, v = np.array([0.3, 0.4]), np.array([-0.2, 1.1])
    a = system.acceleration(at, v, inputs={"F": 3.7})[0]
    scale = np.array([units, 1.0])
    assert other.inverse_dynamics(at * scale, v * scale, a * scale, actuators=("F",)).forces == pytest.approx(
        [3.7], rel=1e-11
    )
    with pytest.raises(em.ModelError, match="cannot drive"):
        other.inverse_dynamics(at * scale, v * scale, (a + np.array([0.0, 1e-5])) * scale, actuators=("F",))


def sliders():
    """Two masses coupled by a bar with Coulomb friction at one, and a motor whose current is a state."""
    x, y, i, U = dynamicsymbols("x y i U")
    friction = em.Friction(x.diff(), limit=0.4)
    return em.Model(name="sliders", coordinates=[x, y], kinetic_energy=(2 * x.diff() ** 2 + 3 * y.diff() ** 2) / 2,
                    states={i: (U - 2 * i - x.diff()) / 5}, inputs={U: 0.0}, forces={x: 7 * i},
                    holonomic_constraints={"bar": x - 2 * y}, contacts={"guide": friction},
                    initial={i: 0.5})  # fmt: skip


@pytest.mark.parametrize(("speed", "rate", "side"), [(1.0, 0.0, 1), (-1.0, 3.0, -1), (0.0, 2.0, 1), (0.0, 0.0, 0)])
def test_frictions_slide_as_the_motion_does(speed, rate, side):
    """By hand: x feels a mass of 2 + 3/4. A friction that stays at rest is left out. The current's force acts."""
    system = system_for(sliders())
    a = np.array([2.0, 1.0]) * rate / 2
    found = system.inverse_dynamics({"i": 0.3, "x": 0.2, "y": 0.1}, {"x": speed, "y": speed / 2}, a, actuators=("x",))
    assert found.forces == pytest.approx([2.75 * rate + 0.4 * side - 7 * 0.3])
    many = system.inverse_dynamics({"i": np.array([0.3, 0.0]), "x": 0.2, "y": 0.1}, {"x": speed, "y": speed / 2}, a,
                                   actuators=("x",))  # fmt: skip
    assert many.forces[0] == pytest.approx([found.forces[0], found.forces[0] + 2.1])
    with pytest.raises(em.ModelError, match=r"U cannot drive.*input 'U' changes no force"):
        system.inverse_dynamics(
            {"i": 0.3, "x": 0.2, "y": 0.1}, {"x": speed, "y": speed / 2}, a + np.array([2.0, 1.0]), actuators=("U",)
        )
    with pytest.raises(em.ModelError, match="first-order state"):
        system.inverse_dynamics([0.2, 0.1], [0.0, 0.0], a, actuators=("i",))


def test_friction_of_a_pin_with_its_reaction():
    """A crank in a bearing whose friction is mu r times the norm of its reaction, by the two balances of forces."""
    q, x, y = dynamicsymbols("q x y")
    mu, m, l, J = 0.3, 2.0, 0.5, 0.1
    pin = {"pin": [x - l * cos(q), y - l * sin(q)]}
    model = em.Model(name="worn", coordinates=[q, x, y], potential_energy=m * 9.81 * y,
                     kinetic_energy=(J * q.diff() ** 2 + m * (x.diff() ** 2 + y.diff() ** 2)) / 2,
                     holonomic_constraints=pin, initial={q: 0.3, x: l},
                     contacts={"bearing": em.Friction(q.diff(), limit=mu / 10, normal="pin")})  # fmt: skip
    system = system_for(model)
    at, speed, rate = 0.7, 3.0, 5.0
    e, n = np.array([np.cos(at), np.sin(at)]), np.array([-np.sin(at), np.cos(at)])
    pull = m * (l * rate * n - l * speed**2 * e) + np.array([0.0, m * 9.81])  # of the pin on the mass
    torque = J * rate + l * pull @ n + mu / 10 * np.linalg.norm(pull)
    found = system.inverse_dynamics([at, *(l * e)], [speed, *(l * speed * n)],
                                    [rate, *(l * rate * n - l * speed**2 * e)], actuators=("q",))  # fmt: skip
    assert found.forces == pytest.approx([torque], rel=1e-12)
    assert np.linalg.norm(found.multipliers) == pytest.approx(np.linalg.norm(pull), rel=1e-12)


def test_closed_contacts_are_refused():
    h = dynamicsymbols("h")
    model = em.Model(name="resting", coordinates=[h], kinetic_energy=h.diff() ** 2 / 2, potential_energy=9.81 * h,
                     contacts={"ground": em.Contact(h)})  # fmt: skip
    system = system_for(model)
    assert system.inverse_dynamics([1.0], [0.0], [2.0]).forces == pytest.approx([11.81])
    with pytest.raises(em.ModelError, match=r"'ground' is closed.*state the contact as a constraint"):
        system.inverse_dynamics([0.0], [0.0], [0.0])


@pytest.mark.parametrize("speed", [(3.0, 4.0), (-3.0, 4.0), (0.0, -4.0), (0.0, 0.0)])
@pytest.mark.parametrize("rate", [(0.0, 0.0), (5.0, 1.0), (-2.0, 1.0), (0.0, 3.0)])
def test_cones_slide_in_the_direction_of_the_slip(speed, rate):
    """A puck of mass 2 on a plane: friction is along its slip, from rest along the slip that begins."""
    x, y = dynamicsymbols("x y")
    model = em.Model(name="puck", coordinates=[x, y], kinetic_energy=x.diff() ** 2 + y.diff() ** 2,
                     contacts={"floor": em.Friction((x.diff(), y.diff()), limit=0.5)})  # fmt: skip
    v, a = np.array(speed), np.array(rate)
    along = v if v.any() else a
    friction = 0.5 * along / np.linalg.norm(along) if along.any() else np.zeros(2)
    found = system_for(model).inverse_dynamics([0.3, -0.2], v, a)
    assert found.forces == pytest.approx(2 * a + friction, rel=1e-13)


def test_rounding_of_positions_is_no_refusal():
    """A residual of 1e-170 beside terms as small is nothing where the row could be 1."""
    p, q = dynamicsymbols("p q")
    model = em.Model(name="axes", coordinates=[p, q], kinetic_energy=(p.diff() ** 2 + q.diff() ** 2) / 2,
                     holonomic_constraints=[p * q], initial={p: 1.0})  # fmt: skip
    system = system_for(model)
    found = system.inverse_dynamics([1.0, 1e-170], [0.0, 0.0], [2.0, 0.0], actuators=("p",))
    assert found.forces == pytest.approx([2.0])
    with pytest.raises(em.ModelError, match="x does not satisfy"):
        system.inverse_dynamics([1.0, 1e-5], [0.0, 0.0], [2.0, 0.0], actuators=("p",))


def test_inputs_that_multiply_each_other():
    """A steered thruster: its thrust is an actuator at a known angle, and not both together."""
    x, y, thrust, angle = dynamicsymbols("x y thrust angle")
    model = em.Model(name="thruster", coordinates=[x, y], kinetic_energy=x.diff() ** 2 + y.diff() ** 2,
                     forces={x: thrust * cos(angle), y: thrust * sin(angle)},
                     inputs={thrust: 0.0, angle: 0.3})  # fmt: skip
    system = system_for(model)
    found = system.inverse_dynamics([0, 0], [0, 0], [3 * np.cos(0.7), 3 * np.sin(0.7)], inputs={"angle": 0.7},
                                    actuators=("thrust",))  # fmt: skip
    assert found.forces == pytest.approx([6.0], rel=1e-14)
    with pytest.raises(em.ModelError, match="not linear in input 'angle'"):
        system.inverse_dynamics([0, 0], [0, 0], [1, 1], actuators=("angle",))
    q, u, w = dynamicsymbols("q u w")
    mixed = system_for(em.Model(name="mixed", coordinates=[q], kinetic_energy=q.diff() ** 2 / 2, forces={q: u * w + u},
                                inputs={u: 0.0, w: 2.0}))  # fmt: skip
    assert mixed.inverse_dynamics([0], [0], [6.0], actuators=("u",)).forces == pytest.approx([2.0])
    assert mixed.inverse_dynamics([0], [0], [6.0], actuators=("w",), inputs={"u": 1.5}).forces == pytest.approx([3.0])
    with pytest.raises(em.ModelError, match="not linear in inputs 'u' and 'w' together"):
        mixed.inverse_dynamics([0], [0], [6.0], actuators=("u", "w"))
