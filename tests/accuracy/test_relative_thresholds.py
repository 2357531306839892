"""Thresholds are relative to the terms they are about: no origin and no unit is special."""

import mpmath
import numpy as np
import pytest
from eigenmotion.codegen.model.check.elimination import is_singular
from sympy import Expr, atan2, cos, exp, lambdify, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, ModelError, System, t
from eigenmotion.arguments.methods import METHODS

from ..support.failing_runs import X, Y, plane
from ..support.generation import FORMULATIONS, system_for
from ..support.models_table import BY_NAME
from .frames import Frame, framed

L, M, G = symbols("L m g", positive=True)
X0, Y0 = symbols("x_0 y_0", real=True)
SWING, GRAVITY, SPAN = 0.9, 9.81, 10.0
HUNG = {  # length and pivot, in units of the length
    "at the origin": (1.0, 0.0, 0.0),
    "through the origin": (1.0, 0.0, 1.0),
    "far away": (1.0, 1e3, -1e3),
    "short": (1e-6, 0.0, 0.0),
    "short, through the origin": (1e-6, 0.0, 1.0),
    "long": (1e6, 0.0, 0.0),
    "long, through the origin": (1e6, 0.0, 1.0),
}


def hung_pendulum() -> Model:
    """A Cartesian pendulum about any pivot."""
    return plane(
        "hung_pendulum",
        kinetic_energy=M * (X.diff() ** 2 + Y.diff() ** 2) / 2,
        potential_energy=M * G * Y,
        holonomic_constraints=[(X - X0) ** 2 + (Y - Y0) ** 2 - L**2],
        parameters={L: 1.0, M: 1.0, G: GRAVITY, X0: 0.0, Y0: 0.0},
    )


def swung(system: System, where: str, span: float, **options: object) -> tuple[np.ndarray, int]:
    """Where the mass is at the end, from the pivot in lengths, and how many right-hand sides that took."""
    length, *pivot = HUNG[where]
    x0, y0 = length * np.array(pivot)
    run = system.simulate(
        (0, span), x0=[x0 + length * np.sin(SWING), y0 - length * np.cos(SWING)], rtol=1e-12, atol=1e-8 * length,
        parameters={"L": length, "g": GRAVITY * length, "x_0": x0, "y_0": y0}, **options,
    )  # fmt: skip
    assert run.success, run.message
    return (run.x[:, -1] - [x0, y0]) / length, run.nfev


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("where", list(HUNG)[1:])
def test_a_pendulum_hung_anywhere_and_of_any_length_swings_alike(where, formulation):
    system = system_for(hung_pendulum(), formulation)
    for method in METHODS:
        (own, cost), (found, here) = (swung(system, place, SPAN, method=method) for place in ("at the origin", where))
        assert here == pytest.approx(cost, rel=0.05)
        np.testing.assert_allclose(found, own, atol=1e-7)


@pytest.mark.parametrize("method", ["radau5", "radau9"])
@pytest.mark.parametrize("where", list(HUNG)[1:])
def test_so_it_does_by_implicit_methods(where, method):
    system = system_for(hung_pendulum(), "lagrange")
    (own, cost), (found, here) = (swung(system, place, 1.0, method=method) for place in ("at the origin", where))
    assert here == pytest.approx(cost, rel=0.1)
    np.testing.assert_allclose(found, own, atol=1e-5)


# --- the rounding of phi ----------------------------------------------------------------------------------------------

ROWS = (
    X**2 + Y**2 - 2,
    (X - 1000) ** 2 + (Y + 1000) ** 2 - L**2,
    sin(1000 * X) * cos(Y) - X * Y,
    sqrt(X**2 + (Y - 1) ** 2) - L,
    (X - Y) * (X + Y) / (3 - X) + exp(X - Y) - 1,
    atan2(Y, X) - sin(X - Y - t / 3),
)


PLAIN = symbols("x y s")


def exactly(row: Expr, *at: float) -> mpmath.mpf:
    """A row in forty digits at (x, y, t, L), numbers that are meant exactly."""
    with mpmath.workdps(40):
        plain = row.subs(dict(zip((X, Y, t), PLAIN, strict=True)))
        return lambdify((*PLAIN, L), plain, "mpmath")(*map(mpmath.mpf, at))


