"""System on a model written by hand, against the bead's equations on paper."""

import copy
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pandas
import pytest
from eigenmotion.codegen.model import ModelError
from scipy.integrate import solve_ivp
from sympy import Symbol
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import simulate_ensemble
from eigenmotion.runtime import CompiledModel, EvaluationError

from ..support.hand_written import bead, capsule

M, G, L = 2.0, 9.81, 1.5


def on_circle(angle: float, rate: float) -> tuple[np.ndarray, np.ndarray]:
    """x, v of a pendulum at an angle from the lowest point."""
    return L * np.array([np.sin(angle), -np.cos(angle)]), L * rate * np.array([np.cos(angle), np.sin(angle)])


def swinging(angle: float, rate: float, push: float = 0.0) -> np.ndarray:
    """Acceleration by way of the angle: l angle'' = -g sin(angle) + push cos(angle) / m."""
    turning = (-G * np.sin(angle) + push * np.cos(angle) / M) / L
    along, inward = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
    return L * (turning * along + rate**2 * inward)


def test_tells_what_was_compiled():
    system = bead()
    assert (system.name, system.n, system.m, system.h, system.n_state) == ("bead", 2, 1, 1, 4)
    assert system.coordinates == ("x", "y")
    assert system.parameters == {"m": M, "g": G, "l": L}
    assert system.inputs == {"push": 0.0}
    assert (system.outputs, system.events) == (("tension", "push_seen"), ("lowest", "level"))
    assert system.layout == {"x": slice(0, 2), "v": slice(2, 4)}
    assert system.left_out == ("dM/dx: M is constant",)
    assert system.blocks == ((0,), (1,))
    assert system.formulation == "lagrange"
    assert not system.conserves_energy  # the push does work
    assert repr(system) == "<System bead: n=2, m=1, 4 states, lagrange>"


def test_what_it_hands_out_does_not_change_it():
    system = bead()
    system.parameters["m"] = 7.0
    system.layout.clear()
    system.initial[0][:] = 7.0
    assert system.parameters["m"] == M
    assert system.layout
    np.testing.assert_array_equal(system.initial[0], [1.5, 0.0])


def test_state_takes_arrays_and_names_over_the_initial_values():
    system = bead()
    np.testing.assert_array_equal(system.state(), [1.5, 0, 0, 0])
    np.testing.assert_array_equal(system.state({"y": 3}, [4, 5]), [1.5, 3, 4, 5])
    np.testing.assert_array_equal(system.state({dynamicsymbols("y"): 3}, {"y": 1.0}), [1.5, 3, 0, 1])


@pytest.mark.parametrize(("angle", "rate", "push"), [(0.3, 0.0, 0.0), (-2.0, 1.7, 5.0), (1.0, -3.0, -2.5)])
def test_rhs_and_acceleration(angle, rate, push):
    system, (x, v) = bead(), on_circle(angle, rate)
    a, multipliers = system.acceleration(x, v, inputs={"push": push})
    np.testing.assert_allclose(a, swinging(angle, rate, push), atol=1e-13)
    tension = M * L * rate**2 + M * G * np.cos(angle) + push * np.sin(angle)
    np.testing.assert_allclose(multipliers * L, [tension], atol=1e-12)
    np.testing.assert_allclose(system.rhs(0.0, [*x, *v], inputs={"push": push}), [*v, *a], atol=1e-13)
    np.testing.assert_allclose(system.rhs(0.0, [*x, *v], inputs=[push]), [*v, *a], atol=1e-13)


def test_rhs_of_sampled_inputs():
    system, (x, v) = bead(), on_circle(0.4, 1.0)
    sampled = system.rhs(0.25, [*x, *v], inputs={"push": ([0, 1], [0, 8])})
    np.testing.assert_allclose(sampled[2:], swinging(0.4, 1.0, 2.0), atol=1e-13)


