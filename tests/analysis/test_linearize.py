"""Linearised models against closed forms, published ones, and the same mechanism in other coordinates and units."""

from functools import cache

import numpy as np
import pytest
from sympy import Abs, Rational, cos, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import ModelError, System
from eigenmotion.runtime.variations import constraint_partials

from ..support.generation import system_for, system_of

m, M, l, g, J, J3, d, k = symbols("m M l g J J3 d k", positive=True)


def same(found, right, within=1e-9):
    """Eigenvalues as sets, relative to the largest."""
    found, right = np.array(found), np.array(right)
    assert found.shape == right.shape
    apart = np.abs(found[:, None] - right)
    assert max(apart.min(axis=0).max(), apart.min(axis=1).max()) < within * max(np.abs(right).max(), 1e-300), (
        found,
        right,
    )


# --- the contract -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["dual_link", "four_bar", "rolling_disk", "driven_pendulum", "double_pendulum"])
def test_a_basis_of_the_tangent_space(name):
    system = system_of(name, "lagrange")
    x, v = system.project_initial_state(t=0.3)
    found, n = system.linearize(x, v, 0.3), system.n
    J = system.compiled.motion_jacobian(0.3, np.concatenate([x, v]), system.prepare(), np.zeros(0), False)
    D = constraint_partials(system.compiled, 0.3, x, v, system.prepare())[:, : 2 * n]
    np.testing.assert_allclose(found.full.A, J, atol=1e-13 * np.abs(J).max())
    np.testing.assert_allclose(found.Z.T @ found.Z, np.eye(2 * n - system.h - system.m), atol=1e-14)
    np.testing.assert_allclose(D @ found.Z, 0.0, atol=1e-14 * max(np.abs(D).max(initial=0.0), 1.0))
    np.testing.assert_allclose(found.A, found.Z.T @ J @ found.Z, atol=1e-13 * np.abs(J).max())
    assert len(found.eigenvalues()) == len(found.A)


def cart() -> em.Model:
    """A pendulum upright on a cart that is pushed; its angle, and what an accelerometer on the cart reads."""
    x, theta, u = dynamicsymbols("x theta u")
    velocity = (x.diff() + l * theta.diff() * cos(theta)) ** 2 + (l * theta.diff() * sin(theta)) ** 2
    return em.Model(
        name="cart", coordinates=[x, theta], kinetic_energy=M * x.diff() ** 2 / 2 + m * velocity / 2,
        potential_energy=m * g * l * cos(theta), forces={x: u - d * x.diff()}, inputs={u: 0.0},
        outputs={"angle": theta, "felt": x.diff().diff()}, parameters={M: 2.0, m: 0.5, l: 0.7, g: 9.81, d: 0.3},
    )  # fmt: skip


def test_inputs_and_outputs():
    system = system_for(cart(), "lagrange")
    p = system.parameters
    found = system.linearize()
    ratio, rate = p["m"] / p["M"], p["g"] / p["l"]
    push = np.array([1.0, -1.0 / p["l"]]) / p["M"]
    bottom = np.array([[0.0, -ratio * p["g"]], [0.0, (1 + ratio) * rate]]), -p["d"] * push[:, None] * [1.0, 0.0]
    np.testing.assert_allclose(found.full.A[2:], np.hstack(bottom), atol=1e-14)
    np.testing.assert_allclose(found.full.B[2:, 0], push, atol=1e-15)
    np.testing.assert_allclose(found.full.C, [[0, 1, 0, 0], found.full.A[2]], atol=1e-14)
    np.testing.assert_allclose(found.full.D[:, 0], [0, push[0]], atol=1e-15)
    assert found.steady
    scipy = found.to_scipy()
    np.testing.assert_array_equal(scipy.A, found.A)
    assert scipy.C.shape == (2, 4)
    assert "upright" not in found._repr_html_()
    assert "theta" in found._repr_html_()
    with pytest.raises(ModelError, match="has no inputs"):
        system_of("pendulum", "lagrange").linearize([0.0]).to_scipy()


# --- closed forms -----------------------------------------------------------------------------------------------------


def test_pendulum():
    system = system_of("pendulum", "lagrange")
    rate = np.sqrt(system.parameters["g"] / system.parameters["l"])
    same(system.linearize([0.0], [0.0]).eigenvalues(), [1j * rate, -1j * rate], 1e-14)
    same(system.linearize([np.pi], [0.0]).eigenvalues(), [rate, -rate], 1e-14)
    (mode,) = system.linearize([0.0], [0.0]).modes()
    assert mode.frequency == pytest.approx(rate / (2 * np.pi))
    assert "undamped: theta" in mode.words


