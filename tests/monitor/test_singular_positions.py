"""Positions where constraints or inertia lose rank: passed rightly, or named."""

from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from sympy import cos, sin
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, System, t
from eigenmotion.arguments.methods import METHODS
from eigenmotion.runtime import StopReason

from ..support.failing_runs import FORMULATIONS, X, Y, check_honest, plane
from ..support.generation import system_for, system_of

RUNS = [(f, m) for f in FORMULATIONS for m in ("rk34", "dop853")] + [("lagrange", "radau5"), ("lagrange", "radau9")]


def dead_centre() -> Model:
    """A slider-crank with rod and crank of one length: at a right angle the slider may go on or stay."""
    theta, phi, x = dynamicsymbols("theta phi x")
    start = 1.0
    return Model(
        name="dead_centre",
        coordinates=[theta, phi, x],
        kinetic_energy=theta.diff() ** 2 / 6 + phi.diff() ** 2 / 10 + x.diff() ** 2 / 2,
        holonomic_constraints=[x - cos(theta) / 2 - cos(phi) / 2, (sin(theta) - sin(phi)) / 2],
        initial={theta: start, phi: start, x: np.cos(start)}
        | {theta.diff(): 1.0, phi.diff(): 1.0, x.diff(): -np.sin(start)},
    )


def flat() -> Model:
    """A four-bar linkage with equal opposite bars: flat, it may go on as a parallelogram or cross over."""
    q1, q2, q3 = dynamicsymbols("q1:4")
    a = 0.4
    return Model(
        name="flat",
        coordinates=[q1, q2, q3],
        kinetic_energy=q1.diff() ** 2 + q3.diff() ** 2 / 2 + q2.diff() * (q2.diff() / 3 + sin(q1 - q2) * q1.diff() / 5),
        holonomic_constraints=[
            a * cos(q1) + cos(q2) - a * cos(q3) - 1,
            a * sin(q1) + sin(q2) - a * sin(q3),
        ],
        initial={q1: 2.0, q3: 2.0, q1.diff(): -3.0, q3.diff(): -3.0},
    )


def cone() -> Model:
    """One row that vanishes at a point: x^2 = y^2, two lines that cross."""
    potential = (X + Y) / 8  # along the lines: the force across vanishes with the row
    return plane("cone", holonomic_constraints=[X**2 - Y**2], potential_energy=potential,
                 initial={X: -1.0, Y: -1.0, X.diff(): 1.0, Y.diff(): 1.0})  # fmt: skip


SINGULAR = {"dead_centre": dead_centre, "flat": flat, "cone": cone}


@cache
def singular(name: str, formulation: str) -> System:
    return system_for(SINGULAR[name](), formulation)


def branch(name: str, x: np.ndarray) -> np.ndarray:
    """What vanishes on the branch that a smooth motion stays on."""
    if name == "cone":
        return x[0] - x[1]
    return x[0] - x[1] if name == "dead_centre" else x[0] - x[2]


@pytest.mark.parametrize("stabilisation", ["project", "none"])
@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("name", list(SINGULAR))
def test_a_singular_position_is_passed_rightly_or_named(name, formulation, stabilisation):
    system, ends = singular(name, formulation), set()
    for method in METHODS:
        for rtol in (1e-4, 1e-6, 1e-9, 1e-12):
            options = {"rtol": rtol, "atol": rtol, "stabilisation": stabilisation, "max_steps": 20_000}
            found = system.simulate((0, 2), method=method, **options)
            check_honest(found)
            ends.add(found.stop)
            assert np.ptp(found.energy) < 1e5 * max(rtol, 1e-12), (method, rtol, found.message)
            if found.success:
                assert np.abs(branch(name, found.x)).max() < 1e3 * max(rtol, 1e-12), (method, rtol)
            else:
                assert "row" in found.message or found.stop is StopReason.TOO_MANY_STEPS
    allowed = {StopReason.FINISHED, StopReason.DEPENDENT_CONSTRAINTS, StopReason.POSITION_NOT_REACHED,
               StopReason.TOO_MANY_STEPS}  # fmt: skip
    assert ends <= allowed


