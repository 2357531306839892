"""First-order states in all that takes a mechanism: starts, ensembles, steppers, derivatives, linear models, files."""

import pickle

import numpy as np
import pytest
from eigenmotion.codegen.compiler import explain
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

from ..support.generation import system_for
from .mechanisms import K, e, i, ref, servo, theta

TOLERANCES = {"rtol": 1e-11, "atol": 1e-12}


@pytest.fixture(scope="module")
def system():
    return system_for(servo())


def end(found) -> np.ndarray:
    return np.array([found.x[0, -1], found.v[0, -1], *(values[-1] for values in found.states.values())])


def test_starts_by_name_and_by_array(system):
    named = system.simulate((0, 1), x0={"i": 0.3, theta: 0.2}, **TOLERANCES)
    array = system.simulate((0, 1), x0=[0.2, 0.3, 0.0], **TOLERANCES)
    np.testing.assert_array_equal(named.y, array.y)
    assert system.simulate((0, 1), x0=[0.2], **TOLERANCES).states["i"][0] == 0.1
    go_on = system.simulate((1, 2), start=named, **TOLERANCES)
    np.testing.assert_allclose(end(go_on), end(system.simulate((0, 2), x0=[0.2, 0.3, 0.0], **TOLERANCES)), atol=1e-10)


def test_copies_go_on(system):
    found = system.simulate((0, 1), x0={"i": 0.3}, **TOLERANCES)
    copied = pickle.loads(pickle.dumps(found))
    np.testing.assert_array_equal(copied.states["i"], found.states["i"])
    np.testing.assert_array_equal(system.simulate((1, 2), start=copied).y, system.simulate((1, 2), start=found).y)


def test_consistent_states_are_of_coordinates(system):
    x, v = system.project_initial_state({"i": 0.3})
    assert x.shape == v.shape == (1,)
    x, v = em.assemble(system, {"theta": 0.2})
    assert x.shape == v.shape == (1,)
    assert system.mass_matrix([0.1]).shape == (1, 1)
    assert system.acceleration([0.1, 0.2, 0.3], [0.4])[0] == pytest.approx(0.2 - 3 * np.sin(0.1))
    assert system.energy([0.1], [0.4]) == pytest.approx(0.08 - 3 * np.cos(0.1))


def test_wrong_starts_are_named(system):
    with pytest.raises(em.ModelError, match="'i', which is a state"):
        system.simulate((0, 1), v0={"i": 1.0})
    with pytest.raises(em.ModelError, match="unknown coordinate of x0 'j'"):
        system.simulate((0, 1), x0={"j": 1.0})
    with pytest.raises(em.ModelError, match="shape"):
        system.simulate((0, 1), x0=[0.1, 0.2])


def test_members_of_an_ensemble_are_runs_of_their_own(system):
    runs = em.simulate_ensemble(
        system, (0, 1), x0={"i": [0.1, 0.3, -0.2]}, parameters={"K": [1.0, 2.0, 0.5]}, **TOLERANCES
    )
    assert runs.x.shape == (3, 1, 1)
    for k, (amperes, constant) in enumerate(zip([0.1, 0.3, -0.2], [1.0, 2.0, 0.5], strict=True)):
        alone = system.simulate((0, 1), x0={"i": amperes}, parameters={K: constant}, **TOLERANCES)
        np.testing.assert_array_equal(runs[k].y[:, -1], alone.y[:, -1])
        assert runs.states["i"][k, -1] == alone.states["i"][-1]
        assert runs.states["e"][k, -1] == alone.states["e"][-1]
    assert set(runs.swept) == {"i(0)", "K"}


def test_steppers_come_to_the_same(system):
    right = system.simulate((0, 1), x0={"i": 0.3}, **TOLERANCES)
    one = system.stepper(x0={"i": 0.3}, **TOLERANCES)
    one.advance(1.0)
    np.testing.assert_allclose([*one.x, *one.v, *one.states.values()], end(right), atol=1e-10)
    assert one.energy == pytest.approx(right.energy[-1], abs=1e-10)
    many = system.steppers(2, x0={"i": [0.3, 0.1]}, **TOLERANCES)
    many.advance(1.0)
    np.testing.assert_allclose(many.states["i"][0], one.states["i"], atol=1e-10)
    assert many.x.shape == (2, 1)
    many.reset([1], x0={"i": [0.3, 0.3]})
    many.advance(np.array([1.0, 1.0]))
    np.testing.assert_allclose(many.states["i"][1], one.states["i"], atol=1e-10)


