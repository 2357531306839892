"""The compiled stiff methods, "radau5" and "radau9": order, L-stability, what stiff scenes ask of them.

Oracles: Pade's approximants, elliptic functions, published values of van der Pol's relaxation, explicit runs at tight
tolerances. Their coefficients: test_tableaux.py.
"""

import math
from functools import cache

import numpy as np
import pytest
from scipy.special import ellipk
from sympy import Rational, cos, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.arguments.methods import METHODS

from ..support.generation import system_for, system_of
from ..support.stepping import FINISHED, PENDULUM, Build, Mechanism, builder, pendulum_angle, simulate

RADAU = ("radau5", "radau9")
ORDER = {name: METHODS[name].order for name in RADAU}


@pytest.fixture(scope="module")
def build(tmp_path_factory: pytest.TempPathFactory) -> Build:
    return builder(tmp_path_factory.mktemp("mechanisms"))


# --- accuracy and stability of steps ----------------------------------------------------------------------------------


SOLVED = "#define EM_ITERATION_TOLERANCE 1e-9"
"""Stages are solved to rounding, however large an error is allowed."""


def fixed_steps(compiled, method, count, t_end, start, **options):
    h = t_end / count
    return simulate(compiled, start, (0.0, t_end), method, first_step=h, max_step=h, rtol=1e-13, **options)


def pade(z: complex, zeros: int, poles: int) -> complex:
    """Pade's approximant of exp, a polynomial of degree `zeros` over one of degree `poles`."""
    top = sum(math.comb(zeros, j) * math.factorial(zeros + poles - j) * z**j for j in range(zeros + 1))
    below = sum(math.comb(poles, j) * math.factorial(zeros + poles - j) * (-z) ** j for j in range(poles + 1))
    return top / below


@pytest.mark.parametrize("method", RADAU)
@pytest.mark.parametrize(("k", "d"), [(4.0, 1.0), (1e4, 0.0), (1e10, 1e6), (1e14, 1e3)])
def test_a_step_of_a_linear_motion_is_pade_s_approximant(build, method, k, d):
    """Of exp(h J), with fewer zeros than poles: what is fast dies out in a step, and nothing grows: L-stability."""
    s, h = (ORDER[method] + 1) // 2, 0.1
    linear = Mechanism(rhs=f"dy[0] = y[1]; dy[1] = -{k} * y[0] - {d} * y[1];", preamble=SOLVED)
    found = fixed_steps(build(linear), method, 1, h, [1.0, 0.5], atol=1e3)
    roots, vectors = np.linalg.eig(np.array([[0, 1], [-k, -d]], dtype=complex))
    factors = np.array([pade(h * root, s - 1, s) for root in roots])
    expected = (vectors * factors @ np.linalg.solve(vectors, [1.0, 0.5])).real
    scale = np.array([1.0, math.sqrt(k)])
    np.testing.assert_allclose(found.y[:, -1] / scale, expected / scale, atol=1e-9)
    assert (np.abs(factors) <= 1 + 1e-12).all()


@pytest.mark.parametrize("method", RADAU)
def test_orders(build, method):
    """Of the ends of steps 2 s - 1, of the polynomial within s."""
    order, ends, within = ORDER[method], [], []
    for count in (40, 80) if method == "radau5" else (16, 32):
        result = fixed_steps(
            build(Mechanism(rhs=PENDULUM.rhs, preamble=SOLVED)), method, count, 8.0, [2.0, 0.0], dense=1, atol=1e-3
        )
        assert result.run.n_steps <= count + 1
        ends.append(np.abs(result.y[0] - pendulum_angle(result.t, 2.0)).max())
        inside = [(t + q * h, result.at(i, t + q * h)[0]) for i, t, h in result.steps() for q in (0.2, 0.5, 0.75)]
        t, x = np.array(inside).T
        within.append(np.abs(x - pendulum_angle(t, 2.0)).max())
    assert math.log2(ends[0] / ends[1]) > order - 0.5
    assert math.log2(within[0] / within[1]) > (order + 1) / 2 + 0.5


RELAXATION = Mechanism(rhs="dy[0] = y[1]; dy[1] = ((1.0 - y[0] * y[0]) * y[1] - y[0]) / 1e-6;")
AT_1 = (-0.1863646254808130e1, 0.7535430865435460e0)
AT_2 = (0.1706167732170456e1, -0.8928097010248257e0)
"""x and v from (2, 0) at t = 1 and 2: Hairer & Wanner's test set of stiff problems."""


@pytest.mark.parametrize("method", RADAU)
@pytest.mark.parametrize("rtol", [1e-4, 1e-7, 1e-10])
def test_van_der_pol_relaxes_as_published(build, method, rtol):
    result = simulate(build(RELAXATION), [2.0, 0.0], (0.0, 2.0), method, rtol=rtol, atol=rtol, t_eval=[1.0, 2.0])
    assert result.status == FINISHED
    np.testing.assert_allclose(result.y.T, [AT_1, AT_2], rtol=300 * rtol)
    assert result.run.n_steps < (1000 if method == "radau9" else 9000)


