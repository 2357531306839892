"""Jacobians of right-hand sides that carry eta, which run on numbers with a derivative: em_rate_jacobian.h."""

import numpy as np
import pytest
import sympy as sp
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import CompilerNotFoundError, Model, ModelError
from eigenmotion.runtime import EvaluationError

from ..support.generation import model_of, system_for

x, z, u = dynamicsymbols("x z u")
c = sp.Symbol("c")
SMOOTH = [sp.sin(x), sp.cos(x), sp.tan(x), sp.asin(x), sp.acos(x), sp.atan(x), sp.sinh(x), sp.cosh(x), sp.tanh(x),
          sp.asinh(x), sp.acosh(2 + x), sp.atanh(x), sp.exp(-x), sp.log(2 + x), sp.erf(x), sp.sqrt(1 + x * z),
          (2 + x) ** (z + c), (1.5 + x) ** sp.Rational(7, 3), sp.atan2(x, z), 1 / (3 + x * z)]  # fmt: skip
"""Of x and z between -1 and 1."""
KINKED = [sp.Abs(x - z), sp.Max(x**2, z), sp.Min(x, z**3), sp.sign(x) * z, sp.Heaviside(z, 0.5) * x,
          sp.floor(3 * x) * z, sp.Piecewise((x**2, x > z), (z**3, sp.And(x > -2, z < 2)), (x, True))]  # fmt: skip


def scene(forces) -> Model:
    """Two unlike masses: M is constant, and eta = S C v at every place."""
    return Model(
        name="functions", coordinates=[x, z], kinetic_energy=2 * x.diff() ** 2 + x.diff() * z.diff() + z.diff() ** 2,
        potential_energy=0, parameters={c: 0.3}, inputs={u: 0.7},
        forces={x: sum(forces) + u * x.diff() * sp.Abs(z.diff()), z: sum(k * f for k, f in enumerate(forces))},
    )  # fmt: skip


@pytest.mark.parametrize("formulation", ["eigenfactor", "cholesky"])
def test_functions(formulation):
    """Against Lagrange's equations, which the compiler differentiates as expressions: y = (x, R v), R constant."""
    model = scene([*SMOOTH, *KINKED])
    one, other = (system_for(model, formulation=name) for name in (formulation, "lagrange"))
    rng = np.random.default_rng(3)
    R = np.array([one.state([0.1, 0.2], v)[2:4] for v in np.eye(2)]).T
    T = np.block([[np.eye(2), np.zeros((2, 2))], [np.zeros((2, 2)), R]])
    for _ in range(20):
        q, v = rng.uniform(-0.9, 0.9, (2, 2))
        expected = T @ other.jacobian(0.0, [*q, *v]) @ np.linalg.inv(T)
        found = one.jacobian(0.0, one.state(q, v))
        np.testing.assert_allclose(found, expected, atol=1e-13 * abs(expected).max())


@pytest.mark.parametrize(("force", "place", "slopes"), [
    (sp.Abs(x) * x, 0, {0.0}), (sp.Abs(x), 0, {1.0, -1.0}), (sp.Max(x, 2 * x), 0, {1.0, 2.0}),
    (sp.sqrt(z**2), 1, {0.0}),
])  # fmt: skip
def test_kinks_are_taken_from_one_side(force, place, slopes):
    """At 0; what has no slope of its own there has none under a root, either."""
    model = Model(name="kink", coordinates=[x, z], kinetic_energy=(x.diff() ** 2 + z.diff() ** 2) / 2,
                  potential_energy=0, forces={x: force})  # fmt: skip
    assert system_for(model, formulation="cholesky").jacobian(0.0, np.zeros(4))[2, place] in slopes


def test_options_of_the_right_hand_side():
    """Omega that is extrapolated goes by (32) where no run remembers it, and eigenfactors of Delta are states."""
    plain = system_for(model_of("dual_link"), schur="eigenfactor")
    extrapolating = system_for(model_of("dual_link"), schur="eigenfactor", close_eigenvalues="extrapolate")
    y = plain.simulate((0.0, 0.3), rtol=1e-8).y[:, -1]
    J = plain.jacobian(0.3, y)
    np.testing.assert_allclose(extrapolating.jacobian(0.3, y), J, atol=1e-13 * abs(J).max())


@pytest.mark.parametrize("size", [1e-6, 1e6])
def test_units_change_nothing(size):
    """Lengths in other units: entries of x and eta change as their units do."""
    l, g = sp.symbols("l g")
    model = Model(
        name="units", coordinates=[x, z], parameters={l: 1.0, g: 9.81}, potential_energy=g * (l * sp.cos(z) + x**2 / l),
        kinetic_energy=x.diff() ** 2 + l * x.diff() * z.diff() * sp.cos(z) + l**2 * z.diff() ** 2,
    )  # fmt: skip
    system = system_for(model, formulation="cholesky")
    one, scaled = {}, {"l": size, "g": 9.81 * size}
    J = system.jacobian(0.0, system.state([0.3, 0.4], [0.5, 0.6], 0.0, one), one)
    found = system.jacobian(0.0, system.state([0.3 * size, 0.4], [0.5 * size, 0.6], 0.0, scaled), scaled)
    units = np.array([size, 1.0, size, size])
    np.testing.assert_allclose(found / units[:, None] * units, J, rtol=0, atol=1e-14 * abs(J).max())


def test_what_is_singular_is_named():
    system = system_for(model_of("double_pendulum"), formulation="cholesky")
    with pytest.raises(EvaluationError, match=r"positive definite|singular"):
        system.jacobian(0.0, np.ones(4), {"m1": 1e-300, "m2": 1.0})


def test_where_it_cannot_be_compiled(monkeypatch):
    system = system_for(model_of("double_pendulum"), formulation="cholesky")
    y = system.state()
    monkeypatch.setenv("CC", "no-such-compiler")
    with pytest.raises(CompilerNotFoundError, match="no-such-compiler"):
        system.jacobian(0.0, y)
    system.compiled.load_part = None
    with pytest.raises(ModelError, match=r"eigenmotion.build know; or build with 'lagrange'"):
        system.jacobian(0.0, y)
