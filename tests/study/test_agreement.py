"""Reference of a report by two tight runs, where there is no independent one, and its refusals."""

from dataclasses import replace

import numpy as np
import pytest
from eigenmotion.codegen.choices import FORMULATIONS
from eigenmotion.models import bouncing_ball, double_pendulum, pendulum
from scipy.spatial.transform import Rotation

import eigenmotion as em
from eigenmotion.comparison.obstacles import without_reference
from eigenmotion.reference.rotations import in_sets_of
from eigenmotion.report import Budget, ReportOptions, examine
from eigenmotion.report.agreement import agreement
from eigenmotion.report.formulations import subject
from eigenmotion.report.output import recommendation, write_report
from eigenmotion.report.solvers import Problem

from ..bodies.test_shadow_parameters import swinging_body
from ..support.generation import model_of, system_of
from .measuring import undisturbed

REDUCED = (1e-6, 1e-8, 1e-10)


def bounces(t: np.ndarray, e: float = 0.9, g: float = 9.81) -> np.ndarray:
    """Height of the ball that falls from 1 m: parabolas by hand."""
    fall, speed = np.sqrt(2 / g), np.sqrt(2 * g)
    height, begin, up = 1 - g * t**2 / 2, fall, e * speed
    while begin < t[-1]:
        since = t - begin
        height = np.where(since >= 0, up * since - g * since**2 / 2, height)
        begin, up = begin + 2 * up / g, e * up
    return height


def report_of(model: em.Model, t_end: float):
    with undisturbed() as patch:
        patch.setattr("eigenmotion.report.solvers.IMPLICIT_TOLERANCES", (1e-6, 1e-8))
        for name in ("SLOW", "_TURN"):
            patch.setattr(f"eigenmotion.report.measure.{name}", 0.0)
        ask = ReportOptions(error=1e-6, t_end=t_end, tolerances=REDUCED, budget=Budget(np.inf, rounds=3))
        return examine(model, ask, lambda *_: None)


def test_a_report_of_a_ball_that_bounces(tmp_path):
    """The reference is the parabolas; it says that it is not independent, and leaves others out."""
    found = report_of(bouncing_ball.model, 3.0)
    np.testing.assert_allclose(found.reference.x[:, 1], bounces(found.reference.t), rtol=0, atol=1e-12)
    assert {m.family for m in found.measurements} == {"eigenmotion"}
    for m in found.measurements:
        assert m.message == ""
        assert m.error_max < 1e-9
        assert m.energy_integral is None
        assert m.constraint_violation is None
    assert found.absent == (("SciPy, heyoka.py, CasADi/CVODES", "left out, since they have no contacts and friction"),)
    assert any("No independent reference, because of contacts and friction" in s for s in recommendation(found))
    page, *_ = write_report([found], tmp_path)
    assert "A fault that both share stays hidden" in page.read_text(encoding="utf-8")


def test_an_error_is_the_difference_from_a_tight_run():
    """A pendulum that meets a stop, loosely by rk34 and tightly by radau9, in formulations of their own."""
    found = report_of(model_of("pendulum_with_stop"), 1.0)
    (m,) = [m for m in found.measurements if m.label == "lagrange rk34" and m.tolerance == 1e-6]
    runs = {"inverse": ("radau9", 1e-12), "lagrange": ("rk34", 1e-6)}
    end, loose = (
        system_of("pendulum_with_stop", f).simulate((0, 1), method=by, rtol=tol, atol=tol).x[:, -1]
        for f, (by, tol) in runs.items()
    )
    assert m.error_end == pytest.approx(np.max(np.abs(loose - end) / (1 + np.abs(end))), rel=1e-3)