@pytest.mark.parametrize("k", range(len(ROWS)))
def test_the_terms_of_phi_tell_its_rounding(k):
    """The error, for a place that is off in its last digit, is below eps of the terms, but no less than a fiftieth."""
    system, eps = system_for(plane("rounded", holonomic_constraints=ROWS, parameters={L: 1.5}), "lagrange"), 2.0**-52
    random, parts = np.random.default_rng(5), []
    for _ in range(60):
        x, time = random.uniform(-2, 2, 2) + np.array([1000, -1000]) * (k == 1), float(random.uniform(-2, 2))
        phi, terms = system.compiled.position(time, x, system.prepare())
        near = [mpmath.mpf(place) * (1 + mpmath.mpf(eps) * float(random.uniform(-0.5, 0.5))) for place in x]
        parts.append(abs(float(exactly(ROWS[k], *near, time, 1.5) - mpmath.mpf(phi[k]))) / (eps * terms[k]))
    assert 0.02 < max(parts) <= 1.0


def test_without_constraints_on_positions_there_is_nothing_to_round():
    system = system_for(plane("free"), "lagrange")
    phi, terms = system.compiled.position(0.0, np.zeros(2), system.prepare())
    assert (phi.size, terms.size) == (0, 0)


# --- Jacobians --------------------------------------------------------------------------------------------------------


def hardening() -> Model:
    """A spring that hardens within `L`: x'' = -u - u^3 + y'/2 with u = (x - origin) / L, in that unit."""
    u = (X - X0) / L
    return plane("hardening", forces=[-L * (u + u**3) + Y.diff() / 2, 0], parameters={L: 1.0, X0: 0.0})


@pytest.mark.parametrize("origin", [0.0, 1.0, 1e3, 1e6])
@pytest.mark.parametrize("length", [1e-12, 1e-6, 1.0, 1e6, 1e12])
def test_a_jacobian_knows_neither_origin_nor_unit(length, origin):
    system = system_for(hardening(), "lagrange")
    at = dict(zip(("L", "x_0"), (length, origin * length), strict=True))
    for place in (0.0, 0.3, 2.0):
        z = np.array([(origin + place) * length, 0.0, 0.0, 0.0])
        found = system.compiled.motion_jacobian(0.0, z, system.prepare(at), np.zeros(0), False)
        exact = np.array([[0, 0, 1, 0], [0, 0, 0, 1], [-1 - 3 * place**2, 0, 0, 0.5], [0, 0, 0, 0]])
        np.testing.assert_allclose(found, exact, atol=1e-9 * max(1.0, origin) ** 0.8)


@pytest.mark.parametrize("power", [-40, -7, 1, 33])
def test_a_jacobian_in_units_of_powers_of_two_is_the_same_to_the_last_bit(power):
    system, found = system_for(hardening(), "lagrange"), []
    for length in (1.0, 2.0**power):
        given, z = system.prepare({"L": length, "x_0": length}), length * np.array([1.3, 0.7, 0.2, -0.9])
        found.append(system.compiled.motion_jacobian(0.0, z, given, np.zeros(0), False))
    np.testing.assert_array_equal(*found)


@pytest.mark.parametrize("name", ["dual_link", "spatial_arm_3", "four_bar"])
def test_a_jacobian_in_another_frame_is_the_same(name):
    system = system_for(framed(BY_NAME[name].model()), "lagrange")
    units, own = np.resize([1e6, 1e-6, 1e-3], system.n), Frame().run(system, 0.3, 1e-8, 1e-8)
    z = np.concatenate([own.x, own.v])
    scale = np.tile(units, 2)
    here = system.compiled.motion_jacobian(0.0, z, system.prepare(), np.zeros(0), False)
    there = {f"unit_{k}": unit for k, unit in enumerate(units.tolist())}
    found = system.compiled.motion_jacobian(0.0, z / scale, system.prepare(there), np.zeros(0), False)
    np.testing.assert_allclose(found * scale[:, None] / scale, here, atol=1e-8 * abs(here).max())


