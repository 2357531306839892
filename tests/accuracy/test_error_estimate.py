"""simulate(..., estimate_error=True): the estimate brackets the true error, against motions known in closed form."""

import pickle
import sys
from dataclasses import replace

import numpy as np
import pytest
from eigenmotion.codegen.model import ModelError

import eigenmotion as em
from eigenmotion.arguments.options import OptionError

from ..support.generation import model_of, system_for, system_of
from ..support.models_table import BY_NAME

KNOWN = ("pendulum", "rigid_body", "rotating_spring", "polar_particle", "chaplygin_sleigh")
RUNS = [
    *[("dop853", tolerance) for tolerance in (1e-4, 1e-7, 1e-10)],
    *[("dopri5", tolerance) for tolerance in (1e-4, 1e-8)],
    *[("rk34", tolerance) for tolerance in (1e-4, 1e-7)],
    ("radau5", 1e-5),
    ("radau9", 1e-5),
]


@pytest.mark.parametrize(("method", "tolerance"), RUNS)
@pytest.mark.parametrize("name", KNOWN)
def test_the_estimate_brackets_the_true_error(name, method, tolerance):
    scenario = BY_NAME[name]
    end = scenario.reference()
    solution = system_of(name).simulate(
        (0, scenario.t_end), method=method, rtol=tolerance, atol=tolerance, estimate_error=True
    )
    true = np.abs(solution.x[:, -1] - end.x.astype(float)), np.abs(solution.v[:, -1] - end.v.astype(float))
    estimate = solution.error_estimate
    assert estimate.t == scenario.t_end
    assert estimate.message == ""
    # a coordinate's own error may pass through zero: a tenth of the largest is allowed for
    for found, error in zip((estimate.x, estimate.v), true, strict=True):
        assert found == pytest.approx(error, rel=0.25, abs=0.1 * error.max() + 1e-13)
    scaled = np.max(true[0] / (1 + np.abs(end.x.astype(float))))
    assert estimate.scaled == pytest.approx(scaled, rel=0.25, abs=1e-13)


@pytest.mark.parametrize("formulation", ["eigenfactor", "cholesky", "lagrange"])
def test_the_largest_error_on_the_way(formulation):
    """The rows asked for are interpolated; the estimate is about them."""
    times = np.linspace(0.5, 10, 20)
    scenario = BY_NAME["pendulum"]
    exact = np.array([scenario.closed_form(scenario.model(), t).x for t in times], dtype=float).T
    solution = system_of("pendulum", formulation).simulate((0, 10), t_eval=times, rtol=1e-6, estimate_error=True)
    errors = np.abs(solution.x - exact)
    assert solution.error_estimate.x_largest == pytest.approx(errors.max(axis=1), rel=0.1)
    assert solution.error_estimate.scaled_largest == pytest.approx(np.max(errors / (1 + np.abs(exact))), rel=0.1)


def test_one_row_is_enough():
    solution = system_of("pendulum").simulate((0, 10), t_eval=[4.0], estimate_error=True)
    assert solution.error_estimate.t == 4
    assert 0 < solution.error_estimate.scaled < 1e-2


def test_it_says_what_it_cost():
    system = system_of("dual_link")
    solution = system.simulate((0, 10), rtol=1e-8, atol=1e-8, estimate_error=True)
    alone = system.simulate((0, 10), rtol=1e-10, atol=1e-10, t_eval=solution.t)
    cost = solution.error_cost
    assert (cost.formulation, cost.method, cost.nfev) == ("eigenfactor", "dop853", alone.nfev)
    assert cost.rtol == pytest.approx(1e-10)
    assert cost.nfev < 2.5 * solution.nfev
    assert cost.seconds > 0
    assert 0 < cost.share < 100


def test_the_run_itself_is_as_without():
    system = system_of("dual_link")
    plain, estimated = system.simulate((0, 10)), system.simulate((0, 10), estimate_error=True)
    assert plain.error_estimate is None
    assert plain.error_cost is None
    np.testing.assert_array_equal(plain.y, estimated.y)
    assert plain.nfev == estimated.nfev
    again = pickle.loads(pickle.dumps(estimated))
    np.testing.assert_array_equal(again.error_estimate.x, estimated.error_estimate.x)


def test_another_formulation_checks():
    options = {"rtol": 1e-8, "atol": 1e-8}
    own = system_of("dual_link").simulate((0, 10), **options, estimate_error=True)
    other = system_of("dual_link").simulate((0, 10), **options, estimate_error=system_of("dual_link", "lagrange"))
    assert other.error_cost.formulation == "lagrange"
    assert other.error_estimate.scaled_largest == pytest.approx(own.error_estimate.scaled_largest, rel=0.2)


def test_parameters_reach_the_checker():
    options = {"rtol": 1e-8, "atol": 1e-8, "parameters": {"l": 0.7}}
    system, checker = system_of("pendulum"), system_of("pendulum", "lagrange")
    solution = system.simulate((0, 3), **options, estimate_error=checker)
    assert solution.error_estimate.scaled_largest < 1e-5


