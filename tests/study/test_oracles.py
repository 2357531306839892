"""The oracles among themselves: closed forms, high-precision integration, published values, Newton's second law."""

from dataclasses import replace
from functools import cache

import mpmath
import numpy as np
import pytest
import sympy
from scipy.integrate import solve_ivp
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

from eigenmotion import Model, t

from ..oracles import Lagrange, State, elementary, elliptic, initial_state, parameters_of, published, trajectory
from ..oracles.trajectory import integrate
from ..support.by_day import CLOSED_FORM
from ..support.models_table import BY_NAME, EVERY, SCENARIOS, Scenario

CLOSED = [scenario for scenario in SCENARIOS if scenario.closed_form]
IN_TURN = [
    pytest.param(scenario, id=scenario.name, marks=[pytest.mark.nightly(CLOSED_FORM)] if k % 3 else [])
    for k, scenario in enumerate(CLOSED)
]
# errors of the closed forms: rounding of start values, times the growth of perturbations
LIMIT = 1e-13
PUBLISHED = {"dual_link": "t = 10", "andrews": r"t = 0\.03"}
"""States at one time alone, and when."""
DIGITS = {"andrews": 1e-9}
"""To which such a state is known where that is less than rounding: this one was found by integration, too."""


def largest_difference(a: np.ndarray, b: np.ndarray) -> float:
    """Largest |a - b| / max(1, |b|) over the entries that are known."""
    known = ~np.isnan(np.asarray(a, dtype=float))
    return float(np.max(np.abs(a - b)[known] / np.maximum(1, np.abs(b[known])), initial=0.0))


@cache
def integrated_to_the_end(scenario: Scenario) -> State:
    return trajectory(scenario.model(), scenario.t_end)


@pytest.mark.parametrize("scenario", IN_TURN)
def test_closed_forms_agree_with_integration(scenario):
    exact, integrated = scenario.reference(), integrated_to_the_end(scenario)
    limit = DIGITS.get(scenario.file, LIMIT)
    assert largest_difference(exact.x, integrated.x) < limit
    assert largest_difference(exact.v, integrated.v) < limit


@pytest.mark.parametrize("scenario", IN_TURN)
def test_closed_forms_say_something_else_at_another_time(scenario):
    if scenario.file in PUBLISHED:
        with pytest.raises(ValueError, match=PUBLISHED[scenario.file]):
            scenario.closed_form(scenario.model(), 0.9 * scenario.t_end)
        return
    early = scenario.closed_form(scenario.model(), 0.9 * scenario.t_end)
    assert largest_difference(scenario.reference().x, early.x) > 1e-3


def test_integration_in_arbitrary_precision():
    """The pendulum in 30 digits: elliptic functions and extrapolation agree far below double rounding."""
    model = replace(BY_NAME["pendulum"].model(), initial={dynamicsymbols("theta"): 2})
    with mpmath.workdps(30):
        end = trajectory(model, 1.0, precision="arbitrary", tolerance=1e-24)
        k, w = mpmath.sin(1), mpmath.sqrt(mpmath.mpf(9.81))
        theta = 2 * mpmath.asin(k * mpmath.ellipfun("cd", w, k=k))
        assert abs(end.x[0] - theta) < 1e-22


def test_the_multiplier_at_the_end_of_the_papers_experiment():
    scenario = BY_NAME["dual_link"]
    end = integrated_to_the_end(scenario)
    _, (multiplier,) = Lagrange(scenario.model(), "extended")(end.x, end.v)
    assert abs(multiplier - np.longdouble(published.DUAL_LINK_MULTIPLIER)) < 1e-13


def test_integration_converges_with_its_tolerance():
    model = BY_NAME["double_pendulum"].model()
    fine = trajectory(model, 2.0)
    errors = [np.abs(trajectory(model, 2.0, tolerance=tolerance).x - fine.x).max() for tolerance in (1e-8, 1e-12)]
    assert errors[1] < 1e-3 * errors[0]
    assert errors[1] < 1e-11


def test_integration_stops_below_rounding():
    with pytest.raises(RuntimeError, match="below rounding"):
        integrate(lambda time, y: -y, np.array([1.0]), 1.0, 1e-30, "double")