def test_parameters_three_ways():
    system, y = bead(), bead().state([0.9, -1.2])
    prepared = system.prepare({"g": 3.0})
    expected = system.rhs(0, y, {"g": 3.0})
    np.testing.assert_array_equal(system.rhs(0, y, [M, 3.0, L]), expected)
    np.testing.assert_array_equal(system.rhs(0, y, prepared), expected)
    np.testing.assert_array_equal(system.rhs(0, y, {Symbol("g"): 3.0}), expected)
    assert not np.array_equal(system.rhs(0, y), expected)
    assert system.energy([0, -1], [3, 4], parameters=prepared) == pytest.approx(25.0 - 6.0)


@pytest.mark.parametrize(
    "spoiled",
    [
        lambda y: np.repeat(y, 3)[::3],
        lambda y: y[::-1].copy()[::-1],
        lambda y: np.stack([y, y], axis=1)[:, 1],
        list,
        lambda y: y.astype(np.float32),
        lambda y: y.astype(">f8"),
    ],
)
def test_rhs_takes_any_stride_and_number_type(spoiled):
    y = np.array([0.75, -1.25, 0.5, 2.0])
    np.testing.assert_array_equal(bead().rhs(0, spoiled(y)), bead().rhs(0, y))


def test_rhs_never_writes_y_and_never_shares_its_answer():
    system, y = bead(), bead().state([0.9, -1.2], [1.2, 0.9])
    y.flags.writeable = False
    first = system.rhs(0, y)
    kept = first.copy()
    system.rhs(0, [1.0, 1.0, 0.0, 0.0])
    np.testing.assert_array_equal(first, kept)


@pytest.mark.parametrize("out", [np.empty(4), np.empty(8)[::2], np.empty(4, dtype=np.float32)])
def test_rhs_into_out(out):
    y = bead().state([0.75, -1.25], [1.25, 0.75])
    assert bead().rhs(0, y, out=out) is out
    np.testing.assert_allclose(out, bead().rhs(0, y), rtol=1e-6)


def test_out_may_be_y_itself():
    y = bead().state([0.75, -1.25], [1.25, 0.75])
    expected = bead().rhs(0, y)
    bead().rhs(0, y, out=y)
    np.testing.assert_array_equal(y, expected)


def test_out_of_a_wrong_shape_is_refused():
    with pytest.raises(ValueError, match=r"shape|broadcast"):
        bead().rhs(0, np.ones(4), out=np.empty(3))


@pytest.mark.parametrize("method", ["RK45", "DOP853", "Radau", "BDF", "LSODA"])
def test_rhs_is_a_fun_of_scipy(method):
    system, (x, v) = bead(), on_circle(0.5, 0.0)
    found = solve_ivp(system.rhs, (0, 1), system.state(x, v), method=method, rtol=1e-8, atol=1e-8)
    swing = solve_ivp(lambda t, q: [q[1], -G / L * np.sin(q[0])], (0, 1), [0.5, 0], rtol=1e-11, atol=1e-11)
    np.testing.assert_allclose(found.y[:, -1], np.concatenate(on_circle(*swing.y[:, -1])), atol=1e-5)


def test_matrices():
    system = bead()
    np.testing.assert_array_equal(system.mass_matrix([1, 2]), M * np.eye(2))
    np.testing.assert_array_equal(system.mass_matrix_gradient([1, 2]), np.zeros((2, 2, 2)))
    A, b = system.pfaffian([1, 2])
    np.testing.assert_array_equal(A, [[1, 2]])
    np.testing.assert_array_equal(b, [0])


def test_energies():
    assert bead().energy([0, -1], [3, 4]) == pytest.approx(M * 12.5 - M * G)
    assert bead().jacobi_integral({"x": 0, "y": -1}, [3, 4]) == pytest.approx(M * 12.5 - M * G)


def test_project_initial_state():
    given = np.array([3.0, -4.0]), np.array([1.0, 1.0])
    x, v = bead().project_initial_state(*given)
    np.testing.assert_allclose(x, [0.9, -1.2], atol=1e-15)
    np.testing.assert_allclose(v, [28 / 25, 21 / 25], atol=1e-15)
    np.testing.assert_array_equal(given[0], [3.0, -4.0])


