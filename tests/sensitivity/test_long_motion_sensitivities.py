"""Sensitivities of long motions, in which motions of another speed drift apart.

An eccentric rotor under a constant torque: q'^2 (1 + r cos q) / 2 = W(q) = tau q - g (cos q - 1), so that the time to
an angle, and its derivatives, are integrals over the angle.
"""

import numpy as np
import pytest
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion import Model, System

from ..support.generation import system_for, system_of

q, p = dynamicsymbols("q p")
tau, r, g, c = symbols("tau r g c", real=True)


def rotor(torque: float) -> System:
    model = Model(name="rotor_under_torque", coordinates=[q], kinetic_energy=q.diff() ** 2 * (1 + r * cos(q)) / 2,
                  potential_energy=g * cos(q), forces=[tau], parameters={tau: torque, r: 0.5, g: 3.0},
                  initial={q: 0.0})  # fmt: skip
    return system_for(model, "lagrange")


def exact(end: float, torque: float = 10.0, eccentricity: float = 0.5, weight: float = 3.0) -> tuple[float, np.ndarray]:
    """Return the time to the angle `end`, and there the derivatives (3,) of the angle by torque, r and g."""
    node, at = np.polynomial.legendre.leggauss(40)
    time, by = 0.0, np.zeros(3)
    for low in np.arange(0.0, end):
        high, u = min(low + 1.0, end), (node + 1) / 2
        x, share = (low + (high - low) * u, at / 2) if low else (high * u**2, at * u)
        mass, work = 1 + eccentricity * np.cos(x), torque * x - weight * (np.cos(x) - 1)
        slowness = (high - low) * share * np.sqrt(mass / 2 / work)
        time += slowness.sum()
        of_time = [-x / work / 2, np.cos(x) / mass / 2, (np.cos(x) - 1) / work / 2]
        by += [slowness @ one for one in of_time]
    rate = np.sqrt(2 * (torque * end - weight * (np.cos(end) - 1)) / (1 + eccentricity * np.cos(end)))
    return time, -by * rate


@pytest.mark.parametrize(("end", "rtol", "most"), [(10.0, 1e-9, 3e-8), (1000.0, 1e-9, 3e-5), (1000.0, 1e-11, 1e-7),
                                                   (6000.0, 1e-8, 3e-3)])  # fmt: skip
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_rotor_that_turns_for_long(end: float, rtol: float, most: float, sign: float):
    """The errors are those of the angle itself."""
    time, right = exact(end)
    run = rotor(10.0 * sign).simulate(
        (0.0, time), sensitivities=["tau", "r", "g"], t_eval=[time], rtol=rtol, atol=1e-3 * rtol
    )
    assert run.x[0, -1] == pytest.approx(sign * end, rel=1e-6)
    found = [run.sensitivity[name].dx[0, -1] for name in ("tau", "r", "g")]
    np.testing.assert_allclose(found, right * [1.0, sign, sign], rtol=most)


def test_rows_within_a_long_motion():
    """Between the ends of steps, too; and with rows at every step."""
    time, right = exact(1000.0)
    times = np.linspace(0.0, time, 4001)
    run = rotor(10.0).simulate((0.0, time), sensitivities=["tau", "r", "g"], t_eval=times, rtol=1e-10, atol=1e-13)
    found = np.array([run.sensitivity[name].dx[0] for name in ("tau", "r", "g")])
    np.testing.assert_allclose(found[:, -1], right, rtol=1e-6)
    tight = rotor(10.0).simulate((0.0, time), sensitivities=["tau", "r", "g"], t_eval=times, rtol=1e-12, atol=1e-15)
    for one, name in zip(found, ("tau", "r", "g"), strict=True):
        size = np.maximum.accumulate(np.abs(tight.sensitivity[name].dx[0]))
        assert (np.abs(one - tight.sensitivity[name].dx[0]) <= 3e-6 * size).all()


def test_gradients_of_a_long_motion():
    """The adjoint comes to the same."""
    time, right = exact(1000.0)
    _, pullback = em.vjp(rotor(10.0), (0.0, time), by=["tau", "r", "g"], t_eval=[time], rtol=1e-10, atol=1e-13)
    np.testing.assert_allclose(list(pullback(dx=[[1.0]]).values()), right, rtol=1e-6)


def test_andrews_mechanism_after_hundreds_of_turns():
    """As the gradient, whose cotangents have no large part along the motion. They differed by 0.4 %."""
    mechanism, options = system_of("andrews", "lagrange"), {"t_eval": [0.6], "rtol": 1e-9}
    run = mechanism.simulate((0.0, 0.6), sensitivities=["m3", "c0", "mom"], **options)
    _, pullback = em.vjp(mechanism, (0.0, 0.6), by=["m3", "c0", "mom"], **options)
    right = pullback(dx=np.eye(mechanism.n)[:, :1])
    for name in ("m3", "c0", "mom"):
        assert run.sensitivity[name].dx[0, -1] == pytest.approx(right[name], rel=3e-5)


