"""Signs: of T1 in (27), (36), (41), where the paper prints another one, and of multipliers by Newton's second law."""

from fractions import Fraction
from functools import cache

import numpy as np
import pytest
from eigenmotion.codegen import compiler
from eigenmotion.codegen.calculus.derivatives import gradient
from eigenmotion.codegen.choices import Choices
from eigenmotion.codegen.equations.terms import Terms
from sympy import Rational, symbols
from sympy.physics.mechanics import dynamicsymbols

from eigenmotion import Model, System, t

from ..oracles import Lagrange, elementary
from ..support.generation import FORMULATIONS, loaded, model_of, system_for, system_of

TIGHT = {"rtol": 1e-11, "atol": 1e-13}


# --- T1 ---------------------------------------------------------------------------------------------------------------


@pytest.fixture
def printed_sign(monkeypatch: pytest.MonkeyPatch) -> None:
    """The generator with the sign of the paper: - dG^T/dx xdot for + dG^T/dx xdot."""
    right = Terms._force

    def printed(self: Terms, gradient_of_L: tuple) -> tuple:
        coriolis = gradient(self.graph, self.T1, self.x)  # d(G^T v)/dx at fixed v is dG^T/dx v
        force = right(self, gradient_of_L)
        return tuple(
            self.graph.sum([(f, Fraction(1)), (g, Fraction(-2))]) for f, g in zip(force, coriolis, strict=True)
        )

    monkeypatch.setattr(Terms, "_force", printed)


def generated_now(model: Model, formulation: str = "eigenfactor") -> System:
    """By the generator as it is patched here; what is kept goes by the files of the generator."""
    return loaded(compiler.generate(model, Choices(formulation)), "-O0")


def error_in_rotating_frame(system: System) -> float:
    right = elementary.rotating_spring(model_of("rotating_spring"), 10.0)
    found = system.simulate((0, 10), **TIGHT)
    return float(np.abs(np.concatenate([found.x[:, -1] - right.x, found.v[:, -1] - right.v])).max())


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_the_rotating_frame_passes_with_ours(formulation):
    assert error_in_rotating_frame(system_of("rotating_spring", formulation)) < 1e-9


@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.usefixtures("printed_sign")
def test_the_rotating_frame_fails_with_the_one_printed(formulation):
    system = generated_now(model_of("rotating_spring"), formulation)
    assert error_in_rotating_frame(system) > 0.1
    # the Coriolis force is gone altogether: accelerations do not depend on velocities
    x = [0.3, 0.8]
    fast, slow = (system.acceleration(x, v)[0] for v in ([2.0, -1.0], [0.0, 0.0]))
    np.testing.assert_allclose(fast, slow, atol=1e-12)


def turning_cart() -> Model:
    """Coupled coordinates, M(x, t), G(x, t), T0(x, t) and a constraint: eigenfactors turn, and nothing is zero."""
    x, y, z = dynamicsymbols("x y z")
    W = symbols("W")
    vx, vy = x.diff() - W * y * (1 + t), y.diff() + W * x + z.diff() * y / 3
    return Model(
        name="turning_cart",
        coordinates=[x, y, z],
        kinetic_energy=Rational(1, 2) * (vx**2 + (2 + t) * vy**2 + (3 + x**2) * z.diff() ** 2),
        potential_energy=x**2 + y * z,
        nonholonomic_constraints=[z.diff() - y * x.diff() / 4 - t * x],
        parameters={W: 1.3},
        initial={x: 1.0, y: 0.5, z: 0.2},
    )


def test_it_is_ours_with_everything_depending_on_time_too():
    model, system = turning_cart(), system_for(turning_cart())
    _agree(system, Lagrange(model), right=True)


@pytest.mark.usefixtures("printed_sign")
def test_and_not_the_one_printed():
    _agree(generated_now(turning_cart()), Lagrange(turning_cart()), right=False)


def _agree(system: System, oracle: Lagrange, right: bool) -> None:
    random = np.random.default_rng(1)
    for _ in range(10):
        x, time = random.normal(size=3), float(random.uniform(0, 2))
        x, v = system.project_initial_state(x, random.normal(size=3), time)
        found, expected = system.acceleration(x, v, time), oracle(x, v, time)
        error = max(np.abs(f - e).max() for f, e in zip(found, expected, strict=True))
        assert error < 1e-11 if right else error > 1e-3


# --- multipliers ------------------------------------------------------------------------------------------------------

MASS, GRAVITY, LENGTH = 2.0, 9.81, 1.5