def test_a_bead_on_a_turning_hoop():
    """It rests where cos theta = g / (omega^2 r), and oscillates there with omega sin theta."""
    system = system_of("rotating_hoop", "lagrange")
    names = {"Omega": 7.0}
    p = system.parameters | names
    found = em.find_equilibrium(system, {"theta": 1.0}, parameters=names)
    assert np.cos(found.x[0]) == pytest.approx(p["g"] / (49.0 * p["R"]), rel=1e-13)
    rate = 7.0 * np.sin(found.x[0])
    same(found.linearize().eigenvalues(), [1j * rate, -1j * rate], 1e-12)


@pytest.mark.parametrize("spin", [0.5, 3.0, 4.4294469180700204, 6.0, 30.0])
def test_rolling_disk(spin):
    """A thin uniform disk rolls upright above spin^2 = g / (3 r) (Neimark & Fufaev 1972), whatever its heading."""
    system = system_of("rolling_disk", "lagrange")
    r, g = system.parameters["r"], system.parameters["g"]
    spin *= np.sqrt(g / (3 * r)) / 4.4294469180700204
    state = em.assemble(system, {"theta": 0.0, "phi": 0.8, "psi": 0.3}, {"psi": spin, "theta": 0.0, "phi": 0.0})
    found = system.linearize(*state)
    across, along = r**2 / 4, r**2 / 2
    square = (g * r - along * (along + r**2) / across * spin**2) / (across + r**2)
    values = found.eigenvalues()
    lean = values[np.argsort(-np.abs(values))]
    assert found.steady
    np.testing.assert_allclose(lean[:2] ** 2, square, atol=1e-12 * g / r)
    assert np.abs(lean[2:]).max() < 1e-7 * np.sqrt(g / r)  # of zeros that are double rounding leaves the root


def test_a_disk_on_a_circle_is_steady_though_its_centre_is_not():
    system = system_of("rolling_disk", "lagrange")
    found = em.find_equilibrium(system, {"theta": 0.3}, v0={"phi": 2.0}, free=["psi'", "x'", "y'"],
                                constant=["theta", "phi", "psi"])  # fmt: skip
    assert found.success
    slow = found.linearize()
    assert slow.steady
    pair = slow.eigenvalues()[np.argsort(-np.abs(slow.eigenvalues()))]
    start = {"x0": found.x + 1e-6 * np.eye(5)[3], "v0": found.v}
    run = system.simulate((0.0, 60.0), rtol=1e-12, atol=1e-14, t_eval=np.linspace(0, 60, 2000), **start)
    lean = run.x[3] - found.x[3]
    spectrum = np.abs(np.fft.rfft((lean - lean.mean()) * np.hanning(2000)))
    assert spectrum.argmax() == pytest.approx(np.abs(pair[0]) / (2 * np.pi) * 60, abs=1.0)


@cache
def top() -> System:
    """Lagrange's top in Cardan angles, regular where it stands upright; beta' is scaled by a kink that is not there."""
    alpha, beta, gamma = dynamicsymbols("alpha beta gamma")
    across = (alpha.diff() * cos(beta)) ** 2 + beta.diff() ** 2
    along = gamma.diff() + alpha.diff() * sin(beta)
    return system_for(em.Model(
        name="cardan_top", coordinates=[alpha, beta, gamma],
        kinetic_energy=Rational(1, 2) * (J * across + J3 * along**2),
        potential_energy=m * g * l * cos(alpha) * cos(beta),
        parameters={m: 1.0, g: 9.81, l: 0.2, J: 0.05, J3: 0.02},
    ), "lagrange")  # fmt: skip


@pytest.mark.parametrize("over", [0.5, 0.999, 1.001, 3.0])
def test_a_sleeping_top_stands_above_its_border(over):
    """spin^2 = 4 m g l J / J3^2 (Lagrange); z = alpha + i beta: J z'' - i J3 spin z' - m g l z = 0."""
    p = top().parameters
    weight = p["m"] * p["g"] * p["l"]
    spin = over * 2 * np.sqrt(weight * p["J"]) / p["J3"]
    found = top().linearize([0, 0, 0.4], [0, 0, spin])
    roots = np.roots([p["J"], -1j * p["J3"] * spin, -weight])
    assert found.steady
    same(found.eigenvalues(), [0, 0, *roots, *roots.conj()])
    assert (found.eigenvalues().real.max() > 1e-6) == (over < 1)


