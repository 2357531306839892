"""Motions by classical equations and methods of their own: orders, closed forms, what is stiff, what fails."""

from dataclasses import replace

import mpmath
import numpy as np
import pytest
import sympy
from eigenmotion.codegen.model import ModelError
from sympy.physics.mechanics import dynamicsymbols

import eigenmotion as em
from eigenmotion.reference.collocation import Collocation
from eigenmotion.reference.elimination import accelerations
from eigenmotion.reference.extended_precision import extended
from eigenmotion.reference.integration import Midpoint, NotReachedError, integrate_adaptive
from eigenmotion.reference.lagrange_equations import classical, double, explicit
from eigenmotion.reference.motion import rates_of, reference, scaled_error
from eigenmotion.stability.expectation.truth import Collocated
from eigenmotion.stability.models.smooth import elastic_link

from ..oracles import elliptic
from ..support.generation import model_of
from ..support.models_table import BY_NAME, SCENARIOS


def test_the_reference_follows_an_ellipse_function():
    model = model_of("pendulum")
    start = np.array([*model.initial_x, *model.initial_v])
    made = reference(classical(model), start, 10.0)
    exact = np.array([elliptic.pendulum(model, t).x for t in made.t[1::40]], dtype=float)
    assert np.abs(made.x[1::40] - exact).max() < 1e-13


def test_the_references_estimate_bounds_its_error():
    """A pendulum let go almost upright magnifies rounding by 1e9: the estimate grows along, and stays above."""
    pendulum = model_of("pendulum")
    (angle,) = pendulum.coordinates
    upright = replace(pendulum, initial={angle: sympy.Float(3.14159265)})
    made = reference(classical(upright), np.array([*upright.initial_x, 0.0]), 8.0)
    with mpmath.workdps(40):
        k, w = mpmath.sin(mpmath.mpf(upright.initial_x[0]) / 2), mpmath.sqrt(mpmath.mpf(9.81))
        exact = [float(2 * mpmath.asin(k * mpmath.ellipfun("cd", w * float(t), k=k))) for t in made.t[::10]]
    errors = scaled_error(made.x[::10], np.array(exact)[:, None])
    assert errors.max() > 1e-12
    assert (errors <= made.errors[::10] + 1e-15).all()
    assert made.errors.max() < 1e4 * errors.max()


def test_no_reference_across_a_singularity():
    model = model_of("polar_particle")
    fall = replace(model, initial={model.coordinates[0]: 1, model.coordinates[1]: 0})
    with pytest.raises(ModelError, match="no reference"):
        reference(classical(fall), np.array([*fall.initial_x, *fall.initial_v]), 50.0)


def test_extrapolation_has_its_order():
    """Steps of fixed length: the error falls with the power 2 columns."""

    def rhs(time: float, y: np.ndarray) -> np.ndarray:
        return np.array([y[1], -y[0]])

    errors = [
        float(
            abs(
                integrate_adaptive(Midpoint(3), rhs, np.array([1.0, 0.0]), np.linspace(0, 8, n + 1), 1.0)[-1, 0]
                - np.cos(8.0)
            )
        )
        for n in (16, 32)
    ]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(6, abs=0.7)


def test_extrapolation_stops_where_steps_vanish():
    with np.errstate(all="ignore"), pytest.raises(NotReachedError):
        integrate_adaptive(Midpoint(8), lambda time, y: y**2, np.array([1.0]), np.array([0.0, 2.0]), 1e-15)


def test_collocation_has_its_order():
    """Steps of fixed length: order 2 stages - 1, and that of the estimate one above the stages."""

    def rhs(time: float, y: np.ndarray) -> np.ndarray:
        return np.array([y[1], -y[0]])

    ends, estimates = [], []
    for n in (16, 32):
        y = np.array([1.0, 0.0], dtype=np.longdouble)
        for k in range(n):
            y, estimate = Collocation(3).step(rhs, np.longdouble(8 * k / n), y, np.longdouble(8) / n)
        ends.append(float(abs(y[0] - np.cos(np.longdouble(8)))))
        estimates.append(estimate)
    assert np.log2(ends[0] / ends[1]) == pytest.approx(5, abs=0.5)
    assert np.log2(estimates[0] / estimates[1]) == pytest.approx(4, abs=0.5)


def test_collocation_crosses_a_strongly_damped_start():
    """y'' + 1e6 y' + 1e10 y = 0, whose parts die out at the rates 1e4 and 1e6."""
    times = np.linspace(0.0, 1e-3, 11)
    rhs = lambda time, y: np.array([y[1], -1e6 * y[1] - 1e10 * y[0]])  # noqa: E731
    rows = integrate_adaptive(Collocation(7), rhs, np.array([1.0, 0.0]), times, 1e-14)
    with mpmath.workdps(40):
        root = mpmath.sqrt(mpmath.mpf(10) ** 12 / 4 - mpmath.mpf(10) ** 10)
        a, b = -mpmath.mpf(500000) + root, -mpmath.mpf(500000) - root
        exact = [float((a * mpmath.exp(b * float(t)) - b * mpmath.exp(a * float(t))) / (a - b)) for t in times]
    assert np.abs(rows[:, 0] - exact).max() < 1e-15