def test_failures_have_names_and_remedies():
    with pytest.raises(EvaluationError, match=r"not positive definite at coordinate 'x'.*inertia"):
        bead().rhs(0, [1.5, 0, 0, 0], {"m": 0.0})
    with pytest.raises(EvaluationError, match=r"Constraint row 0.*least_norm"):
        bead().acceleration([0, 0], [0, 0])
    with pytest.raises(EvaluationError, match=r"row 0.*zero"):
        bead().project_initial_state([0, 0], [0, 0])
    a, multipliers = bead().acceleration([0, 0], [0, 0], dependent_constraints="least_norm")
    np.testing.assert_allclose([*a, *multipliers], [0, -G, 0])


def test_evaluation_errors_travel_between_processes():
    with pytest.raises(EvaluationError) as caught:
        bead().acceleration([0, 0], [0, 0])
    twin = copy.copy(caught.value)
    assert (str(twin), twin.stop) == (str(caught.value), caught.value.stop)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda s: s.rhs(0, np.ones(4), {"gravity": 1}), "'gravity'; known: m, g, l"),
        (lambda s: s.rhs(0, np.ones(4), [1, 2]), "m, g, l"),
        (lambda s: s.rhs(0, np.ones(4), {"m": "heavy"}), "'heavy'"),
        (lambda s: s.rhs(0, np.ones(4), {"m": np.nan}), "'m' is not a finite number"),
        (lambda s: s.rhs(0, np.ones(4), inputs={"psh": 1}), "Did you mean 'push'"),
        (lambda s: s.rhs(0, np.ones(5)), r"y has shape \(5,\).*\(4,\)"),
        (lambda s: s.state({"z": 1}), "'z'; known: x, y"),
        (lambda s: s.state({"x": 1, "y'": 2}), "is a rate: give it as v0"),
        (lambda s: s.state([1, 2, 3]), "x, y"),
        (lambda s: s.state(v0={"x": 1, "vy": 2}), "'vy'"),
        (lambda s: s.acceleration([1, 0], [0, 0], dependent_constraints="leastnorm"), "least_norm"),
    ],
)
def test_mistakes_are_value_errors_that_name_what_is_known(call, words):
    with pytest.raises(ValueError, match=words):
        call(bead())


def test_parameters_of_another_model_are_refused():
    other = type(bead())(capsule())
    with pytest.raises(ModelError, match="another compiled model"):
        bead().prepare(other.prepare({"m": 1.0}))


def test_a_capsule_of_another_kind_is_refused():
    with pytest.raises(ValueError, match="PyCapsule"):
        CompiledModel(capsule(b"something.else"))


def test_threads_share_a_system():
    system, angles = bead(), np.linspace(-3, 3, 200)
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda a: [system.rhs(0, np.concatenate(on_circle(a, 1.0))) for _ in range(50)], angles))
    for angle, rows in zip(angles, found, strict=True):
        np.testing.assert_allclose(np.array(rows)[:, 2:], np.tile(swinging(angle, 1.0), (50, 1)), atol=1e-13)


def test_labels_of_pandas_are_names_whatever_their_order():
    x, v = on_circle(0.5, 1.0)
    system, place = bead(), pandas.Series({"y": x[1], "x": x[0]})
    np.testing.assert_array_equal(system.start(place, pandas.Series({"y": v[1], "x": v[0]})), (x, v))
    np.testing.assert_array_equal(system.mass_matrix(x, parameters=pandas.Series({"m": 3.0})), 3.0 * np.eye(2))
    np.testing.assert_array_equal(system.signals(pandas.Series({"push": 2.0}), 0.0), [2.0])
    np.testing.assert_array_equal(system.start(pandas.Series(x))[0], x)  # by numbers: an array
    starts = {
        "x0": pandas.DataFrame({"y": [x[1], -L], "x": [x[0], 0.0]}),
        "v0": pandas.DataFrame({"y": [v[1], 0.0], "x": [v[0], 1.0]}),
    }
    runs = simulate_ensemble(system, (0.0, 0.0), **starts).x[:, :, 0]
    np.testing.assert_array_equal(runs, [x, (0.0, -L)])