# --- starts -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("length", [1e-9, 1e-6, 1.0, 1e6])
def test_a_start_is_judged_in_its_own_unit(length):
    """A hundredth of the length off the constraint is refused, and a ten-millionth is not."""
    system = system_for(hung_pendulum(), "lagrange")
    options = {"parameters": {"L": length, "g": GRAVITY * length}, "atol": 1e-9 * length}
    for off in (1e-2, -1e-2):
        with pytest.raises(ModelError, match="x0 is off holonomic constraint row 0"):
            system.simulate((0, 1), x0=[length * (1 + off), 0.0], **options)
        with pytest.raises(ModelError, match="v0 does not satisfy"):
            system.simulate((0, 1), x0=[length, 0.0], v0=[off * length, length], **options)
    assert system.simulate((0, 1), x0=[length * (1 + 1e-7), 0.0], **options).success


def test_rounding_in_velocities_at_rest_is_within_their_tolerance():
    system = system_for(hung_pendulum(), "lagrange")
    assert system.simulate((0, 1), x0=[1.0, 0.0], v0=[1e-17, 0.0]).success


@pytest.mark.parametrize("rows", [(1.0, 1.0), (1e6, 1e-6), (1e-6, 1e6)])
def test_the_nearest_start_is_no_matter_of_the_units_of_rows(rows):
    system = system_for(framed(BY_NAME["four_bar"].model()), "lagrange")
    given = dict(zip(("row_0", "row_1"), rows, strict=True))
    near = system.initial[0] + [0.02, -0.01, 0.03]
    own, found = (system.project_initial_state(near, parameters=p) for p in ({}, given))
    np.testing.assert_allclose(found.x, own.x, atol=1e-12)
    np.testing.assert_allclose(found.v, own.v, atol=1e-11)


# --- singular matrices ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("n", [1, 2, 3, 6])
def test_singular_is_no_matter_of_units(n):
    random = np.random.default_rng(n)
    regular, rows, columns = random.normal(size=(n, n)), *(10.0 ** random.uniform(-12, 12, (2, n)))
    singular = regular.copy()
    singular[-1] = random.normal(size=n - 1) @ regular[:-1]
    for matrix, answer in ((regular, False), (singular, True)):
        given = rows[:, None] * matrix * columns
        assert is_singular(given.tolist(), abs(given).tolist(), 1e-13) is answer


def turning(unit: float, lean: float) -> Model:
    """Body rates in angles, of which two coincide at lean = pi / 2; their unit is 1 / unit."""
    psi, theta, phi = dynamicsymbols("psi theta phi")
    omega = dynamicsymbols("omega_1:4")
    rates = (
        psi.diff() * cos(theta) * cos(phi) + theta.diff() * sin(phi),
        theta.diff() * cos(phi) - psi.diff() * cos(theta) * sin(phi),
        phi.diff() + psi.diff() * sin(theta),
    )
    return Model(
        name="turning",
        coordinates=[psi, theta, phi],
        kinetic_energy=sum(rate**2 for rate in omega) / unit**2,
        quasi_velocities=dict(zip(omega, (unit * rate for rate in rates), strict=True)),
        initial={theta: lean, omega[0]: unit, omega[1]: 0.5 * unit},
    )


@pytest.mark.parametrize("unit", [1e-12, 1e6])
def test_quasi_velocities_may_be_in_any_unit(unit):
    system, own = (system_for(turning(u, 0.3), "lagrange") for u in (unit, 1.0))
    np.testing.assert_allclose(system.initial[1], own.initial[1], rtol=1e-13)
    _, v = system.start({"theta": 0.2}, {"omega_3": 2.0 * unit})
    np.testing.assert_allclose(v, own.start({"theta": 0.2}, {"omega_3": 2.0})[1], rtol=1e-12)


@pytest.mark.parametrize("unit", [1.0, 1e6])
def test_and_where_they_are_singular_that_is_said(unit):
    with pytest.raises(ModelError, match="P of y = P\\(x\\) xdot is singular"):
        _ = turning(unit, np.pi / 2).initial_v
    system = system_for(turning(unit, 0.3), "lagrange")
    with pytest.raises(ModelError, match="singular"):
        system.start({"theta": np.pi / 2}, {"omega_3": unit})
