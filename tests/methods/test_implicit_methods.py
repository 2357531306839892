"""Implicit methods and their Jacobians."""

import re
from functools import partial
from itertools import pairwise

import numpy as np
import pytest
import scipy
from sympy import Rational, cos, symbols
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.arguments.methods import IMPLICIT

from ..support.generation import system_for, system_of
from ..support.models_table import BY_NAME


def complex_like_differences(fun, y):
    """Return the Jacobian by Richardson-extrapolated central differences, in steps of their own choice."""
    columns = []
    for k in range(len(y)):
        h = 2e-3 * max(1.0, abs(y[k]))
        table = []
        for level in range(4):
            e = np.zeros(len(y))
            e[k] = h / 2**level
            table.append((fun(y + e) - fun(y - e)) / (2 * e[k]))
        for order in (4, 16, 64):
            table = [(order * b - a) / (order - 1) for a, b in pairwise(table)]
        columns.append(table[0])
    return np.array(columns).T


@pytest.mark.parametrize("formulation", ["eigenfactor", "cholesky", "lagrange"])
@pytest.mark.parametrize("name", ["dual_link", "four_bar", "double_pendulum", "rolling_disk"])
def test_jacobian(name, formulation):
    system = system_for(BY_NAME[name].model(), formulation=formulation)
    sol = system.simulate((0.0, 0.3), rtol=1e-8)
    y = sol.y[:, -1]
    expected = complex_like_differences(lambda z: system.rhs(0.3, z), y)
    np.testing.assert_allclose(system.jacobian(0.3, y), expected, atol=1e-10 * abs(expected).max())


@pytest.mark.parametrize("method", IMPLICIT)
@pytest.mark.parametrize("formulation", ["eigenfactor", "lagrange"])
def test_agrees_with_explicit_run(method, formulation):
    system = system_for(BY_NAME["dual_link"].model(), formulation=formulation)
    t = np.linspace(0.0, 2.0, 7)
    truth = system.simulate((0.0, 2.0), rtol=1e-12, atol=1e-12, t_eval=t)
    sol = system.simulate((0.0, 2.0), rtol=1e-7, atol=1e-9, t_eval=t, method=method, dense_output=True)
    assert sol.success
    np.testing.assert_allclose(sol.x, truth.x, atol=3e-5)
    np.testing.assert_allclose(sol.sol(t)[: system.n], sol.x, atol=1e-12)
    assert abs(sol.constraint_residual).max() < 1e-13
    assert sol.factor_residual.max() < 1e-13
    assert np.abs(np.einsum("ijt,ijt->it", sol.C[..., 1:], sol.C[..., :-1])).min() > 0.3


@pytest.mark.parametrize("method", IMPLICIT)
def test_another_clock_is_the_same_motion_by_the_same_steps(method):
    system = system_for(BY_NAME["double_pendulum"].model(), formulation="lagrange")
    now, later = (system.simulate((start, start + 2.0), rtol=1e-7, atol=1e-9, method=method) for start in (0.0, 64.0))
    assert later.nfev == now.nfev
    np.testing.assert_allclose(later.t - 64.0, now.t, rtol=1e-4, atol=1e-13)


def damped_link():
    """A pendulum on a spring of stiffness 1e10 with damping 1e6 along it."""
    theta, r = dynamicsymbols("theta r")
    m, k, d, g, L = symbols("m k d g L", positive=True)
    return em.Model(
        name="damped_link",
        coordinates=[theta, r],
        kinetic_energy=Rational(1, 2) * m * (r.diff() ** 2 + r**2 * theta.diff() ** 2),
        potential_energy=Rational(1, 2) * k * (r - L) ** 2 - m * g * r * cos(theta),
        forces={r: -d * r.diff()},
        parameters={m: 1.0, k: 1e10, d: 1e6, g: 9.81, L: 1.0},
        initial={theta: 1.0, r: 1.0},
    )


@pytest.mark.parametrize("method", IMPLICIT)
def test_heavily_damped_link(method):
    """Two periods to 1e-6 in fewer than 2000 steps; the rigid pendulum is 1e-9 away."""
    system = system_for(damped_link())
    sol = system.simulate((0.0, 4.0), method=method, rtol=1e-8, atol=1e-10)
    rigid = system_for(BY_NAME["pendulum"].model())
    truth = rigid.simulate((0.0, 4.0), x0=[1.0], v0=[0.0], rtol=1e-12, atol=1e-12)
    assert sol.success
    assert sol.nsteps < 2000
    assert abs(sol.x[0, -1] - truth.x[0, -1]) < 1e-6


@pytest.mark.parametrize("method", ["dopri5", "dop853", "ra15"])
def test_a_run_that_stability_holds_back_says_so(method):
    """At the end of the time or of the steps alike, and not where steps are as long as the error lets them be."""
    system = system_for(damped_link(), formulation="cholesky")
    whole = system.simulate((0.0, 0.02), rtol=1e-5, method=method)
    assert whole.success
    assert 2 * whole.n_stiff > whole.nsteps
    short = system.simulate((0.0, 0.02), rtol=1e-5, method=method, max_steps=whole.nsteps // 2)
    for found in (whole, short):
        assert "The scene is stiff" in found.message
        assert "radau9" in found.message
    easy = system_for(BY_NAME["dual_link"].model()).simulate((0.0, 100.0), method=method)
    assert 20 * easy.n_stiff < easy.nsteps
    assert easy.message == "The end of t_span was reached."


SERVED = {"Radau": "radau9", "bdf": "radau9", "LSODA": "radau9", "cvode": "radau9", "RK45": "dopri5", "RK23": "rk34"}


@pytest.mark.parametrize("given", SERVED)
def test_solvers_of_others_are_named_with_what_serves(given):
    """The call that is said can be made."""
    system, t_span = system_of("pendulum"), (0.0, 1.0)
    words = f"method '{given}' is .*'{SERVED[given]}'.*System.rhs and System.jacobian"
    for ask in (partial(system.simulate, t_span), system.stepper, partial(em.simulate_ensemble, system, t_span)):
        with pytest.raises(em.ModelError, match=words) as said:
            ask(method=given)
    call = re.search(r"scipy\.integrate\.solve_ivp\(.*\)", str(said.value))
    found = eval(call[0], {"scipy": scipy, "system": system, "t_span": t_span})
    assert found.y[0, -1] == pytest.approx(system.simulate(t_span).x[0, -1], abs=1e-2)


def test_backward_and_inputs_leave_no_trace():
    system = system_for(BY_NAME["double_pendulum"].model())
    there = system.simulate((0.0, 1.0), method="radau5", rtol=1e-9, atol=1e-9)
    back = system.simulate((1.0, 0.0), x0=there.x[:, -1], v0=there.v[:, -1], method="radau5", rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(back.x[:, -1], system.initial[0], atol=1e-6)