# --- stiff mechanisms -------------------------------------------------------------------------------------------------


def link(**more):
    """A pendulum on a spring of stiffness 1e10 with damping 1e6 along it, driven by a torque."""
    theta, r, u = dynamicsymbols("theta r u")
    m, k, d, g, L = symbols("m k d g L", nonnegative=True)
    return em.Model(
        name="driven_link", coordinates=[theta, r],
        kinetic_energy=Rational(1, 2) * m * (r.diff() ** 2 + r**2 * theta.diff() ** 2),
        potential_energy=Rational(1, 2) * k * (r - L) ** 2 - m * g * r * cos(theta),
        forces={r: -d * r.diff(), theta: u}, inputs={u: 0.0}, events={"bottom": theta},
        parameters={m: 1.0, k: 1e10, d: 1e6, g: 9.81, L: 1.0}, initial={theta: 1.0, r: 1.0}, **more,
    )  # fmt: skip


@cache
def stiff_link():
    return system_for(link(), formulation="lagrange")


@pytest.mark.parametrize("method", RADAU)
def test_steps_are_as_long_as_the_error_lets_them_be(method):
    """Not as what turns with the link: with slopes that all stages share, steps would be no longer than k^(-1/4)."""
    sol = stiff_link().simulate((0.0, 4.0), method=method, rtol=1e-5, atol=1e-5)
    assert sol.success
    assert sol.nsteps < (120 if method == "radau5" else 45)
    rigid = system_of("pendulum").simulate((0.0, 4.0), x0=[1.0], v0=[0.0], rtol=1e-12, atol=1e-12)
    assert abs(sol.x[0, -1] - rigid.x[0, -1]) < 1e-4
    quarter = ellipk(math.sin(0.5) ** 2) / math.sqrt(9.81)
    np.testing.assert_allclose(sol.t_events[0], quarter * np.array([1, 3, 5, 7]), atol=1e-4)
    assert sol.njev > 0 < sol.nlu


def test_both_orders_agree_on_rows_events_and_dense_output():
    times = np.linspace(0.0, 4.0, 333)
    five, nine = (
        stiff_link().simulate((0.0, 4.0), method=method, rtol=1e-9, atol=1e-9, t_eval=times, dense_output=True)
        for method in RADAU
    )
    np.testing.assert_allclose(five.x, nine.x, atol=3e-8)
    np.testing.assert_allclose(five.v, nine.v, atol=1e-7)
    np.testing.assert_allclose(five.t_events[0], nine.t_events[0], atol=3e-8)
    np.testing.assert_allclose(nine.sol(times)[:2], nine.x, atol=1e-14)
    assert len(nine.t_events[0]) == 4


@pytest.mark.parametrize(("name", "formulation"), [("four_bar", "eigenfactor"), ("four_bar", "lagrange"),
                                                   ("rolling_disk", "cholesky"), ("dual_link", "eigenfactor"),
                                                   ("driven_pendulum", "inverse")])  # fmt: skip
@pytest.mark.parametrize("method", RADAU)
def test_the_motion_of_explicit_steps_in_every_formulation(name, formulation, method):
    """Constraints (of velocities, too, and moved by time), eigenfactors, quasi-velocities; and backwards."""
    system, times = system_of(name, formulation), np.linspace(0.0, 1.0, 9)
    tight = {"rtol": 1e-10, "atol": 1e-10, "t_eval": times}
    explicit, stiff = (system.simulate((0.0, 1.0), method=m, **tight) for m in ("dop853", method))
    assert stiff.success
    np.testing.assert_allclose(stiff.x, explicit.x, atol=2e-8)
    np.testing.assert_allclose(stiff.v, explicit.v, atol=2e-7)
    assert stiff.factor_residual.max() < 1e-12
    if system.m:
        assert np.abs(stiff.constraint_residual).max() < 1e-11
    back = system.simulate((1.0, 0.0), x0=stiff.x[:, -1], v0=stiff.v[:, -1], method=method, rtol=1e-10, atol=1e-10)
    np.testing.assert_allclose(back.x[:, -1], explicit.x[:, 0], atol=2e-7)


def test_without_stabilisation_drift_is_that_of_the_error():
    system = system_of("four_bar", "lagrange")
    sol = system.simulate((0.0, 1.0), method="radau9", rtol=1e-8, atol=1e-8, stabilisation="none")
    assert sol.success
    assert 1e-15 < np.abs(sol.constraint_residual).max() < 1e-6


@pytest.mark.parametrize("method", RADAU)
@pytest.mark.parametrize("span", [1e-12, -1e-12, 1e-6])
def test_short_spans(method, span):
    sol = stiff_link().simulate((0.0, span), method=method)
    assert sol.success
    assert sol.t[-1] == span
    assert sol.nsteps <= 6


def test_limits_of_steps_are_kept():
    sol = stiff_link().simulate((0.0, 1.0), method="radau9", first_step=1e-7, max_step=0.02)
    assert sol.t[1] == 1e-7
    assert np.diff(sol.t).max() <= 0.02 * (1 + 1e-12)
    few = stiff_link().simulate((0.0, 1.0), method="radau9", max_steps=3)
    assert few.stop is em.StopReason.TOO_MANY_STEPS
    assert few.nsteps == 3