@pytest.mark.parametrize("method", ["dop853", "radau9"])
def test_sensitivities_against_differences(system, method):
    asked, h = ["i", "e", "theta", "theta'", "K", "ref"], 1e-4
    found = system.simulate((0, 1), sensitivities=asked, method=method, **TOLERANCES)

    def shifted(name, by):
        start, rates, other = {"i": 0.1, "e": 0.0, "theta": 0.5}, {"theta": 0.0}, {"K": 1.0}
        table = start if name in start else rates if name.endswith("'") else other
        inputs = {"ref": 1.0 + by} if name == "ref" else {}
        if name != "ref":
            table[name.rstrip("'")] += by
        return end(system.simulate((0, 1), x0=start, v0=rates, parameters=other, inputs=inputs, **TOLERANCES))

    for name in asked:
        one = found.sensitivity[name]
        right = (8 * (shifted(name, h) - shifted(name, -h)) - (shifted(name, 2 * h) - shifted(name, -2 * h))) / (12 * h)
        np.testing.assert_allclose([one.dx[0, -1], one.dv[0, -1], *one.dz[:, -1]], right, rtol=1e-6, atol=1e-7)
        assert one.dx.shape == one.dv.shape == (1, len(found.t))


def test_sensitivities_of_an_ensemble(system):
    runs = em.simulate_ensemble(system, (0, 1), x0={"i": [0.1, 0.3]}, sensitivities=["i"], **TOLERANCES)
    one = system.simulate((0, 1), x0={"i": 0.3}, sensitivities=["i"], **TOLERANCES).sensitivity["i"]
    np.testing.assert_allclose(runs.sensitivity["i"].dz[1, :, -1], one.dz[:, -1], atol=1e-9)
    np.testing.assert_allclose(runs.sensitivity["i"].dx[1, :, -1], one.dx[:, -1], atol=1e-9)


def test_the_jacobian_of_the_right_hand_side():
    lagrange, h = system_for(servo(), "lagrange"), 1e-6
    y = lagrange.state(x0={"theta": 0.3, "i": 0.2, "e": 0.1}, v0={"theta": 0.4})
    columns = [(lagrange.rhs(0.0, y + h * d) - lagrange.rhs(0.0, y - h * d)) / (2 * h) for d in np.eye(len(y))]
    np.testing.assert_allclose(lagrange.jacobian(0.0, y), np.transpose(columns), atol=1e-7)


def test_equilibrium_and_linear_model(system):
    """The controller's integral is an eigenvalue, and nothing else is added."""
    rest = em.find_equilibrium(system)
    assert rest.success
    assert rest.x[0] == pytest.approx(1.0, abs=1e-12)
    assert rest.states["i"] == pytest.approx(3 * np.sin(1.0), abs=1e-12)
    right = np.array([[0, 1, 0, 0], [-3 * np.cos(1.0), 0, 1, 0], [-50, -10, -20, 30], [-1, 0, 0, 0]])
    linear = rest.linearize()
    np.testing.assert_allclose(linear.full.A, right, atol=1e-12)
    np.testing.assert_allclose(
        np.sort_complex(linear.eigenvalues()), np.sort_complex(np.linalg.eigvals(right)), rtol=1e-9
    )
    np.testing.assert_allclose(linear.full.B[:, 0], [0, 0, 50, 1], atol=1e-12)
    np.testing.assert_allclose(linear.full.C[1], [0, rest.states["i"], 0, 0], atol=1e-12)
    assert linear.steady
    assert linear.message == "steady: at rest"
    last = linear.modes()[-1]
    assert last.coordinates[np.argmax(last.share)] == "i"
    other = em.find_equilibrium(system, free=["theta", "i", "e"], inputs={"ref": 0.5})
    assert other.x[0] == pytest.approx(0.5, abs=1e-12)


def test_saved_and_pictured(system, tmp_path):
    found = system.simulate((0, 1))
    found.save(tmp_path / "run.csv")
    head, *rows = (tmp_path / "run.csv").read_text().splitlines()
    assert head.split(",") == ["t", "theta", "theta'", "energy", "voltage", "power", "i", "e"]
    assert float(rows[-1].split(",")[-2]) == found.states["i"][-1]
    found.save(tmp_path / "run.npz")
    with np.load(tmp_path / "run.npz") as file:
        np.testing.assert_array_equal(file["state_e"], found.states["e"])
    labels = [text.get_text() for text in found.plot().axes[0].texts]
    assert len(labels) == 3


