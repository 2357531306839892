"""Every model in every formulation, against Lagrange's equations, invariants and known motions."""

from functools import cache

import numpy as np
import pytest
import sympy
from eigenmotion import Solution, System, t

from .generation import FORMULATIONS, relative, system_of
from .models_table import BY_NAME, SCENARIOS, Scenario

EVERY = pytest.mark.parametrize("scenario", SCENARIOS, ids=lambda scenario: scenario.name)
FORMS = pytest.mark.parametrize("formulation", FORMULATIONS)
SOME_ROWS = ("four_bar", "slider_crank", "rolling_disk")


def points(scenario: Scenario, count: int = 4):
    """Give random x, v, t and parameters."""
    for k, state in enumerate(scenario.random_states(count, seed=k_of(scenario))):
        yield state.x, state.v, 0.3 * k, scenario.random_parameters(seed=k)


def k_of(scenario: Scenario) -> int:
    return SCENARIOS.index(scenario)


# --- one state --------------------------------------------------------------------------------------------------------


@EVERY
@FORMS
def test_accelerations_and_multipliers(scenario, formulation):
    system = system_of(scenario.file, formulation)
    for x, v, time, parameters in points(scenario):
        found, right = system.acceleration(x, v, time, parameters), scenario.lagrange()(x, v, time, parameters)
        assert relative(found[0], right[0]) < 1e-11
        assert relative(found[1], right[1], 1e-2) < 1e-11


@EVERY
@FORMS
def test_right_hand_sides_hold_the_acceleration(scenario, formulation):
    """xddot is the derivative of v(t, y) along dy, whatever y carries."""
    system = system_of(scenario.file, formulation)
    for x, v, time, parameters in points(scenario):
        y = system.state(x, v, time, parameters)
        dy = system.rhs(time, y, parameters)
        assert relative(dy[: system.n], v, 1e-3) < 1e-12
        right, _ = scenario.lagrange()(x, v, time, parameters)
        assert relative(along(system, time, y, dy, parameters), right, 1.0) < 2e-10


def along(system: System, time: float, y: np.ndarray, dy: np.ndarray, parameters: dict[str, float]) -> np.ndarray:
    """d/dt v(t, y) along dy by central differences of order 8."""
    h = 2e-2 / (1 + np.abs(dy).max())
    steps, weights = h * np.arange(1, 5), np.array([4 / 5, -1 / 5, 4 / 105, -1 / 280]) / h
    prepared = system.prepare(parameters)
    times = np.concatenate([time + steps, time - steps])
    rows = np.ascontiguousarray(np.concatenate([y + steps[:, None] * dy, y - steps[:, None] * dy]))
    v = system.compiled.velocity_rows(times, rows, prepared)
    return weights @ (v[:4] - v[4:])


@EVERY
@pytest.mark.parametrize("formulation", ["eigenfactor", "cholesky"])
def test_quasi_velocities_make_the_mass_matrix_the_identity(scenario, formulation):
    system = system_of(scenario.file, formulation)
    for x, v, time, parameters in points(scenario):
        eta = system.state(x, v, time, parameters)[system.layout["eta"]]
        assert eta @ eta == pytest.approx(v @ system.mass_matrix(x, time, parameters) @ v, rel=1e-13)


@EVERY
def test_rates_of_the_eigenfactors_are_those_of_the_mass_matrix(scenario):
    """d/dt (C C^T) = 0 and d/dt (C^T S^2 C) = Mdot, block by block, with Mdot by differences of order 8."""
    system = system_of(scenario.file)
    for x, v, time, parameters in points(scenario):
        y = system.state(x, v, time, parameters)
        dy = system.rhs(time, y, parameters)
        for block, C, s, C_dot, s_dot in turning(system, y, dy):
            assert np.abs(C @ C.T - np.eye(len(s))).max() < 1e-14
            assert relative(C.T * s**2 @ C, system.mass_matrix(x, time, parameters)[np.ix_(block, block)]) < 1e-14
            size = np.abs(C_dot).max()
            assert np.abs(C_dot @ C.T + C @ C_dot.T).max() < 1e-14 * (1 + size)
            rate = C_dot.T * s**2 @ C + 2 * (C.T * (s * s_dot)) @ C + C.T * s**2 @ C_dot
            right = mass_rate(system, x, v, time, parameters)[np.ix_(block, block)]
            assert np.abs(rate - right).max() < 2e-11 * (1 + np.abs(right).max()) + 1e-14 * size * s.max() ** 2


def turning(system: System, y: np.ndarray, dy: np.ndarray):
    """Give block, C, s, Cdot, sdot of each block whose eigenfactors the state carries."""
    if "C" not in system.layout:
        return
    C, s = system.layout["C"].start, system.layout["s"].start
    for block in (block for block in system.blocks if carried(system)[block[0]]):
        n = len(block)
        yield block, y[C : C + n * n].reshape(n, n), y[s : s + n], dy[C : C + n * n].reshape(n, n), dy[s : s + n]
        C, s = C + n * n, s + n