@pytest.mark.parametrize("file", ["double_pendulum", "elastic_pendulum", "rotating_spring", "heavy_top", "veering"])
def test_accelerations_agree_with_sympy_mechanics(file):
    scenario = BY_NAME[file]
    model = scenario.model()
    method = LagrangesMethod(model.kinetic_energy - model.potential_energy, model.coordinates)
    method.form_lagranges_equations()
    plain = {x.diff(t): sympy.Symbol(f"v{k}") for k, x in enumerate(model.coordinates)}
    plain |= {x: sympy.Symbol(f"x{k}") for k, x in enumerate(model.coordinates)}
    for state in scenario.random_states(3):
        parameters = scenario.random_parameters()
        values = {symbol: parameters[str(symbol)] for symbol, _ in model.parameters}
        values |= dict(zip(plain.values(), [*state.v, *state.x], strict=True))
        M, f = (np.array(e.xreplace(plain).xreplace(values), dtype=float) for e in (method.mass_matrix, method.forcing))
        acceleration, _ = scenario.lagrange()(state.x, state.v, parameters=parameters)
        np.testing.assert_allclose(acceleration, np.linalg.solve(M, f).ravel(), rtol=1e-11, atol=1e-11)


def test_multipliers_have_the_sign_of_the_paper():
    """M xddot = Q - A^T lambda (7): the guide pin of the slider, and a hanging mass at rest."""
    slider = BY_NAME["slider_crank"]
    acceleration, multipliers = slider.lagrange()(*(getattr(initial_state(slider.model()), f) for f in "xv"))
    assert multipliers[0] == pytest.approx(-parameters_of(slider.model())["m_s"] * acceleration[2], rel=1e-13)

    pendulum = BY_NAME["driven_pendulum"]
    at_rest = {"a": 0.0, "l": 2.0, "m": 3.0}
    acceleration, (tension,) = pendulum.lagrange()([0.0, -2.0], [0.0, 0.0], parameters=at_rest)
    np.testing.assert_allclose(acceleration, 0, atol=1e-15)
    # the rod pulls up with m g = -A_y lambda, A_y = 2 y = -4
    assert 4 * tension == pytest.approx(3.0 * 9.81)


@EVERY
def test_initial_states_satisfy_their_constraints(scenario):
    for residual in constraint_residuals(scenario.model(), initial_state(scenario.model())):
        assert abs(residual) < 1e-14


@pytest.mark.parametrize("file", ["four_bar", "slider_crank", "rolling_disk", "sphere", "chaplygin_sleigh"])
def test_constraints_hold_at_the_end(file):
    scenario = BY_NAME[file]
    end = integrated_to_the_end(scenario)
    assert max(map(abs, constraint_residuals(scenario.model(), end))) < 1e-13


def constraint_residuals(model: Model, state: State) -> list[float]:
    """phi, its rate and the nonholonomic rows, at t = 0 or where time does not enter."""
    values = dict(zip([*model.rates, *model.coordinates], map(sympy.Float, [*state.v, *state.x]), strict=True))
    quasi = dict(model.quasi_velocities)
    rows = [*model.holonomic_constraints, *(phi.diff(t) for phi in model.holonomic_constraints)]
    rows += [row.xreplace(quasi) for row in model.nonholonomic_constraints]
    parameters = dict(model.parameters) | {t: 0.0}
    return [float(row.xreplace(values).subs(parameters)) for row in rows]


def test_kepler_closes_its_ellipse():
    model = BY_NAME["polar_particle"].model()
    end = elementary.kepler(model, 2 * np.pi)
    np.testing.assert_allclose(end.x, [0.1, 2 * np.pi], atol=1e-12)


def test_steady_precession_of_the_top():
    model = BY_NAME["heavy_top"].model()
    theta, axial = 0.6, 40.0
    rate = elliptic.steady_precession(model, theta, axial)
    v = [rate, 0.0, axial - rate * np.cos(theta)]
    acceleration, _ = BY_NAME["heavy_top"].lagrange()([0.3, theta, 0.2], v)
    np.testing.assert_allclose(acceleration, 0, atol=1e-11)


@pytest.mark.parametrize(("lean", "turn"), [(0.2, 1.5), (-0.4, 0.7), (0.6, -2.0)])
def test_steady_motions_of_the_disk(lean, turn):
    scenario = BY_NAME["rolling_disk"]
    roll = elementary.steady_spin(scenario.model(), lean, turn)
    r = parameters_of(scenario.model())["r"]
    heading = 0.4
    v = [r * roll * np.cos(heading), r * roll * np.sin(heading), turn, 0.0, roll]
    acceleration, _ = scenario.lagrange()([0.0, 0.0, heading, lean, 0.0], v)
    np.testing.assert_allclose(acceleration[2:], 0, atol=1e-11)


def test_the_bead_rests_where_weight_and_turning_balance():
    scenario = BY_NAME["rotating_hoop"]
    p = parameters_of(scenario.model())
    theta = np.arccos(p["g"] / (p["R"] * p["Omega"] ** 2))
    acceleration, _ = scenario.lagrange()([theta], [0.0])
    assert abs(acceleration[0]) < 1e-13


