"""Motions of mechanisms with first-order states, against equations by hand."""

import numpy as np
import pytest
import scipy
import sympy
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em

from ..support.generation import FORMULATIONS, system_for
from .mechanisms import (
    OneCoordinate,
    driven_four_bar,
    e,
    i,
    integrated,
    q,
    ref,
    s,
    servo,
    servo_rate,
    theta,
    x,
    z,
)

METHODS = ["dop853", "ra15", "radau5", "radau9"]
TIMES = np.linspace(0.0, 3.0, 7)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_a_servo_by_every_formulation_and_method(formulation, method):
    system = system_for(servo(), formulation)
    found = system.simulate((0, 3), t_eval=TIMES, method=method, rtol=1e-11, atol=1e-12)
    right = integrated(servo_rate, [0.5, 0.0, 0.1, 0.0], TIMES)
    rows = np.vstack([found.x, found.v, *found.states.values()])
    np.testing.assert_allclose(rows, right, rtol=0, atol=1e-9)
    assert found.x.shape == (1, 7)
    assert list(found.states) == list(system.states) == ["i", "e"]
    assert system.n == 1
    assert system.coordinates == ("theta",)
    np.testing.assert_array_equal(found.y[system.layout["z"]], list(found.states.values()))
    np.testing.assert_allclose(found.outputs["voltage"], 5 * (1 - right[0]) + 3 * right[3], atol=1e-9)
    np.testing.assert_allclose(found.energy, right[1] ** 2 / 2 - 3 * np.cos(right[0]), atol=1e-9)


def test_a_motor_driven_four_bar_with_a_pi_controller():
    """Against the linkage as one coordinate, eliminated by hand."""
    model, by_hand = driven_four_bar(), OneCoordinate()
    times = np.linspace(0.0, 1.0, 5)
    start = [by_hand.start[0], dict(zip(model.rates, model.initial_v, strict=True))[model.rates[0]], 0.0, 0.0]
    right = integrated(by_hand.rate, start, times, rtol=1e-11, atol=1e-12)
    for method in ("dop853", "radau9"):
        found = system_for(model).simulate((0, 1), t_eval=times, method=method, rtol=1e-11, atol=1e-12)
        rows = np.vstack([found.x[0], found.v[0], *found.states.values()])
        np.testing.assert_allclose(rows, right, rtol=0, atol=1e-9)


def test_eigenvalues_of_the_driven_four_bar_at_rest():
    """A motor without a controller holds it where gravity pulls as its current does: eigenvalues with the current's."""
    by_hand = OneCoordinate()
    model = driven_four_bar()
    crank = model.coordinates[0]
    amperes = next(z for z, _ in model.states)
    volts = sympy.Symbol("volts")
    known = {field: getattr(model, field) for field in (
        "coordinates", "kinetic_energy", "potential_energy", "holonomic_constraints", "forces")}  # fmt: skip
    held = em.Model(
        name="held_four_bar", **known, states={amperes: (volts - amperes - crank.diff() / 2) / 0.05},
        parameters=dict(model.parameters) | {volts: 1.0}, initial=dict(model.initial),
    )  # fmt: skip
    found = em.find_equilibrium(system_for(held, "lagrange"))
    assert found.success
    assert found.states == pytest.approx({"current": 1.0}, abs=1e-12)
    at = found.x[0]
    inertia = by_hand.inertia(at)
    stiffness = by_hand.stiffness(at) / inertia
    right = np.linalg.eigvals([[0, 1, 0], [-stiffness, 0, 0.5 / inertia], [0, -0.5 / 0.05, -1 / 0.05]])
    values = found.linearize().eigenvalues()
    assert len(values) == 3
    np.testing.assert_allclose(np.sort_complex(values), np.sort_complex(right), rtol=1e-9)


