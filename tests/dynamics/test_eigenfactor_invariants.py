"""First integrals of the generated system, C^T C = I and M - C^T S^2 C, and that runs keep them."""

from functools import cache

import numpy as np
import pytest
import sympy
from scipy.stats import special_ortho_group
from sympy import Rational, cos, sin
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, System, t

from ..support.generation import system_for, system_of

CARRYING = ("dual_link", "double_pendulum", "four_bar", "slider_crank", "rigid_body", "heavy_top", "rolling_disk")


def carried_blocks(system: System) -> list[list[int]]:
    """Coordinates of the blocks of M whose C and s are states, in the order of the layout."""
    block = system.compiled.block
    numbers = sorted({block[k] for k in system.compiled.carried})
    return [[k for k, number in enumerate(block) if number == which] for which in numbers]


def factors(system: System, y: np.ndarray) -> list[tuple[list[int], np.ndarray, np.ndarray]]:
    """(coordinates, C, s) of each carried block of a state, or of a rate."""
    C, s, found = y[system.layout["C"]], y[system.layout["s"]], []
    for block in carried_blocks(system):
        size = len(block)
        found.append((block, C[: size**2].reshape(size, size), s[:size]))
        C, s = C[size**2 :], s[size:]
    return found


def random_state(system: System, random: np.random.Generator) -> np.ndarray:
    """A state whose C are any rotations and whose s are any numbers apart: not the eigenfactors of M(x)."""
    y = system.state() + random.normal(size=system.n_state)
    y[: system.n] = system.initial[0] + random.uniform(-0.3, 0.3, system.n)
    parts = carried_blocks(system)
    rotations = [special_ortho_group.rvs(len(b), random_state=random) if len(b) > 1 else np.eye(1) for b in parts]
    y[system.layout["C"]] = np.concatenate([C.ravel() for C in rotations])
    y[system.layout["s"]] = np.concatenate([random.permutation(0.6 + 0.4 * np.arange(len(b))) for b in parts])
    return y


def rates_of_integrals(system: System, y: np.ndarray, Mdot: np.ndarray) -> list[tuple[np.ndarray, np.ndarray, float]]:
    """(d/dt (M - C^T S^2 C), d/dt (C^T C), size of their terms) of each carried block."""
    dy, found = system.rhs(0.0, y), []
    for (block, C, s), (_, C_dot, s_dot) in zip(factors(system, y), factors(system, dy), strict=True):
        turning = C_dot.T @ np.diag(s**2) @ C
        stretching = C.T @ np.diag(2 * s * s_dot) @ C
        unit = system.scales[block]
        M_rate = Mdot[np.ix_(block, block)] * np.outer(unit, unit)
        size = max(np.abs(turning).max(), np.abs(stretching).max(), np.abs(M_rate).max(), np.abs(C_dot).max())
        found.append((M_rate - turning - turning.T - stretching, C_dot.T @ C + C.T @ C_dot, size))
    return found


@pytest.mark.parametrize("name", CARRYING)
def test_their_rates_vanish_at_random_states(name):
    system, random = system_of(name, schur="factor"), np.random.default_rng(3)
    for _ in range(20):
        y = random_state(system, random)
        xdot = system.rhs(0.0, y)[: system.n]
        Mdot = np.tensordot(xdot, system.mass_matrix_gradient(y[: system.n]), 1)
        assert carried_blocks(system)
        for E_rate, CC_rate, size in rates_of_integrals(system, y, Mdot):
            assert np.abs(E_rate).max() < 1e-14 * size
            assert np.abs(CC_rate).max() < 1e-14 * size


X = dynamicsymbols("x:3")
M_OF_XT = sympy.Matrix(
    [
        [3 + sin(X[1] + t), X[0] / 5, cos(2 * t)],
        [X[0] / 5, 4 + X[2] ** 2, Rational(1, 3) * sin(X[0])],
        [cos(2 * t), Rational(1, 3) * sin(X[0]), 5 + t**2],
    ]
)


@cache
def in_time() -> System:
    v = sympy.Matrix([x.diff() for x in X])
    energy = (v.T * M_OF_XT * v)[0] / 2
    scales = {X[0]: 2.0, X[2]: 0.5}
    return system_for(Model(name="in_time", coordinates=X, kinetic_energy=energy, scales=scales))


def test_their_rates_vanish_where_M_depends_on_time_and_units_differ():
    system, random = in_time(), np.random.default_rng(5)
    total = M_OF_XT.diff(t)  # through x too
    arguments = [*X, *(x.diff(t) for x in X), t]
    Mdot = sympy.lambdify(arguments, total)
    for _ in range(20):
        y = random_state(system, random)
        xdot = system.rhs(0.0, y)[:3]
        for E_rate, CC_rate, size in rates_of_integrals(system, y, Mdot(*y[:3], *xdot, 0.0)):
            assert np.abs(E_rate).max() < 1e-14 * size
            assert np.abs(CC_rate).max() < 1e-14 * size


def test_they_are_integrals_only_where_C_is_orthogonal():
    system, random = system_of("double_pendulum"), np.random.default_rng(7)
    y = random_state(system, random)
    y[system.layout["C"]] *= 1.01
    xdot = system.rhs(0.0, y)[: system.n]
    Mdot = np.tensordot(xdot, system.mass_matrix_gradient(y[: system.n]), 1)
    ((E_rate, _, size),) = rates_of_integrals(system, y, Mdot)
    assert np.abs(E_rate).max() > 1e-3 * size


# --- kept over a run --------------------------------------------------------------------------------------------------


def orthogonality(system: System, y: np.ndarray) -> float:
    """max|C^T C - I| over rows y (n_state, k) and blocks."""
    C, largest = y[system.layout["C"]], 0.0
    for block in carried_blocks(system):
        size = len(block)
        here = np.moveaxis(C[: size**2].reshape(size, size, -1), -1, 0)
        largest = max(largest, np.abs(np.einsum("kij,kil->kjl", here, here) - np.eye(size)).max())
        C = C[size**2 :]
    return float(largest)


@pytest.mark.parametrize("name", ["dual_link", "double_pendulum"])
def test_without_stabilisation_the_drift_falls_with_the_tolerance(name):
    """Where the motion is that of the published system throughout, as `extrapolate` builds it."""
    system, drifts = system_of(name, close_eigenvalues="extrapolate"), []
    tolerances = 10.0 ** -np.arange(7, 13)
    for rtol in tolerances:
        found = system.simulate((0, 4), rtol=rtol, atol=rtol, stabilisation="none")
        drifts.append((found.factor_residual.max(), orthogonality(system, found.y)))
    for drift in np.array(drifts).T:
        slope = np.polyfit(np.log(tolerances), np.log(drift), 1)[0]
        assert 0.85 < slope < 1.25, drift


@pytest.mark.parametrize("name", ["dual_link", "double_pendulum", "four_bar"])
def test_with_projection_they_stay_below_1e_13_over_100_000_steps(name):
    system = system_of(name)
    found = system.simulate((0, 20), method="rk34", rtol=1e-6, atol=1e-6, max_step=2e-4)
    assert found.success
    assert found.nsteps >= 100_000
    assert found.t.size == found.nsteps + 1
    assert found.factor_residual.max() < 1e-13
    assert orthogonality(system, found.y) < 1e-13