def test_the_ball_keeps_its_spin():
    model = BY_NAME["sphere"].model()
    start, end = initial_state(model), integrated_to_the_end(BY_NAME["sphere"])
    p = parameters_of(model)
    before, after = (elementary.ball_rates(model, state) for state in (start, end))
    rolled = np.array([0.0, 5 / 7 * p["g"] * np.sin(p["alpha"]) / p["R"], 0.0])
    np.testing.assert_allclose((after - before).astype(float), rolled, atol=1e-14)


def test_two_chains_are_a_double_pendulum():
    double, chain = BY_NAME["double_pendulum"], replace(BY_NAME["chain_5"], keywords=(("n", 2),))
    p = double.random_parameters()
    renamed = {"m_1": p["m1"], "m_2": p["m2"], "l_1": p["l1"], "l_2": p["l2"], "g": p["g"]}
    for state in double.random_states(3):
        a, _ = double.lagrange()(state.x, state.v, parameters=p)
        b, _ = chain.lagrange()(state.x, state.v, parameters=renamed)
        np.testing.assert_allclose(a, b, rtol=1e-12)


def test_the_arm_from_positions_in_the_fixed_frame():
    """The arm's kinetic energy, which its model forms in the axes of the links, from velocities of many points."""
    model = BY_NAME["spatial_arm_3"].model()
    state = BY_NAME["spatial_arm_3"].random_states(1)[0]
    values = dict(zip([*model.rates, *model.coordinates], [*state.v, *state.x], strict=True))
    T = float(model.kinetic_energy.xreplace(values).subs(dict(model.parameters)))
    np.testing.assert_allclose(T, kinetic_energy_of_points(parameters_of(model), state), rtol=1e-13)


def kinetic_energy_of_points(p: dict[str, float], state: State) -> float:
    """Each link as points of equal moments: two on its axis, four across it; velocities by complex steps."""
    step = 1e-30
    q = state.x + 1j * step * state.v
    joint, R, T = np.zeros(3, dtype=complex), np.eye(3, dtype=complex), 0.0
    for k, angle in enumerate(q):
        l, m, rho = p[f"l_{k + 1}"], p[f"m_{k + 1}"], p["rho"]
        R = R @ turn(angle, axis=1 if k % 2 else 2)
        # six points of mass m / 6 about the middle: moments m rho^2 / 2 along, m (l^2 / 12 + rho^2 / 4) across
        half, wide = l / 2, rho * np.sqrt(3 / 4)
        offsets = [(half, 0, 0), (-half, 0, 0), (0, wide, 0), (0, -wide, 0), (0, 0, wide), (0, 0, -wide)]
        for offset in offsets:
            velocity = (joint + R @ (np.array([l / 2, 0, 0]) + offset)).imag / step
            T += m / 12 * velocity @ velocity
        joint = joint + R @ [l, 0, 0]
    return T


def turn(angle: complex, axis: int) -> np.ndarray:
    """Rotation about y (1) or z (2)."""
    c, s = np.cos(angle), np.sin(angle)
    if axis == 1:
        return np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def test_veering_passes_ten_times():
    """Ten sign changes of x, each an approach of the eigenvalues of M to twice the gap."""
    scenario = BY_NAME["veering"]
    model, lagrange = scenario.model(), scenario.lagrange()

    def rhs(time: float, y: np.ndarray) -> np.ndarray:
        return np.concatenate([y[2:], lagrange(y[:2], y[2:])[0]])

    start = np.concatenate([model.initial_x, model.initial_v])
    motion = solve_ivp(rhs, (0, scenario.t_end), start, method="DOP853", rtol=1e-8, t_eval=np.linspace(0, 22, 400))
    assert np.count_nonzero(np.diff(np.sign(motion.y[0]))) == 10
    assert np.abs(motion.y[0]).max() < 4  # M is positive definite


def test_the_block_of_the_ball_has_equal_eigenvalues():
    model = BY_NAME["sphere"].model()
    T = model.in_rates(model.kinetic_energy)
    M = sympy.hessian(T, model.rates[2:])
    state = BY_NAME["sphere"].random_states(1)[0]
    values = dict(zip(model.coordinates, state.x, strict=True)) | dict(model.parameters)
    eigenvalues = np.linalg.eigvalsh(np.array(M.subs(values), dtype=float))
    assert eigenvalues[2] == pytest.approx(eigenvalues[1], rel=1e-14)
    assert eigenvalues[0] < 0.95 * eigenvalues[1]