def test_a_zener_element_in_closed_form():
    """A spring beside a spring in series with a damper, whose place s is the state: linear, so a matrix exponential."""
    k0, k1, c, m = 3.0, 40.0, 1.5, 2.0
    pull = k1 * (x - s)
    T, V = m * x.diff() ** 2 / 2, k0 * x**2 / 2
    model = em.Model(name="zener", coordinates=[x], kinetic_energy=T, potential_energy=V, forces={x: -pull},
                     states={s: pull / c}, initial={x: 1.0})  # fmt: skip
    A = np.array([[0, 1, 0], [-(k0 + k1) / m, 0, k1 / m], [k1 / c, 0, -k1 / c]])
    right = np.array([scipy.linalg.expm(A * t) @ [1.0, 0.0, 0.0] for t in TIMES]).T
    for method in METHODS:
        found = system_for(model).simulate((0, 3), t_eval=TIMES, method=method, rtol=1e-12, atol=1e-13)
        np.testing.assert_allclose(np.vstack([found.x, found.v, found.states["s"]]), right, rtol=0, atol=1e-10)
    linear = system_for(model).linearize(x={"x": 0.0})
    np.testing.assert_allclose(np.sort_complex(linear.eigenvalues()), np.sort_complex(np.linalg.eigvals(A)), rtol=1e-12)
    np.testing.assert_allclose(linear.full.A, A, atol=1e-14)


def test_a_filter_of_second_order_in_closed_form():
    """Of an input that is a sine: z'' + 2 d w z' + w^2 z = w^2 u, from rest."""
    rate, u = dynamicsymbols("rate u")
    w, d, drive = 5.0, 0.3, 2.0
    model = em.Model(
        name="filter", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, forces={x: z - x},
        states={z: rate, rate: w**2 * (u - z) - 2 * d * w * rate}, inputs={u: 0.0},
        initial={z: 0.2},
    )  # fmt: skip
    gain = w**2 / (w**2 - drive**2 + 2j * d * w * drive)
    steady = (gain * np.exp(1j * drive * TIMES)).imag
    damped = w * np.sqrt(1 - d**2)
    start, start_rate = 0.2 - gain.imag, -(1j * drive * gain).imag
    decay = np.exp(-d * w * TIMES)
    rest = decay * (start * np.cos(damped * TIMES) + (start_rate + d * w * start) / damped * np.sin(damped * TIMES))
    knots = np.linspace(0, 3, 4001)
    signal = em.Signal(knots, np.sin(drive * knots), "cubic")
    found = system_for(model).simulate(
        (0, 3), t_eval=TIMES, inputs={"u": signal}, rtol=1e-11, atol=1e-12, method="radau9"
    )
    np.testing.assert_allclose(found.states["z"], steady + rest, atol=1e-10)


def test_lugre_friction_against_another_integration():
    """Bristles of deflection z between a block and a belt, pulled by a spring: it sticks and slips."""
    s0, s1, fc, fs, vs = 1e3, 10.0, 1.0, 1.5, 0.1
    slip = x.diff() - sympy.Rational(1, 10)
    rate = slip - s0 * sympy.Abs(slip) / (fc + (fs - fc) * sympy.exp(-((slip / vs) ** 2))) * z
    model = em.Model(name="lugre", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, potential_energy=x**2,
                     forces={x: -s0 * z - s1 * rate}, states={z: rate})  # fmt: skip

    def by_hand(t, y):
        v = y[1] - 0.1
        dz = v - s0 * abs(v) / (fc + (fs - fc) * np.exp(-((v / vs) ** 2))) * y[2]
        return [y[1], -2 * y[0] - s0 * y[2] - s1 * dz, dz]

    times = np.linspace(0, 12.0, 13)
    right = integrated(by_hand, [0, 0, 0], times, method="Radau", rtol=1e-10, atol=1e-13)
    found = system_for(model).simulate((0, 12), t_eval=times, method="radau9", rtol=1e-10, atol=1e-13)
    np.testing.assert_allclose(np.vstack([found.x, found.v, found.states["z"]]), right, rtol=0, atol=1e-7)


def test_an_electrostatic_actuator():
    """Plates at a gap 1 - x with a charge q: V(x, q) = q^2 (1 - x) / 2, which the charge's own equation knows, too."""
    volts, ohms = 0.3, 2.0
    model = em.Model(
        name="actuator", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2,
        potential_energy=x**2 / 2 + q**2 * (1 - x) / 2, states={q: (volts - q * (1 - x)) / ohms},
    )  # fmt: skip

    def by_hand(t, y):
        return [y[1], -y[0] + y[2] ** 2 / 2, (volts - y[2] * (1 - y[0])) / ohms]

    right = integrated(by_hand, [0.0, 0.0, 0.0], TIMES)
    for formulation in FORMULATIONS:
        found = system_for(model, formulation).simulate((0, 3), t_eval=TIMES, rtol=1e-12, atol=1e-13)
        np.testing.assert_allclose(np.vstack([found.x, found.v, found.states["q"]]), right, rtol=0, atol=1e-10)
    at_rest = em.find_equilibrium(system_for(model))
    assert at_rest.success
    gap = 1 - at_rest.x[0]
    assert at_rest.states["q"] * gap == pytest.approx(volts, abs=1e-12)
    assert at_rest.x[0] == pytest.approx(at_rest.states["q"] ** 2 / 2, abs=1e-12)


