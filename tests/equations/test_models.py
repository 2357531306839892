"""Every model in every formulation, against Lagrange's equations, invariants and known motions."""

import numpy as np
import pytest
import sympy

from eigenmotion import Solution, System, t
from eigenmotion.runtime import EvaluationError

from ..support.generation import FORMULATIONS, relative, system_of
from ..support.kinematics import acceleration, carried, factored, factored_gradient, slope
from ..support.models_table import BY_NAME, EVERY, SCENARIOS, Scenario

EQUAL = ("sphere", "quaternion_top")
"""Two eigenvalues of one block are equal for ever."""
FORMS = pytest.mark.parametrize("formulation", FORMULATIONS)
PUBLISHED = pytest.mark.parametrize(  # where eigenvalues of a block are equal for ever, (32) does not exist
    "scenario", [scenario for scenario in SCENARIOS if scenario.file not in EQUAL], ids=lambda scenario: scenario.name
)
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
    if scenario.file in EQUAL and formulation == "eigenfactor":
        pytest.skip("eigenvalues of one block are equal for ever")
    for x, v, time, parameters in points(scenario):
        y = system.state(x, v, time, parameters)
        dy = system.rhs(time, y, parameters)
        assert relative(dy[: system.n], v, 1e-3) < 1e-12
        right, _ = scenario.lagrange()(x, v, time, parameters)
        assert relative(along(system, time, y, dy, parameters), right, 1.0) < 2e-10
        assert relative(acceleration(system, time, y, dy, parameters), right, 1.0) < 1e-11


def along(system: System, time: float, y: np.ndarray, dy: np.ndarray, parameters: dict[str, float]) -> np.ndarray:
    """d/dt v(t, y) along dy by differences of the map y -> v."""
    prepared = system.prepare(parameters)

    def velocity(h: float) -> np.ndarray:
        return system.compiled.velocity_rows(np.array([time + h]), np.ascontiguousarray([y + h * dy]), prepared)[0]

    return slope(velocity, np.abs(dy).max())


@FORMS
def test_a_singular_mass_matrix_is_named(formulation):
    """A particle at the origin of polar coordinates: no infinity comes back."""
    system = system_of("polar_particle", formulation)
    with pytest.raises(EvaluationError, match="theta"):
        system.rhs(0.0, [0.0, 0.0, 1.0, 1.0])


@EVERY
@pytest.mark.parametrize("formulation", ["eigenfactor", "cholesky"])
def test_quasi_velocities_make_the_mass_matrix_the_identity(scenario, formulation):
    system = system_of(scenario.file, formulation)
    for x, v, time, parameters in points(scenario):
        eta = system.state(x, v, time, parameters)[system.layout["eta"]]
        assert eta @ eta == pytest.approx(v @ factored(system, x, time, parameters) @ v, rel=1e-13)


@PUBLISHED
def test_rates_of_the_eigenfactors_are_those_of_the_mass_matrix(scenario):
    """d/dt (C C^T) = 0 and d/dt (C^T S^2 C) = Mdot, block by block, with Mdot by differences of order 8."""
    system = system_of(scenario.file)
    for x, v, time, parameters in points(scenario):
        y = system.state(x, v, time, parameters)
        dy = system.rhs(time, y, parameters)
        M_dot = mass_slope(system, (x, time), (v, 1.0), parameters)
        for block, C, s, C_dot, s_dot in carried(system, y, dy):
            assert np.abs(C @ C.T - np.eye(len(s))).max() < 1e-14
            assert relative(C.T * s**2 @ C, factored(system, x, time, parameters)[np.ix_(block, block)]) < 1e-14
            size = np.abs(C_dot).max()
            assert np.abs(C_dot @ C.T + C @ C_dot.T).max() < 1e-14 * (1 + size)
            rate = C_dot.T * s**2 @ C + 2 * (C.T * (s * s_dot)) @ C + C.T * s**2 @ C_dot
            right = M_dot[np.ix_(block, block)]
            assert np.abs(rate - right).max() < 2e-11 * (1 + np.abs(right).max()) + 1e-14 * size * s.max() ** 2


def mass_slope(system, at, direction, parameters):
    """Derivative of M(x, t) along a direction (v, dt)."""
    (x, time), (v, rate) = at, direction
    return slope(lambda h: factored(system, x + h * v, time + h * rate, parameters), np.abs(v).max())


@EVERY
def test_gradient_of_the_mass_matrix(scenario):
    system = system_of(scenario.file)
    for x, _, time, parameters in points(scenario, 2):
        found = factored_gradient(system, x, time, parameters)
        for k, unit in enumerate(np.eye(system.n)):
            right = mass_slope(system, (x, time), (unit, 0.0), parameters)
            assert np.abs(found[k] - right).max() < 2e-11 * (1 + np.abs(found).max())


@EVERY
def test_energies(scenario):
    """T + V and T2 - T0 + V of the energies as they are given."""
    system, model = system_of(scenario.file), scenario.model()
    rates = dict(zip(model.rates, sympy.symbols(f"rate_:{model.n}"), strict=True))
    energies = [
        e.subs(dict(model.quasi_velocities)).doit().xreplace(rates)
        for e in (model.kinetic_energy, model.potential_energy)
    ]
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


@EVERY
@FORMS
@pytest.mark.parametrize("stabilisation", ["project", "none"])
def test_a_run(scenario, formulation, stabilisation):
    """The scene at rtol 1e-11, rows at times of no step."""
    system, times = system_of(scenario.file, formulation), np.linspace(0, scenario.t_end, 73)
    solution = system.simulate((0, scenario.t_end), rtol=1e-11, atol=1e-12, t_eval=times, stabilisation=stabilisation)
    assert solution.success, solution.message
    assert_final_state(solution, scenario)
    assert system.conserves_energy is (scenario.conserved is not None)
    if scenario.conserved:
        assert np.ptp(solution[scenario.conserved]) < 1e-9 * max(1, np.abs(solution.energy).max())
    limit = 1e-12 if stabilisation == "project" else 1e-8
    assert np.abs(solution.constraint_residual).max(initial=0.0) < limit
    assert np.abs(solution.position_residual).max(initial=0.0) < limit
    assert_factors(solution, 1e-8 if stabilisation == "none" and formulation == "eigenfactor" else 1e-13)


def assert_final_state(solution: Solution, scenario: Scenario) -> None:
    right = scenario.reference()
    for found, exact in ((solution.x[:, -1], right.x), (solution.v[:, -1], right.v)):
        known = ~np.isnan(np.asarray(exact, dtype=float))
        assert relative(found[known], np.asarray(exact, dtype=float)[known], 1.0) < 1e-9


def assert_factors(solution: Solution, limit: float) -> None:
    """C C^T = I, M = C^T S^2 C at every row, those between steps included."""
    assert solution.factor_residual.max() < limit
    identity = np.einsum("ijt,kjt->ikt", solution.C, solution.C) - np.eye(len(solution.x))[..., None]
    assert np.abs(identity).max() < limit