def test_a_top_in_steady_precession_in_two_sets_of_angles():
    """From upright angles (Cardan) and from Euler's, of which precession and spin are free to go on."""
    euler = system_of("heavy_top", "lagrange")
    steady = em.find_equilibrium(euler, {"theta": 0.6}, v0={"psi": 40.0}, free=["phi'"])
    assert steady.success
    assert steady.message == "steady"
    values = steady.linearize().eigenvalues()
    p, (rate, spin) = euler.parameters, (steady.v[0], 40.0 + steady.v[0] * np.cos(0.6))
    assert p["J3"] * spin * rate - p["J"] * rate**2 * np.cos(0.6) == pytest.approx(p["m"] * p["g"] * p["l"], rel=1e-12)
    nutation = np.sqrt((p["J3"] * spin / p["J"] - 2 * rate * np.cos(0.6)) ** 2 + (rate * np.sin(0.6)) ** 2)
    same(values, [0, 0, 0, 0, 1j * nutation, -1j * nutation])


# --- other coordinates, other units -----------------------------------------------------------------------------------


def links(cartesian: bool, redundant: bool = False) -> em.Model:
    """A double pendulum, damped in its joints' velocities, in angles or in the places of its masses."""
    if not cartesian:
        a, b = dynamicsymbols("a b")
        places = [(l * sin(a), -l * cos(a)), (l * sin(a) + l * sin(b), -l * cos(a) - l * cos(b))]
        q, rows = [a, b], []
    else:
        q = list(dynamicsymbols("x1 y1 x2 y2"))
        places = [(q[0], q[1]), (q[2], q[3])]
        rows = [q[0] ** 2 + q[1] ** 2 - l**2, (q[2] - q[0]) ** 2 + (q[3] - q[1]) ** 2 - l**2]
        rows += [rows[0] + 3 * rows[1]] * redundant
    T = sum(m * (x.diff("t") ** 2 + y.diff("t") ** 2) for x, y in places) / 2
    forces = [-d * sum(c.diff(coordinate) * c.diff("t") for place in places for c in place) for coordinate in q]
    start = {} if not cartesian else {q[1]: -0.7, q[3]: -1.4}
    return em.Model(
        name=f"links{int(cartesian)}{int(redundant)}", coordinates=q, kinetic_energy=T,
        potential_energy=m * g * sum(y for _, y in places), forces=forces, holonomic_constraints=rows,
        parameters={m: 1.3, g: 9.81, l: 0.7, d: 0.2}, initial=start,
    )  # fmt: skip


@pytest.mark.parametrize("up", [(0, 0), (1, 0), (0, 1), (1, 1)])
def test_independent_of_coordinates(up):
    angles = system_for(links(False), "lagrange").linearize(np.multiply(up, np.pi), [0, 0])
    y = np.cumsum([0.7 if one else -0.7 for one in up])
    for redundant in (False, True):
        there = system_for(links(True, redundant), "lagrange").linearize([0, y[0], 0, y[1]], np.zeros(4))
        assert there.A.shape == (4, 4)
        assert there.steady
        same(there.eigenvalues(), angles.eigenvalues())
        same(np.linalg.eigvals(there.A), angles.eigenvalues())


@pytest.mark.parametrize("length", [1e-6, 1e6])
@pytest.mark.parametrize("mass", [1e-6, 1e6])
def test_independent_of_units(length, mass):
    system = system_for(links(True), "lagrange")
    here = system.linearize()
    given = {"l": 0.7 * length, "g": 9.81 * length, "m": 1.3 * mass, "d": 0.2 * mass}
    there = system.linearize(length * here.x, length * here.v, parameters=given)
    same(there.eigenvalues(), here.eigenvalues(), 1e-13)
    assert there.steady
    for ours, theirs in zip(here.modes(), there.modes(), strict=True):
        assert ours.words == theirs.words


# --- what is said -----------------------------------------------------------------------------------------------------


def test_states_off_the_constraints_are_refused():
    with pytest.raises(ModelError, match="off holonomic constraint row 0"):
        system_of("four_bar", "lagrange").linearize({"q1": 0.3})
    with pytest.raises(ModelError, match="v0 does not satisfy"):
        system_of("rolling_disk", "lagrange").linearize(v={"psi": 3.3})