# --- inputs -----------------------------------------------------------------------------------------------------------


def torque(kind, count=1001):
    times = np.linspace(0.0, 10.0, count)
    return {"u": em.Signal(times, 3 * np.sin(2 * times) + np.cos(5 * times), kind)}


@pytest.mark.parametrize("method", RADAU)
@pytest.mark.parametrize("rtol", [1e-4, 1e-6])
def test_samples_do_not_cost_steps(method, rtol):
    """Right to the tolerance all the same: against steps that end at every sample."""
    given = {"method": method, "rtol": rtol, "atol": rtol}
    smooth = stiff_link().simulate((0.0, 10.0), inputs=torque("cubic"), **given)
    times = np.linspace(0.0, 10.0, 777)
    sampled = stiff_link().simulate((0.0, 10.0), inputs=torque("linear"), t_eval=times, **given)
    assert sampled.success
    assert sampled.nsteps < 1.3 * smooth.nsteps < 500
    exact = stiff_link().simulate((0.0, 10.0), inputs=torque("linear"), t_eval=times, method="radau9",
                                  rtol=1e-11, atol=1e-11, max_step=0.01)  # fmt: skip
    assert np.abs(sampled.x - exact.x).max() < 50 * rtol


@pytest.mark.parametrize("method", RADAU)
@pytest.mark.parametrize("ahead", [True, False])
def test_rough_samples_end_steps(build, method, ahead):
    """x'' = u, forwards and backwards, u a saw whose teeth are wide beside a step: in closed form, inside steps too."""
    samples, values = np.arange(0.0, 10.5, 0.5), np.where(np.arange(21) % 2, 1.0, -1.0)
    system = system_for(link(), formulation="lagrange")
    span = (0.0, 10.0) if ahead else (10.0, 0.0)
    given = {"inputs": {"u": (samples, values)}, "parameters": {"g": 0.0}, "x0": {"theta": 0.0, "r": 1.0}}
    times = np.linspace(*span, 403)
    sol = system.simulate(span, method=method, rtol=1e-8, atol=1e-8, t_eval=times, v0=[0.0, 0.0], **given)
    assert sol.success
    speed = np.array([np.trapezoid(*reversed(pieces(samples, values, span[0], t))) for t in times])
    np.testing.assert_allclose(sol.v[0], speed, atol=2e-7)


def pieces(samples, values, start, t):
    """(times, values) of a piecewise linear function from start to t."""
    low, high = min(start, t), max(start, t)
    at = np.unique([low, *samples[(samples > low) & (samples < high)], high])
    at = at if t >= start else at[::-1]
    return at, np.interp(at, samples, values)


def test_a_spline_is_fitted_once(monkeypatch):
    import scipy.interpolate  # noqa: PLC0415

    fitted = []
    plain = scipy.interpolate.CubicSpline
    monkeypatch.setattr(scipy.interpolate, "CubicSpline", lambda *given: fitted.append(1) or plain(*given))
    signal = em.Signal(np.linspace(0, 1, 50), np.linspace(0, 1, 50) ** 2, "cubic")
    for method in ("dop853", "radau5"):
        for _ in range(2):
            assert stiff_link().simulate((0.0, 1e-6), inputs={"u": signal}, method=method).success
    assert signal(0.5) == pytest.approx(0.25)
    assert len(fitted) == 1


# --- whose choice it is -----------------------------------------------------------------------------------------------


def test_auto_sees_what_is_stiff_and_says_so():
    stiff = stiff_link().simulate((0.0, 4.0), method="auto")
    assert stiff.method == "radau9"
    assert "changed to radau9 at t = " in stiff.message
    undamped = {"parameters": {"d": 0.0}}
    for span, given in (((0.0, 1e-6), {}), ((0.0, 1e-3), undamped), ((0.0, 4.0), {"parameters": {"k": 1e2, "d": 1.0}})):
        sol = stiff_link().simulate(span, method="auto", **given)
        assert sol.method in ("dop853", "ra15")
        assert "stiff" not in sol.message


@pytest.mark.parametrize("method", RADAU)
@pytest.mark.parametrize("length", [1e-9, 1e-3, 1.0, 1e9])
@pytest.mark.parametrize("origin", [0.0, 1e4])
def test_a_model_written_by_hand_has_the_same_steps_in_any_unit(build, method, length, origin):
    """A stiff pendulum, whose slopes are differences: x'' = -1e6 sin x - 2e3 x' + cos t."""
    x = f"(y[0] / {length} - {origin})"
    stiff = Mechanism(rhs=f"dy[0] = y[1]; dy[1] = {length} * (cos(t) - 1e6 * sin({x})) - 2e3 * y[1];")
    found = simulate(build(stiff), [(1.0 + origin) * length, 0.0], (0.0, 20.0), method, rtol=1e-7, atol=1e-9 * length)
    assert found.status == FINISHED
    assert found.y[0, -1] / length - origin == pytest.approx(1e-6 * math.cos(20.0), abs=1e-8)
    assert found.run.n_steps < 400