def test_runs_that_differ_are_no_reference():
    """Two systems that are not the same: the second pendulum is longer."""
    values = {key: value * (1.01 if str(key) == "l" else 1) for key, value in pendulum.model.parameters}
    assert values != dict(pendulum.model.parameters)
    longer = replace(pendulum.model, parameters=values)
    systems = [em.build(one, formulation="lagrange") for one in (pendulum.model, longer)]
    start = np.array([*pendulum.model.initial_x, *pendulum.model.initial_v])
    with pytest.raises(em.ModelError, match=r"two tight runs .* differ by .*--t-end"):
        agreement(systems, Problem(5.0, {}), start, "a reason")


def test_chaos_has_no_reference_over_long_spans_and_says_from_when():
    systems = [em.build(double_pendulum.model, formulation=name) for name in ("lagrange", "inverse")]
    start = np.array([3.0, 3.0, 0.0, 0.0])
    assert agreement(systems, Problem(3.0, {}), start, "a reason").errors.max() < 1e-6
    with pytest.raises(em.ModelError, match=r"differ by .* at t = .* already, as the motion magnifies") as refused:
        agreement(systems, Problem(100.0, {}), start, "a reason")
    advised = float(str(refused.value).rpartition("--t-end ")[2].rstrip("."))
    assert agreement(systems, Problem(advised, {}), start, "a reason").errors.max() < 1e-3


def test_a_start_that_cannot_reach_the_end_is_named():
    fall = model_of("polar_particle")
    systems = [em.build(fall, formulation="lagrange")]
    with pytest.raises(em.ModelError, match="tight runs do not reach the end"):
        agreement(systems, Problem(50.0, {}), np.array([1.0, 0.0, 0.0, 0.0]), "a reason")


def test_shadow_parameters_are_compared_in_one_set():
    """s = tan(angle / 4) times the axis, by SciPy's rotations; the rates by differences."""
    random = np.random.default_rng(0)
    s, rate, h = random.normal(size=(6, 3)), random.normal(size=(6, 3)), 1e-6

    def shadow(s):
        return -s / np.sum(s * s, axis=1, keepdims=True)

    np.testing.assert_allclose(Rotation.from_mrp(s).as_matrix(), Rotation.from_mrp(shadow(s)).as_matrix(), atol=1e-12)
    slope = (shadow(s + h * rate) - shadow(s - h * rate)) / (2 * h)
    beside = random.normal(size=(6, 1))
    expected = np.hstack([beside, s, beside, rate])
    rows = np.hstack([beside, shadow(s), beside, slope])
    np.testing.assert_allclose(in_sets_of(expected, rows, 4, ((1, 2, 3),)), expected, atol=1e-8)
    np.testing.assert_array_equal(in_sets_of(expected, expected, 4, ((1, 2, 3),)), expected)
    assert np.isfinite(in_sets_of(expected, 0 * expected, 4, ((1, 2, 3),))).all()


@pytest.mark.parametrize("name", ["quaternion_top", "rolling_disk", "lugre_oscillator", "chain"])
def test_plain_equations_need_no_agreement(name):
    assert without_reference(model_of(name)) == ""


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("bouncing_ball", "contacts and friction"),
        ("newtons_cradle", "events that act on the motion"),
        ("robot_arm", "functions of a tree of bodies"),
    ],
)
def test_what_plain_equations_lack_is_named(name, why):
    assert without_reference(model_of(name)) == why


def test_trees_are_measured_in_the_formulation_that_build_takes():
    system, *others = subject(model_of("robot_arm"), lambda *_: None).systems
    assert system.formulation == em.build(model_of("robot_arm")).formulation == "articulated_body"
    assert [other.formulation for other in others] == list(FORMULATIONS)


@pytest.mark.nightly
def test_free_joints_are_compared_whatever_their_parameters():
    """Twelve seconds of a tumbling body: runs change their parameters, each at its own step."""
    found = report_of(swinging_body(), 12.0)
    assert {m.message for m in found.measurements} == {""}
    assert max(m.error_max for m in found.measurements if m.tolerance == 1e-8) < 1e-5
