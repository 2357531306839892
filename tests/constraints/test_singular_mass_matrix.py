"""M singular whatever x is, but regular along the constraints: M + A^T W A is factored, and everything else holds."""

from functools import cache

import numpy as np
import pytest
import sympy
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, ModelError, build, t

from ..oracles import Lagrange
from ..support.failing_runs import FORMULATIONS, check_honest
from ..support.generation import relative, system_for

X, Y, Z = dynamicsymbols("x y z")
m, k, g, unit, mass = symbols("m k g unit mass", positive=True)
FORMS = pytest.mark.parametrize("formulation", FORMULATIONS)
OPTIONS = {"extrapolate": {"close_eigenvalues": "extrapolate"}, "schur": {"schur": "eigenfactor"}}
VARIANTS = [*(pytest.param(f, {}, id=f) for f in FORMULATIONS),
            *(pytest.param("eigenfactor", given, id=name) for name, given in OPTIONS.items())]  # fmt: skip


def bead() -> Model:
    """A bead on the curve z = sin(x): the height carries weight and a spring, but no mass."""
    return Model(
        name="bead", coordinates=[X, Z], kinetic_energy=m * X.diff() ** 2 / 2, potential_energy=g * Z + k * Z**2 / 2,
        holonomic_constraints=[Z - sin(X)], parameters={m: 2.0, g: 9.81, k: 5.0},
        initial={X: 0.4, Z: np.sin(0.4), X.diff(): 1.0, Z.diff(): np.cos(0.4)},
    )  # fmt: skip


def reduced_bead() -> Model:
    """The same bead without its height."""
    height = sin(X)
    return Model(
        name="reduced_bead", coordinates=[X], kinetic_energy=m * X.diff() ** 2 / 2,
        potential_energy=g * height + k * height**2 / 2, parameters={m: 2.0, g: 9.81, k: 5.0},
        initial={X: 0.4, X.diff(): 1.0},
    )  # fmt: skip


def chained() -> Model:
    """Massless coordinates behind each other, one row that moves, one of velocities, a row that is not needed."""
    q = dynamicsymbols("q:5")
    energy = (2 + cos(q[0])) * q[0].diff() ** 2 / 2 + m * q[1].diff() ** 2 / 2 + q[0].diff() * q[1].diff() / 3
    return Model(
        name="chained", coordinates=q, kinetic_energy=energy, forces={q[2]: q[1] - q[2].diff(), q[4]: sin(t)},
        potential_energy=k * (q[2] ** 2 + q[0] * q[3]),
        holonomic_constraints=[q[2] - q[0] * q[1] - sin(t) / 4, q[3] - q[2] - q[0] ** 2],
        nonholonomic_constraints=[q[4].diff() - (2 + sin(t)) * q[1] * q[0].diff() - cos(t)],
        parameters={m: 1.5, k: 3.0}, initial={q[0]: 0.4, q[1]: 0.3, q[2]: 0.12, q[3]: 0.28},
    )  # fmt: skip


def two_quaternions() -> Model:
    """Two bodies by quaternions, one on the other: two singular blocks that the energy couples, one row each."""
    p, q = dynamicsymbols("p:4"), dynamicsymbols("q:4")
    one, two = rates(p), rates(q)
    energy = one.dot(sympy.diag(1, 2, 3) * one) / 2 + two.dot(sympy.diag(3, 1, 2) * two) / 2 + one.dot(two) / 4
    return Model(
        name="two_quaternions", coordinates=[*p, *q], kinetic_energy=energy, potential_energy=p[0] * q[1],
        holonomic_constraints=[sum(e**2 for e in p) - 1, sum(e**2 for e in q) - 1],
        initial={p[0]: 0.6, p[1]: 0.8, q[0]: 1.0, q[1].diff(): 0.3, p[2].diff(): 0.4},
    )  # fmt: skip


def rates(q: list[sympy.Expr]) -> sympy.Matrix:
    vector = sympy.Matrix(q[1:])
    return 2 * (q[0] * vector.diff(t) - q[0].diff(t) * vector - vector.cross(vector.diff(t)))


SINGULAR = {"bead": bead, "chained": chained, "two_quaternions": two_quaternions}


@cache
def model_named(name: str) -> Model:
    return SINGULAR[name]()


@cache
def lagrange(name: str) -> Lagrange:
    return Lagrange(model_named(name))