def test_states_with_quasi_velocities():
    """A rate in another unit, which a state's equation is in."""
    y, w = dynamicsymbols("y w")
    model = em.Model(
        name="other_unit", coordinates=[theta], quasi_velocities={w: 2 * theta.diff()},
        kinetic_energy=w**2 / 8, forces={theta: y - theta}, states={y: w - y}, initial={w: 1.0, y: 0.5},
    )  # fmt: skip
    right = integrated(lambda t, r: [r[1], r[2] - r[0], 2 * r[1] - r[2]], [0, 0.5, 0.5], TIMES)
    system = system_for(model)
    found = system.simulate((0, 3), t_eval=TIMES, rtol=1e-11, atol=1e-12)
    np.testing.assert_allclose(np.vstack([found.x, found.v, found.states["y"]]), right, rtol=0, atol=1e-10)
    other = system.simulate((0, 3), x0={"y": 0.1}, rtol=1e-11, atol=1e-12)
    assert other.states["y"][0] == 0.1
    assert other.v[0, 0] == 0.5


def test_states_are_reset_by_events_and_seen_by_them():
    """A counter that wraps at 1, and a controller's integral that is cleared as the arm passes its target."""
    count, done = dynamicsymbols("count done")
    model = servo(
        states={i: 0 * i, e: ref - theta, count: sympy.Integer(2), done: 0 * done},
        events={"wraps": em.Event(count - 1, direction=1, reset={count: 0, done: done + 1}),
                "clears": em.Event(theta - ref, reset={e: 0})},
        forces={}, outputs={},
    )  # fmt: skip
    system = system_for(model)
    found = system.simulate((0, 1.75), x0={"theta": -1.0}, v0={"theta": 2.0}, rtol=1e-10, atol=1e-12)
    np.testing.assert_allclose(found.t_events[0], [0.5, 1.0, 1.5], atol=1e-9)
    assert found.states["done"][-1] == 3.0
    assert found.states["count"][-1] == pytest.approx(0.5, abs=1e-9)
    at = found.t_events[1][0]
    after = found.t > at
    assert found.y_after_events[1][0][system.layout["z"]][1] == 0.0
    assert found.states["e"][after][-1] != 0.0


def test_a_push_that_grows_makes_a_block_slide():
    """A state f = t pushes; dry friction of 2 N holds until then, and a bounce at a wall leaves the state alone."""
    f = dynamicsymbols("f")
    model = em.Model(
        name="pushed", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, forces={x: f}, states={f: sympy.Integer(1)},
        contacts={"rub": em.Friction(x.diff(), 2), "wall": em.Contact(1 - x, restitution=0.5)},
    )  # fmt: skip
    found = system_for(model, "lagrange").simulate((0, 4), rtol=1e-10, atol=1e-12)
    assert found.success
    begins = found.t[found.x[0] > 1e-9][0]
    assert 2.0 <= begins < 2.2
    strikes = found.t_events[1][0]
    assert strikes == pytest.approx(2 + 6 ** (1 / 3), abs=1e-8)
    np.testing.assert_allclose(found.states["f"], found.t, atol=1e-9)
    before = (found.t > 2.3) & (found.t < strikes)
    np.testing.assert_allclose(found.x[0, before], (found.t[before] - 2) ** 3 / 6, atol=1e-8)
    after = found.t > strikes + 1e-3
    assert (found.x[0, after] < 1 + 1e-9).all()


def test_a_limit_of_friction_that_is_a_state():
    """A brake whose force decays: m a = 1 - N, N' = -N, from 3: it holds until N is 1."""
    N = dynamicsymbols("N")
    model = em.Model(
        name="brake", coordinates=[x], kinetic_energy=x.diff() ** 2 / 2, forces={x: 1}, states={N: -N},
        initial={N: 3.0}, contacts={"pads": em.Friction(x.diff(), N)},
    )  # fmt: skip
    found = system_for(model, "lagrange").simulate((0, 3), t_eval=[2.0, 3.0], rtol=1e-10, atol=1e-12)
    s = np.array([2.0, 3.0]) - np.log(3.0)
    np.testing.assert_allclose(found.v[0], s - (1 - np.exp(-s)), atol=1e-8)