def rotor_beside_a_pendulum(coupling: float) -> System:
    """Return the rotor, with a pendulum that its angle hardly moves, and that does not move it."""
    model = Model(name="rotor_beside_a_pendulum", coordinates=[q, p],
                  kinetic_energy=q.diff() ** 2 * (1 + r * cos(q)) / 2 + p.diff() ** 2 / 2000,
                  potential_energy=g * cos(q) - cos(p) / 100, forces=[tau, c * sin(q) / 1000],
                  parameters={tau: 10.0, r: 0.5, g: 3.0, c: coupling}, initial={q: 0.0, p: 1.0})  # fmt: skip
    return system_for(model, "lagrange")


def test_what_moves_beside_a_rotor_does_not_shift_with_it():
    """The pendulum's derivatives are zero, and the rotor's as accurate as without it. They were noise."""
    time, right = exact(1000.0)
    run = rotor_beside_a_pendulum(0.0).simulate(
        (0.0, time), sensitivities=["tau", "r", "g"], t_eval=[time], rtol=1e-10, atol=1e-13
    )
    by = [run.sensitivity[name] for name in ("tau", "r", "g")]
    np.testing.assert_allclose([one.dx[0, -1] for one in by], right, rtol=1e-5)
    assert not any(one.dx[1].any() or one.dv[1].any() for one in by)


def test_what_a_rotor_hardly_moves():
    """As the gradient: of a pendulum whose derivatives are 1e-11 of the rotor's. They were off by 1e-6 and more."""
    system, options = rotor_beside_a_pendulum(1e-8), {"t_eval": [8.0], "atol": 1e-15}
    run = system.simulate((0.0, 8.0), sensitivities=["tau", "r"], rtol=1e-12, **options)
    _, pullback = em.vjp(system, (0.0, 8.0), by=["tau", "r"], rtol=1e-13, **options)
    right = pullback(dx=np.eye(2)[:, 1:])
    for name in ("tau", "r"):
        assert run.sensitivity[name].dx[1, -1] == pytest.approx(right[name], rel=2e-8, abs=0.0)


@pytest.mark.parametrize("rtol", [1e-3, 1e-6])
def test_a_rotor_with_a_stiff_part(rtol: float):
    """A light slider that a strong damper holds: an error of its place is a large one of its acceleration, which dies
    out, and which is no error of directions. With it, they were off by 2,000 % and 2 %."""
    model = Model(name="rotor_with_a_damper", coordinates=[q, p],
                  kinetic_energy=(1 + p**2) * q.diff() ** 2 / 2 + p.diff() ** 2 / 600,
                  potential_energy=6 * (p - 1) ** 2 + 4 * (p - 1) ** 4 + cos(q), forces=[tau, -90 * p.diff()],
                  parameters={tau: 0.5}, initial={q: 0.0, q.diff(): 0.25, p: 1.0})  # fmt: skip
    system, times = system_for(model, "lagrange"), np.linspace(0.5, 20.0, 40)
    run, right = (
        system.simulate(
            (0.0, 20.0), method="radau9", sensitivities=["q", "tau"], t_eval=times, rtol=one, atol=one / 100
        )
        for one in (rtol, 1e-12)
    )
    for name in ("q", "tau"):
        for found, exact in zip(run.sensitivity[name], right.sensitivity[name], strict=True):
            assert (np.abs(found - exact) <= 30 * rtol * np.abs(exact).max(axis=1, keepdims=True)).all()
    _, pullback = em.vjp(system, (0.0, 20.0), by=["q", "tau"], t_eval=times[-1:], rtol=1e-11, atol=1e-13)
    by = pullback(dx=np.eye(2)[:, 1:])
    for name in ("q", "tau"):
        assert right.sensitivity[name].dx[1, -1] == pytest.approx(by[name], rel=1e-8)


def test_loose_tolerances_of_a_stiff_state():
    """Bristles of friction, by the start of what they hold. Ten thousand tolerances were all of it: off by 31 %."""
    system, times = system_of("lugre_oscillator", "lagrange"), np.linspace(1.0, 6.0, 6) / 6
    loose, right = (
        system.simulate((0.0, 1.0), sensitivities=["x"], t_eval=times, rtol=one, atol=one / 100)
        for one in (1e-4, 1e-12)
    )
    exact = right.sensitivity["x"].dx[0]
    assert np.abs(loose.sensitivity["x"].dx[0] - exact).max() <= 3e-4 * np.abs(exact).max()