def test_collocation_does_not_go_on_without_a_solution():
    with np.errstate(all="ignore"), pytest.raises(NotReachedError):
        integrate_adaptive(Collocation(5), lambda time, y: y**2, np.array([1.0]), np.array([0.0, 2.0]), 1e-12)


def stiff_start() -> np.ndarray:
    model = elastic_link()
    return np.array([*model.initial_x[:2], 0.01, *model.initial_v])


def test_the_reference_of_a_stiff_motion_is_implicit():
    """Against steps on a graded mesh: other steps, the same equations."""
    equations = classical(elastic_link()).with_values({"k": 1e10, "d": 1e6})
    made = reference(equations, stiff_start(), 0.2)
    assert "implicit steps" in made.how
    assert made.errors.max() < 1e-15
    integrate_graded = Collocated(extended(equations), np.ones(6)).rows(stiff_start(), made.t, 0)
    assert np.abs(integrate_graded[:, :3] - made.x).max() < 1e-12
    rates = rates_of(extended(equations), made.t[:1], stiff_start()[None])
    assert rates.real.min() == pytest.approx(-1.6e6, rel=0.01)


def test_both_kinds_of_reference_agree(monkeypatch):
    model = model_of("double_pendulum")
    start = np.array([*model.initial_x, *model.initial_v])
    explicit_ = reference(classical(model), start, 2.0)
    monkeypatch.setattr("eigenmotion.reference.motion._DECAYS", -1.0)
    implicit = reference(classical(model), start, 2.0)
    assert explicit_.how != implicit.how
    np.testing.assert_allclose(implicit.x, explicit_.x, rtol=0, atol=1e-14)


def test_decays_are_found_on_the_way():
    """A damper that acts at t = 1 only."""
    times = np.linspace(0.0, 2.0, 5)
    rates = rates_of(lambda time, y: -1e3 * y * (time == 1), times, np.ones((5, 1)))
    assert rates.real.min() == pytest.approx(-1e3)


def test_the_reference_of_a_stiff_spring_minds_its_rounding():
    """A mass on a spring of stiffness 1e8, for 100 periods, in steps that rounding does not shorten."""
    model = model_of("elastic_pendulum")
    equations = classical(model).with_values({"k": 1e8, "g": 0.0})
    made = reference(equations, np.array([0.0, 1.001, 0.0, 0.0]), 200 * np.pi / 1e4)
    exact = 1 + 1e-3 * np.cos(1e4 * made.t)
    assert np.abs(made.x[:, 1] - exact).max() < 1e-14
    assert made.errors.max() < 1e-14


@pytest.mark.parametrize(
    "scenario",
    [pytest.param(one, id=one.name, marks=pytest.mark.nightly if one.keywords else ()) for one in SCENARIOS],
)
def test_classical_equations_agree_with_plain_differentiation(scenario):
    """Every day those of few coordinates."""
    model, n = scenario.model(), len(scenario.model().coordinates)
    equations = classical(model)
    rhs, exact = double(equations), extended(equations)
    for state in scenario.random_states(2):
        expected, _ = scenario.lagrange()(state.x, state.v, 0.3)
        y = np.concatenate([state.x, state.v])
        size = 1e-10 * (1 + np.abs(expected).max())
        np.testing.assert_allclose(rhs(0.3, y)[n:], expected, atol=size)
        np.testing.assert_allclose(exact(np.longdouble(0.3), y.astype(np.longdouble))[n:].astype(float), expected,
                                   atol=size)  # fmt: skip
        np.testing.assert_array_equal(rhs(0.3, y)[:n], state.v)


def test_inputs_are_held_at_what_is_set():
    """q'' = (u + w) / m."""
    q, u, w = dynamicsymbols("q u w")
    m = sympy.Symbol("m")
    model = em.Model(name="pushed", coordinates=[q], kinetic_energy=m * q.diff() ** 2 / 2, forces=[u + w],
                     parameters={m: 2.0}, inputs={u: 1.0, w: 0.5})  # fmt: skip
    for values, rate in (({}, 0.75), ({"w": 3.0}, 2.0), ({"u": 0.0, "w": 3.0, "m": 4.0}, 0.75)):
        assert double(classical(model).with_values(values))(0.0, np.array([0.0, 7.0])).tolist() == [7.0, rate]


def test_written_out_accelerations_agree():
    """The elimination that heyoka.py and CasADi get, done by SymPy's numbers."""
    scenario = BY_NAME["dual_link"]
    functions = {"sin": sympy.sin, "cos": sympy.cos}
    state = scenario.random_states(1)[0]
    y = [sympy.Float(number) for number in (*state.x, *state.v)]
    rates = explicit(classical(scenario.model()), functions, y, sympy.Float(0))
    exact = np.concatenate([state.v, scenario.lagrange()(state.x, state.v)[0]])
    np.testing.assert_allclose(np.array(rates, dtype=float), exact, rtol=1e-11)


def test_elimination_skips_zeros():
    """Two free particles and one held together with the second: zeros stay numbers, and nothing divides by them."""
    a, multipliers = accelerations([[2, 0, 0], [0, 1, 0], [0, 0, 3]], [[0, 1, -1]], [4, 0, 8], [0])
    assert (a, multipliers) == ([2, 2, 2], [-2])