def test_odd_mechanisms():
    """Nothing left to move; a free mass; a coordinate without inertia; rows that share a reaction."""
    x, y = dynamicsymbols("x y")
    led = em.Model(name="led", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, holonomic_constraints=[x - sin(em.t)])
    none = system_for(led, "lagrange").linearize([0.0], [1.0])
    assert none.A.shape == (0, 0)
    assert none.eigenvalues().shape == (0,)
    assert none.modes() == ()
    free = em.Model(name="free_mass", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2)
    np.testing.assert_array_equal(system_for(free, "lagrange").linearize([1], [2]).eigenvalues(), [0.0, 0.0])
    massless = em.Model(name="massless", coordinates=[x, y], kinetic_energy=x.diff() ** 2 / 2,
                        potential_energy=(x - y) ** 2 + y**2 / 2, holonomic_constraints=[y - 2 * x])  # fmt: skip
    same(system_for(massless, "lagrange").linearize().eigenvalues(), [1j * np.sqrt(6), -1j * np.sqrt(6)], 1e-14)
    ring = x**2 + y**2 - 1
    shared = em.Model(name="shared", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
                      potential_energy=y, holonomic_constraints=[ring, 2 * ring], initial={y: -1.0},
                      outputs={"reaction": em.multiplier(0)})  # fmt: skip
    with pytest.raises(ModelError, match="'reaction' holds a multiplier of constraint rows that depend"):
        system_for(shared, "lagrange").linearize()


def test_what_is_not_steady_says_so():
    found = system_of("double_pendulum", "lagrange").linearize()
    assert not found.steady
    assert "not steady" in found.message
    assert "not steady" in repr(found)
    assert not system_of("pendulum", "lagrange").linearize([0.0], [1.0]).steady
    assert system_of("pendulum", "lagrange").linearize([0.0], [0.0]).steady
    assert not system_of("driven_pendulum", "lagrange").linearize().steady


def kinked() -> em.Model:
    x, y = dynamicsymbols("x y")
    return em.Model(name="kinked", coordinates=[x, y], kinetic_energy=(x.diff() ** 2 + y.diff() ** 2) / 2,
                    potential_energy=k * Abs(x) * x / 2 + sqrt(y**4 + y**2), parameters={k: 4.0})  # fmt: skip


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("angle", [1e6, 1e13, 1e16, -1e150])
def test_a_fall_from_an_angle_however_large_is_not_steady(angle):
    """Small beside |slope| |x| are accelerations of any size there; and angles of 1e16 are the same a moment later."""
    assert not system_of("pendulum", "lagrange").linearize([angle]).steady


def test_kinks_are_taken_from_one_side_or_refused():
    """V = k |x| x / 2 has the curvature of x > 0 at 0; sqrt(y^2 + ...) has none there."""
    system = system_for(kinked(), "lagrange")
    np.testing.assert_array_equal(system.linearize([0.0, 1.0]).full.A[2, 0], -4.0)
    with pytest.raises(ModelError, match="no derivative by 'y' at this state"):
        system.linearize([1.0, 0.0])


@pytest.mark.parametrize("wrong", [{"x": [0.0, 0.0]}, {"x": {"phi": 1.0}}, {"x": [float("nan")]}, {"t": "soon"},
                                   {"parameters": {"q": 1.0}}, {"inputs": {"u": 1.0}}, {"v": [[0.0]]}])  # fmt: skip
def test_mistakes_have_names(wrong):
    with pytest.raises(ModelError):
        system_of("pendulum", "lagrange").linearize(**wrong)


@pytest.mark.parametrize("unit", [1e-12, 1.0, 1e12])
def test_rows_in_other_units_than_others_hold(unit):
    """Of two masses and a third one, on springs, the first two are held, one of them by a row in another unit."""
    q, u = dynamicsymbols("q1:4"), symbols("u", positive=True)
    held = em.Model(
        name="held_in_units", coordinates=q, kinetic_energy=sum(one.diff() ** 2 for one in q) / 2,
        potential_energy=sum(one**2 for one in q) / 2, holonomic_constraints=[q[0] - q[1]],
        nonholonomic_constraints=[u * q[1].diff()], parameters={u: 1.0},
    )  # fmt: skip
    system = system_for(held, "lagrange")
    found = system.linearize([0.2, 0.2, 0.5], [0.0] * 3, parameters={"u": unit})
    assert len(found.eigenvalues()) == 6 - 2 - 1
    same(found.eigenvalues(), [1j, -1j, 0.0])