def carried(system: System) -> list[bool]:
    """Whether the state holds C and s of a coordinate's block: those of varying blocks of two or more."""
    probes = [system.mass_matrix(system.initial[0] + 0.1 * k, 0.1 * k) for k in range(4)]
    varies = np.ptp(probes, axis=0) > 0
    flags = [False] * system.n
    for block in system.blocks:
        for k in block:
            flags[k] = len(block) > 1 and bool(varies[np.ix_(block, block)].any())
    return flags


def mass_rate(system, x, v, time, parameters):
    h = 1e-2 / (1 + np.abs(v).max())
    weights = np.array([4 / 5, -1 / 5, 4 / 105, -1 / 280]) / h
    M = [[system.mass_matrix(x + s * k * h * v, time + s * k * h, parameters) for k in range(1, 5)] for s in (1, -1)]
    return np.tensordot(weights, np.array(M[0]) - np.array(M[1]), axes=1)


@EVERY
def test_gradient_of_the_mass_matrix(scenario):
    system = system_of(scenario.file)
    for x, _, time, parameters in points(scenario, 2):
        found = system.mass_matrix_gradient(x, time, parameters)
        for k, unit in enumerate(np.eye(system.n)):
            frozen = mass_rate(system, x, unit, time, parameters) - mass_rate(system, x, 0 * unit, time, parameters)
            assert np.abs(found[k] - frozen).max() < 2e-11 * (1 + np.abs(found).max())


@EVERY
def test_energies(scenario):
    """T + V and T2 - T0 + V of the energies as they are given."""
    system, model = system_of(scenario.file), scenario.model()
    rates = dict(zip(model.rates, sympy.symbols(f"rate_:{model.n}"), strict=True))
    energies = [e.subs(dict(model.quasi_velocities)).doit().xreplace(rates) for e in (model.kinetic_energy, model.potential_energy)]
    still = dict.fromkeys(rates.values(), 0)
    turned = {rate: -rate for rate in rates.values()}
    T, V = energies
    arguments = [*model.coordinates, *rates.values(), t, *(symbol for symbol, _ in model.parameters)]
    T0 = T.subs(still)
    evaluate = sympy.lambdify(arguments, [T + V, (T + T.xreplace(turned)) / 2 - 2 * T0 + V])
    for x, v, time, parameters in points(scenario):
        right = evaluate(*x, *v, time, *parameters.values())
        found = [system.energy(x, v, time, parameters), system.jacobi_integral(x, v, time, parameters)]
        assert relative(found, right) < 1e-12


@pytest.mark.parametrize("name", SOME_ROWS)
def test_carrying_eigenfactors_of_delta_changes_no_acceleration(name):
    scenario, system = BY_NAME[name], system_of(name, schur="eigenfactor")
    for x, v, time, parameters in points(scenario):
        y = system.state(x, v, time, parameters)
        right, _ = scenario.lagrange()(x, v, time, parameters)
        assert relative(along(system, time, y, system.rhs(time, y, parameters), parameters), right, 1.0) < 2e-10


# --- a run ------------------------------------------------------------------------------------------------------------


@cache
def run(name: str, formulation: str, stabilisation: str) -> Solution:
    """The scene at rtol 1e-11, rows at times of no step."""
    scenario = BY_NAME[name]
    times = np.linspace(0, scenario.t_end, 73)
    return system_of(scenario.file, formulation).simulate(
        (0, scenario.t_end), rtol=1e-11, atol=1e-12, t_eval=times, stabilisation=stabilisation
    )


RUNS = pytest.mark.parametrize("stabilisation", ["project", "none"])


@EVERY
@FORMS
@RUNS
def test_final_states(scenario, formulation, stabilisation):
    solution, right = run(scenario.name, formulation, stabilisation), scenario.reference()
    assert solution.success, solution.message
    for found, exact in ((solution.x[:, -1], right.x), (solution.v[:, -1], right.v)):
        known = ~np.isnan(np.asarray(exact, dtype=float))
        assert relative(found[known], np.asarray(exact, dtype=float)[known], 1.0) < 1e-9


@EVERY
@FORMS
@RUNS
def test_conserved_energy(scenario, formulation, stabilisation):
    solution = run(scenario.name, formulation, stabilisation)
    assert system_of(scenario.file, formulation).conserves_energy is (scenario.conserved is not None)
    if scenario.conserved:
        history = solution[scenario.conserved]
        assert np.ptp(history) < 1e-9 * max(1, np.abs(solution.energy).max())


@EVERY
@FORMS
@RUNS
def test_constraints(scenario, formulation, stabilisation):
    solution = run(scenario.name, formulation, stabilisation)
    limit = 1e-12 if stabilisation == "project" else 1e-8
    assert np.abs(solution.constraint_residual).max(initial=0.0) < limit
    assert np.abs(solution.position_residual).max(initial=0.0) < limit


@EVERY
@FORMS
@RUNS
def test_factors(scenario, formulation, stabilisation):
    """C C^T = I, M = C^T S^2 C at every row, those between steps included."""
    solution = run(scenario.name, formulation, stabilisation)
    limit = 1e-8 if stabilisation == "none" and formulation == "eigenfactor" else 1e-13
    assert solution.factor_residual.max() < limit
    identity = np.einsum("ijt,kjt->ikt", solution.C, solution.C) - np.eye(len(solution.x))[..., None]
    assert np.abs(identity).max() < limit
