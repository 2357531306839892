"""Quasi-velocities y = P(x, t) xdot (3): at the start, in T and constraints, and in the solution."""

from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from sympy import Rational, cos, exp, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, ModelError, System, t
from eigenmotion.cli.options import values

from ..support.generation import FORMULATIONS, model_of, system_for, system_of

J = np.array([1.0, 2.0, 3.0])
TIGHT = {"rtol": 1e-11, "atol": 1e-13}
NAMES = ("omega_1", "omega_2", "omega_3")


def body_rates(x: np.ndarray, v: np.ndarray) -> np.ndarray:
    """omega (3,) of Euler angles 3-1-3 (psi, theta, phi)."""
    (_, theta, phi), (psi_dot, theta_dot, phi_dot) = x, v
    return np.array(
        [
            psi_dot * np.sin(theta) * np.sin(phi) + theta_dot * np.cos(phi),
            psi_dot * np.sin(theta) * np.cos(phi) - theta_dot * np.sin(phi),
            psi_dot * np.cos(theta) + phi_dot,
        ]
    )


def euler(omega: np.ndarray, at: np.ndarray) -> np.ndarray:
    """omega (3, k) by Euler's equations J omega' = J omega x omega."""
    rate = lambda _, w: np.cross(J * w, w) / J  # noqa: E731
    return solve_ivp(rate, (0, at[-1]), omega, "DOP853", t_eval=at, rtol=1e-12, atol=1e-13).y


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_a_solution_has_them(formulation):
    system, at = system_of("rigid_body", formulation), np.linspace(0, 4, 33)
    found = system.simulate((0, 4), t_eval=at, **TIGHT)
    assert system.quasi_velocities == NAMES == tuple(found.quasi_velocities)
    omega = np.array([found.quasi_velocities[name] for name in NAMES])
    initial = {str(y).removesuffix("(t)"): value for y, value in model_of("rigid_body").initial}
    np.testing.assert_allclose(omega[:, 0], [initial[name] for name in NAMES], rtol=1e-14)
    np.testing.assert_allclose(omega, euler(omega[:, 0], at), atol=1e-9)
    rates = [body_rates(x, v) for x, v in zip(found.x.T, found.v.T, strict=True)]
    np.testing.assert_allclose(omega.T, rates, atol=1e-14)
    assert "quasi_velocities" in found.keys()  # noqa: SIM118


def test_v0_may_name_them():
    system, given = system_of("rigid_body"), np.array([0.3, -1.1, 0.7])
    x0 = {"theta": 0.9, "phi": 0.2}
    for v0 in (dict(zip(NAMES, given, strict=True)), dict(zip(dynamicsymbols("omega_1:4"), given, strict=True))):
        x, v = system.start(x0, v0)
        np.testing.assert_allclose(body_rates(x, v), given, rtol=1e-13)
        np.testing.assert_array_equal(system.state(x0, v0), system.state(x, v))
        found = system.simulate((0, 1), x0=x0, v0=v0, t_eval=[0, 1])
        assert found.quasi_velocities["omega_2"][0] == pytest.approx(-1.1, rel=1e-13)


def test_those_not_named_are_the_models_own():
    system = system_of("rigid_body")
    initial = np.array([value for name, value in _initial("rigid_body") if name in NAMES])
    x, v = system.start({"theta": 0.5}, {"omega_2": 5.0})
    np.testing.assert_allclose(body_rates(x, v), [initial[0], 5.0, initial[2]], rtol=1e-13)


def _initial(name: str) -> list[tuple[str, float]]:
    return [(str(symbol).removesuffix("(t)"), value) for symbol, value in model_of(name).initial]


def test_given_in_initial_they_hold_at_any_x0():
    system = system_of("rigid_body")
    initial = [value for name, value in _initial("rigid_body") if name in NAMES]
    for x0 in (None, {"theta": 2.0}, [0.1, 0.7, -1.0]):
        np.testing.assert_allclose(body_rates(*system.start(x0)), initial, rtol=1e-13)