@pytest.mark.parametrize("method", ["radau5", "radau9"])
@pytest.mark.parametrize("name", list(SINGULAR))
def test_a_singular_position_in_implicit_methods(name, method):
    for rtol in (1e-4, 1e-8):
        found = singular(name, "lagrange").simulate((0, 2), method=method, rtol=rtol, atol=rtol)
        check_honest(found)
        if found.success:
            assert np.abs(branch(name, found.x)).max() < 1e-3
        else:
            assert found.stop in (StopReason.DEPENDENT_CONSTRAINTS, StopReason.POSITION_NOT_REACHED)


@pytest.mark.parametrize(
    ("name", "x0", "row"), [("cone", [0, 0], 0), ("flat", [0, 0, 0], 0), ("dead_centre", [np.pi / 2, np.pi / 2, 0], 1)]
)
def test_a_start_in_a_singular_position_is_named(name, x0, row):
    for formulation in FORMULATIONS:
        found = singular(name, formulation).simulate((0, 1), x0=x0, v0=np.zeros(len(x0)))
        check_honest(found)
        assert found.stop is StopReason.DEPENDENT_CONSTRAINTS
        assert f"row {row} " in found.message


# --- rank of the mass matrix ------------------------------------------------------------------------------------------


@cache
def telescope(formulation: str) -> System:
    """A double pendulum whose outer link shrinks through zero at t = 1, where its angle has no inertia left."""
    a, b = dynamicsymbols("alpha beta")
    length = 1 - t
    velocity = [(sin(a) + length * sin(b)).diff(t), (cos(a) + length * cos(b)).diff(t)]
    energy = a.diff() ** 2 / 4 + sum(v**2 for v in velocity) / 2
    start = {a: 0.3, b: 0.8, b.diff(): 0.5}
    return system_for(Model(name="telescope", coordinates=[a, b], kinetic_energy=energy, initial=start), formulation)


@pytest.mark.parametrize(("formulation", "method"), RUNS)
def test_a_link_that_shrinks_through_zero_is_named(method, formulation):
    found = telescope(formulation).simulate((0, 2), method=method, max_steps=3_000)
    check_honest(found)
    assert found.stop in (StopReason.SINGULAR_MASS_MATRIX, StopReason.STEP_SIZE_UNDERFLOW, StopReason.TOO_MANY_STEPS)
    assert found.t[-1] < 1 + 1e-9
    if found.stop is StopReason.SINGULAR_MASS_MATRIX:
        assert "'beta'" in found.message


@pytest.mark.parametrize(("formulation", "method"), RUNS)
def test_gimbal_lock_is_passed_rightly_or_named(method, formulation):
    """Turning about body axis 1 straight through theta = 0, where two Euler angles are one."""
    system = system_of("rigid_body", formulation)
    found = system.simulate((0, 2), x0=[0, 0.5, 0], v0=[0, -1, 0], method=method, rtol=1e-8, max_steps=20_000)
    check_honest(found)
    np.testing.assert_allclose(found.x, [0 * found.t, 0.5 - found.t, 0 * found.t], atol=1e-5)
    allowed = (StopReason.FINISHED, StopReason.SINGULAR_MASS_MATRIX, StopReason.STEP_SIZE_UNDERFLOW)
    assert found.stop in allowed


def euler(_: float, w: np.ndarray) -> np.ndarray:
    """Rates of body rates, of a free body with J = 1, 2, 3: J wdot = (J w) x w."""
    J = np.array([1.0, 2.0, 3.0])
    return np.cross(J * w, w) / J


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_close_by_gimbal_lock_the_motion_is_right(formulation):
    """theta comes as near as 1e-4; Euler's equations do not know of it."""
    system = system_of("rigid_body", formulation)
    v0 = {"omega_1": -1.0, "omega_2": 2e-4, "omega_3": 0.1}
    found = system.simulate((0, 2), x0=[0, 0.5, 0.1], v0=v0, rtol=1e-10, atol=1e-10)
    check_honest(found)
    if found.success:
        right = solve_ivp(euler, (0, 2), list(v0.values()), "DOP853", rtol=1e-12, atol=1e-13).y[:, -1]
        assert [found.quasi_velocities[name][-1] for name in v0] == pytest.approx(right, abs=1e-6)
    else:
        assert found.stop in (StopReason.SINGULAR_MASS_MATRIX, StopReason.STEP_SIZE_UNDERFLOW)
