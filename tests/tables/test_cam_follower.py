"""models/cam_follower.py: contact, flight and impacts on a tabulated cam, by one or two coordinates and SciPy."""

from functools import cache
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import make_interp_spline
from scipy.optimize import minimize_scalar

from ..support.generation import FORMULATIONS, system_of
from ..support.shown import check_page, check_picture, integrals

m, k, F0, G, J, C, W, E, REST = 0.3, 5000.0, 40.0, 9.81, 0.02, 0.5, 140.0, 0.3, 1e-3
ROWS = np.genfromtxt(Path(__file__).parents[2] / "models" / "cam_follower.csv", delimiter=",", names=True)
LIFT = make_interp_spline(np.radians(ROWS["angle_deg"]), ROWS["lift_mm"] / 1000, k=5, bc_type="periodic")
TIGHT = {"rtol": 1e-11, "atol": 1e-13}


def spring(y: float) -> float:
    """The force [N] downwards."""
    return k * y + F0 + m * G


def lift(phi: float) -> tuple[float, float, float]:
    """Lift, and its first two derivatives with the angle."""
    angle = phi % (2 * np.pi)
    return tuple(float(LIFT(angle, order)) for order in range(3))


# --- the speed at which lift-off begins ---


def critical_speed() -> float:
    """The least of sqrt((k lift + F0 + m g) / (-m lift'')), which is where the contact's force is zero."""

    def squared(angle: float) -> float:
        h, _, bend = lift(angle)
        return spring(h) / (-m * bend) if bend < 0 else np.inf

    angles = np.linspace(0, 2 * np.pi, 7201)
    near = angles[np.argmin([squared(angle) for angle in angles])]
    step = angles[1]
    found = minimize_scalar(squared, bounds=(near - step, near + step), method="bounded", options={"xatol": 1e-10})
    return float(np.sqrt(found.fun))


def test_lift_off_begins_at_the_speed_of_the_second_derivative():
    """With a flywheel that keeps the speed; a millionth below it stays on the cam, a millionth above it does not."""
    begins = critical_speed()
    for share in (1 - 1e-3, 1 - 1e-6, 1 + 1e-6, 1 + 1e-3):
        speed = begins * share
        found = system_of("cam_follower", "lagrange").simulate(
            (0.0, 1.9 * np.pi / speed), v0={"phi": speed}, parameters={"J": 1e9, "w": speed}, rtol=1e-11, atol=1e-12
        )
        assert found.success
        released = [mode for t, mode in found.modes if t > 1e-6 and mode["cam_held"] == 0.0]
        assert bool(released) == (share > 1), share


# --- the motion ---


def touching(t: float, z: np.ndarray) -> list[float]:
    """Rates of (phi, phi') while the roller is on the cam."""
    h, slope, bend = lift(z[0])
    pull = C * (W - z[1]) - slope * (m * bend * z[1] ** 2 + spring(h))
    return [z[1], pull / (J + m * slope**2)]


def pressing(t: float, z: np.ndarray) -> float:
    """The contact's force [N]."""
    h, slope, bend = lift(z[0])
    return m * (slope * touching(t, z)[1] + bend * z[1] ** 2) + spring(h)


def flying(t: float, z: np.ndarray) -> list[float]:
    """Rates of (phi, y, phi', y')."""
    return [z[2], z[3], C * (W - z[2]) / J, -spring(z[1]) / m]


def gap(t: float, z: np.ndarray) -> float:
    return z[1] - lift(z[0])[0]


pressing.terminal = gap.terminal = True  # type: ignore[attr-defined]
pressing.direction = gap.direction = -1.0  # type: ignore[attr-defined]


def struck(z: np.ndarray) -> tuple[np.ndarray, bool]:
    """The state after an impact, by Newton's law along (-lift', 1), and whether the follower stays."""
    normal, masses = np.array([-lift(z[0])[1], 1.0]), np.array([J, m])
    approach = normal @ z[2:]
    stays = -E * approach <= REST
    impulse = -(1 + (0.0 if stays else E)) * approach / (normal**2 / masses).sum()
    return np.concatenate([z[:2], z[2:] + impulse * normal / masses]), bool(stays)


def on_cam(z: np.ndarray) -> np.ndarray:
    """(phi, y, phi', y') of (phi, phi')."""
    h, slope, _ = lift(z[0])
    return np.array([z[0], h, z[1], slope * z[1]])


@cache
def expected(end: float) -> tuple[np.ndarray, int, float]:
    """The state at the end, the number of impacts, and the energy [J] lost in them."""
    t, z, stays, impacts, lost = 0.0, np.array([0.0, 0.0, 140.0, 0.0]), True, 0, 0.0
    while True:
        rates, event, start = (touching, pressing, z[[0, 2]]) if stays else (flying, gap, z)
        ahead = 0.0 if stays else 1e-9  # beside the root, where the follower has just left
        start = start + ahead * np.array(rates(t, start))
        run = solve_ivp(rates, (t + ahead, end), start, "DOP853", rtol=1e-12, atol=1e-14, events=event, max_step=1e-3)
        t, z = run.t[-1], on_cam(run.y[:, -1]) if stays else run.y[:, -1]
        if run.status == 0:
            return z, impacts, lost
        if stays:
            stays = False
            continue
        before, impacts = kinetic(z), impacts + 1
        z, stays = struck(z)
        lost += before - kinetic(z)


def kinetic(z: np.ndarray) -> float:
    return (J * z[2] ** 2 + m * z[3] ** 2) / 2


@pytest.mark.parametrize("method", ["dop853", "ra15", "radau9"])
@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_two_turns_by_hand(formulation, method):
    right, impacts, _ = expected(0.09)
    assert impacts >= 6
    found = system_of("cam_follower", formulation).simulate((0.0, 0.09), method=method, **TIGHT)
    assert found.success
    np.testing.assert_allclose(found.y[[0, 1], -1], right[:2], rtol=0, atol=1e-8)
    np.testing.assert_allclose(np.array([found.v[0, -1], found.v[1, -1]]), right[2:], rtol=0, atol=1e-6)
    assert found.outputs["gap"].min() > -1e-12
    assert found.outputs["pressing"].min() > -1e-6


def test_work_of_the_motor_is_energy_and_what_impacts_take():
    run, (work,) = integrals(system_of("cam_follower"), (0.0, 0.09), ("motor_power",), **TIGHT)
    lost = expected(0.09)[2]
    assert lost > 1e-3
    assert run.energy[-1] - run.energy[0] == pytest.approx(work - lost, abs=1e-8 * run.energy[0])


def test_other_profiles_need_no_compiling():
    """Half the lift at 100 rad/s: no lift-off, and the follower is where the table says."""
    halved = make_interp_spline(LIFT.t[5:-5], LIFT(LIFT.t[5:-5]) / 2, k=5, bc_type="periodic")
    found = system_of("cam_follower").simulate(
        (0.0, 0.1), parameters={"lift": halved, "w": 100.0}, v0={"phi": 100.0}, rtol=1e-9, atol=1e-12
    )
    assert found.modes[-1][1] == {"cam_held": 1.0}
    assert found.x[1] == pytest.approx(halved(found.x[0] % (2 * np.pi)), abs=1e-12)


def test_page_and_picture(scene, hurried):
    check_picture("cam_follower", scene.parent, "--t-end", "0.1")
    check_page("cam_follower", scene.parent)