def test_rates_still_serve_also_as_symbols():
    system, psi = system_of("rigid_body"), dynamicsymbols("psi")
    x, v = system.start(None, {"psi": 1.0, "theta": 2.0, "phi": 3.0})
    np.testing.assert_array_equal(v, [1, 2, 3])
    np.testing.assert_array_equal(system.start(None, {psi.diff(): 1.0, "theta": 2.0, "phi": 3.0})[1], v)
    np.testing.assert_array_equal(system.start(x, [1, 2, 3])[1], v)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"v0": {"omega_1": 1, "psi": 2}}, r"rates \(psi\) and quasi-velocities \(omega_1\).*one of the two"),
        ({"v0": {"omega1": 1}}, "Did you mean 'omega_1'"),
        ({"v0": {"omega_1": np.inf}}, "'omega_1' is not a finite number"),
        ({"x0": {"theta": 0.0}}, r"omega_1, omega_2, omega_3.*singular.*Start elsewhere"),
        ({"x0": {"theta": 0.0}, "v0": [0, 0, 1]}, "mass matrix.*not positive definite.*'phi'"),
    ],
)
def test_mistakes_are_named(options, words):
    with pytest.raises(ModelError, match=words):
        system_of("rigid_body").simulate((0, 1), **options)


@cache
def wheel() -> System:
    """A wheel of radius r rolls on a track that shrinks: T, a force and the start in y = x' e^(c t) / r."""
    x, z, spin, slide = dynamicsymbols("x z spin slide")
    r, m, c = symbols("r m c", positive=True)
    return system_for(
        Model(
            name="wheel",
            coordinates=[x, z],
            quasi_velocities={spin: x.diff() * exp(c * t) / r + z.diff() * sin(z), slide: z.diff()},
            kinetic_energy=Rational(1, 2) * m * (spin**2 + slide**2),
            forces={z: -slide},
            nonholonomic_constraints=[slide - Rational(1, 2) * spin * cos(x)],
            parameters={r: 0.5, m: 2.0, c: 0.1},
            initial={spin: 3.0, slide: 1.5, x: 0.0},
        )
    )


def test_they_may_depend_on_parameters_and_time():
    system = wheel()
    for r, time in ((0.5, 0.0), (2.0, 0.0), (2.0, 1.5)):
        x, v = system.start({"z": 0.4}, None, time, {"r": r})
        np.testing.assert_allclose(v, [(3 - 1.5 * np.sin(0.4)) * r * np.exp(-0.1 * time), 1.5], rtol=1e-14)
        assert system.energy(x, v, time, {"r": r}) == pytest.approx(3**2 + 1.5**2, rel=1e-13)


def test_constraints_written_in_them_hold():
    found = wheel().simulate((0, 2), **TIGHT)
    slide, spin = found.quasi_velocities["slide"], found.quasi_velocities["spin"]
    np.testing.assert_allclose(slide, spin * np.cos(found.x[0]) / 2, atol=1e-14)
    np.testing.assert_allclose(found.constraint_residual, [slide - spin * np.cos(found.x[0]) / 2], atol=1e-15)


def test_files_hold_them_and_models_without_have_none(tmp_path):
    system = system_of("rigid_body")
    found = system.simulate((0, 1))
    found.save(tmp_path / "motion.npz")
    with np.load(tmp_path / "motion.npz") as file:
        np.testing.assert_array_equal(file["quasi_velocity_omega_2"], found.quasi_velocities["omega_2"])
    pendulum = system_of("pendulum")
    assert pendulum.quasi_velocities == ()
    assert pendulum.simulate((0, 0.1)).quasi_velocities == {}


def test_the_command_line_sets_them():
    given = values(model_of("rigid_body"), ("omega_1=2.5", "theta=1", "J1=1.5"))
    assert given == {"parameters": {"J1": 1.5}, "x0": {"theta": 1.0}, "v0": {"omega_1": 2.5}}