@pytest.mark.parametrize(("formulation", "options"), VARIANTS)
@pytest.mark.parametrize("name", list(SINGULAR))
def test_accelerations_and_multipliers_are_those_of_the_kkt_system(name, formulation, options):
    """On the constraints and off them, against a dense solution with SymPy's own M, A and f."""
    if (name, formulation) == ("two_quaternions", "inverse"):
        pytest.skip("a block of eight coordinates is too large for an algebraic inverse")
    system, random = system_for(model_named(name), formulation, **options), np.random.default_rng(8)
    x0, _ = system.initial
    for at in (0.0, 0.7):
        x, v = x0 + random.uniform(-0.2, 0.2, system.n), random.normal(size=system.n)
        right = lagrange(name)(x, v, at)
        found = system.acceleration(x, v, at)
        assert relative(found[0], right[0]) < 1e-12
        assert relative(found[1], right[1]) < 1e-12
        y = system.state(x, v, at)
        dy = system.rhs(at, y)
        assert relative(dy[: system.n], v) < 1e-12
        if formulation in ("lagrange", "inverse"):
            assert relative(dy[system.n :], right[0]) < 1e-11


@pytest.mark.parametrize(("formulation", "options"), VARIANTS)
@pytest.mark.parametrize("name", list(SINGULAR))
def test_every_variant_runs_and_agrees_with_the_reference(name, formulation, options):
    if (name, formulation) == ("two_quaternions", "inverse"):
        pytest.skip("a block of eight coordinates is too large for an algebraic inverse")
    system, at = system_for(model_named(name), formulation, **options), np.linspace(0, 1, 5)
    start = system.project_initial_state()
    found = system.simulate((0, 1), x0=start.x, v0=start.v, t_eval=at, rtol=1e-10, atol=1e-10)
    check_honest(found)
    assert found.success, found.message
    right = lagrange_motion(name)
    np.testing.assert_allclose(found.x[:, -1], right[: system.n], atol=2e-8)
    np.testing.assert_allclose(found.v[:, -1], right[system.n :], atol=2e-7)


@cache
def lagrange_motion(name: str) -> np.ndarray:
    """(x, v) at t = 1 by SciPy with the dense KKT system, from the projected start."""
    from scipy.integrate import solve_ivp  # noqa: PLC0415

    start, right = system_for(model_named(name), "lagrange").project_initial_state(), lagrange(name)
    n = len(start.x)

    def rate(time: float, y: np.ndarray) -> np.ndarray:
        return np.concatenate([y[n:], right(y[:n], y[n:], time)[0]])

    ends = solve_ivp(rate, (0, 1), [*start.x, *start.v], method="DOP853", rtol=1e-11, atol=1e-11)
    return np.asarray(ends.y[:, -1])


@FORMS
@pytest.mark.parametrize("method", ["dop853", "rk34", "radau5", "radau9"])
def test_a_massless_coordinate_moves_as_the_reduced_model(formulation, method):
    if method in ("radau5", "radau9") and formulation != "lagrange":
        pytest.skip("implicit methods integrate x, v whatever the formulation")
    tolerance = 1e-10 if method == "dop853" else 1e-6
    options = {"t_eval": [1.0, 2.0], "method": method, "rtol": tolerance, "atol": tolerance}
    found = system_for(bead(), formulation).simulate((0, 2), **options)
    right = system_for(reduced_bead(), "lagrange").simulate((0, 2), t_eval=[1.0, 2.0], rtol=1e-12, atol=1e-12)
    check_honest(found)
    assert found.success, found.message
    np.testing.assert_allclose(found.x[0], right.x[0], atol=300 * tolerance)
    np.testing.assert_allclose(found.multipliers[0], -(9.81 + 5.0 * np.sin(found.x[0])), rtol=1e-9)  # no inertia in it


def scaled_bead() -> Model:
    """The bead with lengths in `unit` metres and masses in `mass` kilogrammes."""
    length, weight = unit, mass
    return Model(
        name="scaled_bead", coordinates=[X, Z], kinetic_energy=m * weight * X.diff() ** 2 / 2,
        potential_energy=weight * (g * Z * length + k * Z**2 / 2), holonomic_constraints=[Z - length * sin(X / length)],
        parameters={m: 2.0, g: 9.81, k: 5.0, unit: 1.0, mass: 1.0}, initial={X: 0.0, X.diff(): 1.0, Z.diff(): 1.0},
    )  # fmt: skip


@FORMS
@pytest.mark.parametrize("of_mass", [1e-6, 1e6])
@pytest.mark.parametrize("of_length", [1e-6, 1e6])
def test_weights_follow_the_units_of_a_parameter_set(formulation, of_length, of_mass):
    system = system_for(scaled_bead(), formulation)
    parameters = {"unit": of_length, "mass": of_mass}
    x, v = np.array([0.4, np.sin(0.4)]), np.array([1.0, np.cos(0.4)])
    a, multipliers = system.acceleration(of_length * x, of_length * v, parameters=parameters)
    right = system.acceleration(x, v)
    np.testing.assert_allclose(a / of_length, right[0], rtol=1e-13)
    np.testing.assert_allclose(multipliers / (of_length * of_mass), right[1], rtol=1e-13)


