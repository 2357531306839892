"""Mechanisms too heavy for all that other models go through by day: each by what it is known for."""

from functools import cache

import numpy as np
import pytest

import eigenmotion as em

from ..oracles import published
from ..support.generation import system_of
from ..support.models_table import BY_NAME, SCENARIOS, Scenario

HEAVY = [scenario for scenario in SCENARIOS if scenario.heavy]


@cache
def system(name: str) -> em.System:
    return system_of(name, "lagrange")


@pytest.mark.parametrize("name", ["andrews", "four_bars_2", "snakeboard"])
def test_the_motion_that_is_known(name):
    scenario: Scenario = BY_NAME[name]
    run = system(scenario.file).simulate((0.0, scenario.t_end), rtol=1e-11, atol=1e-12)
    assert run.success, run.message
    right = scenario.reference()
    assert np.abs(run.x[:, -1] - right.x.astype(float)).max() < 1e-9 * np.abs(right.x).max()
    known = ~np.isnan(right.v.astype(float))
    assert np.abs(run.v[known, -1] - right.v[known].astype(float)).max(initial=0.0) < 1e-9 * np.abs(run.v).max()


def test_what_holds_the_puma_in_its_nominal_pose():
    """As many digits as are printed."""
    arm = system("puma")
    x = arm.initial[0]
    M = arm.mass_matrix(x)
    torques = -M @ arm.acceleration(x, np.zeros(6))[0]
    np.testing.assert_allclose(torques, published.PUMA_TORQUES, atol=5e-5)
    np.testing.assert_allclose(np.diag(M), published.PUMA_INERTIA, atol=5e-5)
    held = dict(zip(arm.inputs, torques, strict=True))
    assert np.abs(arm.acceleration(x, np.zeros(6), inputs=held)[0]).max() < 1e-12


@pytest.mark.nightly
@pytest.mark.parametrize("speed", published.BICYCLE)
def test_eigenvalues_of_the_bicycle(speed):
    """Upright and straight, at any heading."""
    bicycle = system("bicycle")
    parameters, heading = bicycle.parameters, 0.4
    rates = {"spin_r": speed / parameters["r_R"], "spin_f": speed / parameters["r_F"]}
    forward = {"x": speed * np.cos(heading), "y": speed * np.sin(heading)}
    v = [(rates | forward).get(name, 0.0) for name in bicycle.coordinates]
    nearby = bicycle.linearize(x={"psi": heading, "phi": 0.0, "theta": 0.0, "delta": 0.0}, v=v)
    assert nearby.steady
    for right in published.BICYCLE[speed]:
        assert np.abs(nearby.eigenvalues() - right).min() < 1e-11


@pytest.mark.nightly
def test_a_row_of_bricards_mechanism_that_was_left_out_holds():
    """Its last bar stays square to the axis of the joint in the ground, and the energy where it was."""
    run = system("bricard").simulate((0.0, 3.0), rtol=1e-10, atol=1e-10)
    assert run.success, run.message
    assert np.abs(run.x[:, -1]).max() > 0.5
    left_out = [rotation(x)[1, 0] for x in run.x.T]
    assert np.abs(left_out).max() < 1e-13
    assert np.ptp(run.energy) < 1e-7


def rotation(x: np.ndarray) -> np.ndarray:
    """Return that of the last bar."""
    R = np.eye(3)
    for angle, axis in zip(x, (1, 2, 0, 1, 2), strict=True):
        i, j = (axis + 1) % 3, (axis + 2) % 3
        turn = np.eye(3)
        turn[i, i] = turn[j, j] = np.cos(angle)
        turn[i, j], turn[j, i] = -np.sin(angle), np.sin(angle)
        R = R @ turn
    return R


def test_joints_of_jansens_leg_lie_where_circles_meet():
    """At every angle of the crank, through a whole turn; and the energy stays."""
    run = system("jansen").simulate((0.0, 1.0), rtol=1e-11, atol=1e-11)
    assert run.success, run.message
    assert np.ptp(run.x[0]) > 2 * np.pi
    assert np.ptp(run.energy) < 1e-8 * np.abs(run.energy).max()
    for x in run.x.T:
        found = np.exp(1j * x[1:])
        np.testing.assert_allclose(found, jansen(x[0], system("jansen").parameters), atol=1e-12)


def jansen(theta: float, p: dict[str, float]) -> list[complex]:
    """Return the directions of the bars (aj, ab, ak, ac, af, ag), as complex numbers."""
    B, P = -p["a"] - 1j * p["l"], p["m"] * np.exp(1j * theta)
    C, E = meet(B, p["b"], P, p["j"]), meet(P, p["k"], B, p["c"])
    D = meet(B, p["d"], C, p["e"])
    F = meet(E, p["g"], D, p["f"])
    ways = (C - P, C - B, E - P, E - B, F - D, F - E)
    return [way / abs(way) for way in ways]


def meet(p: complex, r: float, q: complex, s: float) -> complex:
    """Return where circles about p and q meet, to the left of the way from p to q."""
    distance = abs(q - p)
    along = (r**2 + distance**2 - s**2) / (2 * distance)
    return p + (q - p) / distance * (along + 1j * np.sqrt(r**2 - along**2))


def test_the_load_and_the_drone_fall_together_without_thrust():
    """Their common centre of mass falls freely, while the load swings."""
    drone = system("drone")
    run = drone.simulate((0.0, 0.5), v0={"sway": 1.5}, inputs=dict.fromkeys(drone.inputs, 0.0), rtol=1e-10, atol=1e-10)
    m, load, L, g = (drone.parameters[name] for name in ("m", "load", "L", "g"))
    sway, heave = run.x[6], run.x[7]
    rope = L * np.array([np.sin(sway) * np.cos(heave), np.sin(heave), -np.cos(sway) * np.cos(heave)])
    centre = run.x[:3] + load / (m + load) * rope
    rate = L * 1.5 * np.cos(heave[0]) * np.array([np.cos(sway[0]), 0.0, np.sin(sway[0])])
    v = run.v[:3, 0] + load / (m + load) * rate
    right = centre[:, :1] + np.outer(v, run.t) - np.outer([0.0, 0.0, g / 2], run.t**2)
    assert np.ptp(sway) > 0.1
    assert np.abs(centre - right).max() < 1e-9


def test_the_governor_keeps_its_angular_momentum_and_is_stiff():
    governor = system("governor")
    run = governor.simulate((0.0, 0.2), method="radau5", rtol=1e-8, atol=1e-10)
    assert run.success, run.message
    M, J, b, l = (governor.parameters[name] for name in ("M", "J", "b", "l"))
    radius = b + 2 * l * np.sin(run.x[1:3])
    momentum = (J + M * (radius**2).sum(axis=0)) * run.v[0]
    assert np.ptp(momentum) < 1e-6 * momentum[0]
    assert run.nsteps < 300  # an explicit method takes more than a thousand