def test_another_program_finds_what_one_got_wrong():
    """A fault planted in one program's equations: its own second run has it too, another program's has not."""
    right = model_of("pendulum")
    wrong = system_for(replace(right, potential_energy=right.potential_energy * (1 + 1e-6)))
    blind = wrong.simulate((0, 10), rtol=1e-9, atol=1e-9, estimate_error=True)
    seen = wrong.simulate((0, 10), rtol=1e-9, atol=1e-9, estimate_error=system_for(right, "lagrange"))
    true = np.abs(wrong.simulate((0, 10), rtol=1e-12).x[0, -1] - float(BY_NAME["pendulum"].reference().x[0]))
    assert true > 1e-6
    assert blind.error_estimate.x[0] < 0.1 * true
    assert seen.error_estimate.x[0] == pytest.approx(true, rel=0.1)


def test_it_says_where_rounding_is_the_limit():
    solution = system_of("pendulum").simulate((0, 10), rtol=1e-13, atol=1e-13, estimate_error=True)
    assert "factor of about 3" in solution.error_estimate.message
    assert solution.error_cost.rtol == pytest.approx(3e-14)
    true = abs(solution.x[0, -1] - float(BY_NAME["pendulum"].reference().x[0]))
    assert true / 3 - 1e-13 < solution.error_estimate.x[0] < 3 * true + 1e-13


def test_a_run_that_ends_early_is_compared_as_far_as_it_got():
    solution = system_of("pendulum").simulate((0, 10), rtol=1e-8, max_steps=20, estimate_error=True)
    assert not solution.success
    assert solution.error_estimate.t == solution.t[-1]
    assert 0 < solution.error_estimate.scaled_largest < 1e-5


def test_a_run_without_rows_says_so():
    solution = system_of("pendulum").simulate((0, 10), t_eval=[0.0], max_steps=1, estimate_error=True)
    assert not solution.success
    assert "no rows" in solution.error_estimate.message
    assert np.isnan(solution.error_estimate.scaled)


def test_a_second_run_that_ends_before_the_first_row_says_so(monkeypatch):
    module = sys.modules["eigenmotion.simulation.simulate"]
    plain, methods = module.run_task, []

    def run(task, method):
        methods.append(method)
        return plain(task if len(methods) == 1 else task._replace(max_steps=1), method)

    monkeypatch.setattr(module, "run_task", run)
    solution = system_of("pendulum").simulate((0, 3), t_eval=[3.0], estimate_error=True)
    assert solution.success
    assert np.isnan(solution.error_estimate.scaled)
    assert "1 rows could not be compared" in solution.error_estimate.message
    assert "step limit" in solution.error_estimate.message


@pytest.mark.parametrize("given", ["yes", 1.0, None])
def test_what_is_neither_true_nor_a_system_is_refused(given):
    with pytest.raises(OptionError, match="estimate_error"):
        system_of("pendulum").simulate((0, 1), estimate_error=given)


def test_another_model_cannot_check():
    with pytest.raises(ModelError, match="differs"):
        em.simulate(system_of("pendulum"), (0, 1), estimate_error=system_of("double_pendulum"))


FALL, G, E = 1.0, 9.81, 0.9
"""[m], [m / s^2], restitution of models/bouncing_ball.py."""


def of_a_ball(t: np.ndarray, after: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Height and speed at times t, where a bounce is due just before or `after` it."""
    first = np.sqrt(2 * FALL / G)
    strikes = np.cumsum([first, *(2 * first * E**k for k in range(1, 20))])
    past = (t[:, None] > strikes) | (after[:, None] & (np.abs(t[:, None] - strikes) < 1e-9))
    k = past.sum(axis=1)
    since = t - np.where(k > 0, strikes[k - 1], -first)
    speed = np.sqrt(2 * G * FALL) * E**k
    return speed * since - G * since**2 / 2, speed - G * since


@pytest.mark.parametrize("method", ["dop853", "radau5"])
@pytest.mark.parametrize("around", [None, 0.0, 1e-12, 1e-3])
def test_states_are_compared_on_one_side_of_an_impact(method, around):
    """The runs strike some 1e-10 apart, and a row in between has the jump of the speed between them."""
    first = np.sqrt(2 * FALL / G)
    strikes = first + np.array([0, 2 * E, 2 * E + 2 * E**2]) * first
    times = None if around is None else np.unique([strikes - around, strikes, strikes + around, [0.1, 0.5, 2.0]])
    system = system_of("bouncing_ball", "lagrange")
    run = system.simulate((0, 2.1), method=method, rtol=1e-8, atol=1e-8, t_eval=times, estimate_error=True)
    estimate = run.error_estimate
    assert estimate.v_largest.max() < 1e-5
    assert estimate.t == run.t[-1]
    if around is None:
        after = np.append(False, np.diff(run.t) == 0)
        assert after.sum() == 3
        z, v = of_a_ball(run.t, after)
        clear = np.array([np.abs(t - strikes).min() > 1e-6 for t in run.t])
        true = np.abs(run.v[1] - v)[clear].max()
        assert estimate.v_largest[1] >= 0.5 * true - 1e-12  # rounding, of which parabolas leave nothing else
        assert np.abs(run.x[1] - z).max() < 1e-5
        assert "3 rows at the very moment" in estimate.message