def test_only_the_rows_that_are_needed_couple_coordinates():
    """A body on a ball joint, by its centre and a quaternion: the norm makes up for M, the joint couples nothing."""
    q, place = dynamicsymbols("q:4"), sympy.Matrix([X, Y, Z])
    omega, arm = rates(q), sympy.Matrix([2 * (q[1] * q[3] + q[0] * q[2]), 2 * (q[2] * q[3] - q[0] * q[1]),
                                         q[0] ** 2 - q[1] ** 2 - q[2] ** 2 + q[3] ** 2])  # fmt: skip
    energy = (place.diff(t).dot(place.diff(t)) + omega.dot(sympy.diag(1, 2, 3) * omega)) / 2
    rows = [*(place - arm), sum(e**2 for e in q) - 1]
    model = Model(name="jointed", coordinates=[*place, *q], kinetic_energy=energy, potential_energy=9 * Z,
                  holonomic_constraints=rows, initial={Z: 1.0, q[0]: 1.0})  # fmt: skip
    system = system_for(model, "inverse")
    assert sorted(map(len, system.blocks)) == [1, 1, 1, 4]
    x, v = np.array([0.3, 0.4, 0.2, 0.8, 0.1, -0.5, 0.3]), np.linspace(-1, 1, 7)
    right = Lagrange(model)(x, v)
    for found, exact in zip(system.acceleration(x, v), right, strict=True):
        np.testing.assert_allclose(found, exact, rtol=1e-12, atol=1e-12)


def test_the_mass_matrix_and_the_energy_stay_those_of_the_user():
    system = system_for(bead())
    np.testing.assert_array_equal(system.mass_matrix([0.4, 0.0]), [[2, 0], [0, 0]])
    np.testing.assert_array_equal(system.mass_matrix_gradient([0.4, 0.0]), np.zeros((2, 2, 2)))
    assert system.energy([0.0, 0.0], [1.0, 3.0]) == 1.0
    assert any("M is singular" in line for line in system.left_out)


def test_a_build_proves_a_coordinate_that_only_follows():
    """Its row carries nothing: what is found there is rounding, beside what the multipliers are computed from."""
    shadow = Model(name="shadow", coordinates=[X, Y], kinetic_energy=(1 + X**2) * X.diff() ** 2 / 2,
                   potential_energy=sin(X), nonholonomic_constraints=[Y.diff() - cos(Y) * X.diff() / 3])  # fmt: skip
    assert build(shadow, formulation="cholesky", flags="-O0").n == 2


@FORMS
def test_inertia_that_is_lost_at_one_place_is_named_as_before(formulation):
    """A sliding mass of (x - 1)^2, and a row that does not hold x: nothing makes up for what M loses at x = 1."""
    energy = (X - 1) ** 2 * X.diff() ** 2 / 2 + Y.diff() ** 2 / 2 + Z.diff() ** 2 / 2
    system = system_for(
        Model(name="lost", coordinates=[X, Y, Z], kinetic_energy=energy, holonomic_constraints=[Y - Z],
              initial={X.diff(): 1.0}),
        formulation,
    )  # fmt: skip
    assert not any("M is singular" in line for line in system.left_out)
    with pytest.raises(ModelError, match=r"mass matrix.*'x'"):
        system.simulate((0, 1), x0=[1.0, 0.0, 0.0])


def test_a_coordinate_that_nothing_holds_is_refused_by_name():
    with pytest.raises(ModelError, match=r"rate of 'z'.*hold it by a constraint"):
        Model(name="loose", coordinates=[X, Z], kinetic_energy=X.diff() ** 2)


def rod(rows: int) -> Model:
    """A mass on a rod, whose angle has no inertia: one row holds it where it is level, the other where it hangs."""
    angle = dynamicsymbols("angle")
    return Model(
        name=f"rod_{rows % 3}", coordinates=[X, Y, angle], kinetic_energy=m * (X.diff() ** 2 + Y.diff() ** 2) / 2,
        potential_energy=m * g * Y, holonomic_constraints=[X - cos(angle), Y - sin(angle)][::rows],
        parameters={m: 2.0, g: 9.81}, initial={X: 1.0, Y: 0.0, angle: 0.0},
    )  # fmt: skip


@pytest.mark.parametrize("rows", [1, -1])
@pytest.mark.parametrize("formulation", ["eigenfactor", "cholesky", "lagrange"])
def test_rows_that_hold_what_has_no_inertia_do_so_wherever_it_turns(rows, formulation):
    """Beside its own diagonal one row looks sound at every state, and is singular at two angles of each turn."""
    from scipy.integrate import solve_ivp  # noqa: PLC0415

    found = system_for(rod(rows), formulation).simulate((0, 3), rtol=1e-10, atol=1e-10)
    ends = solve_ivp(lambda _, y: [y[1], -9.81 * np.cos(y[0])], (0, 3), [0, 0], method="DOP853", rtol=1e-12, atol=1e-12)
    assert found.success, found.message
    assert found.x[2, -1] == pytest.approx(ends.y[0, -1], abs=1e-8)