def test_controllers_measure_states(system):
    """x of a Sampled function has the states behind the coordinates."""
    seen = []

    def law(t, x, v):
        seen.append((len(x), len(v), x[1]))
        return 1.0

    system.simulate((0, 0.5), inputs={"ref": em.Sampled(law, 0.25)})
    assert [one[:2] for one in seen] == [(3, 1)] * len(seen)
    assert seen[0][2] == 0.1


def test_controllers_of_an_ensemble_measure_what_those_of_single_runs_do(system):
    """A law that feeds back a state, which single runs and ensembles have behind the coordinates."""
    given = {"t_eval": np.linspace(0, 1, 5), **TOLERANCES}
    law = {"ref": em.Sampled(lambda t, x, v: float(x[1] - x[2] + v[0]), 0.125)}
    runs = em.simulate_ensemble(system, (0, 1), x0={"i": [0.1, 0.3]}, inputs=law, **given)
    for k, amperes in enumerate([0.1, 0.3]):
        alone = system.simulate((0, 1), x0={"i": amperes}, inputs=law, **given)
        np.testing.assert_array_equal(runs[k].y, alone.y)


def test_what_describes_a_model_names_states(system):
    assert "{i}: constant" in explain(servo())
    assert "z        y[4:6]" in explain(servo())
    assert r"\frac{d}{d t} e" in servo().equations().latex() or r"\dot{e}" in servo().equations().latex()


# --- models ---

y, FUEL = dynamicsymbols("y"), dynamicsymbols("fuel", positive=True)


@pytest.mark.parametrize(("change", "words"), [
    ({"states": {y.diff(): 1}}, "not a function of time"),
    ({"states": {FUEL: -1}, "initial": {}, "forces": {}, "outputs": {}}, "'fuel', declared positive"),
    ({"states": {theta: 1}}, "both a coordinate and a state"),
    ({"states": {i: 1, e: dynamicsymbols("unheard")}}, "unheard.*not declared"),
    ({"kinetic_energy": i * theta.diff() ** 2}, "kinetic_energy contains the state 'i'.*forces"),
    ({"holonomic_constraints": [theta - i]}, "holonomic_constraints.*state 'i'"),
    ({"nonholonomic_constraints": [theta.diff() - i]}, "nonholonomic_constraints.*state 'i'"),
    ({"states": {i: i.diff() + 1, e: 0}}, "i'"),
    ({"initial": {y: 1.0}}, "'y'|y\\(t\\)"),
    ({"inputs": {i: 0.0, ref: 1.0}}, "named twice"),
])  # fmt: skip
def test_mistakes_are_named(change, words):
    with pytest.raises(em.ModelError, match=words):
        servo(**change)


def test_a_model_without_states_has_the_text_that_it_had():
    plain = servo(states={}, forces={}, initial={}, outputs={})
    assert "states" not in plain.canonical()
    assert "states" in servo().canonical()


def test_a_drawing_shows_a_state():
    """A gauge of a filtered speed: at the rows, between them, and through dense output."""
    gauge = dynamicsymbols("gauge")
    model = em.Model(
        name="gauge", coordinates=[theta], kinetic_energy=theta.diff() ** 2 / 2, potential_energy=2 * theta**2,
        states={gauge: 3 * (theta.diff() - gauge)}, initial={theta: 1.0},
        drawing=[em.draw.Line((theta, 0), (gauge, 1))],
    )  # fmt: skip
    times = np.linspace(0.1, 1.9, 7)
    for dense in (False, True):
        found = em.build(model).simulate((0, 2), rtol=1e-9, atol=1e-12, dense_output=dense, max_step=0.02)
        at_rows = found.drawing.numbers
        np.testing.assert_allclose(at_rows[:, 2], found.states["gauge"], rtol=0, atol=1e-15)
        between = found.drawn(times).numbers
        exact = em.build(model).simulate((0, 2), rtol=1e-11, atol=1e-13, t_eval=times)
        np.testing.assert_allclose(between[:, 0], exact.x[0], rtol=0, atol=1e-6)
        np.testing.assert_allclose(between[:, 2], exact.states["gauge"], rtol=0, atol=1e-4 if not dense else 1e-8)