@cache
def bob(formulation: str) -> System:
    """A pendulum in Cartesian coordinates, phi = sqrt(x^2 + y^2) - l: its multiplier is the tension of the rod."""
    x, y = dynamicsymbols("x y")
    m, g, l = symbols("m g l", positive=True)
    return system_for(
        Model(
            name="bob",
            coordinates=[x, y],
            kinetic_energy=m * (x.diff() ** 2 + y.diff() ** 2) / 2,
            potential_energy=m * g * y,
            holonomic_constraints=[(x**2 + y**2) ** Rational(1, 2) - l],
            parameters={m: MASS, g: GRAVITY, l: LENGTH},
            initial={y: -LENGTH},
        ),
        formulation,
    )


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_a_hanging_mass_pulls_its_rod_with_its_weight(formulation):
    system = bob(formulation)
    assert system.acceleration(*system.initial)[1] == pytest.approx([MASS * GRAVITY], rel=1e-15)
    found = system.simulate((0, 1))
    np.testing.assert_allclose(found.multipliers, MASS * GRAVITY, rtol=1e-14)
    np.testing.assert_allclose(found.x, np.tile([[0], [-LENGTH]], found.t.size), atol=1e-15)
    standing = system.acceleration([0, LENGTH], [0, 0])[1]  # upside down the rod is pressed
    np.testing.assert_allclose(standing, [-MASS * GRAVITY], rtol=1e-15)


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_a_swinging_mass_pulls_with_weight_and_centripetal_force(formulation):
    angle = 1.0
    x0 = LENGTH * np.array([np.sin(angle), -np.cos(angle)])
    found = bob(formulation).simulate((0, 3), x0=x0, v0=[0, 0], **TIGHT)
    along = found.x / LENGTH
    tension = MASS * (found.v**2).sum(axis=0) / LENGTH - MASS * GRAVITY * along[1]
    np.testing.assert_allclose(found.multipliers[0], tension, atol=1e-11)
    # -A^T lambda is what Newton's law needs beside the weight: m a = W - A^T lambda
    system = bob(formulation)
    for k in (0, found.t.size // 2, -1):
        x, v = found.x[:, k], found.v[:, k]
        a, multipliers = system.acceleration(x, v)
        A, _ = system.pfaffian(x)
        np.testing.assert_allclose(MASS * a, [0, -MASS * GRAVITY] - A.T @ multipliers, atol=1e-12)
        np.testing.assert_allclose(A.T @ multipliers, tension[k] * along[:, k], atol=1e-11)


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_the_rod_of_a_slider_crank_pushes_its_slider(formulation):
    """phi_0 = x - ..., so that m_s x'' = -lambda_0; x'' from positions of the run, not from the model."""
    system = system_of("slider_crank", formulation)
    h, at = 1e-3, np.linspace(0.1, 0.9, 9)
    times = np.concatenate([at + k * h for k in (-2, -1, 0, 1, 2)])
    found = system.simulate((0, 1), t_eval=np.sort(times), **TIGHT)
    slider = dict(zip(np.sort(times), found.x[2], strict=True))
    weights = {-2: -1, -1: 16, 0: -30, 1: 16, 2: -1}
    x_ddot = np.array([sum(w * slider[time + k * h] for k, w in weights.items()) for time in at]) / (12 * h**2)
    middle = np.isin(found.t, at)
    np.testing.assert_allclose(-found.multipliers[0, middle], system.parameters["m_s"] * x_ddot, rtol=1e-5, atol=1e-5)


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_the_guide_of_a_slider_crank_at_rest_carries_half_its_rod(formulation):
    """Static: the crank hangs down. Moments about its pin: the guide lifts the rod's end by m_r g / 2; phi_1 is the
    height of that end, so that -lambda_1 is the lift. Nothing pushes the slider."""
    system = system_of("slider_crank", formulation)
    p = system.parameters
    rod = np.arcsin(-p["r"] / p["l"])
    start = [-np.pi / 2, rod, p["l"] * np.cos(rod)]
    a, multipliers = system.acceleration(start, [0, 0, 0])
    np.testing.assert_allclose(a, 0, atol=1e-13)
    np.testing.assert_allclose(multipliers, [0, -p["m_r"] * p["g"] / 2], atol=1e-13)
    found = system.simulate((0, 1), x0=start, v0=[0, 0, 0])
    np.testing.assert_allclose(found.multipliers[1], -p["m_r"] * p["g"] / 2, atol=1e-9)
