"""models/servo_pendulums.py: a current loop and a balance, against equations by hand integrated by SciPy."""

import math
from functools import cache

import numpy as np
import pytest
import scipy.linalg
from scipy.integrate import solve_ivp

import eigenmotion as em

from ..support.by_day import PAGE
from ..support.generation import FORMULATIONS, model_of, system_of
from ..support.shown import check_page, check_picture, integrals

M0, M1, M2, L1, L2, ROTOR, PULLEY, G = 0.6, 0.1, 0.08, 0.3, 0.4, 8e-5, 0.02, 9.81
D0, D1, D2, K, R, L, KP, KI, MOST = 2.0, 2e-4, 2e-4, 0.1, 0.5, 1e-3, 0.5, 250.0, 8.0
FIRST, SECOND = (M1 / 2 + M2) * L1, M2 * L2 / 2
"""First moments [kg m] of what hangs on the rods' lower ends."""
TIMES = np.linspace(0.0, 2.0, 21)
TIGHT = {"rtol": 1e-11, "atol": 1e-12}


def mass_matrix(q1: float, q2: float) -> np.ndarray:
    c1, c2, c12 = math.cos(q1), math.cos(q2), math.cos(q1 - q2)
    rods = [[FIRST * c1, (M1 / 3 + M2) * L1**2, SECOND * L1 * c12], [SECOND * c2, SECOND * L1 * c12, M2 * L2**2 / 3]]
    return np.array([[M0 + ROTOR / PULLEY**2 + M1 + M2, FIRST * c1, SECOND * c2], *rods])


def linear() -> tuple[np.ndarray, np.ndarray]:
    """A (6, 6) and B (6,) of (x, q1, q2) and rates about the upright, with the current as input."""
    M = mass_matrix(0.0, 0.0)
    damping = np.array([[D0, 0, 0], [0, D1 + D2, -D2], [0, -D2, D2]])
    A = np.zeros((6, 6))
    A[:3, 3:] = np.eye(3)
    A[3:, :3] = np.linalg.solve(M, np.diag([0.0, FIRST * G, SECOND * G]))
    A[3:, 3:] = -np.linalg.solve(M, damping)
    return A, np.concatenate([[0.0] * 3, np.linalg.solve(M, [K / PULLEY, 0.0, 0.0])])


def regulator() -> np.ndarray:
    """Gains of the linear quadratic regulator, by SciPy's Riccati equation."""
    A, B = linear()
    P = scipy.linalg.solve_continuous_are(A, B[:, None], np.diag([40.0, 10.0, 10.0, 1.0, 1.0, 1.0]), [[0.05]])
    return B @ P / 0.05


GAINS = np.array([float(f"{gain:.4g}") for gain in regulator()])


def controlled(y: np.ndarray) -> tuple[float, float, float]:
    """Voltage, its value before saturation, and the current wanted, for (x, q1, q2, rates, i, e)."""
    wanted = -GAINS @ y[:6]
    command = KP * (wanted - y[6]) + KI * y[7]
    return min(MOST, max(-MOST, command)), command, wanted


def by_hand(t: float, y: np.ndarray) -> np.ndarray:
    _, q1, q2, v, w1, w2, i, _ = y.tolist()
    s1, s2, s12 = math.sin(q1), math.sin(q2), math.sin(q1 - q2)
    pull = [
        K * i / PULLEY - D0 * v + FIRST * s1 * w1**2 + SECOND * s2 * w2**2,
        FIRST * G * s1 - D1 * w1 + D2 * (w2 - w1) - SECOND * L1 * s12 * w2**2,
        SECOND * G * s2 - D2 * (w2 - w1) + SECOND * L1 * s12 * w1**2,
    ]
    voltage, command, wanted = controlled(y)
    rates = [(voltage - R * i - K * v / PULLEY) / L, wanted - i + (voltage - command) / KP]
    return np.concatenate([y[3:6], np.linalg.solve(mass_matrix(q1, q2), pull), rates])


@cache
def expected() -> np.ndarray:
    start = [0.0, 0.15, -0.1, 0.0, 0.0, 0.0, 0.0, 0.0]
    run = solve_ivp(by_hand, (0.0, 2.0), start, "DOP853", TIMES, rtol=1e-12, atol=1e-13)
    assert run.success
    return run.y


@pytest.mark.parametrize("method", ["dop853", "ra15", "radau9"])
@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_the_motion_is_that_by_hand(formulation, method):
    found = system_of("servo_pendulums", formulation).simulate((0, 2), t_eval=TIMES, method=method, **TIGHT)
    assert found.success
    rows = np.vstack([found.x, found.v, *found.states.values()])
    np.testing.assert_allclose(rows, expected(), rtol=0, atol=1e-8)
    voltage, _, wanted = np.array([controlled(y) for y in expected().T]).T
    np.testing.assert_allclose(found.outputs["voltage"], voltage, rtol=0, atol=1e-6)
    np.testing.assert_allclose(found.outputs["wanted"], wanted, rtol=0, atol=1e-6)


def test_the_gains_are_those_of_the_regulator():
    known = {symbol.name: value for symbol, value in model_of("servo_pendulums").parameters}
    assert [known[f"k{k}"] for k in range(1, 7)] == pytest.approx(GAINS, abs=0.0)


def test_it_saturates_and_settles():
    found = system_of("servo_pendulums").simulate((0, 10), rtol=1e-9, atol=1e-11)
    assert np.abs(found.outputs["voltage"]).max() == pytest.approx(MOST)
    assert np.abs(found.y[:, -1][[0, 1, 2]]).max() < 1e-9
    moved = system_of("servo_pendulums").simulate((0, 10), inputs={"target": 0.3}, x0={"q1": 0, "q2": 0})
    assert moved.x[:, -1] == pytest.approx([0.3, 0.0, 0.0], abs=1e-6)


def test_what_the_amplifier_delivers_is_motion_coil_and_heat():
    run, (electric, heat) = integrals(
        system_of("servo_pendulums"), (0.0, 1.5), ("electric_power", "heat"), rtol=1e-12, atol=1e-13
    )
    stored = run.energy + L * run.states["i"] ** 2 / 2
    assert heat > 1.0
    assert stored[-1] - stored[0] == pytest.approx(electric - heat, abs=1e-8 * heat)


def test_eigenvalues_of_the_closed_loop():
    A, B = linear()
    loop = np.zeros((8, 8))
    loop[:6, :6], loop[:6, 6] = A, B
    loop[6] = [*(-KP * GAINS), -KP - R, KI]
    loop[6, 3] -= K / PULLEY
    loop[6] /= L
    loop[7] = [*(-GAINS), -1.0, 0.0]
    right = np.sort_complex(np.linalg.eigvals(loop))
    rest = em.find_equilibrium(system_of("servo_pendulums", "lagrange"), {"q1": 0.0, "q2": 0.0})
    assert rest.success
    np.testing.assert_allclose(np.sort_complex(rest.linearize().eigenvalues()), right, rtol=1e-8)
    assert right.real.max() < -2.0


@pytest.mark.nightly(PAGE)
def test_page_and_picture(scene, hurried):
    check_picture("servo_pendulums", scene.parent, "--t-end", "1")
    check_page("servo_pendulums", scene.parent)
